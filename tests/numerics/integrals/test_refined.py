"""Integrals with kinks at unknown places: closed forms, wherever the kink lies, and functions that diverge at zero."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.integrals.bisected_quadrature import along_springs, refined, towards
from winkler.values.errors import NotConverged


def test_a_kink_anywhere():
    """Thousands of kinks, also just beside the end of a panel: |x - b| integrates to 1/2 - b + b^2."""
    place = np.concatenate(
        [
            np.random.default_rng(4).random(3000),
            *(end + sign * np.geomspace(1e-12, 1e-2, 40) for end in (0.25, 0.5, 0.75) for sign in (-1.0, 1.0)),
        ]
    )
    solution = refined(
        lambda x, index: np.abs(x - place[index]), np.linspace(0.0, 1.0, 5), np.full(place.size, 1e-13), "kink"
    )
    np.testing.assert_allclose(solution, 0.5 - place + place**2, rtol=2e-12)


def test_smooth_functions_and_square_roots():
    def power(x, index):
        return x ** np.array([0.5, 3.0, 7.5])[index]

    solution = refined(power, np.array([0.0, 1.0]), np.full(3, 1e-13), "power")
    np.testing.assert_allclose(solution, [1 / 1.5, 0.25, 1 / 8.5], rtol=1e-12)


@pytest.mark.parametrize("exponent", [-0.6, -0.3, 0.0, 0.4])
def test_springs_that_stiffen_towards_the_axis(exponent):
    end, kink = 3e-4, 1.1e-4
    solution = along_springs(
        lambda x, _: x**exponent * np.maximum(kink - x, 0.0), towards(end, [], 30), np.array([1e-13]), "stiff springs"
    )
    exact = kink ** (2.0 + exponent) * (1.0 / (1.0 + exponent) - 1.0 / (2.0 + exponent))
    assert solution[0] == pytest.approx(exact, rel=1e-11)


def test_a_part_of_the_springs():
    solution = along_springs(lambda x, _: x**2, np.array([0.5, 0.7, 2.0]), np.array([1e-13]), "part")
    assert solution[0] == pytest.approx((8.0 - 0.125) / 3.0, rel=1e-14)


def test_panels_crowd_towards_the_end():
    edges = towards(2.0, [0.3, 5.0], 3)
    np.testing.assert_array_equal(edges, [0.0, 0.3, 1.0, 1.5, 1.75, 2.0])


@pytest.mark.slow
def test_noise_is_refused():
    noise = np.random.default_rng(0)
    with pytest.raises(NotConverged, match="noise does not settle"):
        refined(lambda x, _: noise.normal(size=x.size), np.array([0.0, 1.0]), np.array([1e-13]), "noise")
