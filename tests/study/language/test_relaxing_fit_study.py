"""Studies that fit bodies that relax: what they say, what they refuse, what they write, and how it is drawn."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.fit import fit
from winkler.io.curves import read_curve
from winkler.io.segments import directions
from winkler.plot import draw
from winkler.study.batch.fit_recording import results_of, written_fits
from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import parse_fit_study, read_fit_study
from winkler.study.report.fit_writing import dataset
from winkler.study.report.writing import outcome_files, write_files
from winkler.values.errors import InvalidInput

SOLID = "problem.bed.medium.first."


@pytest.fixture
def studies(root):
    return root / "examples" / "studies" / "fitting"


def comes_back(outcome):
    """A journal keeps fits to the last digit."""
    (result,) = outcome.results
    (again,) = results_of(outcome.study, json.loads(written_fits("", outcome.results)))
    assert again.fit == result.fit
    assert again.notes == result.notes == again.fit.validity
    assert again.steps == result.steps


@pytest.mark.slow
def test_the_loop_gives_what_is_known(studies, tmp_path):
    study = read_fit_study(studies / "fit_cell_loop.toml")
    outcome = fit_study(study)
    (result,) = outcome.fitted
    for path, truth in (("first.shear", 500.0), ("first.exponent", 0.2)):
        name = f"bed.medium.{path}"
        assert abs(result.fit.value(name) - truth) < 4.0 * result.fit.error(name), path
    assert not result.fit.flags
    direct = fit(
        read_curve(studies.parents[1] / "data" / "cell_loop.csv"),
        study.problem,
        free={free.path: free.start_or_bounds for free in study.free},
    )
    assert direct.values.tolist() == result.fit.values.tolist()
    comes_back(outcome)
    write_files(outcome_files(outcome), tmp_path)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    for words in ("The measured motion drives", "the approach, the hold and the retraction", "Lee", "exponent"):
        assert words in page
    with (tmp_path / "curves" / "data_cell_loop.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    assert rows[0][0].startswith("time")
    assert any(head.startswith("fitted_force") and "[N]" in head for head in rows[0])
    assert len(rows) == 602


@pytest.mark.slow
def test_creep_gives_what_is_known_with_units_of_positions(studies, tmp_path):
    study = read_fit_study(studies / "fit_gel_creep.toml")
    assert [free.key for free in study.free] == [
        f"{SOLID}relaxed_shear",
        f"{SOLID}shears.0",
        f"{SOLID}relaxation_times.0",
    ]
    outcome = fit_study(study)
    (result,) = outcome.fitted
    assert result.fit.count == 501
    comes_back(outcome)
    for path, truth in (("relaxed_shear", 300.0), ("shears[0]", 700.0), ("relaxation_times[0]", 0.8)):
        name = f"bed.medium.first.{path}"
        assert abs(result.fit.value(name) - truth) < 4.0 * result.fit.error(name), path
    columns = {column.name: column for column in outcome.table()}
    assert columns["noise"].word.unit == "m"
    assert columns["noise"].content[0] == pytest.approx(2e-9, rel=0.15)
    assert columns[f"{SOLID}relaxation_times.0"].word.unit == "s"
    data = dataset(outcome)
    assert data["residual"].attrs["units"] == "m"
    assert data["fitted_position"].attrs["units"] == "m"
    write_files(outcome_files(outcome), tmp_path)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "The measured forces drive the contact, and the positions were fitted." in page


@pytest.mark.parametrize(
    ("name", "before", "after", "why"),
    [
        ("fit_cell_loop", 'part = "both"', 'part = "retract"', "depends on how it was pressed; give both"),
        ("fit_cell_loop", 'part = "both"', 'part = "both"\nfitted = "position"', "only while it grows; give hold"),
        ("fit_cell_loop", 'part = "both"', 'part = "both"\nfitted = "depth"', "position"),
        ("fit_cell_loop", 'part = "both"', 'part = "both"\nnoise = "10 nm"', "fit.noise"),
        ("fit_gel_creep", 'part = "hold"', 'part = "hold"\nnoise = "10 pN"', "fit.noise"),
        ("fit_gel_creep", 'part = "hold"', 'part = "hold"\nnoise = "-1 nm"', "must be positive"),
        ("fit_cell_loop", "contact_point = true", "contact_pint = true", "did you mean 'contact_point'"),
        ("fit_cell_loop", "contact_point = true", "drift = true\ndrga = true", "did you mean 'drag'"),
        ("fit_gel_creep", "first.shears", "first.shers", "did you mean 'shears'"),
        ("fit_gel_creep", 'first.shears"', 'first.shears.3"', "is no place in this list; its only one is 0"),
        ("fit_cell_loop", "first.exponent", "first.span", "there is no 'span'"),
        ("fit_cell_loop", '"viscoelastic_indentation"', '"creep_test"', "no curve can be fitted to"),
        ("fit_gel", 'part = "approach"', 'part = "hold"', "needs a body that relaxes"),
        ("fit_gel", 'part = "approach"', 'part = "approach"\nfitted = "position"', "needs a body that relaxes"),
        ("fit_gel", "contact_point = true", "drag = true", "nor one of contact_point, baseline, tilt"),
    ],
)
def test_mistakes_get_one_sentence(studies, name, before, after, why):
    text = (studies / f"{name}.toml").read_text(encoding="utf-8")
    assert before in text
    with pytest.raises(InvalidInput) as message:
        parse_fit_study(text.replace(before, after, 1), file="study.toml", folder=studies)
    assert why in str(message.value)
    assert str(message.value).startswith("study.toml: ")
    assert "\n" not in str(message.value)


def test_the_path_of_the_model_does_not_matter(studies):
    text = (studies / "fit_cell_loop.toml").read_text(encoding="utf-8")
    kind = 'kind = "viscoelastic_indentation"'
    path = 'path = { kind = "path", time = ["0 s", "1 s"], normal = { kind = "depth", depth = ["0 um", "2 um"] } }'
    moved = parse_fit_study(text.replace(kind, f"{kind}\n{path}\n#", 1), file="study.toml", folder=studies)
    assert moved.problem == read_fit_study(studies / "fit_cell_loop.toml").problem


def test_a_curve_without_times_is_refused_by_name(studies, tmp_path):
    (tmp_path / "curve.csv").write_text(
        "depth [nm], force [nN]\n" + "".join(f"{d}, {max(d, 0) ** 1.5 / 1e3}\n" for d in range(-50, 100)), "utf-8"
    )
    text = (studies / "fit_cell_loop.toml").read_text(encoding="utf-8").replace("../../data/cell_loop.csv", "curve.csv")
    with pytest.raises(InvalidInput, match=r"curve 'curve\.csv' has no times"):
        fit_study(parse_fit_study(text, file="study.toml", folder=tmp_path))


def test_segments_of_a_table_give_the_hold(tmp_path):
    rows = ["0, 0, 0, 1", "100, 1, 1, 1", "101, 0.7, 2, 2", "100, 0.6, 3, 2", "90, 0.2, 4, 3", "0, 0, 5, 3"]
    path = tmp_path / "curve.csv"
    path.write_text("depth [nm], force [nN], time [s], segment\n" + "\n".join(rows), encoding="utf-8")
    assert read_curve(path).direction.tolist() == [1, 1, 0, 0, -1, -1]
    path.write_text("depth [nm], force [nN], time [s]\n" + "\n".join(row[:-3] for row in rows), encoding="utf-8")
    assert read_curve(path).direction.tolist() == [1, 1, 1, -1, -1, -1]
    steady = directions(np.array([0.0, 1.0, 2.0]), np.array([1.0, 1.001, 1.0]), np.zeros(0))
    assert steady.tolist() == [0, 0, 0]


@pytest.mark.slow
def test_fits_are_drawn_with_labels_and_units(studies):
    for name, labels in (
        ("fit_cell_loop", ("force $F_N$ [nN]", "residual [pN]", "depth $d$ [µm]", "relaxation $E^*(t)$ [kPa]")),
        ("fit_gel_creep", ("position from first touch $D - D_0$ [nm]", "residual [nm]", "time $t$ [s]")),
    ):
        (result,) = fit_study(read_fit_study(studies / f"{name}.toml")).fitted
        figure = draw(result.fit)
        message = {axes.get_ylabel() for axes in figure.axes} | {axes.get_xlabel() for axes in figure.axes}
        assert set(labels) <= {label.replace("\n", " ") for label in message}
    with pytest.raises(wk.InvalidInput, match="no extent"):
        draw(result.fit, extent=1.0)
