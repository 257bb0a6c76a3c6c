"""Tables and measured profiles from files: every layout that is read, and every refusal with its sentence."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.io.tables.profile_table import read_profile
from winkler.io.tables.table import Column, read_table
from winkler.profiles.measured import Measured
from winkler.values.errors import InvalidInput

RADIUS = Column("radius", ("radius", "r", "x"), "m", "um")
HEIGHT = Column("height", ("height", "h", "z", "f"), "m", "nm")

RADII = np.arange(13) * 0.25
"""In um; exact in binary and in text."""
HEIGHTS = 12.5 * RADII**2
"""In nm: a paraboloid with R = 40 um."""


def rows(separator, radii=RADII, heights=HEIGHTS):
    return "\n".join(f"{r!r}{separator}{h!r}" for r, h in zip(radii.tolist(), heights.tolist(), strict=True)) + "\n"


@pytest.fixture
def file(tmp_path, monkeypatch):
    """Writes ``tip.csv`` into an empty folder that is the current one, and returns its name."""
    monkeypatch.chdir(tmp_path)

    def write(content, name="tip.csv"):
        (tmp_path / name).write_bytes(content.encode() if isinstance(content, str) else content)
        return name

    return write


LAYOUTS = {
    "commas": "radius [um], height [nm]\n" + rows(","),
    "commas and spaces": "radius [um], height [nm]\n" + rows(" , "),
    "semicolons": "r (µm);f (nm)\n" + rows(";"),
    "tabs": "r (um)\tz (nm)\n" + rows("\t"),
    "spaces": "x [um]  h [nm]\n" + rows("   "),
    "unit after an underscore": "radius_um,height_nm\n" + rows(","),
    "spaces and underscores": "  radius_um height_nm\n" + rows("  "),
    "unit after a stroke": "r / um; f / nm\n" + rows(";"),
    "unit after a space": "Radius um,Height nm\n" + rows(","),
    "unit in words": "r in um, h in nm\n" + rows(","),
    "quoted": '"Radius (um)","Height (nm)"\n' + rows(","),
    "a row of units": "r,h\num,nm\n" + rows(","),
    "a row of units in brackets": "r;h\n[um];[nm]\n" + rows(";"),
    "a row of units among spaces": "r h\num nm\n" + rows(" "),
    "header in a comment": "# radius [um], height [nm]\n" + rows(","),
    "header in a comment, cells apart by spaces": "# radius [um], height [nm]\n" + rows(" "),
    "text above the header": "Tip 7\nScan, 2024-05-02\n# a comment\n\nr [um],h [nm]\n" + rows(","),
    "comments and blank lines": "r [um],h [nm]\n\n# halfway\n" + rows(",").replace("\n", "  # a remark\n", 1) + "\n\n",
    "other columns": "n,r [um],remark,h [nm]\n"
    + "".join(f"{n},{r},good,{h}\n" for n, (r, h) in enumerate(zip(RADII, HEIGHTS, strict=True))),
    "columns in reverse order": "h [nm],r [um]\n" + rows(",", HEIGHTS, RADII),
    "empty cells at the end": "r [um],h [nm]\n" + rows(",").replace("\n", ",,\n"),
    "capitals": "RADIUS [um],HEIGHT [nm]\n" + rows(","),
    "carriage returns and newlines": ("r [um],h [nm]\n" + rows(",")).replace("\n", "\r\n"),
    "carriage returns": ("r [um],h [nm]\n" + rows(",")).replace("\n", "\r"),
    "a mark at the start": "\ufeffr [um],h [nm]\n" + rows(","),
    "Latin-1": ("r [µm],h [nm]\n" + rows(",")).encode("latin-1"),
    "no newline at the end": ("r [um],h [nm]\n" + rows(",")).rstrip(),
    "other units": "r [mm],h [m]\n" + rows(",", RADII * 1e-3, HEIGHTS * 1e-9),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_layouts(file, layout):
    table = read_table(file(LAYOUTS[layout]), (RADIUS, HEIGHT))
    np.testing.assert_allclose(table.values[:, 0], RADII * 1e-6, rtol=4e-16, atol=0.0)
    np.testing.assert_allclose(table.values[:, 1], HEIGHTS * 1e-9, rtol=4e-16, atol=0.0)
    assert table.path == "tip.csv"
    assert table.lines.shape == (13,)


def test_numbers_are_rounded_once(file):
    table = read_table(file("r [nm],h [um]\n3,7\n0.3,1.1\n"), (RADIUS, HEIGHT))
    np.testing.assert_array_equal(table.values, [[3e-9, 7e-6], [0.3e-9, 1.1e-6]])


def test_every_row_knows_its_line(file):
    table = read_table(file("# a\nr [um],h [nm]\n\n1,2\n# b\n3,4\n"), (RADIUS, HEIGHT))
    np.testing.assert_array_equal(table.lines, [4, 6])


def test_columns_of_other_kinds(file):
    wanted = (Column("force", ("force", "load"), "N"), Column("time", ("time", "t"), "s"))
    table = read_table(file("Time (ms)\tLoad (uN)\n1\t2\n3\t4\n"), wanted)
    np.testing.assert_array_equal(table.values, [[2e-6, 1e-3], [4e-6, 3e-3]])


NAMES = "; name the columns, as in 'radius [um], height [nm]'."
NEITHER = ": the header has no radius (radius, r, x) and no height (height, h, z, f), there are "
NO_HEADER = " without a header above them; write one, as 'radius [um], height [nm]'."
NO_UNIT = "; write it in the header, as 'radius [um], height [nm]'."
EMPTY = ": the file is empty; it needs a header such as 'radius [um], height [nm]', and numbers below."
POINTS = "a comma; write decimals with a point and thousands without, as "
MISSING = ": a number is missing or not finite; complete or delete the line"
UTF16 = ": the file is damaged UTF-16; save it anew as UTF-8."
SPREADSHEET = ": this is a spreadsheet or an archive; save the table as text (CSV)."
NO_TEXT = ": the file is not a text; save the table as text (CSV) in UTF-8."

REFUSED = [
    # content of the file, what the sentence says behind its name
    ("", EMPTY),
    (" \n\n \t\n", EMPTY),
    ("\ufeff", EMPTY),
    ("1,2\n3,4\n", ": numbers begin in line 1" + NO_HEADER),
    ("\n\n1\t2\n", ": numbers begin in line 3" + NO_HEADER),
    ("0,5;1,5\n", ": numbers begin in line 1" + NO_HEADER),
    ("# by hand\n1 2\n", NEITHER + "'by', 'hand'" + NAMES),
    ("a [um],b [nm]\n1,2\n", NEITHER + "'a [um]', 'b [nm]'" + NAMES),
    ("hello\nworld\n", NEITHER + "'world'" + NAMES),
    (
        "radus [um],height [nm]\n1,2\n",
        ": the header has no radius (radius, r, x), there are 'radus [um]', 'height [nm]'" + NAMES,
    ),
    ("radius [um]\n1\n", ": the header has no height (height, h, z, f), there are 'radius [um]'" + NAMES),
    (
        "r [um],z [nm],h [nm]\n1,2,3\n",
        ", line 1: 'z [nm]' (column 2) and 'h [nm]' (column 3) may each be the height; rename all but one.",
    ),
    (
        "x [um],r [um],h [nm]\n1,2,3\n",
        ", line 1: 'x [um]' (column 1) and 'r [um]' (column 2) may each be the radius; rename all but one.",
    ),
    ("r,h\n1,2\n", ", line 1: no unit stands with 'r' and 'h'" + NO_UNIT),
    ("r [um],h\n1,2\n", ", line 1: no unit stands with 'h'" + NO_UNIT),
    ("r [],h [-]\n1,2\n", ", line 1: no unit stands with 'r []' and 'h [-]'" + NO_UNIT),
    ("r,h\n", ", line 1: no unit stands with 'r' and 'h'" + NO_UNIT),
    ("r;h\n0,5;1\n", ", line 1: no unit stands with 'r' and 'h'" + NO_UNIT),
    ("r [kg],h [nm]\n1,2\n", ", line 1, radius: 'kg' is the unit of a mass, not of a length."),
    ("r [um],h [deg]\n1,2\n", ", line 1, height: 'deg' is the unit of an angle, not of a length."),
    (
        "r [umm],h [nm]\n1,2\n",
        ", line 1, radius: 'umm' cannot be read: the unit 'umm' is unknown (did you mean 'um'?).",
    ),
    ("r,h\nnnm,nm\n1,2\n", ", line 2, radius: 'nnm' cannot be read: the unit 'nnm' is unknown (did you mean 'nm'?)."),
    ("r [um],h [nm]\n", ": there are no numbers below the header in line 1."),
    ("r,h\num,nm\n# 1,2\n", ": there are no numbers below the header in line 2."),
    ("r [um],h [nm]\n1,2\nabc,3\n", ", line 3: 'abc' in the column 'r [um]' is not a number."),
    ("r [um],h [nm]\n1,2\n3,4 nm\n", ", line 3: '4 nm' in the column 'h [nm]' is not a number."),
    ("r [um],h [nm]\n1_0,2\n", ", line 2: '1_0' in the column 'r [um]' is not a number."),
    ("r [um],h [nm]\n0x10,2\n", ", line 2: '0x10' in the column 'r [um]' is not a number."),
    (
        "r [um];h [nm]\n0.5;1\n0,5;1,25\n",
        ", line 3: '0,5' has a comma, and '0.5' a point; write one decimal sign in the whole file.",
    ),
    (
        "r [um],h [nm]\n0,5,1,25\n",
        ", line 2: the line has 4 and the header 2 cells; if commas mark decimals or group thousands, write 1.5 and "
        "1000.",
    ),
    (
        "r [um];h [nm]\n0.5;1\n1,000;2\n",
        ", line 3: '1,000' has a comma, which is ambiguous; write '1000' if it groups thousands, '1.000' if it is the "
        "decimal sign.",
    ),
    ("r [um];h [nm]\n0.5;1\n1;2,345.5\n", ", line 3: '2,345.5' has " + POINTS + "'2345.5'."),
    ("r [um];h [nm]\n1;2\n1\n", ", line 3: the line has 1 and the header 2 cells."),
    ("r [um];h [nm]\n1;2\n1;2;3\n", ", line 3: the line has 3 and the header 2 cells."),
    ("r [um],h [nm]\n1,2\nnan,3\n", ": line 3" + MISSING + "."),
    ("r [um],h [nm]\n1,1e999\n", ": line 2" + MISSING + "."),
    ("r [um],h [nm]\n1,2\n2,\n3,inf\n4,1\n,5\n", ": lines 3, 4, 6" + MISSING + "s."),
    ("r [um],h [nm]\n" + "NaN,1\n" * 9, ": lines 2, 3, 4, 5, 6 and 4 more" + MISSING + "s."),
    (("r [um],h [nm]\n" + rows(",")).encode("utf-16")[:-3], UTF16),
    (b"\xfe\xff\x00", UTF16),
    (b"PK\x03\x04 and so on", SPREADSHEET),
    (b"\xd0\xcf\x11\xe0\xa1\xb1", SPREADSHEET),
    (b"r [um],h [nm]\n1,2\n\x00\x01\x02", NO_TEXT),
    (b"\x89PNG\r\n\x1a\n", NO_TEXT),
]


@pytest.mark.parametrize(("content", "sentence"), REFUSED, ids=[repr(content)[:40] for content, _ in REFUSED])
def test_what_is_refused_and_how(file, content, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_profile(file(content))
    assert str(caught.value) == "tip.csv" + sentence


def test_files_that_are_not_there(file, tmp_path):
    name = file("r [um],h [nm]\n1,2\n", "tip_A.csv")
    (tmp_path / "folder").mkdir()
    for path, sentence in (
        (
            "tip_a.csv",
            "tip_a.csv: there is no such file in '.' (did you mean 'tip_A.csv'?); give the path of a text file.",
        ),
        ("other", "other: there is no such file in '.'; give the path of a text file."),
        ("no/tip.csv", "no/tip.csv: there is no folder 'no'; give the path of a text file."),
        ("folder", "folder: this is a folder; give a file in it."),
        ("/dev/null", "/dev/null: this is not a file with contents; give the path of a text file."),
        ("t" * 3000, "..." + "t" * 200 + ": the file cannot be read (File name too long)."),
        (3, "3 is no path of a file; give one such as 'tip.csv'."),
    ):
        with pytest.raises(InvalidInput) as caught:
            read_profile(path)
        assert str(caught.value) == sentence
    assert read_table(tmp_path / name, (RADIUS,)).path == str(tmp_path / name)


def test_a_file_beyond_the_limit_is_not_read(tmp_path):
    path = tmp_path / "huge.csv"
    with path.open("wb") as stream:
        stream.truncate(300_000_000)  # holes: nothing is written
    with pytest.raises(InvalidInput) as caught:
        read_profile(path)
    assert str(caught.value) == f"{path}: 300 MB are too much; at most 200 MB are read."


def test_what_the_profile_refuses_names_the_file(file):
    with pytest.raises(InvalidInput, match=r"^tip\.csv: Measured: 3 different radii were given"):
        read_profile(file("r [um],h [nm]\n0,0\n1,1\n2,4\n"))


def test_a_profile(file):
    tip = read_profile(file("radius [um], height [nm]\n" + rows(",")))
    assert isinstance(tip, Measured)
    assert tip == Measured(RADII / 1e6, HEIGHTS / 1e9)
    assert tip.gap(np.array([2e-6]))[0] == pytest.approx((2e-6) ** 2 / 40e-6, rel=1e-6)


SHAPES = {
    "paraboloid": (lambda r: r**2 / 20e-6, 1e-9),
    "cone": (lambda r: 0.3 * r, 0.1),
    "sphere": (lambda r: 20e-6 - np.sqrt(400e-12 - r**2), 1e-3),
    "flat, then round": (lambda r: np.maximum(r - 1e-6, 0.0) ** 2 / 1e-5, 0.05),
    "fourth power": (lambda r: r**4 / 1e-16, 0.1),
}
"""Height, and how far the apex may be missed, in steps of the scan."""


def scan(shape, apex=0.37e-6, count=201, scatter=0.0):
    x = np.linspace(-5e-6, 5e-6, count)
    return x, shape(np.abs(x - apex)) + scatter * np.random.default_rng(4).standard_normal(count)


def as_text(x, z):
    return "x [m]\tz [m]\n" + rows("\t", x, z)


@pytest.mark.parametrize("name", SHAPES)
def test_a_scan_is_folded_about_its_apex(file, name):
    shape, tolerance = SHAPES[name]
    x, z = scan(shape)
    tip = read_profile(file(as_text(x, z)))
    np.testing.assert_allclose(np.sort(tip.radii), np.sort(np.abs(x - 0.37e-6)), atol=tolerance * (x[1] - x[0]))
    np.testing.assert_array_equal(np.sort(tip.heights), np.sort(z))


def test_a_noisy_scan(file):
    x, z = scan(SHAPES["paraboloid"][0], scatter=5e-9)
    tip = read_profile(file(as_text(x, z)))
    apex = x - np.sign(x - 0.37e-6) * tip.radii
    assert np.median(apex) == pytest.approx(0.37e-6, abs=0.5 * (x[1] - x[0]))


def test_a_scan_does_not_depend_on_the_order_of_its_rows(file):
    x, z = scan(SHAPES["sphere"][0])
    order = np.random.default_rng(1).permutation(x.size)
    one, other = read_profile(file(as_text(x, z))), read_profile(file(as_text(x[order], z[order])))
    np.testing.assert_allclose(other.radii, one.radii[order], rtol=1e-9)


def test_a_tilted_paraboloid_is_a_shifted_one(file):
    x, z = scan(SHAPES["paraboloid"][0])
    tip = read_profile(file(as_text(x, z + 0.02 * x)))
    np.testing.assert_allclose(tip.radii, np.abs(x - 0.37e-6 + 0.2e-6), atol=1e-14)


def test_a_topography_has_its_peak_at_the_apex(file):
    x, z = scan(SHAPES["paraboloid"][0])
    name = file(as_text(x, 3e-6 - z))
    tip = read_profile(name, peak=True)
    assert tip.height(np.array([2e-6]))[0] == pytest.approx(4e-12 / 20e-6, rel=1e-6)
    with pytest.raises(InvalidInput) as caught:
        read_profile(name)
    assert str(caught.value) == (
        "tip.csv: the heights of the scan fall away from the apex; change their sign, or call "
        "read_profile(path, peak=True)."
    )


NO_APEX = (
    " m, where the scan is lowest; a scan needs both flanks and five points around the apex, or give one flank with "
    "distances from the axis."
)


@pytest.mark.parametrize(
    ("x", "z", "sentence"),
    [
        (np.linspace(-1, 3, 41), (np.linspace(-1, 3, 41) + 2) ** 2, "no apex was found near x = -1" + NO_APEX),
        (np.linspace(-1, 1, 21), np.zeros(21), "no apex was found near x = -1" + NO_APEX),
        (np.array([-1.0, 0.0, 1.0]), np.array([1.0, 0.0, 1.0]), "no apex was found near x = 0" + NO_APEX),
        (np.array([-1.0, -1.0, 1.0]), np.array([1.0, 0.0, 1.0]), "no apex was found near x = -1" + NO_APEX),
        (
            np.linspace(-1, 1, 41),
            np.where(np.linspace(-1, 1, 41) < 0, 9.0, 1.0) * np.abs(np.linspace(-1, 1, 41)) ** 3,
            "the two flanks of the scan differ by ",
        ),
    ],
)
def test_scans_that_are_refused(file, x, z, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_profile(file(as_text(x, z)))
    message = str(caught.value)
    assert message.startswith("tip.csv: " + sentence)
    if "flanks of" in sentence:
        assert message.endswith(" of its height; level the scan, or give one flank with distances from the axis.")
    else:
        assert message == "tip.csv: " + sentence


def test_real_files_are_read_or_refused_with_the_reason(shared_data):
    with pytest.raises(
        InvalidInput, match=r"dektak-1\.csv: the header has no radius .* there are 'Lateral um', 'Raw Micro"
    ):
        read_profile(shared_data / "topographies" / "dektak-1.csv")
    lateral = Column("place", ("lateral",), "m"), Column("height", ("raw",), "m")
    table = read_table(shared_data / "topographies" / "dektak-1.csv", lateral)
    assert table.values[0].tolist() == [0.0, -0.00933e-6]
    assert np.all(np.diff(table.values[:, 0]) > 0.0)
    curve = Column("depth", ("depth",), "m"), Column("force", ("load",), "N")
    # the instrument repeats depth and load in volts: the columns whose units fit are taken
    curve = read_table(shared_data / "nanoindentation" / "RobinSteel0000LC.txt", curve).values
    assert curve[0] == pytest.approx([0.814723e-9, 1.836146e-6], rel=1e-12)
    with pytest.raises(InvalidInput, match="numbers begin in line 1 without a header above them"):
        read_profile(shared_data / "topographies" / "xy-1.txt")
    assert math.isclose(float(table.values[-1, 0]), 1500e-6, rel_tol=0.01)


def test_the_line_of_a_number_that_is_too_large_is_a_whole_number(tmp_path):
    """It was "line 2.0"."""
    path = tmp_path / "tip.csv"
    path.write_text("radius [um], height [nm]\n1e301, 0\n1, 1\n")
    with pytest.raises(InvalidInput, match=r"tip\.csv, line 2: a number is too large"):
        read_profile(path)
