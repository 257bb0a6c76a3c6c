"""Flat punches, capped cylinders, and the cylinder on its side that is refused."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_transforms

import winkler as wk


def test_flat_punch():
    punch = wk.FlatPunch(2e-3)
    assert punch.reach == punch.rim == 2e-3
    assert punch.size == math.inf
    x = np.array([[0.0, 1e-3], [1.9e-3, 2e-3]])
    for word in ("height", "slope", "curvature", "gap", "gap_slope", "gap_integral"):
        got = getattr(punch, word)(x)
        assert got.shape == x.shape
        assert not np.any(got)
        assert np.shape(getattr(punch, word)(np.array(1e-3))) == ()


def test_capped_cylinder_is_its_cap_up_to_the_rim():
    b, theta = 1e-3, 1.3
    m = 1 / mp.tan(mp.mpf(theta))
    profile = wk.CappedCylinder(b, wk.TruncatedCone(theta, 0.4e-3))
    x = b * np.array([0.1, 0.39, 0.41, 0.9, 1.0])
    assert_transforms(profile, lambda r: m if r > 0.4e-3 else mp.mpf(0), x, (0.4e-3,))
    assert profile.reach == profile.rim == b
    assert profile.kinks == profile.cap.kinks


def test_capped_cylinder_forgets_kinks_beyond_its_rim():
    assert wk.CappedCylinder(1e-3, wk.TruncatedCone(1.0, 2e-3)).kinks == ()


def test_capped_cylinder_keeps_what_its_cap_says():
    cap = wk.Berkovich()
    assert wk.CappedCylinder(1e-3, cap).notes == cap.notes
    assert wk.CappedCylinder(1e-3, wk.Wavy(1e-7, 1e-4)).rising is False


def test_a_cap_must_reach_the_rim():
    with pytest.raises(
        wk.InvalidInput,
        match=r"^CappedCylinder: the cap is known up to 0.001 m but the cylinder has "
        r"the radius 0.002 m; give a cap that reaches the rim\.$",
    ):
        wk.CappedCylinder(2e-3, wk.Sphere(1e-3))
    with pytest.raises(wk.InvalidInput, match="the cap is known up to 0.001 m"):
        wk.CappedCylinder(2e-3, wk.FlatPunch(1e-3))


def test_a_cap_that_is_vertical_at_the_rim():
    """A hemisphere of the cylinder's own radius: g diverges at the rim, though f does not."""
    with pytest.raises(wk.InvalidInput, match="vertical at the rim"):
        wk.CappedCylinder(1e-3, wk.Sphere(1e-3))


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_bad_radius(bad):
    with pytest.raises(
        wk.InvalidInput, match=r"^FlatPunch: radius is .*; it must be a positive, finite number in m\.$"
    ):
        wk.FlatPunch(bad)
    with pytest.raises(wk.InvalidInput, match=r"^CappedCylinder: radius is .*; it must be a positive"):
        wk.CappedCylinder(bad, wk.Paraboloid(1.0))


def test_a_cylinder_on_its_side_is_refused_kindly():
    with pytest.raises(
        wk.OutsideValidity,
        match=r"line contact.*not a body of revolution.*infinite.*LineIndentation with LineFoundation.*"
        r"or CappedCylinder",
    ):
        wk.Cylinder(1e-3)
