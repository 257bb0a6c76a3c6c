"""Histories under a steady load: turning points against the march of the springs, and against boundary elements."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.torsion_bound import PressedState, twist_bound
from winkler.problems.ring_slip.play import followed
from winkler.problems.ring_slip.push_bound import push_bound
from winkler.problems.ring_slip.steady_path import steady_points
from winkler.problems.ring_slip.torsion_march import square, step_to, torque_of, torsion_step
from winkler.problems.ring_slip.torsion_pieces import TwistMemory, fresh

MU, D = 0.3, 0.01
LAYER = wk.Layer(wk.Elastic(1.0, 0.3), 0.1)
BALL = wk.Paraboloid(1.0)


def on(ratio: float) -> wk.Foundation:
    return wk.Foundation(BALL, wk.CoatedHalfSpace([LAYER], on=wk.Elastic(ratio, 0.3)))


def history(count: int, seed: int) -> np.ndarray:
    """Random turns, one outward branch that closes all loops, loops that end where they began, and a rest."""
    random = np.random.default_rng(seed).uniform(-1.0, 1.0, count)
    return np.concatenate([[0.0], random, [1.0, -1.0, 1.0, 0.2, 0.5, 0.2, 0.5, 0.5, 0.7, -1.0, 0.0]])


@pytest.mark.slow
def test_a_ball_that_never_touches_bears_nothing_in_all_units():
    time = np.arange(3.0)
    for size in (1e-6, 1.0, 1e6):
        layer = wk.Layer(wk.Elastic(1.0, 0.3), 0.1 * size)
        bed = wk.Foundation(wk.Paraboloid(size), wk.CoatedHalfSpace([layer], on=wk.Elastic(0.1, 0.3)))
        path = wk.Path(time, wk.Force(np.zeros(3)), wk.Shift(1e-3 * size * np.array([0.0, 1.0, -1.0])))
        moved = wk.Tangential(bed, wk.Coulomb(MU), path).solve()
        assert not any(each.any() for each in (moved.shear_force, moved.radius, moved.dissipation))


@pytest.mark.parametrize(
    ("bound_of", "ratio"), [(push_bound, 0.1), pytest.param(twist_bound, 10.0, marks=pytest.mark.slow)]
)
def test_turning_points_as_the_march_of_the_springs(bound_of, ratio):
    bed = on(ratio)
    contact = wk.Indentation(bed, wk.Depth(D)).solve()
    bound = bound_of(bed, MU, float(contact.radius), False)
    press = PressedState(D, float(contact.radius), 0.0)
    values = 0.8 * float(bound.at(press).max()) * history(6, 3)
    if bound_of is twist_bound:
        values *= 0.1  # the bound grows without limit towards the axis
    found = steady_points(bound, press, values.tolist(), by_load=False)
    memory, motion, lost, work = torsion_step(bound, fresh(), press, 0.0).memory, 0.0, 0.0, 0.0
    most, whole = bound.most(press), found[-1].work
    for value, point in zip(values.tolist(), found, strict=True):
        step = torsion_step(bound, memory, press, value - motion)
        memory, motion, lost, work = step.memory, value, lost + step.loss, work + step.work
        assert point.load == pytest.approx(torque_of(bound, memory), abs=1e-12 * most)
        assert point.load == pytest.approx(torque_of(bound, TwistMemory(press, point.memory.pieces)), abs=1e-12 * most)
        got = (point.work, point.lost, point.stored, square(bound, TwistMemory(press, point.memory.pieces)))
        assert got == pytest.approx((work, lost, square(bound, memory), point.stored), abs=1e-12 * whole)
    back = steady_points(bound, press, [point.load for point in found], by_load=True)
    np.testing.assert_allclose([point.motion for point in back], values, atol=1e-11 * np.max(values))


def test_a_prescribed_load_as_the_march_of_the_springs():
    bed = on(0.1)
    contact = wk.Indentation(bed, wk.Depth(D)).solve()
    bound = push_bound(bed, MU, float(contact.radius), False)
    press = PressedState(D, float(contact.radius), 0.0)
    loads = 0.97 * bound.most(press) * np.array([0.0, 0.4, 1.0, -1.0, 0.6, 0.2, 1.0])
    found = steady_points(bound, press, loads.tolist(), by_load=True)
    memory, motion = torsion_step(bound, fresh(), press, 0.0).memory, 0.0
    for load, point in zip(loads.tolist(), found, strict=True):
        step = step_to(bound, memory, press, load)
        memory, motion = step.memory, motion + step.twist
        assert point.motion == pytest.approx(motion, abs=1e-10 * float(bound.at(press).max()))


def test_a_history_is_cut_into_branches():
    """Out to 4, an inner loop 1 to 3 that closes, and beyond -4, where nothing is remembered."""
    branches = followed([4.0, 1.0, 3.0, 0.0, -4.0, -5.0])
    assert [branches.turns(point) for point in range(6)] == [[], [0], [0, 1], [0], [], []]
    assert branches.directions == [1.0, -1.0, 1.0, -1.0, -1.0, -1.0]
    ways = [(each.point, each.fold, each.start, each.end) for each in branches.stretches]
    assert ways[:4] == [(0, 1, 0.0, 4.0), (1, 2, 0.0, 1.5), (2, 2, 0.0, 1.0), (3, 2, 0.0, 1.0)]
    assert ways[4:] == [(3, 2, 1.5, 2.0), (4, 2, 2.0, 4.0), (4, 1, 4.0, 4.0), (5, 1, 4.0, 5.0)]


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [0.1, 10.0])
def test_a_loop_as_by_boundary_elements_on_the_layer(ratio):
    """Tractions of both directions on 97 x 97 pixels, without rings: within 0.1 % of friction, losses within 0.3 %."""
    bed = on(ratio)
    contact = wk.Indentation(bed, wk.Depth(D)).solve()
    radius, friction = float(contact.radius), MU * float(contact.force)
    unit = friction / float(bed.medium.punch_shear_stiffness(np.array([radius]))[0])
    path = wk.Path.through(wk.Depth(D), wk.Shift(unit * np.array([0.0, 0.5, 1.0, 0.3, -0.6, 0.4])))
    rings = wk.Tangential(bed, wk.Coulomb(MU), path).solve()
    assert np.min(rings.stick_radius) < 0.65 * radius
    topography = wk.SampledProfile([2.6 * radius] * 2, BALL, (97, 97))
    pixels = wk.SurfaceTangential(topography, bed.medium, wk.Coulomb(MU), path).solve()
    np.testing.assert_allclose(pixels.shear_force[:, 0], rings.shear_force, atol=1e-3 * friction)
    np.testing.assert_allclose(pixels.dissipation, rings.dissipation, rtol=3e-3, atol=0.0)


def test_damping_on_a_coating_is_that_of_its_loop():
    bed, law = on(0.1), wk.Coulomb(MU)
    contact = wk.Indentation(bed, wk.Depth(D)).solve()
    shift = MU * float(contact.force) / float(bed.medium.punch_shear_stiffness(contact.radius))
    path = wk.Path.through(wk.Depth(D), wk.Shift(shift * np.array([0.0, 1.0, -1.0, 1.0])))
    loop = wk.Tangential(bed, law, path).solve()
    swing = wk.FrictionDamping(bed, law, wk.Depth(D), wk.Shift([0.0, shift])).solve()
    assert swing.loss_per_cycle[1] == pytest.approx(loop.dissipation[3] - loop.dissipation[1], rel=1e-12)
    assert swing.shear_force[1] == pytest.approx(loop.shear_force[1], rel=1e-12)
    assert swing.loss_per_cycle[0] == 0.0 == swing.shear_force[0]
    assert any("kernels are those of the layers" in note.statement for note in swing.validity)
    back = wk.FrictionDamping(bed, law, wk.Depth(D), wk.ShearForce([swing.shear_force[1], MU * contact.force])).solve()
    assert back.shift[0] == pytest.approx(shift, rel=1e-11)


def test_damping_on_a_layer_of_the_same_solid_is_that_of_a_half_space():
    """Mindlin and Deresiewicz, with all that slides at the end."""
    solid, law, swing = wk.Elastic(1.0, 0.3), wk.Coulomb(MU), wk.Shift(np.array([1e-5, 1e-4, 1e-3, 2e-2]))
    media = (wk.CoatedHalfSpace([LAYER], on=solid), wk.HalfSpace(solid))
    first, other = (wk.FrictionDamping(wk.Foundation(BALL, each), law, wk.Depth(D), swing).solve() for each in media)
    np.testing.assert_allclose(first.loss_per_cycle, other.loss_per_cycle, rtol=1e-9)
    np.testing.assert_allclose(first.shear_force, other.shear_force, rtol=1e-10)
