"""Onset of yield of a contact that slides on layers: waves of the test summed over directions, and closed limits."""

import numpy as np
import pytest
from layer_waves import _plane
from layer_waves import base as decaying
from scipy.linalg import expm
from scipy.optimize import minimize_scalar
from scipy.special import j0
from sliding_ball import mises, on_the_surface, point_loads

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.media.interior import shear_field
from winkler.profiles.ellipse import CurvedBodies

E, R, Y, H, A = 210e9, 1e-2, 1e9, 5e-5, 1e-4
LAYERS = ((E / 2.6, 0.3, H), (E / 8.4, 0.4, 0.6 * H))
BASE = (E / 4.6, 0.15)
GAUSS = np.polynomial.legendre.leggauss(40)


def solid(shear, poisson, strength=np.inf):
    return wk.Elastic(2.0 * shear * (1.0 + poisson), poisson, strength=strength)


def pressed(medium, a=A):
    bed = wk.Foundation(wk.Paraboloid(R), medium)
    return PressedSprings(bed, float(bed.gap(np.array([a]))[0]), a)


def stack(base=BASE):
    layers = [wk.Layer(solid(shear, poisson), thickness) for shear, poisson, thickness in LAYERS]
    return wk.CoatedHalfSpace(layers, on=solid(*base) if base else wk.Rigid())


def tensor(field):
    xy, xz, yz = field.xy_stress, field.xz_stress, field.yz_stress
    return np.array([[field.xx_stress, xy, xz], [xy, field.yy_stress, yz], [xz, yz, field.zz_stress]])


def waves_at(above, here, below, base, xi):
    """Amplitudes of waves along (U, W, T, S) and across (V, Q), per traction of -1 along the surface."""
    fields = decaying(base)
    across = np.array([0.0, 1.0]) if base is None else np.array([1.0, -base[0]])
    fields = np.broadcast_to(fields, (xi.size, 4, 2))
    across = np.broadcast_to(across[:, None], (xi.size, 2, 1))

    def lifted(fields, across, rows):
        for shear, poisson, thickness in reversed(rows):
            scale = np.array([1.0, 1.0, shear, shear])[:, None]
            length = (xi * thickness)[:, None, None]
            fields = scale * (expm(-_plane(poisson) * length) @ (fields / scale))
            across = expm(-np.array([[0.0, 1.0 / shear], [shear, 0.0]]) * length) @ across
        return fields, across

    here_fields, here_across = lifted(fields, across, [*here, *below])
    top_fields, top_across = lifted(here_fields, here_across, above)
    amplitudes = np.linalg.solve(top_fields[:, 2:], np.array([-1.0, 0.0])[None, :, None] * np.ones((xi.size, 1, 1)))
    return (here_fields @ amplitudes)[..., 0], (here_across / -top_across[:, 1:])[..., 0]


def summed(place, material, along, across, xi, shares, wave):
    """The stress of plane waves in 160 directions, at a place."""
    shear, poisson = material
    n, c = poisson / (1.0 - poisson), 2.0 * shear / (1.0 - poisson)
    u, _, t, s = along.T
    v, q = across.T
    result = np.zeros((3, 3))
    for angle in 2.0 * np.pi * (np.arange(160) + 0.5) / 160:
        cos, sin = np.cos(angle), np.sin(angle)
        phase = np.exp(1j * xi * (place[0] * cos + place[1] * sin)) * shares * xi * wave / 160
        ss, tt, zz = (np.sum(1j * part * cos * phase).real for part in (n * s + c * u, n * s + (c - 2 * shear) * u, s))
        st, sz, tz = np.sum(-1j * shear * v * sin * phase), np.sum(t * cos * phase), np.sum(-q * sin * phase)
        own = np.array([[ss, st.real, sz.real], [st.real, tt, tz.real], [sz.real, tz.real, zz]])
        turn = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
        result += turn @ own @ turn.T
    return result


@pytest.mark.parametrize(
    ("place", "base"),
    [((0.4 * A, 0.3 * A, 0.8 * H), BASE), ((-0.6 * A, 0.2 * A, 1.3 * H), None), ((0.5 * A, -0.4 * A, 2.0 * H), BASE)],
)
def test_stresses_of_a_traction_are_those_of_plane_waves_in_all_directions(place, base):
    medium, z = stack(base), place[2]
    springs = pressed(medium)
    angle, area = 0.25 * np.pi * (GAUSS[0] + 1.0), 0.25 * np.pi * GAUSS[1]
    r = A * np.sin(angle)
    load = area * A * np.cos(angle) * r * medium.pressure(springs, r)
    cuts = np.concatenate([[0.0], np.geomspace(0.02, 1.0, 6), np.arange(2.0, 34.0)]) / z
    xi = (cuts[:-1, None] + 0.5 * np.diff(cuts)[:, None] * (GAUSS[0] + 1.0)).ravel()
    shares = (0.5 * np.diff(cuts)[:, None] * GAUSS[1]).ravel()
    above, here, below, top = [], [], [], 0.0
    for shear, poisson, thickness in LAYERS:
        low, deep = min(max(z - top, 0.0), thickness), thickness
        above += [(shear, poisson, low)] if low > 0.0 else []
        here += [(shear, poisson, deep - low)] if low < deep else []
        top += thickness
    above += [(*BASE, z - top)] if z > top else []
    material = (here[0] if here else BASE)[:2]
    along, across = waves_at(above, here, below, base, xi)
    wanted = summed(place, material, along, across, xi, shares, j0(np.outer(xi, r)) @ load)
    found = tensor(medium.dragged_interior(springs, *(np.array([x]) for x in place), below=True))[..., 0]
    np.testing.assert_allclose(found, wanted, atol=1e-7 * np.max(np.abs(wanted)))


def test_stresses_are_in_equilibrium_and_obey_hooke_and_the_traction():
    """Derivatives of fourth order, in each layer and the base; at the surface the traction is the pressure."""
    medium, step = stack(), 2e-7
    springs = pressed(medium)
    near = np.array([k * row for row in np.eye(3) for k in (1.0, -1.0, 2.0, -2.0)] + [np.zeros(3)]) * step
    for x, y, z, material in ((0.3, 0.2, 0.4, LAYERS[0]), (0.3, 0.2, 1.4, LAYERS[1]), (-1.0, 0.2, 2.4, BASE)):
        field = medium.dragged_interior(springs, *(np.array([x, y, z]) * H + near).T, below=True)
        stress, moved = tensor(field), np.array([field.x_displacement, field.y_displacement, field.z_displacement])

        def slope(values, axis):
            one, minus, two, back = np.moveaxis(values, -1, 0)[4 * axis : 4 * axis + 4]
            return (8.0 * (one - minus) - (two - back)) / (12.0 * step)

        slopes = [slope(stress[:, axis], axis) for axis in range(3)]
        np.testing.assert_allclose(sum(slopes), 0.0, atol=1e-9 * np.max(np.abs(slopes)))
        strain = np.array([slope(moved, axis) for axis in range(3)])
        strain, (shear, poisson) = 0.5 * (strain + strain.T), material[:2]
        hooke = 2.0 * shear * (strain + poisson / (1.0 - 2.0 * poisson) * np.trace(strain) * np.eye(3))
        np.testing.assert_allclose(hooke, stress[..., -1], atol=1e-9 * np.max(np.abs(hooke)))
    x = np.array([0.0, 0.5, -0.9]) * A
    on = tensor(medium.dragged_interior(springs, x, 0.1 * x, 0.0 * x, below=True))
    wanted = np.array([-medium.pressure(springs, np.hypot(x, 0.1 * x)), 0.0 * x, 0.0 * x])
    np.testing.assert_allclose(on[2], wanted, atol=1e-11 * np.max(np.abs(wanted)))


@pytest.mark.slow
def test_layers_of_one_solid_slide_as_a_half_space():
    """Where the surface yields first, by Hertz' and Johnson's closed forms of it."""
    steel = wk.Elastic(E, 0.3, strength=Y)
    bed = wk.Foundation(wk.Paraboloid(R), wk.CoatedHalfSpace([wk.Layer(steel, H)], on=wk.Elastic(E, 0.3)))
    found = wk.YieldOnset(bed, wk.Coulomb(0.5)).solve()
    p0 = Y / on_the_surface(0.5, 0.3)
    modulus = E / (1.0 - 0.3**2)
    assert found.force == pytest.approx(np.pi**3 * R**2 * p0**3 / (6.0 * modulus**2), rel=1e-6)
    assert (found.z, found.r) == (0.0, -found.x)
    assert found.x < 0.0
    assert [note.assumption for note in found.validity].count(wk.Assumption.UNCOUPLED) == 1


@pytest.mark.slow
def test_the_onset_below_the_surface_is_that_of_the_ellipse():
    steel, slides = wk.Elastic(E, 0.3, strength=Y), wk.Coulomb(0.1)
    ellipse = wk.EllipticYieldOnset(CurvedBodies(R, R), wk.HalfSpace(steel), slides).solve()
    plain = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace(steel)), slides).solve()
    coated = wk.CoatedHalfSpace([wk.Layer(steel, 2.0 * H)], on=steel)
    found = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), coated), slides).solve()
    assert plain.force == pytest.approx(ellipse.force, rel=1e-10)
    assert found.force == pytest.approx(ellipse.force, rel=1e-9)
    assert (found.x, found.z) == (pytest.approx(ellipse.x, abs=1e-9), pytest.approx(ellipse.z, rel=1e-5))


@pytest.mark.slow
def test_a_base_far_below_a_narrow_contact_yields_off_the_axis():
    """Several contact radii beside the middle: by point loads on the disc, in the plane of the interface."""
    thick, mu, p0 = 30.0 * A, 0.5, 2.0 * E / (1.0 - 0.3**2) * A / (np.pi * R)
    most = minimize_scalar(lambda x: -point_loads(mu, 0.3, x, 30.0), (3.0, 5.0, 7.0), tol=1e-9)
    base, layer = wk.Elastic(E, 0.3, strength=-most.fun * p0), wk.Elastic(E, 0.3)
    bed = wk.Foundation(wk.Paraboloid(R), wk.CoatedHalfSpace([wk.Layer(layer, thick)], on=base))
    found = wk.YieldOnset(bed, wk.Coulomb(mu)).solve()
    assert found.radius == pytest.approx(A, rel=1e-7)
    assert (found.x, found.z) == (pytest.approx(most.x * A, rel=1e-3), pytest.approx(thick, rel=1e-6))


def test_the_surface_of_the_second_body_yields():
    """Where its depth is -0.0."""
    weak = wk.Elastic(E, 0.3, strength=Y)
    for first in (wk.Elastic(E, 0.3), wk.Elastic(E, 0.3, strength=3.0 * Y)):
        bed = wk.Foundation(wk.Paraboloid(R), wk.HalfSpace(first, weak))
        found = wk.YieldOnset(bed, wk.Coulomb(0.5)).solve()
        assert found.z == 0.0
        assert found.validity[-1].statement.startswith("Yielding begins in the second body, ")


def test_stresses_in_layers_of_one_solid_are_those_of_a_half_space():
    steel = wk.Elastic(E, 0.3)
    coated = wk.CoatedHalfSpace([wk.Layer(steel, H), wk.Layer(steel, 0.6 * H)], on=steel)
    plain, a = wk.HalfSpace(steel), A
    x, y, z = np.array([[0.0, 0.3, -0.5, 1.1, 0.2], [0.0, 0.1, 0.4, 0.2, 0.7], [0.2, 0.4, 0.6, 0.9, 1.5]]) * a
    found = coated.dragged_interior(pressed(coated), x, y, z, below=True)
    wanted = shear_field.field(pressed(plain), x, y, z, modulus=plain.modulus, poisson=0.3, shear=steel.shear)
    for one, other in zip(found, wanted, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-12 * np.max(np.abs(other)))


@pytest.mark.long
def test_no_place_of_the_layers_is_stressed_more_than_the_one_that_yields():
    """A hard layer dragged over a softer base: sampled on both sides of the plane of sliding, and off it."""
    hard, soft = wk.Elastic(2.0 * E, 0.25, strength=3.0 * Y), wk.Elastic(E, 0.3, strength=Y)
    medium = wk.CoatedHalfSpace([wk.Layer(hard, H)], on=soft)
    found = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), medium), wk.Coulomb(0.4)).solve()
    a, springs = found.radius, pressed(medium, found.radius)
    x, y, z = (part.ravel() for part in np.meshgrid(
        np.linspace(-1.3, 1.3, 21) * a, np.linspace(0.0, 1.2, 5) * a, np.array([0.0, 0.5, 1.0, 1.0001, 2.0, 3.0]) * H
    ))  # fmt: skip
    r = np.hypot(x, y)
    along = medium.dragged_interior(springs, x, y, z, below=True)
    across = medium.interior(springs, r, z, below=True)
    c, s = np.where(r > 0.0, x / np.maximum(r, 1e-12), 1.0), y / np.maximum(r, 1e-12)
    rr, tt, rz = across.radial_stress, across.hoop_stress, across.shear_stress
    stress = mises(
        rr * c * c + tt * s * s + 0.4 * along.xx_stress, rr * s * s + tt * c * c + 0.4 * along.yy_stress,
        across.axial_stress + 0.4 * along.zz_stress, (rr - tt) * s * c + 0.4 * along.xy_stress,
        rz * c + 0.4 * along.xz_stress, rz * s + 0.4 * along.yz_stress,
    )  # fmt: skip
    share = stress / np.where(z <= H, 3.0 * Y, Y)
    assert np.nanmax(share) <= 1.0 + 1e-9
    assert np.nanmax(share) > 0.95


def test_a_traction_shears_the_axis_alone():
    """So that von Mises' stress on the axis moves with the square of friction, and little friction changes little."""
    medium = stack()
    springs, zero = pressed(medium), np.zeros(1)
    along = medium.dragged_interior(springs, zero, zero, np.array([0.7 * H]), below=True)
    for stress in (along.xx_stress, along.yy_stress, along.zz_stress, along.xy_stress, along.yz_stress):
        assert abs(stress[0]) <= 1e-12 * abs(along.xz_stress[0])
