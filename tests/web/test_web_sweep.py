"""Sweeps in the app: rows of the form are lines of [sweep], and the numbers are those of the command line."""

from __future__ import annotations

import csv
import io

import pytest
import tomli_w

from winkler.study.batch.run import run
from winkler.study.language.designs import DESIGNS
from winkler.study.language.reading import parse_study
from winkler.web.form import form, sweep_form
from winkler.web.form.study_form import StudyForm
from winkler.web.pictures.replies import AnswerText, DrawnSheet, MomentComplete
from winkler.web.session.worker import MOST_POINTS, Export, Progress, Solve, Wrong, _WorkerState

FORCE, RADIUS, POISSON = (
    "problem.load.force",
    "problem.bed.profile.curvature_radius",
    "problem.bed.medium.first.poisson",
)


@pytest.fixture(scope="module")
def bench():
    return _WorkerState()


def varied_study(*keys, kind="crossed"):
    """Return the table of a sweep as a person would make it."""
    entered = StudyForm(lambda: None, lambda: None)
    for key in keys:
        entered.vary(key)
    entered.choose_design(kind)
    return entered


def first_of(bench, text, folder):
    """Yield the parts of an answer up to its first sheet."""
    for reply in bench.replies(Solve(1, text, folder, True)):
        yield reply
        if isinstance(reply, DrawnSheet):
            return


def test_a_number_varies_about_what_it_was():
    entered = varied_study(FORCE, POISSON)
    assert entered.table["sweep"] == {
        FORCE: {"from": "50 N", "to": "200 N", "count": 5},
        POISSON: {"from": 0, "to": 0.49, "count": 5},
    }
    study = parse_study(tomli_w.dumps(entered.table))
    assert study.shape == (5, 5)
    assert study.axes[0].values == (50.0, 87.5, 125.0, 162.5, 200.0)


@pytest.mark.parametrize(
    ("spacing", "texts", "values"),
    [
        ("even", {"from": "10 N", "to": "30 N", "count": "3"}, (10.0, 20.0, 30.0)),
        ("ratio", {"from": "1 N", "to": "100 N", "count": "3"}, (1.0, 10.0, 100.0)),
        ("list", {"values": "3 N, 1 N, 2 N"}, (3.0, 1.0, 2.0)),
        ("even", {"values": "3 N, 4 N, 5 N"}, (3.0, 4.0, 5.0)),
    ],
)
def test_what_stands_in_the_boxes_is_what_is_solved(spacing, texts, values):
    entered = varied_study(FORCE)
    entered.vary_over(FORCE, spacing, texts, anew=True)
    study = parse_study(tomli_w.dumps(entered.table))
    assert study.axes[0].values == pytest.approx(values, rel=1e-12)
    ((row,), others) = sweep_form.rows(entered.table)
    assert row.spacing == spacing
    again = varied_study(FORCE)
    again.vary_over(FORCE, row.spacing, row.texts, anew=True)
    assert again.table == entered.table
    assert FORCE not in others
    assert RADIUS in others


@pytest.mark.parametrize("kind", DESIGNS)
def test_every_design_can_be_chosen_and_left(kind):
    entered = varied_study(FORCE, RADIUS, kind=kind)
    assert sweep_form.design_kind(entered.table) == kind
    study = parse_study(tomli_w.dumps(entered.table))
    assert study.design.kind == kind
    assert set(sweep_form.DESIGN_LABELS) == set(DESIGNS)
    counts = {"crossed": 25, "zipped": 5, "latin_hypercube": 64, "sobol": 64, "sensitivity": 64 * 4}
    points = 1
    for length in study.shape:
        points *= length
    assert points == counts[kind]
    entered.choose_design("crossed")
    assert parse_study(tomli_w.dumps(entered.table)).shape == (5, 5)


def test_without_a_number_there_is_no_sweep():
    entered = varied_study(FORCE, RADIUS, kind="sobol")
    entered.hold_constant(FORCE)
    assert list(entered.table["sweep"]) == ["design", RADIUS]
    entered.choose("problem.bed.profile", "cone")  # has no radius
    assert "sweep" not in entered.table


def test_the_app_and_the_command_line_sweep_equal_numbers(bench, tmp_path):
    entered = varied_study(FORCE, RADIUS, kind="sobol")
    form.put(entered.table, "sweep.design.count", 8)
    text = tomli_w.dumps(entered.table)
    replies = [reply for reply in first_of(bench, text, tmp_path) if not isinstance(reply, Progress)]
    answer, *_, frame, sheet = replies
    assert isinstance(answer, AnswerText)
    assert answer.points == 8
    assert isinstance(frame, MomentComplete)
    assert "the last point of the sweep" in frame.remark
    assert isinstance(sheet, DrawnSheet)
    assert sheet.title == "Depth over what was varied"
    (file,) = bench.replies(Export(2, "csv"))
    rows = list(csv.DictReader(io.StringIO(file.content.decode())))
    expected = run(parse_study(text))
    for name in ("depth [m]", "radius [m]"):
        assert [float(row[name]) for row in rows] == expected.answer(name.split()[0]).ravel().tolist()
    (archive,) = bench.replies(Export(3, "netcdf"))
    assert archive.name == "results.nc"


def test_progress_is_reported_and_rises(bench, tmp_path, monkeypatch):
    monkeypatch.setattr("winkler.web.session.worker.PROGRESS_INTERVAL", 0.0)
    text = tomli_w.dumps(varied_study(FORCE).table)
    replies = bench.replies(Solve(1, text, tmp_path, True))
    assert [next(replies) for _ in range(5)] == [Progress(done, 5) for done in range(1, 6)]
    assert isinstance(next(replies), AnswerText)


def test_too_many_points_are_refused(bench, tmp_path):
    entered = varied_study(FORCE, RADIUS)
    entered.vary_over(FORCE, "even", {"from": "1 N", "to": "2 N", "count": "101"}, anew=False)
    entered.vary_over(RADIUS, "even", {"from": "1 mm", "to": "2 mm", "count": "10"}, anew=False)
    (wrong,) = bench.replies(Solve(1, tomli_w.dumps(entered.table), tmp_path, True))
    assert isinstance(wrong, Wrong)
    (sentence,) = wrong.sentences
    assert f"1010 points, and the app solves at most {MOST_POINTS}" in sentence
    assert form.owner_of(sentence) == "sweep"


@pytest.mark.parametrize(
    ("key", "content", "owner"),
    [
        (FORCE, {"from": "1 kg", "to": "2 N", "count": 3}, f"sweep.{FORCE}.from"),
        (FORCE, {"from": "1 N", "count": 3}, f"sweep.{FORCE}.to"),
        (FORCE, {"from": "1 N", "to": "2 N", "count": 2.5}, f"sweep.{FORCE}.count"),
        (FORCE, ["1 N", "2 kg"], f"sweep.{FORCE}.1"),
        (FORCE, [], f"sweep.{FORCE}"),
        ("design", {"kind": "sobol", "count": 60, "seed": 0}, "sweep.design.count"),
        (POISSON, {"from": 0.1, "to": 0.9, "count": 3}, "sweep"),
    ],
)
def test_every_mistake_of_a_sweep_names_its_field(bench, tmp_path, key, content, owner):
    entered = varied_study(FORCE)
    entered.table["sweep"][key] = content
    (wrong,) = bench.replies(Solve(1, tomli_w.dumps(entered.table), tmp_path, True))
    assert isinstance(wrong, Wrong)
    assert form.owner_of(wrong.sentences[0]) == owner, wrong.sentences[0]
