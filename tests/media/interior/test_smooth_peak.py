"""The search of the greatest stress below a contact: few places in smooth fields, narrow and deep tops, cusps."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from winkler.media.interior.peak import greatest

GRID = 16 * 25
"""Places of the first grid."""


def counted(function):
    """Return a field that counts at how many places it is asked."""

    def field(r, z):
        field.places += r.size
        return function(r, z)

    field.places = 0
    return field


def hertz(poisson):
    """Von Mises stress on the axis under Hertz's pressure, over p0; off the axis less (K. L. Johnson 1985, 3.45)."""

    def stress(z):
        axial = -1.0 / (1.0 + z**2)
        radial = -(1.0 + poisson) * (1.0 - z * np.arctan2(1.0, z)) + 0.5 / (1.0 + z**2)
        return np.abs(axial - radial)

    return stress


@pytest.mark.parametrize("poisson", [0.1, 0.3, 0.5])
def test_top_on_the_axis(poisson):
    stress = hertz(poisson)
    expected = minimize_scalar(lambda z: -stress(z), bounds=(0.2, 1.0), method="bounded", options={"xatol": 1e-10})
    field = counted(lambda r, z: stress(z) * np.exp(-0.3 * r**2))
    found = greatest(field, 1.0)
    assert found.value == pytest.approx(-expected.fun, rel=1e-14)
    assert (found.r, found.z) == (pytest.approx(0.0, abs=1e-7), pytest.approx(expected.x, abs=1e-6))
    assert field.places <= GRID + 250


@pytest.mark.parametrize("both_sides", [False, True])
def test_inclined_ridge(both_sides):
    field = counted(lambda r, z: 5.0 - (r - 0.61) ** 2 - 4.0 * (z - 0.37 - 0.6 * (r - 0.61)) ** 2 - (r - 0.61) ** 4)
    found = greatest(field, 1.0, both_sides=both_sides)
    assert (found.value, found.r, found.z) == pytest.approx((5.0, 0.61, 0.37), abs=1e-6)
    assert found.value == pytest.approx(5.0, rel=1e-12)
    assert field.places <= (2 * GRID + 121 if both_sides else GRID) + 250  # on both sides, and on the surface


def test_top_at_the_surface_and_none_at_all():
    surface = greatest(lambda r, z: np.exp(-((r - 0.5) ** 2) - z), 1.0)
    assert (surface.r, surface.z) == (pytest.approx(0.5, abs=1e-6), 0.0)
    level = counted(lambda r, z: np.full(r.shape, 2.0))
    assert greatest(level, 1.0).value == 2.0
    assert level.places == GRID + 25


def test_a_cusp_off_the_grid():
    field = counted(lambda r, z: -np.hypot(r - 0.61, z - 0.37))
    found = greatest(field, 1.0)
    assert (found.r, found.z) == (pytest.approx(0.61, abs=1e-6), pytest.approx(0.37, abs=1e-6))
    assert field.places <= GRID + 1000


def test_the_greater_of_two_narrow_peaks_on_both_sides():
    """As of a rubbed punch: ahead it is higher, behind wider, and coarse values are greater behind."""

    def field(r, z):
        ahead = 1.2 * np.exp(-(((r - 0.991) / 0.004) ** 2) - (z / 0.004) ** 2)
        return ahead + np.exp(-(((r + 0.99) / 0.01) ** 2) - (z / 0.01) ** 2)

    found = greatest(field, 1.0, both_sides=True)
    assert (found.value, found.r, found.z) == pytest.approx((1.2, 0.991, 0.0), abs=2e-6)


def test_a_peak_at_the_surface_beside_one_below():
    """It is narrower, and higher."""

    def field(r, z):
        surface = 1.2 * np.exp(-(((r - 0.993) / 0.002) ** 2) - z / 0.0005)
        return surface + np.exp(-(((r - 1.0) / 0.01) ** 2) - ((z - 0.01) / 0.01) ** 2)

    found = greatest(field, 1.0, both_sides=True)
    line = np.linspace(0.97, 1.01, 4001)
    assert found.z == 0.0
    assert found.value == pytest.approx(np.max(field(line, np.zeros(4001))), rel=1e-5)


def test_a_place_that_rounding_moves_off_the_axis_lies_on_it():
    """Values at the axis and within 1e-8 of it are equal but for rounding: which one is greater says nothing."""
    stress = hertz(0.3)
    field = counted(lambda r, z: stress(z) * (1.0 - 0.3 * r**2) * (1.0 + 1e-15 * np.sign(r)))
    found = greatest(field, 1.0)
    assert found.r == 0.0
    beside = greatest(lambda r, z: stress(z) * (1.0 - 0.3 * (r - 1e-3) ** 2), 1.0)
    assert beside.r == pytest.approx(1e-3, rel=1e-3)


@pytest.mark.parametrize(("top", "bottom", "place"), [(1.0, np.inf, 30.0), (1.0, 20.0, 20.0), (0.0, np.inf, 30.0)])
def test_a_greatest_value_far_deeper_than_the_contact_is_wide(top, bottom, place):
    """As in a soft base whose stiff layer spreads the pressure: z exp(-z/30) under a contact of 0.1."""
    found = greatest(lambda r, z: z * np.exp(-z / 30.0 - r**2), 0.1, top=top, bottom=bottom)
    assert (found.r, found.z) == (pytest.approx(0.0, abs=1e-6), pytest.approx(place, rel=1e-5))
    assert found.value == pytest.approx(place * np.exp(-place / 30.0), rel=1e-10)
