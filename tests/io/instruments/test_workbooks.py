"""Workbooks of Agilent, Keysight and MTS indenters, in both formats."""

import struct
import sys

import numpy as np
import pytest
from old_workbook import old_workbook

import winkler as wk
from winkler.io.curves import read_curve, read_curves

INVALID = 1.7976931348623157e308
NAMES = ["Segment", "Displacement Into Surface", "Load On Sample", "Time On Sample", "Harmonic Contact Stiffness"]
UNITS = ["", "nm", "mN", "s", "N/m"]


def csm_sheet(scale):
    """Return 6 points of loading, of which 4 are in contact and 3 have a stiffness, a hold, and an unloading."""
    depth = [-20.0, -10.0, 10.0, 20.0, 30.0, 40.0, 40.0, 40.5, 30.0, 20.0]
    load = [0.0, 0.0, *(scale * 0.01 * h for h in (10.0, 40.0, 90.0, 160.0)), scale * 1.6, scale * 1.6, scale, 0.4]
    stiffness = [-5.0, INVALID, 1e3, 2e3, INVALID, 4e3, INVALID, INVALID, INVALID, INVALID]
    marks = ["Load Segment Type", *[""] * 5, "Hold Segment Type", "", "Unload From Peak Segment Type", ""]
    numbers = zip(marks, depth, load, np.arange(10.0), stiffness, strict=True)
    return [NAMES, UNITS, *([mark, *map(float, row)] for mark, *row in numbers), ["END"]]


SHEETS = {
    "Results": [
        ["Test", "E", "Drift Correction", "Tip Name", "Displacement", "Load"],
        ["", "GPa", "nm/s", "", "nm", "mN"],
        ["1", "72.8", "0.025", "TB22169", "40", "1.6"],
    ],
    "Required Inputs": [
        ["Test", "Poissons Ratio", "X Test Position", "Y Test Position"],
        ["", "", "um", "um"],
        [1.0, 0.18, 40.0, 60.0],
        [10.0, 0.18, 140.0, 60.0],
    ],
    "Test 010": csm_sheet(2.0),
    "Test 001": csm_sheet(1.0),
}


def new_workbook(path, sheets):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append([None if cell == "" else cell for cell in row])
    book.save(path)
    return path


def written(tmp_path, ending, sheets):
    if ending == "xlsx":
        return new_workbook(tmp_path / "steel.xlsx", sheets)
    pytest.importorskip("xlrd")
    path = tmp_path / "steel.xls"
    path.write_bytes(old_workbook(sheets))
    return path


@pytest.mark.parametrize("ending", ["xls", "xlsx"])
def test_a_workbook_of_many_tests(tmp_path, ending):
    first, tenth = read_curves(written(tmp_path, ending, SHEETS))
    assert [placed.curve.name for placed in (first, tenth)] == [f"steel.{ending}, Test 0{n}" for n in ("01", "10")]
    np.testing.assert_allclose(first.curve.position[2:6], [10e-9, 20e-9, 30e-9, 40e-9])
    np.testing.assert_allclose(tenth.curve.force[2:6], [0.2e-3, 0.8e-3, 1.8e-3, 3.2e-3])
    np.testing.assert_array_equal(first.curve.direction, [1, 1, 1, 1, 1, 1, 0, 0, -1, -1])
    assert (tenth.x, tenth.y) == pytest.approx((140e-6, 60e-6))
    np.testing.assert_allclose(first.continuous.stiffness, [1e3, 2e3, 4e3])
    np.testing.assert_allclose(first.continuous.depth, [10e-9, 20e-9, 40e-9])
    for fact in ("'Displacement Into Surface' [nm]", "subtracted drift and frame", "drift 0.025 nm/s", "tip TB22169"):
        assert fact in first.curve.reading
    assert "drift 0.025" not in tenth.curve.reading


@pytest.mark.parametrize("ending", ["xls", "xlsx"])
def test_cycles_are_found_from_the_curve(tmp_path, ending):
    """The marks of a method with cycles do not say where it is held, so that the segments are detected."""
    load = np.concatenate(
        [np.linspace(0, 4, 30), np.linspace(3.9, 1, 20), np.linspace(1.1, 8, 30), np.linspace(7.9, 0, 30)]
    )
    marks = {0: "Cycle Begin Marker 1", 30: "Cycle Unload Marker 1", 50: "Cycle Begin Marker 2"}
    rows = [[marks.get(i, ""), 10.0 * float(p) ** 0.5, float(p), 0.1 * i] for i, p in enumerate(load)]
    path = written(tmp_path, ending, {"Test 002": [NAMES[:4], UNITS[:4], *rows, ["END", "", "", ""]]})
    kinds = [segment.kind.value for segment in read_curve(path).segments]
    assert kinds == ["loading", "partial unloading", "loading", "last unloading"]


def test_a_sheet_of_any_program(tmp_path):
    path = new_workbook(
        tmp_path / "own.xlsx",
        {"Notes": [["for Monday"]], "Curve": [["h (nm)", "P (mN)"], [0.0, 0.0], [1.0, 2.0], ["", 3.0], [2.0, 4.0]]},
    )
    curve = read_curve(path)
    np.testing.assert_allclose(curve.force, [0.0, 2e-3, 4e-3])
    assert "1 row without numbers left out" in curve.reading


def test_a_list_beside_a_test_is_named(tmp_path):
    """A sheet with moduli and without time is left out beside a test, whose reading names it; alone it is read."""
    force = np.append(np.arange(60.0), np.arange(58.0, -1.0, -2.0))
    test = [["Depth (nm)", "Load (mN)", "Time (s)"], *map(list, zip(force, force, np.arange(90.0), strict=True))]
    listed = [["Depth (nm)", "Load (mN)", "Modulus (GPa)"], *([100.0 + k, 5.0, 72.0] for k in range(12))]
    both = new_workbook(tmp_path / "both.xlsx", {"A": test, "Short": listed})
    (placed,) = read_curves(both)
    assert "taken for lists of results, without time, and left out: 'Short'" in placed.curve.reading
    (alone,) = read_curves(new_workbook(tmp_path / "alone.xlsx", {"A": test}))
    assert "left out" not in alone.curve.reading


def test_an_average_whose_time_falls(tmp_path):
    names = ["", "Displacement Into Surface", "STANDARD DEVIATION (Displacement)", "Load On Sample", "Time On Sample"]
    rows = [["", 1.0, 0.1, 1.0, 5.0], ["", 2.0, 0.1, 3.0, 4.0], ["", 3.0, 0.1, 6.0, 7.0]]
    path = new_workbook(tmp_path / "mean.xlsx", {"Sample": [names, ["", "nm", "nm", "mN", "s"], *rows]})
    curve = read_curve(path)
    assert not curve.timed
    assert "an average of several tests, whose time falls and is left out" in curve.reading


@pytest.mark.parametrize(
    ("sheets", "why"),
    [
        ({"Sheet1": [["a", "b"], [1.0, 2.0]]}, "no sheet of the workbook has a row that names a depth and a force"),
        (
            {"S": [["h", "P"], [0.0, 0.0], [1.0, 2.0]]},
            r"no unit stands with 'h' and 'P'; give it as units = \{ position = \"nm\", force",
        ),
        ({"S": [["h (nm)", "P (mN)"], [0.0, 0.0]]}, "1 rows hold depth and force; it needs at least 2"),
        ({"S": [["h (nm)", "P (mN)", *map(str, range(900))], [0.0] * 902]}, "has 902 columns, at most 500 are read"),
    ],
)
def test_workbooks_that_are_refused(tmp_path, sheets, why):
    path = new_workbook(tmp_path / "own.xlsx", sheets)
    with pytest.raises(wk.InvalidInput, match=why) as error:
        read_curve(path)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("states", [True, False])
def test_a_sheet_of_too_many_rows_is_refused_before_they_are_read(tmp_path, monkeypatch, states):
    """Issue 38, item 7: a million rows of one cell took over 15 s."""
    from openpyxl.worksheet._read_only import ReadOnlyWorksheet

    path = new_workbook(tmp_path / "long.xlsx", {"S": [["h (nm)", "P (mN)"], *([[1.0, 2.0]] * 20)]})
    monkeypatch.setattr("winkler.io.workbooks.workbook_cells.MOST_ROWS", 20)
    if states:
        monkeypatch.setattr(ReadOnlyWorksheet, "iter_rows", None)
    else:
        monkeypatch.setattr(ReadOnlyWorksheet, "max_row", None)
    with pytest.raises(wk.InvalidInput, match="the sheet 'S' has more than 20 rows; save it as text"):
        read_curve(path)


@pytest.mark.parametrize("start", [b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", b"PK\x03\x04"])
@pytest.mark.parametrize("ending", ["xls", "xlsx"])
def test_a_damaged_workbook(tmp_path, start, ending):
    path = tmp_path / f"damaged.{ending}"
    path.write_bytes(start + bytes(range(256)) * 20)
    with pytest.raises(wk.InvalidInput, match=r"damaged\.xlsx?: .*(save|unpack)") as error:
        read_curve(path)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(("ending", "package"), [("xls", "xlrd"), ("xlsx", "openpyxl")])
def test_without_the_package(tmp_path, monkeypatch, ending, package):
    path = written(tmp_path, ending, SHEETS)
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(wk.InvalidInput, match=rf"workbooks need {package}; install it with pip install 'winkler\[nano"):
        read_curve(path)


def test_tests_side_by_side_in_a_sheet(tmp_path):
    """H is the name of the sample there, and no depth without a unit."""
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    signals = ("X", "Time_[s]"), ("Y", "Fn_[mN]"), ("Y", "Pd_[nm]")
    book.active.append([f"{axis}_H_100mN_{n}_{what}" for n in (2, 4) for axis, what in signals])
    for n in range(50):
        book.active.append([0.1 * n, 0.01 * n**2, 3.0 * n, 0.1 * n, 0.02 * n**2, 4.0 * n])
    book.create_sheet("evaluated").append(["E", "H"])
    book.save(tmp_path / "lot.xlsx")
    curves = [placed.curve for placed in read_curves(tmp_path / "lot.xlsx")]
    assert [curve.position[-1] for curve in curves] == pytest.approx([147e-9, 196e-9])
    assert [curve.force[-1] for curve in curves] == pytest.approx([24.01e-3, 48.02e-3])


def test_columns_of_a_sheet_are_counted_too(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for n in range(30):
        book.active.append([0.5 * n, 2.0 * n, 0.01 * n**2])
    book.save(tmp_path / "bare.xlsx")
    units = {"position": "nm", "force": "mN"}
    curve = read_curve(tmp_path / "bare.xlsx", columns={"depth": 2, "force": 3}, units=units)
    assert curve.position[-1] == pytest.approx(58e-9)


def test_a_sheet_of_a_rheometer_is_a_table(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.active.append(["Point", "Gap (mm)", "Normal Force (N)"])
    for n in range(30):
        book.active.append([n, 1.0 - 0.01 * n, 0.01 * n**2])
    book.save(tmp_path / "gap.xlsx")
    assert np.ptp(read_curve(tmp_path / "gap.xlsx", spring_constant=float("inf")).position) == pytest.approx(0.29e-3)


def test_a_damaged_drawing_does_not_refuse_a_sheet(tmp_path):
    """Unexpected data at end of OBJECT record: xlrd reads no cell of such a sheet."""
    rows = [["Depth (nm)", "Load (mN)"], *[[float(n), 1e-3 * n * n] for n in range(1, 40)]]
    pytest.importorskip("xlrd")
    drawing = struct.pack("<HH18xHH", 0x15, 18, 0, 0) + b"\x01\x01"
    for number, damaged in enumerate((b"", drawing)):
        path = tmp_path / f"{number}.xls"
        path.write_bytes(old_workbook({"Test": rows}, version=8, drawing=damaged))
        assert read_curve(path).force[-1] == pytest.approx(1.521e-3)
