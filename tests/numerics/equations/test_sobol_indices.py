"""Indices of Sobol: the function of Ishigami, additive functions, and the estimates of scipy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats

from winkler.numerics.equations.sobol_indices import sobol_indices
from winkler.study.language.designs import Sensitivity


def evaluated(function, keys: int, count: int, seed: int = 0):
    """Return f at A, at B, and at A with one argument from B, on the unit cube."""
    values = function(Sensitivity(count, seed).shares(keys)).reshape(count, keys + 2)
    return values[:, 0], values[:, 1], values[:, 2:].T


def ishigami(shares):
    x = math.pi * (2.0 * shares - 1.0)
    return np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


# Ishigami and Homma 1990: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2, with a = 7 and b = 0.1
VARIANCE = 49.0 / 8.0 + 0.1 * math.pi**4 / 5.0 + 0.01 * math.pi**8 / 18.0 + 0.5
FIRST = np.array([0.5 * (1.0 + 0.1 * math.pi**4 / 5.0) ** 2, 49.0 / 8.0, 0.0]) / VARIANCE
BOTH = 8.0 * 0.01 * math.pi**8 / 225.0 / VARIANCE
TOTAL = FIRST + np.array([BOTH, 0.0, BOTH])


@pytest.mark.slow
def test_ishigami():
    found = sobol_indices(*evaluated(ishigami, 3, 4096))
    np.testing.assert_allclose(found.first_order, FIRST, atol=5e-3)
    np.testing.assert_allclose(found.total_order, TOTAL, atol=5e-3)
    assert np.all((found.first_order_low < FIRST) & (found.first_order_high > FIRST))
    assert np.all((found.total_order_low <= TOTAL + 1e-12) & (found.total_order_high >= TOTAL - 1e-12))


@pytest.mark.slow
def test_more_pairs_come_closer():
    errors = [
        np.max(np.abs(sobol_indices(*evaluated(ishigami, 3, count)).total_order - TOTAL)) for count in (64, 512, 4096)
    ]
    assert errors[0] > 4.0 * errors[2]


def test_the_estimates_of_scipy():
    f_a, f_b, f_ab = evaluated(ishigami, 3, 256, seed=3)
    mean = np.mean(np.concatenate([f_a, f_b]))
    theirs = stats.sobol_indices(
        func={"f_A": f_a[None] - mean, "f_B": f_b[None] - mean, "f_AB": (f_ab - mean)[:, None, :]}, n=256
    )
    ours = sobol_indices(f_a, f_b, f_ab)
    np.testing.assert_allclose(ours.first_order, theirs.first_order, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(ours.total_order, theirs.total_order, rtol=1e-10, atol=1e-12)


def test_pairs_may_be_missing_which_scipy_does_not_take():
    f_a, f_b, f_ab = evaluated(ishigami, 3, 256)
    found = sobol_indices(f_a[:250], f_b[:250], f_ab[:, :250])
    np.testing.assert_allclose(found.total_order, TOTAL, atol=0.05)
    with pytest.raises(ValueError, match="power of 2"):
        stats.sobol_indices(func={"f_A": f_a[None, :250], "f_B": f_b[None, :250], "f_AB": f_ab[:, None, :250]}, n=250)


def test_a_constant_beside_the_function_changes_nothing():
    plain = sobol_indices(*evaluated(ishigami, 3, 128))
    moved = sobol_indices(*evaluated(lambda shares: ishigami(shares) + 1e4, 3, 128))
    for one, other in zip(plain, moved, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-8)


def test_what_adds_up_has_equal_indices_of_both_orders():
    weights = np.array([3.0, 2.0, 1.0, 0.0])
    found = sobol_indices(*evaluated(lambda shares: shares @ weights, 4, 1024))
    np.testing.assert_allclose(found.first_order, weights**2 / 14.0, atol=5e-3)
    np.testing.assert_allclose(found.total_order, weights**2 / 14.0, atol=2e-3)
    assert found.total_order[3] == 0.0


@pytest.mark.slow
def test_the_intervals_hold_the_truth_at_least_as_often_as_they_say():
    """95 % for pairs drawn by chance; pairs of a Sobol sequence scatter less."""
    held = [
        (found.total_order_low <= TOTAL) & (found.total_order_high >= TOTAL)
        for found in (sobol_indices(*evaluated(ishigami, 3, 128, seed)) for seed in range(40))
    ]
    assert np.mean(held) > 0.9


def test_equal_seeds_give_equal_intervals():
    pairs = evaluated(ishigami, 3, 64)
    assert np.array_equal(sobol_indices(*pairs, 5).total_order_low, sobol_indices(*pairs, 5).total_order_low)
    assert not np.array_equal(sobol_indices(*pairs, 5).total_order_low, sobol_indices(*pairs, 6).total_order_low)
