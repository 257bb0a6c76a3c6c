"""Sphere, ellipsoid and hyperboloid against quadrature of T1 at 30 digits, and their limits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_curvature, assert_starts_at_zero, assert_transforms

import winkler as wk

X = np.array([1e-7, 1e-3, 0.1, 0.19999, 0.2, 0.3, 0.5, 0.9, 0.99, 1.0 - 1e-6])


@pytest.mark.few(1)
@pytest.mark.parametrize("radius", [1.0, 7e-9])
def test_sphere(radius):
    big = mp.mpf(radius)
    assert_transforms(wk.Sphere(radius), lambda r: r / mp.sqrt(big**2 - r**2), radius * X, (radius,))
    assert_curvature(wk.Sphere(radius), lambda r: r / mp.sqrt(big**2 - r**2), radius * X[:-1])
    assert_starts_at_zero(wk.Sphere(radius))


@pytest.mark.few(1)
@pytest.mark.parametrize(("radial", "axial"), [(1.0, 0.2), (1.0, 5.0), (1e-4, 1e-4)])
def test_ellipsoid(radial, axial):
    a, b = mp.mpf(radial), mp.mpf(axial)
    assert_transforms(wk.Ellipsoid(radial, axial), lambda r: b / a * r / mp.sqrt(a**2 - r**2), radial * X, (radial,))


@pytest.mark.slow
@pytest.mark.parametrize("degrees", [5.0, 45.0, 70.0, 89.0])
def test_hyperboloid(degrees):
    """f = c (sqrt(1 + r^2/A^2) - 1), c/A = 1/tan(half_angle), A^2/c = R."""
    big, theta = 2e-6, math.radians(degrees)
    m = 1 / mp.tan(mp.mpf(theta))
    length = big * m
    x = float(length) * np.array([1e-6, 1e-2, 0.1999, 0.2001, 1.0, 30.0, 1e6])
    assert_transforms(wk.Hyperboloid(big, theta), lambda r: m * r / mp.sqrt(length**2 + r**2), x)
    assert_curvature(wk.Hyperboloid(big, theta), lambda r: m * r / mp.sqrt(length**2 + r**2), x)


def test_theory_sheet_numbers():
    """Exact sphere R = 1, a = 0.5."""
    assert wk.Sphere(1.0).gap(np.array([0.5]))[0] == pytest.approx(0.274653072167027, rel=1e-14)
    half_force = 0.5 * wk.Sphere(1.0).gap(np.array([0.5])) - wk.Sphere(1.0).gap_integral(np.array([0.5]))
    assert 2.0 * half_force[0] == pytest.approx(0.186632680417569, rel=1e-13)


def test_limits_of_the_hyperboloid():
    """Close to its apex a paraboloid, far from it a cone."""
    tip = wk.Hyperboloid(1.0, math.radians(50.0))
    near = np.array([1e-8, 1e-6])
    np.testing.assert_allclose(tip.gap(near), wk.Paraboloid(1.0).gap(near), rtol=1e-11)
    np.testing.assert_allclose(tip.gap_integral(near), wk.Paraboloid(1.0).gap_integral(near), rtol=1e-11)
    far = np.array([1e10, 1e12])
    np.testing.assert_allclose(tip.gap(far), wk.Cone(math.radians(50.0)).gap(far), rtol=1e-9)


def test_limits_of_sphere_and_ellipsoid():
    """x/R -> 0: the paraboloid; the ellipsoid's apex has the curvature radius A^2/B."""
    x = np.array([1e-9, 1e-7])
    np.testing.assert_allclose(wk.Sphere(0.5).gap(x), wk.Paraboloid(0.5).gap(x), rtol=1e-12)
    np.testing.assert_allclose(wk.Ellipsoid(0.5, 0.2).gap(x), wk.Paraboloid(0.25 / 0.2).gap(x), rtol=1e-12)
    assert np.array_equal(wk.Ellipsoid(0.5, 0.5).gap(X / 2), wk.Sphere(0.5).gap(X / 2))


def test_the_equator_and_beyond():
    ball = wk.Sphere(2.0)
    assert ball.reach == ball.size == 2.0
    assert ball.height(np.array([2.0]))[0] == 2.0
    assert ball.height(np.array([2.1]))[0] == math.inf
    assert ball.slope(np.array([2.0]))[0] == math.inf
    assert ball.curvature(np.array([2.0]))[0] == math.inf


@pytest.mark.parametrize("bad", [0.0, -1e-3, math.nan, math.inf])
def test_bad_numbers(bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"^Sphere: curvature_radius is .*; it must be a positive, finite number "
        r"in m\.$",
    ):
        wk.Sphere(bad)
    with pytest.raises(wk.InvalidInput, match="^Ellipsoid: radial_semi_axis is"):
        wk.Ellipsoid(bad, 1.0)
    with pytest.raises(wk.InvalidInput, match="^Ellipsoid: axial_semi_axis is"):
        wk.Ellipsoid(1.0, bad)
    with pytest.raises(wk.InvalidInput, match="^Hyperboloid: curvature_radius is"):
        wk.Hyperboloid(bad, 1.0)


@pytest.mark.parametrize("bad", [0.0, -0.3, 0.5 * math.pi, math.nan, math.inf, "1.2"])
def test_bad_angles(bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"^Hyperboloid: half_angle is .* rad; measured from the axis it must lie "
        r"between 0 and pi/2.*\.$",
    ):
        wk.Hyperboloid(1.0, bad)
