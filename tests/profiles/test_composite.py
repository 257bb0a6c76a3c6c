"""Sums of profiles: linear in everything."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_transforms

import winkler as wk

X = np.array([1e-5, 0.9e-4, 1.1e-4, 2.9e-4, 3.1e-4, 1e-3])


@pytest.mark.slow
def test_guduru_profile_with_a_kink():
    """A paraboloid with a wave and a flattened cone: nothing in common but the sum."""
    profile = wk.Paraboloid(1e-2) + wk.Wavy(1e-8, 2e-3) + wk.TruncatedCone(1.5, 1e-4)
    k, m = 2 * mp.pi / mp.mpf(2e-3), 1 / mp.tan(mp.mpf(1.5))
    slope = lambda r: r / mp.mpf(1e-2) + mp.mpf(1e-8) * k * mp.sin(k * r) + (m if r > 1e-4 else 0)  # noqa: E731
    assert_transforms(profile, slope, X, (1e-4,))


def test_two_balls_of_any_radii():
    """1/R = 1/R1 + 1/R2 for paraboloids, exactly."""
    pair = wk.Paraboloid(2e-2) + wk.Paraboloid(3e-2)
    np.testing.assert_allclose(pair.gap(X), wk.Paraboloid(1.2e-2).gap(X), rtol=1e-14)


def test_properties_of_the_parts():
    ball, punch = wk.Sphere(1e-3), wk.FlatPunch(2e-3)
    both = ball + punch + wk.Berkovich()
    assert isinstance(both, wk.Sum)
    assert both.reach == 1e-3
    assert both.rim == 2e-3
    assert both.size == 1e-3
    assert both.notes == wk.Berkovich().notes
    assert both.rising
    assert not (both + wk.Wavy(1.0, 1.0)).rising


def test_sums_are_flat_and_keep_their_order():
    a, b, c = wk.Paraboloid(1.0), wk.Cone(1.0), wk.Wavy(1.0, 2.0)
    assert (a + b) + c == wk.Sum((a, b, c)) == a + (b + c)
    assert wk.Sum((wk.Sum((a,)), wk.Sum((b, c)))).parts == (a, b, c)
    assert wk.Sum([a]).gap(X).tolist() == a.gap(X).tolist()


def test_kinks_are_merged():
    both = wk.TruncatedCone(math.pi / 4.0, 1e-3) + wk.RoundedPunch(1e-3, 1.0) + wk.TruncatedParaboloid(1.0, 5e-4)
    assert both.kinks == ((5e-4, pytest.approx(5e-4)), (1e-3, pytest.approx(1.0)))


def test_opposite_jumps_cancel():
    """A sharpened and a worn cap of the same radius leave a smooth paraboloid."""
    one, two = wk.CappedParaboloid(1.0, 2.0, 0.1), wk.CappedParaboloid(2.0, 1.0, 0.1)
    both = one + two
    assert both.kinks == ((0.1, pytest.approx(0.0, abs=1e-16)),)
    x = np.array([0.05, 0.1, 0.2])
    np.testing.assert_allclose(both.gap(x), wk.Paraboloid(1.0 / 1.5).gap(x), rtol=1e-14)


def test_nothing_to_add():
    with pytest.raises(wk.InvalidInput, match=r"^Sum: no parts were given; give at least one profile\.$"):
        wk.Sum(())


@pytest.mark.parametrize("other", [1.0, "a", None])
def test_only_profiles_can_be_added(other):
    with pytest.raises((TypeError, wk.InvalidInput)):
        wk.Paraboloid(1.0) + other
