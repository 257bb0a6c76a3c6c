"""Height matrices in plain files, as text, NPY or NPZ, with lengths and unit where the file states them."""

from __future__ import annotations

import math
import re
from array import array
from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.io.array_file import read_arrays
from winkler.io.tables.decimal_commas import DecimalCommas
from winkler.io.tables.table_cells import number_in
from winkler.io.tables.table_lines import table_lines
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.limits import HEADER_LINES, MOST_NUMBERS
from winkler.values.units import quantity

LEAST_ROWS = 4
"""Fewest rows and columns of a map; a smaller matrix is a scan, or a list of points."""
MOST_COLUMNS, SLENDER = 8, 8
"""Most columns of a table without names that might be a map, and its least rows over columns."""
ONE_WAY = 0.9
"""Least share of the steps of a column that goes one way."""
POINT_CELLS = 3
"""Cells of a point x, y, z."""
SAME_PLACE = 1e-5
"""Greatest distance of points that are in one row of a grid, relative to its length."""
UNEVEN = 0.05
"""Greatest deviation of the distance of two rows from the mean."""
SHAPES, LEAST_LINES = 24, 16
"""Most doublings of the length over the width of a pixel, and fewest pixels along a side then."""
CLEARLY_MORE = 1.25
"""Least part of pixels with a point, over that of square ones, for another shape: scan lines are closer along them."""
LEAST_HELD = 0.3
"""Least part of pixels that hold a point: 0.63 at random places of a rectangle, at most 0.25 along four curves."""
MOST_SCATTER = 0.5
"""Greatest mean square difference of neighbouring heights, in parts of that of any two."""
FARTHEST = 2.0
"""Greatest distance of a pixel from a point, in pixels; beyond it the height is missing."""
MOST_SCATTERED = 2_000_000
"""Most points off a grid; those of a million take some ten seconds."""
NO_HEIGHT = "is no height; give a matrix of numbers, nan where they are missing"
HEADER = re.compile(r"#\s*+(Width|Height|Value units)\s*+:(.*)")
"""Header lines that Gwyddion writes above a matrix."""
NANOSCOPE_UNIT = re.compile(r"\\Exported image units\s*+:\s*+(\S{1,12})\s*+")
"""Header line of an export of NanoScope; those of its other settings begin with the same mark."""
COMMENTS = ("#", "%", "\\")


class MapContents(NamedTuple):
    """Height map as a file holds it.

    Parameters
    ----------
    heights
        In the unit below; nan where missing.
    lengths
        Of both directions, in the same unit; nan where the file does not state them.
    unit
        Of lengths; empty where the file does not state it.
    periodic
        Whether the file states that the map is periodic.
    tip_radius, tip_unit
        Radius of the tip that has measured it, and its unit; zero where the file does not state it.
    length_unit
        Of lengths, where the file states it and not that of heights.
    reading
        Of which points off a grid, between which the heights are; empty where these are those of the file.
    """

    heights: Array
    lengths: Array
    unit: str
    periodic: bool = False
    tip_radius: float = 0.0
    tip_unit: str = ""
    length_unit: str = ""
    reading: str = ""


def text_map(path: Path) -> MapContents:
    """Return the matrix of a text: one row in a line, cells apart by tabs, semicolons, commas or spaces.

    Raises
    ------
    InvalidInput
        If the file is none; the message names the line.
    """
    lines = table_lines(path, "a matrix of heights")
    stated = {match[1]: match[2].strip() for line in lines if (match := HEADER.match(line)) and match[2].strip()}
    numbered = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith(COMMENTS)]
    if not numbered:
        raise InvalidInput(f"{path}: there are no heights; give a matrix, one row in a line.")
    separator = next((mark for mark in ("\t", ";", ",") if mark in numbered[0][1].strip()), None)
    heights = _rows(path, numbered, separator)
    if heights.shape[1] == POINT_CELLS and len(heights) >= LEAST_ROWS**2:
        return point_map(path, heights)
    if min(heights.shape) < LEAST_ROWS:
        rows, columns = heights.shape
        raise InvalidInput(
            f"{path}: a matrix of {rows} x {columns} numbers is no map, but a scan or a list of points; give "
            f"at least {LEAST_ROWS} x {LEAST_ROWS} heights."
        )
    if np.isnan(heights[0, 0]) and all(_counts(line) for line in (heights[0, 1:], heights[1:, 0])):
        raise InvalidInput(
            f"{path}: the first row and the first column count 0, 1, 2 and so on; these are no heights, delete both."
        )
    exported = next((match[1] for match in map(NANOSCOPE_UNIT.fullmatch, lines[:HEADER_LINES]) if match), "")
    lengths, unit = np.full(2, np.nan), stated.get("Value units", exported)
    if unit:
        for axis, word in enumerate(("Height", "Width")):  # rows are counted along the first direction
            if word in stated:
                lengths[axis] = quantity(stated[word], unit, what=f"{path}, '# {word}'")
    return MapContents(heights, lengths, unit)


def refuse_table(path: Path, heights: Array) -> None:
    """Refuse a table without names: few long columns, the first of which goes one way, as a time or a frequency does.

    Between tests that stand below each other it may turn.

    Raises
    ------
    InvalidInput
    """
    steps = np.diff(heights[:, 0])
    long = heights.shape[1] <= MOST_COLUMNS and len(heights) >= SLENDER * heights.shape[1]
    if long and max(np.mean(steps > 0.0), np.mean(steps < 0.0)) >= ONE_WAY:
        raise InvalidInput(
            f"{path}: its {heights.shape[1]} columns stand without a header above them, and the first goes one way, as "
            "in a table, which is no map; write their names and units in a line above."
        )


def point_map(path: Path, points: Array, *, joined: bool = False) -> MapContents:
    """Return the map of points x, y, z ``(n, 3)``, without a unit: theirs on a full grid, else heights between them.

    Parameters
    ----------
    path : path
        For messages.
    points : ndarray, (n, 3)
    joined : bool, optional
        Whether they are the corners of one surface; else they may be no surface at all, and are examined.

    Raises
    ------
    InvalidInput
        If they are too many, lie along a curve, leave most of their rectangle empty, or have several heights at one
        place.
    """
    if (grid := points_on_grid(points)) is not None:
        return grid
    from scipy.interpolate import LinearNDInterpolator
    from scipy.spatial import KDTree, QhullError

    points = points[np.all(np.isfinite(points), axis=1)]
    places, which, counts = np.unique(points[:, :2], axis=0, return_inverse=True, return_counts=True)
    what = f"{path}: its {len(points)} points x, y, z are no map, for"
    remedy = "give points all over a rectangle, or heights on a grid of your own"
    if len(places) > MOST_SCATTERED:
        raise InvalidInput(
            f"{path}: {len(places)} points are off a grid; at most {MOST_SCATTERED} are read: thin them out."
        )
    sides = np.ptp(places, axis=0) if len(places) else np.zeros(2)
    if (len(places) < LEAST_ROWS**2 and not joined) or not np.all(sides > 0.0):
        raise InvalidInput(f"{what} they are on one line, or fewer than {LEAST_ROWS**2}; {remedy}.")
    heights = np.bincount(which.ravel(), points[:, 2]) / counts
    parts = (places - places.min(axis=0)) / sides
    count, held = _pixels(parts, sides)
    if min(count) < LEAST_ROWS and not joined:
        raise InvalidInput(f"{what} they are close to one line; {remedy}.")
    if held < LEAST_HELD and not joined:
        raise InvalidInput(f"{what} as many pixels as points would be {1.0 - held:.0%} empty; {remedy}.")
    known, tree = parts * count, KDTree(parts * count)
    difference = heights - heights[tree.query(known, k=2)[1][:, 1]]
    if not joined and float(np.mean(difference**2)) > MOST_SCATTER * 2.0 * float(np.var(heights)):
        raise InvalidInput(
            f"{what} heights of neighbours differ nearly as much as any two, as on a body with two sides; {remedy}."
        )
    centres = np.stack(np.meshgrid(*(np.arange(one) + 0.5 for one in count), indexing="ij"), axis=-1)
    try:
        between = LinearNDInterpolator(known, heights)(centres)
    except QhullError:
        raise InvalidInput(f"{what} they are on one line; {remedy}.") from None
    filled = np.where(tree.query(centres)[0] > FARTHEST, math.nan, between)
    twice = f", {len(points) - len(places)} of them at the place of another, averaged" * (len(places) < len(points))
    return MapContents(filled, sides, "", reading=f"{len(points)} points off a grid{twice}")


def _pixels(parts: Array, sides: Array) -> tuple[Array, float]:
    """Return how many pixels, about as many as places, a grid has along each side, and the part of them with a place.

    Of all shapes of a pixel the one is taken by which most hold a place, if they are clearly more than of squares.

    Parameters
    ----------
    parts : ndarray, (n, 2)
        Places, in parts of the sides.
    sides : ndarray, (2,)
    """

    def grid(shape: float) -> tuple[Array, float]:
        most = np.sqrt(len(parts) * shape * np.array([sides[0] / sides[1], sides[1] / sides[0] / shape**2]))
        count = np.clip(np.rint(most), 1, len(parts)).astype(int)
        cells = np.minimum((parts * count).astype(int), count - 1)
        holds = np.zeros(count, dtype=bool)
        holds[cells[:, 0], cells[:, 1]] = True
        return count, float(np.mean(holds))

    with np.errstate(over="ignore"):
        square, *others = (grid(2.0 ** (power / 2)) for power in (0, *range(-SHAPES, SHAPES + 1)))
    many = [one for one in others if min(one[0]) >= LEAST_LINES]
    best = max(many, key=lambda one: one[1], default=square)
    return best if best[1] > CLEARLY_MORE * square[1] else square


def points_on_grid(points: Array) -> MapContents | None:
    """Return the map of points x, y, z ``(n, 3)`` on an even grid, nan where it has none; None if they are on none."""
    x, y, z = points.T
    along_x, along_y = _axis(x), _axis(y)
    if along_x is None or along_y is None or points.shape[0] < LEAST_HELD * along_x[0] * along_y[0]:
        return None
    (columns, step_x), (rows, step_y) = along_x, along_y
    cells = np.rint((x - x.min()) / step_x).astype(int) * rows + np.rint((y - y.min()) / step_y).astype(int)
    if np.unique(cells).size != cells.size:
        return None
    heights = np.full(columns * rows, math.nan)
    heights[cells] = z
    return MapContents(heights.reshape(columns, rows), np.array([columns * step_x, rows * step_y]), "")


def _axis(places: Array) -> tuple[int, float] | None:
    """Return the number of places of points along an axis, and their distance; None where it is not even."""
    if not np.all(np.isfinite(places)):
        return None
    ordered = np.sort(places)
    steps = np.diff(ordered)
    gap = np.flatnonzero(steps > SAME_PLACE * np.ptp(ordered))
    count = gap.size + 1
    if count < LEAST_ROWS:
        return None
    step = float(np.ptp(ordered)) / (count - 1)
    return (count, step) if np.all(np.abs(steps[gap] - step) <= UNEVEN * step) else None


def _rows(path: Path, numbered: list[tuple[int, str]], separator: str | None) -> Array:
    """Return the numbers of all lines, of equally many cells each."""
    usual, total, ends = MOST_NUMBERS, 0, separator is not None
    for _, line in numbered:
        cells = line.strip("\r\n ").split(separator)
        usual, total, ends = min(usual, len(cells)), total + len(cells), ends and not cells[-1].strip()
        refuse_many(total, path)
    numbers, wide = array("d"), 0
    commas, seen = DecimalCommas(str(path)) if separator != "," else None, False
    for number, line in numbered:
        cells = line.strip("\r\n ").split(separator)
        if ends or (separator is not None and len(cells) == usual + 1 and not cells[-1].strip()):
            cells.pop()  # some programs end a line with a separator
        wide = wide or len(cells)
        if len(cells) != wide and separator == "\t":  # spaces in some rows, tabs in others
            cells = line.split()
        if len(cells) != wide:
            raise InvalidInput(
                f"{path}, line {number}: there are {len(cells)} heights, and {wide} above; give rows of equal length."
            )
        try:
            numbers.extend([float(cell) for cell in cells])
        except ValueError:
            where = f"{path}, line {number}"
            plain = [cell.strip(" \t\"'") for cell in cells]
            seen = True
            plain = [cell if commas is None else commas.with_point(cell, number) for cell in plain]
            numbers.extend([number_in(cell, where, NO_HEIGHT) for cell in plain])
    if commas is not None and seen:
        for _, line in numbered:
            commas.see_points(line.split(separator))
        commas.refuse_ambiguous()
    return np.frombuffer(numbers).reshape(len(numbered), wide)


def refuse_many(count: int, path: Path) -> None:
    """Refuse a map of more heights than are read.

    Raises
    ------
    InvalidInput
    """
    if count > MOST_NUMBERS:
        side = math.isqrt(MOST_NUMBERS)
        raise InvalidInput(
            f"{path}: there are {count} heights or more; at most {MOST_NUMBERS} are read, {side} x {side}: save a "
            "part of the map."
        )


def _counts(line: Array) -> bool:
    return bool(np.array_equal(line, np.arange(line.size)))


def array_map(path: Path) -> MapContents:
    """Return the array of an NPY file, or ``heights``, ``lengths``, ``unit`` and ``periodic`` of an NPZ file.

    Raises
    ------
    InvalidInput
        If the file is none, or holds no map.
    """
    arrays = read_arrays(
        path,
        ("heights", "lengths", "unit", "periodic"),
        needed=("heights",),
        missing="the array of heights must be called 'heights'",
        wrong="this is no file of numpy's arrays",
        remedy="write it by numpy.save",
    )
    if "" in arrays:
        return MapContents(_numbers(arrays[""], "heights", path), np.full(2, np.nan), "")
    heights = _numbers(arrays["heights"], "heights", path)
    lengths = _numbers(arrays.get("lengths", np.full(2, np.nan)), "lengths", path)
    unit, periodic = arrays.get("unit", np.array("")), arrays.get("periodic", np.array(False))
    if unit.size != 1 or unit.dtype.kind != "U":
        raise InvalidInput(f"{path}: 'unit' is of the type {unit.dtype} and the shape {unit.shape}; write one text.")
    if periodic.size > 2 or periodic.dtype.kind not in "biu":
        raise InvalidInput(f"{path}: 'periodic' is of the type {periodic.dtype}; write True or False.")
    if lengths.shape != (2,):
        raise InvalidInput(f"{path}: 'lengths' have the shape {lengths.shape}; write both lengths of the map.")
    return MapContents(heights, lengths, str(unit.item()), bool(np.any(periodic)))


def _numbers(content: Array, word: str, path: Path) -> Array:
    if content.dtype.kind not in "fiu":
        raise InvalidInput(f"{path}: '{word}' are of the type {content.dtype}; write real numbers.")
    return content.astype(float, copy=False)
