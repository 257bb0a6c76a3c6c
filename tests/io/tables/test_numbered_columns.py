"""Tables without names: the columns are given by their numbers."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.curves import read_curve, try_curves
from winkler.io.topography_file import read_topography
from winkler.values.errors import InvalidInput

UNITS = {"position": "nm", "force": "mN", "time": "s"}
ROWS = "".join(f"{h:.3f} {1e-4 * h**2:.6f} {1 + 200 * h:.3f}\n" for h in range(100))


def _file(tmp_path, text, name="kla.txt"):
    (tmp_path / name).write_text(text)
    return tmp_path / name


def test_bare_numbers_are_read_by_their_columns(tmp_path):
    curve = read_curve(_file(tmp_path, ROWS), units=UNITS, columns={"depth": 1, "force": 2, "time": 3})
    assert curve.position[-1] == pytest.approx(99e-9)
    assert curve.force[-1] == pytest.approx(0.9801e-3)
    assert curve.time[-1] == pytest.approx(19801.0)
    assert "depth from 'column 1 [nm]'" in curve.reading


def test_bare_numbers_are_no_file_of_a_microscope(tmp_path):
    """The message asked for a spring constant alone, and the reading said "file of NT-MDT"."""
    with pytest.raises(InvalidInput, match=r"give columns = \{ depth = 1, force = 2 \}"):
        read_curve(_file(tmp_path, ROWS))


@pytest.mark.parametrize("separator", [";", "\t", ","])
def test_columns_may_stand_anywhere_below_any_text(tmp_path, separator):
    rows = "\n".join(separator.join(row.split()[::-1]) for row in ROWS.splitlines())
    text = f"sample 3{separator} kept wet\nWeg{separator}Last (mN){separator}Tiefe (um)\n{rows}\n"
    curve = read_curve(_file(tmp_path, text), columns={"depth": 3, "force": 2})
    assert curve.position[-1] == pytest.approx(99e-6)  # the unit stands in the header
    assert curve.force[-1] == pytest.approx(0.9801e-3)


def test_units_are_asked_for_and_wrong_columns_refused(tmp_path):
    file = _file(tmp_path, ROWS)
    for columns, said in (
        ({"depth": 1, "force": 2}, "units = "),
        ({"depth": 1, "force": 9}, "no line has numbers"),
        ({"depth": 1, "forc": 2}, "did you mean 'force'"),
        ({"depth": 1}, "give one of position, depth, gap and one of force"),
        ({"depth": 1, "force": 1}, "a column of its own"),
        ({"depth": 0, "force": 1}, "counted from 1"),
    ):
        with pytest.raises(InvalidInput, match=said):
            read_curve(file, columns=columns)


def test_a_table_without_known_names_shows_those_it_has(tmp_path):
    with pytest.raises(InvalidInput, match=r"whose columns are 'Foo \[nm\]', 'Bar \[N\]'"):
        read_curve(_file(tmp_path, "Foo [nm]; Bar [N]\n1;2\n3;4\n", "a.csv"))


def test_a_displacement_is_that_of_the_tip_where_no_cantilever_bends(tmp_path):
    """Studies with [indentation] asked for a spring constant, for which they have no key."""
    file = _file(tmp_path, "Displacement (nm),Load (mN)\n" + "".join(f"{h},{h * h}\n" for h in range(50)), "a.csv")
    (one,) = try_curves(file, rigid=True)
    assert np.isinf(one.curve.machine_stiffness)
    assert "taken as that of the tip" in one.curve.reading
    (other,) = try_curves(file)
    assert "give spring_constant" in other.reason


def test_a_map_of_nanoscope_is_in_the_unit_of_its_head(tmp_path):
    """It was "'\\Exported' is no height"."""
    rows = "\n".join(" ".join(f"{x * y:.3e}" for x in range(8)) for y in range(8))
    found = read_topography(_file(tmp_path, f"\\Exported image units: nm\n{rows}\n", "map.txt"), lengths=(1e-6, 1e-6))
    assert np.ptp(found.heights) == pytest.approx(49e-9)


def test_places_and_heights_of_a_map_may_have_two_units(tmp_path):
    """Points in mm and um took one unit for both: a root mean square slope of 349 for 0.35."""
    text = "".join(f"{0.005 * x:.4f},{0.005 * y:.4f},{0.1 * x * y:.4f}\n" for y in range(12) for x in range(12))
    found = read_topography(_file(tmp_path, text, "points.txt"), unit="mm, um")
    assert np.ptp(found.heights) == pytest.approx(12.1e-6)
    assert found.lengths == pytest.approx(np.full(2, 60e-6))
    with pytest.raises(InvalidInput, match="unit"):
        read_topography(_file(tmp_path, text, "points.txt"), unit="mm, s")
