"""Maps of a panel as pixels of an image, and its contours as outlines."""

from __future__ import annotations

import base64
import itertools
import struct
import zlib
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.marks import Map
from winkler.plot.svg.scales import Side, levels_between
from winkler.values.errors import InvalidInput

PER_POINT = 2.0
"""Pixels in a point, where the cells of a map are no equal rectangles."""
LEAST_BAND = 1e-9
"""By which the lowest band of contours reaches lower, over the range of all."""


class Colours(NamedTuple):
    """Colours of a map: stops ``(n, 3)`` from 0 to 255 at equal distances, or single ones, and their numbers."""

    stops: Array
    low: float
    high: float
    log: bool = False
    stepped: bool = False

    def of(self, numbers: Array) -> Array:
        """Return red, green and blue of shown numbers, 0 to 255; those beyond an end have its colour."""
        with np.errstate(invalid="ignore", divide="ignore"):
            low, high, at = (
                np.log10(part) if self.log else np.asarray(part) for part in (self.low, self.high, numbers)
            )
            share = np.clip((at - low) / ((high - low) or 1.0), 0.0, 1.0)
        if self.stepped:
            return np.asarray(
                self.stops[np.minimum(np.nan_to_num(share) * len(self.stops), len(self.stops) - 1).astype(int)]
            )
        along = np.linspace(0.0, 1.0, len(self.stops))
        return np.stack([np.interp(share, along, channel) for channel in self.stops.T], axis=-1)

    def text(self, number: float) -> str:
        """Return the colour of a shown number as text."""
        return _text(self.of(np.asarray(number)))


def _text(channels: Array) -> str:
    return "#" + "".join(f"{round(float(part)):02x}" for part in channels)


def stops_of(colours: Any) -> Array:
    """Return the colours of a map by name, or single ones, ``(n, 3)`` from 0 to 255."""
    if isinstance(colours, str):
        known = colours in style.MAPS
        texts = style.MAPS[colours if known else f"{colours}_r"].split()[:: 1 if known else -1]
    else:
        texts = [one.removeprefix("#") for one in colours]
    return np.array([[int(text[place : place + 2], 16) for place in (0, 2, 4)] for text in texts], dtype=float)


def levels_of(mark: Map) -> Array:
    """Return the shown numbers between the bands of contours."""
    if isinstance(mark.levels, np.ndarray):
        return np.asarray(mark.levels / mark.bar.scale.factor)
    content = mark.z[np.isfinite(mark.z)] / mark.bar.scale.factor
    return levels_between(float(np.min(content)), float(np.max(content)), int(mark.levels))


def colours_of(mark: Map) -> Colours:
    """Return the colours of a map."""
    factor = mark.bar.scale.factor
    if mark.kind == "contours":
        levels = levels_of(mark)
        return Colours(stops_of(mark.colours), float(levels[0]), float(levels[-1]))
    content = np.asarray(mark.levels if mark.kind == "discs" else mark.z / factor, dtype=float)
    content = content[np.isfinite(content) & ((content > 0.0) if mark.bar.log else True)]
    ends = (float(np.min(content)), float(np.max(content))) if content.size else (0.0, 1.0)
    low = ends[0] if mark.bar.low is None else mark.bar.low / factor
    high = ends[1] if mark.bar.high is None else mark.bar.high / factor
    return Colours(stops_of(mark.colours), low, high, mark.bar.log, not isinstance(mark.colours, str))


def contour_bands(mark: Map) -> list[tuple[str, list[Array]]]:
    """Return the bands between levels: the colour, and outlines ``(n, 2)`` [SI] filled by the even-odd rule."""
    from contourpy import FillType, contour_generator

    levels = np.array(levels_of(mark))
    maker = contour_generator(mark.x, mark.y, _shown(mark), fill_type=FillType.OuterOffset)
    below, above = (mark.extend in (end, "both") for end in ("min", "max"))
    content = mark.z[np.isfinite(mark.z)] / mark.bar.scale.factor
    span = levels[-1] - levels[0]
    far = min(levels[0], content.min()) - span, max(levels[-1], content.max()) + span
    if content.min() == levels[0]:
        levels[0] -= LEAST_BAND * span  # a band holds what lies above its lower level
    edges = [*([far[0]] if below else []), *levels.tolist(), *([far[1]] if above else [])]
    found = []
    for place, (low, high) in enumerate(itertools.pairwise(edges)):
        outlines = []
        for corners, offsets in zip(*maker.filled(low, high), strict=True):
            outlines += [corners[start:stop] for start, stop in itertools.pairwise(offsets)]
        found.append((band_colour(mark, place, low, high), outlines))
    return found


def band_colour(mark: Map, place: int, low: float, high: float) -> str:
    """Return the colour of a band between two levels, by its place among them; those beyond have that of an end."""
    if not isinstance(mark.colours, str):
        return str(mark.colours[min(place, len(mark.colours) - 1)])
    ends = colours_of(mark)
    return ends.text(
        0.5 * (low + high) if ends.low - 1e-6 * (ends.high - ends.low) <= low and high <= ends.high else low
    )


def _shown(mark: Map) -> Any:
    return np.ma.masked_invalid(mark.z / mark.bar.scale.factor)


def contour_lines(mark: Map) -> list[Array]:
    """Return the lines at the levels that have one, ``(n, 2)`` [SI]."""
    from contourpy import contour_generator

    own = isinstance(mark.lines, np.ndarray)
    levels = mark.lines / mark.bar.scale.factor if own else levels_of(mark)[0 if mark.lines else 1 :]
    x, y = mark.centres or (mark.x, mark.y)
    maker: Any = contour_generator(x, y, _shown(mark))
    return [line for level in levels for line in maker.lines(float(level))]


def corners_of(mark: Map) -> tuple[Array, Array]:
    """Return the ends of what a map covers along x and along y [SI]; of cells given by their middles their edges."""
    if mark.kind == "discs":
        return np.concatenate([mark.x - mark.z, mark.x + mark.z]), np.concatenate([mark.y - mark.z, mark.y + mark.z])
    x, y = (_edges(part) if mark.kind == "cells" and _by_middles(mark) else part for part in (mark.x, mark.y))
    return np.asarray(x), np.asarray(y)


def _by_middles(mark: Map) -> bool:
    return bool(mark.z.shape[-1] == mark.x.shape[-1])


def _edges(middles: Array) -> Array:
    between = 0.5 * (middles[1:] + middles[:-1])
    return np.concatenate([[2.0 * middles[0] - between[0]], between, [2.0 * middles[-1] - between[-1]]])


def map_pixels(mark: Map, across: Side, upright: Side, factors: tuple[float, float]) -> tuple[Array, tuple[float, ...]]:
    """Return red, green, blue and opacity of the pixels of a map ``(rows, columns, 4)``, and where they lie [pt].

    Parameters
    ----------
    mark
        Cells, pixels, or a smooth map whose rows have one y each.
    across, upright
        The axes in their places.
    factors
        Of the axes [SI].

    Raises
    ------
    InvalidInput
        If the places of a smooth map are no rows.
    """
    x, y = (part / factor for part, factor in zip(corners_of(mark), factors, strict=True))
    z = (mark.z.T if mark.kind == "pixels" else mark.z) / mark.bar.scale.factor
    ends_x, ends_y = (np.array([np.nanmin(part), np.nanmax(part)]) for part in (x, y))
    left, right = across.place(ends_x)
    below, above = upright.place(ends_y)
    where = (min(left, right), min(above, below), max(left, right), max(above, below))
    even = mark.kind == "pixels" or (mark.kind == "cells" and _equal(across.place(x)) and _equal(upright.place(y)))
    if not even:
        columns, rows = (max(2, round(PER_POINT * (where[2 + side] - where[side]))) for side in (0, 1))
        at_x = _numbers_at(across, where[0], where[2], columns)
        at_y = _numbers_at(upright, where[3], where[1], rows)
        z = _cells_at(x, y, z, at_x, at_y) if mark.kind == "cells" else _smooth_at(x, y, z, at_x, at_y)
        turned = False, False
    else:
        turned = left > right, below < above
    shown = colours_of(mark).of(np.nan_to_num(z))
    opacity = np.where(np.isfinite(z) & ((z > 0.0) if mark.bar.log else True), 255.0 * mark.alpha, 0.0)
    pixels = np.concatenate([shown, opacity[..., None]], axis=-1)[::-1]
    pixels = pixels[:, ::-1] if turned[0] else pixels
    return (pixels[::-1] if turned[1] else pixels), where


def _equal(places: Array) -> bool:
    steps = np.diff(places)
    return bool(places.ndim == 1 and np.ptp(steps) <= 1e-3 * abs(float(np.mean(steps))))


def _numbers_at(side: Side, start: float, stop: float, count: int) -> Array:
    """Return the shown numbers at the middles of so many pixels between two places."""
    return side.at(start + (np.arange(count) + 0.5) * ((stop - start) / count))


def _cells_at(x: Array, y: Array, z: Array, at_x: Array, at_y: Array) -> Array:
    """Return the numbers of the cells in which places lie, given the rising edges of rows and columns."""
    if np.ndim(x) != 1 or np.ndim(y) != 1:
        raise InvalidInput("draw: the cells of a map lie in rows and columns; give their edges as two rows of numbers.")
    column, row = (np.searchsorted(edges, at, side="right") - 1 for edges, at in ((x, at_x), (y, at_y)))
    found = np.array(z[np.ix_(np.clip(row, 0, z.shape[0] - 1), np.clip(column, 0, z.shape[1] - 1))], dtype=float)
    found[(row < 0) | (row >= z.shape[0])] = np.nan
    found[:, (column < 0) | (column >= z.shape[1])] = np.nan
    return found


def _smooth_at(x: Array, y: Array, z: Array, at_x: Array, at_y: Array) -> Array:
    """Return numbers between those at places of rows that have one y each, NaN outside."""
    places = np.broadcast_to(y, z.shape)
    if np.ndim(x) != 2 or np.ptp(places, axis=1).max() > 1e-9 * np.ptp(places):
        raise InvalidInput("draw: the rows of a smooth map have one y each; give x for each place, y for each row.")
    heights, order = places[:, 0], np.argsort(places[:, 0])
    found = np.full((at_y.size, at_x.size), np.nan)
    for row, height in enumerate(at_y):
        if not heights[order[0]] <= height <= heights[order[-1]]:
            continue
        last = min(int(np.searchsorted(heights[order], height)), len(order) - 1)
        one, two = order[max(last - 1, 0)], order[last]
        part = (height - heights[one]) / ((heights[two] - heights[one]) or 1.0)
        along, content = (part * row_[two] + (1.0 - part) * row_[one] for row_ in (x, z))
        rising = np.argsort(along)
        found[row] = np.interp(at_x, along[rising], content[rising], left=np.nan, right=np.nan)
    return found


def image_data(pixels: Array) -> str:
    """Return pixels ``(rows, columns, 4)`` from 0 to 255 as the address of a PNG image."""
    rows, columns = pixels.shape[:2]
    lines = np.zeros((rows, 1 + 4 * columns), dtype=np.uint8)
    lines[:, 1:] = np.round(pixels).astype(np.uint8).reshape(rows, -1)
    head = struct.pack(">IIBBBBB", columns, rows, 8, 6, 0, 0, 0)
    parts = ((b"IHDR", head), (b"IDAT", zlib.compress(lines.tobytes(), 6)), (b"IEND", b""))
    file = b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
        for name, content in parts
    )
    return f"data:image/png;base64,{base64.b64encode(file).decode('ascii')}"
