"""Many tests in one sheet, below each other or side by side, are as many curves."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.curves import read_curve, read_curves
from winkler.values.errors import InvalidInput

PEAKS = (10.0, 3.0, 8.0, 1.0)


def _test(peak, seed=0, elastic=False):
    """Depth [nm], force [mN] and time [s] of a loading F ~ h^2 up to the peak, and an unloading."""
    along, back = np.linspace(0.0, 1.0, 60), np.linspace(1.0, 0.0, 40)[1:]
    deepest = 100.0 * np.sqrt(peak)
    final = 0.0 if elastic else 0.7 * deepest
    depth = np.r_[deepest * along, final + (deepest - final) * back ** (1.0 / 1.5)]
    force = np.r_[peak * along**2, peak * back] + 1e-4 * peak * np.random.default_rng(seed).standard_normal(depth.size)
    return np.c_[depth, force, 0.1 * np.arange(depth.size)]


def _lines(table, count=3):
    return [",".join(f"{x:.6g}" for x in row[:count]) for row in table]


HEADER = "Depth [nm],Load [mN],Time [s]"


@pytest.mark.parametrize("between", ["blank", "header", "time", "jump", "cumulative"])
@pytest.mark.parametrize("elastic", [False, True])
def test_tests_below_each_other(tmp_path, between, elastic):
    """Six tests of 70 to 95 GPa became one, of 95.56 +- 0.51: that of the last; each is a curve of its own."""
    if between == "jump" and elastic:
        pytest.skip("without blank rows, time and jump nothing parts cycles from tests")
    timed = between in ("time", "cumulative")
    names = HEADER if timed else HEADER.rsplit(",", 1)[0]
    lines = [names]
    for number, peak in enumerate(PEAKS):
        table = _test(peak, number, elastic)
        if between == "cumulative":
            table[:, 2] += 100.0 * number
        if number:
            lines += {"header": [names], "blank": [""], "cumulative": ["", ""]}.get(between, [])
        lines += _lines(table, 3 if timed else 2)
    path = tmp_path / "tests.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    found = [one.curve for one in read_curves(path)]
    assert [curve.count for curve in found] == [99] * 4
    assert [float(curve.force.max()) for curve in found] == pytest.approx([1e-3 * peak for peak in PEAKS], rel=1e-3)
    assert found[1].name == "tests.csv, test 2"
    assert "test 2 of 4 below each other" in found[1].reading
    with pytest.raises(InvalidInput, match="holds 4 curves"):
        read_curve(path)


def test_a_workbook_with_tests_below_each_other(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append(HEADER.split(","))
    for number, peak in enumerate(PEAKS):
        for row in _test(peak, number):
            sheet.append(row.tolist())
        sheet.append([])
        sheet.append([])
    book.save(tmp_path / "tests.xlsx")
    found = [one.curve for one in read_curves(tmp_path / "tests.xlsx")]
    assert [curve.count for curve in found] == [99] * 4


@pytest.mark.parametrize("blank_after", [30, 60, 75])
def test_a_blank_row_within_a_test_parts_nothing(tmp_path, blank_after):
    lines = _lines(_test(5.0))
    path = tmp_path / "one.csv"
    path.write_text("\n".join([HEADER, *lines[:blank_after], "", *lines[blank_after:]]) + "\n", encoding="utf-8")
    assert read_curve(path).count == 99


def test_blank_rows_everywhere_part_nothing(tmp_path):
    path = tmp_path / "one.csv"
    path.write_text("\n\n".join([HEADER, *_lines(_test(5.0))]) + "\n", encoding="utf-8")
    assert read_curve(path).count == 99


def test_cycles_within_a_test_and_a_pull_off_part_nothing(tmp_path):
    """Partial unloadings do not jump back; the depth that jumps when a tip comes off is followed by no peak."""
    first, second = _test(5.0), _test(10.0)
    second = second[second[:, 0] > first[-1, 0]]
    off = np.c_[np.linspace(-60.0, -80.0, 30), np.zeros(30), np.zeros(30)]
    table = np.r_[first, second, off]
    path = tmp_path / "one.csv"
    path.write_text("\n".join([HEADER.rsplit(",", 1)[0], *_lines(table, 2)]) + "\n", encoding="utf-8")
    assert read_curve(path).count == len(table)


SIDE_BY_SIDE = {
    "anton_paar": "X_lot_{n}_Time_[s]\tY_lot_{n}_Fn_[mN]\tX_lot_{n}_Time_[s]\tY_lot_{n}_Pd_[nm]",
    "numbered": "Time {n} (s)\tLoad {n} (mN)\tTime {n} (s)\tDepth {n} (nm)",
    "attached": "t{n} [s]\tForce{n} [mN]\tt{n} [s]\th{n} [nm]",
    "repeated": "Time (s)\tLoad (mN)\tTime (s)\tDepth (nm)",
}


@pytest.mark.parametrize("shape", SIDE_BY_SIDE)
@pytest.mark.parametrize("comma", [False, True])
def test_tests_side_by_side(tmp_path, shape, comma):
    """The text export of Anton Paar was "no table of a force curve"."""
    tables = [_test(peak, number) for number, peak in enumerate(PEAKS)]
    if shape == "repeated":
        tables = [table[:, [2, 1, 0]] for table in tables]
        header = "\t".join(["Time (s)\tLoad (mN)\tDepth (nm)"] * 4)
    else:
        tables = [table[:, [2, 1, 2, 0]] for table in tables]
        header = "\t".join(SIDE_BY_SIDE[shape].format(n=n + 1) for n in range(4))
    rows = [[f"{x:.7g}" for x in row] for row in np.hstack(tables)]
    rows += [["", "", "", ""] * 3 + rows[-1][12:]] if shape == "anton_paar" else []
    text = "\n".join([header, *("\t".join(row) for row in rows)])
    path = tmp_path / "lot.txt"
    path.write_text(text.replace(".", ",") if comma else text, encoding="utf-8")
    found = [one.curve for one in read_curves(path)]
    assert [float(curve.force.max()) for curve in found] == pytest.approx([1e-3 * peak for peak in PEAKS], rel=1e-3)
    assert [float(curve.position.max()) for curve in found] == pytest.approx([1e-7 * p**0.5 for p in PEAKS], rel=1e-4)
    assert [curve.count for curve in found][:3] == [99] * 3


def test_extension_and_retraction_side_by_side(tmp_path):
    """NanoScope's text: Calc_Ramp_Ex_nm beside Calc_Ramp_Rt_nm, each from the far end on; there was "no table"."""
    ramp = np.linspace(0.0, 2000.0, 501)
    there, back = (factor * np.maximum(ramp - 1000.0, 0.0) ** 1.5 / 1000.0 for factor in (1.0, 0.9))
    lines = ["\t".join(f"{x:.6g}" for x in row) for row in np.c_[ramp, ramp, there, back]]
    path = tmp_path / "curve.txt"
    path.write_text("\n".join(["Calc_Ramp_Ex_nm\tCalc_Ramp_Rt_nm\tDefl_nN_Ex\tDefl_nN_Rt", *lines]) + "\n")
    with pytest.raises(InvalidInput, match="give spring_constant in N/m"):
        read_curve(path)
    curve = read_curve(path, spring_constant=0.5)
    np.testing.assert_allclose(curve.position, 1e-9 * np.r_[ramp, ramp[::-1]], rtol=1e-5)
    np.testing.assert_allclose(curve.force, 1e-9 * np.r_[there, back[::-1]], rtol=1e-5)
    np.testing.assert_array_equal(curve.direction, np.r_[np.ones(501), -np.ones(501)])
    assert curve.machine_stiffness == 0.5
    assert "'Calc_Ramp_Ex_nm'" in curve.reading


def test_two_times_of_one_test_must_agree(tmp_path):
    table = _test(5.0)
    rows = np.c_[table[:, 2], table[:, 1], 1.1 * table[:, 2], table[:, 0]]
    text = "\n".join(["\t".join([SIDE_BY_SIDE["numbered"].format(n=n) for n in (1, 2)])] +
                     ["\t".join(f"{x:.6g}" for x in [*row, *row]) for row in rows])  # fmt: skip
    path = tmp_path / "lot.txt"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InvalidInput, match="time of test 1 stands in 2 columns that differ"):
        list(read_curves(path))


def test_means_beside_standard_deviations_are_one_curve(tmp_path):
    """Columns in another unit, or of deviations, are no further test."""
    rows = np.c_[_test(5.0)[:, :2], 0.01 * _test(5.0)[:, :2]]
    names = "Depth [nm],Load [mN],Depth std [nm],Load std [mN]"
    path = tmp_path / "mean.csv"
    path.write_text("\n".join([names, *_lines(rows, 4)]) + "\n", encoding="utf-8")
    assert read_curve(path).count == 99
