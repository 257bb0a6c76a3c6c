"""The last cycle of a path: its loss against closed forms and the work, and loops that do not close."""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.problems.last_cycle import cycle_ends
from winkler.study.batch.outcome import answers_of
from winkler.values.errors import OutsideValidity

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BALL = wk.Foundation(wk.Paraboloid(10e-3), PAIR)
MU, LOAD, SHEAR = 0.3, 100.0, 18.0
NUMBERS = "loss_per_cycle", "secant_stiffness", "loss_factor"


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
    assert loop.loss_factor == pytest.approx(loss / (math.pi * SHEAR * shift), rel=1e-11)
    found = answers_of(loop)
    assert {name: found[name] for name in NUMBERS} == {name: getattr(loop, name) for name in NUMBERS}


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
    with pytest.raises(OutsideValidity, match="has no closed cycle"):
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


def test_a_line_that_begins_at_rest_does_not_close_its_first_loop():
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), PAIR)
    first = wk.LineTangential(bed, wk.Coulomb(0.5), wk.LinePath(1e5, [0.0, 30e3, -30e3, 0.0], count=60)).solve()
    again = wk.LineTangential(bed, wk.Coulomb(0.5), wk.LinePath(1e5, [0.0, 30e3, -30e3, 30e3], count=60)).solve()
    named = [any("not closed" in note.statement for note in line.validity) for line in (first, again)]
    assert named == [True, False]


RUBBER = wk.StandardSolid(relaxed_shear=1e6, shear=1e6, relaxation_time=0.1, poisson=0.5)
SOFT = wk.Foundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(RUBBER))
UNIT = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
SWING = np.concatenate([np.linspace(a, b, 4000) for a, b in ((-0.1, 0.1), (0.1, -0.1))])
PRESSES = np.concatenate([np.linspace(a, b, 400) for a, b in ((0.0, 5e-5), (5e-5, 2e-5), (2e-5, 5e-5))])
LOOPS = {
    "springs": lambda: wk.Tangential(
        BALL,
        wk.StaticKinetic(0.4, 0.3),
        wk.Path.oscillation(force=LOAD, amplitude=4e-7, cycles=2, count=400),
        wk.Method.SPRINGS,
    ),
    "pressed rubber": lambda: wk.ViscoelasticIndentation(
        SOFT, wk.Path(np.linspace(0.0, 2.0, 401), wk.Depth(1e-4 + 2e-5 * np.sin(2 * np.pi * np.linspace(0, 2, 401))))
    ),
    "adhesion": lambda: wk.AdhesiveCycle(UNIT, wk.ShortRange(1e-3), wk.Depth(SWING)),
    "adhesion on a soft machine": lambda: wk.AdhesiveCycle(UNIT, wk.ShortRange(1e-3), wk.Depth(2.0 * SWING), 0.2),
    "a particle": lambda: wk.ElasticPlasticParticle(1e-3, wk.Elastic(1e9, 0.3, strength=2e7), wk.Depth(PRESSES)),
}


@pytest.mark.parametrize("name", LOOPS)
def test_the_loss_of_a_cycle_is_the_area_of_its_loop(name):
    loop = LOOPS[name]().solve()
    part = slice(loop.last_cycle.first, loop.last_cycle.last + 1)
    along = getattr(loop, "shift" if name == "springs" else "position" if "adhesion" in name else "depth")[part]
    load = (loop.shear_force if name == "springs" else loop.force)[part]
    assert loop.loss_per_cycle == pytest.approx(np.trapezoid(load, along), rel=3e-3, abs=1e-9 * np.ptp(load * along))
    factor = loop.loss_per_cycle / (0.25 * np.pi * np.ptp(load) * np.ptp(along))
    assert loop.loss_factor == pytest.approx(factor, rel=1e-12)
    assert loop.secant_stiffness == pytest.approx(np.ptp(load) / np.ptp(along), rel=1e-12)


def test_a_small_swing_of_rubber_has_the_dynamic_stiffness():
    """Loss and stiffness by the complex modulus, of a ball that swings by a hundredth of its depth."""
    time = np.linspace(0.0, 3.0, 241)
    path = wk.Path(time, wk.Depth(1e-4 + 1e-6 * np.sin(2.0 * np.pi * time)))
    loop = wk.ViscoelasticIndentation(SOFT, path, count=200).solve()
    stated = wk.HarmonicIndentation(SOFT, wk.Depth(1e-4), 2.0 * np.pi).solve()
    assert loop.loss_per_cycle == pytest.approx(np.pi * stated.loss_stiffness * 1e-12, rel=5e-3)
    assert loop.secant_stiffness == pytest.approx(math.hypot(stated.storage_stiffness, stated.loss_stiffness), rel=5e-3)


def test_a_particle_that_stays_pressed_does_not_close_its_cycle():
    pressed = wk.ElasticPlasticParticle(1e-3, wk.Elastic(1e9, 0.3, strength=2e7), wk.Depth([0.0, 5e-5, 0.0, 5e-5, 0.0]))
    first = wk.ElasticPlasticParticle(1e-3, wk.Elastic(1e9, 0.3, strength=2e7), wk.Force([0.01, 5.0, 0.01]))
    named = [any("not closed" in note.statement for note in each.solve().validity) for each in (pressed, first)]
    assert named == [False, True]


def test_a_map_that_is_twisted_has_the_numbers_of_the_twist():
    ball = wk.SampledProfile([6e-4, 6e-4], wk.Paraboloid(10e-3), (16, 16))
    turns = wk.Torque([0.0, 1e-3, -1e-3, 1e-3])
    inside = wk.SurfaceTangential(ball, PAIR, wk.Coulomb(MU), wk.Path.through(wk.Force(LOAD), turns)).solve()
    still = wk.Path.through(wk.Force(LOAD), wk.Shift(np.zeros(4)))
    beside = wk.SurfaceTangential(ball, PAIR, wk.Coulomb(MU), still, twist=turns).solve()
    round_ = wk.Torsion(BALL, wk.Coulomb(MU), wk.Path.through(wk.Force(LOAD), turns)).solve()
    assert beside.loss_per_cycle == inside.loss_per_cycle > 0.0
    stiffness = inside.last_cycle.load / inside.last_cycle.motion
    assert stiffness == pytest.approx(round_.secant_stiffness, rel=3e-2)
    with pytest.raises(OutsideValidity, match=r"the cycle turns the bodies.* \[N m/rad\]"):
        _ = inside.secant_stiffness
    pushed = wk.Path.through(wk.Force(LOAD), wk.ShearForce([0.0, 12.0, -12.0, 12.0]))
    both = wk.SurfaceTangential(ball, PAIR, wk.Coulomb(MU), pushed, twist=turns).solve()
    assert both.loss_per_cycle > inside.loss_per_cycle
    with pytest.raises(OutsideValidity, match="rotates the bodies in addition"):
        _ = both.loss_factor


def test_a_circle_has_a_loss_and_no_stiffness():
    angle = np.linspace(0.0, 4.0 * np.pi, 161)
    path = wk.Path.through(wk.Force(LOAD), wk.Shift(4e-7 * np.stack([np.cos(angle), np.sin(angle)], axis=1)))
    loop = wk.Tangential(BALL, wk.Coulomb(MU), path).solve()
    middle = 0.5 * (loop.shear_force[80:-1] + loop.shear_force[81:])
    assert loop.loss_per_cycle == pytest.approx(np.sum(middle * np.diff(loop.shift[80:], axis=0)), rel=1e-2)
    with pytest.raises(OutsideValidity, match="changes its direction"):
        _ = loop.secant_stiffness
    assert answers_of(loop).keys() & set(NUMBERS) == {"loss_per_cycle"}


def test_a_cycle_of_depth_and_shift_loses_what_its_springs_lose_one_by_one():
    """The march of springs by gap beside the closed cycle of each spring, whose integral has no steps."""
    angle = np.linspace(0.0, 4.0 * np.pi, 401)
    path = wk.Path(angle, wk.Depth(2e-6 + 1e-6 * np.cos(angle)), wk.Shift(3e-7 * np.cos(angle + 1.0)))
    march = wk.Tangential(BALL, wk.Coulomb(MU), path).solve()
    cycle = wk.BimodalDamping(BALL, wk.Coulomb(MU), 2e-6, 1e-6, 3e-7, phase=1.0).solve()
    assert (march.last_cycle.first, march.last_cycle.last) == (200, 400)
    assert march.loss_per_cycle == pytest.approx(cycle.loss_per_cycle, rel=1e-3)


SWEPT = """
[problem]
kind = "tangential"
law = { kind = "coulomb", coefficient = 0.3 }
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
second = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
[problem.path]
kind = "path"
time = ["0 s", "1 s", "2 s", "3 s"]
normal = { kind = "force", force = "100 N" }
lateral = { kind = "shear_force", shear_force = ["0 N", "10 N", "-10 N", "10 N"] }
[sweep]
"problem.path.normal.force" = ["80 N", "100 N"]
"problem.path.lateral.shear_force" = [
    ["0 N", "10 N", "-10 N", "10 N"], ["0 N", "18 N", "-18 N", "18 N"], ["0 N", "20 N", "-4 N", "20 N"]
]
[output]
figures = []
report = false
"""


def test_energy_over_force_and_turning_points_is_one_sweep_on_the_command_line(tmp_path):
    """Half of the range counts alone: of 20 and -4 N it is 12 N; the loss is that of `FrictionDamping`."""
    (tmp_path / "loops.toml").write_text(SWEPT, encoding="utf-8")
    assert main(["run", str(tmp_path / "loops.toml"), "--output", str(tmp_path / "out")]) == 0
    with open(tmp_path / "out" / "results.csv", encoding="utf-8", newline="") as table:
        lines = [line for line in csv.reader(table) if not line[0].startswith("#")]
    place = next(place for place, name in enumerate(lines[0]) if "loss_per_cycle" in name)
    found = [float(line[place]) for line in lines[1:] if line[place]]
    sought = [
        wk.FrictionDamping(BALL, wk.Coulomb(MU), wk.Force(force), wk.ShearForce([10.0, 18.0, 12.0])).solve()
        for force in (80.0, 100.0)
    ]
    losses = np.concatenate([each.loss_per_cycle for each in sought])
    assert np.unique(found).size == losses.size
    assert np.sort(np.unique(found)) == pytest.approx(np.sort(losses), rel=1e-9)
    assert sought[1].loss_factor[1] == pytest.approx(
        wk.Tangential(
            BALL, wk.Coulomb(MU), wk.Path.oscillation(force=100.0, amplitude=wk.ShearForce(18.0), cycles=2)
        ).solve().loss_factor, rel=1e-9,
    )  # fmt: skip


@pytest.mark.parametrize(("last", "named"), [("0 um", True), ("0.6 um", False)])
def test_a_loop_that_does_not_close_is_named_on_the_command_line(last, named, tmp_path, capsys):
    """Pushed for the first time the ball has no shear force at no shift, and has one when it is back there."""
    forced = 'kind = "shear_force", shear_force = ["0 N", "10 N", "-10 N", "10 N"] }\n[sweep]'
    shifted = f'kind = "shift", shift = ["0 um", "0.6 um", "-0.6 um", "{last}"] }}\n[sweep]'
    assert forced in SWEPT
    start, end = SWEPT.replace(forced, shifted).split("[sweep]")
    (tmp_path / "loop.toml").write_text(f"{start}[output]{end.split('[output]')[1]}", encoding="utf-8")
    assert main(["run", str(tmp_path / "loop.toml"), "--output", str(tmp_path / "out")]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "loss per cycle" in said
    assert ("The last cycle of the path, from point 0 to point 3, is not closed." in said) == named
    assert ("is not closed" in said) == named
