"""Tables as laboratories publish them: means beside deviations, raw beside corrected, lists of results, odd headers."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.curves import read_curve, read_curves
from winkler.io.logs.log_tables import read_pin
from winkler.io.tables.relaxation_table import read_dynamic, read_relaxation
from winkler.io.tables.scan_table import read_scan
from winkler.io.tables.sweeps_table import read_dynamic_sweeps
from winkler.io.tables.table_cells import named
from winkler.io.topography_file import read_topography
from winkler.study.inspection.inspect import inspect_file
from winkler.values.errors import InvalidInput

DEPTH = np.linspace(0.0, 100.0, 101)
FORCE = 1e-4 * DEPTH**2


def _file(tmp_path, header, columns, name="table.csv", separator=","):
    rows = [separator.join(f"{number:.9g}" for number in row) for row in zip(*columns, strict=True)]
    (tmp_path / name).write_text("\n".join([*header, *rows]) + "\n", encoding="utf-8")
    return tmp_path / name


@pytest.mark.parametrize(
    "header",
    ["depth(nm),F_avg(mN),F_std(mN)", "Depth (nm),Mean Load (mN),Load SD (mN)", "depth_nm,load_mN,load_std_mN",
     "Depth [nm],Load mean [mN],Load stdev [mN]"],
)  # fmt: skip
def test_the_mean_is_read_and_not_the_deviation_beside_it(tmp_path, header):
    """'F_avg(N)' and 'F_std(N)' may each be the force; rename all but one."""
    curve = read_curve(_file(tmp_path, [header], [DEPTH, FORCE, 0.1 * FORCE]))
    assert curve.force == pytest.approx(FORCE * 1e-3)


def test_names_with_hyphens_and_low_lines_are_names():
    assert named("Storage-Modulus", ("storage modulus",)) == (True, "")
    assert named("angular_frequency [rad/s]", ("angular frequency",)) == (True, "rad/s")
    assert named("Z-Piezo (nm)", ("z-piezo",)) == (True, "nm")
    assert not named("Load std. dev. (mN)", ("load",))[0]
    assert named("Standard force (mN)", ("load", "force")) == (False, "")


def test_what_was_corrected_precedes_what_was_measured(tmp_path):
    """An export with Displacement, Force beside DEPTH, LOAD; the stiffness begins later than the test."""
    header = ["Markers,Displacement,Force,Time,DEPTH,LOAD,STIFFNESS", ",nm,mN,s,nm,mN,N/m"]
    rows = [
        f"{'Surface Index' * (n == 0)},{800 + h:.6g},{f - 0.5:.6g},{0.1 * n:.6g},{h:.6g},{f:.6g},"
        + (f"{2e4 * f / h:.6g}" if h > 20.0 else "")
        for n, (h, f) in enumerate(zip(DEPTH, FORCE, strict=True))
    ]
    file = tmp_path / "test.csv"
    file.write_text("\n".join([*header, *rows]))
    curve = read_curve(file)
    assert curve.position[-1] == pytest.approx(100e-9)
    assert curve.force[-1] == pytest.approx(1e-3)
    assert "force from 'LOAD [mN]'" in curve.reading
    assert "continuous stiffness from 'STIFFNESS [N/m]': 80 points of the loading" in curve.reading


def test_two_forces_beside_one_depth_stay_refused(tmp_path):
    file = _file(tmp_path, ["Depth (nm),Load (mN),Force (mN)"], [DEPTH, FORCE, 2.0 * FORCE])
    with pytest.raises(InvalidInput, match="may each be the force"):
        read_curve(file)


def test_a_list_of_results_is_no_curve(tmp_path):
    """A map of 40,000 indents, a row for each, was read as one curve of 40,000 points."""
    random = np.random.default_rng(4)
    depth, force = 50.0 + 10.0 * random.standard_normal(400), 0.4 + 1e-4 * random.standard_normal(400)
    file = _file(tmp_path, ["Load (mN),Depth (nm),Modulus (GPa)"], [force, depth, 3.0 * depth])
    with pytest.raises(InvalidInput, match="no curve but a list"):
        read_curve(file)


def test_a_list_with_one_force_for_many_rows_is_no_curve(tmp_path):
    """Eleven rows of twenty tests, each row at one force: force and depth go on, but the depth leaps to and fro."""
    random = np.random.default_rng(6)
    force = np.repeat(np.linspace(1000.0, 10.0, 11), 20) + 0.1 * random.standard_normal(220)
    depth = 0.3 * np.sqrt(force) * (1.0 + 0.15 * random.standard_normal(220))
    columns = [force, depth, 17.0 + 0.0 * force, 1.0 + 0.0 * force]
    for header in ("F (mN),h (um),E (GPa),H (GPa)", "F (mN),h (um),Er (GPa),Hardness (GPa)"):
        with pytest.raises(InvalidInput, match="a list, for 'h .um.' and 'F .mN.' do not go on from row to row"):
            read_curve(_file(tmp_path, [header], columns))
    rising = np.sort(depth)
    assert read_curve(_file(tmp_path, ["F (mN),h (um),E (GPa)"], [rising**2, rising, rising])).position.size == 220


@pytest.mark.parametrize("written", [str, float])
def test_a_list_in_a_workbook_with_numbers_as_text_is_no_curve(tmp_path, written):
    """It was refused as if no row held a depth and a force."""
    openpyxl = pytest.importorskip("openpyxl")
    random = np.random.default_rng(7)
    book = openpyxl.Workbook()
    book.active.append(["No.", "F", "h", "E", "H"])
    book.active.append(["", "mN", "um", "GPa", "GPa"])
    for number in range(60):
        row = [float(number), 1000.0 + random.normal(), 8.0 + random.normal(), 17.0, 1.1]
        book.active.append([written(round(one, 3)) for one in row])
    book.save(tmp_path / "list.xlsx")
    with pytest.raises(InvalidInput, match="its rows are no curve but a list, for 'h' and 'F' do not go on"):
        read_curve(tmp_path / "list.xlsx")


def test_a_noisy_curve_is_no_list(tmp_path):
    random = np.random.default_rng(5)
    depth, force = DEPTH + 3.0 * random.standard_normal(101), FORCE + 0.05 * random.standard_normal(101)
    assert read_curve(_file(tmp_path, ["Depth (nm),Load (mN)"], [depth, force])).position.size == 101


def test_a_gap_that_is_called_h_is_no_depth(tmp_path):
    """The height of a rheometer was read as the depth of an indenter, in silence."""
    gap = 1.0 - 1e-3 * DEPTH
    file = _file(tmp_path, ["No,Fn in N,h in mm,t in s"], [DEPTH, FORCE, gap, DEPTH])
    with pytest.raises(InvalidInput, match=r"give columns = \{ gap = 3, force = 2 \}"):
        read_curve(file)
    curve = read_curve(file, columns={"gap": 3, "force": 2, "time": 4}, spring_constant=float("inf"))
    assert curve.position[-1] - curve.position[0] == pytest.approx(0.1e-3)


def test_the_unit_of_a_gap_is_given_as_that_of_a_position(tmp_path):
    file = _file(tmp_path, ["No,Time,Gap,Normal Force"], [DEPTH, DEPTH, 1.0 - 1e-3 * DEPTH, FORCE])
    with pytest.raises(InvalidInput, match=r'units = \{ position = "nm", force = "uN", time = "s" \}'):
        read_curve(file)
    units = {"position": "mm", "force": "N", "time": "s"}
    assert np.ptp(read_curve(file, units=units, spring_constant=float("inf")).position) == pytest.approx(0.1e-3)


@pytest.mark.parametrize("place", [1, 2])
def test_a_word_that_ends_the_header_is_passed_over(tmp_path, place):
    file = _file(tmp_path, ["Depth (nm)\tLoad (mN)"], [DEPTH, FORCE], separator="\t")
    lines = file.read_text().splitlines()
    file.write_text("\n".join([*lines[:place], "eoh", *lines[place:]]))
    assert read_curve(file).force == pytest.approx(FORCE * 1e-3)


def test_a_word_between_the_rows_is_not(tmp_path):
    file = _file(tmp_path, ["Depth (nm)\tLoad (mN)"], [DEPTH, FORCE], separator="\t")
    lines = file.read_text().splitlines()
    file.write_text("\n".join([*lines[:50], "eoh", *lines[50:]]))
    with pytest.raises(InvalidInput, match="line 51: the line has 1 and the header 2 cells"):
        read_curve(file)


def test_rows_apart_by_spaces_below_a_header_with_tabs(tmp_path):
    rows = [f"{h:.6g}{separator}{f:.9g}" for h, f, separator in zip(DEPTH, FORCE, ["\t", " "] * 51, strict=False)]
    (tmp_path / "mixed.txt").write_text("\n".join(["Depth (nm)\tLoad (mN)", *rows]))
    assert read_curve(tmp_path / "mixed.txt").force == pytest.approx(FORCE * 1e-3)


def test_a_refusal_shows_names_and_no_row_of_numbers(tmp_path):
    """Where each row had a label such as 1|3, the refusal listed the numbers of the last row as names."""
    rows = [f"1|{n},{0.1 * n:.3f},{20 * n:.2f},37" for n in range(9)]
    (tmp_path / "segments.csv").write_text("\n".join(["SegIndex,t in s,Torque in Nm,T in K", *rows]))
    with pytest.raises(InvalidInput, match=r"there are 'SegIndex', 't in s', 'Torque in Nm', 'T in K'"):
        read_relaxation(tmp_path / "segments.csv")


def test_a_second_table_is_named_where_it_begins(tmp_path):
    table = ["Time\tRelaxation Modulus", "[s]\t[Pa]", *(f"{t}\t{1e4 / t}" for t in (1, 2, 3, 4))]
    (tmp_path / "two.txt").write_text("\n".join([*table, "Result: second", *table]))
    with pytest.raises(InvalidInput, match=r"it holds 2 tests \(1: lines 3 to 6; 2: lines 10 to 13\); give one"):
        read_relaxation(tmp_path / "two.txt")
    (tmp_path / "next.txt").write_text("\n".join([*table, *table]))
    with pytest.raises(InvalidInput, match=r"it holds 2 tests \(1: lines 3 to 6; 2: lines 9 to 12\); give one"):
        read_relaxation(tmp_path / "next.txt")
    rows = ["x [mm]\tz [um]", *(f"{t}\t{0.1 * t * t}" for t in range(9))]
    (tmp_path / "scans.txt").write_text("\n".join([*rows, "Result: second", *rows]))
    with pytest.raises(InvalidInput, match=r"line 11: .* stands again in line 12, give each table a file of its own"):
        read_scan(tmp_path / "scans.txt")


def test_a_refusal_shows_the_names_above_a_word_that_ends_the_header(tmp_path):
    rows = [f"{n},{n * n},{0.1 * n}" for n in range(5)]
    (tmp_path / "end.csv").write_text("\n".join(["Ramp [nm],Sensor [nm],Clock [ms]", "eoh", *rows]))
    with pytest.raises(InvalidInput, match=r"whose columns are 'Ramp \[nm\]', 'Sensor \[nm\]', 'Clock \[ms\]'"):
        read_curve(tmp_path / "end.csv")


OMEGA = np.array([0.1, 1.0, 10.0, 100.0])


@pytest.mark.parametrize(
    ("names", "factor"), [("w [1/s],G' [Pa],G'' [Pa]", 1.0), ("w (rad/s),Gp (kPa),Gpp (kPa)", 1e3)]
)
def test_an_angular_frequency_per_second_counts_radians(tmp_path, names, factor):
    moduli = read_dynamic(_file(tmp_path, [names], [OMEGA, 2.0 + OMEGA, OMEGA]))
    assert moduli.angular_frequency == pytest.approx(OMEGA)
    assert moduli.storage_shear == pytest.approx(factor * (2.0 + OMEGA))


def test_decimal_commas_below_semicolons(tmp_path):
    header = "Freq. (Hz);Storage modulus (MPa);Loss modulus (MPa);Temperature (°C)"
    rows = ["0,1;10,5;1,2;20", "1,5;12,2;1,5;20", "10,25;15,1;2,1;20", "99,5;18,4;2,9;20"]
    (tmp_path / "commas.csv").write_text("\n".join([header, *rows]), encoding="utf-8")
    moduli = read_dynamic(tmp_path / "commas.csv")
    assert moduli.storage_shear == pytest.approx([10.5e6, 12.2e6, 15.1e6, 18.4e6])
    (tmp_path / "three.csv").write_text("\n".join([header, *rows[:3]]), encoding="utf-8")
    with pytest.raises(InvalidInput, match="has 3 numbers; give a row of at least 4"):
        read_dynamic(tmp_path / "three.csv")


def test_a_sweep_of_time_is_no_sweep_of_frequency(tmp_path):
    """Sixty-one rows at one frequency were sixty-one sweeps."""
    strain = np.arange(1.0, 9.0)
    header = ["Angular frequency (rad/s),Temperature (degC),Strain,Storage modulus (Pa),Loss modulus (Pa)"]
    columns = [np.full(8, 6.28), 25.0 + 0.01 * strain, strain, 1e3 / strain, 10.0 * strain]
    with pytest.raises(InvalidInput, match="all of its 8 rows have one frequency, 6.28 rad/s, and one temperature"):
        read_dynamic_sweeps(_file(tmp_path, header, columns))
    columns[1] = 25.0 + 5.0 * strain  # a ramp of temperature at one frequency is one
    assert read_dynamic_sweeps(_file(tmp_path, header, columns)).temperature.size == 8


X, Y = (part.ravel() for part in np.meshgrid(np.arange(6) * 25.0, np.arange(5) * 20.0, indexing="ij"))
Z = 0.3 * X + np.sin(Y)


@pytest.mark.parametrize("ending", [".asc", ".xlsx"])
@pytest.mark.parametrize("order", ["rows", "columns", "mixed"])
def test_points_on_a_grid_are_a_map(tmp_path, ending, order):
    ways = {
        "rows": np.lexsort((Y, X)),
        "columns": np.lexsort((X, Y)),
        "mixed": np.random.default_rng(2).permutation(30),
    }
    points = np.column_stack([X + 0.05 * np.sin(X), Y, Z])[ways[order]]
    file = tmp_path / f"points{ending}"
    if ending == ".xlsx":
        openpyxl = pytest.importorskip("openpyxl")
        book = openpyxl.Workbook()
        for row in points.tolist():
            book.active.append(row)
        book.save(file)
    else:
        np.savetxt(file, points, fmt="%12.6f")
    rough = read_topography(file, unit="um, nm")
    assert rough.lengths == pytest.approx((150e-6, 100e-6), rel=1e-3)
    assert rough.heights == pytest.approx(Z.reshape(6, 5) * 1e-9, abs=1e-14)


def test_points_may_have_a_header_with_units(tmp_path):
    file = _file(tmp_path, ["X (mm),Y (mm),Z (um)"], [X * 1e-3, Y * 1e-3, Z])
    rough = read_topography(file)
    assert rough.lengths == pytest.approx((150e-6, 100e-6))
    assert rough.heights == pytest.approx(Z.reshape(6, 5) * 1e-6)


@pytest.mark.parametrize(
    ("fault", "reading"),
    [
        ("missing", ""),
        ("twice", "30 points off a grid, 1 of them at the place of another"),
        ("uneven", "30 points off"),
    ],
)
def test_points_on_no_full_grid_are_a_map_that_says_so(tmp_path, fault, reading):
    """A missing point is a missing height; other points give heights between them, and the reading says of which."""
    x, y, z = X.copy(), Y.copy(), Z.copy()
    if fault == "missing":
        x, y, z = x[:-1], y[:-1], z[:-1]
    elif fault == "twice":
        x[-1], y[-1] = x[0], y[0]
    else:
        x[x == 125.0] = 150.0
    found = read_topography(_file(tmp_path, ["X (um),Y (um),Z (nm)"], [x, y, z]))
    assert reading in found.reading
    assert (found.reading == "") == (reading == "")
    if not reading:
        expected = Z.reshape(6, 5) * 1e-9
        expected[-1, -1] = np.nan
        assert found.heights == pytest.approx(expected, nan_ok=True)


@pytest.mark.parametrize("unit", ["C", "deg C", "°C", "degC"])
def test_a_temperature_in_c_is_in_degrees_celsius(tmp_path, unit):
    header = [f"f (Hz),T ({unit}),G' (Pa),G'' (Pa)"]
    columns = [np.tile(OMEGA, 2), np.repeat([20.0, 40.0], 4), np.tile(2.0 + OMEGA, 2), np.tile(OMEGA, 2)]
    assert read_dynamic_sweeps(_file(tmp_path, header, columns)).temperature == pytest.approx(columns[1] + 273.15)


def test_a_testing_machine_names_travel_and_force(tmp_path):
    """Names of Zwick, without units: the one key is named, and the tool separation beside them is no position."""
    header = ["Test time,     Standard travel,     Tool separation,      Standard force"]
    path = _file(tmp_path, header, [0.1 * DEPTH, DEPTH, 25.0 - 1e-3 * DEPTH, FORCE])
    with pytest.raises(InvalidInput, match="no unit stands with 'Standard travel' and 'Standard force'.*units = {"):
        read_curve(path, spring_constant=1e9)
    curve = read_curve(path, spring_constant=1e9, units={"position": "um", "force": "N", "time": "s"})
    assert curve.position == pytest.approx(DEPTH * 1e-6)
    assert curve.force == pytest.approx(FORCE)


def test_the_reason_is_that_of_the_curve_where_the_header_names_one(tmp_path):
    """'read as force over time of a hold: no unit stands with time and force' left the travel out."""
    path = _file(tmp_path, ["time,travel,force,stress"], [0.1 * DEPTH, DEPTH, FORCE, FORCE])
    reason = inspect_file(path, brief=True).reason
    assert "read as force curve" in reason
    assert "no unit stands with 'travel'" in reason


def test_a_test_with_an_extension_is_no_hold(tmp_path):
    """Instron's 'Time, Extension, Load' was taken for the force over the time of a hold, its extension unread."""
    path = _file(tmp_path, ["Time,Extension,Load", "(s),(mm),(N)"], [0.1 * DEPTH, DEPTH, FORCE])
    found = inspect_file(path, brief=True)
    assert found.taken_for in ("force curve", "nanoindentation")
    assert "position from 'Extension [mm]', force from 'Load [N]', time from 'Time [s]'" in found.reason
    assert read_curve(path, spring_constant=1e6).position == pytest.approx(DEPTH * 1e-3)


TRIBOMETER = "\t".join(
    ["Step Time (s)", "Traction Coeff (-)", "", "Step Time (s)", "Wear (um)", "Disc Speed 1", "Disc Speed 2"]
)


def _steps(*lengths, other=""):
    """A log of a ball on a disc: a header above each step, words between, and a sentence at its end."""
    lines = ["Test Data File", "Comments:", ""]
    for number, length in enumerate(lengths, start=1):
        lines += [f"Step {number} started at 23/03/2018", "Step type\tTIMED\tStep description\tNew step", TRIBOMETER]
        lines += [f"{t}\t{0.05 * number}\t\t{other or t}\t{10 * number + t}\t100.2\t99.9" for t in range(1, length + 1)]
        lines += [""]
    return "\n".join([*lines, "All steps completed, test completed normally at 23/03/2018 12:24:47", ""])


def test_steps_of_a_tribometer_follow_each_other(tmp_path):
    """Names hold spaces, so only tabs part them; a time stands twice; the clock of each step begins at 1 s."""
    (tmp_path / "log.txt").write_text(_steps(30, 20))
    log = read_pin(tmp_path / "log.txt", speed=0.1)
    np.testing.assert_allclose(log.distance, 0.1 * np.arange(1.0, 51.0))
    np.testing.assert_allclose(log.friction, np.repeat([0.05, 0.1], [30, 20]))
    np.testing.assert_allclose(log.height_loss, 1e-6 * np.r_[11.0:41.0, 21.0:41.0])
    (tmp_path / "one.txt").write_text(_steps(30))
    np.testing.assert_allclose(read_pin(tmp_path / "one.txt", speed=0.1).distance, 0.1 * np.arange(1.0, 31.0))
    (tmp_path / "two.txt").write_text(_steps(30, other="5"))
    with pytest.raises(
        InvalidInput, match=r"'Step Time \(s\)' \(column 1\) and 'Step Time \(s\)' \(column 4\) may each"
    ):
        read_pin(tmp_path / "two.txt", speed=0.1)


def _specimens(start=0.0):
    """An export of a testing machine: results, then each specimen below a header with its number; it breaks at 60 %."""
    lines = ["Results Table 1,,", ",Maximum Force,", ",(N),", "1,900,", "2,1800,", ""]
    for number in (1, 2):
        lines += [f"{number},Time,Displacement,Force", ",(s),(mm),(N)"]
        load = number * 900.0 * np.append(np.linspace(0.0, 1.0, 40), [0.9, 0.6])
        lines += [f",{0.1 * n:.1f},{start * (number - 1) + 0.01 * n:.3f},{f:.3f}" for n, f in enumerate(load)]
    return "\n".join([*lines, ""])


def test_specimens_below_numbered_headers_are_tests(tmp_path):
    (tmp_path / "raw.csv").write_text(_specimens())
    first, second = read_curves(tmp_path / "raw.csv", spring_constant=np.inf)
    assert first.curve.force.max() == pytest.approx(900.0)
    assert second.curve.force.max() == pytest.approx(1800.0)
    assert second.curve.position[[0, -1]] == pytest.approx([0.0, 0.41e-3])
    (tmp_path / "on.csv").write_text(_specimens(start=0.4))  # the second goes on where the first has ended
    with pytest.raises(InvalidInput, match="the header with the position stands again"):
        list(read_curves(tmp_path / "on.csv", spring_constant=np.inf))


@pytest.mark.parametrize("mark", ["\t", " "])
def test_numbers_without_names_may_have_decimal_commas_and_other_gaps(tmp_path, mark):
    """'-32,4285 -13,63499' below '-32,5<tab>-14': there are 1 heights, and 2 above."""
    place = np.linspace(-32.5, 32.5, 80)
    rows = [f"{x:.4f}{mark if n else chr(9)}{-14.0 - 0.01 * x * x:.5f}" for n, x in enumerate(place)]
    (tmp_path / "rail.dat").write_text("\n".join(rows).replace(".", ",") + "\n")
    assert "or give its unit, such as unit = 'um'" in inspect_file(tmp_path / "rail.dat").reason
    assert read_scan(tmp_path / "rail.dat", unit="mm, um").heights[-1] == pytest.approx(-24.5625e-6)
    (tmp_path / "rail.dat").write_text("\n".join(rows) + "\n")
    assert read_scan(tmp_path / "rail.dat", unit="mm").heights[-1] == pytest.approx(-24.5625e-3)
    rows[30] = rows[30].replace(".", ",")
    (tmp_path / "rail.dat").write_text("\n".join(rows) + "\n")
    assert "write one decimal sign in the whole file" in inspect_file(tmp_path / "rail.dat").reason


def test_a_map_with_decimal_commas(tmp_path):
    heights = np.random.default_rng(5).normal(0.0, 1.0, (12, 12)).round(4) + 0.00005
    text = "\n".join("\t".join(f"{z:.5f}" for z in row) for row in heights)
    (tmp_path / "map.txt").write_text(text.replace(".", ","))
    rough = read_topography(tmp_path / "map.txt", unit="um", lengths=(1e-6, 1e-6))
    np.testing.assert_allclose(rough.heights, 1e-6 * heights, rtol=1e-12)


def test_what_lacks_is_named_by_its_key(tmp_path):
    """Columns under the owner's own names, moduli below a line of parameters, a curve without its lever."""
    own = _file(tmp_path, [",trace_a,trace_b"], [np.arange(40.0), DEPTH[:40] % 7, DEPTH[:40] % 5], "own.csv")
    assert "if a column holds heights at equal steps, give --channel, its name, --lengths" in inspect_file(own).reason
    moduli = tmp_path / "melt.tts"
    rows = [f"{w:.4g} {1e3 * w:.5g} {2e2 * w:.5g}" for w in np.geomspace(0.1, 10.0, 20)]
    moduli.write_text("\n".join(["Ma=14.8;Mb=53.8;q=7.0;", "#", *rows]) + "\n")
    assert 'of moduli give header = "frequency [Hz], storage [kPa], loss [kPa]"' in inspect_file(moduli).reason
    pytest.importorskip("afmformats")
    head = ["Force-Distance Curve", "File Format:\t3", "", "Mode:\tSingle", "Point:\t1", "X, um:\t25", "Y, um:\t25", ""]
    head += ["Extend Z-Sense(nm),Extend T-B(V),Retract Z-Sense(nm),Retract T-B(V)"]
    bent = np.maximum(DEPTH - 60.0, 0.0) * 1e-3
    lever = _file(tmp_path, head, [DEPTH, bent, DEPTH[::-1], bent[::-1]], "lever.csv")
    assert "give spring_constant in N/m and sensitivity in m/V" in inspect_file(lever).reason
    curve = read_curve(lever, spring_constant=2.0, sensitivity=1e-6)
    assert curve.force.max() == pytest.approx(2.0 * 1e-6 * 0.04)


TRAVEL = np.linspace(0.0, 2.0, 50)


@pytest.mark.parametrize(
    ("header", "rigid"),
    [
        ("Temps [sec];Force [N];Stroke [mm]", True),
        ("Temps [s];Force [N];Course_Traverse [mm]", True),
        ("C_1_Temps[s];C_1_Force[N];C_1_Stroke[mm]", True),
        ("C_1_Temps[s];C_1_Force[N];C_1_Déplacement[mm]", False),
        ("Zeit [s];Kraft [N];Verschiebung [mm]", False),
        ("Tiempo [s];Fuerza [N];Desplazamiento [mm]", False),
        ("Tempo [s];Force [N];Spostamento [mm]", False),
    ],
)
def test_travels_of_testing_machines_in_their_words(tmp_path, header, rigid):
    """The travel of the crosshead is that of the tip; of other positions the bending of a spring may be unknown."""
    file = _file(tmp_path, [header], [10.0 * TRAVEL, 3.0 * TRAVEL**1.5, TRAVEL], separator=";")
    if not rigid:
        with pytest.raises(
            InvalidInput, match="give spring_constant in N/m, infinite where the position is the travel"
        ):
            read_curve(file)
    curve = read_curve(file, spring_constant=None if rigid else np.inf)
    assert curve.position[-1] == pytest.approx(2e-3)
    assert curve.force[-1] == pytest.approx(3.0 * 2.0**1.5)
    assert inspect_file(file).taken_for in ({"force curve", "nanoindentation"} if rigid else {""})


def test_a_list_of_greatest_forces_and_depths_is_named(tmp_path):
    """Its columns E_1 and E_3 were named as two moduli of a relaxation, for T (C) is no time."""
    header = ["Case,hc(nm),Pmax(uN),hmax(um),H(GPa),T (C),E_1,E_3"]
    columns = [np.arange(30.0), DEPTH[1:31], DEPTH[1:31], DEPTH[1:31], DEPTH[1:31], *[np.ones(30)] * 3]
    found = inspect_file(_file(tmp_path, header, columns))
    assert not found.is_read
    assert "read as list of results: its header names the greatest force and the greatest depth" in found.reason
