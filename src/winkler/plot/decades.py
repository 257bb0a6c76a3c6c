"""Quantities over many decades of time or frequency: lines on logarithmic axes, with measured or requested points."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.families import spans_decades
from winkler.plot.panel import Panel, PanelAxis, among, points
from winkler.plot.series import Series, middle_scale

MOST_MARKED_POINTS = 60
"""Points are marked individually up to this number."""
MOST_LABELLED_DECADES = 5.0
"""Over more decades than these not each of them is labelled."""
MARGIN = 0.08
LEAST_SHARE = 1e-4
"""Lower limit of a logarithmic axis, relative to the greatest number."""


class Quantity(NamedTuple):
    """One quantity, its name for the legend, and its measured or requested points."""

    of: Series
    name: str = ""
    points: tuple[np.ndarray, np.ndarray] = (np.empty(0), np.empty(0))


def decades_around(requested: Array, factor: float, count: int) -> Array:
    """Return so many numbers across the requested range, or up to a factor around a single one."""
    low, high = float(np.min(requested)), float(np.max(requested))
    if high <= low * (1.0 + 1e-12):
        low, high = low / factor, high * factor
    return np.geomspace(low, high, count)


def decades_panel(along: Series, quantities: Sequence[Quantity], label: str = "") -> Panel:
    """Return quantities of one unit over decades of another.

    Parameters
    ----------
    along : Series
        Positive numbers.
    quantities : sequence of Quantity
        Over these.
    label : str
        Common label without a unit; that of the first quantity if empty.
    """
    contents = np.concatenate([np.ravel(one.of.content) for one in quantities])
    marks = []
    for place, one in enumerate(quantities):
        marks.append(among(place, along.content, one.of.content, one.name, most=0))
        if 0 < one.points[0].size <= MOST_MARKED_POINTS:
            marks.append(points(*one.points, style.CYCLE[place], size=4.0, order=5.0))
    crowded = np.ptp(np.log10(along.content)) > MOST_LABELLED_DECADES
    across = PanelAxis.of(along, margin=0.04, log=True, plain=True, parts=5 if crowded else 0)
    greatest = float(np.max(contents))
    fitted = float(np.min(contents)) - MARGIN * float(np.ptp(contents))
    ends: dict[str, Any] = {"low": 0.0} if fitted > 0.0 else {}
    if spans_decades(contents):
        lowest = max(0.7 * float(np.min(contents)), LEAST_SHARE * greatest)
        ends = {"low": lowest, "high": 1.5 * greatest, "log": True, "plain": True}
    upright = PanelAxis.of(quantities[0].of, middle_scale(quantities[0].of.word.unit, contents), margin=MARGIN, **ends)
    upright = dataclasses.replace(upright, label=label) if label else upright
    return Panel(tuple(marks), across, upright, legend="best" if len(quantities) > 1 else "")
