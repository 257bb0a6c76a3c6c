"""Inversion of rising functions against roots known in closed form or to 30 digits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from winkler.numerics.equations.roots import between, invert
from winkler.values.errors import NotConverged, OutsideValidity


@pytest.mark.parametrize("power", [0.3, 1.0, 2.0, 3.7, 20.0])
@pytest.mark.parametrize("guess", [1e-12, 1.0, 1e9])
def test_powers_over_sixty_decades(power, guess):
    expected = np.geomspace(1e-30, 1e30, 25) ** (1.0 / max(power, 1.0))
    got = invert(
        lambda x: (x**power, power * x ** (power - 1.0)), expected**power, lower=0.0, upper=math.inf, guess=guess
    )
    np.testing.assert_allclose(got, expected, rtol=1e-14)


def test_a_function_that_diverges_at_the_upper_end():
    """x artanh(x) = d: the sphere, up to where doubles end."""
    target = np.array([1e-20, 1e-3, 0.5, 3.0, 10.0, 15.0, 18.0, 40.0])
    got = invert(
        lambda x: (x * np.arctanh(x), np.arctanh(x) + x / ((1.0 - x) * (1.0 + x))),
        target,
        lower=0.0,
        upper=1.0,
        guess=0.1,
    )
    mp.mp.dps = 40
    for x, d in zip(got, target, strict=True):
        start = mp.sqrt(mp.mpf(d)) if d < 0.5 else mp.mpf(d)
        exact = mp.tanh(mp.findroot(lambda u, d=d: u * mp.tanh(u) - mp.mpf(d), start))
        assert abs(x - exact) <= 4e-16 * exact  # as good as the next double
        assert x < 1.0


@pytest.mark.parametrize("power", [0.5, 1.5, 2.5])
def test_a_function_that_starts_above_zero(power):
    """Close above the lower end the distance from it is found to rounding, not only x."""
    distance = np.geomspace(1e-13, 1e6, 20)
    got = invert(
        lambda x: ((x - 1.0) ** power, power * (x - 1.0) ** (power - 1.0)),
        distance**power,
        lower=1.0,
        upper=math.inf,
        guess=2.0,
    )
    np.testing.assert_allclose(got, 1.0 + distance, rtol=5e-16)


def test_a_bend_between_two_powers():
    """A square that goes over into a 200th power: Newton alone would overshoot."""

    def function(x):
        return x**2 + x**200.0, 2.0 * x + 200.0 * x**199.0

    expected = np.array([1e-8, 0.5, 0.97, 1.0, 1.01, 1.5])
    got = invert(function, function(expected)[0], lower=0.0, upper=30.0, guess=1e-3)
    np.testing.assert_allclose(got, expected, rtol=1e-13)


def test_a_step_is_found_between_neighbours():
    """A jump has no root; the place of the jump is the result."""
    got = invert(
        lambda x: (np.where(x < 0.3, 1.0, 2.0) * x, np.ones_like(x)), np.array([0.45]), lower=0.0, upper=9.0, guess=1.0
    )
    assert got[0] == pytest.approx(0.3, rel=1e-14)


def test_slopes_that_are_infinite_zero_or_wrong_do_not_mislead():
    """Only the values decide: with useless slopes it bisects."""
    for slope in (math.inf, 0.0, -1.0, math.nan):
        got = invert(
            lambda x, s=slope: (x**3, np.full_like(x, s)), np.array([8.0, 1e-9]), lower=0.0, upper=math.inf, guess=1.0
        )
        np.testing.assert_allclose(got, [2.0, 1e-3], rtol=1e-12)


def test_one_answer_does_not_depend_on_the_others():
    def function(x):
        return x * np.sinh(x), np.sinh(x) + x * np.cosh(x)

    targets = np.geomspace(1e-6, 1e6, 37)
    together = invert(function, targets, lower=0.0, upper=math.inf, guess=1.0)
    alone = [invert(function, np.array([t]), lower=0.0, upper=math.inf, guess=1.0)[0] for t in targets]
    np.testing.assert_allclose(together, alone, rtol=4e-16)


MANY = {
    "a bend": (lambda x: (x**2 + x**200.0, 2.0 * x + 200.0 * x**199.0), 0.0, 30.0, np.geomspace(1e-8, 1.5, 5000)),
    "a pole": (
        lambda x: (x * np.arctanh(x), np.arctanh(x) + x / ((1.0 - x) * (1.0 + x))),
        0.0,
        1.0,
        1.0 - np.geomspace(1e-12, 0.999, 5000),
    ),
    "a flat": (
        lambda x: ((x - 1.0) ** 1.5, 1.5 * np.sqrt(x - 1.0)),
        1.0,
        math.inf,
        1.0 + np.geomspace(1e-9, 1e6, 5000),
    ),
    "a kink": (
        lambda x: (np.where(x < 2.0, x, 10.0 * x - 18.0), np.where(x < 2.0, 1.0, 10.0)),
        0.0,
        9.0,
        np.linspace(1e-3, 8.9, 5000),
    ),
    "a useless slope": (lambda x: (x**3, np.full_like(x, np.nan)), 0.0, 9.0, np.geomspace(1e-3, 8.0, 5000)),
    "a root at the end": (lambda x: (x**2, 2.0 * x), 0.0, math.nextafter(3.0, 4.0), np.linspace(1e-3, 3.0, 5000)),
}


@pytest.mark.parametrize("name", MANY)
def test_many_targets_have_the_roots_of_few(name):
    """Unsorted, so that none of the roots may be taken for that of a neighbour."""
    function, lower, upper, expected = MANY[name]
    expected = np.random.default_rng(3).permutation(expected)
    target = function(expected)[0]
    together = invert(function, target, lower=lower, upper=upper, guess=1.5 if lower else 0.3)
    few = [invert(function, own, lower=lower, upper=upper, guess=1.5 if lower else 0.3) for own in np.split(target, 25)]
    np.testing.assert_allclose(together, np.concatenate(few), rtol=1e-14)
    np.testing.assert_allclose(function(together)[0], target, rtol=1e-10)


def test_a_smooth_function_is_read_little_more_than_once_for_each_of_many_targets():
    """Over four decades of the targets; one alone takes four to six readings."""
    read = []

    def function(x):
        read.append(x.size)
        return x * np.sinh(x), np.sinh(x) + x * np.cosh(x)

    invert(function, np.geomspace(1e-2, 1e2, 20_000), lower=0.0, upper=math.inf, guess=1.0)
    assert sum(read) < 1.5 * 20_000


def test_a_target_that_is_never_met():
    with pytest.raises(NotConverged, match="No contact radius carries the load"):
        invert(
            lambda x: (np.tanh(x), np.cosh(np.minimum(x, 300.0)) ** -2.0),
            np.array([2.0]),
            lower=0.0,
            upper=math.inf,
            guess=1.0,
        )


def test_one_root_in_a_bracket():
    assert between(lambda x: x**3 - 2.0, 0.0, 2.0) == pytest.approx(2.0 ** (1.0 / 3.0), rel=1e-15)
    assert between(lambda x: x - 1e-200, 0.0, 1.0) == pytest.approx(1e-200, rel=1e-12)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_root_that_rounding_pushes_out_of_its_bracket_is_its_end(sign):
    """exp(log(2)) is no longer 2: what vanishes at the lower end does not change its sign above it."""
    bottom, top = math.log(2.0), math.log(3.0)
    low = 1e-16 + math.exp(bottom)
    assert math.exp(between(lambda y: sign * (math.exp(y) - low + 4e-16), bottom, top)) == pytest.approx(2.0, rel=1e-15)
    assert between(lambda x: sign * (x - 1.0 + 1e-12), 1.0, 5.0) == 1.0
    assert between(lambda x: sign * (x - 5.0 - 1e-12), 1.0, 5.0) == 5.0
    assert between(lambda x: sign, 1.0, 1.0 + 1e-12) == 1.0


def test_a_bracket_without_a_root_is_an_error_of_winkler():
    with pytest.raises(
        NotConverged, match=r"No root lies between 1 and 2 \(f\(a\) and f\(b\) must have different signs\)"
    ):
        between(lambda x: x, 1.0, 2.0)
    with pytest.raises(NotConverged, match="No root lies between"):
        between(lambda x: math.nan, 1.0, 2.0)

    def refused(x):
        raise OutsideValidity("beyond what is known.")

    with pytest.raises(OutsideValidity, match="beyond what is known"):
        between(refused, 1.0, 2.0)


def test_newton_that_swings_about_a_root_is_halved():
    """Of sign(z) |z|^0.505 in logarithms each step of Newton leads to -0.98 z, always within its bracket."""

    def swinging(x):
        z = np.log(x)
        size = np.maximum(np.abs(z), 1e-300)
        value = np.exp(np.sign(z) * size**0.505)
        return value, value * 0.505 * size**-0.495 / x

    found = invert(swinging, np.array([1.0]), lower=0.0, upper=np.inf, guess=3.0)
    assert found == pytest.approx(1.0, rel=1e-8)  # the last step is of 3e-9
