"""Surfaces packed otherwise, simple fields of Gwyddion, and surfaces of triangles: the same heights as in a matrix."""

from __future__ import annotations

import struct
import zipfile
import zlib

import numpy as np
import pytest

from winkler.io.topography_file import read_topography
from winkler.profiles.rough.plausibility import doubts_of_surface
from winkler.values.errors import InvalidInput

ROWS, COLUMNS, STEP = 6, 9, 0.5
COUNTS = np.arange(ROWS * COLUMNS, dtype="<i4").reshape(ROWS, COLUMNS) % 7
"""Heights in steps of 0.01 um, on pixels of 0.5 um."""


def digital_surf(*, streams=0, comment=b"", cut=0, says=None):
    """A surface of MountainsMap: a head of 512 bytes, a comment, and points, compressed in streams where there are."""
    head = struct.pack("<12sHHHH30s30s", b"DSCOMPRESSED" if streams else b"DIGITAL SURF", 0, 1, 1, 1, b"map", b"me")
    head += struct.pack("<HHHHHIIHiiiiI", 0, 0, 0, 0, 0, 0, 0, 32, 0, 6, COLUMNS, ROWS, COLUMNS * ROWS)
    head += struct.pack("<3f", STEP, STEP, 0.01) + b"".join(name.ljust(16) for name in (b"X", b"Y", b"Z"))
    head += b"um".ljust(16) * 6 + struct.pack("<3f3H3I7HfIIHHH", 1, 1, 1, 0, 0, 0, 0, 0, 0, *(1,) * 7, 0, 0, 0, 0,
                                              len(comment), 0)  # fmt: skip
    head += bytes(128) + struct.pack("<3f", 0, 0, 0) + bytes(34)
    assert len(head) == 512
    points = COUNTS.tobytes()
    if streams:
        edges = np.linspace(0, len(points), streams + 1).astype(int)
        parts = [points[a:b] for a, b in zip(edges[:-1], edges[1:], strict=True)]
        packed = [zlib.compress(part) for part in parts]
        sizes = [(len(part) if says is None else says, len(one)) for part, one in zip(parts, packed, strict=True)]
        points = struct.pack("<I", streams) + b"".join(struct.pack("<II", *one) for one in sizes) + b"".join(packed)
    content = head + comment + points
    return content[: len(content) - cut]


@pytest.mark.parametrize("streams", [1, 3, 8])
@pytest.mark.parametrize("comment", [b"", b"scanned twice"])
def test_a_compressed_surface_is_that_which_was_compressed(tmp_path, streams, comment):
    pytest.importorskip("SurfaceTopography")
    plain, packed = tmp_path / "plain.sur", tmp_path / "packed.sur"
    plain.write_bytes(digital_surf(comment=comment))
    packed.write_bytes(digital_surf(streams=streams, comment=comment))
    expected, found = read_topography(plain), read_topography(packed)
    np.testing.assert_allclose(expected.heights, 1e-8 * COUNTS.T, rtol=1e-6)
    np.testing.assert_array_equal(found.heights, expected.heights)
    assert found.lengths == pytest.approx([COLUMNS * STEP * 1e-6, ROWS * STEP * 1e-6])


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"cut": 10}, "the file ends before its compressed points; copy it anew"),
        ({"cut": 300}, "packed.sur"),
        ({"says": 2**31}, "it unpacks to .* MB, at most .* are read; save the map as an NPY file"),
        ({"says": 4}, "packed.sur"),
    ],
)
def test_a_compressed_surface_that_is_cut_or_lies_is_one_sentence(tmp_path, changes, sentence):
    pytest.importorskip("SurfaceTopography")
    (tmp_path / "packed.sur").write_bytes(digital_surf(streams=2, **changes))
    with pytest.raises(InvalidInput, match=sentence):
        read_topography(tmp_path / "packed.sur")


def test_an_x3p_within_a_folder_is_that_of_the_folder(tmp_path):
    """It was refused: pack what is in the folder, without it."""
    axes = "".join(
        f"<C{axis}><AxisType>{kind}</AxisType><DataType>D</DataType><Increment>{step}</Increment><Offset>0</Offset>"
        f"</C{axis}>" for axis, kind, step in (("X", "I", 1e-6), ("Y", "I", 1e-6), ("Z", "A", 1))
    )  # fmt: skip
    head = (
        '<?xml version="1.0"?><p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>'
        f"<Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>{axes}</Axes></Record1><Record2>"
        "<Date>2020-01-01T00:00:00</Date></Record2><Record3><MatrixDimension>"
        f"<SizeX>{COLUMNS}</SizeX><SizeY>{ROWS}</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink><PointDataLink>"
        "bindata/data.bin</PointDataLink></DataLink></Record3></p:ISO5436_2>"
    )
    pytest.importorskip("SurfaceTopography")
    found = []
    for folder in ("", "land/"):
        with zipfile.ZipFile(tmp_path / "map.x3p", "w") as pack:
            pack.writestr(f"{folder}main.xml", head)
            pack.writestr(f"{folder}bindata/data.bin", (1e-8 * COUNTS).astype("<f8").tobytes())
        found.append(read_topography(tmp_path / "map.x3p"))
    np.testing.assert_allclose(found[0].heights, 1e-8 * COUNTS.T, rtol=1e-12)
    np.testing.assert_array_equal(found[1].heights, found[0].heights)


def simple_field(settings, heights=COUNTS, cut=0):
    head = b"Gwyddion Simple Field 1.0\n" + "".join(f"{key} = {text}\n" for key, text in settings.items()).encode()
    numbers = heights.astype("<f4").tobytes()
    return head + bytes(4 - len(head) % 4) + numbers[: len(numbers) - cut]


SETTINGS = {"XRes": COLUMNS, "YRes": ROWS, "XReal": "9e-6", "YReal": "3e-6", "XYUnits": "m", "ZUnits": "m", "Title": ""}


@pytest.mark.parametrize("title", ["", "a", "ab", "abc"])
def test_a_simple_field_of_gwyddion_is_read(tmp_path, title):
    """Its settings are filled up with zeros to a multiple of four bytes; a row of the file is one along x."""
    heights = 1e-8 * COUNTS
    heights[2, 3] = np.nan
    (tmp_path / "map.gsf").write_bytes(simple_field({**SETTINGS, "Title": title}, heights))
    found = read_topography(tmp_path / "map.gsf")
    np.testing.assert_allclose(found.heights, heights, rtol=1e-6)
    assert found.lengths == pytest.approx([3e-6, 9e-6])


def test_a_simple_field_in_two_units_or_without_one(tmp_path):
    file = tmp_path / "map.gsf"
    file.write_bytes(simple_field({**SETTINGS, "ZUnits": "nm"}))
    expected = read_topography(file)
    np.testing.assert_allclose(expected.heights, 1e-9 * COUNTS, rtol=1e-12)
    assert expected.lengths == pytest.approx([3e-6, 9e-6])
    file.write_bytes(simple_field({**SETTINGS, "ZUnits": ""}))
    with pytest.raises(InvalidInput, match="does not state the unit of its heights; give unit"):
        read_topography(file)
    given = read_topography(file, unit="nm")
    np.testing.assert_allclose(given.heights, expected.heights, rtol=1e-12)
    assert given.lengths == pytest.approx([3e-6, 9e-6])


@pytest.mark.parametrize(
    ("settings", "cut", "sentence"),
    [
        ({"ZUnits": "V"}, 0, "it holds no height map, but numbers in 'V'"),
        ({"XRes": "many"}, 0, "'XRes = many'; it must be a whole number of pixels"),
        ({"XRes": 10**6, "YRes": 10**6}, 0, "map.gsf"),
        ({}, 4, "the file ends before its 9 x 6 heights"),
    ],
)
def test_a_simple_field_that_is_none_is_one_sentence(tmp_path, settings, cut, sentence):
    (tmp_path / "map.gsf").write_bytes(simple_field({**SETTINGS, **settings}, cut=cut))
    with pytest.raises(InvalidInput, match=sentence):
        read_topography(tmp_path / "map.gsf")


def triangles(x, y, height):
    """Two triangles for each cell of a grid, all of them looking up ``(n, 3, 3)``."""
    points = np.stack([*np.meshgrid(x, y, indexing="ij"), height(*np.meshgrid(x, y, indexing="ij"))], axis=-1)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    return np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)


def stl(corners, *, text=False):
    if text:
        facets = ["facet normal 0 0 1\n outer loop" for _ in corners]
        body = "\n".join(
            "\n".join([facet, *(f"  vertex {p[0]:.9g} {p[1]:.9g} {p[2]:.9g}" for p in one), " endloop\nendfacet"])
            for facet, one in zip(facets, corners, strict=True)
        )
        return f"solid rock\n{body}\nendsolid rock\n".encode()
    facets = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    facets["corners"] = corners
    return bytes(80) + struct.pack("<I", len(corners)) + facets.tobytes()


@pytest.mark.parametrize("text", [False, True])
def test_triangles_with_corners_on_a_grid_are_these_corners(tmp_path, text):
    x, y = np.arange(5.0), np.arange(6.0)
    corners = triangles(x, y, lambda a, b: 0.01 * a * b)
    (tmp_path / "rock.stl").write_bytes(stl(corners, text=text))
    found = read_topography(tmp_path / "rock.stl", unit="mm")
    np.testing.assert_allclose(found.heights, 1e-5 * np.outer(x, y), rtol=1e-6)
    assert found.lengths == pytest.approx([5e-3, 6e-3])
    with pytest.raises(InvalidInput, match="does not state the unit of its heights; give unit"):
        read_topography(tmp_path / "rock.stl")


def test_triangles_of_a_plane_are_that_plane_between_their_corners(tmp_path):
    """A plane is the same however it is parted into triangles; pixels are as many as corners."""
    x = np.cumsum(np.random.default_rng(1).uniform(0.5, 1.5, 30))
    corners = triangles(x, x[:20], lambda a, b: 0.1 * a - 0.05 * b)
    (tmp_path / "plane.stl").write_bytes(stl(corners))
    found = read_topography(tmp_path / "plane.stl", unit="mm")
    assert found.heights.size == pytest.approx(600, rel=0.1)
    low, steps = (x[0], x[0]), found.lengths / found.heights.shape * 1e3
    places = [low[axis] + steps[axis] * (np.arange(count) + 0.5) for axis, count in enumerate(found.heights.shape)]
    expected = 1e-3 * (0.1 * places[0][:, None] - 0.05 * places[1])
    np.testing.assert_allclose(found.heights, expected, rtol=1e-5, atol=1e-9)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (stl(triangles(np.arange(3.0), np.arange(3.0), lambda a, b: a * b)[[0, 1]] * [[[1, 1, 1]], [[-1, 1, 1]]]),
         "its 2 triangles are no surface with one height at each place"),
        (stl(np.full((2, 3, 3), np.inf)), "a corner of its triangles is not finite"),
        (stl(np.ones((4, 3, 3)))[:-7], "this is no whole file of triangles"),
        (b"solid rock\nvertex 1 2 e\nvertex 1 2 3\nvertex 1 2 3\nendsolid", "a corner of its triangles is no number"),
        (b"solid rock\nendsolid rock\n", "this is no whole file of triangles"),
    ],
)  # fmt: skip
def test_triangles_without_one_height_at_each_place_are_one_sentence(tmp_path, content, sentence):
    (tmp_path / "rock.stl").write_bytes(content)
    with pytest.raises(InvalidInput, match=sentence):
        read_topography(tmp_path / "rock.stl", unit="mm")


def test_heights_and_lengths_below_atoms_are_doubted():
    """Heights that stand in metres, read as micrometres, were a map without a word."""
    heights = 1e-14 * COUNTS
    assert "less than the size of an atom" in " ".join(doubts_of_surface(heights, 1e-8, (1e-5, 1e-5)))
    assert "a few atoms" in " ".join(doubts_of_surface(1e4 * heights, 0.1, (1e-10, 1e-10)))
    assert doubts_of_surface(1e4 * heights, 1e-4, (1e-5, 1e-5)) == ()
    assert doubts_of_surface(0.0 * heights, 0.0, (1e-5, 1e-5)) == ()
