"""The inputs of users on which version 0.2 failed, each as its user ran it, with the number that is right."""

from __future__ import annotations

import csv
import shutil

import numpy as np
import pytest

from winkler.cli import main
from winkler.io.curves import read_curves
from winkler.io.tables.relaxation_table import read_creep, read_dynamic, read_relaxation
from winkler.io.tables.sweeps_table import read_dynamic_sweeps
from winkler.study.inspection.inspect import inspect_file
from winkler.study.inspection.surfaces import SurfaceOptions

RIGID = np.inf


@pytest.fixture
def reported(shared_data, tmp_path, monkeypatch):
    """A copy of the folder of reported inputs, from which studies are run."""
    folder = shared_data / "reported"
    if not folder.is_dir():
        pytest.skip("the reported inputs are not among the measured files")
    shutil.copytree(folder, tmp_path / "reported")
    monkeypatch.chdir(tmp_path / "reported")
    return tmp_path / "reported"


def _first(path, column):
    with path.open(newline="", encoding="utf-8") as file:
        row = next(csv.DictReader(file))
    return float(next(row[name] for name in row if name.split(" ")[0].rpartition(".")[2] == column))


INDENTED = {
    "lift_off_drift/lift": ("EIT", 210e9, 0.01),
    "lift_off_drift/no_lift": ("EIT", 210e9, 0.01),
    "preload_lift/preload": ("EIT", 130e9, 0.01),
    "long_approach/air_100": ("EIT", 72e9, 0.005),
    "long_approach/air_900": ("EIT", 72e9, 0.005),
    "long_approach/air_2000": ("EIT", 72e9, 0.005),
    "ten_tests_one_sheet/six_csv": ("EIT", 70e9, 0.015),
    "ten_tests_one_sheet/six_xlsx": ("EIT", 70e9, 0.015),
    "ten_tests_one_sheet/notime_csv": ("EIT", 70e9, 0.015),
    "asylum_one_segment/fit_seg0": ("young", 50e3, 0.003),
    "jkr_retract/fit_peel": ("work", 18e-3, 0.025),
    "jkr_retract/fit_clean": ("work", 18e-3, 0.025),
}
"""Study, quantity of its first curve, what is right [SI], and the relative difference that is allowed."""


@pytest.mark.slow
@pytest.mark.parametrize("indented", [True, False])
def test_fits_give_what_is_right(indented, reported, capsys):
    chosen = {one: right for one, right in INDENTED.items() if (right[0] == "EIT") == indented}
    for study, (quantity, expected, within) in chosen.items():
        out = reported / "out" / study
        assert main(["fit", str(reported / f"{study}.toml"), "--output", str(out)]) == 0
        found = next(one for name in ("quantities.csv", "fit.csv") for one in out.rglob(name))
        assert _first(found, quantity) == pytest.approx(expected, rel=within), study


@pytest.mark.slow
def test_an_area_that_is_negative_far_below_its_range(reported, capsys):
    """The hardness is the force over the area, whose terms are those of the study, at the contact depth."""
    assert main(["fit", str(reported / "hysitron_area" / "steel.toml"), "--output", str(reported / "out")]) == 0
    (table,) = (reported / "out").rglob("unloadings.csv")
    force, depth, hardness = (_first(table, name) for name in ("force", "contact_depth", "hardness"))
    terms = (24.5, 2460.555732, -185073.933454, 2197392.23639, -5682984.151049, 3678718.2292)
    powers = (2.0, 1.0, 0.5, 0.25, 0.125, 0.0625)
    area = 1e-18 * sum(term * (1e9 * depth) ** power for term, power in zip(terms, powers, strict=True))
    assert hardness == pytest.approx(force / area, rel=1e-6)


@pytest.mark.slow
def test_dust_before_the_contact_is_named(reported, capsys):
    assert main(["fit", str(reported / "soft_before_contact" / "soft.toml"), "--output", str(reported / "out")]) == 0
    assert "two touches are seen" in capsys.readouterr().out


@pytest.mark.slow
def test_tests_side_by_side_are_two(reported, capsys):
    assert main(["fit", str(reported / "wide_anton_paar" / "study.toml"), "--output", str(reported / "out")]) == 0
    assert "2 curves with 2 unloadings" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("study", "column", "expected"),
    [
        ("torsion_program/as_asked", "torque_limit", 5.712e-3),
        ("steady_diffusivity/beads", "resistance", 6649.55),
        ("expect_thermal_resistance/h1_glass_beads", "resistance", 6649.5463),
    ],
)
def test_runs_give_what_is_right(study, column, expected, reported, capsys):
    assert main(["run", str(reported / f"{study}.toml"), "--output", str(reported / "out")]) == 0
    (table,) = (reported / "out").rglob("results.csv")
    assert _first(table, column) == pytest.approx(expected, rel=1e-4)


DOUBTED = {
    "nanovea_units/points.txt": ("um", "the root mean square slope is 349"),
    "nms_lengths/flat.npz": ("", "the surface is 160 m long"),
    "missing_as_number/line.csv": ("", "Missing: 112 of 400 heights"),
    "missing_as_number/map.csv": ("um", "Missing: "),
    "scan_mm_um/xmm_zum.txt": ("um", "the root mean square slope is 18"),
}


@pytest.mark.parametrize("file", DOUBTED)
def test_units_and_marks_are_doubted(file, reported):
    unit, doubt = DOUBTED[file]
    lengths = "1 mm, 1 mm" if file.endswith("map.csv") else ""
    options = SurfaceOptions(unit=unit, lengths=lengths) if unit else None
    assert any(doubt in one for one in inspect_file(reported / file, options).doubts)


def test_scans_are_read_as_they_are(reported):
    mitutoyo = inspect_file(reported / "mitutoyo_circle" / "mitutoyo_nonuniform_mock.xlsx")
    assert mitutoyo.content.position.size == 960
    assert mitutoyo.content.position[-1] == pytest.approx(479.5e-6)
    wide = inspect_file(reported / "scan_header" / "scan_utf16.csv")
    assert wide.content.position[-1] == pytest.approx(7.387e-6, rel=1e-3)
    # its header states the unit of the places alone, and that of the heights is not guessed
    assert "no unit stands with 'y1'" in inspect_file(reported / "scan_header" / "scan.csv").reason
    image = inspect_file(reported / "nanoscope_ascii" / "map.txt", SurfaceOptions(lengths="1 um, 1 um"))
    assert image.taken_for == "height map"


def test_curves_of_texts(reported):
    """Force in newton as JPK states it, both ways of NanoScope's text, and positions that are minus a gap."""
    (jpk,) = read_curves(reported / "jpk_text_as_ntmdt" / "jpk.txt")
    assert jpk.curve.force.max() == pytest.approx(55.9e-9, rel=1e-3)
    (ways,) = read_curves(reported / "nanoscope_ascii" / "curve.txt", spring_constant=0.05)
    assert set(ways.curve.direction.tolist()) == {1.0, -1.0}
    assert "columns = { position = 1, force = 2 }" in inspect_file(reported / "jpk_text_as_ntmdt" / "kla.txt").reason
    gap, place = (
        next(read_curves(reported / "rheometer_gap" / name, spring_constant=RIGID)).curve
        for name in ("gap.csv", "pos.csv")
    )
    for curve in (gap, place):
        assert curve.position[np.argmax(curve.force)] == pytest.approx(curve.position.max(), abs=1e-9)


MODULI = ("a_trios.csv", "b_rheocompass.txt", "c_osc.txt", "e_pyvisco.csv", "g_tand.csv", "i_w.csv", "j_ta.txt")


def test_moduli_under_the_names_of_instruments(reported):
    folder = reported / "dma_headers"
    for name in MODULI:
        assert read_dynamic(folder / name).storage_shear.size >= 4, name
    assert read_dynamic_sweeps(folder / "k_T.txt").storage_shear.size >= 4
    assert read_relaxation(folder / "l_rel.csv").time.size >= 4
    assert read_creep(folder / "o_creep.csv").time.size >= 4
    assert "temperature has 3 numbers" in inspect_file(folder / "h_comma.csv").reason  # read, and too few
