"""Several tests in one table of moduli, and tables in one of several sheets."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curves
from winkler.io.tables import table_lines, tests_of_table
from winkler.study.language.reading import parse_study

OMEGA = np.array([0.1, 1.0, 10.0, 100.0])
WARM = (263.15, 293.15, 313.15)


def _moduli(warmth):
    factor = np.exp(-0.05 * (warmth - 293.15))
    return 1e5 * (OMEGA * factor) ** 0.2, 3e4 * (OMEGA * factor) ** 0.1


def _beside(shared=False):
    """Rows of frequency, storage and loss at each temperature, or one frequency for all."""
    columns = [OMEGA] if shared else []
    for warmth in WARM:
        columns += [*_moduli(warmth)] if shared else [OMEGA, *_moduli(warmth)]
    return np.column_stack(columns)


def _text(rows, mark):
    return "\n".join(mark.join(f"{number:.9e}" for number in row) for row in rows) + "\n"


ABOVE = "T = -10 °C,,,T = 20 °C,,,T = 40 °C,,\n" + ",".join(["Frequency,G',G''"] * 3) + "\n"
SHAPES = {
    "above": (ABOVE + ",".join(["rad/s,Pa,Pa"] * 3) + "\n", ",", False),
    "pandas": (
        "263.15 K;;;293.15 K;;;313.15 K;;\n"
        + ";".join(f"omega [rad/s]{n};G' [Pa]{n};G'' [Pa]{n}" for n in ("", ".1", ".2"))
        + "\n",
        ";",
        False,
    ),
    "in names": (
        "omega [rad/s]\t" + "\t".join(f"G' ({t} °C) [Pa]\tG'' ({t} °C) [Pa]" for t in ("-10", "20", "40,0")) + "\n",
        "\t",
        True,
    ),
    "tan delta": (
        "T = 263.15 K,,,T = 293.15 K,,,T = 313.15 K,,\n" + ",".join(["w [rad/s],G' [Pa],tan delta"] * 3) + "\n",
        ",",
        False,
    ),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_temperatures_side_by_side_are_sweeps(tmp_path, shape):
    head, mark, shared = SHAPES[shape]
    rows = _beside(shared)
    if shape == "tan delta":
        rows[:, 2::3] /= rows[:, 1::3]
    file = tmp_path / "m.csv"
    file.write_text(head + _text(rows, mark), encoding="utf-8")
    found = wk.read_dynamic_sweeps(file)
    assert found.temperature == pytest.approx(np.repeat(WARM, 4), rel=1e-12)
    assert found.angular_frequency == pytest.approx(np.tile(OMEGA, 3), rel=1e-8)
    for place, warmth in enumerate(WARM):
        own = slice(4 * place, 4 * place + 4)
        storage, loss = _moduli(warmth)
        assert found.storage_shear[own] == pytest.approx(storage, rel=1e-8)
        assert found.loss_shear[own] == pytest.approx(loss, rel=1e-8)
    with pytest.raises(wk.InvalidInput, match="it holds 3 tests"):
        wk.read_dynamic(file)
    one = wk.read_dynamic(file, test=3)
    assert one.storage_shear == pytest.approx(_moduli(WARM[2])[0], rel=1e-8)
    with pytest.raises(wk.InvalidInput, match="test is 4, and it holds 3"):
        wk.read_dynamic(file, test=4)


def test_shorter_tests_side_by_side_and_columns_of_temperature(tmp_path):
    names = "Temperature [K],Frequency [rad/s],G' [Pa],G'' [Pa]"
    rows = [
        f"{263 + 0.01 * n},{w},{3 * w},{2 * w}," + (f"293,{w},{w},{w}" if n < 3 else ",,,") for n, w in enumerate(OMEGA)
    ]
    file = tmp_path / "m.csv"
    file.write_text(f"{names},{names}\n" + "\n".join(rows) + "\n", encoding="utf-8")
    found = wk.read_dynamic_sweeps(file)
    assert found.temperature == pytest.approx([263.0, 263.01, 263.02, 263.03, 293.0, 293.0, 293.0])
    assert found.storage_shear == pytest.approx([*(3 * OMEGA), *OMEGA[:3]])


def test_tests_without_a_temperature_are_no_sweeps(tmp_path):
    file = tmp_path / "m.csv"
    file.write_text(",".join(["w [rad/s],G' [Pa],G'' [Pa]"] * 3) + "\n" + _text(_beside(), ","), encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="no temperature"):
        wk.read_dynamic_sweeps(file)
    assert wk.read_dynamic(file, test=2).loss_shear == pytest.approx(_moduli(WARM[1])[1], rel=1e-8)


def _rheometer(mark, tests):
    """Tests below each other, as Anton Paar's program exports them."""
    text = "Project:\tgel\n"
    for name, time, modulus in tests:
        text += f"\nTest:\t{name}\n\nInterval and data points:\t1\t{time.size}\n"
        text += "Interval data:\tPoint No.\tTime\tRelaxation Modulus\n\t\t\t\n\t\t[s]\t[Pa]\n"
        text += "".join(f"\t{n}\t{t:.6e}\t{g:.6e}\n" for n, (t, g) in enumerate(zip(time, modulus, strict=True), 1))
    return text.replace("\t", mark)


def test_tables_below_each_other_are_given_by_number(tmp_path):
    time = np.geomspace(0.1, 1e3, 12)
    tests = [("one", time, 2e3 * time**-0.2), ("two", time[:7], 5e3 * time[:7] ** -0.1)]
    file = tmp_path / "r.txt"
    file.write_text(_rheometer("\t", tests), encoding="utf-16")
    with pytest.raises(wk.InvalidInput, match=r"it holds 2 tests \(1: lines 9 to 20; 2: lines 28 to 34\)"):
        wk.read_relaxation(file)
    for number, (_, at, modulus) in enumerate(tests, 1):
        found = wk.read_relaxation(file, test=number)
        assert found.time == pytest.approx(at, rel=1e-6)
        assert found.shear == pytest.approx(modulus, rel=1e-6)


def test_a_creep_before_its_recovery(tmp_path):
    """The points are counted anew; the recovery has no compliance, and a later creep counts its time from the first."""
    time = np.linspace(1.0, 20.0, 10)
    creep = [f"{n},{t},30,{1e-3 * t**0.3}" for n, t in enumerate(time, 1)]
    recovery = [f"{n},{20.0 + t},0,0" for n, t in enumerate(time, 1)]
    again = [f"{n},{40.0 + t},30,{1e-3 * t**0.3}" for n, t in enumerate(time, 1)]
    file = tmp_path / "c.csv"
    head = "Meas. Pts.,Time,Shear Stress,Creep Compliance\n,[s],[Pa],[1/Pa]\n"
    file.write_text(head + "\n".join([*creep, *recovery, *again]) + "\n", encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="give one, as in test = 1"):
        wk.read_creep(file)
    found = wk.read_creep(file, test=1)
    assert found.time == pytest.approx(time)
    assert found.compliance == pytest.approx(1e-3 * time**0.3)
    with pytest.raises(wk.InvalidInput, match="its time begins at 41 s, where test 2 ends"):
        wk.read_creep(file, test=3)


def test_points_counted_anew_in_one_relaxation_stay_one(tmp_path):
    """A rheometer samples in intervals; what is read as a whole is not parted."""
    time = np.geomspace(0.1, 100.0, 12)
    rows = [f"{n % 6 + 1},{t},{2e3 * t**-0.2}" for n, t in enumerate(time)]
    file = tmp_path / "r.csv"
    file.write_text("Point No.,Time [s],G [Pa]\n" + "\n".join(rows) + "\n", encoding="utf-8")
    assert wk.read_relaxation(file).time == pytest.approx(time)


def test_a_study_names_the_test(tmp_path):
    file = tmp_path / "m.csv"
    file.write_text(SHAPES["above"][0] + _text(_beside(), ","), encoding="utf-8")
    study = parse_study(
        '[problem]\nkind = "relaxation_test"\ndepth = "1 um"\ntime = ["1 s"]\n'
        '[problem.bed]\nkind = "foundation"\nprofile = { kind = "paraboloid", curvature_radius = "1 mm" }\n'
        '[problem.bed.medium]\nkind = "viscoelastic_half_space"\n'
        'first = { kind = "dynamic_data", file = "m.csv", test = 2 }\n',
        folder=tmp_path,
    )
    assert study.problem.bed.medium.first == wk.read_dynamic(file, test=2)


def _book(path, sheets):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(row)
    book.save(path)
    return path


RESULTS = [["Test", "Depth [nm]", "Load [mN]", "Modulus [GPa]", "Hardness [GPa]"]] + [
    [n, 200.0 + n, 5.0 - 0.1 * n, 72.0, 9.0] for n in range(1, 9)
]


def test_the_sheet_is_the_one_that_names_the_columns(tmp_path):
    storage, loss = _moduli(293.15)
    sweep = [
        ["Frequency [rad/s]", "G' [Pa]", "G'' [Pa]"],
        *map(list, zip(*map(np.ndarray.tolist, (OMEGA, storage, loss)), strict=True)),
    ]
    flow = [["Shear rate [1/s]", "Viscosity [Pa s]"], *[[float(n), 2.0 / n] for n in range(1, 9)]]
    file = _book(tmp_path / "all.xlsx", {"flow": flow, "results": RESULTS, "sweep": sweep})
    found = wk.read_dynamic(file)
    assert found.storage_shear == pytest.approx(storage, rel=1e-12)
    assert found.loss_shear == pytest.approx(loss, rel=1e-12)


def test_a_list_of_results_beside_sheets_of_tests_is_no_test(tmp_path):
    depth = np.concatenate([np.linspace(0.0, 200.0, 60), np.linspace(199.0, 150.0, 40)])
    force = np.where(
        np.arange(100) < 60, 5.0 * (depth / 200.0) ** 2, 5.0 * (np.maximum(depth - 149.0, 0.0) / 51.0) ** 1.5
    )
    rows = [
        ["Time [s]", "Depth [nm]", "Load [mN]"],
        *[[0.1 * n, h, f] for n, (h, f) in enumerate(zip(depth.tolist(), force.tolist(), strict=True))],
    ]
    file = _book(tmp_path / "n.xlsx", {"Overview of all": RESULTS, "Point A": rows, "Point B": rows})
    curves = list(read_curves(file))
    assert [one.curve.name for one in curves] == ["n.xlsx, Point A", "n.xlsx, Point B"]
    for one in curves:
        assert one.curve.force == pytest.approx(1e-3 * force, rel=1e-12)


def test_a_later_sheet_that_is_too_wide_does_not_hide_the_table(tmp_path):
    storage, loss = _moduli(293.15)
    sweep = [
        ["Frequency [rad/s]", "G' [Pa]", "G'' [Pa]"],
        *map(list, zip(*map(np.ndarray.tolist, (OMEGA, storage, loss)), strict=True)),
    ]
    file = _book(tmp_path / "wide.xlsx", {"sweep": sweep, "wide": [[1.0] * 600]})
    assert wk.read_dynamic(file).storage_shear == pytest.approx(storage, rel=1e-12)


def test_many_tests_and_much_text_are_refused(tmp_path, monkeypatch):
    rows, other = ("".join(f"1,{n + 1},2,{times * (n + 1)}\n" for n in range(500)) for times in (1, 3))
    file = tmp_path / "many.csv"
    file.write_text("Meas. Pts.,Time [s],Stress [Pa],Creep Compliance [1/Pa]\n" + rows + other, encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="it holds 1000 tests, too many"):
        wk.read_creep(file)
    monkeypatch.setattr(tests_of_table, "MOST_LETTERS", 100)
    beside = tmp_path / "m.csv"
    beside.write_text(SHAPES["above"][0] + _text(_beside(), ","), encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="too many or too long"):
        wk.read_dynamic_sweeps(beside)
    monkeypatch.setattr(table_lines, "TEXT_BYTES", 2000)
    book = _book(tmp_path / "long.xlsx", {"a": [["x" * 100] * 5] * 5})
    with pytest.raises(wk.InvalidInput, match="MB of text"):
        wk.read_dynamic(book)


def test_sheets_with_the_same_names_are_tests_of_one_workbook(tmp_path):
    """The first sheet is read, `show` says that others name the same, and `test` reads them."""
    import openpyxl

    from winkler.study.inspection.inspect import inspect_file

    path = tmp_path / "warm.xlsx"
    book = openpyxl.Workbook()
    book.remove(book.active)
    for number, factor in ((180, 1.0), (160, 3.0)):
        sheet = book.create_sheet(str(number))
        sheet.append(["frequency [rad/s]", "Storage [Pa]", "Loss [Pa]"])
        for row in zip(OMEGA, factor * _moduli(293.15)[0], factor * _moduli(293.15)[1], strict=True):
            sheet.append([float(one) for one in row])
    book.create_sheet("notes").append(["by", "hand"])
    book.save(path)
    first, second = wk.read_dynamic(path), wk.read_dynamic(path, test=2)
    np.testing.assert_allclose(second.storage_shear, 3.0 * first.storage_shear, rtol=1e-12)
    np.testing.assert_allclose(wk.read_dynamic(path, test=1).storage_shear, first.storage_shear, rtol=0.0)
    with pytest.raises(wk.InvalidInput, match="test is 3, and it holds 2"):
        wk.read_dynamic(path, test=3)
    said = " ".join(inspect_file(path).doubts)
    assert "The first of 2 sheets that name these columns was read, not '160'; test = 2" in said
