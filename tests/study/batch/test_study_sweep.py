"""Sweeps: every combination, in order, the same numbers in a pool, failures with their reasons."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest

import winkler as wk
from winkler.problems.particles.trace import ContactTrace
from winkler.study.batch import stream
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.points import Failed, Solved
from winkler.study.batch.pool import Machine
from winkler.study.batch.processes import THREAD_VARIABLES
from winkler.study.batch.run import run
from winkler.study.batch.sweep import solve_points
from winkler.study.batch.tasks import tasks
from winkler.study.language.designs import Zipped
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Fields, Places, Study
from winkler.study.language.varied import Axis
from winkler.study.language.writing import study_text
from winkler.study.report.describe import in_words, setting_text
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Standing

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
PROBLEM = wk.Indentation(BED, wk.Force(1.0))
FORCES = Axis("problem.load.force", (1.0, 2.0, 4.0))
YOUNGS = Axis("problem.bed.medium.first.young", (1e9, 2e9))
SHAPES = Axis("problem.bed.profile", (wk.Paraboloid(1e-3), wk.Cone(1.0)))


def test_every_combination_the_last_key_fastest():
    study = Study("x", PROBLEM, sweep=(FORCES, YOUNGS))
    assert study.shape == (3, 2)
    todo = tasks(study)
    assert [task.index for task in todo] == [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)]
    assert [task.settings for task in todo][:3] == [(1.0, 1e9), (1.0, 2e9), (2.0, 1e9)]
    for task in todo:
        assert task.problem.load.force == task.settings[0]
        assert task.problem.bed.medium.first.young == task.settings[1]


def test_together():
    study = Study("x", PROBLEM, sweep=(YOUNGS, SHAPES), design=Zipped())
    assert study.shape == (2,)
    assert [task.settings for task in tasks(study)] == [(1e9, wk.Paraboloid(1e-3)), (2e9, wk.Cone(1.0))]
    assert [point.index for point in run(study).points] == [(0,), (1,)]


def test_a_sweep_in_which_one_point_yields_is_not_said_to_stay_elastic():
    medium = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=1e9))
    ball = wk.SampledProfile([0.4e-3, 0.4e-3], wk.Paraboloid(10e-3), (16, 16))
    problem = wk.SurfaceContact(ball, medium, wk.Force(1.0))
    elastic, both = (
        run(Study("x", problem, sweep=(Axis("problem.load.force", forces),))) for forces in ((1.0, 2.0), (1.0, 100.0))
    )
    for outcome, standing in ((elastic, Standing.ASYMPTOTIC), (both, Standing.OUTSIDE)):
        stated = [note for note in outcome.validity if "von Mises" in note.statement]
        assert [note.standing for note in stated] == [standing]


def test_without_a_sweep_there_is_one_point():
    outcome = run(Study("x", PROBLEM))
    assert outcome.shape == ()
    assert [point.index for point in outcome.points] == [()]
    assert outcome.answer("force").tolist() == [1.0]


def test_hertz_over_forces_and_moduli():
    """d = (9 F^2 / (16 E*^2 R))^(1/3), with E* = E / (1 - nu^2)."""
    outcome = run(Study("x", PROBLEM, sweep=(FORCES, YOUNGS)))
    force, young = np.meshgrid(FORCES.values, YOUNGS.values, indexing="ij")
    modulus = young / (1.0 - 0.25**2)
    expected = np.cbrt(9.0 * force**2 / (16.0 * modulus**2 * 1e-3))
    np.testing.assert_allclose(outcome.answer("depth")[..., 0], expected, rtol=1e-12)


def test_lists_are_swept_as_wholes():
    """Turning points of a path, each time others; the pull-off of JKR's paraboloid takes the same energy each time."""
    text = """
title = "deeper and deeper"
[problem]
kind = "adhesive_cycle"
law = { kind = "short_range", work = "50 mJ/m^2" }
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 MPa", poisson = 0.5 } }
[problem.path]
kind = "depth"
depth = ["-20 um", "-20 um"]
[sweep]
"problem.path.depth" = [["-20 um", "20 um", "-20 um"], ["-20 um", "20 um", "-20 um", "40 um"]]
"""
    study = parse_study(text)
    assert study.axes[0].values == ((-2e-5, 2e-5, -2e-5), (-2e-5, 2e-5, -2e-5, 4e-5))
    assert parse_study(study_text(study)) == study
    outcome = run(study)
    for point, depths in zip(outcome.solved, study.axes[0].values, strict=True):
        alone = dataclasses.replace(study.problem, path=wk.Depth(depths)).solve()
        assert dict(point.found)["force"] == pytest.approx(np.asarray(alone.force), rel=1e-14)
    (column, *_) = outcome.table()
    assert list(dict.fromkeys(column.content.tolist())) == ["-20, 20, -20 µm", "-20, 20, -20, 40 µm"]
    assert setting_text(study, study.axes[0], study.axes[0].values[0]) == "depth: -20, 20, -20 µm"
    assert "path.depth = -20, 20, -20 µm; -20, 20, -20, 40 µm." in in_words(study)
    with pytest.raises(InvalidInput, match="is a list; give one quantity"):
        parse_study(text.replace('path.depth" = [[', 'bed.profile.curvature_radius" = [['))


def test_a_swept_list_that_does_not_fit_its_path_is_named():
    """A loop of two turning points where the normal load and the times have three."""
    text = """
[problem]
kind = "tangential"
law = { kind = "coulomb", coefficient = 0.3 }
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 MPa", poisson = 0.5 } }
[problem.path]
kind = "path"
time = ["0 s", "1 s", "2 s"]
normal = { kind = "force", force = "1 N" }
lateral = { kind = "shear_force", shear_force = ["0 N", "0.1 N", "-0.1 N"] }
[sweep]
"problem.path.lateral.shear_force" = [["0 N", "0.1 N", "-0.1 N"], ["0 N", "0.2 N"]]
"""
    with pytest.raises(InvalidInput) as refusal:
        run(parse_study(text))
    (sentence,) = str(refusal.value).splitlines()
    assert sentence.startswith(
        "sweep: at problem.path.lateral.shear_force = 0, 200 mN: Path: lateral has the shape (2,)"
    )


def test_the_table_has_a_row_for_every_point_and_load():
    problem = wk.Indentation(BED, wk.Force(np.array([1.0, 8.0])))
    outcome = run(Study("x", problem, sweep=(YOUNGS,)))
    columns = {column.name: column for column in outcome.table()}
    assert columns[YOUNGS.key].content.tolist() == [1e9, 1e9, 2e9, 2e9]
    assert columns["force"].content.tolist() == [1.0, 8.0, 1.0, 8.0]
    assert columns["depth"].word.unit == "m"
    assert outcome.answer("depth").shape == (2, 2)
    np.testing.assert_allclose(outcome.answer("depth")[:, 1] / outcome.answer("depth")[:, 0], 4.0, rtol=1e-12)
    assert [contact.force for contact in outcome.solved[0].each] == [1.0, 8.0]


def test_exchanged_parts_are_named_in_the_table():
    outcome = run(Study("x", PROBLEM, sweep=(SHAPES,)))
    (shapes, *_) = outcome.table()
    assert shapes.word.unit is None
    assert shapes.content.tolist() == ["Paraboloid(curvature_radius=0.001)", "Cone(half_angle=1)"]


FIELDS = Fields(r=Places(np.array([0.0, 0.5, 2.0]), relative=True), z=Places(np.array([0.5, 1.0]), relative=True))


def test_fields_are_restored_for_every_load():
    problem = wk.Indentation(BED, wk.Force(np.array([1.0, 8.0])))
    (point,) = run(Study("x", problem, fields=FIELDS)).solved
    assert [fields.r.shape for fields in point.surface] == [(3,), (3,)]
    assert [fields.von_mises.shape for fields in point.subsurface] == [(3, 2), (3, 2)]
    for contact, surface in zip(point.each, point.surface, strict=True):
        np.testing.assert_allclose(surface.r, [0.0, 0.5 * contact.radius, 2.0 * contact.radius], rtol=1e-15)
        # p = p0 sqrt(1 - r^2/a^2) with p0 = 3 F / (2 pi a^2)
        greatest = 1.5 * contact.force / (math.pi * contact.radius**2)
        np.testing.assert_allclose(surface.pressure, [greatest, greatest * math.sqrt(0.75), 0.0], rtol=1e-9)


def test_places_in_lengths():
    fields = Fields(r=Places(np.array([0.0, 1e-4])))
    (point,) = run(Study("x", PROBLEM, fields=fields)).solved
    assert point.surface[0].r.tolist() == [0.0, 1e-4]
    assert point.subsurface == ()


def test_a_point_that_fails_keeps_its_reason_and_does_not_stop_the_others():
    study = Study("x", PROBLEM, sweep=(Axis("problem.load.force", (1.0, -1.0, 2.0)),))
    outcome = run(study)
    assert [type(point) for point in outcome.points] == [Solved, Failed, Solved]
    (failed,) = outcome.failed
    assert (failed.index, failed.settings, failed.code) == ((1,), (-1.0,), OutsideValidity.exit_code)
    assert "tensile" in failed.reason
    depth = outcome.answer("depth")[:, 0]
    assert np.isnan(depth).tolist() == [False, True, False]
    columns = {column.name: column.content for column in outcome.table()}
    assert columns["failure"].tolist() == ["", failed.reason, ""]
    assert np.isnan(columns["depth"]).tolist() == [False, True, False]


def test_if_nothing_can_be_solved_the_reason_is_raised():
    with pytest.raises(OutsideValidity, match=r"^force -1 N is tensile"):
        run(Study("x", wk.Indentation(BED, wk.Force(-1.0))))
    study = Study("x", PROBLEM, sweep=(Axis("problem.load.force", (-1.0, -2.0)),))
    with pytest.raises(
        OutsideValidity, match=r"^none of the 2 points of the sweep has an answer; the first: force -1 N"
    ):
        run(study)


def test_a_point_that_cannot_be_built_is_refused_before_anything_is_solved(monkeypatch):
    monkeypatch.setattr(wk.Indentation, "solve", lambda self: pytest.fail("solved"))
    study = Study("x", PROBLEM, sweep=(Axis("problem.bed.medium.first.poisson", (0.3, 0.7)),))
    with pytest.raises(InvalidInput, match=r"^sweep: at problem\.bed\.medium\.first\.poisson = 0\.7: "):
        run(study)


def test_a_problem_without_fields_says_so():
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25, strength=1e7)))
    with pytest.raises(InvalidInput, match="the answer to YieldOnset has no fields to restore"):
        run(Study("x", wk.YieldOnset(bed), fields=FIELDS))


@pytest.mark.parametrize("workers", [0, -1, 1.5, True])
def test_wrong_numbers_of_workers(workers):
    with pytest.raises(InvalidInput, match="workers is"):
        run(Study("x", PROBLEM), workers=workers)


def test_points_are_a_stream():
    """A point is handed out before the next one is solved."""
    forces = []

    class Recorded(wk.Indentation):
        def solve(self):
            forces.append(self.load.force)
            return super().solve()

    points = solve_points(Study("x", Recorded(BED, wk.Force(1.0)), sweep=(FORCES,)))
    next(points)
    assert forces == [1.0]
    next(points)
    assert forces == [1.0, 2.0]


@pytest.mark.slow
def test_a_pool_gives_the_same_numbers():
    study = Study(
        "x",
        PROBLEM,
        sweep=(FORCES, SHAPES, Axis("problem.bed.medium.first.poisson", (0.1, 0.49))),
        fields=Fields(r=FIELDS.r, z=Places(np.array([0.3, 1.0]), relative=True)),
    )
    serial, pooled = run(study), run(study, workers=2)
    assert serial.points == pooled.points
    assert serial.provenance.hash == pooled.provenance.hash


@pytest.mark.slow
def test_a_pool_keeps_failures_and_leaves_the_environment_alone():
    before = {name: os.environ.get(name) for name in THREAD_VARIABLES}
    study = Study("x", PROBLEM, sweep=(Axis("problem.load.force", (1.0, -1.0, 2.0, 3.0)),))
    assert run(study, workers=3).points == run(study).points
    assert {name: os.environ.get(name) for name in THREAD_VARIABLES} == before


SCRIPT = """
import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Axis, Study
from winkler.study.language.writing import study_text
bed = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
study = Study("x", wk.Indentation(bed, wk.Force(1.0)), sweep=(Axis("problem.load.force", (1.0, 2.0)),))
run(study, workers=2)
"""


@pytest.mark.slow
def test_a_script_without_a_guard_is_refused_in_a_sentence(tmp_path):
    """Pools start Python anew and read the script again; without a guard they would do so for ever."""
    (tmp_path / "script.py").write_text(SCRIPT)
    answer = subprocess.run([sys.executable, "script.py"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert answer.returncode != 0
    assert "if __name__ == '__main__':" in answer.stderr.splitlines()[-1]
    assert NotConverged.__name__ in answer.stderr.splitlines()[-1]


WORKER = """
import json, os, sys
from winkler.study.batch.processes import THREAD_VARIABLES, _quiet_start
import multiprocessing, signal
def look():
    deaf = signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, ())
    print(json.dumps([os.environ.get(name) for name in THREAD_VARIABLES] + [deaf]))
if __name__ == "__main__":
    worker = multiprocessing.get_context("spawn").Process(target=look)
    with _quiet_start():
        worker.start()
    worker.join()
"""


@pytest.mark.skipif(os.name == "nt", reason="dispositions of signals are inherited on POSIX only")
def test_workers_have_one_thread_and_are_deaf_to_interrupts_from_the_start(tmp_path):
    (tmp_path / "script.py").write_text(WORKER)
    answer = subprocess.run([sys.executable, "script.py"], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert json.loads(answer.stdout) == ["1"] * len(THREAD_VARIABLES) + [True]


@pytest.mark.slow
def test_the_machine_takes_over_when_a_sweep_lasts():
    """The numbers are those of one process, in the same order, wherever the others come in."""
    study = Study("x", PROBLEM, sweep=(Axis("problem.load.force", (1.0, 2.0, 3.0, 4.0, 5.0)),))
    alone = run(study)
    assert run(study, workers=Machine(patience=0.0)).points == alone.points
    assert run(study, workers=Machine(patience=60.0)).points == alone.points
    with pytest.raises(InvalidInput, match="patience is -1"):
        Machine(patience=-1.0)


class Clock:
    """Two clocks: that on the wall, and that of this process."""

    def __init__(self):
        self.wall = self.own = 0.0

    def monotonic(self):
        return self.wall

    def process_time(self):
        return self.own


@pytest.mark.parametrize(
    ("own", "wall", "count", "alone"),
    [
        (0.3e-3, 0.1, 1000, 1000),  # a busy machine: the points themselves take 0.3 s
        (0.3e-3, 0.3e-3, 3000, 3000),  # 0.9 s in all
        (0.3, 0.3, 5, 5),  # 1.5 s, and too little is left after 1.2
        (0.25, 0.25, 100, 5),  # after 1.25 s
        (0.5, 0.125, 100, 9),  # many threads in a point: 0.125 s each
        (10.0, 10.0, 3, 1),
    ],
)
def test_others_come_in_for_the_time_of_the_points_themselves(own, wall, count, alone, monkeypatch):
    """Issue 38, item 10: on a busy machine points of 0.3 ms started processes, and the sweep took twice the time."""
    clock, sent = Clock(), []

    def compute(task, watch):
        clock.wall += wall
        clock.own += own

    def completed(compute, todo, workers):
        sent.extend(todo)
        return ()

    monkeypatch.setattr(stream, "time", clock)
    monkeypatch.setattr(stream, "completed", completed)
    monkeypatch.setattr(Machine, "processors", 2)
    assert len(list(stream._computed(compute, range(count), Machine(), None))) == alone
    assert sent == list(range(alone, count))


def test_vectors_of_many_contacts_and_steps_are_split_into_their_components():
    rows, vectors = np.zeros((2, 3)), np.arange(12.0).reshape(2, 3, 2)
    found = answers_of(ContactTrace(rows, rows, vectors, rows, vectors, rows, rows))
    assert found["shear_force_x"].tolist() == [[0.0, 2.0, 4.0], [6.0, 8.0, 10.0]]
    assert found["rolling_moment_y"].tolist() == [[1.0, 3.0, 5.0], [7.0, 9.0, 11.0]]


def test_two_bounds_of_two_loads_are_no_vector_in_the_plane():
    """A band of shape (2, loads) was taken for shares along x and y where there were two loads."""
    bed = wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-4)
    rough = wk.RoughIndentation(spectrum, bed, 4e-3, wk.Force([1.0, 2.0]), realisations=3, count=256).solve()
    assert rough.depth_band.shape == (2, 2)
    assert [name for name in answers_of(rough) if "band" in name] == []


def test_a_sweep_states_the_greatest_error_of_its_points():
    """The last point had been taken among equals: 4.4 % were stated where one of three points changed by 7.8 %."""
    steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.3))
    roller = wk.RollerContact(10e-3, 10e-3, wk.RoundedEnds(0.5e-3), steel, wk.Force(1.0), elements=24)
    outcome = run(Study("x", roller, sweep=(Axis("problem.load.force", (3e3, 5e3, 2e3)),)))
    stated = [note for point in outcome.solved for note in point.validity if "half as many elements" in note.statement]
    assert len({note.standing for note in stated}) == 1
    (told,) = [note for note in outcome.validity if "half as many elements" in note.statement]
    assert told.error == max(note.error for note in stated) > stated[-1].error
