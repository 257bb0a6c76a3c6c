"""The greatest pressure of a contact without friction against closed forms."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

import winkler as wk

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3))
LOADS = np.array([0.0, 10.0, 1000.0])


def solved(profile, load, medium=STEEL):
    return wk.Indentation(wk.Foundation(profile, medium), load).solve()


def test_hertz_of_many_loads():
    pressed = solved(wk.Paraboloid(10e-3), wk.Force(LOADS))
    expected = np.cbrt(6.0 * LOADS * STEEL.modulus**2 / (np.pi**3 * 10e-3**2))
    assert pressed.peak_pressure == pytest.approx(expected, rel=1e-12)
    assert float(pressed.at(2).peak_pressure) == pytest.approx(expected[2], rel=1e-12)


def test_sphere_against_quadrature():
    # p(0) = E*/pi times the integral of g'(x) / x, with g = (x/2) ln((R + x) / (R - x))
    a, ball = mpmath.mpf("4e-3"), mpmath.mpf("10e-3")

    def slope_over_place(x):
        return (mpmath.log((ball + x) / (ball - x)) / 2 + x * ball / (ball**2 - x**2)) / x

    expected = STEEL.modulus / mpmath.pi * mpmath.quad(slope_over_place, [0, a])
    assert float(solved(wk.Sphere(10e-3), wk.Radius(4e-3)).peak_pressure) == pytest.approx(float(expected), rel=1e-9)


def test_off_the_axis_of_a_blunt_body():
    # f ~ r^4: p ~ (a^2 + 2 r^2) sqrt(a^2 - r^2), greatest at r = a / sqrt(2), sqrt(2) / 1.2 times the mean
    pressed = solved(wk.PowerLaw(1e6, 4.0), wk.Force(50.0))
    assert float(pressed.peak_pressure / pressed.mean_pressure) == pytest.approx(2.0**0.5 / 1.2, rel=1e-9)


@pytest.mark.parametrize("profile", [wk.Cone(1.2), wk.FlatPunch(1e-3), wk.TruncatedCone(1.2, 1e-4)])
def test_infinite_at_what_is_sharp(profile):
    assert float(solved(profile, wk.Force(50.0)).peak_pressure) == np.inf


def test_ellipse_as_that_of_hertz():
    bodies = wk.CurvedBodies(10e-3, 2e-3)
    springs = wk.Indentation(wk.EllipticFoundation(bodies, STEEL), wk.Force(20.0)).solve()
    exact = wk.EllipticIndentation(bodies, STEEL, wk.Force(20.0)).solve()
    assert float(springs.peak_pressure) == pytest.approx(float(exact.peak_pressure), rel=1e-9)


def test_refused_where_the_outline_is_unknown():
    radii = np.linspace(1e-6, 8e-6, 8)
    pressed = wk.Indentation(wk.MeasuredBed(radii, 1e9 * radii, 1e3 * radii**2), wk.Depth(2e-8)).solve()
    with pytest.raises(wk.OutsideValidity, match="outline"):
        _ = pressed.peak_pressure
