"""Gauss-Legendre and tanh-sinh rules on (0, 1)."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from winkler.numerics.integrals.quadrature import gauss_legendre, tanh_sinh
from winkler.values.errors import InvalidInput


@pytest.mark.parametrize("count", [1, 2, 5, 20, 64])
def test_gauss_is_exact_up_to_its_degree_and_not_beyond(count):
    nodes, weights = gauss_legendre(count)
    degree = 2 * count - 1
    assert float(weights @ nodes**degree) == pytest.approx(1.0 / (degree + 1.0), rel=1e-13)
    missed = abs(float(weights @ nodes ** (degree + 1)) - 1.0 / (degree + 2.0))
    exact = math.factorial(count) ** 4 / ((2 * count + 1) * math.factorial(2 * count) ** 2)
    assert missed == pytest.approx(exact, rel=1e-2, abs=1e-15)


def test_gauss_nodes_are_the_roots_of_legendre():
    nodes, _ = gauss_legendre(7)
    mp.mp.dps = 30
    for node in nodes:
        assert abs(mp.legendre(7, 2 * mp.mpf(node) - 1)) < 1e-14


@pytest.mark.parametrize("power", [-0.5, -0.25, 0.5, 3.3])
def test_tanh_sinh_integrates_powers_at_either_end(power):
    nodes, complements, weights = tanh_sinh(161)
    assert float(weights @ nodes**power) == pytest.approx(1.0 / (power + 1.0), rel=1e-14)
    assert float(weights @ complements**power) == pytest.approx(1.0 / (power + 1.0), rel=1e-14)


def test_tanh_sinh_complements_keep_their_digits():
    nodes, complements, weights = tanh_sinh(81)
    np.testing.assert_array_equal(nodes, complements[::-1])
    np.testing.assert_allclose(weights, weights[::-1], rtol=1e-15)
    assert 0.0 < complements[-1] < 1e-37
    assert np.all(np.diff(nodes) >= 0.0)


def test_rules_are_shared_and_cannot_be_spoilt():
    nodes, _ = gauss_legendre(9)
    assert gauss_legendre(9)[0] is nodes
    with pytest.raises(ValueError, match="read-only"):
        nodes[0] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        tanh_sinh(9)[0][0] = 1.0


@pytest.mark.parametrize(("rule", "count"), [(gauss_legendre, 0), (gauss_legendre, -3), (tanh_sinh, 1)])
def test_too_few_nodes(rule, count):
    with pytest.raises(InvalidInput, match=f"count is {count}"):
        rule(count)
