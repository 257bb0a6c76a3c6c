"""Quantities over another one: lines with requested or measured points, bands between bounds, and fitting axes."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.plot import style
from winkler.plot.families import in_equal_ratios, spans_decades
from winkler.plot.panel import Area, Panel, PanelAxis, among, from_zero, points, zero
from winkler.plot.series import Series, middle_scale, row_of, scale_of

MOST_MARKED_POINTS = 60
"""Requested or measured points are marked up to this number."""
MOST_JOINED_POINTS = 40
"""Points of a line are marked individually up to this number, where none were requested."""
MOST_LABELLED_DECADES = 5.0
"""Over more decades than these not each of them is labelled."""
LEAST_SHOWN = 1e-3
"""Least number of an abscissa over decades in the unit of its greatest; else the unit is that of its middle."""
MARGIN = 0.08
AXIS_FACTOR = 3.0
"""Range of logarithmic axes beyond that of the lines, as a factor."""
LEAST_SHARE = 1e-5
"""Lower limit of a logarithmic axis, relative to the greatest number, unless it was asked for."""


class Quantity(NamedTuple):
    """One quantity, its name for the legend, its requested or measured points and their name, and its look."""

    of: Series
    name: str = ""
    points: tuple[ArrayLike, ArrayLike] = (np.empty(0), np.empty(0))
    marked: str = ""
    look: Mapping[str, Any] = MappingProxyType({})


class Bounds(NamedTuple):
    """A shaded band between two curves."""

    low: Array
    high: Array
    name: str
    colour: str


def decades_around(requested: ArrayLike, factor: float, count: int) -> Array:
    """Return so many numbers across the requested range, or up to a factor around a single one."""
    low, high = float(np.min(requested)), float(np.max(requested))
    if high <= low * (1.0 + 1e-12):
        low, high = low / factor, high * factor
    return np.geomspace(low, high, count)


def answered(curve: Any, item: Any, along: str, of: str, name: str = "") -> Quantity:
    """Return an answer of `curve`, with the points `of` over `along` that were requested of `item`."""
    return Quantity(row_of(curve, of), name, (getattr(item, along), getattr(item, of)), "requested")


def curves_panel(
    along: Series,
    lines: Sequence[Quantity | tuple[Series, str]],
    bounds: Sequence[Bounds] = (),
    *,
    label: str = "",
    log: bool | None = None,
) -> Panel:
    """Return quantities of one unit over another quantity, logarithmic over decades in equal ratios.

    Parameters
    ----------
    along : Series
        Abscissa, in any order.
    lines : sequence of Quantity or (Series, str)
        One curve each, with its name; empty for a single one.
    bounds : sequence of Bounds
        They may be far away or infinite.
    label : str
        Of the upright axis, without a unit; the name of the first quantity if empty.
    log : bool, optional
        Whether the upright axis is logarithmic, down to the least number; by the range of the numbers if left out.
    """
    order = np.argsort(along.content, kind="stable")
    rows, x = [Quantity(*line) for line in lines], along.content[order]
    contents = np.concatenate([np.ravel(part) for one in rows for part in (one.of.content, one.points[1])])
    contents = contents[np.isfinite(contents)] if np.isfinite(contents).any() else np.zeros(1)
    decades, least, most = in_equal_ratios(x), float(np.min(contents)), float(np.max(contents))
    dense = 0 if any(np.size(one.points[0]) for one in rows) else MOST_JOINED_POINTS
    steep = decades and (spans_decades(contents) or (bool(bounds) and least > 0.0)) if log is None else log
    steep = steep and most > 0.0
    marks: list[Any] = [Area(x, one.low[order], one.high[order], one.colour, 0.2, one.name) for one in bounds]
    asked: list[Any] = []  # above the lines, and behind them in the legend
    for place, one in enumerate(rows):
        content = np.where(np.isfinite(one.of.content), one.of.content, np.nan)[order]
        marks.append(among(place, x, content, one.name, most=dense, **one.look))
        at, found = (np.ravel(np.asarray(part, dtype=float)) for part in one.points)
        shown = np.isfinite(found) & ((at > 0.0) | (not decades)) & ((found > 0.0) | (not steep))
        if 0 < np.count_nonzero(shown) <= MOST_MARKED_POINTS:
            colour = style.RED if len(rows) == 1 else style.INK if one.marked else style.CYCLE[place]
            name = "" if any(one.marked == other.name for other in asked) else one.marked
            asked.append(points(at[shown], found[shown], colour, name=name, size=4.0, order=5.0))
    unit = rows[0].of.word.unit
    scale = (middle_scale if steep else scale_of)(unit, contents)
    ends: dict[str, Any] = {"margin": MARGIN}
    if steep:
        low = max(float(np.min(contents[contents > 0.0])) / AXIS_FACTOR, 0.0 if log else LEAST_SHARE * most)
        ends = {"low": low, "high": AXIS_FACTOR * most, "log": True, "plain": True}
    elif least < 0.0:
        asked.append(zero())
    elif from_zero(contents) is not None:
        shaded = [one.high[np.isfinite(one.high)] for one in bounds]
        top = max([most, *(float(np.max(part)) for part in shaded if part.size and np.max(part) < AXIS_FACTOR * most)])
        ends = {"low": 0.0, "high": 1.15 * top or scale.factor}
    crowded = decades and np.ptp(np.log10(x)) > MOST_LABELLED_DECADES
    across = PanelAxis.of(
        along,
        middle_scale(along.word.unit, x) if decades and x[0] < LEAST_SHOWN * along.scale.factor else along.scale,
        margin=0.04, log=decades, plain=decades, parts=5 if crowded else 0,
    )  # fmt: skip
    upright = PanelAxis.of(rows[0].of, scale, **ends)
    upright = dataclasses.replace(upright, label=label) if label else upright
    marks += asked
    return Panel(tuple(marks), across, upright, legend="best" if any(mark.name for mark in marks) else "")
