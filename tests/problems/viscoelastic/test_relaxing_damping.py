"""Damping of bodies that relax: complex moduli, elastic limits, hereditary sums written out, and plain cycles."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.loading.loads import ShearForce
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.plot.friction.damping import damping_sheet
from winkler.reference.damping import ball_loss
from winkler.values.errors import InvalidInput, OutsideValidity

RELAXED, GLASSY, TAU = 0.05, 0.25, 0.2
STANDARD = StandardSolid(RELAXED, GLASSY - RELAXED, TAU)
WIDE = Prony(0.05, [0.1, 0.2, 0.3, 0.2], [1e-2, 0.1, 1.0, 100.0])
MU, STICKY = wk.Coulomb(0.3), wk.Coulomb(1e5)
RADIUS, DEPTH = 0.1, 0.01
"""Of the contact of a ball of radius 1."""


def ball(solid):
    medium = wk.ViscoelasticHalfSpace(solid) if not isinstance(solid, wk.Elastic) else wk.HalfSpace(solid)
    return wk.Foundation(wk.Paraboloid(1.0), medium)


@pytest.mark.parametrize("solid", [STANDARD, WIDE], ids=lambda solid: type(solid).__name__)
def test_without_slip_the_loss_is_that_of_the_complex_modulus(solid):
    """Errors fall as one over the springs, since the load ends with a jump: two numbers of springs tell the limit."""
    frequency, shift = 1.3, 1e-4
    turn = 2.0 * math.pi * frequency
    shear = complex(solid.storage(np.array([turn]))[0], solid.loss(np.array([turn]))[0])
    stiffness = 2.0 * RADIUS * 8.0 / 3.0 * shear  # 2 a G*, G* = 4 G / (2 - nu)
    loss = math.pi * stiffness.imag * shift**2

    def solved(count, amplitude):
        bed = ball(solid)
        return wk.FrictionDamping(
            bed, STICKY, wk.Depth(DEPTH), amplitude, frequency=frequency, count=count, tolerance=1e-6
        ).solve()

    few, many = (solved(count, wk.Shift([0.0, shift])) for count in (400, 800))
    assert few.loss_per_cycle[1] == pytest.approx(loss, rel=2e-3)
    assert 2.0 * many.loss_per_cycle[1] - few.loss_per_cycle[1] == pytest.approx(loss, rel=1e-4)
    assert few.friction_loss[1] < 1e-3 * loss
    np.testing.assert_allclose(2.0 * many.secant_stiffness - few.secant_stiffness, abs(stiffness), rtol=2e-3)
    assert few.loss_factor[1] == pytest.approx(stiffness.imag / abs(stiffness), rel=2e-3)
    assert few.damping(frequency)[1] == pytest.approx(stiffness.imag / turn, rel=2e-3)
    few, many = (solved(count, ShearForce(abs(stiffness) * shift)) for count in (400, 800))
    assert 2.0 * many.loss_per_cycle - few.loss_per_cycle == pytest.approx(loss, rel=1e-3)
    assert 2.0 * many.shift - few.shift == pytest.approx(shift, rel=2e-3)


def relaxed_force(solid, depth=DEPTH):
    return 4.0 / 3.0 * 4.0 * float(solid.series.relaxed) * depth**1.5


@pytest.mark.parametrize("force", [False, True])
def test_slow_oscillations_lose_what_relaxed_bodies_lose(force):
    load, elastic = wk.Force(relaxed_force(STANDARD)), wk.Elastic(3.0 * RELAXED, 0.5)
    amplitude = ShearForce(0.2 * load.force) if force else wk.Shift([0.002, 0.006])
    slow = wk.FrictionDamping(ball(STANDARD), MU, load, amplitude, frequency=1e-5).solve()
    expected = wk.FrictionDamping(ball(elastic), MU, load, amplitude).solve()
    np.testing.assert_allclose(slow.loss_per_cycle, expected.loss_per_cycle, rtol=1e-3)
    np.testing.assert_allclose(slow.shear_force, expected.shear_force, rtol=1e-4)
    np.testing.assert_allclose(slow.shift, expected.shift, rtol=1e-3)
    assert np.max(slow.bulk_loss / slow.loss_per_cycle) < 1e-3
    assert slow.contact.radius == pytest.approx(RADIUS, rel=1e-9)
    assert slow.contact.force == pytest.approx(load.force, rel=1e-9)


@pytest.mark.parametrize("solid", [STANDARD, WIDE], ids=lambda s: type(s).__name__)
def test_fast_oscillations_shear_a_glassy_body_under_the_relaxed_load(solid):
    """Mindlin and Deresiewicz with G* right after a step, force and radius those after all time."""
    force = relaxed_force(solid)
    glassy = float(solid.series.glassy)
    push = np.array([0.4, 0.8]) * MU.coefficient * force
    fast = wk.FrictionDamping(ball(solid), MU, wk.Force(force), ShearForce(push), frequency=1e6).solve()
    expected = ball_loss(push, force=force, coefficient=MU.coefficient, radius=RADIUS, shear_modulus=8.0 / 3.0 * glassy)
    np.testing.assert_allclose(fast.loss_per_cycle, expected, rtol=2e-3)
    assert np.max(fast.bulk_loss / fast.loss_per_cycle) < 1e-3


def hereditary(solid, frequency, swing, cycles, steps, springs):
    """Return losses to friction and in all, and the amplitude of the force, by sums over the whole history.

    Springs of a ball stand in the middle of cells; each bears the sum over all its steps of modulus times change, with
    the modulus after a mean of the step.  Springs that would pull are let go, those on their bound slide.
    """
    x = (np.arange(springs) + 0.5) / springs * math.sqrt(max(np.max(swing(np.linspace(0.0, 1.0, 99))[0]), 0.0))
    width = 2.0 * x[0] * 2.0  # of both sides
    gap, dt = x * x, 1.0 / frequency / steps
    time = np.arange(cycles * steps + 1) / steps
    depth, shift = swing(time)
    shear = np.asarray(solid.relaxation(dt * (np.arange(time.size) + 0.5)))[::-1]  # after every step, its mean
    ease = np.asarray(solid.relaxation(np.full(1, 0.5 * dt)))[0]
    normal, along = 4.0, 8.0 / 3.0  # E* and G* over G
    rest = 4.0 * float(solid.series.relaxed)
    place = np.zeros((time.size, springs))
    moved = np.zeros((time.size, springs))
    place_steps, moved_steps = np.zeros((time.size, springs)), np.zeros((time.size, springs))
    start = max(depth[0], 0.0)
    place[0] = np.maximum(start - gap, 0.0)
    friction, force, work, lift = np.zeros(time.size), np.zeros(time.size), np.zeros(time.size), np.zeros(time.size)
    load = np.zeros(springs)
    for k in range(1, time.size):
        after = shear[-k:]  # of steps 1 .. k
        past_z = normal * (after[:-1] @ place_steps[1:k]) + rest * place[0]
        past_x = along * (after[:-1] @ moved_steps[1:k])
        free = place[k - 1] - past_z / (normal * ease)
        target = depth[k] - gap
        place[k] = np.where(target >= free, target, free)
        pressed = target >= free
        place_steps[k] = place[k] - place[k - 1]
        held = np.where(pressed, normal * ease * place_steps[k] + past_z, 0.0)
        bound = MU.coefficient * np.maximum(held, 0.0)
        step = shift[k] - shift[k - 1]
        trial = past_x + along * ease * step
        before = load
        load = np.clip(trial, -bound, bound)
        moved_steps[k] = (load - past_x) / (along * ease)
        moved[k] = moved[k - 1] + moved_steps[k]
        slid = np.where(bound > 0.0, step - moved_steps[k], 0.0)
        friction[k] = width * np.sum(load * slid)
        force[k] = width * np.sum(load)
        work[k] = width * np.sum(0.5 * (load + before)) * step
        lift[k] = width * np.sum(held)
    last = slice(-steps, None)
    pressing = float(np.sum(0.5 * (lift[last] + lift[-steps - 1 : -1]) * np.diff(depth)[last]))
    return float(np.sum(friction[last])), float(np.sum(work[last])), 0.5 * float(np.ptp(force[last])), pressing


def test_losses_are_those_of_hereditary_sums():
    """A ball under a steady depth: all of its memory written out, no series of exponentials carried on."""
    shift, frequency = 0.004, 1.0

    def swing(time):
        return np.full(np.shape(time), DEPTH), shift * np.sin(2.0 * math.pi * np.asarray(time))

    swung = wk.FrictionDamping(ball(STANDARD), MU, wk.Depth(DEPTH), wk.Shift(shift), frequency=frequency).solve()
    found = [hereditary(STANDARD, frequency, swing, 4, steps, 200) for steps in (200, 400)]
    (friction, work, force, _), (coarse, *_) = found[1], found[0]
    assert abs(coarse / friction - 1.0) < 0.02
    friction = 2.0 * friction - coarse
    assert swung.friction_loss == pytest.approx(friction, rel=3e-3)
    assert swung.loss_per_cycle == pytest.approx(2.0 * work - found[0][1], rel=3e-3)
    assert swung.shear_force == pytest.approx(force, rel=3e-3)


def test_losses_of_depth_and_shift_together_are_those_of_hereditary_sums():
    shift, amplitude, phase, frequency = 0.003, 0.004, 1.0, 1.0

    def swing(time):
        turn = 2.0 * math.pi * np.asarray(time)
        return DEPTH + amplitude * np.cos(turn), shift * np.cos(turn + phase)

    swung = wk.BimodalDamping(ball(STANDARD), MU, DEPTH, amplitude, shift, phase, frequency=frequency).solve()
    one, two = (np.array(hereditary(STANDARD, frequency, swing, 5, steps, 200)) for steps in (200, 400))
    friction, work, _, pressing = 2.0 * two - one
    assert swung.friction_loss == pytest.approx(friction, rel=5e-3)
    assert swung.loss_per_cycle - swung.pressing_loss == pytest.approx(work, rel=5e-3)
    assert swung.pressing_loss == pytest.approx(pressing, rel=5e-3)


def test_cycles_that_repeat_are_those_of_a_long_path():
    """`Tangential` through cycle after cycle, without any memory set ahead; its straight pieces cut corners."""
    shift, amplitude, phase = 0.003, 0.004, 1.0
    swing = wk.BimodalDamping(ball(STANDARD), MU, DEPTH, amplitude, shift, phase, frequency=1.0, tolerance=1e-7)
    losses = []
    for count in (100, 200):
        path = swing.path(phase, shift, cycles=14, count=count)
        marched = wk.Tangential(swing.bed, MU, path, tolerance=1e-7).solve()
        first = int(np.searchsorted(path.time, 13.0 - 1e-9))
        losses.append([float(np.ptp(loss[first:])) for loss in (marched.friction_loss, marched.bulk_loss)])
    solved = swing.solve()
    limit = (4.0 * np.array(losses[1]) - losses[0]) / 3.0
    np.testing.assert_allclose([solved.friction_loss, solved.bulk_loss], limit, rtol=5e-4)


@pytest.mark.slow
def test_slow_memories_need_few_cycles():
    """Against as many plain cycles as the memory lasts: forty, of a relaxation time of four.

    Here the bodies are glassy in a cycle, while springs have relaxed about the mean of theirs.
    """
    solid = StandardSolid(RELAXED, GLASSY - RELAXED, 4.0)
    swing = wk.BimodalDamping(ball(solid), MU, DEPTH, 0.004, 0.002, 1.0, frequency=1.0, count=60, tolerance=1e-6)
    path = swing.path(1.0, 0.002, cycles=40, count=80)
    marched = wk.Tangential(swing.bed, MU, path, count=60, tolerance=1e-6).solve()
    first = int(np.searchsorted(path.time, 39.0 - 1e-9))
    solved = swing.solve()
    assert solved.friction_loss == pytest.approx(float(np.ptp(marched.friction_loss[first:])), rel=5e-3)
    assert solved.bulk_loss == pytest.approx(float(np.ptp(marched.bulk_loss[first:])), rel=1e-2)
    assert solved.cycle_change < 1e-4


def test_a_depth_that_rests_is_friction_damping():
    fine = {"frequency": 2.0, "tolerance": 1e-7}
    push = wk.FrictionDamping(ball(WIDE), MU, wk.Depth(DEPTH), wk.Shift(0.003), **fine).solve()
    both = wk.BimodalDamping(ball(WIDE), MU, DEPTH, 0.0, [0.003, 0.0], **fine).solve()
    assert both.friction_loss[0] == pytest.approx(push.friction_loss, rel=1e-4)
    assert both.bulk_loss[0] == pytest.approx(push.bulk_loss, rel=1e-3)
    assert both.loss_stiffness[0] == pytest.approx(push.loss_stiffness, rel=1e-4)
    assert both.pressing_loss == both.loss_per_cycle[1] == 0.0


def test_slow_cycles_of_depth_and_shift_lose_what_relaxed_bodies_lose():
    numbers = DEPTH, 0.004, 0.003, np.array([0.3, 1.5])
    slow = wk.BimodalDamping(ball(STANDARD), MU, *numbers, 2, 3, frequency=1e-6).solve()
    expected = wk.BimodalDamping(ball(wk.Elastic(3.0 * RELAXED, 0.5)), MU, *numbers, 2, 3).solve()
    np.testing.assert_allclose(slow.friction_loss, expected.loss_per_cycle, rtol=2e-3)
    np.testing.assert_allclose(slow.loss_per_cycle, slow.friction_loss, rtol=1e-3)


@pytest.mark.slow
def test_relaxing_layers_slide_as_rings_of_elastic_ones():
    """Slow and fast: the loss of rings on elastic layers, under the load that the relaxed ones bear."""
    solid = wk.Elastic(3.0, 0.5)
    layers = wk.CoatedHalfSpace([wk.Layer(solid, 0.05)], on=wk.Elastic(0.6, 0.4))
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.RelaxingInProportion(layers, StandardSolid(1.0, 4.0, 1.0), shear=1.0))
    amplitude = wk.Shift([0.002, 0.004])
    expected = wk.FrictionDamping(bed.with_medium(layers), MU, wk.Depth(DEPTH), amplitude).solve()
    slow = wk.FrictionDamping(bed, MU, wk.Depth(DEPTH), amplitude, frequency=1e-6).solve()
    np.testing.assert_allclose(slow.loss_per_cycle, expected.loss_per_cycle, rtol=1e-2)
    np.testing.assert_allclose(slow.shear_force, expected.shear_force, rtol=5e-3)
    # fast: five times as stiff along, under the same pressure, as under a fifth of the friction and of the forces
    fifth = wk.FrictionDamping(bed.with_medium(layers), wk.Coulomb(0.06), wk.Depth(DEPTH), amplitude).solve()
    fast = wk.FrictionDamping(bed, MU, wk.Depth(DEPTH), amplitude, frequency=1e6).solve()
    np.testing.assert_allclose(fast.loss_per_cycle, 5.0 * np.asarray(fifth.loss_per_cycle), rtol=1e-2)


LAYERS = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(STANDARD, 0.2)], wk.Elastic(1.0, 0.3))
BAD = {
    "no frequency": (lambda: damped(ball(STANDARD)), "give the frequency in Hz"),
    "of elastic bodies": (lambda: damped(ball(wk.Elastic(1.0, 0.3)), frequency=2.0), "2 Hz.*leave it out"),
    "fluid": (lambda: damped(ball(Maxwell(1.0, 1.0)), frequency=1.0), "creeps without limit"),
    "dashpot": (lambda: damped(ball(KelvinVoigt(1.0, 1.0)), frequency=1.0), "dashpot alongside"),
    "rings": (lambda: damped(ball(STANDARD), frequency=1.0, method=wk.Method.RINGS), "the method rings"),
}


def damped(bed, **more):
    return wk.FrictionDamping(bed, MU, wk.Depth(DEPTH), wk.Shift(1e-3), **more)


@pytest.mark.parametrize("name", BAD)
def test_bad_input(name):
    made, words = BAD[name]
    with pytest.raises(InvalidInput, match=words):
        made()
    with pytest.raises(InvalidInput, match="give the frequency in Hz"):
        wk.BimodalDamping(ball(STANDARD), MU, DEPTH, 0.001, 0.001)


def test_more_force_than_friction_bears():
    problem = wk.FrictionDamping(ball(STANDARD), MU, wk.Force(1e-4), ShearForce([1e-5, 4e-5]), frequency=1.0)
    with pytest.raises(OutsideValidity, match=r"4e-05 N at index 1 exceeds .* 3e-05 N"):
        problem.solve()
    swing = wk.FrictionDamping(ball(STANDARD), MU, wk.Force(1e-4), ShearForce(1e-5), frequency=1.0).solve()
    with pytest.raises(InvalidInput, match="give this one, or solve the problem at the other"):
        swing.damping(2.0)


def test_the_greatest_force_that_friction_bears():
    force = 1e-4
    swing = wk.FrictionDamping(ball(STANDARD), MU, wk.Force(force), ShearForce(0.3 * force), frequency=1.0).solve()
    assert swing.shear_force == pytest.approx(0.3 * force, rel=1e-9)


def test_one_question_says_whether_a_medium_relaxes():
    assert relaxes(LAYERS)
    assert relaxes(ball(STANDARD).medium)
    assert not relaxes(LAYERS.relaxed)
    assert not relaxes(ball(wk.Elastic(1.0, 0.3)).medium)


def test_the_picture_tells_the_losses_apart():
    swing = wk.FrictionDamping(ball(STANDARD), MU, wk.Depth(DEPTH), wk.Shift(0.003), frequency=1.0, count=20).solve()
    lost, damped, loop = damping_sheet(swing).panels
    names = [mark.name for mark in lost.marks]
    assert names == ["all", "to friction", "in the bodies", "requested"]
    whole, rubbed, inside = (np.asarray(mark.y) for mark in lost.marks[:3])
    np.testing.assert_allclose(whole, rubbed + inside, rtol=1e-12)
    assert len(damped.marks) == 2
    assert max(loop.marks[1].x) == pytest.approx(0.003, rel=1e-12)


@pytest.mark.parametrize("asked", ["damping", "bimodal", "line"])
def test_bodies_that_never_touch_are_refused_as_such(asked):
    """On layers of own laws, and under a line, a division by zero was taken for numbers that are too large."""
    medium = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(STANDARD, 0.01)], wk.Elastic(1.0, 0.3))
    bed = wk.Foundation(wk.Paraboloid(1.0), medium)
    line = wk.LineFoundation(wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(STANDARD))
    problem = {
        "damping": lambda: wk.FrictionDamping(bed, MU, wk.Depth(0.0), wk.Shift(1e-4), frequency=1.0),
        "bimodal": lambda: wk.BimodalDamping(bed, MU, 0.0, 0.0, 1e-4, frequency=1.0),
        "line": lambda: wk.LineTangential(line, MU, wk.LinePath([0.0, 0.0], [0.0, 0.0], time=[0.0, 1.0])),
    }[asked]()
    with pytest.raises(OutsideValidity, match="the bodies never touch along this path; press them"):
        problem.solve()
