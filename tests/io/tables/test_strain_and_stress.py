"""Creep and relaxation by strain and stress, shorter rows, a foremost name: the numbers of a made test come back."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.tables.relaxation_table import read_creep, read_relaxation
from winkler.study.inspection.inspect import inspect_file
from winkler.values.errors import InvalidInput

TIME = np.geomspace(0.1, 100.0, 13)
COMPLIANCE = 1e-4 * (1.0 + np.log10(10.0 * TIME))
STRESS = 40.0


def table(tmp_path, head, rows, separator="\t"):
    file = tmp_path / "test.txt"
    lines = [*head, *(separator.join(f"{cell:.12g}" for cell in row) for row in rows)]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("head", "factor"),
    [
        (["t\tstrain\tstress\tT", "s\t-\tPa\tC"], 1.0),
        (["t\tstrain\tstress\tT", "s\t%\tPa\tC"], 100.0),
        (["Time [s]\tShear Strain [%]\tShear Stress [Pa]\tTemperature [°C]"], 100.0),
        (["Time [s]\tShear Strain [1]\tShear Stress [Pa]\tTemperature [°C]"], 1.0),
    ],
)
def test_creep(tmp_path, head, factor):
    rows = [(t, factor * j * STRESS, STRESS, 150.0) for t, j in zip(TIME, COMPLIANCE, strict=True)]
    file = table(tmp_path, head, rows)
    read = read_creep(file)
    np.testing.assert_allclose(read.compliance, COMPLIANCE, rtol=1e-10)
    assert read.reading == "compliance = strain / stress"
    found = inspect_file(file)
    assert found.taken_for == "creep"
    assert read.reading in found.done


def test_relaxation(tmp_path):
    rows = [(t, 2.0 + 0.01 * (-1) ** k, 0.02 / j) for k, (t, j) in enumerate(zip(TIME, COMPLIANCE, strict=True))]
    file = table(tmp_path, ["time [s]\tstrain [%]\tstress [Pa]"], rows)
    strain = np.array(rows)[:, 1] / 100.0
    np.testing.assert_allclose(read_relaxation(file).shear, 0.02 / COMPLIANCE / strain, rtol=1e-10)
    assert inspect_file(file).taken_for == "relaxation"


def test_strain_without_unit(tmp_path):
    """A plain strain may be in per cent: the table must say."""
    file = table(tmp_path, ["time [s]\tstrain\tstress [Pa]"], [(t, 0.5, 1.0 / t) for t in TIME])
    with pytest.raises(InvalidInput, match="no unit stands with 'strain'"):
        read_relaxation(file)


def test_what_is_not_held(tmp_path):
    """A test until fracture is no creep and no relaxation, and a recovery has no stress."""
    head = ["time [s]\tstrain [%]\tstress [Pa]"]
    pulled = table(tmp_path, head, [(t, t, 5.0 * t) for t in TIME])
    for read, what in ((read_creep, "stress"), (read_relaxation, "strain")):
        with pytest.raises(InvalidInput, match=f"has one {what}, and here it goes from"):
            read(pulled)
    with pytest.raises(InvalidInput, match="has one stress"):
        read_creep(table(tmp_path, head, [(t, 1.0 / t, 0.0) for t in TIME]))


def test_shorter_rows(tmp_path):
    """Empty cells at the end of a row may be left out; a last row that is cut is refused."""
    head = ["time [s]\tshear [Pa]\tstatus [1]\tpoint [1]"]
    full = [(t, 1.0 / j, 1.0, 1.0) for t, j in zip(TIME, COMPLIANCE, strict=True)]
    rows = [row[:2] if k % 3 else row for k, row in enumerate(full)]
    np.testing.assert_allclose(read_relaxation(table(tmp_path, head, rows)).shear, 1.0 / COMPLIANCE, rtol=1e-10)
    with pytest.raises(InvalidInput, match="the line has 2 and the header 4 cells"):
        read_relaxation(table(tmp_path, head, [*full[:-1], full[-1][:2]]))
    with pytest.raises(InvalidInput, match="the line has 1 and the header 4 cells"):
        read_relaxation(table(tmp_path, head, [*full[:3], full[3][:1], *full[4:]]))


def test_time_of_the_step(tmp_path):
    """A step has a time of its own beside that of the whole test."""
    head = ["Step time\tRun time\tTime\tCompliance", "min\tmin\tmin\t1/Pa"]
    rows = [(t, t + 7.0, t + 5.0, j) for t, j in zip(TIME, COMPLIANCE, strict=True)]
    np.testing.assert_allclose(read_creep(table(tmp_path, head, rows)).time, 60.0 * TIME, rtol=1e-10)


def test_averaged_rows_are_named(tmp_path):
    """Rows of one time that agree are averaged, and the data say so; without such rows they say nothing."""
    rows = [(t, 1.0 / j) for t, j in zip(TIME, COMPLIANCE, strict=True)]
    plain = read_relaxation(table(tmp_path, ["time [s]\tshear [Pa]"], rows))
    assert plain.reading == ""
    again = [*rows, (TIME[2], 1.1 / COMPLIANCE[2]), (TIME[2], 0.9 / COMPLIANCE[2]), (TIME[5], 1.1 / COMPLIANCE[5])]
    file = table(tmp_path, ["time [s]\tshear [Pa]"], again)
    read = read_relaxation(file)
    assert read.reading == "5 rows at 2 times are averaged"
    assert read.shear[2] == pytest.approx(1.0 / COMPLIANCE[2])
    assert read.shear[5] == pytest.approx(1.05 / COMPLIANCE[5])
    assert read.reading in inspect_file(file).done


def test_the_held_stress_of_a_creep_is_given_where_no_column_holds_it(tmp_path):
    """Files of creep often hold time and strain, and state the stress above; names of empty columns may follow."""
    for head in (["stress=10;", "t\tstrain\tstress\tT", "s\t-\tPa\tC"], ["time [s]\tstrain [1]"]):
        file = table(tmp_path, head, [(t, 10.0 * j) for t, j in zip(TIME, COMPLIANCE, strict=True)])
        with pytest.raises(
            InvalidInput, match='of a creep, where no column holds the stress, give held_stress = "10 Pa"'
        ):
            read_creep(file)
        read = read_creep(file, held_stress=10.0)
        np.testing.assert_allclose(read.compliance, COMPLIANCE, rtol=1e-8)
        assert read.reading == "compliance = strain / 10 Pa, given"
        assert 'give held_stress = "10 Pa"' in inspect_file(file).reason
    with pytest.raises(InvalidInput, match="the stress of its creep is -1 Pa; give a positive one"):
        read_creep(file, held_stress=-1.0)


@pytest.mark.parametrize(("scatter", "read"), [(0.2, True), (0.01, False)])
def test_rows_of_one_time_are_averaged_if_rows_around_them_scatter_as_much(tmp_path, scatter, read):
    """Two rows 30 % apart are noise beside others that scatter by 20 %, and a contradiction beside smooth ones."""
    time = np.geomspace(0.01, 100.0, 60)
    noise = np.exp(scatter * np.random.default_rng(3).standard_normal(60))
    rows = list(zip(time, time**0.3 * noise, strict=True))
    rows.insert(20, (time[20], 1.3 / 0.85 * rows[20][1]))
    file = table(tmp_path, ["time [s]\tcompliance [1/Pa]"], rows)
    if not read:
        with pytest.raises(InvalidInput, match="time does not rise"):
            read_creep(file)
        return
    found = read_creep(file)
    assert found.reading == "2 rows at 1 times are averaged, up to 35% apart, as the rows around them scatter"
    assert found.compliance[20] == pytest.approx(0.5 * (rows[20][1] + rows[21][1]))
