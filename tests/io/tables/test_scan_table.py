"""Scans along a line in files: tables, a stylus instrument's own file, and what is none."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.tables.scan_table import read_scan
from winkler.io.tables.spectrum_table import read_spectrum
from winkler.profiles.rough.spectrum import PowerSpectrum
from winkler.values.errors import InvalidInput

X = np.arange(200) * 0.5
Z = 3.0 * np.sin(X / 5.0) + np.sin(2.0 * X)


def written(path, header, rows=None):
    rows = rows if rows is not None else zip(X, Z, strict=True)
    path.write_text(header + "".join(f"{x:.4f},{z:.6f}\n" for x, z in rows), encoding="utf-8")
    return path


@pytest.mark.parametrize("header", ["x [um], z [nm]\n", "Scan Type,Standard\n\nScan Data\nLateral um,Raw nm\n"])
def test_a_table_of_places_and_heights(tmp_path, header):
    scan = read_scan(written(tmp_path / "scan.csv", header))
    np.testing.assert_allclose(scan.position, X * 1e-6, atol=1e-12)
    np.testing.assert_allclose(scan.heights, Z * 1e-9, atol=1e-15)


def test_a_scan_is_taken_where_a_spectrum_is_wanted(tmp_path):
    file = written(tmp_path / "scan.csv", "x [um], z [nm]\n")
    assert read_spectrum(file) == read_scan(file).spectrum
    assert isinstance(read_spectrum(file), PowerSpectrum)


def test_what_is_no_scan(tmp_path):
    with pytest.raises(InvalidInput, match=r"few.csv: LineScan: position has 10 numbers; give a row of at least 64"):
        read_scan(written(tmp_path / "few.csv", "x [um], z [nm]\n", list(zip(X, Z, strict=True))[:10]))
    with pytest.raises(InvalidInput, match=r"back.csv: LineScan: position does not rise"):
        read_scan(written(tmp_path / "back.csv", "x [um], z [nm]\n", list(zip(X[::-1], Z, strict=True))))
    with pytest.raises(InvalidInput, match="numbers begin in line 1 without a header"):
        read_scan(written(tmp_path / "bare.csv", ""))


def test_a_file_of_a_stylus_instrument(shared_data):
    """What the instrument itself says in its file: 1500 um long, Rq 11.4 nm between its cursors."""
    scan = read_scan(shared_data / "topographies" / "dektak-1.csv")
    assert scan.position[-1] == pytest.approx(1500e-6, rel=1e-3)
    assert 1e-9 < scan.rms_height < 1e-6
    with pytest.raises(InvalidInput, match="numbers begin in line 1 without a header"):
        read_scan(shared_data / "topographies" / "xy-1.txt")
