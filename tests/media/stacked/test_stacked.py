"""Stacks whose layers slide on each other, or are transversely isotropic: by another route, and in closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sliding_waves import sliding_film_response
from stack_waves import surface

import winkler as wk
from winkler.media.layered.coated_interior import wave_states
from winkler.media.layered.pair_response import Mode, PairResponse
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import constants_of
from winkler.problems.rough.compliance import compliance_of
from winkler.values.errors import InvalidInput, OutsideValidity

QUARTZ_LIKE = wk.TransverselyIsotropic(162e9, 92e9, 69e9, 181e9, 35e9)
WEAVE = wk.TransverselyIsotropic(1e9, 0.2e9, 0.3e9, 1.2e9, 0.6e9)
"""Whose exponents are a complex pair."""
FIBRES = wk.TransverselyIsotropic(14e9, 7e9, 6e9, 160e9, 7e9)
GLASS, GEL, SOFT = wk.Elastic(70e9, 0.2), wk.Elastic(1e6, 0.49), wk.Elastic(1e3, 0.49999)
WAVES = np.array([1e-3, 0.9, 5.0])


def stack(parts, on, **others):
    return wk.StackedHalfSpace([wk.StackLayer(*part) for part in parts], on, **others)


STACKS = {
    "distinct and complex exponents on glass": ([(QUARTZ_LIKE, 1.0, True), (WEAVE, 0.5, True)], GLASS),
    "complex on fibres": ([(WEAVE, 1.0, True)], FIBRES),
    "sliding on a bonded one": ([(QUARTZ_LIKE, 1.0, False), (WEAVE, 0.5, True)], GLASS),
    "both slide, on a rigid base": ([(WEAVE, 1.0, False), (FIBRES, 0.5, False)], wk.Rigid()),
    "a cover slip on gel": ([(GLASS, 0.1, False)], GEL),
    "a plate, gel that slides on a plate": ([(GLASS, 0.1, True), (GEL, 0.3, False), (GLASS, 1.0, True)], GEL),
    "slides in the middle": ([(FIBRES, 0.2, True), (WEAVE, 0.5, False), (GLASS, 0.7, True)], QUARTZ_LIKE),
    "a stiff plate on a thin soft film": ([(GLASS, 0.5, True), (SOFT, 0.1, True)], wk.Rigid()),
    "bonded, and slides on a rigid base": ([(GLASS, 1.0, True), (GEL, 0.3, False)], wk.Rigid()),
}


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("name", STACKS)
def test_compliances_are_those_of_elasticity(name):
    """Navier's equations, carried through the stack by matrix exponentials of a hundred digits and more."""
    parts, on = STACKS[name]
    layers = tuple(wk.StackLayer(*part) for part in parts)
    normal = PairResponse(Mode.NORMAL, StackBody(layers, on))
    wanted = [surface(wave, parts, on)[1] for wave in WAVES]
    assert 2.0 * normal.whole(WAVES) / normal.modulus == pytest.approx(wanted, rel=1e-12)
    if all(bonded for _, _, bonded in parts):
        along = PairResponse(Mode.ALONG, StackBody(layers, on))
        wanted = [surface(wave, parts, on, load=(-1, 0))[0] for wave in WAVES]
        assert 2.0 * (1.0 + along.excess(WAVES)) / along.modulus == pytest.approx(wanted, rel=1e-12)


def test_the_exponents_of_these_solids_are_of_all_kinds():
    splits = [constants_of(solid).split for solid in (QUARTZ_LIKE, FIBRES, GLASS, WEAVE)]
    assert splits[0] > 0.1
    assert splits[1] > 0.1
    assert splits[2] == 0.0
    assert splits[3] < -0.1


@pytest.mark.parametrize("nearly", [0.0, 1e-13, 1e-9, -1e-9, 1e-5])
def test_nearly_isotropic_constants_are_no_special_case(nearly):
    """c44 close to that of the isotropic solid: exponents nearly equal, real or complex; stacks move in proportion."""
    young, nu = 2.0, 0.3
    lame, shear = young * nu / (1.3 * 0.4), young / 2.6
    solid = wk.TransverselyIsotropic(lame + 2 * shear, lame, lame, lame + 2 * shear, shear * (1.0 + nearly))
    base = wk.Elastic(0.1, 0.4)
    found = PairResponse(Mode.NORMAL, StackBody((wk.StackLayer(solid, 0.7),), base)).whole(WAVES)
    isotropic = PairResponse(Mode.NORMAL, StackBody((wk.Layer(wk.Elastic(young, nu), 0.7),), base)).whole(WAVES)
    assert found == pytest.approx(isotropic, rel=1e-12 + 2.0 * abs(nearly))
    if nearly == -1e-9:
        away = [PairResponse(Mode.NORMAL, StackBody((wk.StackLayer(solid, 0.7, False),), base)).whole(WAVES)]
        assert np.all(np.isfinite(away))


def test_bonded_isotropic_layers_are_a_coated_half_space():
    parts, on, second = [(wk.Elastic(3.0, 0.5), 0.3), (wk.Elastic(0.2, 0.1), 1.0)], wk.Elastic(1.0, 0.4), GEL
    coated = wk.CoatedHalfSpace([wk.Layer(*part) for part in parts], on, second)
    stacked = wk.StackedHalfSpace([wk.StackLayer(*part) for part in parts], on, second)
    xi = np.geomspace(1e-3, 30.0, 60)
    for name in ("response", "along_response", "across_response", "tangential_response"):
        one, other = getattr(coated, name), getattr(stacked, name)
        assert other.modulus == pytest.approx(one.modulus, rel=1e-14)
        np.testing.assert_allclose(other.excess(xi), one.excess(xi), rtol=0.0, atol=1e-13)
    radius = np.array([0.4])
    for name in ("punch_stiffness", "punch_torsional_stiffness"):
        assert getattr(stacked, name)(radius) == pytest.approx(getattr(coated, name)(radius), rel=1e-12)


@pytest.mark.few(1)
@pytest.mark.parametrize("solid", [QUARTZ_LIKE, WEAVE, FIBRES])
def test_a_layer_on_its_own_solid_is_the_half_space_of_elliott(solid):
    medium = stack([(solid, 1.0, True)], on=solid, second=GLASS)
    half_space = wk.TransverselyIsotropicHalfSpace.between(solid, GLASS)
    for name in ("modulus", "shear_modulus", "torsional_modulus"):
        assert getattr(medium, name) == pytest.approx(getattr(half_space, name), rel=1e-14)
    a = np.array([1.0])
    assert medium.punch_stiffness(a) == pytest.approx(2.0 * half_space.modulus * a, rel=1e-13)
    assert medium.punch_shear_stiffness(a) == pytest.approx(2.0 * half_space.shear_modulus * a, rel=1e-13)
    assert medium.punch_torsional_stiffness(a) == pytest.approx(
        16.0 / 3.0 * half_space.torsional_modulus * a**3, rel=1e-13
    )


def test_a_twist_meets_layers_of_another_thickness():
    """Waves across the depth: sqrt(C44 C66) is the modulus, sqrt(C66/C44) stretches the depth."""
    stretch, shear = math.sqrt(3.5 / 7.0), math.sqrt(3.5e9 * 7e9)
    a = np.array([0.3, 1.0, 4.0])
    found = stack([(FIBRES, 1.0, True)], on=wk.Rigid()).punch_torsional_stiffness(a)
    alike = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.0 * shear, 0.0), stretch)], on=wk.Rigid())
    assert found == pytest.approx(alike.punch_torsional_stiffness(a), rel=1e-12)


@pytest.mark.parametrize("nu", [0.5, 0.3, -0.2])
@pytest.mark.parametrize("softer", [0.0, 1.0, 1e-3, 1e3])
def test_one_sliding_layer_has_the_closed_form(nu, softer):
    """Also a half-space cut at the depth of the layer: equal solids, softer = 1."""
    solid = wk.Elastic(1.0 - nu**2, nu)
    on = wk.Elastic(1.0 / softer, 0.0) if softer else wk.Rigid()
    xi = np.array([1e-5, 0.01, 0.3, 0.99, 1.01, 5.0, 20.0])
    found = PairResponse(Mode.NORMAL, StackBody((wk.StackLayer(solid, 1.0, bonded=False),), on)).whole(xi)
    assert found == pytest.approx(sliding_film_response(xi, softer), rel=1e-12)


def test_a_thin_stiff_layer_that_slides_is_a_plate_on_a_half_space():
    """Hogg (1938): 1/k = 2 / (3^(3/2) E* l), l^3 = 2 D / E*, of a force on a plate; no shear reaches the base."""

    def excess(h: float) -> float:
        plate = wk.Elastic(6.0 / h**3 * 0.91, 0.3)
        medium = stack([(plate, h, False)], on=wk.Elastic(1.0, 0.0))
        return float(medium.punch_stiffness(np.array(h))) / (1.5 * math.sqrt(3.0)) - 1.0

    errors = [excess(h) for h in (0.05, 0.025, 0.0125)]
    assert 0.0 < errors[2] < 4e-4
    assert 2.9 < errors[1] / errors[2] < errors[0] / errors[1] + 0.1 < 4.0


def test_layers_that_are_free_sideways_yield_more():
    """The limit of long waves on a rigid base: by elasticity, and for a laminate that slides as a whole."""
    parts = [(QUARTZ_LIKE, 1.0, True), (GLASS, 0.5, False), (WEAVE, 0.3, True)]
    response = PairResponse(Mode.NORMAL, StackBody(tuple(wk.StackLayer(*part) for part in parts), wk.Rigid()))
    limit = surface(1e-12, parts, wk.Rigid())[1] / 1e-12
    assert 2.0 * response.compressed / response.modulus == pytest.approx(limit, rel=1e-10)
    assert response.whole(np.array([1e-9]))[0] * 1e9 == pytest.approx(response.compressed, rel=1e-8)


def test_stresses_inside_by_elasticity_in_one_wave():
    """Below a sliding interface shear is zero, the lateral displacement jumps; amplitudes by matrix exponentials."""
    parts, on = [(GLASS, 1.0, False), (WEAVE, 0.5, True)], QUARTZ_LIKE
    layers = tuple(wk.StackLayer(*part) for part in parts)
    depths = np.array([0.4, 1.0, 1.2, 1.5])
    for wave in (0.2, 2.0):
        _, _, states = surface(wave, parts, on, depths=depths.tolist())
        own = constants_of(GLASS).decay(np.array([wave * 0.4]))
        found = list(wave_states(StackBody(layers, on), depths, np.array([wave])))
        for (_, state, _), wanted in zip(found[2:], states[2:], strict=True):
            assert np.concatenate([state.moved[0], state.loaded[0]]) == pytest.approx(wanted, rel=1e-10)
        # in the uppermost layer without what a half-space of it has
        loaded = found[0][1].loaded[0] + np.array([-own[1][0], -own[3][0]])
        assert loaded == pytest.approx(states[0][2:], rel=1e-10)


def ball_on_sliding_stack():
    medium = stack([(wk.Elastic(3.0, 0.3), 1.0, False), (wk.Elastic(1.0, 0.4), 0.5, True)], on=wk.Elastic(2.0, 0.3))
    return wk.Indentation(wk.Foundation(wk.Paraboloid(2.0), medium), wk.Radius(1.0)).solve()


def test_no_shear_passes_an_interface_that_slides():
    solution, places = ball_on_sliding_stack(), np.array([0.3, 1.0, 2.0])
    above, below = (wk.restore(solution, places, np.full(3, z)) for z in (1.0, 1.0 + 1e-9))
    for fields in (above, below):
        assert np.max(np.abs(fields.shear_stress)) < 1e-7 * np.max(np.abs(fields.axial_stress))
    assert below.axial_stress == pytest.approx(above.axial_stress, rel=1e-6)
    assert below.axial_displacement == pytest.approx(above.axial_displacement, rel=1e-6)
    assert np.max(np.abs(below.radial_displacement - above.radial_displacement)) > 0.01 * above.axial_displacement[0]


@pytest.mark.slow
def test_the_force_passes_through_each_plane():
    solution = ball_on_sliding_stack()
    nodes, weights = np.polynomial.legendre.leggauss(12)
    edges = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0])
    r = (0.5 * (edges[1:] + edges[:-1])[:, None] + 0.5 * np.diff(edges)[:, None] * nodes).ravel()
    share = (0.5 * np.diff(edges)[:, None] * weights).ravel()
    for z in (0.5, 1.3):
        stress = wk.restore(solution, r, np.full(r.shape, z)).axial_stress
        assert float(share @ (-2.0 * np.pi * r * stress)) == pytest.approx(float(solution.force), rel=1e-2)


def test_what_is_not_known_is_refused_by_name():
    slides = stack([(QUARTZ_LIKE, 1.0, True), (GLASS, 1.0, False)], on=GLASS)
    with pytest.raises(OutsideValidity, match="StackedHalfSpace: layer 2 slides on its base"):
        slides.punch_shear_stiffness(np.array([1.0]))
    with pytest.raises(OutsideValidity, match="layer 2 slides"):
        slides.tangential_stiffness(np.array([1.0]))
    with pytest.raises(InvalidInput, match="list of at least one Layer or StackLayer"):
        wk.StackedHalfSpace([], on=GLASS)
    pressed = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), slides), wk.Radius(0.5)).solve()
    bonded = stack([(QUARTZ_LIKE, 1.0, True)], on=GLASS)
    with pytest.raises(OutsideValidity, match=r"lies in a transversely isotropic uppermost layer"):
        bonded.dragged_interior(pressed.pressed, *np.array([[0.1], [0.0], [0.5]]), below=True)
    assert np.isfinite(wk.restore(pressed, np.array([0.1]), np.array([1.5])).axial_stress).all()


def test_a_height_map_presses_on_a_sliding_stack():
    """A ball as a map: its force is that of the springs, but for an error of second order in the pixel."""
    medium = stack([(WEAVE, 0.1, False), (WEAVE, 0.1, True)], on=wk.Elastic(3e9, 0.3))
    line = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), medium), wk.Radius(0.3)).solve()
    errors = []
    for count in (24, 48):
        x = (np.arange(count) - (count - 1) / 2) * 0.8 / count
        heights = -0.5 * (x[:, None] ** 2 + x**2)
        depth = float(line.depth) + float(heights.max())
        contact = wk.SurfaceContact(wk.Topography(heights, [0.8, 0.8]), medium, wk.Depth(depth)).solve()
        errors.append(contact.force / line.force - 1.0)
    assert abs(errors[1]) < 5e-4
    assert 3.0 < errors[0] / errors[1] < 6.0
    with pytest.raises(OutsideValidity, match="of a StackedHalfSpace that slides carries no tangential tractions"):
        compliance_of(medium)
