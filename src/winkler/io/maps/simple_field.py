"""Simple fields of Gwyddion (.gsf): lines of settings, then heights as numbers of four bytes, row by row."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from winkler.io.height_matrix import MapContents, refuse_many
from winkler.io.text_file import content_of
from winkler.values.errors import InvalidInput
from winkler.values.limits import FILE_BYTES
from winkler.values.units import scale

MARK = b"Gwyddion Simple Field 1.0\n"
HEAD_BYTES = 100_000
"""Most bytes of settings,"""
ALIGNED = 4
"""behind which zeros follow up to a multiple of so many bytes, at least one."""


def is_simple_field(path: Path) -> bool:
    """Return whether a file begins as a simple field."""
    with path.open("rb") as file:
        return file.read(len(MARK)) == MARK


def simple_field_map(path: Path) -> MapContents:
    """Return the height map of a simple field.

    Raises
    ------
    InvalidInput
        If its settings are incomplete, its numbers too few, or it holds another quantity than heights.
    """
    content = content_of(path, FILE_BYTES)
    end = content.find(b"\0", 0, HEAD_BYTES)
    if end < 0:
        raise InvalidInput(f"{path}: the settings of this simple field have no end; save it anew.")
    settings = {}
    for line in content[len(MARK) : end].decode("utf-8", "replace").splitlines():
        key, _, text = line.partition("=")
        settings[key.strip()] = text.strip()
    columns, rows = (_count(settings, key, path) for key in ("XRes", "YRes"))
    refuse_many(columns * rows, path)
    begin = end + ALIGNED - end % ALIGNED
    numbers = content[begin : begin + 4 * columns * rows]
    if len(numbers) < 4 * columns * rows:
        raise InvalidInput(f"{path}: the file ends before its {columns} x {rows} heights; save it anew.")
    along, heights = settings.get("XYUnits", ""), settings.get("ZUnits", "")
    if heights and not _is_length(heights):
        raise InvalidInput(f"{path}: it holds no height map, but numbers in '{heights[:20]}'; give another file.")
    sides = [_side(settings.get(key, "")) for key in ("XReal", "YReal")]
    if along and not _is_length(along):
        sides = [math.nan, math.nan]
    elif along and heights:
        sides = [side * scale(along, heights) for side in sides]
    # the second direction of a map runs along the rows of the file
    values = np.frombuffer(numbers, dtype="<f4").reshape(rows, columns).astype(float)
    return MapContents(values, np.array(sides[::-1]), heights, length_unit="" if heights else along)


def _is_length(unit: str) -> bool:
    try:
        scale(unit, "m")
    except InvalidInput:
        return False
    return True


def _count(settings: dict[str, str], key: str, path: Path) -> int:
    word = settings.get(key, "")
    if not (word.isascii() and word.isdecimal() and len(word) <= 9 and int(word) > 0):
        raise InvalidInput(f"{path}: its settings state '{key} = {word[:40]}'; it must be a whole number of pixels.")
    return int(word)


def _side(word: str) -> float:
    try:
        side = float(word)
    except ValueError:
        return math.nan
    return side if side > 0.0 and math.isfinite(side) else math.nan
