"""Heights that fall as the tip approaches, compression that counts as negative, and further names and heads."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.fitting.curves.directions import found_directions
from winkler.io.curves import read_curve, read_curves
from winkler.io.logs.log_tables import read_friction_log
from winkler.io.swapped_columns import signs
from winkler.io.tables.relaxation_table import read_dynamic, read_relaxation
from winkler.io.tables.table_cells import cells_of, named
from winkler.io.topography_file import read_topography
from winkler.values.errors import InvalidInput

TRAVEL = np.linspace(0.0, 2000.0, 401)
FORCE = np.maximum(TRAVEL - 1000.0, 0.0) ** 1.5 / 1000.0
BOTH = np.r_[TRAVEL, TRAVEL[::-1]], np.r_[FORCE, FORCE[::-1]]


def _file(tmp_path, header, *columns, name="table.csv", separator=","):
    rows = [separator.join(f"{number:.15g}" for number in row) for row in zip(*columns, strict=True)]
    (tmp_path / name).write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    return tmp_path / name


@pytest.mark.parametrize(
    ("header", "place", "load", "said"),
    [
        ("z [nm], force [nN]", -1.0, 1.0, "rises as the position falls"),
        ("indentation [nm], force [nN]", -1.0, 1.0, "rises as the position falls"),
        ("piezo [nm], deflection [nm]", -1.0, 1.0, "rises as the position falls"),
        ("z [nm], force [nN]", 1.0, -1.0, "pressed by negative forces"),
        ("z [nm], force [nN]", 1.0, 1.0, ""),
    ],
)
def test_a_contact_is_pressed_by_positive_forces_at_its_deepest(tmp_path, header, place, load, said):
    """A height was read as it stands, so that the approach was the unloading, and nothing said so."""
    curve = read_curve(_file(tmp_path, header, place * BOTH[0], load * BOTH[1]), spring_constant=1.0)
    np.testing.assert_allclose(curve.position, 1e-9 * BOTH[0], rtol=1e-9, atol=1e-18)
    np.testing.assert_allclose(curve.force, 1e-9 * BOTH[1], rtol=1e-9, atol=1e-18)
    assert curve.direction[200] == 1.0
    assert said in curve.reading
    assert ("sign is changed" in curve.reading) == bool(said)


@pytest.mark.parametrize("pull", [5.0, 50.0, 500.0])
def test_a_sticky_contact_is_not_turned(pull):
    """Its tension lies before the deepest point, however much greater than the greatest force it is."""
    sticky = FORCE - pull * np.exp(-(((TRAVEL - 1050.0) / 60.0) ** 2))
    assert signs(BOTH[0], np.r_[FORCE, sticky[::-1]])[:2] == (1.0, 1.0)
    assert signs(-BOTH[0], np.r_[FORCE, sticky[::-1]])[:2] in {(-1.0, 1.0), (1.0, 1.0)}


def test_a_drift_of_the_baseline_is_no_wrong_sign():
    rng = np.random.default_rng(3)
    assert signs(TRAVEL, -0.01 * TRAVEL + rng.normal(size=TRAVEL.size))[:2] == (1.0, 1.0)
    assert signs(TRAVEL[:9], -FORCE[:9])[:2] == (1.0, 1.0)


def test_a_first_row_far_from_the_others_leaves_the_sign_to_be_found(tmp_path):
    """A program wrote where it began, then the test: a quarter of the travel held one point."""
    place, load = np.r_[5000.0, -TRAVEL], np.r_[0.0, FORCE]
    curve = read_curve(_file(tmp_path, "z [nm], force [nN]", place, load), spring_constant=1.0)
    assert curve.position[-1] == pytest.approx(2e-6)
    assert "rises as the position falls" in curve.reading


def test_a_stretch_that_differs_by_rounding_alone_is_read():
    """The histogram of one refused: too many bins for data range; found among strokes to and fro of few points."""
    rng = np.random.default_rng(2288)
    ways = [np.linspace(number % 2, 1 - number % 2, 6)[::-1] for number in range(rng.integers(2, 8))]
    place = np.round(np.concatenate([*ways, np.linspace(0.0, 1.0, 300)]), 2)
    force = np.round(0.02 * rng.normal(size=place.size) + np.maximum(place - 0.7, 0.0), 2)
    assert set(found_directions(place, force)) <= {-1.0, 0.0, 1.0}


def test_rows_that_are_numbered_have_an_empty_name(tmp_path):
    """As pandas writes a table apart by tabs: the line has 3 and the header 2 cells."""
    file = _file(tmp_path, "\tz_nm\tforce_nN", np.arange(802.0), *BOTH, separator="\t")
    curve = read_curve(file, spring_constant=1.0)
    np.testing.assert_allclose(curve.position, 1e-9 * BOTH[0], rtol=1e-9, atol=1e-18)
    np.testing.assert_allclose(curve.force, 1e-9 * BOTH[1], rtol=1e-9, atol=1e-18)


def test_a_tab_before_the_names_alone_is_no_column(tmp_path):
    file = _file(tmp_path, "\tz_nm\tforce_nN", *BOTH, separator="\t")
    assert read_curve(file, spring_constant=1.0).force.max() == pytest.approx(FORCE.max() * 1e-9)


def _nanoscope_text(tmp_path, *, missing=0, settings=600, mark='"'):
    """As NanoScope writes a curve as text: its settings, and volts of the deflection in columns of both ways."""
    head = [
        rf"{mark}\?Force file list{mark}",
        *[rf"{mark}\Setting {number}: {number}{mark}" for number in range(settings)],
        rf"{mark}\@Sens. DeflSens: V 50.00000 nm/V{mark}",
        rf"{mark}\Spring Constant: 0.2{mark}",
        rf"{mark}\*Force file list end{mark}",
        "Calc_Ramp_Ex_nm\tCalc_Ramp_Rt_nm\tDefl_V_Ex\tDefl_V_Rt",
    ]
    count = TRAVEL.size
    volts = FORCE / 50.0 / 0.2
    there = np.full((2, count), np.nan)
    there[:, : count - missing] = TRAVEL[: count - missing], volts[missing:]
    rows = [
        "\t".join("" if np.isnan(cell) else f"{cell:.15g}" for cell in row)
        for row in zip(there[0], TRAVEL[::-1], there[1], volts[::-1], strict=True)
    ]
    file = tmp_path / "curve.000.txt"
    file.write_text("\n".join([*head, *rows]) + "\n")
    return file


@pytest.mark.parametrize("mark", ['"', ""])
def test_volts_of_nanoscope_become_forces_by_what_stands_above_them(tmp_path, mark):
    """Its head of settings is longer than other heads: there was no table of a force curve in this text."""
    curve = read_curve(_nanoscope_text(tmp_path, mark=mark))
    np.testing.assert_allclose(curve.force, 1e-9 * BOTH[1], rtol=1e-8, atol=1e-18)
    np.testing.assert_allclose(curve.position, 1e-9 * BOTH[0], rtol=1e-8, atol=1e-18)
    assert curve.machine_stiffness == 0.2
    assert "sensitivity 5e-08 m/V from the file" in curve.reading
    given = read_curve(_nanoscope_text(tmp_path, mark=mark), spring_constant=0.4, sensitivity=100e-9)
    np.testing.assert_allclose(given.force, 4.0 * curve.force, rtol=1e-12)


def test_an_extension_that_a_trigger_ends_goes_to_where_retraction_begins(tmp_path):
    """Its last rows are blank, and its ramp begins at zero; both ways have one deepest point."""
    curve = read_curve(_nanoscope_text(tmp_path, missing=30))
    turn = TRAVEL.size - 30
    assert curve.position[turn - 1] == pytest.approx(curve.position[turn], rel=1e-12) == pytest.approx(2e-6)
    assert np.diff(curve.position[:turn]) == pytest.approx(5e-9, rel=1e-6)
    np.testing.assert_allclose(curve.force[:turn], 1e-9 * FORCE[30:], rtol=1e-8, atol=1e-18)
    assert "extension moved to end where retraction begins" in curve.reading


def test_sheets_of_other_languages_with_a_table_beside_the_test(tmp_path):
    """Temps d'essai, Force standard, Allongement: no sheet of the workbook has a row that names a depth and a force."""
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for number in (1, 2):
        sheet = book.create_sheet(f"essai {number}")
        sheet.append([f"essai {number}"] * 4)
        sheet.append(["Temps d'essai", "Force standard", "Allongement", "Ecartement entre outils", None, 20.0, 80.0])
        sheet.append(["s", "N", "mm", "mm", None, 3.16, 77.1])
        for place, (h, f) in enumerate(zip(TRAVEL, FORCE, strict=True)):
            sheet.append([0.1 * place, number * f, 1e-3 * h, 10.0 - 1e-3 * h, None, 1.5])
    book.save(tmp_path / "essais.xlsx")
    curves = [placed.curve for placed in read_curves(tmp_path / "essais.xlsx", spring_constant=float("inf"))]
    assert [curve.force.max() for curve in curves] == pytest.approx([FORCE.max(), 2.0 * FORCE.max()])
    assert curves[0].position == pytest.approx(1e-6 * TRAVEL)
    assert curves[0].time[-1] == pytest.approx(40.0)


def test_a_noun_behind_a_name_is_no_unit(tmp_path):
    """A shear stress over time, its unit a row below, was read as a shear modulus that relaxes."""
    (tmp_path / "flow.csv").write_text(
        "Time,Gap,Normal Stress,Shear Stress\n[s],[mm],[Pa],[Pa]\n"
        + "".join(f"{t},1,3,{5 * t}\n" for t in range(1, 30))
    )
    with pytest.raises(InvalidInput, match=r"the header has no shear modulus \(.*there are 'Time', 'Gap'"):
        read_relaxation(tmp_path / "flow.csv")
    assert named("Shear Stress", ("shear",)) == (False, "")
    assert named("Load mNn", ("load",)) == (True, "mNn")
    assert named("Kraft Newton", ("kraft",)) == (True, "Newton")


def test_a_device_before_a_channel_is_not_its_name(tmp_path):
    """A tribometer writes each name behind that of the device that measured it."""
    place = np.concatenate([np.linspace(-1.0, 1.0, 30), np.linspace(1.0, -1.0, 30)])
    rows = _file(tmp_path, "DAQ.Displacement (um),DAQ.Fx (N)", np.tile(place, 3), np.sign(np.tile(place, 3)))
    assert read_friction_log(rows).displacement.max() == pytest.approx(1e-6, rel=1e-12)


def test_a_table_without_names_is_no_map(tmp_path):
    """Time, strain, rate and stress of a rheometer asked for the unit of their heights."""
    time = np.linspace(0.0, 1.0, 200)
    rows = np.stack([time, np.sin(time), np.cos(time), np.sin(time + 0.3)], axis=1)
    np.savetxt(tmp_path / "bare.txt", rows)
    with pytest.raises(TypeError, match="positional"):  # was a fault of the file
        read_topography(tmp_path / "bare.txt", "um")
    with pytest.raises(InvalidInput, match="its 4 columns stand without a header above them"):
        read_topography(tmp_path / "bare.txt", lengths=(1e-6, 1e-6), unit="um")
    np.savetxt(tmp_path / "strip.txt", rows * rows[::-1, :1] + np.cos(40.0 * rows))
    assert read_topography(tmp_path / "strip.txt", lengths=(1e-6, 1e-6), unit="um").heights.shape == (200, 4)


def test_a_force_in_grams_is_their_weight(tmp_path):
    place = np.tile(np.r_[np.linspace(-1.0, 1.0, 30), np.linspace(1.0, -1.0, 30)], 3)
    log = read_friction_log(_file(tmp_path, "displacement [um],friction force [g]", place, np.sign(place)))
    assert np.abs(log.shear_force).max() == pytest.approx(9.80665e-3, rel=1e-12)


def test_a_rheometer_in_japanese_groups_thousands_in_quotes(tmp_path):
    rows = [f'{n},{60 * n},25,{0.5 * n},"1,900,000",{2e6 + n},{1e5 + n},"1,000"' for n in range(1, 12)]
    head = "測定点数,時間,温度,角周波数,複素弾性率,貯蔵弾性率,損失弾性率,複素粘度\n"
    head += ",[s],[°C],[1/s],[Pa],[Pa],[Pa],[Pa・s]\n"
    (tmp_path / "sweep.csv").write_text(head + "\n".join(rows) + "\n", encoding="utf-8")
    data = read_dynamic(tmp_path / "sweep.csv")
    np.testing.assert_allclose(data.angular_frequency, 0.5 * np.arange(1, 12), rtol=1e-12)
    np.testing.assert_allclose(data.storage_shear, 2e6 + np.arange(1, 12), rtol=1e-12)
    assert cells_of('"x","1,5",2', ",") == ["x", "1,5", "2"]
    assert cells_of('"a","b"', ",") == ["a", "b"]


def test_many_columns_of_one_name_are_counted(tmp_path):
    names = ",".join(["f [Hz]", "G' [Pa]", "G'' [Pa]"] + ["f [Hz]"] * 9)
    names += ",g [Hz]"
    (tmp_path / "wide.csv").write_text(
        names.replace("g [Hz]", "F [Hz]") + "\n" + "\n".join([",".join("1" * 13)] * 9) + "\n"
    )
    with pytest.raises(InvalidInput, match=r"column 4\) and 'f \[Hz\]' \(column 5\) and 8 more may each be"):
        read_dynamic(tmp_path / "wide.csv")


@pytest.mark.parametrize("mark", [",", ", "])
def test_a_column_that_stands_again_is_read_if_its_numbers_are_the_same(tmp_path, mark):
    """Rheometers and tribometers repeat time or temperature before a later group of columns."""
    frequency = np.geomspace(0.1, 10.0, 9)
    rows = [[w, 1e3 + w, 1e2 + w, w, 0.1] for w in frequency.tolist()]
    path = tmp_path / "twice.csv"

    def write():
        names = ["f [Hz]", "G' [Pa]", "G'' [Pa]", "f [Hz]", "tan delta [-]"]
        path.write_text("\n".join(mark.join(map(str, row)) for row in [names, *rows]) + "\n")

    write()
    np.testing.assert_allclose(read_dynamic(path).angular_frequency, 2.0 * np.pi * frequency, rtol=1e-12)
    rows[5][3] *= 1.001
    write()
    with pytest.raises(InvalidInput, match=r"'f \[Hz\]' \(column 1\) and 'f \[Hz\]' \(column 4\) may each be"):
        read_dynamic(path)
