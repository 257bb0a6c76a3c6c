"""Marks of missing heights, and units that were mistaken, do not pass without a word."""

from __future__ import annotations

import json

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.profiles.rough.plausibility import doubts_of_surface, without_marks


def _wave(count=400):
    """Places [um] and heights [um] of a rough line with Rdq near 0.02."""
    x = np.arange(float(count))
    return x, 0.4 * np.sin(0.05 * x) + 0.05 * np.sin(0.2 * x + 1.0)


@pytest.mark.parametrize("mark", [-25400.0, -9999.0, 1e10, 32767.0, -32768.0])
def test_marks_of_missing_heights_are_left_out(tmp_path, mark):
    """30 % of -25400 gave Ra 10.24 mm and Rdq 15680 without a word; 0.31 um is right without them."""
    x, z = _wave()
    lost = np.random.default_rng(1).random(x.size) < 0.3
    lost[[0, -1]] = False
    path = tmp_path / "line.csv"
    rows = np.c_[x, np.where(lost, mark, z)]
    path.write_text("x [um],z [um]\n" + "\n".join(f"{a:.6g},{b:.9g}" for a, b in rows) + "\n")
    scan = wk.read_scan(path)
    assert scan.missing == np.count_nonzero(lost)
    assert scan.heights == pytest.approx(1e-6 * z[~lost], rel=1e-6, abs=1e-15)
    straight = np.polyval(np.polyfit(x, z, 1), x)
    assert scan.arithmetic_height == pytest.approx(1e-6 * np.mean(np.abs(z - straight)), rel=0.03)
    heights = np.tile(z, (8, 1))
    heights[2, 5] = heights[3, 9] = mark
    np.savetxt(tmp_path / "map.csv", heights, delimiter=",")
    rough = wk.read_topography(tmp_path / "map.csv", unit="um", lengths=(8e-6, 400e-6))
    assert rough.missing == 2
    assert np.isnan(rough.heights[2, 5])


def test_floors_and_steps_are_no_marks():
    """Equal heights far below the others are measured ones, unless they are numbers that instruments write."""
    rough = 2e-7 + 1e-8 * np.random.default_rng(2).random(200)
    for floor in (0.0, -1e-6, -999e-9, 25.4e-3 * 1.01):
        heights = np.where(np.arange(200) < 40, floor, rough)
        left, marks = without_marks(heights)
        assert marks.size == 0
        np.testing.assert_array_equal(left, heights)
        assert any("If they mark missing points" in doubt for doubt in doubts_of_surface(heights, 0.1, (1e-3,)))
    assert doubts_of_surface(rough, 0.1, (1e-3,)) == ()


def _shown(capsys, *arguments):
    assert main(["show", *map(str, arguments), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_places_in_mm_and_heights_in_um(tmp_path, capsys):
    """One unit for both gave Rdq 18.05 without a word; 0.018 is right."""
    x, z = _wave()
    path = tmp_path / "line.txt"
    np.savetxt(path, np.c_[1e-3 * x, z], fmt="%.9g", delimiter="\t")
    assert any("may have different units" in one for one in _shown(capsys, path, "--unit", "um")["remarks"])
    right = _shown(capsys, path, "--unit", "mm, um")
    assert right["remarks"] == []
    assert right["statistics"]["rms_slope"]["value"] == pytest.approx(np.std(np.diff(z)), rel=0.01)


def test_a_fine_surface_in_mm_and_um(tmp_path, capsys):
    """A slope of 0.001 by right units is 1 by one unit for both: not steep, and yet worth a remark."""
    x, z = _wave()
    path = tmp_path / "fine.txt"
    np.savetxt(path, np.c_[1e-3 * x, 0.05 * z], fmt="%.9g")
    (remark,) = _shown(capsys, path, "--unit", "um")["remarks"]
    assert "if the places are in mm, give --unit 'mm, um'" in remark
    assert _shown(capsys, path, "--unit", "mm, um")["remarks"] == []


def test_a_map_of_160_m(tmp_path, capsys):
    """160 m x 160 m with heights of 0.7 um: Sdq 1.4e-7 without a word."""
    heights = 1e-7 * np.random.default_rng(3).standard_normal((16, 16))
    np.savez(tmp_path / "map.npz", heights=heights, lengths=[160.0, 160.0], unit="m")
    assert any("160 m long" in one for one in _shown(capsys, tmp_path / "map.npz")["remarks"])
    np.savez(tmp_path / "right.npz", heights=heights, lengths=[160e-6, 160e-6], unit="m")
    assert not any("Doubtful" in one for one in _shown(capsys, tmp_path / "right.npz")["remarks"])
