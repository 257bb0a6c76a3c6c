"""Cones, sharp, cut and rounded, and the equal-area cones of pyramids, against quadrature of T1 at 30 digits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_curvature, assert_starts_at_zero, assert_transforms

import winkler as wk

DEGREES = [5.0, 22.5, 70.0, 89.0]
X = np.array([1e-3, 0.3, 0.9, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.0 + 1e-4, 1.1, 2.0, 20.0])
"""In units of the length of the shape, where its kink is."""


@pytest.mark.few(1)
@pytest.mark.parametrize("degrees", DEGREES)
def test_cone(degrees):
    theta = math.radians(degrees)
    m = 1 / mp.tan(mp.mpf(theta))
    assert_transforms(wk.Cone(theta), lambda r: m + 0 * r, 1e-6 * X)
    assert_starts_at_zero(wk.Cone(theta))
    # at the axis the slope is that of the flank, and g' = (pi/2) m
    assert wk.Cone(theta).slope(np.zeros(1))[0] == pytest.approx(float(m), rel=1e-14)
    assert wk.Cone(theta).gap_slope(np.zeros(1))[0] == pytest.approx(float(m * mp.pi / 2), rel=1e-14)
    assert float(wk.Cone(theta).gap_slope(np.array(0.0))) == pytest.approx(float(m * mp.pi / 2), rel=1e-14)


@pytest.mark.few(1)
@pytest.mark.parametrize("degrees", DEGREES)
def test_truncated_cone(degrees):
    theta, b = math.radians(degrees), 2e-6
    m = 1 / mp.tan(mp.mpf(theta))
    x = np.delete(b * X, 4)
    assert_transforms(wk.TruncatedCone(theta, b), lambda r: m if r > b else mp.mpf(0), x, (b,))
    assert_starts_at_zero(wk.TruncatedCone(theta, b))


def test_truncated_cone_at_its_kink():
    """At b itself everything is still that of the flat: the values just below."""
    tip = wk.TruncatedCone(1.0, 2e-6)
    for word in ("height", "slope", "gap", "gap_slope", "gap_integral"):
        assert getattr(tip, word)(np.array([2e-6]))[0] == 0.0, word
    assert tip.kinks == ((2e-6, pytest.approx(1.0 / math.tan(1.0))),)


@pytest.mark.parametrize("distance", [1e-14, 1e-12, 1e-9, 1e-6])
def test_just_above_a_flat_all_digits_are_kept(distance):
    """g = m x arccos(b/x) and its integral, at the very double that x is."""
    b = 1.0
    x = b * (1.0 + distance)
    for profile, gap, total in (
        (wk.TruncatedCone(math.pi / 4.0, b), lambda t: t * mp.acos(b / t), None),
        (wk.TruncatedParaboloid(1.0, b), lambda t: t * mp.sqrt(t**2 - 1), lambda t: mp.sqrt(t**2 - 1) ** 3 / 3),
        (wk.RoundedPunch(b, 1.0), lambda t: t * (mp.sqrt(t**2 - 1) - mp.acos(b / t)), None),
    ):
        with mp.workdps(60):
            scale = 1 / mp.tan(mp.mpf(math.pi / 4.0)) if isinstance(profile, wk.TruncatedCone) else mp.mpf(1)
            expected = float(scale * gap(mp.mpf(x)))
            integral = float(total(mp.mpf(x))) if total else None
        assert profile.gap(np.array([x]))[0] == pytest.approx(expected, rel=1e-14, abs=0.0)
        if integral is not None:
            assert profile.gap_integral(np.array([x]))[0] == pytest.approx(integral, rel=1e-13, abs=0.0)


@pytest.mark.few(1)
@pytest.mark.parametrize("degrees", DEGREES)
def test_rounded_cone(degrees):
    theta, big = math.radians(degrees), 3e-8
    tip = wk.RoundedCone(big, theta)
    m = 1 / mp.tan(mp.mpf(theta))
    b = mp.mpf(tip.blend_radius)
    assert float(abs(b - big * m)) <= 2e-15 * float(b)
    x = float(b) * X
    assert_transforms(tip, lambda r: m * min(r / b, mp.mpf(1)), x, (float(b),))
    assert_curvature(tip, lambda r: m * min(r / b, mp.mpf(1)), x[np.abs(X - 1.0) > 1e-6])


@pytest.mark.slow
@pytest.mark.parametrize("degrees", DEGREES)
def test_sphero_conical(degrees):
    theta, big = math.radians(degrees), 1e-8
    tip = wk.SpheroConical(big, theta)
    radius, m = mp.mpf(big), 1 / mp.tan(mp.mpf(theta))
    b = mp.mpf(tip.blend_radius)
    assert float(abs(b - radius * mp.cos(mp.mpf(theta)))) <= 2e-15 * float(b)

    def slope(r):
        return r / mp.sqrt(radius**2 - r**2) if r <= b else m

    assert_transforms(tip, slope, float(b) * X, (float(b),), rtol=2e-12)
    assert_curvature(tip, slope, float(b) * X[np.abs(X - 1.0) > 1e-3], rtol=1e-10)
    assert_starts_at_zero(tip)


@pytest.mark.parametrize("degrees", [5.0, 45.0, 89.0])
def test_limits_of_rounded_tips(degrees):
    """Near the apex the paraboloid (or sphere); far away a cone, whose apex would lie at the right depth."""
    theta = math.radians(degrees)
    near, far = np.array([1e-5, 1e-4]) / math.tan(theta), np.array([1e3, 1e4])
    rounded, ball = wk.RoundedCone(1.0, theta), wk.SpheroConical(1.0, theta)
    np.testing.assert_allclose(rounded.gap(near), wk.Paraboloid(1.0).gap(near), rtol=1e-13)
    inside = 0.99 * ball.blend_radius * np.array([1e-3, 1.0])
    np.testing.assert_allclose(ball.gap(inside), wk.Sphere(1.0).gap(inside), rtol=1e-13)
    # g - g(cone) tends to a constant: by how much the sharp tip is missing
    sharp = wk.Cone(theta).gap(far)
    for tip, missing in (
        (rounded, 0.5 / math.tan(theta) ** 2),
        (ball, 1.0 / math.sin(theta) - 1.0),
    ):
        excess = wk.Cone(theta).height(far) - tip.height(far)
        np.testing.assert_allclose(excess, missing, rtol=1e-7, atol=4e-12 * far[-1])
        np.testing.assert_allclose(sharp - tip.gap(far), missing, rtol=0.02, atol=2e-12 * float(sharp[-1]))


@pytest.mark.parametrize("ratio", [1e2, 1e3, 1e6])
def test_rounded_cone_far_from_its_tip(ratio):
    """A sharp tip pressed deep: what is lost is x/b units in the last place."""
    theta, big = math.radians(70.0), 1e-8
    tip = wk.RoundedCone(big, theta)
    m, b = 1 / mp.tan(mp.mpf(theta)), mp.mpf(tip.blend_radius)
    x = float(b) * ratio
    assert_transforms(tip, lambda r: m * min(r / b, mp.mpf(1)), [x], (float(b),), rtol=max(1e-12, 2e-16 * ratio))


PYRAMIDS = {
    # half-angle of the equal-area cone [deg], area function A(h) = C0 h^2
    "berkovich": (wk.Berkovich(), 70.30, 24.49),
    "vickers": (wk.Vickers(), 70.30, 24.504),
    "cube corner": (wk.CubeCorner(), 42.28, 2.598),
}


@pytest.mark.parametrize("name", PYRAMIDS)
def test_equal_area_cones(name):
    profile, degrees, area = PYRAMIDS[name]
    assert math.degrees(profile.half_angle) == pytest.approx(degrees, abs=0.05)
    assert math.pi * math.tan(profile.half_angle) ** 2 == pytest.approx(area, rel=1e-3)
    x = np.array([1e-6])
    np.testing.assert_allclose(profile.gap(x), wk.Cone(profile.half_angle).gap(x), rtol=1e-14)


def test_equal_area_cones_from_the_pyramids_geometry():
    """Cross-sections written down independently: a triangle of inradius h tan(a), a square of inradius h tan(a)."""
    berkovich = 3.0 * math.sqrt(3.0) * math.tan(math.radians(65.27)) ** 2
    cube = 3.0 * math.sqrt(3.0) * math.tan(math.atan(1.0 / math.sqrt(2.0))) ** 2
    vickers = (2.0 * math.tan(math.radians(68.0))) ** 2
    for profile, area in ((wk.Berkovich(), berkovich), (wk.CubeCorner(), cube), (wk.Vickers(), vickers)):
        h = 1.0
        assert math.pi * (h * math.tan(profile.half_angle)) ** 2 == pytest.approx(area, rel=1e-4)


@pytest.mark.parametrize("name", PYRAMIDS)
def test_a_pyramid_says_that_it_is_approximate(name):
    notes = PYRAMIDS[name][0].notes
    assert any(note.standing is wk.Standing.APPROXIMATE and "equal cross-section" in note.statement for note in notes)


@pytest.mark.parametrize("bad", [0.0, -0.1, 0.5 * math.pi, 70.3, 1e9, math.nan, math.inf, "1.2", None, True])
@pytest.mark.parametrize(
    "make",
    [
        wk.Cone,
        lambda t: wk.TruncatedCone(t, 1e-6),
        lambda t: wk.RoundedCone(1e-6, t),
        lambda t: wk.SpheroConical(1e-6, t),
    ],
)
def test_bad_angles(make, bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"half_angle is .* rad; measured from the axis it must lie between 0 and "
        r"pi/2.*\.$",
    ):
        make(bad)


def test_degrees_are_noticed():
    with pytest.raises(wk.InvalidInput, match=r"if 70.3 are degrees, give math.radians\(70.3\)"):
        wk.Cone(70.3)


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_bad_lengths(bad):
    with pytest.raises(wk.InvalidInput, match=r"^TruncatedCone: flat_radius is .*; it must be a positive"):
        wk.TruncatedCone(1.0, bad)
    with pytest.raises(wk.InvalidInput, match=r"^RoundedCone: curvature_radius is .*; it must be a positive"):
        wk.RoundedCone(bad, 1.0)
    with pytest.raises(wk.InvalidInput, match=r"^SpheroConical: curvature_radius is .*; it must be a positive"):
        wk.SpheroConical(bad, 1.0)
