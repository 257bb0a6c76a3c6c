"""Stresses inside coatings: Hooke and equilibrium by differences, continuity at interfaces, known special cases."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.materials.layered import Layer
from winkler.media.layered.coated import CoatedHalfSpace

LAYERS = ((20.0, 0.2, 0.3), (0.5, 0.5, 0.2), (5.0, 0.3, 0.4))
SOLIDS = [wk.Elastic(young, nu) for young, nu, _ in LAYERS] + [wk.Elastic(1.0, 0.3)]
STACK = CoatedHalfSpace(
    [Layer(solid, h) for solid, (_, _, h) in zip(SOLIDS, LAYERS, strict=False)],
    on=SOLIDS[-1],
    second=wk.Elastic(8.0, 0.25),
)
INTERFACES = (0.3, 0.5, 0.9)
PARTS = ("radial_stress", "hoop_stress", "axial_stress", "shear_stress", "radial_displacement", "axial_displacement")


@pytest.fixture(scope="module")
def contact():
    return wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), STACK), wk.Radius(0.8)).solve()


@pytest.mark.parametrize(
    ("r", "z", "index"), [(0.5, 0.01, 0), (0.7, 0.15, 0), (0.9, 0.29, 0), (0.4, 0.4, 1), (1.2, 0.7, 2), (0.3, 1.5, 3)]
)
def test_equilibrium_and_hooke(contact, r, z, index):
    h = 1e-3
    step = h * np.arange(-2, 3)
    stencil = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / (12.0 * h)
    across, along, here = (wk.restore(contact, *place) for place in ((r + step, z), (r, z + step), (r, z)))
    size = float(here.von_mises)

    def rate(field, name):
        return float(stencil @ getattr(field, name))

    s_r, s_t, s_z, tau = (float(getattr(here, name)) for name in PARTS[:4])
    assert abs(rate(across, "radial_stress") + rate(along, "shear_stress") + (s_r - s_t) / r) < 1e-7 * size
    assert abs(rate(across, "shear_stress") + rate(along, "axial_stress") + tau / r) < 1e-7 * size
    solid = SOLIDS[index]
    strains = {
        "radial": rate(across, "radial_displacement"),
        "hoop": float(here.radial_displacement) / r,
        "axial": rate(along, "axial_displacement"),
    }
    nu, young = solid.poisson, solid.young
    assert strains["radial"] == pytest.approx((s_r - nu * (s_t + s_z)) / young, abs=1e-8)
    assert strains["hoop"] == pytest.approx((s_t - nu * (s_r + s_z)) / young, abs=1e-8)
    assert strains["axial"] == pytest.approx((s_z - nu * (s_r + s_t)) / young, abs=1e-8)
    shear = rate(along, "radial_displacement") + rate(across, "axial_displacement")
    assert shear == pytest.approx(tau / solid.shear, abs=1e-7)


@pytest.mark.parametrize("depth", INTERFACES)
def test_bonded_interfaces(contact, depth):
    r = np.array([0.0, 0.3, 0.8, 2.0])
    above, below = (wk.restore(contact, r, z) for z in (depth, np.nextafter(depth, 1.0)))
    for name in PARTS[2:]:
        np.testing.assert_allclose(getattr(above, name), getattr(below, name), rtol=0, atol=1e-10)
    assert np.max(np.abs(above.radial_stress - below.radial_stress)) > 0.1


def test_the_surface_is_met(contact):
    r = np.array([0.0, 0.2, 0.6, 0.79])
    outside = np.array([0.9, 1.7])
    surface, inside = wk.restore(contact, r), wk.restore(contact, r, 0.0)
    np.testing.assert_allclose(-inside.axial_stress, surface.pressure, rtol=1e-8)
    np.testing.assert_allclose(inside.shear_stress, 0.0, atol=1e-10)
    free = wk.restore(contact, outside, 0.0)
    np.testing.assert_allclose(free.axial_stress, 0.0, atol=1e-9)
    # both bodies together move as the surface does
    other = wk.restore(contact, r, -1e-300)
    moved = inside.axial_displacement + other.axial_displacement
    np.testing.assert_allclose(moved, surface.displacement, rtol=1e-8)


def test_any_plane_carries_the_force(contact):
    s, w = np.polynomial.legendre.leggauss(60)
    for depth in (0.2, 0.6, 2.0):
        # r = tan: the stress falls with the fifth power of the distance
        angle = 0.25 * np.pi * (s + 1.0)
        r, dr = np.tan(angle), 0.25 * np.pi * w / np.cos(angle) ** 2
        near = r < 60.0
        stress = wk.restore(contact, r[near], depth).axial_stress
        assert -np.sum(2 * np.pi * r[near] * dr[near] * stress) == pytest.approx(contact.force, rel=2e-3)


def test_a_film_does_not_slide_on_its_rigid_base():
    film = CoatedHalfSpace([Layer(wk.Elastic(1.0, 0.45), 1.0)], on=wk.Rigid())
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), film), wk.Radius(3.0)).solve()
    base = wk.restore(contact, [0.0, 1.0, 2.9, 5.0], 1.0)
    np.testing.assert_allclose(base.axial_displacement, 0.0, atol=1e-9)
    np.testing.assert_allclose(base.radial_displacement, 0.0, atol=1e-9)
    with pytest.raises(wk.OutsideValidity, match="rigid base"):
        wk.restore(contact, 0.0, 1.1)
    with pytest.raises(wk.OutsideValidity, match="second body"):
        wk.restore(contact, 0.0, -0.1)
