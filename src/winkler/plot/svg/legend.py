"""Legends: the samples and names of the marks of a panel, and a place for them where they hide nothing."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import marks
from winkler.plot.svg.letters import Rectangle, text_element, width_of
from winkler.plot.svg.shapes import markers, outline, stroke, tint

SIZE = 8.5
HANDLE, BESIDE, EDGE, ROW = 2.2 * SIZE, 0.8 * SIZE, 0.4 * SIZE, 1.5 * SIZE
"""Length of a sample, its distance from the name, the edge inside of the frame, and the height of a line [pt]."""
COLUMNS, NEAR_COLUMNS = 2.0 * SIZE, 1.2 * SIZE
AWAY = 0.5 * SIZE
"""Distance of a legend from the frame of its panel [pt]."""
PLACES = (
    "upper right",
    "upper left",
    "lower right",
    "lower left",
    "center right",
    "center left",
    "upper center",
    "lower center",
    "center",
)
ABOVE = ("upper right", "upper left", "upper center")
FREE = 3.0
"""Distance of a legend from a curve, in the units of the drawing."""
MOST_ROOM = 0.5
"""Greatest part of a panel that is left free above its curves for the legend."""
TEXT_COUNTS = 1000
"""Points of a curve that a hidden text counts for."""


def named(found: Iterable[Any]) -> list[Any]:
    """Return the marks that have a name, points and curves before bars."""
    known = [mark for mark in found if getattr(mark, "name", "") and not mark.name.startswith("_")]
    return sorted(known, key=lambda mark: isinstance(mark, marks.Bars) or getattr(mark, "error_y", None) is not None)


class Legend(NamedTuple):
    """A legend that has no place yet: its marks in columns, title, size [pt], and whether it has a ground."""

    columns: tuple[tuple[Any, ...], ...]
    widths: tuple[float, ...]
    title: str
    gap: float
    width: float
    height: float
    framed: bool
    marker_scale: float

    def at(self, place: str, frame: Rectangle, *, outside: bool = False) -> Rectangle:
        """Return its rectangle at a place of a frame, or with that corner at the upper right one of the frame."""
        upright, across = {"center": ("center", "center"), "right": ("center", "right")}.get(place) or place.split()
        inner = Rectangle(frame.right, frame.top, frame.right, frame.top) if outside else frame
        left = {
            "left": inner.left + AWAY,
            "right": inner.right - AWAY - self.width,
            "center": 0.5 * (inner.left + inner.right - self.width),
        }[across]
        top = {
            "upper": inner.top + (0.0 if outside else AWAY),
            "lower": inner.bottom - AWAY - self.height,
            "center": 0.5 * (inner.top + inner.bottom - self.height),
        }[upright]
        return Rectangle(left, top, left + self.width, top + self.height)

    def drawn(self, box: Rectangle) -> str:
        """Return its elements in a rectangle."""
        text = '<g class="legend">'
        if self.framed:
            text += box.drawn('fill="white" fill-opacity=".85"')
        top = box.top + EDGE
        if self.title:
            text += text_element(self.title, 0.5 * (box.left + box.right), top, SIZE, upright="top")
            top += ROW
        left = box.left + EDGE
        for entries, wide in zip(self.columns, self.widths, strict=True):
            level = top
            for mark in entries:
                high = _height(mark)
                middle = level + 0.5 * high
                text += _sample(mark, left, middle, self.marker_scale)
                text += text_element(mark.name, left + HANDLE + BESIDE, middle, SIZE, across="left")
                level += high
            left += wide + self.gap
        return f"{text}</g>"


def _height(mark: Any) -> float:
    return ROW + 1.2 * SIZE * str(mark.name).count("\n")


def legend_of(
    entries: Sequence[Any], columns: int, *, title: str = "", near: bool = False, framed: bool = True,
    marker_scale: float = 1.0,
) -> Legend:  # fmt: skip
    """Return the legend of some marks.

    Parameters
    ----------
    entries
        Marks with names.
    columns
        Their number.
    title
        Above them.
    near
        Whether the columns are close to each other.
    framed
        Whether it has a ground.
    marker_scale
        Of the points in the samples.
    """
    parts = np.array_split(np.arange(len(entries)), max(1, min(columns, len(entries))))
    rows = tuple(tuple(entries[place] for place in part) for part in parts)
    widths = tuple(HANDLE + BESIDE + max(width_of(mark.name, SIZE) for mark in part) for part in rows)
    gap = NEAR_COLUMNS if near else COLUMNS
    wide = max(sum(widths) + gap * (len(widths) - 1), width_of(title, SIZE) if title else 0.0)
    high = max(sum(map(_height, part)) for part in rows) + (ROW if title else 0.0)
    return Legend(rows, widths, title, gap, wide + 2.0 * EDGE, high + 2.0 * EDGE, framed, marker_scale)


def _sample(mark: Any, left: float, middle: float, scale: float) -> str:
    """Return the sample of a mark beside its name."""
    x, y = np.array([left, left + HANDLE]), np.array([middle, middle])
    if isinstance(mark, marks.Line):
        line = mark.width and mark.error_x is None and mark.error_y is None
        look = stroke(mark.colour, mark.width, mark.dash, mark.alpha, blunt=mark.blunt)
        text = f'<path d="{outline(x, y)}" {look}/>' if line else ""
        if mark.error_y is not None:
            text += f'<path d="M{x.mean():.1f} {middle - 4.0:.1f}v8" {stroke(mark.error_colour or mark.colour, 1.0)}/>'
        return text + (markers(mark, x[:1] + 0.5 * HANDLE, y[:1], scale) if mark.marker else "")
    if isinstance(mark, marks.Rule):
        return f'<path d="{outline(x, y)}" {stroke(mark.colour, mark.width, mark.dash, blunt=True)}/>'
    if isinstance(mark, marks.Dots):
        dot = marks.Line(x, y, mark.colour, width=0.0, marker="o", size=math.sqrt(mark.size), alpha=mark.alpha)
        return markers(dot, x[:1] + 0.5 * HANDLE, y[:1], scale)
    several = isinstance(mark, marks.Bars) and not isinstance(mark.colour, str)
    patch = Rectangle(left, middle - 3.0, left + HANDLE, middle + 3.0)
    hatch = patch.drawn('fill="url(#hatch)"') if getattr(mark, "hatch", "") else ""
    return patch.drawn(tint(mark.colour[0] if several else mark.colour, getattr(mark, "alpha", 1.0))) + hatch


def free_place(
    wanted: str, box_at: Callable[[str], Rectangle], drawn: Array, texts: Sequence[Rectangle]
) -> tuple[str, bool]:
    """Return where a legend is drawn, and whether it hides nothing there.

    Parameters
    ----------
    wanted
        Where it goes if that is free.
    box_at
        Its rectangle at a place.
    drawn : ndarray
        Places ``(n, 2)`` that curves and points cover.
    texts
        Rectangles of texts.
    """
    hidden: dict[str, int] = {}
    for place in dict.fromkeys((wanted, *PLACES)):
        box = box_at(place).grown(FREE)
        inside = (drawn >= box[:2]).all(axis=1) & (drawn <= box[2:]).all(axis=1)
        hidden[place] = int(np.count_nonzero(inside)) + TEXT_COUNTS * sum(map(box.meets, texts))
        if hidden[place] == 0:
            return place, True
    return min(hidden, key=lambda place: hidden[place]), False


def room_above(height: float, frame_height: float) -> float:
    """Return the share of a panel that is left free above its curves for a legend; zero if it would be too much."""
    share = (height + 4.0 * FREE) / frame_height
    return share if share < MOST_ROOM else 0.0
