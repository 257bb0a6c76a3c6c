"""Studies of height maps: files beside the study, maps in results, reports with surface, spots and bounds."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
import xarray

import winkler as wk
from winkler.cli import main
from winkler.study.batch.run import run
from winkler.study.chapters.contents import formulas_of
from winkler.study.chapters.rough import ROUGH
from winkler.study.chapters.surfaces import read_surface
from winkler.study.language.build import build, unbuild
from winkler.study.language.canonical import canonical, digest
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Study
from winkler.study.language.writing import study_text
from winkler.study.report.archive import dataset
from winkler.study.report.describe import inputs
from winkler.study.report.figures import answers_over
from winkler.study.report.mathml import formula
from winkler.study.report.report import page

HEIGHTS = wk.random_topography(wk.SelfAffine(0.8, 1e-6, 1e-3, 80e-6), (40, 32), [1e-3, 0.8e-3], 5).heights
TEXT = """title = "Measured"

[problem]
kind = "surface_conduction"
realisations = 5

[problem.contact]
kind = "surface_contact"
load = { kind = "force", force = ["2 N", "20 N"] }
medium = { kind = "half_space", first = { kind = "elastic", young = "83 GPa", poisson = 0.37 } }

[problem.contact.topography]
kind = "height_map"
file = "map.npy"
unit = "um"
lengths = ["1 mm", "0.8 mm"]
detrend = "plane"
filled = true

[problem.conductors]
kind = "electrical_conductors"
first = { kind = "electrical_conductor", resistivity = "15.9 nohm m" }
second = { kind = "electrical_conductor", resistivity = "15.9 nohm m" }

[output]
figures = ["png"]
"""


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    tilted = 1e6 * HEIGHTS + 0.1 * np.arange(40)[:, None]
    tilted[7, 9] = np.nan
    np.save(tmp_path / "map.npy", tilted)
    return tmp_path


@pytest.mark.slow
def test_a_measured_surface_ends_in_a_report(here, capsys):
    (here / "study.toml").write_text(TEXT, encoding="utf-8")
    assert main(["run", "study.toml", "--quiet", "--output", "first"]) == 0
    for name in ("surface", "contact", "conductance"):
        assert (here / "first" / "figures" / f"answer_{name}.png").stat().st_size > 20_000
    report = (here / "first" / "report.html").read_text(encoding="utf-8")
    assert "power spectrum of all directions" in report
    assert "Barber&#x27;s bounds" in report or "Barber's bounds" in report
    assert re.search(r"\.\.\. \d+ letters, in study\.toml", report)
    assert len(report) < 1_500_000
    # the maps are in NetCDF, not in CSV
    with xarray.open_dataset(here / "first" / "results.nc", engine="h5netcdf") as data:
        assert data["pressure"].dims == ("x", "y")
        assert data["pressure"].shape == (40, 32)
        assert float(data["x"][-1]) == pytest.approx(1e-3 - 0.5 * 1e-3 / 40)
        force = float(data["pressure"].sum()) * (1e-3 / 40) * (0.8e-3 / 32)
        assert force == pytest.approx(20.0, rel=1e-5)
        assert float(data["separation"].min()) == 0.0
        assert "units" in data["heights"].attrs
    assert "pressure" not in (here / "first" / "results.csv").read_text(encoding="utf-8")
    # study.toml stands on its own
    (here / "map.npy").unlink()
    again = (here / "first" / "study.toml").read_text(encoding="utf-8")
    again = again[: again.index("[output]")] + "[output]\nfigures = []\nreport = false\n"
    (here / "again.toml").write_text(again, encoding="utf-8")
    assert main(["run", "again.toml", "--quiet", "--output", "second"]) == 0
    one, two = (json.loads((here / name / "provenance.json").read_text())["hash"] for name in ("first", "second"))
    assert one == two
    assert (here / "first" / "results.csv").read_text() == (here / "second" / "results.csv").read_text()
    capsys.readouterr()


@pytest.mark.slow
def test_the_map_is_drawn_by_itself(here, capsys):
    (here / "study.toml").write_text(TEXT, encoding="utf-8")
    assert main(["draw", "study.toml", "--part", "profile"]) == 0
    assert capsys.readouterr().out == "Written study-profile.png\n"
    assert (here / "study-profile.png").stat().st_size > 20_000


def test_reading_makes_a_map_ready(here):
    plain = read_surface(here / "map.npy", lengths=np.array([1e-3, 0.8e-3]), unit="um")
    assert plain.missing == 1
    ready = read_surface(
        here / "map.npy", lengths=np.array([1e-3, 0.8e-3]), unit="um", detrend="plane", filled=True, coarsened=2
    )
    assert ready == plain.detrended(1).filled().coarsened(2)
    assert ready.heights.shape == (20, 16)
    spiked = 1e6 * HEIGHTS.copy()
    spiked[20, 11] += 50.0
    np.save(here / "spiked.npy", spiked)
    clean = read_surface(here / "spiked.npy", lengths=np.array([1e-3, 0.8e-3]), unit="um", without_spikes=True)
    assert np.isnan(clean.heights[20, 11])
    level = read_surface(
        here / "map.npy", lengths=np.array([1e-3, 0.8e-3]), unit="um", levelled="line", scan_lines_along="y"
    )
    assert level == plain.levelled("line", "y")
    with pytest.raises(wk.InvalidInput, match=r"detrend is 'plain' \(did you mean 'plane'\?\)"):
        read_surface(here / "map.npy", lengths=np.array([1e-3, 1e-3]), unit="um", detrend="plain")


@pytest.mark.parametrize("shape", [(3, 5), (40, 32)])
def test_a_map_is_written_to_the_last_bit(shape):
    """Small ones in numbers, large ones packed; missing heights stay missing."""
    heights = HEIGHTS[: shape[0], : shape[1]].copy()
    for missing in (False, True):
        if missing:
            heights[1, 2] = np.nan
        item = wk.Topography(heights, [1e-3, 2e-3])
        table = unbuild(item)
        assert ("packed" in table["heights"]) == (missing or heights.size > 64)
        again = build(table, "topography")
        np.testing.assert_array_equal(again.heights, item.heights)
        assert again == item


SWEPT = """
[problem]
kind = "surface_contact"
load = { kind = "force", force = "5 N" }
medium = { kind = "half_space", first = { kind = "elastic", young = "83 GPa", poisson = 0.37 } }
[problem.topography]
kind = "random_topography"
lengths = "1 mm"
shape = [24, 24]
periodic = false
spectrum = { kind = "self_affine", hurst = 0.8, rms_height = "1 um", longest = "1 mm", shortest = "0.1 mm" }
[sweep]
"""
"""A sweep over random maps; what is swept is added."""


def test_maps_of_a_sweep_stand_beside_one_another():
    study = parse_study(SWEPT + '"problem.topography.spectrum.rms_height" = ["0.5 um", "1 um"]')
    assert parse_study(study_text(study)) == study
    outcome = run(study)
    data = dataset(outcome)
    assert data["pressure"].dims == ("problem.topography.spectrum.rms_height", "x", "y")
    np.testing.assert_allclose(2.0 * data["heights"].values[0], data["heights"].values[1], rtol=1e-12)
    assert data["force"].values == pytest.approx([5.0, 5.0], rel=1e-5)


NOT_ROUND = ("elliptic_indentation", "nearly_round_indentation")
QUICK = (*NOT_ROUND, "elastomer_friction")
PROBLEMS = (*ROUGH.answers, *NOT_ROUND)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    "name",
    [
        name if name in QUICK else pytest.param(name, marks=pytest.mark.long)
        for name in (*ROUGH.answers, "elliptic_indentation", "nearly_round_indentation")
    ],
)
def test_every_problem_has_its_picture_and_formulas(name):
    problem = build(example_study(name)["problem"])
    outcome = run(Study("picture", problem))
    shown = list(answers_over(outcome))
    assert shown
    report = page(outcome, tuple(shown))
    assert "The formulas" in report
    assert "knows no formulas" not in report
    assert "are no pictures" not in report
    assert all(one.picture is not None for one in shown), [one.missing for one in shown]
    assert formulas_of(problem)
    for one in formulas_of(problem):
        assert formula(one.latex).startswith("<math")


@pytest.mark.slow
def test_a_reduced_bed_shows_the_surface_it_stands_for():
    problem = build(example_study("indentation", bed="reduced_bed")["problem"])
    shown = [one.name for one in answers_over(run(Study("picture", problem)))]
    assert shown == ["answer_surface"]


def test_large_maps_are_stated_by_their_hash():
    big = np.add.outer(np.arange(70.0), np.arange(70.0)) * 1e-9
    rough = wk.Topography(big, [1e-3, 1e-3])
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    message = canonical(Study("", wk.SurfaceContact(rough, steel, wk.Force(1.0))))
    assert len(message) < 1000
    other = big.copy()
    other[3, 4] += 1e-12
    changed = wk.SurfaceContact(wk.Topography(other, [1e-3, 1e-3]), steel, wk.Force(1.0))
    assert digest(Study("", changed)) != digest(Study("", wk.SurfaceContact(rough, steel, wk.Force(1.0))))
    again = wk.SurfaceContact(wk.Topography(big - 0.0, [1e-3, 1e-3]), steel, wk.Force(1.0))
    assert canonical(Study("", again)) == message


def test_a_report_states_what_a_random_surface_is_made_of():
    study = Study("", build(example_study("surface_contact")["problem"]))
    message = {row.name: row.text for row in inputs(study)}
    assert message["shape"] == "64 × 64"
    assert message["lengths"] == "1 mm, 1 mm"
    assert message["Hurst exponent"] == "0.8"
    assert "heights" not in message  # they follow from the others


def test_maps_of_other_sizes_share_the_corner():
    """Pixels that a smaller map does not have are nan; there are no common places."""
    study = parse_study(SWEPT + '"problem.topography.shape" = [[16, 24], [24, 20]]')
    assert parse_study(study_text(study)) == study
    outcome = run(study)
    data = dataset(outcome)
    assert data["heights"].shape == (2, 24, 24)
    assert "x" not in data.coords
    first, second = (point.solution.last.pressure for point in outcome.solved)
    np.testing.assert_array_equal(data["pressure"].values[0, :16, :24], first)
    np.testing.assert_array_equal(data["pressure"].values[1, :24, :20], second)
    assert np.isnan(data["pressure"].values[0, 16:]).all()
    assert np.isnan(data["pressure"].values[1, :, 20:]).all()
