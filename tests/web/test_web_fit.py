"""Fits in the app: the same numbers as on the command line, and every mistake beside its field."""

from __future__ import annotations

import dataclasses
import itertools
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
import tomli_w

from winkler.cli import main
from winkler.io.curves import read_curve
from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_grammar import fit_form as section
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.fit_study import FITTED
from winkler.study.language.reading import parsed
from winkler.values.errors import InvalidInput
from winkler.web.form import fit_form, form, measurement_form
from winkler.web.form.sample_curve import SAMPLE, sample_curve
from winkler.web.form.study_form import StudyForm
from winkler.web.form.typed import typed
from winkler.web.pictures.fitted import MOST_POINTS, drawn_points
from winkler.web.pictures.replies import AnswerText, DrawnSheet, InteractivePicture, MomentComplete
from winkler.web.session.upload_folder import UploadFolder, files_in
from winkler.web.session.worker import Export, Look, Solve, Wrong, _WorkerState, beside_the_curve

EXAMPLES = Path(__file__).parents[2] / "examples"
YOUNG = "problem.bed.medium.first.young"


@pytest.fixture(scope="module")
def bench():
    return _WorkerState()


@pytest.fixture
def folder_(tmp_path):
    shutil.copy(EXAMPLES / "data" / "gel_bead.csv", tmp_path / "gel_bead.csv")
    return tmp_path


def gel_table():
    """The study of the example, with the curve beside it as an upload lies there."""
    table = parsed((EXAMPLES / "studies" / "fitting" / "fit_gel.toml").read_text(encoding="utf-8"), "fit_gel.toml")
    form.put(table, "fit.curve", "gel_bead.csv")
    return table


def solved(bench, table, folder):
    return list(bench.replies(Solve(1, tomli_w.dumps(table), folder, True)))


@pytest.mark.slow
def test_the_app_and_the_command_line_fit_equal_numbers(bench, folder_, tmp_path):
    answer, *others = solved(bench, gel_table(), folder_)
    pictures = [one for one in others if isinstance(one, InteractivePicture)]
    (frame,) = (one for one in others if isinstance(one, MomentComplete))
    (file,) = bench.replies(Export(2, "csv"))
    plain = {**gel_table(), "output": {"report": False, "figures": []}}
    (folder_ / "study.toml").write_text(tomli_w.dumps(plain), encoding="utf-8")
    folder = tmp_path / "by_command"
    assert main(["fit", str(folder_ / "study.toml"), "--output", str(folder), "--quiet"]) == 0
    assert file.content == (folder / "fit.csv").read_bytes()
    assert isinstance(answer, AnswerText)
    assert "3.99 kPa" in answer.answers
    assert answer.standing == "approximate"
    assert [one.name for one in pictures][:2] == ["fit", "shape"]
    assert frame.total == len(pictures) == 7
    assert frame.remark


@pytest.mark.slow
def test_the_picture_holds_the_curve_and_what_is_left_over(bench, folder_):
    _, first, *_ = solved(bench, gel_table(), folder_)
    chart = json.loads(first.chart)
    fit = bench.outcome.fitted[0].fit
    curve = read_curve(folder_ / "gel_bead.csv")
    dots, law, left = chart["data"][:3]
    scale = 1e9  # to nN
    assert np.sort(dots["y"]) == pytest.approx(np.sort(curve.force) * scale, rel=1e-6, abs=1e-6)
    assert np.sort(left["y"]) == pytest.approx(np.sort(curve.force - fit.predicted) * 1e12, rel=1e-4, abs=1e-4)
    assert law["name"] == "fitted"
    assert np.sort(law["y"]) == pytest.approx(np.sort(fit.predicted) * scale, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize(
    ("path", "content", "owner", "part"),
    [
        ("fit.curve", "spoilt.csv", "fit.curve", "no table of a force curve"),
        ("fit.part", "in", "fit.part", "approach or hold"),
        ("fit.noise", "3 kg", "fit.noise", "mass"),
        ("problem.bed.medium.first.young", "1 kg", YOUNG, "mass"),
        ("fit.free", {YOUNG: ["10 N", "1 Pa"]}, f"fit.free.{YOUNG}.0", "force"),
        ("fit.free", {YOUNG: ["2 Pa", "1 Pa"]}, f"fit.free.{YOUNG}", "not below"),
        ("fit.free", {YOUNG: True, "problem.bed.medium.first.poisson": True}, "fit.free", "only a combination"),
        ("fit.free", {}, "fit.free", "empty"),
    ],
)
def test_every_mistake_names_its_field(bench, folder_, path, content, owner, part):
    (folder_ / "spoilt.csv").write_text("nothing to fit", encoding="utf-8")
    table = gel_table()
    form.put(table, path, content)
    (wrong,) = solved(bench, table, folder_)
    assert isinstance(wrong, Wrong)
    assert part in wrong.sentences[0]
    assert form.owner_of(wrong.sentences[0]) == owner


def test_many_curves_are_looked_at_one_by_one(bench, tmp_path):
    for place in (1, 2, 3):
        free_numbers = (EXAMPLES / "data" / "gel_bead.csv").read_text(encoding="utf-8").splitlines()
        (tmp_path / f"c{place}.csv").write_text("\n".join(free_numbers[: 4 + 100 * place]), encoding="utf-8")
    table = gel_table()
    form.put(table, "fit.curve", "c[23].csv")
    *progress, answer, values, first = itertools.islice(solved(bench, table, tmp_path), 5)
    assert [(one.done, one.total) for one in progress] == [(1, 2), (2, 2)]
    assert answer.moments == 2
    assert (values.name, first.name) == ("values", "fit")
    assert first.title.endswith("c2.csv")
    _, looked, *_, last = bench.replies(Look(2, 1))
    assert looked.title.endswith("c3.csv")
    assert isinstance(last, MomentComplete)


@pytest.mark.parametrize("kind", FITTED)
def test_what_a_fit_begins_with_can_be_read(kind, folder_):
    table = fit_form.initial_table(kind)
    form.put(table, "fit.curve", "gel_bead.csv")
    study = parse_fit_study(tomli_w.dumps(table), folder=folder_)
    free_numbers, others = fit_form.free_numbers(table)
    assert [line.key for line in free_numbers] == [free.key for free in study.free]
    assert all(line.word.meaning for line in free_numbers)
    assert others
    assert not set(others) & {line.key for line in free_numbers}
    for key in others:  # whatever may be chosen can be free
        table["fit"]["free"] = {key: True}
        parse_fit_study(tomli_w.dumps(table), folder=folder_)


@pytest.mark.parametrize(
    ("low", "high", "unit", "content"),
    [
        ("", "", "Pa", True),
        ("1 kPa", "", "Pa", "1 kPa"),
        ("1 kPa", "1 MPa", "Pa", ["1 kPa", "1 MPa"]),
        ("0.1", "0.4", "", [0.1, 0.4]),
        ("", "1 MPa", "Pa", ["", "1 MPa"]),
    ],
)
def test_bounds(low, high, unit, content):
    assert fit_form.bounds(low, high, unit) == content


def test_both_studies_are_unchanged_while_one_turns():
    calls = []
    entered = StudyForm(lambda: calls.append("form"), lambda: calls.append("solve"))
    entered.change("problem.load.force", "3 N", "quantity [N]")
    entered.switch_task("fit")
    entered.bound(YOUNG, "1 Pa", "1 MPa", "Pa")
    entered.free("problem.bed.profile.curvature_radius")
    entered.fix("baseline")
    free = {YOUNG: ["1 Pa", "1 MPa"], "contact_point": True}
    assert form.at(entered.table, "fit.free") == {**free, "problem.bed.profile.curvature_radius": True}
    entered.choose("problem.bed.profile", "cone")  # has no radius
    assert form.at(entered.table, "fit.free") == free
    entered.switch_task("solve")
    assert form.at(entered.table, "problem.load.force") == "3 N"
    entered.switch_task("solve")
    assert calls == ["solve", "form", "solve", "form", "form", "form", "form"]


def test_the_curve_stays_when_the_model_changes():
    entered = StudyForm(lambda: None, lambda: None)
    entered.switch_task("fit")
    entered.read_curve("gel.csv")
    entered.choose("problem", "adhesive_indentation")
    assert form.at(entered.table, "fit.curve") == "gel.csv"
    assert form.at(entered.table, "problem.kind") == "adhesive_indentation"
    assert list(files_in(entered.table)) == [("fit.curve", "gel.csv")]


def test_another_curve_leaves_the_form_as_it_is():
    """A form that were made anew when an upload arrives would lose bounds that are being typed."""
    calls = []
    entered = StudyForm(lambda: calls.append("form"), lambda: calls.append("solve"))
    entered.switch_task("fit")
    entered.read_curve("gel.csv")
    assert form.at(entered.table, "fit.curve") == "gel.csv"
    assert calls == ["form", "solve"]


def test_the_guess_of_a_radius_is_said_until_one_is_entered():
    table = fit_form.initial_table(FITTED[0])
    assert "5 um, is a guess" in fit_form.model_remark(table)
    form.put(table, "problem.bed.profile.curvature_radius", "4 um")
    assert "guess" not in fit_form.model_remark(table)


def test_a_study_and_its_curve_travel_together(folder_):
    uploads = UploadFolder()
    text = tomli_w.dumps(gel_table())
    uploads.keep("gel_bead.csv", (folder_ / "gel_bead.csv").read_bytes())
    store = uploads.packed(text, "study.toml", ("gel_bead.csv",))
    other = UploadFolder()
    assert other.unpack(store, "study.toml").decode() == text
    assert other.names == ("gel_bead.csv",)
    other.check(gel_table())
    with pytest.raises(InvalidInput, match="upload a measured curve"):
        other.check({"fit": {"curve": ""}})
    with pytest.raises(InvalidInput, match="uploaded files only"):
        other.check({"fit": {"curve": "../../etc/*"}})
    with pytest.raises(InvalidInput, match=r"no study\.toml"):
        other.unpack(uploads.packed("", "else.toml", ()), "study.toml")
    with pytest.raises(InvalidInput, match="cannot be read"):
        other.unpack(b"PK\x03\x04 spoilt", "study.toml")
    uploads.close()
    other.close()


def test_the_form_begins_with_a_curve_that_can_be_fitted(folder_):
    (folder_ / SAMPLE).write_bytes(sample_curve())
    table = fit_form.initial_table(FITTED[0])
    form.put(table, "fit.curve", SAMPLE)
    found = fit_study(parse_fit_study(tomli_w.dumps(table), folder=folder_)).fitted[0].fit
    low, high = found.interval("bed.medium.first.young")
    assert low < 4e3 < high < 1.02 * 4e3
    assert found.flags == ()


def test_only_so_many_points_are_drawn():
    assert drawn_points(10).tolist() == list(range(10))
    some = drawn_points(100_000)
    assert some.size == MOST_POINTS
    assert some[-1] == 99_999


def test_whose_fault_it_is():
    assert beside_the_curve("gel.csv: it never touches.") == "fit.curve: gel.csv: it never touches."


ALL_KEYS = {
    "segments": ["loading 0", "unloading 200"],
    "events": ["baseline 0 to 20"],
    "spring_constant": "0.04 N/m",
    "sensitivity": "50 nm/V",
    "units": {"position": "nm", "force": "nN"},
    "columns": {"position": 1, "force": 2},
    "frame_stiffness": "1 MN/m",
    "correct": ["baseline"],
    "noise": "10 pN",
    "noise_spectrum": "white",
    "time_limit": "2 min",
    "spring_constant_error": "8 %",
    "sensitivity_error": 0.02,
    "spring_constant_by": "thermal",
    "over_depth": 4,
    "shared": [YOUNG],
    "model": "ball",
    "models": {
        "cone": {"problem.bed.profile": {"kind": "cone", "half_angle": "60 deg"}},
        "free ball": {"free": {YOUNG: ["1 Pa", "1 MPa"]}},
    },
}


def measured(table):
    """All entries and choices of a measurement, by path."""
    found = measurement_form.groups(table)
    entries = {entry.path: entry for group in found for entry in group.entries}
    picks = [one for group in found for one in group.choices]
    return entries, {one.path: one for one in (*picks, *measurement_form.choices(table))}


def test_all_keys_of_a_fit_have_a_field():
    table = fit_form.initial_table(FITTED[-1])
    entries, picks = measured(table)
    shown = {path.split(".")[1] for path in (*entries, *picks)}
    assert shown | {"curve", "free"} == set(section().model_fields)
    assert all(entry.hint for entry in entries.values())


def test_what_the_form_shows_comes_back_unchanged(folder_):
    table = gel_table()
    table["fit"] |= ALL_KEYS
    before = tomli_w.dumps(table)
    entries, picks = measured(table)
    for path, entry in entries.items():
        if entry.text:
            form.put(table, path, typed(entry.text, entry.takes))
    for path, pick in picks.items():
        assert pick.chosen == form.at(table, path)
    read, expected = (parse_fit_study(text, folder=folder_) for text in (tomli_w.dumps(table), before))
    assert dataclasses.replace(read, text="") == dataclasses.replace(expected, text="")


def test_units_are_typed_and_removed_one_by_one():
    entered = StudyForm(lambda: None, lambda: None)
    entered.switch_task("fit")
    entered.change("fit.units.force", "nN", "text")
    entered.change("fit.units.position", "nm", "text")
    assert form.at(entered.table, "fit.units") == {"force": "nN", "position": "nm"}
    entered.change("fit.units.force", "", "text")
    entered.change("fit.units.position", "", "text")
    assert "units" not in entered.table["fit"]


def test_the_measurement_stays_when_the_model_changes():
    entered = StudyForm(lambda: None, lambda: None)
    entered.switch_task("fit")
    entered.table["fit"] |= ALL_KEYS
    entered.choose("problem", "viscoelastic_indentation")
    left = {"over_depth", "shared", "model", "models"}
    assert {name for name in ALL_KEYS if name in entered.table["fit"]} == set(ALL_KEYS) - left


@pytest.mark.slow
def test_depths_models_and_events_stand_on_the_page(bench, folder_):
    table = gel_table()
    table["fit"] |= {"over_depth": 3, "models": {"cone": ALL_KEYS["models"]["cone"]}}
    answer, *others = solved(bench, table, folder_)
    assert "More from the curves" in answer.answers
    assert "<td>cone</td><td>excluded</td>" in answer.answers
    titles = [one.title for one in others if isinstance(one, DrawnSheet)]
    name = "gel_bead.csv"
    assert titles == [f"Over depth: {name}", f"Models: {name}", f"{name}: what was done", titles[-1]]
    assert "noise" in titles[-1].lower() or "residual" in titles[-1].lower()
    assert all(one.svg for one in others if isinstance(one, DrawnSheet))


@pytest.mark.slow
def test_the_headline_holds_the_error_of_the_calibration(bench, folder_):
    """The interval of 95 % under 8 % of error is at least 1.96 * 8 % wide to either side of 3.99 kPa."""
    table = gel_table()
    table["fit"] |= {"spring_constant_error": "8 %"}
    answer, *_ = solved(bench, table, folder_)
    low, high = re.search(r"95 %:\D*([\d.]+)\D+?([\d.]+)", re.sub(r"<[^>]*>", " ", answer.answers)).groups()
    assert 3.0 < float(low) < 3.99 * 0.87
    assert 3.99 * 1.14 < float(high) < 5.0
