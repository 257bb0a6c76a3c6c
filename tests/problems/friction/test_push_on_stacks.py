"""Partial slip on stacks of bonded layers, transversely isotropic ones too, and on bodies graded in depth."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.bed import PressedSprings
from winkler.materials.depth_grading import ExponentialGrading

MU, D, BALL = 0.3, 0.01, wk.Paraboloid(1.0)
WEAVE = wk.TransverselyIsotropic(10.0, 4.0, 3.0, 6.0, 2.0)
GLASS, SOFT = wk.Elastic(2.5, 0.25), wk.Elastic(0.5, 0.4)
HARDER = ExponentialGrading(1.0, 3.0, depth_scale=0.1, poisson=0.3)
PARTS = (0.0, 1.0, -0.6, 0.4, 1.2)


def pushed(medium, parts=PARTS):
    """Push a ball by parts of mu F over the stiffness of a stuck contact."""
    bed = wk.Foundation(BALL, medium)
    contact = wk.Indentation(bed, wk.Depth(D)).solve()
    unit = MU * float(contact.force) / float(medium.punch_shear_stiffness(np.array(float(contact.radius))))
    return wk.Tangential(bed, wk.Coulomb(MU), wk.Path.through(wk.Depth(D), wk.Shift(unit * np.array(parts))))


@functools.cache
def on_grading():
    return pushed(wk.DepthGradedHalfSpace(HARDER)).solve()


@functools.cache
def on_weave():
    return pushed(wk.StackedHalfSpace([wk.StackLayer(WEAVE, 0.04), wk.Layer(GLASS, 0.03)], on=SOFT)).solve()


@pytest.mark.slow
@pytest.mark.parametrize(
    "medium",
    [
        wk.StackedHalfSpace([wk.StackLayer(WEAVE, 0.02), wk.StackLayer(WEAVE, 0.05)], on=WEAVE),
        wk.StackedHalfSpace([wk.Layer(GLASS, 0.02)], on=GLASS),
        pytest.param(
            wk.DepthGradedHalfSpace(ExponentialGrading(1.0, 1.0, depth_scale=0.1, poisson=0.3)), marks=pytest.mark.slow
        ),
    ],
)
def test_alike_all_through_it_is_the_loop_of_cattaneo_and_mindlin(medium):
    """F = mu F_N (1 - (1 - U/U_s)^(3/2)), U_s = mu d E*/G*; later branches are twice as large (Masing)."""
    solution = pushed(medium, (0.0, 0.5, -0.3, 1.0, 2.0)).solve()
    slide = MU * D * medium.modulus / medium.shear_modulus
    move = solution.shift / slide

    def fresh(u):
        return 1.0 - (1.0 - min(u, 1.0)) ** 1.5

    back = fresh(move[1]) - 2.0 * fresh(0.5 * (move[1] - move[2]))
    wanted = [0.0, fresh(move[1]), back, fresh(move[3]), 1.0]
    friction = MU * solution.force[0]
    np.testing.assert_allclose(solution.shear_force / friction, wanted, rtol=0.0, atol=2e-11)
    stuck = (1.0 - move[1]) ** 0.5 * solution.radius[1]
    assert solution.stick_radius[1] == pytest.approx(stuck, rel=1e-8)
    # work of the first branch, 2/5 of the primitive, less what is stored
    area = move[1] - 0.4 * (1.0 - (1.0 - move[1]) ** 2.5)
    assert solution.work[1] == pytest.approx(friction * slide * area, rel=1e-9)


@pytest.mark.slow
def test_isotropic_layers_slip_as_those_of_a_coated_half_space():
    layers = [wk.Layer(GLASS, 0.02), wk.Layer(SOFT, 0.03)]
    coated, stack = (pushed(kind(layers, on=GLASS)).solve() for kind in (wk.CoatedHalfSpace, wk.StackedHalfSpace))
    for name in ("shear_force", "stick_radius", "dissipation", "stored_energy"):
        first, other = getattr(stack, name), getattr(coated, name)
        np.testing.assert_allclose(first, other, rtol=1e-9, atol=1e-9 * np.max(other))
    r = np.linspace(0.01, 1.5, 12) * coated.radius[0]
    np.testing.assert_allclose(stack.at(2).traction(r), coated.at(2).traction(r), rtol=1e-8)
    np.testing.assert_allclose(stack.at(2).slip(r), coated.at(2).slip(r), rtol=0.0, atol=1e-10 * coated.shift[1])
    first, other = (wk.restore_body(each.at(2), 0.02, 0.01, [0.01, 0.03, 0.08]) for each in (stack, coated))
    np.testing.assert_allclose(first.xz_stress, other.xz_stress, rtol=1e-7)


@pytest.mark.slow
def test_a_grading_slips_as_ever_thinner_layers():
    """Layers converge in proportion to the square of their thickness."""
    found = on_grading()
    known = []
    for count in (15, 30, 60):
        depth = np.concatenate([[0.0], np.geomspace(1e-3, 1.4, count)])
        young = 3.0 - 2.0 * np.exp(-0.5 * (depth[1:] + depth[:-1]) / 0.1)
        layers = [wk.Layer(wk.Elastic(e, 0.3), h) for e, h in zip(young, np.diff(depth), strict=True)]
        bed = wk.Foundation(BALL, wk.StackedHalfSpace(layers, on=wk.Elastic(3.0, 0.3)))
        loop = wk.Tangential(bed, wk.Coulomb(MU), found.problem.path).solve()
        known.append(np.append(loop.shear_force[1:], loop.dissipation[-1] / found.shift[1]))
    wanted = np.append(found.shear_force[1:], found.dissipation[-1] / found.shift[1])
    missed = [np.max(np.abs(each / wanted - 1.0)) for each in known]
    order = math.log2(missed[0] / missed[1]), math.log2(missed[1] / missed[2])
    assert min(order) > 1.8
    np.testing.assert_allclose((4.0 * known[2] - known[1]) / 3.0, wanted, rtol=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("solve", [on_weave, pytest.param(on_grading, marks=pytest.mark.slow)])
def test_rings_that_slide_bear_their_own_pressure_and_others_stand(solve):
    solution = solve()
    bed, state, a = solution.problem.bed, solution.at(1), float(solution.radius[1])
    r = a * np.linspace(0.03, 0.98, 40)
    borne = MU * bed.medium.pressure(PressedSprings(bed, D, a), r)
    slides, graded = r > state.stick_radius, solve is on_grading
    assert 5 < np.count_nonzero(slides) < 35
    traction = state.traction(r)
    np.testing.assert_allclose(traction[slides], borne[slides], rtol=3e-4 if graded else 1e-7)
    assert np.all(traction[~slides] < borne[~slides])
    np.testing.assert_allclose(state.slip(r)[~slides], 0.0, atol=1e-9 * state.shift)
    assert np.all(state.slip(r)[slides][1:] > 0.0)
    # tractions make up the force, and all friction slides in the end
    nodes, weights = np.polynomial.legendre.leggauss(60)
    force = 0.0
    for low, high in ((0.0, state.stick_radius), (state.stick_radius, a)):
        y = 0.5 * math.sqrt((high - low) * (high + low)) * (nodes + 1.0)
        place = np.sqrt(np.maximum(high * high - y * y, 0.0))
        force += 2.0 * np.pi * float(np.sum(0.5 * (y[-1] + y[0]) * weights * y * state.traction(place)))
    assert force == pytest.approx(state.shear_force, rel=1e-4 if graded else 1e-6)


@pytest.mark.few(1, slow=1)
@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("solve", [on_weave, on_grading])
def test_no_history_gains_energy(solve, seed):
    solution = solve()
    problem, unit, random = solution.problem, solution.shift[1], np.random.default_rng(seed)
    moves = unit * random.uniform(-1.2, 1.2, 12)
    steady = wk.Path.through(wk.Depth(D), wk.Shift(np.concatenate([[0.0], moves, moves[-1:], moves[:1] * 0.0])))
    depths = np.concatenate([[D], D * random.uniform(0.6, 1.0, 4), [D]])
    varied = wk.Path(np.arange(6.0), wk.Depth(depths), wk.Shift(np.concatenate([[0.0], moves[:4], [0.0]])))
    for path in (steady, varied):
        loop = wk.Tangential(problem.bed, problem.law, path).solve()
        most = np.max(np.abs(loop.work))
        assert np.all(np.diff(loop.dissipation) >= -1e-12 * most)
        missed = loop.work - loop.stored_energy - loop.dissipation
        np.testing.assert_allclose(missed, 0.0, atol=1e-7 * most)
        assert np.all(loop.stored_energy >= -1e-12 * most)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("solve", [on_weave, on_grading])
def test_a_loop_as_by_boundary_elements(solve):
    """Tractions of both directions on 97 x 97 pixels, without rings."""
    rings = solve()
    problem, radius, friction = rings.problem, float(rings.radius[0]), MU * float(rings.force[0])
    topography = wk.SampledProfile([2.6 * radius] * 2, BALL, (97, 97))
    pixels = wk.SurfaceTangential(topography, problem.bed.medium, wk.Coulomb(MU), problem.path).solve()
    missed = np.max(np.abs(pixels.shear_force[:, 0] - rings.shear_force)) / friction
    lost = np.max(np.abs(pixels.dissipation[1:] / rings.dissipation[1:] - 1.0))
    assert missed < 5e-3
    assert lost < 1e-2


@pytest.mark.slow
@pytest.mark.parametrize("solve", [on_weave, pytest.param(on_grading, marks=pytest.mark.slow)])
def test_damping_and_heat_are_those_of_the_loop(solve):
    bed, unit = solve().problem.bed, float(solve().shift[1])
    loop = wk.Tangential(
        bed, wk.Coulomb(MU), wk.Path.through(wk.Depth(D), wk.Shift(unit * np.array([0.0, 1.0, -1.0, 1.0])))
    )
    lost = np.diff(loop.solve().dissipation[[1, 3]])[0]
    swing = wk.FrictionDamping(bed, wk.Coulomb(MU), wk.Depth(D), wk.Shift(unit)).solve()
    assert swing.loss_per_cycle == pytest.approx(lost, rel=1e-10)
    both = wk.BimodalDamping(bed, wk.Coulomb(MU), D, 0.0, unit).solve()
    assert both.loss_per_cycle == pytest.approx(lost, rel=1e-3)
    iron = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
    heat = wk.FrettingHeat(loop, 10.0, wk.HeatConductors(iron, iron)).solve()
    assert heat.loss_per_cycle == pytest.approx(lost, rel=1e-9)
    assert heat.misfit < 1e-4


@pytest.mark.slow
def test_impacts_keep_the_energy():
    bed = on_weave().problem.bed
    thrown = wk.Impact(bed, wk.Coulomb(MU), mass=1.0, velocity=3e-3, lateral_velocity=2e-3, count=21).solve()
    np.testing.assert_allclose(thrown.balance, 1.0, rtol=1e-9)
    assert 0.0 < thrown.lateral_velocity[-1] < 2e-3


def test_what_is_refused():
    path = wk.Path.through(wk.Depth(D), wk.Shift([0.0, 1e-4]))
    sliding = wk.StackedHalfSpace([wk.StackLayer(GLASS, 0.02, False)], on=SOFT)
    with pytest.raises(wk.OutsideValidity, match="layer 1 slides on its base and carries no shear"):
        wk.Tangential(wk.Foundation(BALL, sliding), wk.Coulomb(MU), path)
    power = wk.GradedHalfSpace.between(wk.PowerLawGraded(2.6, 0.5, exponent=0.3, poisson=0.3))
    with pytest.raises(wk.OutsideValidity, match=r"is a GradedHalfSpace.*leave the method out, or give springs"):
        wk.Tangential(wk.Foundation(BALL, power), wk.Coulomb(MU), path, wk.Method.RINGS)
