"""The fields below the surface in closed form against Hankel's integrals in 30 digits (theory 1.2)."""

from __future__ import annotations

import mp_solutions
import mpmath as mp
import numpy as np
import pytest

from winkler.reference import hertz, punch

PLACES = [(0.0, 0.5), (0.6, 0.5), (1.0, 0.4), (1e-5, 0.7), (1.7, 1.1), (0.4, 3.0)]
NU, G = 0.3, 0.35


def compared(given, expected, scale):
    for name, number in expected.items():
        assert abs(mp.mpf(float(getattr(given, name))) - number) <= 1e-12 * abs(number) + 3e-16 * scale, name


@pytest.mark.few(1)
@pytest.mark.parametrize(("r", "z"), PLACES)
def test_flat_punch(r, z):
    given = punch.flat_punch_subsurface(r, z, 1.0, force=2.0, poisson=NU, shear=G)
    with mp.workdps(25):
        transform = mp_solutions.punch_transform(mp.mpf(1), mp.mpf(2))
        expected = mp_solutions.hankel_field(transform, mp.mpf(r), mp.mpf(z), mp.mpf(NU), mp.mpf(G), mp.mpf(1))
    compared(given, expected, 1.0)


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize(("r", "z"), PLACES)
def test_hertz(r, z):
    given = hertz.hertz_subsurface(r, z, 1.0, peak_pressure=1.0, poisson=NU, shear=G)
    with mp.workdps(25):
        transform = mp_solutions.hertz_transform(mp.mpf(1), mp.mpf(1))
        expected = mp_solutions.hankel_field(transform, mp.mpf(r), mp.mpf(z), mp.mpf(NU), mp.mpf(G), mp.mpf(1))
    compared(given, expected, 1.0)


def test_flat_punch_number_of_theory():
    given = punch.flat_punch_subsurface(0.6, 0.5, 1.0, force=2.0, poisson=0.3, shear=1.0)
    expected = (-0.111543335814, -0.138748156999, -0.409245048135, -0.0193774365764)
    np.testing.assert_allclose(given[:4], expected, atol=5e-13)


@pytest.mark.parametrize(
    ("poisson", "place", "largest"),
    [
        (0.3, 0.4808644853, 0.310020502),
        (0.0, 0.3819362007, 0.384821111),
        (0.25, 0.464313193, 0.3216784032),
        (0.5, 0.5478684611, 0.2663485631),
    ],
)
def test_largest_shear_stress_of_theory(poisson, place, largest):
    z = place + np.array([-1e-3, 0.0, 1e-3])
    radial, axial = hertz.hertz_axis_stress(z, 1.0, peak_pressure=1.0, poisson=poisson)
    shear = 0.5 * (radial - axial)
    assert shear[1] == pytest.approx(largest, rel=2e-9)
    assert shear[1] > max(shear[0], shear[2])


def test_axis():
    """The field on the axis is the elementary one; scaled by the contact radius and the peak pressure."""
    z = np.array([0.0, 0.1, 0.5, 1.0, 4.0])
    radial, axial = hertz.hertz_axis_stress(z, 0.2, peak_pressure=3.0, poisson=NU)
    field = hertz.hertz_subsurface(0.0, z, 0.2, peak_pressure=3.0, poisson=NU, shear=G)
    np.testing.assert_allclose(field.axial_stress, axial, rtol=1e-11)
    np.testing.assert_allclose(field.radial_stress, radial, rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(field.hoop_stress, radial, rtol=1e-11, atol=1e-13)
    np.testing.assert_array_equal(field.shear_stress, 0.0)
    np.testing.assert_array_equal(field.radial_displacement, 0.0)


def test_surface():
    """At z = 0 the field is the surface's: pressure, surface stresses, displacement and (1-2 nu)/3 at the edge."""
    r = np.array([0.0, 1e-4, 0.3, 0.9, 1.0, 1.1, 3.0])
    modulus = 2.0 * G / (1.0 - NU)
    big = 2.0 * modulus / np.pi  # R with p0 = 1 at a = 1
    field = hertz.hertz_subsurface(r, 0.0, 1.0, peak_pressure=1.0, poisson=NU, shear=G)
    radial, hoop = hertz.hertz_surface_stress(r, 1.0, peak_pressure=1.0, poisson=NU)
    pressure = hertz.hertz_pressure(r, 1.0, curvature_radius=big, modulus=modulus)
    sunk = hertz.hertz_displacement(r, 1.0, curvature_radius=big)
    np.testing.assert_allclose(field.axial_stress, -pressure, atol=1e-15)
    np.testing.assert_allclose(field.radial_stress, radial, atol=1e-14)
    np.testing.assert_allclose(field.hoop_stress, hoop, atol=1e-14)
    np.testing.assert_allclose(field.axial_displacement, sunk, rtol=1e-13)
    np.testing.assert_array_equal(field.shear_stress, 0.0)
    assert radial[4] == pytest.approx((1.0 - 2.0 * NU) / 3.0, rel=1e-15)
    # Johnson (3.41b, 3.42b): the surface is drawn inward
    swallowed = (1.0 - np.sqrt(np.maximum(1.0 - r[1:] ** 2, 0.0)) ** 3) / r[1:]
    drawn = -(1.0 - 2.0 * NU) / (6.0 * G) * swallowed
    np.testing.assert_allclose(field.radial_displacement[1:], drawn, rtol=1e-7)


def test_equilibrium():
    """Div sigma = 0 in both directions, by differences of the closed forms."""
    r, z, h = 0.7, 0.4, 1e-4
    for field in (
        lambda r, z: hertz.hertz_subsurface(r, z, 1.0, peak_pressure=1.0, poisson=NU, shear=G),
        lambda r, z: punch.flat_punch_subsurface(r, z, 1.0, force=1.0, poisson=NU, shear=G),
    ):
        east, west, north, south, here = field(r + h, z), field(r - h, z), field(r, z + h), field(r, z - h), field(r, z)
        radial = (
            (east.radial_stress - west.radial_stress) / (2 * h)
            + (north.shear_stress - south.shear_stress) / (2 * h)
            + (here.radial_stress - here.hoop_stress) / r
        )
        axial = (
            (east.shear_stress - west.shear_stress) / (2 * h)
            + (north.axial_stress - south.axial_stress) / (2 * h)
            + here.shear_stress / r
        )
        assert abs(radial) < 1e-7
        assert abs(axial) < 1e-7
