"""A picture as plain data: marks and axes, drawn by matplotlib or by the browser.

The drawing functions return marks in SI numbers; `winkler.plot.render` draws a `Panel` with matplotlib,
`winkler.web.pictures.chart` turns it into a figure of plotly.js.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.plot import style
from winkler.plot.axis import PanelAxis, from_zero, plane
from winkler.plot.marks import (
    Area,
    Arrow,
    Band,
    Bars,
    Dots,
    Facets,
    Line,
    Map,
    Mark,
    Polygon,
    Rule,
    Strokes,
    Text,
    Vectors,
)
from winkler.values.value import value

__all__ = [
    "NO_CONTACT",
    "Area",
    "Arrow",
    "Band",
    "Bars",
    "Dots",
    "Facets",
    "Line",
    "Map",
    "Mark",
    "Panel",
    "PanelAxis",
    "Polygon",
    "Rule",
    "Sheet",
    "Strokes",
    "Text",
    "Vectors",
    "among",
    "from_zero",
    "note",
    "plane",
    "points",
    "titled",
    "zero",
]


ALONE: dict[str, Any] = {"width": 0.0, "marker": "o"}


@value
class Panel:
    """One picture with its two axes.

    Parameters
    ----------
    marks
        Drawn elements.
    across, upright
        The axes.
    title
        Above it.
    beside
        A second upright axis at the right; empty for none.
    equal
        Whether lengths have one scale in both directions.
    grid
        ``both``, ``x`` or nothing.
    legend
        Position of the legend in the terms of matplotlib; empty for none.
    columns
        Of the legend.
    legend_title, spaced, outside, marker_scale
        Of the legend: title, reduced column spacing, position right of the frame, size of points.
    bare
        Whether frame and axes are left out.
    boxed
        Whether the frame is closed.
    """

    marks: tuple[Any, ...] = ()
    across: PanelAxis = PanelAxis()
    upright: PanelAxis = PanelAxis()
    title: str = ""
    beside: tuple[PanelAxis, ...] = ()
    equal: bool = False
    grid: str = "both"
    legend: str = ""
    columns: int = 1
    legend_title: str = ""
    spaced: bool = False
    outside: bool = False
    marker_scale: float = 1.0
    unframed: bool = False
    bare: bool = False
    boxed: bool = False

    def plus(self, *marks: Any, **changes: Any) -> Panel:
        """Return the panel with further marks, and with other properties."""
        return dataclasses.replace(self, marks=(*self.marks, *marks), **changes)


@value
class Sheet:
    """Panels side by side, row after row.

    Parameters
    ----------
    panels
        None leaves a cell empty; a sheet in a sheet has a grid of its own.
    columns
        Panels in a row; zero: all.
    width, height
        Of one panel [inch].
    title
        Above them all.
    below
        Columns of a common legend below the panels; zero for none.
    widths, heights
        Relative, of the columns and rows.
    shared
        The axis that the panels share: ``x``, ``y``, or nothing.
    """

    panels: tuple[Any, ...]
    columns: int = 0
    width: float = 4.4
    height: float = 3.1
    title: str = ""
    below: int = 0
    widths: tuple[float, ...] = ()
    heights: tuple[float, ...] = ()
    shared: str = ""


def titled(panels: Any, *titles: str) -> tuple[Panel, ...]:
    """Return panels with their titles."""
    return tuple(panel.plus(title=title) for panel, title in zip(panels, titles, strict=True))


def points(x: ArrayLike, y: ArrayLike, colour: Any = style.RED, **look: Any) -> Line:
    """Return places marked one by one, without a line through them."""
    places, heights = (np.atleast_1d(np.asarray(part, dtype=float)) for part in (x, y))
    return Line(places, heights, colour, **(ALONE | look))


def among(place: int, x: Array, y: Array, name: str = "", *, most: int = 40, **look: Any) -> Line:
    """Return one curve of several, by its place among them, with its points marked up to a number of `most`."""
    own = {"colour": style.CYCLE[place % len(style.CYCLE)], "dash": style.DASHES[place % len(style.DASHES)]}
    return Line(x, y, name=name, **({"marker": "o" if x.size <= most else "", "size": 4.0} | own | look))


def zero(**look: Any) -> Rule:
    """Return the thin line at zero behind the curves."""
    return Rule(0.0, order=1.0, **look)


def note(text: str, where: str = "upper right") -> Text:
    """Return a short remark in a corner of a panel."""
    upright, across = where.split()
    return Text(
        {"left": 0.03, "right": 0.97, "centre": 0.5}[across],
        {"upper": 0.97, "lower": 0.04}[upright],
        text,
        across={"left": "left", "right": "right", "centre": "center"}[across],
        upright={"upper": "top", "lower": "bottom"}[upright],
        boxed=0.8,
        framed=(True, True),
        order=9.0,
    )


NO_CONTACT = Panel((note("no contact", "upper centre"),))
