"""Curves of Hysitron indenters: .hld, the text export, and nanoDMA."""

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curve, read_curves

SEGMENTS = [(0.0, 0.0, 4), (0.0, 900.0, 12), (900.0, 900.0, 5), (900.0, 0.0, 12)]
DEMAND = np.concatenate([np.linspace(begin, end, count) for begin, end, count in SEGMENTS])
DEPTH = np.sqrt(DEMAND)
TIME = 0.01 * np.arange(DEMAND.size)


def hld(points=DEMAND.size):
    head = [
        "File Version: Hysitron HighLoad FBControls 6.1 Release",
        "Machine Comp: 0.0031 nm/µN",
        "Tip ID: Berkovich 7",
        "FB Mode: Load Control",
        "Drift Rate: -0.012 nm/s",
        f"Number of Segments: {len(SEGMENTS)}",
    ]
    for number, (begin, end, count) in enumerate(SEGMENTS):
        head += [
            f"Segment Number: {number}",
            f"Segment Begin Demand: {begin:g} µN",
            f"Segment End Demand: {end:g} µN",
            f"Segment Points: {count}",
        ]
    head += ["Sample Approach Data Points: 2", "Time_s\tMotorDisp_mm\tPiezo Extension_nm"]
    head += ["0.01\t0.0\t1.0", "0.02\t0.0\t2.0", f"Test Data Points: {points}", "Time_s\tDisp_nm\tForce_µN\tDisp_V"]
    rows = [f"{t:.6f}\t{h:.9f}\t{f:.9f}\t0.1" for t, h, f in zip(TIME, DEPTH, DEMAND, strict=True)]
    return "\r\n".join([*head, *rows]) + "\r\n"


def test_hld(tmp_path):
    """The units stand in the names of the columns, the directions in the demanded segments; Latin-1, as instruments."""
    path = tmp_path / "test.hld"
    path.write_bytes(hld().encode("latin-1"))
    curve = read_curve(path)
    np.testing.assert_allclose(curve.position, 1e-9 * DEPTH, atol=1e-18)
    np.testing.assert_allclose(curve.force, 1e-6 * DEMAND, atol=1e-15)
    np.testing.assert_allclose(curve.time, TIME, atol=1e-12)
    np.testing.assert_array_equal(curve.direction, np.repeat([0, 1, 0, -1], [4, 12, 5, 12]))
    for fact in ("Hysitron HighLoad", "'Disp' [nm]", "'Force' [µN]", "subtracted the compliance", "0.0031", "-0.012"):
        assert fact in curve.reading
    assert curve.reading in curve.approach.reading
    assert "Machine Comp 0.0031 nm/µN" in " ".join(str(curve).split())


def test_an_hld_that_was_cut_off(tmp_path):
    path = tmp_path / "test.hld"
    path.write_bytes(hld(points=400).encode("latin-1"))
    with pytest.raises(wk.InvalidInput, match="states 400 points of the test and holds 33; save it anew"):
        read_curve(path)
    path.write_bytes(hld().encode("latin-1")[:600])
    with pytest.raises(wk.InvalidInput, match="has no 'Test Data Points'"):
        read_curve(path)


def test_the_text_export(tmp_path):
    path = tmp_path / "test.txt"
    path.write_bytes(
        "Mon Apr 1 10:00:00 2019\n\nNumber of Points = 3\nDepth (nm)\tLoad (µN)\tTime (s)\tDepth (V)\tLoad (V)\n"
        "0.0\t0.0\t0.0\t1\t1\n\n2.0\t3.0\t0.1\t1\t1\n4.0\t9.0\t0.2\t1\t1\n".encode("latin-1")
    )
    curve = read_curve(path)
    np.testing.assert_allclose(curve.force, [0.0, 3e-6, 9e-6])
    assert curve.reading.startswith("Hysitron, text export: depth from 'Depth (nm)', force from 'Load (µN)', time from")


def test_dynamic_data(tmp_path):
    """The stiffness of the loading is kept beside the curve; points without one, and the unloading, are not in it."""
    header = "\t ".join(
        ["Test Time (s)", "Indent Disp. (nm)", "Indent Act. Load (µN)", "Indent Load (µN)", "Storage Stiff. (µN/nm)"]
    )
    rows = [
        f"{0.1 * i}\t{h}\t999\t{h**2}\t{'nan' if i == 3 else 2.0 * h}"
        for i, h in enumerate([0.0, 1.0, 2.0, 3.0, 4.0, 2.5])
    ]
    path = tmp_path / "dma.txt"
    path.write_bytes("\n".join(["nanoDMA Text Export Version 1.00", "", f" {header}", *rows]).encode("latin-1"))
    (placed,) = read_curves(path)
    np.testing.assert_allclose(placed.curve.force, 1e-6 * np.array([0.0, 1.0, 4.0, 9.0, 16.0, 6.25]))
    continuous = placed.continuous
    np.testing.assert_allclose(continuous.depth, [1e-9, 2e-9, 4e-9])
    np.testing.assert_allclose(continuous.stiffness, [2e3, 4e3, 8e3])
    np.testing.assert_allclose(continuous.time, [0.1, 0.2, 0.4])
    assert "continuous stiffness from 'Storage Stiff.' [µN/nm]: 3 points of the loading" in placed.curve.reading


@pytest.mark.parametrize("name", ["test.tdm", "test.tdx"])
def test_files_of_tdm_are_refused_by_name(tmp_path, name):
    (tmp_path / name).write_bytes(b"<usi:tdm/>" if name.endswith("m") else bytes(64))
    with pytest.raises(wk.InvalidInput, match=r"files of TDM .* export the test"):
        wk.read_curve(tmp_path / name)
