"""Height maps in a study: rows of quantities, rows of numbers with one unit, or all bits of a large map, packed."""

from __future__ import annotations

import base64
import zlib
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from winkler.numerics.types import Array
from winkler.study.language.quantities import WHERE, number_or_numbers, numbers, sentence_of, wrong
from winkler.values.limits import MOST_NUMBERS

LOADS = ("pressure", "x_traction", "y_traction")
MAPS: frozenset[tuple[str, str]] = frozenset({("Topography", "heights"), *(("SurfaceLoad", name) for name in LOADS)})
"""Fields that are maps of quantities, row by row."""
PAIRS: frozenset[tuple[str, str]] = frozenset(
    {("Topography", "lengths"), ("RandomTopography", "lengths"), ("SurfaceLoad", "lengths"), ("SurfaceLoad", "corner")}
)
"""Fields that are two quantities."""
MOST_READABLE = 64
"""Pixels up to which a map is written as numbers; larger ones are packed."""


def height_map(raw: Any, unit: str | None) -> Array:
    """Return a map in SI units from rows of quantities, ``{ values, unit }`` or ``{ packed, shape }``."""
    if isinstance(raw, dict) and "packed" in raw:
        return _unpacked_map(raw)
    if isinstance(raw, dict) and isinstance(rows := raw.get("values"), list) and rows:
        lists = [row if isinstance(row, list) else [row] for row in rows]
        _refuse_uneven(lists)
        flat = numbers({**raw, "values": [item for row in lists for item in row]}, unit)
        return flat.reshape(len(lists), -1)
    if not isinstance(raw, list) or not all(isinstance(row, list) for row in raw):
        like = f"[[{quoted(1, unit)}, {quoted(2, unit)}], [{quoted(2, unit)}, {quoted(3, unit)}]]"
        wrong(f"{WHERE} is no map; give rows of quantities, such as {like}, or a file.")
    _refuse_uneven(raw)
    heights: Array = number_or_numbers(raw, unit)
    return heights


def quoted(number: int, unit: str | None) -> str:
    """Return a quantity as an example in a sentence, of a usual size."""
    usual = {"m": "um", "Pa": "MPa"}.get(unit or "", unit or "")
    return f'"{number} {usual}"'


def _refuse_uneven(rows: list[Any]) -> None:
    if len({len(row) for row in rows}) > 1:
        wrong(f"{WHERE} has rows of {len(rows[0])} and of other numbers of quantities; give rows of one length.")


def _unpacked_map(raw: dict[str, Any]) -> Array:
    for key in raw:
        if key not in ("packed", "shape"):
            wrong(f"{WHERE}.{key} is not known; a packed map has the keys packed and shape.")
    shape = counts(raw.get("shape"), f"{WHERE}.shape")
    if shape[0] * shape[1] > MOST_NUMBERS:
        wrong(f"{WHERE}.shape is {list(shape)}; give at most {MOST_NUMBERS} pixels.")
    try:
        size = 8 * shape[0] * shape[1]
        stored = zlib.decompressobj().decompress(base64.b64decode(raw["packed"], validate=True), size + 1)
        heights: Array = np.frombuffer(stored, dtype="<f8").reshape(shape).astype(float)
    except (ValueError, TypeError, zlib.error):
        wrong(f"{WHERE}.packed is damaged, or does not fit its shape; it is written by winkler alone, give the file.")
    return heights


def written_map(content: Array, unit: str) -> dict[str, Any]:
    """Return a map as a study file writes it: readable while it is small, packed otherwise."""
    if content.size <= MOST_READABLE and np.all(np.isfinite(content)):
        return {"values": content.tolist(), "unit": unit}
    stored = zlib.compress(np.ascontiguousarray(content, dtype="<f8").tobytes(), 6)
    return {"packed": base64.b64encode(stored).decode("ascii"), "shape": list(content.shape)}


def counts(raw: Any, where: str = WHERE) -> tuple[int, int]:
    """Return two whole numbers."""
    whole = isinstance(raw, list | tuple) and all(isinstance(n, int) and not isinstance(n, bool) for n in raw)
    if not whole or len(raw) != 2 or min(raw) < 1:
        wrong(f"{where} is {raw!r}; give two positive whole numbers, such as [256, 256].")
    return int(raw[0]), int(raw[1])


def pair(raw: Any, unit: str | None) -> Array:
    """Return two quantities; one stands for both."""
    try:
        heights = numbers(raw if isinstance(raw, list | dict) else [raw], unit)
    except PydanticCustomError as refusal:
        sentence = sentence_of(refusal)
        wrong(sentence if isinstance(raw, list | dict) else sentence.replace(f"{WHERE}[0]", WHERE))
    if heights.size == 1:
        heights = np.repeat(heights, 2)
    if heights.size != 2:
        wrong(f'{WHERE} has {heights.size} entries; give two, such as ["1 mm", "1 mm"].')
    return heights
