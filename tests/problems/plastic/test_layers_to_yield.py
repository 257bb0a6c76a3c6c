"""Layers under the problems of metals that yield: elastic up to first yield, which is named; beyond it nothing."""

import functools
import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.special import gamma

import winkler as wk

RADIUS, MASS, THICKNESS = 5e-3, 4e-3, 20e-6
STEEL = wk.Elastic(210e9, 0.3, 1e9)


def ball(*layers, slides=False):
    kind = wk.SlidingFilm if slides else wk.CoatedHalfSpace
    return wk.Foundation(wk.Paraboloid(RADIUS), kind([wk.Layer(solid, THICKNESS) for solid in layers], on=STEEL))


HARD = wk.Elastic(420e9, 0.25, 4e9)
SOFT = wk.Elastic(70e9, 0.33, 0.3e9)
COATED = {"hard": ball(HARD), "soft": ball(SOFT), "film": ball(HARD, slides=True)}


@functools.cache
def onset(kind):
    return wk.YieldOnset(COATED[kind]).solve()


def test_equal_layers_yield_where_hertz_and_mises_have_it():
    bed = ball(STEEL)
    modulus = 210e9 / 0.91
    z = np.linspace(0.4, 0.56, 160001)
    mises = 1.5 / (1.0 + z**2) - 1.3 * (1.0 - z * np.arctan(1.0 / z))  # Johnson, equation 3.45, over p0
    p0 = 1e9 / mises.max()
    pressed = wk.PlasticIndentation(bed, wk.Force([0.0]))
    assert pressed.yield_force == pytest.approx(math.pi**3 * RADIUS**2 * p0**3 / (6.0 * modulus**2), rel=1e-8)
    velocity = 0.5 * wk.PlasticImpact(bed, MASS, 1.0).yield_velocity
    hit = wk.PlasticImpact(bed, MASS, velocity).solve()
    depth = (15.0 * MASS * velocity**2 / (16.0 * modulus * math.sqrt(RADIUS))) ** 0.4
    assert hit.greatest_depth == pytest.approx(depth, rel=1e-9)
    lasting = math.sqrt(math.pi) * gamma(0.4) / (2.5 * gamma(0.9))
    assert hit.duration == pytest.approx(2.0 * depth / velocity * lasting, rel=1e-9)


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", COATED)
def test_the_path_is_elastic_up_to_first_yield(kind):
    bed, first = COATED[kind], onset(kind)
    force = first.force * np.array([0.1, 0.5, 1.0 - 1e-9, 0.3, 0.0])
    solved = wk.PlasticIndentation(bed, wk.Force(force)).solve()
    elastic = wk.Indentation(bed, wk.Force(force)).solve()
    np.testing.assert_allclose(solved.depth, elastic.depth, rtol=1e-12)
    np.testing.assert_allclose(solved.energy, elastic.energy, rtol=1e-9, atol=1e-20)
    assert not solved.residual_depth.any()
    assert not solved.dissipation.any()
    assert solved.yield_force == first.force
    assert solved.dented == bed
    by_depth = wk.PlasticIndentation(bed, wk.Depth(elastic.depth)).solve()
    np.testing.assert_allclose(by_depth.force, force, rtol=1e-9, atol=1e-12)


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", COATED)
def test_the_first_part_to_yield_is_named_with_its_load(kind):
    bed, first = COATED[kind], onset(kind)
    name = min(first.onsets, key=lambda part: part.force).name
    for beyond in (
        wk.PlasticIndentation(bed, wk.Force([1.0001 * first.force])),
        wk.PlasticIndentation(bed, wk.Depth([1.0001 * first.depth])),
        wk.PlasticImpact(bed, MASS, 1.0001 * wk.PlasticImpact(bed, MASS, 1.0).yield_velocity),
    ):
        with pytest.raises(wk.OutsideValidity, match=f"{first.force:.6g} N, under which yielding begins .{name}"):
            beyond.solve()


@pytest.mark.slow
@pytest.mark.parametrize("kind", COATED)
def test_impacts_below_yield_follow_the_equation_of_motion(kind):
    bed, first = COATED[kind], onset(kind)

    def force(depth):
        return float(wk.Indentation(bed, wk.Depth(depth)).solve().force) if depth > 0.0 else 0.0

    depths = first.depth * np.linspace(0.0, 1.0, 129) ** 2
    forces = np.array([force(depth) for depth in depths])
    stiff = np.polynomial.chebyshev.Chebyshev.fit(np.sqrt(depths), forces, 24)  # smooth over the root of the depth
    work = quad(lambda root: float(stiff(root)) * 2.0 * root, 0.0, math.sqrt(first.depth), epsabs=0.0)[0]
    yields = wk.PlasticImpact(bed, MASS, 1.0).yield_velocity
    assert yields == pytest.approx(math.sqrt(2.0 * work / MASS), rel=1e-6)

    velocity = 0.7 * yields
    hit = wk.PlasticImpact(bed, MASS, velocity).solve()

    def motion(t, state):
        return [state[1], -float(stiff(math.sqrt(max(state[0], 0.0)))) / MASS]

    def parts(t, state):
        return state[0] if t > 0.0 else 1.0

    parts.terminal, parts.direction = True, -1.0
    way = solve_ivp(
        motion, (0.0, 4.0 * first.depth / velocity), [0.0, velocity], "DOP853", events=parts, rtol=1e-9, atol=1e-16
    )
    assert hit.duration == pytest.approx(way.t_events[0][0], rel=1e-5)
    assert -way.y_events[0][0][1] / velocity == pytest.approx(1.0, abs=1e-5)
    assert (hit.restitution, hit.dissipation, hit.residual_depth) == (1.0, 0.0, 0.0)


def test_the_base_and_the_layer_are_felt():
    beds = COATED | {"none": ball(STEEL)}
    force = {name: wk.PlasticIndentation(bed, wk.Force([0.0])).yield_force for name, bed in beds.items()}
    assert force["soft"] < 0.5 * force["none"]
    assert force["hard"] < force["none"]  # the stiff layer draws the load together: steel yields below it
    assert onset("hard").z == pytest.approx(THICKNESS, rel=1e-6)


@pytest.mark.few(1)
@pytest.mark.parametrize("strength", [1e9, 5e9])
def test_a_note_says_up_to_where(strength):
    bed = ball(wk.Elastic(420e9, 0.25, strength))
    pressed = wk.PlasticIndentation(bed, wk.Force([1.0])).solve()
    (note,) = (note for note in pressed.validity if "no dent remains" in note.statement)
    assert f"{pressed.yield_force:.4g} N" in note.statement


def test_dents_in_layers_and_in_bodies_without_one_strength_are_refused():
    wood = wk.TransverselyIsotropic(c11=15e9, c12=5e9, c13=4e9, c33=20e9, c44=4e9)
    across = wk.Foundation(wk.Paraboloid(RADIUS), wk.TransverselyIsotropicHalfSpace(wood))
    for made in (
        lambda bed: wk.DentLimit(bed, 1e-6),
        lambda bed: wk.StrengthFromDent(bed, wk.Force(10.0), wk.Radius(1e-4)),
    ):
        with pytest.raises(wk.InvalidInput, match="strength, modulus and thickness of every"):
            made(COATED["hard"])
    for made in (
        lambda bed: wk.DentLimit(bed, 1e-6),
        lambda bed: wk.PlasticIndentation(bed, wk.Force([1.0])),
        lambda bed: wk.PlasticImpact(bed, MASS, 1.0),
    ):
        with pytest.raises(wk.InvalidInput, match="no single strength"):
            made(across)
    plain = wk.Elastic(1e9, 0.3)
    without = wk.Foundation(wk.Paraboloid(RADIUS), wk.CoatedHalfSpace([wk.Layer(plain, 1e-5)], on=plain))
    with pytest.raises(wk.InvalidInput, match="no body has a strength"):
        wk.PlasticImpact(without, MASS, 1.0)
