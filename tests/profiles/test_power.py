"""Paraboloid and PowerLaw against quadrature of T1 at 30 digits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from shape_solutions import assert_curvature, assert_starts_at_zero, assert_transforms

import winkler as wk

R = 3e-3
X = np.array([1e-9, 1e-5, 1e-3, 0.2])


def test_paraboloid():
    assert_transforms(wk.Paraboloid(R), lambda r: r / mp.mpf(R), X)
    assert_curvature(wk.Paraboloid(R), lambda r: r / mp.mpf(R), X)
    assert_starts_at_zero(wk.Paraboloid(R))


@pytest.mark.few(1)
@pytest.mark.parametrize("exponent", [0.5, 1.0, 1.05, 1.5, 2.0, 3.0, 4.0, 7.3, 20.0, 120.0])
def test_power_law(exponent):
    c, n = 2.5, exponent
    profile = wk.PowerLaw(c, exponent)
    x = np.array([0.02, 0.3, 1.0, 1.7])

    def slope(r):
        return mp.mpf(c) * mp.mpf(n) * r ** (mp.mpf(n) - 1)

    assert_transforms(profile, slope, x)
    assert_curvature(profile, slope, x)
    assert_starts_at_zero(profile)


@pytest.mark.parametrize(
    ("exponent", "stretch"),
    [(1.0, math.pi / 2.0), (2.0, 2.0), (3.0, 0.75 * math.pi), (4.0, 8.0 / 3.0), (5.0, 2.9452431127404311), (6.0, 3.2)],
)
def test_stretch_of_the_theory_sheet(exponent, stretch):
    assert wk.PowerLaw(1.0, exponent).stretch == pytest.approx(stretch, rel=1e-14)


def test_stretch_of_a_nearly_flat_punch():
    """kappa_n grows as sqrt(pi n/2): Stirling."""
    assert wk.PowerLaw(1.0, 1e6).stretch == pytest.approx(math.sqrt(0.5e6 * math.pi), rel=1e-6)


def test_the_axis_of_a_cusp():
    """f = c sqrt(r) is infinitely steep at the axis and f'' minus infinite there; g is still zero."""
    cusp = wk.PowerLaw(1.0, 0.5)
    assert cusp.slope(np.zeros(1))[0] == math.inf
    assert cusp.curvature(np.zeros(1))[0] == -math.inf
    assert cusp.gap_slope(np.zeros(1))[0] == math.inf
    assert_starts_at_zero(cusp)


def test_power_laws_meet_the_named_shapes():
    np.testing.assert_allclose(wk.PowerLaw(1.0 / (2.0 * R), 2.0).gap(X), wk.Paraboloid(R).gap(X), rtol=1e-14)
    np.testing.assert_allclose(wk.PowerLaw(0.5, 1.0).gap(X), wk.Cone(math.atan(2.0)).gap(X), rtol=1e-14)


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf, "1 mm", None, True])
def test_bad_numbers(bad):
    with pytest.raises(
        wk.InvalidInput,
        match=r"^Paraboloid: curvature_radius is .*; it must be a positive, finite "
        r"number in m\.$",
    ):
        wk.Paraboloid(bad)
    with pytest.raises(wk.InvalidInput, match=r"^PowerLaw: coefficient is .* number in m\^\(1-n\)\.$"):
        wk.PowerLaw(bad, 2.0)
    with pytest.raises(wk.InvalidInput, match=r"^PowerLaw: exponent is .*; it must be a positive, finite number\.$"):
        wk.PowerLaw(1.0, bad)
