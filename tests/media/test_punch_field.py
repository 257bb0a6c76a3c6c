"""The field of one flat punch: closed forms at 40 digits, everywhere a naive formula loses them."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from winkler.media.punch_field import Potentials, combine, punch_below, punch_surface


def exact(r: float, z: float, t: float) -> Potentials:
    """The formulas of theory 1.2 as they stand, at 60 digits."""
    with mp.workdps(60):
        r, z, t = mp.mpf(r), mp.mpf(z), mp.mpf(t)
        big_z = mp.mpc(z, t)
        p = mp.sqrt(r * r + big_z * big_z)
        v_z = 2 * mp.im(1 / p)
        on_axis = r == 0
        return Potentials(
            *(
                float(number)
                for number in (
                    2 * mp.im(mp.log(big_z + p)),
                    v_z,
                    -2 * z * mp.im(big_z / p**3),
                    -2 * z * r * mp.im(1 / p**3),
                    2 * z * mp.im(1 / (p * (p + big_z))),
                    t / (t * t + z * z) if on_axis else 2 / r**2 * (t - mp.im(p)),
                )
            )
        )


PLACES = [
    (0.6, 0.5, 1.0),
    (0.0, 0.5, 1.0),
    (1e-9, 0.5, 1.0),  # next to the axis, where t - Im P cancels
    (1e-9, 1e-9, 1.0),  # deep inside a wide punch
    (0.3, 1e-12, 1.0),
    (2.0, 1e-12, 1.0),
    (1.0, 1e-12, 1.0),  # at the edge
    (1.0 + 2.0**-40, 1e-13, 1.0),
    (3e7, 4e7, 1.0),  # far away
    (3.0, 4.0, 1e-9),  # a needle
    (0.0, 1e-12, 1.0),
    (0.8, 0.6, 1.0),
    (np.sqrt(0.5), 0.5, 0.9),
]


@pytest.mark.parametrize("place", PLACES, ids=str)
def test_no_digit_is_lost(place):
    got = punch_below(*(np.array(number) for number in place))
    want = exact(*place)
    assert np.allclose(got.v, want.v, rtol=1e-14, atol=0.0)
    assert np.allclose(got.v_z, want.v_z, rtol=2e-14, atol=0.0)
    assert np.allclose(got.psi_r_by_r, want.psi_r_by_r, rtol=1e-14, atol=0.0)
    # these change sign somewhere: against the size of their own terms
    scale = abs(want.v_z)
    for name in ("z_v_zz", "z_v_rz", "z_v_r_by_r"):
        assert abs(getattr(got, name) - getattr(want, name)) <= 2e-14 * scale


def test_the_axis_is_the_limit_of_its_neighbourhood():
    z, t = np.array([1e-3, 0.2, 5.0]), np.array(1.0)
    axis, near = punch_below(np.zeros(3), z, t), punch_below(np.full(3, 1e-9), z, t)
    for on, beside in zip(axis, near, strict=True):
        assert np.allclose(on, beside, rtol=1e-14, atol=1e-8)
    assert np.allclose(axis.psi_r_by_r, 1.0 / (1.0 + z * z), rtol=1e-15)
    assert np.allclose(axis.z_v_r_by_r, -0.5 * axis.z_v_zz, rtol=1e-13)  # Laplace's equation on the axis


def test_an_exact_difference_helps_next_to_the_edge():
    excess, z = 1e-20, 1e-20  # t - r far below the last digit of r
    got = punch_below(np.array(1.0), np.array(z), np.array(1.0), np.array(excess))
    with mp.workdps(60):
        square = -mp.mpf(excess) * (2 + mp.mpf(excess)) + mp.mpf(z) ** 2 + 2j * mp.mpf(z) * (1 + mp.mpf(excess))
        want = 2 * mp.im(1 / mp.sqrt(square))
    assert np.isclose(got.v_z, float(want), rtol=1e-14)


def test_shapes_broadcast():
    got = punch_below(np.ones((3, 1)), np.ones((1, 4)), np.array(1.0))
    assert {part.shape for part in got} == {(3, 4)}


@pytest.mark.parametrize("r", [0.0, 1e-8, 0.3, 0.999, 1.001, 7.0])
def test_the_surface_is_the_limit_of_the_depth(r):
    on, below = punch_surface(np.array(r), np.array(1.0)), punch_below(np.array(r), np.array(1e-13), np.array(1.0))
    for surface, deep in zip(on, below, strict=True):
        assert np.isclose(surface, deep, rtol=1e-9, atol=1e-7)


def test_the_edge_itself():
    edge = punch_surface(np.array(1.0), np.array(1.0))
    assert edge.v_z == -np.inf
    assert np.isclose(edge.v, np.pi)
    assert np.isclose(edge.psi_r_by_r, 2.0)


def test_published_point_below_a_flat_punch():
    """Theory 1.2: E* d = a = 1, nu = 0.3, r = 0.6, z = 0.5."""
    r, z = np.array(0.6), np.array(0.5)
    got = combine(punch_below(r, z, np.array(1.0)), r, z, modulus=1.0, poisson=0.3, shear=0.35)
    want = (-0.111543335814, -0.138748156999, -0.409245048135, -0.0193774365764)
    assert np.allclose(got[:4], want, rtol=0.0, atol=6e-13)


def test_the_punch_goes_down_by_its_depth():
    """A rigid punch on a half-space with E* = 2 G/(1 - nu): u_z = 1 below it, (2/pi) asin(a/r) beside it."""
    r, z, nu, shear = np.array([0.0, 0.5, 1.0, 1.5, 9.0]), np.zeros(5), 0.2, 3.0
    modulus = 2.0 * shear / (1.0 - nu)
    got = combine(punch_surface(r, np.array(1.0)), r, z, modulus=modulus, poisson=nu, shear=shear)
    assert np.allclose(got.axial_displacement, 2.0 / np.pi * np.arcsin(1.0 / np.maximum(r, 1.0)), rtol=1e-14)
    assert got.radial_displacement[0] == 0.0
    assert np.all(got.radial_displacement[1:] < 0.0)  # the surface of a compressible body is drawn inwards


@pytest.mark.parametrize(("poisson", "hoop"), [(0.3, -np.inf), (-0.2, np.inf), (0.0, None)])
def test_signs_of_the_infinite_stresses_at_the_edge(poisson, hoop):
    r = np.array(1.0)
    got = combine(punch_surface(r, r), r, np.array(0.0), modulus=1.0, poisson=poisson, shear=1.0)
    assert got.axial_stress == -np.inf
    assert got.radial_stress == -np.inf
    assert got.shear_stress == 0.0
    assert np.isfinite(got.axial_displacement)
    if hoop is None:
        assert np.isclose(got.hoop_stress, -1.0 / np.pi)  # -psi_r/r / (2 pi)
    else:
        assert got.hoop_stress == hoop
