"""Height maps from files: plain matrices in every layout, arrays, files of instruments, and every refusal."""

from __future__ import annotations

import io
import sys
import zipfile

import numpy as np
import pytest

from winkler.io.topography_file import read_topography
from winkler.values.errors import InvalidInput

HEIGHTS = np.arange(20.0).reshape(5, 4) * 0.25
"""In nm; exact in binary and in text."""
HOLED = np.where(HEIGHTS == 1.5, np.nan, HEIGHTS)
SIZES = (5e-6, 2e-6)


def rows(separator, heights=HEIGHTS, end=""):
    return "".join(separator.join(map(repr, row)) + end + "\n" for row in heights.tolist())


@pytest.fixture
def file(tmp_path, monkeypatch):
    """Writes into an empty folder that is the current one, and returns the name."""
    monkeypatch.chdir(tmp_path)

    def write(content, name="map.csv"):
        (tmp_path / name).write_bytes(content.encode() if isinstance(content, str) else content)
        return name

    return write


LAYOUTS = {
    "commas": rows(","),
    "semicolons": rows("; "),
    "tabs": rows("\t"),
    "spaces": rows("   "),
    "a separator at the end": rows(",", end=","),
    "comments and blank lines": "# tip 7\n% scan\n\n" + rows(" ") + "\n",
    "a mark at the start": "\ufeff" + rows(","),
    "carriage returns": rows(",").replace("\n", "\r\n"),
    "Latin-1": ("# Fläche in µm\n" + rows(",")).encode("latin-1"),
    "blanks at the start": "".join("  " + line + "\n" for line in rows(" ").splitlines()),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_matrices(file, layout):
    rough = read_topography(file(LAYOUTS[layout]), lengths=SIZES, unit="nm")
    np.testing.assert_array_equal(rough.heights, HEIGHTS / 1e9)
    assert rough.lengths.tolist() == list(SIZES)
    assert not rough.periodic


@pytest.mark.parametrize("empty", ["nan", "NaN", "", "-", "n/a"])
def test_missing_heights(file, empty):
    text = rows(",").replace("1.5,", f"{empty},", 1)
    rough = read_topography(file(text), lengths=SIZES, unit="nm", periodic=True)
    np.testing.assert_array_equal(rough.heights, HOLED / 1e9)
    assert rough.missing == 1
    assert rough.periodic


@pytest.mark.parametrize(("unit", "metre"), [("nm", 1e9), ("um", 1e6), ("µm", 1e6), ("mm", 1e3), ("m", 1.0)])
def test_units(file, unit, metre):
    rough = read_topography(file(rows("\t"), "map.txt"), lengths=(5e3 / metre, 2e3 / metre), unit=unit)
    np.testing.assert_array_equal(rough.heights, HEIGHTS / metre)


GWYDDION = "# Channel: Topography\n# Width: 2.0 µm\n# Height: 5.0 µm\n# Value units: nm\n"


def test_what_gwyddion_writes_above_a_matrix(file):
    """Its width is along the lines, which is the second direction."""
    name = file(GWYDDION + rows("\t"), "map.txt")
    rough = read_topography(name)
    np.testing.assert_array_equal(rough.heights, HEIGHTS / 1e9)
    np.testing.assert_allclose(rough.lengths, SIZES, rtol=1e-15)
    assert read_topography(name, unit="nm") == rough
    assert read_topography(name, lengths=(1.0, 2.0)).lengths.tolist() == [1.0, 2.0]
    with pytest.raises(
        InvalidInput, match=r"^map.txt: the file states its unit, nm, and um was given; leave it out\.$"
    ):
        read_topography(name, unit="um")
    with pytest.raises(InvalidInput, match=r"^map\.txt, '# Width': '2\.0 s' is a time, not a length"):
        read_topography(file(GWYDDION.replace("2.0 µm", "2.0 s") + rows("\t"), "map.txt"))


def test_arrays(tmp_path):
    np.save(tmp_path / "map.npy", HOLED)
    rough = read_topography(tmp_path / "map.npy", lengths=SIZES, unit="nm")
    np.testing.assert_array_equal(rough.heights, HOLED / 1e9)
    np.save(tmp_path / "whole.npy", np.arange(20, dtype=np.int16).reshape(5, 4))
    assert read_topography(tmp_path / "whole.npy", lengths=(5.0, 2.0), unit="m").heights[4, 3] == 19.0
    np.savez(tmp_path / "map.npz", heights=HEIGHTS, lengths=[5000.0, 2000.0])
    rough = read_topography(tmp_path / "map.npz", unit="nm")
    np.testing.assert_array_equal(rough.heights, HEIGHTS / 1e9)
    np.testing.assert_allclose(rough.lengths, SIZES, rtol=1e-15)
    np.savez_compressed(tmp_path / "stated.npz", heights=HEIGHTS, lengths=[5000.0, 2000.0], unit="nm", periodic=True)
    message = read_topography(tmp_path / "stated.npz")
    assert message.periodic
    np.testing.assert_array_equal(message.heights, rough.heights)


MATRIX = [
    # content, sentence behind the name
    ("", ": the file is empty; it needs a matrix of heights."),
    ("# nothing\n", ": there are no heights; give a matrix, one row in a line."),
    ("1,2,3,4\n1,2,3\n", ", line 2: there are 3 heights, and 4 above; give rows of equal length."),
    (
        rows(",").replace("1.25", "high"),
        ", line 2: 'high' is no height; give a matrix of numbers, nan where they are missing.",
    ),
    (
        rows(";").replace("1.25", "1,25"),
        ", line 2: '1,25' has a comma, and '1.0' a point; write one decimal sign in the whole file.",
    ),
    (
        rows(";").replace("1.25", "1,250"),
        ", line 2: '1,250' has a comma, which is ambiguous; write '1250' if it groups thousands, '1.250' if it is the "
        "decimal sign.",
    ),
    (
        rows(",", HEIGHTS[:, :2]),
        ": a matrix of 5 x 2 numbers is no map, but a scan or a list of points; give at least 4 x 4 heights.",
    ),
    (b"\x89PNG\r\n\x1a\n", ": the file is not a text; save the table as text (CSV) in UTF-8."),
    (b"[Paramco32]\nDAC-Type=20bit\n\x00\x01", ": this is an image of Createc; save its heights from there, or from"),
    (b"PK\x03\x04 and so on", ": this is a spreadsheet or an archive; save the table as text (CSV)."),
    (rows(",").replace("1.25", "inf"), ": Topography: heights are infinite, or all missing; give finite ones, nan for"),
    (rows(",", HEIGHTS * np.nan), ": Topography: heights are infinite, or all missing; give finite ones, nan for"),
]


@pytest.mark.parametrize(("content", "sentence"), MATRIX, ids=[repr(content)[:30] for content, _ in MATRIX])
def test_what_is_no_matrix(file, content, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_topography(file(content), lengths=SIZES, unit="nm")
    assert str(caught.value).startswith("map.csv" + sentence)


@pytest.mark.parametrize(
    ("names", "sentence"),
    [
        (("main.xml", "md5checksum.hex"), "heights stand in its main.xml; save it anew with binary data"),
    ],
)
def test_x3p_of_other_forms_are_named(tmp_path, names, sentence):
    path = tmp_path / "land.x3p"
    with zipfile.ZipFile(path, "w") as archive:
        for name in names:
            archive.writestr(name, "<x3p/>")
    with pytest.raises(InvalidInput, match=sentence):
        read_topography(path)


def packed(**arrays):
    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return stream.getvalue()


def saved(array):
    stream = io.BytesIO()
    np.save(stream, array)
    return stream.getvalue()


def archive():
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as made:
        made.writestr("readme.txt", "none")
    return stream.getvalue()


ARRAYS = [
    ("map.npz", packed(z=HEIGHTS), ": it holds z; the array of heights must be called 'heights'."),
    ("map.npz", archive(), ": it holds readme.txt; the array of heights must be called 'heights'."),
    ("map.npz", packed(heights=HEIGHTS, lengths=[1.0]), ": 'lengths' have the shape (1,); write both lengths of"),
    ("map.npz", packed(heights=HEIGHTS, lengths=["a", "b"]), ": 'lengths' are of the type <U1; write real numbers."),
    ("map.npz", packed(heights=HEIGHTS, lengths=[1.0, -1.0]), ": Topography: lengths is "),
    ("map.npz", packed(heights=HEIGHTS)[:200], ": this is no file of numpy's arrays ("),
    ("map.npy", b"", ": this is no file of numpy's arrays (No data left in file); write it by numpy.save."),
    ("map.npy", b"height,map\n", ": this is no file of numpy's arrays ("),
    ("map.npy", saved(np.array([{}])), ": this is no file of numpy's arrays (Object arrays cannot be loaded"),
    ("map.npy", saved(HEIGHTS + 1j), ": 'heights' are of the type complex128; write real numbers."),
    ("map.npy", saved(HEIGHTS[0]), ": Topography: heights have the shape (4,); give a map of at least 2 x 2 pixels"),
]


@pytest.mark.parametrize(("name", "content", "sentence"), ARRAYS, ids=[sentence[:40] for *_, sentence in ARRAYS])
def test_what_is_no_array(file, name, content, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_topography(file(content, name), unit="nm", **({"lengths": SIZES} if name.endswith("npy") else {}))
    assert str(caught.value).startswith(name + sentence)


def test_an_array_that_does_not_fit_the_memory(file, monkeypatch):
    def none_left(*_, **__):
        raise MemoryError("Unable to allocate 74.5 GiB for an array with shape (100000, 100000)")

    monkeypatch.setattr(np.lib.format, "read_array", none_left)
    with pytest.raises(InvalidInput) as caught:
        read_topography(file(saved(HEIGHTS), "map.npy"), unit="nm", lengths=SIZES)
    assert str(caught.value) == (
        "map.npy: it does not fit the memory of this machine (Unable to allocate 74.5 GiB for an array with shape "
        "(100000, 100000)); save a part of it."
    )


def test_what_has_to_be_stated(file):
    name = file(rows(","))
    for message, sentence in (
        ({}, "map.csv: the file does not state the unit of its heights; give unit, such as 'nm' or 'um'."),
        ({"unit": "nm"}, "map.csv: the file does not state the lengths of the map; give lengths=(x, y) in m."),
        ({"unit": "nmm"}, "map.csv, unit: 'nmm' cannot be read: the unit 'nmm' is unknown (did you mean 'nm'?)."),
        ({"unit": "kg"}, "map.csv, unit: 'kg' is the unit of a mass, not of a length."),
        ({"unit": "nm", "lengths": (1.0, 2.0, 3.0)}, "map.csv: lengths are (1.0, 2.0, 3.0); give two numbers, in m."),
        ({"unit": "nm", "lengths": (1.0, 0.0)}, "map.csv: Topography: lengths is "),
    ):
        with pytest.raises(InvalidInput) as caught:
            read_topography(name, **message)
        assert str(caught.value).startswith(sentence)
    np.save("map.npy", HEIGHTS)
    with pytest.raises(InvalidInput, match=r"^map\.npy: an array has no channels; leave channel 'Height' out\.$"):
        read_topography("map.npy", unit="nm", channel="Height")


def test_files_that_are_not_there(file):
    file("", "map_A.npy")
    for path, sentence in (
        (
            "map_a.npy",
            "map_a.npy: there is no such file in '.' (did you mean 'map_A.npy'?); give the path of a height map.",
        ),
        (".", ".: this is a folder; give a file in it."),
        (3, "3 is no path of a file; give one such as 'tip.csv'."),
    ):
        with pytest.raises(InvalidInput) as caught:
            read_topography(path, unit="nm")
        assert str(caught.value) == sentence


def test_without_the_extra_it_says_what_to_install(file, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    monkeypatch.setitem(sys.modules, "SurfaceTopography.IO", None)
    with pytest.raises(InvalidInput) as caught:
        read_topography(file(b"\x01\x02", "afm.spm"))
    assert str(caught.value) == (
        'afm.spm: files of instruments are read by SurfaceTopography; install it by pip install "winkler[topography]".'
    )


@pytest.fixture
def instruments(shared_data):
    pytest.importorskip("SurfaceTopography", reason="the extra 'topography' is not installed")
    return shared_data / "topographies"


def test_an_atomic_force_microscope(instruments):
    """Digital Instruments, 10 um: against the numbers that SurfaceTopography gives."""
    from SurfaceTopography import read_topography as reference_reader

    rough = read_topography(instruments / "di-3.di")
    message = reference_reader(str(instruments / "di-3.di"))
    assert rough.heights.shape == (256, 256)
    np.testing.assert_allclose(rough.lengths, 1e-5, rtol=1e-12)
    assert rough.missing == 0
    assert rough.rms_height == pytest.approx(message.Sq() * 1e-9, rel=1e-12)
    other = read_topography(instruments / "di-3.di", channel="Height")
    assert other.rms_height > 1.1 * rough.rms_height
    with pytest.raises(
        InvalidInput, match=r"di-3\.di: there is no height channel 'Phase'; give one of ZSensor, Height"
    ):
        read_topography(instruments / "di-3.di", channel="Phase")
    with pytest.raises(InvalidInput, match=r"di-3\.di: the file states its unit, nm, and um was given; leave it out"):
        read_topography(instruments / "di-3.di", unit="um")


def test_a_map_with_missing_heights(instruments):
    """Digital Surf, in mm, pixels almost square."""
    rough = read_topography(instruments / "sur-2.sur")
    assert rough.heights.shape == (563, 484)
    np.testing.assert_allclose(rough.lengths, [1.9614921233e-3, 1.6862561060e-3], rtol=1e-9)
    assert rough.missing == 117
    assert rough.rms_height == pytest.approx(1.7517881e-8, rel=1e-6)
    whole = rough.detrended(1).filled()
    assert whole.missing == 0
    known = ~np.isnan(rough.heights)
    np.testing.assert_array_equal(whole.heights[known], rough.detrended(1).heights[known])


@pytest.mark.parametrize("name", ["dektak-1.csv", "xy-1.txt"])
def test_line_scans_are_no_maps(instruments, name):
    with pytest.raises(InvalidInput, match=f"{name}: it holds no height map, but line scans; read them with read_s"):
        read_topography(instruments / name, channel="default")
    with pytest.raises(InvalidInput, match=f"{name}(, line 1: 'Scan' is no height|: a matrix of 132 x 2 numbers)"):
        read_topography(instruments / name, unit="um", lengths=SIZES)


def test_what_surface_topography_cannot_read(file, instruments):
    with pytest.raises(InvalidInput, match=r"^afm\.spm: SurfaceTopography cannot read this file \("):
        read_topography(file(b"\x01\x02" * 500, "afm.spm"))
    cut = (instruments / "sur-2.sur").read_bytes()[:5000]
    with pytest.raises(InvalidInput, match=r"^cut\.sur: SurfaceTopography cannot read this file \("):
        read_topography(file(cut, "cut.sur"))


def test_heights_in_another_unit_than_lengths(tmp_path):
    """Lengths that stand in m in a file of nm: no surface is that steep."""
    file = tmp_path / "map.npz"
    np.savez(file, heights=np.random.default_rng(0).normal(scale=500.0, size=(16, 16)), lengths=[1e-3, 1e-3])
    with pytest.raises(InvalidInput, match=r"map.npz: heights of 5\S+ m on pixels of 6.25e-14 m are no surface; check"):
        read_topography(file, unit="nm")


def test_texts_with_missing_last_heights_and_with_counted_rows(tmp_path):
    ragged = tmp_path / "ragged.csv"
    ragged.write_text("1,2,3,4,5\n1,2,3,4,\n1,2,3,4,5\n1,2,3,4,5\n", encoding="utf-8")
    message = read_topography(ragged, unit="nm", lengths=(1e-6, 1e-6))
    assert message.heights.shape == (4, 5)
    assert message.missing == 1
    counted = tmp_path / "counted.csv"
    rows = "\n".join(f"{i},0.5,0.25,0.125,1.5" for i in range(5))
    counted.write_text(f",0,1,2,3\n{rows}\n", encoding="utf-8")
    with pytest.raises(InvalidInput, match="the first row and the first column count 0, 1, 2 and so on"):
        read_topography(counted, unit="nm", lengths=(1e-6, 1e-6))


def test_lengths_are_handed_on_to_files_that_do_not_state_them(tmp_path):
    """They were refused: "the file does not state how long its height map is; save it as an NPY file"."""
    pytest.importorskip("SurfaceTopography")
    from scipy.io import savemat

    heights = np.random.default_rng(7).normal(size=(20, 30))
    savemat(tmp_path / "map.mat", {"heights": heights})
    rough = read_topography(tmp_path / "map.mat", unit="nm", lengths=(2e-6, 3e-6))
    assert rough.lengths == pytest.approx((2e-6, 3e-6))
    assert rough.heights == pytest.approx(heights * 1e-9)
    for unknown in ({}, {"lengths": (float("nan"), float("nan"))}):
        with pytest.raises(InvalidInput, match=r"give lengths=\(x, y\) in m"):
            read_topography(tmp_path / "map.mat", unit="nm", **unknown)


def test_bytes_of_a_square_number_are_no_map(tmp_path):
    """A reader of bare integers takes them for one, whatever they are."""
    pytest.importorskip("SurfaceTopography")
    (tmp_path / "picture.bin").write_bytes(bytes(range(200)))
    with pytest.raises(InvalidInput, match="does not state how long"):
        read_topography(tmp_path / "picture.bin", unit="nm", lengths=(2e-6, 3e-6))


@pytest.mark.parametrize("shape", [(90, 1), (1, 90)])
def test_a_row_of_heights_without_places_is_neither_a_map_nor_a_scan(tmp_path, shape):
    pytest.importorskip("SurfaceTopography")
    from scipy.io import savemat

    savemat(tmp_path / "profile.mat", {"z": np.sin(np.arange(90.0)).reshape(shape)})
    with pytest.raises(InvalidInput, match="a row of 90 numbers without their places.*columns place and height"):
        read_topography(tmp_path / "profile.mat", unit="um", lengths=(1e-3, 1e-3))


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_a_log_is_told_before_the_readers_of_texts_are_tried(encoding, tmp_path, monkeypatch):
    """One of them reads a text anew below each line: 9,000 rows of a tribometer took 299 s to be refused."""
    library = pytest.importorskip("SurfaceTopography.IO")
    monkeypatch.setattr(library, "open_topography", lambda path: pytest.fail("the readers were tried"))
    rows = [f"4,{0.1 * n:.1f},9.0,nan,{437.0 + n % 7:g},0,-115.4" for n in range(2000)]
    path = tmp_path / "log.csv"
    path.write_text(
        "\n".join(["Recipe, Averaging", "Rotary,100", "Step, Timestamp, Fz, COF, rpm, X, Y", *rows]), encoding
    )
    with pytest.raises(InvalidInput, match=r"log\.csv"):
        read_topography(path)


def test_a_map_in_the_text_of_iso_25178_is_no_log(tmp_path):
    """Its rows hold as many numbers as the instrument likes, here four."""
    pytest.importorskip("SurfaceTopography")
    heights = np.sin(np.arange(80.0))[:, None] * np.cos(np.arange(60.0)) * 1e-7
    facts = {
        "ManufacID": "made",
        "CreateDate": "010120260000",
        "ModDate": "010120260000",
        "NumPoints": 60,
        "NumProfiles": 80,
        "Xscale": 1e-6,
        "Yscale": 1e-6,
        "Zscale": 1.0,
        "Zresolution": -1,
        "Compression": 0,
        "DataType": 7,
        "CheckType": 0,
    }
    head = ["aISO-1.0", *(f"{name} = {stated}" for name, stated in facts.items()), "*"]
    cells = [f"{height:.9e}" for height in heights.ravel()]
    path = tmp_path / "map.sdf"
    path.write_text("\n".join([*head, *(" ".join(cells[n : n + 4]) for n in range(0, len(cells), 4)), "*", ""]))
    np.testing.assert_allclose(np.sort(read_topography(path).heights.ravel()), np.sort(heights.ravel()), atol=1e-16)
