"""Tables of functions that are nearly powers."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.numerics.panels.log_panels import Octaves


@pytest.mark.parametrize("unit", [1e-9, 1.0, 3e4])
def test_a_sum_of_powers(unit):
    def function(x):
        return (x / unit) ** 1.5 + 2.0 * np.sqrt(x / unit)

    table = Octaves(function, unit, 0.0, math.inf)
    x = unit * np.geomspace(1e-20, 1e20, 301)
    np.testing.assert_allclose(table(x), function(x), rtol=4e-14)
    for place in x[::50]:
        assert table(np.array([place]))[0] == pytest.approx(function(place), rel=4e-14)


def test_a_high_power_is_rounded_once():
    """x^256, of 1e-300 to 1e300: the exponential of a logarithm would be off by 256 roundings."""

    table = Octaves(lambda x: x**256.0, 1.0, 0.0, math.inf)
    x = np.arange(6, 100) / 64.0 * np.array([[1.0], [8.0]])
    np.testing.assert_allclose(table(x.ravel()), (x**256.0).ravel(), rtol=2e-14)


def test_few_evaluations_for_many_places():
    requested = []

    def function(x):
        requested.append(x.size)
        return x**2 + x

    table = Octaves(function, 1.0, 0.0, math.inf)
    for x in np.linspace(0.1, 0.9, 500):
        assert table(np.array([x]))[0] == pytest.approx(x * x + x, rel=4e-14)
    assert sum(requested) < 400


def test_what_is_not_smooth_is_evaluated():
    def function(x):
        return 1.0 + np.abs(np.sin(40.0 * x))

    x = np.linspace(0.3, 0.9, 50)
    np.testing.assert_array_equal(Octaves(function, 1.0, 0.0, math.inf)(x), function(x))


def test_blocks_that_are_not_inside_are_evaluated():
    def function(x):
        assert np.all((x > 0.1) & (x < 20.0))
        return x

    x = np.array([0.2, 0.9, 1.1, 15.0, 17.0])
    np.testing.assert_allclose(Octaves(function, 1.0, 0.1, 20.0)(x), x, rtol=1e-14)
