"""Line scans of instruments and published containers of measurements, written here byte by byte."""

from __future__ import annotations

import io
import re
import struct
import subprocess
import sys
import warnings
import zipfile

import numpy as np
import pytest

from winkler.io.tables.scan_table import read_scan
from winkler.io.tables.spectrum_table import read_spectrum
from winkler.io.topography_file import read_topography
from winkler.values.errors import InvalidInput

pytest.importorskip("SurfaceTopography", reason="the extra 'topography' is not installed")

PLACES = np.arange(200) * 0.5e-6
HEIGHTS = 1e-9 * np.round(40.0 * np.sin(PLACES / 3e-6) + 5.0 * np.sin(PLACES / 0.7e-6), 3)


def name(text):
    return struct.pack("<I", len(text.encode())) + text.encode()


def sized(content):
    return b"\x04" + struct.pack("<I", len(content)) + content


def item(label, type_id, content):
    return name(label) + bytes([type_id]) + content


def container(label, *items):
    return item(label, 0x7D, sized(b"".join(items) + item("", 0x7F, b"") + b"\0\0"))


def quantity(label, number, symbol):
    return item(label, 0x13, sized(struct.pack("<d", number) + name("a unit") + name(symbol)))


def opdx(heights_nm, extent_um):
    """A line scan of a Dektak XT as Gwyddion's dektakvca.c describes it: places and heights in their own units."""
    rows = np.asarray(heights_nm, dtype="<f8").tobytes()
    data = container(
        "1D_Data",
        container(
            "Raw",
            item("NumPoints", 0x06, struct.pack("<i", len(heights_nm))),
            quantity("Extent", extent_um, "µm"),
            quantity("DataScale", 1.0, "nm"),
            item("DataKind", 0x12, sized(b"Raw")),
            item("Array", 0x40, name("doubles") + sized(b"\0" * 5 + rows)),
        ),
    )
    channels = container("1D_Channels", item("Height", 0x42, name("list") + sized(name("Raw"))))
    meta = container("MetaData", item("DataKind", 0x12, sized(b"Surface Profile")), channels)
    return b"VCA DATA\x01\x00\x00\x55" + meta + data + item("", 0x7F, b"")


@pytest.fixture
def stylus(tmp_path):
    file = tmp_path / "scan.OPDx"
    file.write_bytes(opdx(HEIGHTS * 1e9, PLACES[-1] * 1e6))
    return file


def test_a_dektak_stylus(stylus):
    scan = read_scan(stylus)
    np.testing.assert_allclose(scan.position, PLACES, rtol=1e-12, atol=1e-18)
    np.testing.assert_allclose(scan.heights, HEIGHTS, rtol=1e-9, atol=1e-20)
    assert read_scan(stylus, channel="Raw") == scan
    assert read_spectrum(stylus) == scan.spectrum
    with pytest.raises(InvalidInput, match=r"there is no height channel 'Form'; give one of Raw\.$"):
        read_scan(stylus, channel="Form")
    with pytest.raises(InvalidInput, match=r"the file states its unit, µm, and nm was given; leave it out\.$"):
        read_scan(stylus, unit="nm")
    with pytest.raises(InvalidInput, match="no height map, but line scans; read them with read_scan, or"):
        read_topography(stylus)


def test_a_damaged_stylus_scan(stylus):
    stylus.write_bytes(stylus.read_bytes()[:300])
    with pytest.raises(InvalidInput, match="SurfaceTopography cannot read this file"):
        read_scan(stylus)


def test_two_columns_without_a_header(tmp_path):
    file = tmp_path / "scan.txt"
    file.write_text("".join(f"{x * 1e6:.6f} {z * 1e6:.9f}\n" for x, z in zip(PLACES, HEIGHTS, strict=True)))
    np.testing.assert_allclose(read_scan(file, unit="um").heights, HEIGHTS, atol=1e-15)
    with pytest.raises(InvalidInput, match=r"without a header above them; .*, or give its unit, such as u"):
        read_scan(file)


META = """
versions: {topobank: 1.0}
surfaces:
- name: ground steel
  topographies:
  - name: wide
    datafile: {original: wide.npy}
    data_source: 0
    size: [20.0, 10.0]
    unit: µm
    is_periodic: false
    height_scale: 0.001
    detrend_mode: center
    instrument: {name: probe, type: contact-based, parameters: {tip_radius: {value: 25.0, unit: nm}}}
  - name: a line
    datafile: {original: line.txt}
    data_source: 0
    size: [99.5]
    unit: µm
    is_periodic: false
    detrend_mode: center
"""
MAP = np.arange(32.0 * 16.0).reshape(32, 16) ** 1.5


@pytest.fixture
def published(tmp_path):
    """As contact.engineering packs uploaded files: heights in nm, with a factor to the unit of lengths."""
    array = io.BytesIO()
    np.save(array, MAP)
    line = "".join(f"{x * 1e6:.6f} {z * 1e6:.9f}\n" for x, z in zip(PLACES, HEIGHTS, strict=True))
    with zipfile.ZipFile(tmp_path / "steel.zip", "w") as pack:
        pack.writestr("meta.yml", META)
        pack.writestr("wide.npy", array.getvalue())
        pack.writestr("line.txt", line)
    return tmp_path / "steel.zip"


def test_a_published_container(published):
    rough = read_topography(published)
    np.testing.assert_allclose(rough.heights, (MAP - np.mean(MAP)) * 1e-9, rtol=1e-12, atol=1e-20)
    np.testing.assert_allclose(rough.lengths, [20e-6, 10e-6], rtol=1e-12)
    assert rough.tip_radius == pytest.approx(25e-9, rel=1e-12)
    assert read_topography(published, channel="wide") == rough
    assert read_topography(published, tip_radius=5e-9).tip_radius == 5e-9
    scan = read_scan(published)
    np.testing.assert_allclose(scan.heights, HEIGHTS - np.mean(HEIGHTS), atol=2e-12)
    with pytest.raises(InvalidInput, match=r"the container has no height map 'fine'; give one of wide\.$"):
        read_topography(published, channel="fine")


def test_a_container_that_the_library_writes(tmp_path):
    """Surfaces of two samples: names of measurements come behind those of their surfaces."""
    from SurfaceTopography import Topography
    from SurfaceTopography.Container.IO import write_containers
    from SurfaceTopography.Container.SurfaceContainer import InMemorySurfaceContainer

    maps = [
        Topography(1e-6 * k * MAP, (2.0, 1.0), unit="mm", periodic=k == 2, info={"name": f"map {k}"})
        for k in (1.0, 2.0)
    ]
    write_containers([InMemorySurfaceContainer([one]) for one in maps], str(tmp_path / "two.zip"))
    second = read_topography(tmp_path / "two.zip", channel="map 2.0")
    np.testing.assert_allclose(second.heights, 2e-9 * MAP, rtol=1e-9)
    assert second.periodic
    assert read_topography(tmp_path / "two.zip", channel="surface1/map 2.0") == second
    with pytest.raises(InvalidInput, match="the container holds no line scan, but surface0/map 1.0, surface1/map 2.0"):
        read_scan(tmp_path / "two.zip")


def test_damaged_containers(published, tmp_path):
    with zipfile.ZipFile(tmp_path / "empty.zip", "w") as pack:
        pack.writestr("meta.yml", "surfaces: 3")
    with pytest.raises(InvalidInput, match=r"empty\.zip: SurfaceTopography cannot read this file \("):
        read_topography(tmp_path / "empty.zip")
    with zipfile.ZipFile(tmp_path / "lost.zip", "w") as pack:
        pack.writestr("meta.yml", META)
    with pytest.raises(InvalidInput, match=r"lost\.zip: SurfaceTopography cannot read this file \("):
        read_topography(tmp_path / "lost.zip")


SHORT = {
    "one point": "0 0\n",
    "one point, no end of line": "0 0",
    "one row": "0,0,0,0,0\n",
    "one column": "0\n1\n2\n",
    "no number": "nan nan\n",
    "two points": "0 0\n1 2\n",
    "equal places": "1 0\n1 2\n" * 50,
}
LIBRARY = re.compile(r"index -?\d+ is|out of bounds|axis|tried|Reader|physical_sizes|dtype|NoneType|[\n`]")
"""What NumPy and SurfaceTopography say of such files."""


@pytest.mark.few(8)
@pytest.mark.parametrize("ending", [".txt", ".xyz", ".csv"])
@pytest.mark.parametrize("name", SHORT)
def test_files_of_too_few_points_are_refused_without_words_of_a_library(name, ending, tmp_path):
    """Issue 38, item 7: a scan of one point leaked a warning and NumPy's sentence."""
    file = tmp_path / f"short{ending}"
    file.write_text(SHORT[name], encoding="utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for read in (read_scan, read_topography):
            for unit in ("", "um"):
                with pytest.raises(InvalidInput) as refused:
                    read(file, unit=unit)
                assert LIBRARY.search(str(refused.value)) is None, str(refused.value)


@pytest.mark.slow
def test_the_library_of_instruments_warns_nobody(tmp_path):
    """It says in a new process that mpi4py is not there."""
    file = tmp_path / "short.opd"
    file.write_text("0 0\n", encoding="utf-8")
    code = f"import winkler as wk\ntry: wk.read_scan({str(file)!r}, unit='um')\nexcept wk.InvalidInput as e: print(e)"
    ended = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "(none of its formats fits); save it as a table with the columns place and height." in ended.stdout
