"""The two rules on [0, 1]: exact where they promise it, and shared without being spoilt."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.errors import InvalidInput
from winkler.numerics.quadrature import gauss_legendre, tanh_sinh


@pytest.mark.parametrize("count", [1, 2, 5, 16, 48, 96])
def test_gauss_is_exact_for_polynomials_of_its_order(count):
    nodes, weights = gauss_legendre(count)
    for power in (0, 1, 2 * count - 1):
        assert np.isclose(weights @ nodes**power, 1.0 / (power + 1), rtol=1e-13)


def test_gauss_misses_the_next_power():
    nodes, weights = gauss_legendre(3)
    assert abs(weights @ nodes**6 - 1.0 / 7.0) == pytest.approx(1.0 / 2800.0, rel=1e-10)  # (n!)^4 / ((2n+1) (2n)!^2)


@pytest.mark.parametrize(
    ("integrand", "exact"),
    [
        (lambda x, y: x**-0.5, 2.0),
        (lambda x, y: y**-0.5, 2.0),
        (lambda x, y: (x * y) ** -0.5, math.pi),
        (lambda x, y: np.log(x) * np.log(y), 2.0 - math.pi**2 / 6.0),
        (lambda x, y: x**0.3 * y**1.7, math.gamma(1.3) * math.gamma(2.7) / math.gamma(4.0)),
        (lambda x, y: np.exp(x), math.e - 1.0),
    ],
)
def test_tanh_sinh_takes_singular_ends(integrand, exact):
    nodes, complements, weights = tanh_sinh(81)
    assert np.isclose(weights @ integrand(nodes, complements), exact, rtol=1e-14)


def test_tanh_sinh_converges_geometrically():
    errors = []
    for count in (21, 41, 81):
        nodes, _, weights = tanh_sinh(count)
        errors.append(abs(weights @ (1.0 / (1.0 + (4.0 * nodes) ** 2)) - math.atan(4.0) / 4.0))
    assert errors[1] < 20.0 * errors[0] ** 1.7
    assert errors[2] < 1e-13 < errors[0]


@pytest.mark.parametrize("count", [2, 40, 81])
def test_complements_know_the_far_end(count):
    nodes, complements, weights = tanh_sinh(count)
    assert np.all(np.diff(complements[complements < 0.5]) < 0.0)
    assert np.array_equal(complements, nodes[::-1])
    assert np.array_equal(weights, weights[::-1])
    assert np.allclose(nodes + complements, 1.0, rtol=0.0, atol=3e-16)
    assert 0.0 < complements[-1] < 1e-37
    assert np.all(nodes > 0.0)


@pytest.mark.parametrize("rule", [gauss_legendre, tanh_sinh])
def test_rules_are_shared_and_read_only(rule):
    assert rule(12) is rule(12)
    for array in rule(12):
        assert array.shape == (12,)
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0


def test_too_few_nodes_are_refused():
    with pytest.raises(InvalidInput, match="count is 0; give at least 1"):
        gauss_legendre(0)
    with pytest.raises(InvalidInput, match="count is 1; give at least 2"):
        tanh_sinh(1)
