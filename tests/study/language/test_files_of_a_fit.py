"""Files of instruments in `[fit]`: units by one key, many tests in one file, and how the report says they were read."""

import dataclasses

import numpy as np
import pytest

from winkler.study.batch.fit_run import fit_study
from winkler.study.language.canonical import how_fitted
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.report.fit_report import page
from winkler.values.errors import InvalidInput

YOUNG, RADIUS = 5e6, 10e-6
STUDY = """
[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 um" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "1 MPa", poisson = 0.5 }

[fit]
curve = "FILE"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = true
contact_point = true
"""
UNITS = 'units = { position = "nm", force = "uN", time = "s" }'


def numbers(young, seed):
    """Return depths [nm], forces [uN] and times [s] of a paraboloid on a half-space, by Hertz."""
    depth = np.linspace(-200.0, 500.0, 150)
    force = 1e6 * 16 / 9 * young * np.sqrt(RADIUS) * (1e-9 * np.maximum(depth, 0.0)) ** 1.5
    return depth, force + 0.002 * force.max() * np.random.default_rng(seed).standard_normal(150), 0.01 * np.arange(150)


def study_of(folder, file, line=""):
    text = STUDY.replace("FILE", file).replace('part = "approach"', f'part = "approach"\n{line}')
    return parse_fit_study(text, file="gel.toml", folder=folder)


def test_units_by_one_key(tmp_path):
    rows = [f"{t:.3f},{h:.6f},{f:.6f}" for h, f, t in zip(*numbers(YOUNG, 1), strict=True)]
    (tmp_path / "gel.csv").write_text("\n".join(["t,h,F", *rows]), encoding="utf-8")
    with pytest.raises(
        InvalidInput, match=r"no unit stands with 'h' and 'F'.* give it as units = \{ position = \"nm\""
    ):
        fit_study(study_of(tmp_path, "gel.csv"))
    study = study_of(tmp_path, "gel.csv", UNITS)
    assert study.units == (("force", "uN"), ("position", "nm"), ("time", "s"))
    outcome = fit_study(study)
    (result,) = outcome.fitted
    assert result.fit.value("bed.medium.first.young") == pytest.approx(YOUNG, rel=0.02)
    report = page(outcome, ())
    assert "How the files were read:" in report
    assert "depth from &#x27;h [nm]&#x27;" in report or "depth from 'h [nm]'" in report
    assert "given units: force uN, position nm, time s" in report


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ('units = { positions = "nm" }', r"fit.units: 'positions' is not known \(did you mean 'position'\?\)"),
        ('units = { position = "mN" }', r"fit.units, position: 'mN' is the unit of a force, not of a length"),
        ('units = "nm"', r"fit.units is 'nm'; give the unit of each quantity, as in units = \{"),
        ('unit = { position = "nm" }', r"unit.*did you mean.*units"),
    ],
)
def test_units_that_are_refused(tmp_path, line, why):
    (tmp_path / "gel.csv").write_text("h,F\n0,0\n1,1\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match=why) as error:
        study_of(tmp_path, "gel.csv", line)
    assert "\n" not in str(error.value)


def test_other_units_are_another_fit(tmp_path):
    (tmp_path / "gel.csv").write_text("h,F\n0,0\n1,1\n", encoding="utf-8")
    study = study_of(tmp_path, "gel.csv", UNITS)
    other = dataclasses.replace(study, units=(("force", "mN"),))
    assert how_fitted(study) != how_fitted(other)


def test_a_workbook_is_a_batch(tmp_path):
    """Each sheet is a curve with its own modulus, named by file and test."""
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.remove(book.active)
    for number, young in ((1, 5e6), (2, 8e6)):
        sheet = book.create_sheet(f"Test 00{number}")
        for row in (["Displacement Into Surface", "Load On Sample", "Time On Sample"], ["nm", "uN", "s"]):
            sheet.append(row)
        for row in zip(*numbers(young, number), strict=True):
            sheet.append([float(cell) for cell in row])
    book.save(tmp_path / "gel.xlsx")
    outcome = fit_study(study_of(tmp_path, "gel.xlsx"))
    assert [result.name for result in outcome.fitted] == ["gel.xlsx, Test 001", "gel.xlsx, Test 002"]
    np.testing.assert_allclose(
        [result.fit.value("bed.medium.first.young") for result in outcome.fitted], [5e6, 8e6], rtol=0.02
    )
