"""Heights in plain files: a matrix as text, NPY or NPZ, and what such a file tells of its size and unit."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.text_file import lines_of
from winkler.numerics.types import Array
from winkler.units import comma_hint, comma_readings, quantity

__all__ = ["FoundMap", "array_map", "text_map"]

FEWEST = 4
"""Rows and columns of a map; less is a scan, or a list of points."""
MISSING = frozenset({"", "nan", "na", "n/a", "-", "--", "none", "null"})
HEADER = re.compile(r"#\s*(Width|Height|Value units)\s*:\s*(.+?)\s*$")
"""What Gwyddion writes above a matrix."""


class FoundMap(NamedTuple):
    """What was found in a file.

    Parameters
    ----------
    heights
        In the unit below; nan where missing.
    lengths
        Of both directions, in the same unit; nan where the file does not tell.
    unit
        Of lengths; empty where the file does not tell.
    periodic
        Whether the file says that the map is repeated for ever.
    """

    heights: Array
    lengths: Array
    unit: str
    periodic: bool = False


def text_map(path: Path) -> FoundMap:
    """Return the matrix of a text: one row in a line, cells apart by tabs, semicolons, commas or spaces.

    Raises
    ------
    InvalidInput
        If the file is none; the message names the line.
    """
    lines = lines_of(path, "a matrix of heights")
    told = {match[1]: match[2] for line in lines if (match := HEADER.match(line))}
    numbered = [
        (n, line) for n, line in enumerate(lines, 1) if line.strip() and not line.lstrip().startswith(("#", "%"))
    ]
    if not numbered:
        raise InvalidInput(f"{path}: there are no heights; give a matrix, one row in a line.")
    separator = next((mark for mark in ("\t", ";", ",") if mark in numbered[0][1].strip()), None)
    cut = [(number, line.strip("\r\n ").split(separator)) for number, line in numbered]
    usual = min(len(cells) for _, cells in cut)
    ends = separator is not None and all(not cells[-1].strip() for _, cells in cut)
    rows: list[list[float]] = []
    for number, cells in cut:
        if ends or (separator is not None and len(cells) == usual + 1 and not cells[-1].strip()):
            cells.pop()  # some programs end a line with a separator
        if rows and len(cells) != len(rows[0]):
            raise InvalidInput(
                f"{path}, line {number}: there are {len(cells)} heights, and {len(rows[0])} above; give rows of equal "
                "length."
            )
        try:
            rows.append([float(cell) for cell in cells])
        except ValueError:
            rows.append([_height(cell.strip(" \t\"'"), f"{path}, line {number}") for cell in cells])
    if len(rows) < FEWEST or len(rows[0]) < FEWEST:
        raise InvalidInput(
            f"{path}: a matrix of {len(rows)} x {len(rows[0])} numbers is no map, but a scan or a list of points; give "
            f"at least {FEWEST} x {FEWEST} heights."
        )
    heights = np.array(rows)
    if np.isnan(heights[0, 0]) and all(_counts(line) for line in (heights[0, 1:], heights[1:, 0])):
        raise InvalidInput(
            f"{path}: the first row and the first column count 0, 1, 2 and so on; these are no heights, delete both."
        )
    lengths, unit = np.full(2, np.nan), told.get("Value units", "")
    if unit:
        for axis, word in enumerate(("Height", "Width")):  # rows are counted along the first direction
            if word in told:
                lengths[axis] = quantity(told[word], unit, what=f"{path}, '# {word}'")
    return FoundMap(heights, lengths, unit)


def _counts(line: Array) -> bool:
    return bool(np.array_equal(line, np.arange(line.size)))


def _height(cell: str, where: str) -> float:
    if cell.lower() in MISSING:
        return float("nan")
    try:
        return float(cell)
    except ValueError:
        pass
    if comma_readings(cell):
        raise InvalidInput(f"{where}: '{cell}' has {comma_hint(cell)}.")
    raise InvalidInput(f"{where}: '{cell[:40]}' is no height; give a matrix of numbers, nan where they are missing.")


def array_map(path: Path) -> FoundMap:
    """Return the array of an NPY file, or ``heights``, ``lengths``, ``unit`` and ``periodic`` of an NPZ file.

    Raises
    ------
    InvalidInput
        If the file is none, or holds no map.
    """
    try:
        loaded = np.load(path, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            return FoundMap(_numbers(loaded, "heights", path), np.full(2, np.nan), "")
        with loaded as arrays:
            if "heights" not in arrays:
                raise InvalidInput(
                    f"{path}: it holds {', '.join(arrays.files) or 'nothing'}; the array of heights must be called "
                    "'heights'."
                )
            heights = _numbers(arrays["heights"], "heights", path)
            lengths = _numbers(arrays["lengths"], "lengths", path) if "lengths" in arrays else np.full(2, np.nan)
            unit = str(arrays["unit"]) if "unit" in arrays else ""
            periodic = bool(np.any(arrays["periodic"])) if "periodic" in arrays else False
    except InvalidInput:
        raise
    except MemoryError as error:  # numpy's own words tell how much is needed
        raise InvalidInput(
            f"{path}: the map does not fit the memory of this machine ({error}); save a part of it."
        ) from None
    except (ValueError, OSError, EOFError, zipfile.BadZipFile, KeyError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InvalidInput(f"{path}: this is no file of numpy's arrays ({reason}); write it by numpy.save.") from None
    if lengths.shape != (2,):
        raise InvalidInput(f"{path}: 'lengths' have the shape {lengths.shape}; write both lengths of the map.")
    return FoundMap(heights, lengths, unit, periodic)


def _numbers(array: Array, word: str, path: Path) -> Array:
    if array.dtype.kind not in "fiu":
        raise InvalidInput(f"{path}: '{word}' are of the type {array.dtype}; write real numbers.")
    return array.astype(float)
