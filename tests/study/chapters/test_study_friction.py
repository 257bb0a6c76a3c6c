"""Friction in study files: paths given in steps, sweeps over them, marches that end early, tables, figures, reports."""

from __future__ import annotations

import csv
import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.io.processes.stopping import INTERRUPTED
from winkler.problems.friction.tangential import Tangential
from winkler.problems.friction.torsion import Torsion
from winkler.study.batch.marching import solve_march
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.run import run
from winkler.study.batch.sweep import solve_points
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.build import build, unbuild
from winkler.study.language.catalogue import CATALOGUE, FORMER, FORMER_PARTS
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Study
from winkler.study.language.template import template
from winkler.study.language.varied import Axis
from winkler.study.language.writing import study_text
from winkler.study.report import figures
from winkler.study.report.citing import cite
from winkler.study.report.describe import in_words, inputs
from winkler.study.report.figures import figures_of
from winkler.study.report.mathml import formula
from winkler.study.report.report import page
from winkler.values.errors import InvalidInput, OutsideValidity

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
BED = wk.Foundation(wk.Paraboloid(10e-3), STEEL)
LOOP = wk.Program(
    [
        wk.Start(wk.Force(100.0)),
        wk.Ramp(wk.Force(200.0), count=2),
        wk.Oscillate(lateral=wk.Shift(4e-7), cycles=1.25, count=8),
    ]
)
RUBBED = Tangential(BED, wk.Coulomb(0.2), LOOP)

TEXT = """title = "Loop"

[problem]
kind = "tangential"
law = { kind = "coulomb", coefficient = 0.2 }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
second = { kind = "elastic", young = "210 GPa", poisson = 0.3 }

[problem.path]
kind = "program"
steps = [
    { kind = "start", normal = { kind = "force", force = "100 N" } },
    { kind = "ramp", normal = { kind = "force", force = "200 N" }, count = 2 },
    { kind = "oscillate", lateral = { kind = "shift", shift = "0.4 um" }, cycles = 1.25, count = 8 },
]
"""


def test_a_file_says_the_same_as_python():
    study = parse_study(TEXT)
    assert study.problem == RUBBED
    assert parse_study(study_text(study)) == study
    solved, direct = run(study).solved[0], RUBBED.solve()
    assert solved.stopped == ""
    assert list(answers_of(solved.solution)) == list(answers_of(direct))
    assert np.array_equal(solved.answers["shear_force"], direct.shear_force)
    assert np.array_equal(solved.answers["dissipation"], direct.dissipation)


@pytest.mark.parametrize(
    "path",
    [
        wk.Path([0.0, 1.0, 2.0], wk.Depth(np.array([1e-6, 2e-6, 1e-6])), wk.Shift(np.array([0.0, 1e-7, 2e-7 / 3.0]))),
        wk.Path([0.0, 1.0], wk.Force(1.0), wk.ShearForce(np.array([[0.0, 1.0], [1.0 / 3.0, 2.0]]))),
        wk.Path([0.0], wk.Force(1.0), wk.Torque(0.1)),
        wk.Path.oscillation(force=10.0, amplitude=wk.Angle(1e-3), cycles=2.0),
        LOOP,
        wk.Program([wk.Start(wk.Force(1.0), wk.Angle(0.1)), wk.Hold(2.0), wk.Ramp(lateral=wk.Angle(0.0))]),
        wk.Program([wk.Start(wk.Force(1.0)), wk.Circle(wk.Shift(1e-6 / 3.0), cycles=0.3), wk.Follow(LOOP, cycles=2)]),
        wk.Program([wk.Start(wk.Force(1.0)), wk.Ramp(lateral=wk.Shift(np.array([1e-6, 2e-6])))]),
        wk.Program([wk.Start(wk.Depth(1.0)), wk.Oscillate(wk.Depth(0.1), wk.Shift(0.2), ratio=2.0, phase=0.5)]),
    ],
)
def test_paths_come_back_from_their_tables(path):
    assert build(unbuild(path), "path") == path


def test_what_is_not_stated_is_not_written():
    assert unbuild(wk.Ramp(wk.Force(2.0))) == {"kind": "ramp", "normal": {"kind": "force", "force": "2 N"}}
    assert unbuild(wk.Hold()) == {"kind": "hold"}
    assert set(unbuild(LOOP)) == {"kind", "steps"}


def test_an_infinite_coefficient_and_inertia_are_words():
    stuck = unbuild(wk.Coulomb(math.inf))
    assert stuck == {"kind": "coulomb", "coefficient": "infinite"}
    assert build(stuck, "law") == wk.Coulomb(math.inf)
    table = example_study("impact")["problem"] | {"inertia": "infinite", "lever": "0 m"}
    assert build(table).inertia == math.inf
    with pytest.raises(InvalidInput, match="poisson"):
        build({"kind": "elastic", "young": "1 GPa", "poisson": "infinite"}, "solid")


def test_steps_are_swept_by_their_number():
    study = parse_study(TEXT + '[sweep]\n"problem.path.steps.2.lateral.shift" = ["0.1 um", "0.4 um"]\n')
    assert study.sweep == (Axis("problem.path.steps.2.lateral.shift", (1e-7, 4e-7)),)
    outcome = run(study)
    first, second = (point.answers["shift"] for point in outcome.solved)
    assert (np.max(first), np.max(second)) == (1e-7, 4e-7)
    assert outcome.answer("dissipation").shape == (2, LOOP.time.size)
    assert parse_study(study_text(study)) == study


def test_what_follows_from_the_steps_is_no_key():
    with pytest.raises(InvalidInput, match=r"problem\.path\.time"):
        parse_study(TEXT + '[sweep]\n"problem.path.time.0" = ["1 s"]\n')


def test_a_path_in_a_file_lies_beside_the_study(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    rows = "\n".join(f"{t};{n};{u}" for t, n, u in zip(LOOP.time, LOOP.across, LOOP.along * 1e6, strict=True))
    (tmp_path / "loop.csv").write_text(f"time [s];force [N];shift [um]\n{rows}\n", encoding="utf-8")
    head = TEXT.partition("[problem.path]")[0]
    path = '[problem.path]\nkind = "path"\nfile = "loop.csv"\n'
    (tmp_path / "loop.toml").write_text(head + path + "[output]\nfigures = []\nreport = false\n", encoding="utf-8")
    assert main(["run", "loop.toml", "--output", "out", "--quiet"]) == 0
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    found = [float(row["shear_force [N]"]) for row in table]
    assert found == pytest.approx(RUBBED.solve().shear_force.tolist(), rel=1e-12, abs=1e-12)
    again = (tmp_path / "out" / "study.toml").read_text(encoding="utf-8")
    assert parse_study(again).problem.path.time.size == LOOP.time.size  # the points are in it


def test_a_place_among_the_rows_may_be_expected():
    expect = '[[expect]]\nquantity = "shift.{}"\nvalue = "{} um"\nscale = "1 um"\ntolerance = 1e-12\n'
    outcome = run(parse_study(TEXT + expect.format(-1, 0.4) + expect.format(0, 0.0)))
    assert [verdict.passed for verdict in outcome.verdicts] == [True, True]
    assert "shift (last)" in page(outcome, ())
    with pytest.raises(InvalidInput, match=r"'shift\.99' asks for one of 1\d numbers"):
        run(parse_study(TEXT + expect.format(99, 0.4)))
    with pytest.raises(InvalidInput, match="give an answer of the problem"):
        parse_study(TEXT + expect.replace("shift", "shaft").format(0, 0.4))


# -------------------------------------------------------------------------------------------- marches that end early

PULLED = dataclasses.replace(
    RUBBED,
    path=wk.Path.through(wk.Force(100.0), wk.ShearForce(np.array([0.0, 5.0, 10.0, 25.0, 5.0]))),
)
"""Friction bears 20 N."""


def test_what_was_reached_before_an_error_is_stored():
    march = solve_march(PULLED)
    assert march.code == OutsideValidity("").exit_code
    assert march.stopped.startswith(
        "After 3 of 5 points of the path, which are kept, the calculation ended: Tangential:"
    )
    assert np.allclose(march.solution.shear_force, [0.0, 5.0, 10.0], rtol=1e-12)
    whole = dataclasses.replace(
        PULLED, path=wk.Path.through(wk.Force(100.0), wk.ShearForce(np.array([0.0, 5.0, 10.0])))
    )
    assert np.array_equal(march.solution.shift, whole.solve().shift)


def test_an_interrupted_march_keeps_what_it_reached():
    def watch(states, total):
        assert total == LOOP.time.size
        for number, state in enumerate(states):
            if number == 4:
                raise KeyboardInterrupt
            yield state

    study = Study("", RUBBED, sweep=(Axis("problem.law.coefficient", (0.2, 0.3)),))
    points = list(solve_points(study, watch=watch))
    assert [point.code for point in points] == [INTERRUPTED]  # the next point is not begun
    assert points[0].stopped.endswith("the calculation ended: it was interrupted.")
    assert np.array_equal(points[0].answers["shear_force"], RUBBED.solve().shear_force[:4])


def test_nothing_is_stored_of_a_march_that_did_not_begin():
    def watch(states, total):
        raise KeyboardInterrupt
        yield

    with pytest.raises(KeyboardInterrupt):
        solve_march(RUBBED, watch)
    first = dataclasses.replace(PULLED, path=wk.Path.through(wk.Force(100.0), wk.ShearForce(np.array([25.0, 5.0]))))
    with pytest.raises(OutsideValidity):
        solve_march(first)


@pytest.mark.slow
def test_the_command_line_writes_what_was_reached(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    study = Study("Too much", PULLED)
    (tmp_path / "pulled.toml").write_text(study_text(study) + "\n[output]\nfigures = []\n", encoding="utf-8")
    assert main(["run", "pulled.toml", "--output", "out"]) == 4
    assert "After 3 of 5 points of the path" in capsys.readouterr().out
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == 3
    assert "Where the calculation ended early" in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")


def test_ctrl_c_ends_a_run_with_what_was_reached(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    steps = Tangential.steps

    def broken(self):
        for number, state in enumerate(steps(self)):
            if number == 3:
                raise KeyboardInterrupt
            yield state

    monkeypatch.setattr(Tangential, "steps", broken)
    (tmp_path / "loop.toml").write_text(TEXT + "[output]\nfigures = []\nreport = false\n", encoding="utf-8")
    assert main(["run", "loop.toml", "--output", "out", "--quiet"]) == 130
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) == 3


# --------------------------------------------------------------------------------------------------- tables, reports


def test_paths_in_the_plane_have_two_columns_for_each_load():
    path = wk.Program([wk.Start(wk.Depth(2e-6)), wk.Circle(wk.Shift(2e-7), cycles=0.25, count=8)])
    outcome = run(Study("", dataclasses.replace(RUBBED, path=path)))
    assert {"shift_x", "shift_y", "shear_force_x", "shear_force_y"} <= set(outcome.answers)
    assert "shift" not in outcome.answers
    assert np.allclose(outcome.answer("shift_x"), path.along[:, 0], atol=1e-20)
    assert np.allclose(outcome.answer("shift_y"), path.along[:, 1], atol=1e-20)
    assert [outcome.word(name).unit for name in ("shift_y", "shear_force_x")] == ["m", "N"]


FRICTION = ("tangential", "torsion", "friction_damping", "bimodal_damping", "relaxation_damper", "impact")


@pytest.mark.parametrize("name", [*FRICTION, "adhesive_impact", "elastic_plastic_particle"])
def test_every_kind_is_cited_described_and_has_formulas(name):
    problem = build(example_study(name)["problem"])
    study = Study("", problem)
    assert len(cite(problem)) >= 3
    if name in FRICTION:
        for one in formulas_of(problem):
            assert formula(one.latex).startswith("<math")
        assert len(formulas_of(problem)) >= 4
        message = in_words(study)
        assert "Unchanged" not in message
        assert "kept" not in message
    assert all(given.text for given in inputs(study))


def test_the_inputs_of_a_path_are_its_steps():
    message = [(given.group, given.name, given.text) for given in inputs(Study("", RUBBED))]
    assert ("step 2: ramp", "count", "2") in message
    assert ("step 3: oscillate", "cycles", "1.25") in message
    assert any("0.4 µm" in content or "400 nm" in content for _, name, content in message if name == "shift")
    assert not any(name in ("time", "normal") for _, name, _ in message)


@pytest.mark.slow
def test_figures_of_a_sweep_lay_loops_side_by_side(monkeypatch):
    monkeypatch.setattr(figures, "pictures_of", lambda contact: ("springs",))  # those of the method: one of them
    outcome = run(Study("", RUBBED, sweep=(Axis("problem.law.coefficient", (0.1, 0.2)),)))
    drawn = list(figures_of(outcome))
    assert {"answer_tangential", "answer_shear_force", "answer_dissipation"} <= {shown.name for shown in drawn}
    assert all(shown.picture is not None for shown in drawn if not shown.of_method)


@pytest.mark.slow
def test_stages_of_an_impact_are_a_table(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    problem = build(example_study("impact")["problem"])
    problem = dataclasses.replace(problem, count=11)
    text = study_text(Study("Thrown", problem)) + "\n[output]\nfigures = []\nreport = false\n"
    (tmp_path / "thrown.toml").write_text(text, encoding="utf-8")
    assert main(["run", "thrown.toml", "--output", "out", "--quiet"]) == 0
    with (tmp_path / "out" / "stages.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(problem.solve().stages)
    assert float(rows[0]["start [s]"]) == 0.0


def test_torsion_refuses_a_shift():
    table = example_study("torsion")["problem"] | {"path": unbuild(LOOP)}
    with pytest.raises(InvalidInput, match="problem: Torsion: the path prescribes a Shift"):
        build(table)
    assert isinstance(build(example_study("angle")["problem"]), Torsion)
    assert isinstance(build(example_study("torque")["problem"]), Torsion)


@pytest.mark.parametrize(
    "name", [*CATALOGUE["path"], *CATALOGUE["step"], "angle", "torque", "coulomb", "static_kinetic"]
)
def test_examples_with_every_part_of_a_path_have_an_answer(name):
    problem = build(example_study(name)["problem"])
    assert problem.solve() is not None


def test_the_command_states_what_an_interrupted_march_stored(tmp_path, monkeypatch, capsys):
    from winkler.cli import main
    from winkler.problems.friction.tangential import Tangential

    whole = Tangential.steps

    def cut(self):
        for count, state in enumerate(whole(self)):
            if count == 3:
                raise KeyboardInterrupt
            yield state

    monkeypatch.setattr(Tangential, "steps", cut)
    study, folder = tmp_path / "loop.toml", tmp_path / "loop"
    text = template("tangential") + "\n[output]\nfigures = []\nreport = false\n"
    study.write_text(text, encoding="utf-8")
    assert main(["run", str(study), "--output", str(folder)]) == 130
    message = capsys.readouterr().err.splitlines()[-1]
    assert message == f"winkler: interrupted; the points that were reached are kept in {folder}."
    assert len((folder / "results.csv").read_text(encoding="utf-8").splitlines()) >= 4


def test_a_method_is_a_word_of_a_study():
    by_springs = dataclasses.replace(RUBBED, method=wk.Method.SPRINGS)
    assert unbuild(by_springs)["method"] == "springs"
    assert build(unbuild(by_springs)) == by_springs
    assert "method" not in unbuild(RUBBED)
    with pytest.raises(wk.InvalidInput, match=r"method is 'ring' \(did you mean 'rings'\?\); give one of auto,"):
        build({**unbuild(RUBBED), "method": "ring"})


FORMER_EXAMPLES = Path(__file__).parents[2] / "golden" / "former"


@pytest.mark.parametrize("kind", FORMER)
def test_a_study_of_a_former_kind_is_that_of_today(kind, capsys):
    """Its numbers are those of before: tests/golden holds them."""
    text = (FORMER_EXAMPLES / f"{kind}.toml").read_text(encoding="utf-8")
    assert f'kind = "{kind}"' in text
    today = text.replace(f'"{kind}"', f'"{FORMER[kind]}"')
    if kind in FORMER_PARTS:
        place, kind_there, keys = FORMER_PARTS[kind]
        if kind_there:
            today = today.replace(
                "[problem.conductors]", f'[problem.{place}]\nkind = "{kind_there}"\n\n[problem.conductors]'
            )
        for key in keys:
            today = today.replace(f"[problem.{key}", f"[problem.{place}.{key}" if kind_there else f"[problem.{place}")
    assert parse_study(text).problem == parse_study(today).problem
    assert main(["show", kind]) == 0
    said = capsys.readouterr().out
    assert f'{kind} is a kind of version 0.2: studies with it still run; write kind = "{FORMER[kind]}".' in said
