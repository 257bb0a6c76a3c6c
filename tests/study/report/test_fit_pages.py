"""Pages of single curves: what stands on them, and what their figures show."""

from __future__ import annotations

import dataclasses
import hashlib
import re

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.plot.fitting.noise_sheet import noise_sheet
from winkler.study.batch.fit_run import fit_study
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.report.fit_report import figures_of
from winkler.study.report.fits.pages import curve_pages
from winkler.study.report.writing import write_files

STUDY = """title = "Gel"
[problem]
kind = "indentation"
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "RADIUS um" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 kPa", poisson = 0.5 } }
[fit]
curve = "gel"
part = "approach"
[fit.free]
"problem.bed.medium.first.young" = true
contact_point = true
"""


def hertz(depth: np.ndarray, young: float) -> np.ndarray:
    return 4.0 / 3.0 * young / 0.75 * np.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5


@pytest.fixture
def outcome(tmp_path):
    (tmp_path / "gel").mkdir()
    for number, deepest in enumerate((4e-8, 1e-6, 5e-8), 1):
        depth = np.linspace(-deepest, deepest, 100)
        force = hertz(depth, 4e3) + 1e-3 * hertz(depth, 4e3)[-1] * np.random.default_rng(number).standard_normal(100)
        rows = (f"{1e9 * d:.6f}, {1e9 * f:.8f}\n" for d, f in zip(depth, force, strict=True))
        (tmp_path / f"gel/c{number}.csv").write_text("depth [nm], force [nN]\n" + "".join(rows), encoding="utf-8")
    (tmp_path / "gel/empty.csv").write_text("depth [nm], force [nN]\n1, 2\n", encoding="utf-8")
    return fit_study(parse_fit_study(STUDY.replace("RADIUS", "5"), file="gel.toml", folder=tmp_path))


@pytest.mark.slow
def test_a_page_states_everything_behind_its_numbers(outcome, tmp_path):
    target = tmp_path / "results"
    target.mkdir()
    write_files(curve_pages(outcome, 2), target)
    assert sorted(path.name for path in (target / "pages").iterdir()) == ["1_gel_c1.csv.html", "2_gel_c2.csv.html"]
    page = (target / "pages/1_gel_c1.csv.html").read_text(encoding="utf-8")
    assert hashlib.sha256((tmp_path / "gel/c1.csv").read_bytes()).hexdigest() in page
    assert hashlib.sha256((tmp_path / "gel/c2.csv").read_bytes()).hexdigest() not in page
    for text in (
        "gel/c1.csv",
        "loading (100 points)",
        "the position is the travel of the tip",
        "estimated from the",
        "it was fitted as it was measured",
        "Residuals in units of the noise",
        outcome.provenance.hash,
    ):
        assert text in page
    assert page.count("<svg") == 3
    assert not re.search(r'(src|href)="https?://(?!doi\.org)', page)


@pytest.mark.slow
def test_the_report_of_one_curve_shows_once_what_was_done(outcome, tmp_path):
    study = parse_fit_study(STUDY.replace("RADIUS", "5").replace('"gel"', '"gel/c1.csv"'), folder=tmp_path)
    drawn = [figure.name for figure in figures_of(fit_study(study))]
    assert drawn == ["curve_1", "measured_1", "noise"]


def test_notes_on_many_curves_name_those_they_hold_for(outcome):
    """The contact of the second curve alone is wide against its tip: sqrt(R d) = 0.45 R, of others 0.1 R."""
    statements = [note.statement for note in outcome.validity]
    assert any(
        statement.startswith("1 of 3 curves (gel/c2.csv): The contact radius is 0.4") for statement in statements
    )
    assert any(statement.startswith("all 3 curves: ") for statement in statements)
    assert [one.name for one in outcome.refused] == ["gel/empty.csv"]
    alone = dataclasses.replace(outcome, results=outcome.fitted[1:2])
    assert not any("curves" in note.statement.partition(":")[0] for note in alone.validity)


def test_the_spectrum_of_white_noise_is_one_and_slow_noise_rises():
    depth, random = np.linspace(-1e-6, 1e-6, 2000), np.random.default_rng(5)
    model = wk.Indentation(
        wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(1e4, 0.5))), wk.Depth(0.0)
    )
    white = 1e-11 * random.standard_normal(2000)
    slow = 2e-12 * np.cumsum(random.standard_normal(2000))

    def power(noise):
        found = fit(ForceCurve(depth, hertz(depth, 4e3) + noise), model, free=["bed.medium.first.young"])
        residuals, spectrum = noise_sheet(found).panels
        assert residuals.marks[0].y == pytest.approx(found.residuals / found.noise)
        return spectrum.marks[0].y

    assert np.mean(power(white)[-10:]) == pytest.approx(1.0, abs=0.15)
    risen = power(white + slow)
    assert np.mean(risen[1:6]) > 20.0 * np.mean(risen[-10:])
