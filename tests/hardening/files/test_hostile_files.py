"""Files made to harm: bombs, endless devices, sizes that are lies, lines for which searches take for ever."""

from __future__ import annotations

import contextlib
import importlib
import io
import os
import struct
import sys
import tokenize
import tracemalloc
import zipfile
import zlib

import numpy as np
import pytest
from bounded import sentence_within

import winkler as wk
from winkler.io.curves import try_curves
from winkler.io.wear_states import read_wear
from winkler.study.language.reading import read_study
from winkler.values.errors import InvalidInput, WinklerError
from winkler.values.limits import MOST_NUMBERS
from winkler.values.units import scale
from winkler.web.session.upload_folder import UploadFolder

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="bounds are set as Linux does")

BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
SIZES = {"lengths": (1e-3, 1e-3), "unit": "nm"}
READERS = {
    "bed": wk.read_bed,
    "bounces": wk.read_bounces,
    "contacts": wk.read_contacts,
    "creep": wk.read_creep,
    "cross_profile": wk.read_cross_profile,
    "curve": wk.read_curve,
    "curves": lambda path: list(wk.read_curves(path)),
    "dynamic": wk.read_dynamic,
    "friction_log": wk.read_friction_log,
    "grading": wk.read_grading,
    "indenter": wk.read_indenter,
    "map": lambda path: wk.read_topography(path, **SIZES),
    "path": wk.read_path,
    "pin": wk.read_pin,
    "profile": wk.read_profile,
    "profile_pair": lambda path: wk.read_profile_pair(path, path),
    "relaxation": wk.read_relaxation,
    "dynamic_sweeps": wk.read_dynamic_sweeps,
    "held_force": lambda path: wk.read_held_force(path, profile=wk.Paraboloid(1e-3), depth=1e-5),
    "relaxation_sweeps": wk.read_relaxation_sweeps,
    "resistance_log": wk.read_resistance_log,
    "scan": wk.read_scan,
    "section": wk.read_section,
    "spectrum": wk.read_spectrum,
    "study": read_study,
    "surface_load": wk.read_surface_load,
    "wear": lambda path: read_wear(path, BED),
}


@pytest.fixture(scope="module", autouse=True)
def libraries():
    """Import what reads the files of instruments once, and not in every child."""
    for name in ("afmformats", "h5py", "SurfaceTopography.IO"):
        with contextlib.suppress(ImportError):
            importlib.import_module(name)
    scale("nm", "m")


def each(path, *besides: str) -> dict[str, str]:
    """Return how what every reader says of a path ends."""

    def all_of_them() -> None:
        message = []
        for name, read in READERS.items():
            if name in besides:
                continue
            try:
                read(path)
                message.append(f"{name}: read")
            except WinklerError as error:
                message.append(f"{name}: {str(error)[-160:]}")
        raise InvalidInput(*message)

    return dict(line.split(": ", 1) for line in sentence_within(all_of_them).split("\n"))


def test_every_reader_is_here():
    from winkler import public as names

    public = {name.removeprefix("read_") for name in names.__all__ if name.startswith("read_")}
    assert {name.replace("topography", "map") for name in public} <= {*READERS}


@pytest.mark.parametrize("place", ["/dev/zero", "/dev/null", "pipe"])
def test_devices_and_pipes_are_not_read(place, tmp_path):
    if place == "pipe":
        place = str(tmp_path / "pipe.csv")
        os.mkfifo(place)
    message = each(place)
    assert set(message) == set(READERS)
    assert {name: sentence for name, sentence in message.items() if "not a file with contents" not in sentence} == {}


@pytest.mark.parametrize("name", ["a" * 5000, "a" * 300 + ".npz", "b/" * 3000 + "c.csv"])
def test_names_that_no_system_takes(name):
    message = each(name)
    assert set(message) == set(READERS)
    assert {name: sentence for name, sentence in message.items() if "File name too long" not in sentence} == {}


@pytest.mark.parametrize("error", [RuntimeError("boom"), struct.error("boom"), zlib.error("boom"), IndexError("boom")])
def test_whatever_is_raised_while_reading_is_one_sentence(error, tmp_path, monkeypatch):
    def raising(*_, **__):
        raise error

    path = tmp_path / "file.csv"
    path.write_text("x [um],y\n1,2\n")
    monkeypatch.setattr("winkler.io.text_file.Path", raising)
    for name, read in READERS.items():
        if name != "study":
            with pytest.raises(InvalidInput, match=r"boom\); [^.\n]+\.$"):
                read(path)


def test_errors_of_libraries_that_are_no_exceptions(tmp_path):
    path = tmp_path / "curve.jpk-force"
    for content in (b"\0" * 50, b"PK\x03\x04" + b"\0" * 50, b"PK\x05\x06" + b"\0" * 18):
        path.write_bytes(content)
        with pytest.raises(InvalidInput, match=r"curve\.jpk-force: "):
            wk.read_curve(path)


# ------------------------------------------------------------------------------------------------------------ arrays


def header(shape: str, kind: str = "'<f8'", version: bytes = b"\x01\x00") -> bytes:
    text = f"{{'descr': {kind}, 'fortran_order': False, 'shape': {shape}, }}".encode().ljust(117) + b"\n"
    return b"\x93NUMPY" + version + struct.pack("<H", len(text)) + text


def packed(method: int = zipfile.ZIP_DEFLATED, **arrays: bytes) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as made:
        for name, content in arrays.items():
            made.writestr(f"{name}.npy", content)
    return stream.getvalue()


def saved(array) -> bytes:
    stream = io.BytesIO()
    np.save(stream, array)
    return stream.getvalue()


MAP = saved(np.arange(16.0).reshape(4, 4) ** 2)
SIDE = 9000
RECORD = saved(np.zeros(2, dtype=[("a", "<f8"), ("b", "<f8")]))
ARRAYS = {
    "a bomb": (packed(heights=header(f"({SIDE}, {SIDE})", "'|i1'") + bytes(SIDE**2)), "at most 67108864 numbers"),
    "packed by bzip2": (packed(zipfile.ZIP_BZIP2, heights=MAP), "packed by another method"),
    "packed by lzma": (packed(zipfile.ZIP_LZMA, heights=MAP), "packed by another method"),
    "a header of megabytes": (
        packed(heights=b"\x93NUMPY\x02\x00" + struct.pack("<I", 4_000_000) + b" " * 4_000_000),
        "expected 4000000 bytes got",
    ),
    "a shape that is a lie": (packed(heights=header("(8000, 8000)") + bytes(100)), "needs more bytes than"),
    "a shape without end": (packed(heights=header("(10**9, 9)")), "no file of numpy's arrays"),
    "more numbers than there are": (packed(heights=header("(99999999999999, 9)")), "at most 67108864 numbers"),
    "negative numbers": (packed(heights=header("(-4, -4)") + bytes(128)), "no file of numpy's arrays"),
    "a text that is huge": (
        packed(heights=MAP, unit=header("()", "'<U250000000'") + bytes(99)),
        "'unit' has the shape",
    ),
    "a header that is not closed": (packed(heights=header("(3, L'")), "no file of numpy's arrays"),
    "a header that is nested": (packed(heights=header("(" * 90 + ")" * 5)), "no file of numpy's arrays"),
    "another version": (packed(heights=header("(4, 4)", version=b"\x03\x00")), "the version 3.0 of the format"),
    "no array": (packed(heights=b"heights"), "no file of numpy's arrays"),
    "lengths of records": (packed(heights=MAP, lengths=RECORD), "'lengths' are of the type"),
    "lengths of texts": (packed(heights=MAP, lengths=saved(np.array(["1 um", "1 um"]))), "'lengths' are of the type"),
    "tiny lengths": (packed(heights=MAP, lengths=saved(np.full(2, 1e-320))), "Topography: lengths"),
    "huge lengths": (packed(heights=MAP, lengths=saved(np.full(2, 1e308))), "Topography: "),
    "missing lengths": (packed(heights=MAP, lengths=saved(np.full(2, np.nan))), "does not state the lengths"),
    "periodic of records": (packed(heights=MAP, periodic=RECORD), "'periodic' is of the type"),
    "periodic of texts": (packed(heights=MAP, periodic=saved(np.array("yes"))), "'periodic' is of the type"),
    "units in a row": (packed(heights=MAP, unit=saved(np.array(["nm", "um"]))), "'unit' is of the type"),
    "heights of records": (packed(heights=RECORD), "'heights' are of the type"),
    "a list of contents of gigabytes": (MAP and packed(heights=MAP)[:-10] + b"\xff" * 4 + bytes(6), "list of contents"),
    "a member that is damaged": (packed(heights=MAP).replace(MAP[:6], b"\0" * 6, 1)[:-40] + bytes(40), "map.npz"),
}


@pytest.mark.few(2, slow=6)
@pytest.mark.parametrize("case", ARRAYS)
def test_arrays_made_to_harm(case, tmp_path):
    content, sentence = ARRAYS[case]
    path = tmp_path / "map.npz"
    path.write_bytes(content)
    lengths = {} if "lengths" in case else {"lengths": SIZES["lengths"]}
    message = sentence_within(lambda: wk.read_topography(path, **lengths, **({} if "unit" in case else {"unit": "nm"})))
    assert sentence in message
    assert "raised" not in message
    for name in ("contacts", "wear"):
        assert sentence_within(lambda name=name: READERS[name](path)).startswith(str(path))


@pytest.mark.parametrize("error", [tokenize.TokenError("EOF in multi-line statement"), zipfile.BadZipFile("bad")])
def test_errors_within_numpy_are_one_sentence(error, tmp_path, monkeypatch):
    def raising(*_, **__):
        raise error

    (tmp_path / "map.npy").write_bytes(MAP)
    monkeypatch.setattr(np.lib.format, "read_array", raising)
    with pytest.raises(InvalidInput, match=r"map\.npy: this is no file of numpy's arrays \(.+\); write it by"):
        wk.read_topography(tmp_path / "map.npy", **SIZES)


def test_an_npy_file_that_states_more_than_it_has(tmp_path):
    path = tmp_path / "map.npy"
    path.write_bytes(header("(8000, 8000)") + bytes(1000))
    assert "needs more bytes than" in sentence_within(lambda: READERS["map"](path))


@pytest.mark.slow
def test_a_map_of_an_instrument_is_read(tmp_path):
    whole = np.lib.format.open_memmap(tmp_path / "map.npy", "w+", np.float64, (4096, 4096))
    whole[::7] = 3.0
    whole.flush()
    assert whole.size < MOST_NUMBERS
    assert wk.read_topography(tmp_path / "map.npy", **SIZES).heights.shape == (4096, 4096)


@pytest.mark.few(1)
@pytest.mark.parametrize("method", [zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_a_member_of_an_upload_that_unpacks_to_more_than_it_states(method):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as made:
        made.writestr("study.toml", bytes(15_000_000))
    content = stream.getvalue().replace(struct.pack("<I", 15_000_000), struct.pack("<I", 10))
    uploads = UploadFolder()
    tracemalloc.start()
    try:
        with pytest.raises(InvalidInput, match="cannot be read"):
            uploads.unpack(content, "study.toml")
        assert tracemalloc.get_traced_memory()[1] < 2_000_000
    finally:
        tracemalloc.stop()
        uploads.close()


# ------------------------------------------------------------------------------------------- files of other programs


def test_an_hdf5_file_that_states_gigabytes(tmp_path):
    h5py = pytest.importorskip("h5py")
    pytest.importorskip("afmformats")
    path = tmp_path / "curve.h5"
    with h5py.File(path, "w") as made:  # never written, and so of no size
        made.create_dataset("0/force", shape=(10**9,), dtype="f8", chunks=(1000,))
        made.attrs.update({"software": "afmformats", "software version": "0.18.4"})
    assert "its arrays have 8000 MB, at most 1000 MB are read" in sentence_within(lambda: wk.read_curve(path))


@pytest.mark.parametrize("name", ["curve.jpk-force", "surface.x3p"])
def test_archives_of_instruments_that_unpack_to_gigabytes(name, tmp_path):
    path = tmp_path / name
    content = packed(header=bytes(1_000_000), data=b"")
    stated = content.replace(struct.pack("<I", 1_000_000), struct.pack("<I", 3_000_000_000))
    path.write_bytes(stated)
    message = sentence_within(lambda: READERS["curve" if "curve" in name else "map"](path))
    assert "2 files of 3000 MB" in message
    path.write_bytes(b"something else" + stated)
    message = sentence_within(lambda: READERS["curve" if "curve" in name else "map"](path))
    assert ("2 files of 3000 MB" if "curve" in name else "SurfaceTopography cannot read this file") in message


# ------------------------------------------------------------------------------------------------------------- texts

GAP = " " * 16_000
LINES = {
    "spaces in a header": f"radius{GAP}x height{GAP}y\n1 2\n",
    "spaces behind a unit": f"radius [um]{GAP}y, height [nm]{GAP}y\n1,2\n",
    "spaces around a slash": f"radius{GAP}/ {GAP[:3000]}, height{GAP[:900]}\n1,2\n",
    "spaces before in": f"depth{GAP}in{GAP[:3000]}, force\n1,2\n",
    "brackets that are not closed": "radius " + "a(" * 9000 + " height\n1 2\n",
    "a spring constant of spaces": f"k (N/m){GAP}x\ndepth [nm],force [nN]\n0,0\n1,1\n",
    "a width of spaces": f"# Width: x{GAP * 5}y\n1 2 3 4\n",
    "a unit of digits": f"radius [m^{'9' * 190}], height [nm]\n1,2\n",
    "a unit of powers": "radius [((mm^12))^12], height [nm]\n1,2\n",
    "a long line": "radius [um], height [nm]," + "a" * 60_000 + "\n1,2\n",
    "a cell of digits": "depth [nm],force [nN]\n" + "9" * 1_000_000 + ",1\n1,1\n",
    "many columns": ",".join(f"radius depth force height{i}" for i in range(200)) + "\n1,2\n",
    "spring constants that are none": "k (N/m) 1-1\ndepth [nm],force [nN]\n0,0\n1,1\n",
}


def harmed(case, path):
    path.write_text(LINES[case])
    message = each(path, *() if "width" in case else ("map",))
    assert {*message, "map"} == set(READERS), (case, message)
    assert [name for name, end in message.items() if end == "read" and name not in ("curve", "curves")] == [], case


def test_a_text_made_to_harm(tmp_path):
    harmed("spaces around a slash", tmp_path / "table.csv")


@pytest.mark.slow
def test_texts_made_to_harm(tmp_path):
    for case in LINES:
        harmed(case, tmp_path / "table.csv")


def test_a_table_of_too_many_lines(tmp_path, monkeypatch):
    monkeypatch.setattr("winkler.io.text_file.TEXT_LINES", 1000)
    for end in ("\n", "\r", "\r\n"):
        (tmp_path / "tip.csv").write_bytes(f"r [um],h [nm]{end}".encode() + f"1,2{end}".encode() * 1000)
        with pytest.raises(InvalidInput, match=r"tip\.csv: the file has more than 1000 lines; thin it out"):
            wk.read_profile(tmp_path / "tip.csv")


def test_a_matrix_of_too_many_numbers(tmp_path, monkeypatch):
    monkeypatch.setattr("winkler.io.height_matrix.MOST_NUMBERS", 1000)
    path = tmp_path / "map.csv"
    np.savetxt(path, np.arange(2000.0).reshape(40, 50))
    with pytest.raises(InvalidInput, match="heights or more; at most 1000 are read, 31 x 31"):
        wk.read_topography(path, **SIZES)


def test_columns_of_a_header_are_known_as_before(tmp_path):
    for text in (
        "radius [um];height (nm)", "radius/um,height / nm", "radius in um,height in nm", "radius_um height_nm",
        "r (um)\th [nm]", "radius um,height nm", "x [um], z [nm]", "# radius [um] height [nm]",
    ):  # fmt: skip
        mark = ";" if ";" in text else "\t" if "\t" in text else "," if "," in text else " "
        path = tmp_path / "tip.csv"
        rows = [f"{i}{mark}{i**2}" for i in range(8)]
        path.write_text("\n".join([text, *rows]) + "\n")
        assert wk.read_profile(path).radii[1] == pytest.approx(1e-6, rel=1e-15), text


def zip_of(path, members, before=b""):
    pack = io.BytesIO()
    with zipfile.ZipFile(pack, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    path.write_bytes(before + pack.getvalue())


@pytest.mark.parametrize("before", [b"", b"in front of the list of contents"])
def test_an_archive_within_an_archive_of_curves_stays_closed(before, tmp_path):
    zip_of(tmp_path / "inner.zip", {"curve.csv": "depth [nm],force [nN]\n0,0\n1,1\n2,3\n"}, before)
    zip_of(tmp_path / "outer.zip", {"inner.zip": (tmp_path / "inner.zip").read_bytes()})
    (found,) = try_curves(tmp_path / "outer.zip")
    assert "an archive within an archive is not opened" in found.reason


def test_an_archive_of_too_many_curves(tmp_path):
    pytest.importorskip("afmformats")
    zip_of(tmp_path / "many.zip", {f"{number}.txt": "" for number in range(10_001)})
    assert "10001" in sentence_within(lambda: list(wk.read_curves(tmp_path / "many.zip"))).replace(",", "")
