"""Batches of fits: curves that stand out, and copies, are named; a copy counts once."""

from __future__ import annotations

import csv
import json
import shutil

import numpy as np
import pytest

from winkler.cli import main
from winkler.fitting.several.population import population
from winkler.fitting.several.standing_out import BatchQuantity, outlying, standing_out
from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import read_fit_study
from winkler.study.report.fit_report import page

RADIUS, YOUNG = 5e-6, 1e3
STUDY = """
[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "5 um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }

[fit]
curve = "gel"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = true
contact_point = true
"""
KEY = "problem.bed.medium.first.young"


def _write(path, young, touch, seed, deepest=1e-6):
    """Hertz: F = 4/3 E/(1 - nu^2) sqrt(R) d^(3/2), nu = 1/2."""
    random = np.random.default_rng(seed)
    depth = np.linspace(-1e-6, deepest, 200)
    force = 4.0 / 3.0 * young / 0.75 * np.sqrt(RADIUS) * np.maximum(depth, 0.0) ** 1.5
    force = force + 5e-12 * random.standard_normal(depth.size)
    rows = (f"{1e9 * d:.3f}, {1e9 * f:.7f}\n" for d, f in zip(depth + touch, force, strict=True))
    path.write_text("depth [nm], force [nN]\n" + "".join(rows), encoding="utf-8")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Seven curves of one gel, one of a gel three times as stiff, and two more files with the data of the first."""
    folder = tmp_path_factory.mktemp("batch")
    (folder / "gel").mkdir()
    random = np.random.default_rng(5)
    moduli = YOUNG * random.lognormal(0.0, 0.05, 8)
    moduli[4] = 3.0 * YOUNG
    for place, young in enumerate(moduli.tolist()):
        _write(folder / "gel" / f"c{place}.csv", young, 1e-7 * random.standard_normal(), place)
    for copy in ("c8.csv", "c9.csv"):
        shutil.copy(folder / "gel" / "c0.csv", folder / "gel" / copy)
    (folder / "gel.toml").write_text(STUDY, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def outcome(folder):
    return fit_study(read_fit_study(folder / "gel.toml"))


@pytest.mark.slow
def test_the_stiff_curve_is_named_and_copies_count_once(outcome):
    """The mean is that of the eight independent curves, not of ten, three of them the same."""
    assert [one.name for one in outcome.independent] == [f"gel/c{place}.csv" for place in range(8)]
    doubts = dict(outcome.doubts)
    assert sorted(doubts) == ["gel/c4.csv", "gel/c8.csv", "gel/c9.csv"]
    assert doubts["gel/c4.csv"][0].startswith("Stands out: young 3")
    assert doubts["gel/c8.csv"] == ("Copy: the data of gel/c0.csv, counted once.",)
    young = np.array([one.fit.value("bed.medium.first.young") for one in outcome.independent])
    quantity = outcome.batch[0]
    assert quantity.median == pytest.approx(float(np.median(young)), rel=1e-12)
    assert quantity.deviation == pytest.approx(float(np.median(np.abs(young - np.median(young)))), rel=1e-12)
    assert [one.name for one in outcome.batch] == ["young", "depth at the peak", "first touch", "chi-square in contact"]


@pytest.mark.slow
def test_command_line_json_table_and_report_say_so(folder, outcome, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    assert main(["fit", "gel.toml", "--output", "a"]) == 0
    said = capsys.readouterr().out
    assert "of 8 curves" in said
    assert "MAD" in said
    assert "doubtful: gel/c4.csv: Stands out: young 3" in said
    assert "doubtful: gel/c9.csv: Copy: the data of gel/c0.csv" in said
    assert "Mean of young over 8 curves" in said
    with (folder / "a" / "fit.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["doubts"].partition(":")[0] for row in rows] == [*[""] * 4, "Stands out", *[""] * 3, "Copy", "Copy"]
    assert main(["fit", "gel.toml", "--output", "b", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert [one["curve"] for one in answer["doubts"]] == ["gel/c4.csv", "gel/c8.csv", "gel/c9.csv"]
    assert answer["batch"][0]["median"] == pytest.approx(outcome.batch[0].median)
    shown = page(outcome, ())
    assert "median absolute deviation" in shown
    assert "the data of gel/c0.csv" in shown


def test_a_batch_of_equal_numbers_still_shows_what_is_far():
    """Driven to one depth, the peaks of most curves agree: MAD is zero, and the one at a fifth of it stands out."""
    depths = BatchQuantity("depth at the peak", "m", np.array([5e-7] * 7 + [1e-7]))
    assert [bool(one) for one in standing_out([depths])] == [*[False] * 7, True]
    touches = BatchQuantity("first touch", "m", np.array([0.0] * 7 + [1e-7]), is_place=True)
    assert standing_out([touches]) == ("",) * 8


def test_a_large_error_explains_a_distance():
    numbers, errors = [70.0, 71.0, 69.0, 70.5, 69.5, 140.0], [0.5, 0.5, 0.5, 0.5, 0.5, 60.0]
    assert outlying(numbers)[-1] > 1.0
    assert outlying(numbers, errors).max() < 1.0


def test_a_population_and_a_batch_name_the_same_curves():
    """One rule: of 400 populations of lognormal numbers none is doubted by one and believed by the other."""
    random = np.random.default_rng(8)
    for _ in range(400):
        numbers = np.exp(random.standard_t(2, 12) * 0.1)
        errors = 0.03 * numbers * random.uniform(0.5, 2.0, 12)
        said = standing_out([BatchQuantity("young", "Pa", numbers, errors)])
        assert population(numbers, errors).outliers == tuple(np.flatnonzero([bool(one) for one in said]).tolist())


def test_the_limit_is_rarely_passed():
    """Of Gaussian batches 3.4 % (5 curves), 1.2 % (6) and 0.7 % (10) have a curve beyond the limit."""
    random = np.random.default_rng(3)
    for count, most in ((5, 0.045), (6, 0.02), (10, 0.015), (50, 0.006)):
        named = sum(bool(np.any(outlying(random.standard_normal(count)) > 1.0)) for _ in range(2000))
        assert named / 2000 < most
