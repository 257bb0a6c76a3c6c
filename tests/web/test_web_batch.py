"""A folder of curves in the app: the command line's numbers, a row for each file, a stop that keeps what was fitted."""

from __future__ import annotations

import json
import math
import re

import numpy as np
import pytest
import tomli_w

from winkler.cli import main
from winkler.io.curves import read_curves
from winkler.values.errors import InvalidInput
from winkler.web.form import fit_form, form
from winkler.web.form.sample_folder import sample_folder
from winkler.web.pictures.replies import AnswerText, InteractivePicture, MomentComplete
from winkler.web.session.upload_folder import CURVES, SAMPLE_CURVES, UploadFolder
from winkler.web.session.worker import Export, Halt, Look, Progress, Solve, _WorkerState

COUNT = 6
"""Curves of the sample that are fitted here, and its file that is none."""


@pytest.fixture(scope="module")
def bench():
    return _WorkerState()


@pytest.fixture
def folder(tmp_path):
    uploads = UploadFolder(tmp_path)
    files = [*sample_folder()]
    for name, content in (*files[1:5], *files[6:8], files[-1]):
        uploads.keep(name, content, CURVES)
    yield uploads
    uploads.close()


def study(title="inclusion"):
    table = fit_form.initial_table("indentation") | {"title": title, "output": {"report": False, "figures": []}}
    form.put(table, "problem.bed.profile", {"kind": "paraboloid", "curvature_radius": "5 um"})
    form.put(table, "fit.curve", CURVES)
    form.put(table, "fit.free", {"problem.bed.medium.first.young": True, "contact_point": True})
    return table


def until_pictures(replies):
    """Return the replies without the sheets, which are those of the report."""
    kept = []
    for one in replies:
        kept.append(one)
        if isinstance(one, MomentComplete):
            break
    return kept


@pytest.mark.slow
def test_a_folder_is_fitted_as_by_the_command_line(bench, folder, tmp_path):
    replies = until_pictures(bench.replies(Solve(1, tomli_w.dumps(study()), folder.folder, True)))
    assert [(one.done, one.total, one.what) for one in replies if isinstance(one, Progress)] == [
        (done, COUNT + 1, "files") for done in range(1, COUNT + 2)
    ]
    (answer,) = (one for one in replies if isinstance(one, AnswerText))
    (csv,) = bench.replies(Export(2, "csv"))
    (folder.folder / "study.toml").write_text(tomli_w.dumps(study()), encoding="utf-8")
    out = tmp_path / "out"
    assert main(["fit", str(folder.folder / "study.toml"), "--output", str(out), "--quiet", "--workers", "1"]) == 2
    assert csv.content == (out / "fit.csv").read_bytes()

    assert re.findall(r'data-curve="(\d)">curves/(place_\d\d)', answer.curves) == [
        (str(n), f"place_{k:02d}") for n, k in enumerate((2, 3, 4, 5, 7, 8))
    ]
    assert len(re.findall("<tr>", answer.curves)) == COUNT + 2  # with its head and the file that is no curve
    assert "no table of a force curve" in re.search(r"<tr><td>curves/notes\.txt</td>.*?</tr>", answer.curves)[0]
    assert len(answer.labels) == answer.moments == COUNT


def charts_of(replies):
    return {one.name: json.loads(one.chart) for one in until_pictures(replies) if isinstance(one, InteractivePicture)}


@pytest.mark.slow
def test_a_click_on_a_value_shows_its_curve_and_places_make_a_map(bench, folder):
    files = dict(sample_folder())
    for name in folder.curves_in(CURVES)[1:]:  # without their places
        folder.keep(name, files[name].replace(b"# x [um]", b"# first").replace(b"# y [um]", b"# second"), CURVES)
    charts = charts_of(bench.replies(Solve(1, tomli_w.dumps(study()), folder.folder, True)))
    assert [*charts][:3] == ["values", "histogram", "fit"]
    assert charts["values"]["data"][0]["customdata"] == list(range(COUNT))
    assert sum(charts["histogram"]["data"][0]["y"]) == COUNT
    folder.remove_curves()
    for name in ("place_03.csv", "place_04.csv", "place_08.csv", "place_09.csv", "notes.txt"):
        folder.keep(name, files[name], CURVES)
    charts = charts_of(bench.replies(Solve(2, tomli_w.dumps(study()), folder.folder, True)))
    colours = charts["map"]["data"][0]
    assert colours["customdata"] == [[0.0, 1.0], [2.0, 3.0]]
    # E of the made curves, from the formula of the inclusion: 2 kPa + 7 kPa exp(-r^2 / (2.5 um)^2), r from (4, 4) um
    x, y = np.array([4.0, 6.0]), np.array([[0.0], [2.0]])
    made = 2.0 + 7.0 * np.exp(-((x - 4.0) ** 2 + (y - 4.0) ** 2) / 2.5**2)
    assert "%{z:.4~g} kPa" in colours["hovertemplate"]
    assert np.array(colours["z"]) == pytest.approx(made, rel=0.01)
    looked = list(bench.replies(Look(3, 2)))
    assert isinstance(looked[-1], MomentComplete)
    assert next(one.title for one in looked if one.name == "fit").endswith("place_08.csv")


def test_a_stop_keeps_what_was_fitted(bench, folder):
    replies = bench.replies(Solve(1, tomli_w.dumps(study()), folder.folder, True))
    assert [next(replies).done for _ in range(3)] == [1, 2, 3]  # the first is no curve
    assert list(bench.replies(Halt())) == []
    answer = next(replies)
    assert isinstance(answer, AnswerText)
    assert answer.moments == 2
    assert f"stopped before {COUNT - 2} more" in answer.curves
    (csv,) = bench.replies(Export(2, "csv"))
    assert csv.content.count(b"place_") == 2


def test_a_folder_travels_with_its_study(folder, tmp_path):
    store, other = folder.packed("text", "study.toml", (CURVES,)), UploadFolder(tmp_path)
    assert other.unpack(store, "study.toml") == b"text"
    assert other.folders == {CURVES: COUNT + 1}
    other.check(study())
    other.remove_curves()
    with pytest.raises(InvalidInput, match="uploaded files only"):
        other.check(study())
    with pytest.raises(InvalidInput, match="uploaded files only"):
        folder.check({"fit": {"curve": f"{CURVES}/../.."}})
    assert folder.members(SAMPLE_CURVES) == ()
    other.close()


def test_a_table_states_its_place(tmp_path):
    rows = "depth [nm], force [nN]\n-1, 0\n0, 0\n1, 1\n2, 3\n"
    for head, x, y in (
        ("# x [um]: 3.5\n# y (nm) = 20\n", 3.5e-6, 2e-8),
        ("y [mm]: -1e-3\n", math.nan, -1e-6),
        ("# x [kg]: 3\n", math.nan, math.nan),
    ):
        (tmp_path / "c.csv").write_text(head + rows, encoding="utf-8")
        (placed,) = read_curves(tmp_path / "c.csv")
        assert (placed.x, placed.y) == pytest.approx((x, y), rel=1e-14, nan_ok=True)
    (tmp_path / "c.csv").write_text("# x [um]: 3,5\n" + rows, encoding="utf-8")
    with pytest.raises(InvalidInput, match="write it with a decimal point"):
        list(read_curves(tmp_path / "c.csv"))
