"""Studies on bodies that stick: read from files, swept, written down again, stored with their jumps, and reported."""

from __future__ import annotations

import csv
import json
import math

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.plot.adhesion.cycles import contact_of
from winkler.study.batch.events import EVENTS, events_of
from winkler.study.batch.run import run
from winkler.study.chapters.contents import formulas_of
from winkler.study.language.keys import replaced
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Output, Study
from winkler.study.language.varied import Axis
from winkler.study.language.writing import study_text
from winkler.study.report import figures
from winkler.study.report.figure import ReportFigure
from winkler.study.report.figures import figures_of
from winkler.study.report.headline.shown_contact import shown_contact, shown_point
from winkler.study.report.mathml import formula
from winkler.study.report.report import page

RUBBER = wk.HalfSpace.between(wk.Elastic(1e6, 0.5))
BED = wk.Foundation(wk.Paraboloid(1e-3), RUBBER)
LAW = wk.ShortRange(0.05)
DUGDALE = wk.Dugdale(0.05, 3e4)
FAR = wk.DerjaguinMullerToporov(0.05)
PATH = wk.Depth(np.array([-2e-5, 2e-5, -6e-5]))
HEAD = """
[problem]
kind = "{kind}"
{keys}
[problem.bed]
kind = "foundation"
profile = {{ kind = "paraboloid", curvature_radius = "1 mm" }}
medium = {{ kind = "half_space", first = {{ kind = "elastic", young = "1 MPa", poisson = 0.5 }} }}
[problem.law]
kind = "short_range"
work = "50 mJ/m^2"
"""
QUESTIONS = {
    "indentation": wk.AdhesiveIndentation(BED, LAW, wk.Force(0.0)),
    "ring": wk.AdhesiveIndentation(BED, DUGDALE, wk.Force(0.0)),
    "far": wk.AdhesiveIndentation(BED, FAR, wk.Force(0.0)),
    "pull-off": wk.PullOff(BED, LAW, machine_stiffness=math.inf),
    "equilibrium": wk.Equilibrium(BED, LAW, reach=2e-4, count=60),
    "cycle": wk.AdhesiveCycle(BED, LAW, PATH, machine_stiffness=50.0),
    "shear": wk.AdhesiveShear(BED, LAW, wk.Force(0.0), wk.ShearForce(np.array([0.0, 1e-4]))),
}
BARE = Output(figures=(), report=False)


def text(kind, keys=""):
    return HEAD.format(kind=kind, keys=keys)


@pytest.mark.parametrize("problem", QUESTIONS.values(), ids=QUESTIONS)
def test_a_study_is_written_down_and_read_again(problem):
    study = Study("sticks", problem)
    assert parse_study(study_text(study)) == study


def test_fixed_grips_are_written_as_a_word():
    study = parse_study(text("pull_off", 'machine_stiffness = "infinite"'))
    assert study.problem == QUESTIONS["pull-off"]
    assert 'machine_stiffness = "infinite"' in study_text(study)


def test_a_machine_of_growing_stiffness_up_to_fixed_grips():
    study = parse_study(text("pull_off") + '[sweep]\n"problem.machine_stiffness" = ["0 N/m", "50 N/m", "infinite"]\n')
    assert parse_study(study_text(study)) == study
    force = run(study).answer("force").ravel() / (math.pi * 1e-3 * 0.05)
    assert force[[0, 2]] == pytest.approx([-3 / 2, -5 / 6], rel=1e-9)
    assert force[0] < force[1] < force[2]


@pytest.mark.parametrize(
    ("law", "key", "expected"),
    [
        (LAW, "work", wk.ShortRange(0.02)),
        (LAW, "work_closing", wk.ShortRange(work_closing=0.02, work_opening=0.05)),
        (
            wk.ShortRange(work_closing=0.01, work_opening=0.05),
            "work",
            wk.ShortRange(work_closing=0.01, work_opening=0.02),
        ),
        (wk.ShortRange(work_closing=0.01, work_opening=0.05), "work_opening", wk.ShortRange(0.02, 0.01)),
    ],
)
def test_the_works_of_a_law_are_varied_one_by_one(law, key, expected):
    assert replaced(wk.PullOff(BED, law), f"law.{key}", 0.02).law == expected


def test_a_path_may_go_there_and_back_by_ranges():
    there = '{ from = "-20 um", to = "20 um", count = 3 }'
    study = parse_study(text("adhesive_cycle", f'path = {{ kind = "depth", depth = [{there}, "5 um", "-60 um"] }}'))
    assert study.problem.path.depth == pytest.approx([-2e-5, 0.0, 2e-5, 5e-6, -6e-5], abs=1e-18)


def test_a_sweep_takes_no_range_among_its_values():
    wrong = (
        text("pull_off")
        + '[sweep]\n"problem.law.work" = ["1 mJ/m^2", { from = "1 J/m^2", to = "2 J/m^2", count = 2 }]\n'
    )
    with pytest.raises(wk.InvalidInput, match=r"work\S* is a table; give one quantity"):
        parse_study(wrong)


def test_rows_of_a_curve_are_its_points_and_nothing_else():
    outcome = run(Study("curve", QUESTIONS["equilibrium"]))
    solution = outcome.points[0].solution
    assert set(outcome.answers) == {"radius", "depth", "force", "stable"}
    assert outcome.answer("radius").tolist() == solution.radius.tolist()
    assert outcome.answer("stable").tolist() == solution.stable.astype(float).tolist()
    assert 0 < np.sum(outcome.answer("stable")) < solution.radius.size


def test_curves_of_different_lengths_stand_side_by_side():
    bent = wk.Equilibrium(wk.Foundation(wk.Paraboloid(10e-3) + wk.Wavy(1e-6, 1e-4), RUBBER), LAW, 6e-4, count=60)
    study = Study("waves", bent, sweep=(Axis("problem.machine_stiffness", (0.0, math.inf)),))
    outcome = run(study)
    lengths = [point.solution.radius.size for point in outcome.solved]
    assert lengths[0] != lengths[1]
    assert outcome.answer("force").shape == (2, max(lengths))
    rows = {column.name: column.content for column in outcome.table()}
    assert rows["radius"].size == sum(lengths)


@pytest.mark.slow
def test_jumps_branches_and_limits_are_stored(tmp_path):
    import xarray

    for name, question in (("jumps", "cycle"), ("branches", "equilibrium"), ("limit", "shear")):
        problem = QUESTIONS[question]
        folder = tmp_path / name
        (tmp_path / f"{name}.toml").write_text(study_text(Study("kept", problem, output=BARE)), encoding="utf-8")
        assert main(["run", str(tmp_path / f"{name}.toml"), "--quiet", "--output", str(folder)]) == 0
        solution = problem.solve()
        message = getattr(solution, name)
        items = message if isinstance(message, tuple) else (message,)
        with (folder / f"{name}.csv").open(encoding="utf-8") as file:
            rows = list(csv.reader(file))
        events = events_of(solution, name)
        assert rows[0] == [f"{one.name} [{one.word.unit}]" for one in events[0]]
        assert [[float(item) for item in row] for row in rows[1:]] == [[one.content for one in row] for row in events]
        assert len(rows) == len(items) + 1
        with xarray.open_dataset(folder / "results.nc", engine="h5netcdf") as data:
            for place, one in enumerate(events[0]):
                assert data[f"{name}_{one.name}"].values.tolist() == [row[place].content for row in events]
    assert set(EVENTS) == {"jumps", "branches", "limit", "stages", "onsets"}  # the last two of impacts, and of yield
    jump = QUESTIONS["cycle"].solve().jumps[1]
    events = {one.name: one.content for one in events_of(QUESTIONS["cycle"].solve(), "jumps")[1]}
    assert events["before_force"] == jump.before.force
    assert events["after_radius"] == jump.after.radius == 0.0
    assert events["loss"] == jump.loss


def test_the_contact_of_a_report_is_one_that_sticks():
    """The springs at its edge are stretched by what Griffith's balance says."""
    for name in ("indentation", "pull-off", "equilibrium"):
        contact = shown_contact(shown_point(run(Study(name, QUESTIONS[name]))))
        stretch = math.sqrt(2.0 * math.pi * contact.radius * 0.05 / RUBBER.modulus)
        assert -contact.pressed.edge == pytest.approx(stretch, rel=1e-9)
        assert contact.force == pytest.approx(
            2.0 * RUBBER.modulus * (contact.depth * contact.radius - contact.radius**3 / 3e-3), rel=1e-9, abs=1e-15
        )
    widest = contact_of(QUESTIONS["cycle"].solve())
    assert widest.radius == np.max(QUESTIONS["cycle"].solve().radius)


def test_a_cycle_that_never_touches_shows_no_contact():
    apart = wk.AdhesiveCycle(BED, LAW, wk.Depth(np.array([-2e-5, -1e-5, -2e-5])))
    outcome = run(Study("apart", apart))
    assert shown_contact(shown_point(outcome)) is None
    assert "no pictures of the method for AdhesiveCycle" in page(outcome, ())


def quiet(monkeypatch):
    """Draw nothing: what is requested is the page."""
    monkeypatch.setattr(
        figures, "drawn", lambda name, title, sentence, picture: ReportFigure(name, title, sentence, None)
    )


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("name", QUESTIONS)
def test_figures_of_a_report(name, monkeypatch):
    quiet(monkeypatch)
    shown = figures_of(run(Study(name, QUESTIONS[name])))
    assert [one.name for one in shown if one.missing] == []
    names = {one.name for one in shown}
    assert {"springs", "pressure", "shape"} <= names
    whole = {"pull-off": "answer_pull_off", "equilibrium": "answer_equilibria", "cycle": "answer_cycle"}
    whole["shear"] = "answer_shear"
    assert whole.get(name, "force") in names
    assert ("force" in names) == (name not in whole)
    assert "stretched" in next(one.sentence for one in shown if one.name == "springs")


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_report_has_formulas_and_tables(name):
    problem = QUESTIONS[name]
    outcome = run(Study(name, problem))
    assert all(formula(one.latex).startswith("<math") for one in formulas_of(problem))
    says = " ".join(one.says for one in formulas_of(problem))
    assert ("cohesive zone ends" in says) == (name == "ring")
    assert ("Long-range attraction" in says) == (name == "far")
    assert ("under shear" in says) == (name == "shear")
    assert "the outermost spring is zero" not in says
    html = page(outcome, ())
    for attribute, title in EVENTS.items():
        assert (f"<h3>{title}</h3>" in html) == bool(events_of(outcome.points[0].solution, attribute))


def test_a_load_below_the_pull_off_is_refused_by_name(tmp_path, capsys):
    load = 'load = { kind = "force", force = ["0 N", "-300 uN"] }'
    (tmp_path / "study.toml").write_text(text("adhesive_indentation", load), encoding="utf-8")
    assert main(["run", str(tmp_path / "study.toml"), "--output", str(tmp_path / "answer")]) == 4
    message = capsys.readouterr().err
    assert "below the pull-off" in message
    assert "-0.000235619" in message  # 3/2 pi R w
    assert "index 1" in message
    assert not (tmp_path / "answer").exists()


def test_a_sweep_keeps_what_holds(tmp_path, capsys):
    load = 'load = { kind = "force", force = "-200 uN" }'
    sweep = '[sweep]\n"problem.law.work" = ["20 mJ/m^2", "50 mJ/m^2"]\n[output]\nfigures = []\nreport = false\n'
    (tmp_path / "study.toml").write_text(text("adhesive_indentation", load) + sweep, encoding="utf-8")
    assert main(["run", str(tmp_path / "study.toml"), "--json", "--output", str(tmp_path / "answer")]) == 4
    message = {one["name"]: one["values"] for one in json.loads(capsys.readouterr().out)["answers"]}
    assert message["stable"][1] == 1.0
