"""The last cycle of a path: its loss against closed forms and the work, and loops that do not close."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.errors import OutsideValidity
from winkler.problems.last_cycle import cycle_ends
from winkler.study.batch.outcome import answers_of

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BALL = wk.Foundation(wk.Paraboloid(10e-3), PAIR)
MU, LOAD, SHEAR = 0.3, 100.0, 18.0


def test_a_ball_loses_what_its_first_loading_says_by_masing():
    """W = 8 int F du - 4 F U with the closed curve F = mu P (1 - (1 - u/u_m)^(3/2)) of Cattaneo and Mindlin."""
    path = wk.Path.oscillation(force=LOAD, amplitude=wk.ShearForce(SHEAR), cycles=2)
    loop = wk.Tangential(BALL, wk.Coulomb(MU), path).solve()
    radius = (0.75 * LOAD * 10e-3 / PAIR.modulus) ** (1.0 / 3.0)
    most = 0.75 * MU * LOAD / (radius * PAIR.shear_modulus)
    left = (1.0 - SHEAR / (MU * LOAD)) ** (2.0 / 3.0)
    shift = most * (1.0 - left)
    under = MU * LOAD * (shift - 0.4 * most * (1.0 - left**2.5))
    loss = 8.0 * under - 4.0 * SHEAR * shift
    assert (loop.last_cycle.first, loop.last_cycle.last) == (40, 80)
    assert loop.loss_per_cycle == pytest.approx(loss, rel=1e-11)
    assert loop.secant_stiffness == pytest.approx(SHEAR / shift, rel=1e-12)
    assert loop.damping_ratio == pytest.approx(loss / (2.0 * math.pi * SHEAR * shift), rel=1e-11)
    found = answers_of(loop)
    assert {name: found[name] for name in ("loss_per_cycle", "secant_stiffness", "damping_ratio")} == {
        "loss_per_cycle": loop.loss_per_cycle,
        "secant_stiffness": loop.secant_stiffness,
        "damping_ratio": loop.damping_ratio,
    }


def test_a_twist_loses_its_work():
    twist = wk.Torsion(
        BALL, wk.Coulomb(MU), wk.Path.through(wk.Force(LOAD), wk.Torque([0.0, 1e-3, -1e-3, 1e-3]))
    ).solve()
    assert twist.loss_per_cycle == pytest.approx(twist.work[3] - twist.work[1], rel=1e-9)
    assert twist.secant_stiffness == pytest.approx(1e-3 / twist.angle[1], rel=1e-9)
    assert not any("not closed" in note.statement for note in twist.validity)


def test_a_line_loses_the_area_of_its_loop():
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)
    path = wk.LinePath(1e5, [0.0, 30e3, -30e3, 30e3], count=400)
    line = wk.LineTangential(bed, wk.Coulomb(0.5), path).solve()
    loop = slice(line.last_cycle.first, line.last_cycle.last + 1)
    area = np.trapezoid(line.shear_force_per_length[loop], line.slip_shift[loop])  # what is elastic cancels
    assert line.loss_per_cycle_per_length == pytest.approx(area, rel=2e-4)


def test_a_map_has_the_numbers_of_its_cycle():
    ball = wk.SampledProfile([6e-4, 6e-4], wk.Paraboloid(10e-3), (16, 16))
    path = wk.Path.through(wk.Force(LOAD), wk.ShearForce([0.0, 12.0, -12.0, 12.0]))
    pushed = wk.SurfaceTangential(ball, PAIR, wk.Coulomb(MU), path).solve()
    assert pushed.loss_per_cycle == pushed.dissipation[3] - pushed.dissipation[1] > 0.0
    assert pushed.secant_stiffness == pytest.approx(12.0 / pushed.shift_x[1], rel=1e-3)


@pytest.mark.parametrize(("cycles", "named"), [(1, True), (2, False)])
def test_a_loop_that_does_not_close_is_named(cycles, named):
    """Moved for the first time, the ball begins its first cycle without slip."""
    path = wk.Path.oscillation(force=LOAD, amplitude=wk.Shift(6e-7), cycles=cycles)
    loop = wk.Tangential(BALL, wk.Coulomb(MU), path).solve()
    notes = [note.statement for note in loop.validity if "not closed" in note.statement]
    assert bool(notes) == named
    assert not named or "from point 0 to point 40" in notes[0]


def test_a_path_without_a_cycle_has_no_loss_of_one():
    pushed = wk.Tangential(
        BALL, wk.Coulomb(MU), wk.Path.through(wk.Force(LOAD), wk.ShearForce([0.0, 9.0, 4.0]))
    ).solve()
    with pytest.raises(OutsideValidity, match="closes no cycle"):
        _ = pushed.loss_per_cycle
    assert "loss_per_cycle" not in answers_of(pushed)


PATHS = {
    "waits at the end": ([[0.0, 1.0, -1.0, 1.0, 1.0]], (1, 4)),
    "a small loop at the end": ([[0.0, 2.0, 1.0, 2.0]], (1, 3)),
    "twice as fast across": ([[0.0, 1.0, 0.0, -1.0, 0.0], [1.0, 2.0, 1.0, 2.0, 1.0]], (0, 4)),
    "on its way back": ([[0.0, 2.0, 1.0]], None),
    "pulses": ([[0.0, 1.0, 0.0, 1.0, 0.0]], (2, 4)),
    "back at the beginning": ([[1.0, -1.0, 1.0]], (0, 2)),
    "at rest": ([[1.0, 1.0, 1.0]], None),
}


@pytest.mark.parametrize("name", PATHS)
def test_a_cycle_ends_where_it_began_in_the_same_direction(name):
    rows, ends = PATHS[name]
    assert cycle_ends([np.array(row) for row in rows]) == ends


def test_rings_on_equal_layers_lose_what_the_half_space_loses():
    path = wk.Path.through(wk.Force(LOAD), wk.Shift([0.0, 4e-7, -4e-7, 4e-7]))
    layers = wk.CoatedHalfSpace([wk.Layer(STEEL, 5e-5)], STEEL, STEEL)
    rings = wk.Tangential(wk.Foundation(wk.Paraboloid(10e-3), layers), wk.Coulomb(MU), path).solve()
    gap = wk.Tangential(BALL, wk.Coulomb(MU), path).solve()
    assert rings.loss_per_cycle == pytest.approx(gap.loss_per_cycle, rel=1e-3)
    assert rings.secant_stiffness == pytest.approx(gap.secant_stiffness, rel=1e-4)
    assert not any("not closed" in note.statement for note in rings.validity)


def test_a_body_that_hardly_relaxes_loses_what_an_elastic_one_loses():
    slow = wk.StandardSolid(relaxed_shear=0.5 * STEEL.shear, shear=0.5 * STEEL.shear, relaxation_time=1e9, poisson=0.3)
    bed = wk.Foundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(slow))
    path = wk.Path.through(wk.Depth(1e-6), wk.Shift([0.0, 2e-7, -2e-7, 2e-7]))
    late = wk.Tangential(bed, wk.Coulomb(MU), path).solve()
    elastic = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL))
    now = wk.Tangential(elastic, wk.Coulomb(MU), path).solve()
    assert late.loss_per_cycle == pytest.approx(now.loss_per_cycle, rel=1e-2)
    assert late.secant_stiffness == pytest.approx(now.secant_stiffness, rel=1e-3)


def test_a_line_that_begins_at_rest_does_not_close_its_first_loop():
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)
    first = wk.LineTangential(bed, wk.Coulomb(0.5), wk.LinePath(1e5, [0.0, 30e3, -30e3, 0.0], count=60)).solve()
    again = wk.LineTangential(bed, wk.Coulomb(0.5), wk.LinePath(1e5, [0.0, 30e3, -30e3, 30e3], count=60)).solve()
    named = [any("not closed" in note.statement for note in line.validity) for line in (first, again)]
    assert named == [True, False]
