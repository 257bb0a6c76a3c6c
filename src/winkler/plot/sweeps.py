"""Pictures of sweeps: maps over two keys, points over each key, and the part of the variance of each key."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.axis import edges_of
from winkler.plot.families import spans_decades
from winkler.plot.panel import Bars, Dots, Map, Panel, PanelAxis, Sheet
from winkler.plot.series import Scale, Series, common_scale, middle_scale

MOST_COLUMNS = 3
"""Most panels side by side."""


def _axis(one: Series, **more: Any) -> PanelAxis:
    """Return an axis, logarithmic where the numbers span decades."""
    logarithmic = spans_decades(one.content)
    scale = middle_scale(one.word.unit, one.content) if logarithmic else common_scale(one)
    return PanelAxis.of(one, scale, log=logarithmic, plain=logarithmic, **more)


def map_sheet(along: Series, up: Series, of: Series) -> Sheet:
    """Return a map of one result over two varied quantities.

    Parameters
    ----------
    along, up : Series
        Varied quantities, ``(n,)`` and ``(m,)``.
    of : Series
        The result, ``(n, m)``; white where it is NaN.
    """
    across, above = np.argsort(along.content, kind="stable"), np.argsort(up.content, kind="stable")
    x, y, bar = _axis(along), _axis(up), dataclasses.replace(_axis(of), plain=True)
    content = of.content[np.ix_(across, above)].T
    varies = bool(np.nanmin(content) < np.nanmax(content))
    drawn = Map(
        edges_of(along.content[across], decades=x.log),
        edges_of(up.content[above], decades=y.log),
        content,
        bar,
        kind="cells",
        lines=_levels(content, bar.log) if varies else (),
        line_colour="black",
        line_width=0.5 if varies else 0.0,
        centres=(along.content[across], up.content[above]),
    )
    return Sheet((Panel((drawn,), x, y, grid=""),), width=4.8, height=3.9)


def _levels(content: Array, logarithmic: bool) -> Array:
    low, high = float(np.nanmin(content)), float(np.nanmax(content))
    ends = np.geomspace(low, high, 9) if logarithmic else np.linspace(low, high, 9)
    return np.asarray(ends[1:-1])


def cloud_sheet(along: Sequence[Series], of: Series) -> Sheet:
    """Return one panel for every varied quantity: one result at all points of a design over it.

    Parameters
    ----------
    along : sequence of Series
        Varied quantities, each ``(points,)``.
    of : Series
        The result, ``(points,)``.
    """
    columns = min(MOST_COLUMNS, len(along))
    rows = -(-len(along) // columns)
    size = float(np.clip(200.0 / np.sqrt(of.content.size), 1.0, 12.0))
    upright = _axis(of, margin=0.06)
    panels = [
        Panel(
            (Dots(one.content, of.content, size=size, coarse=True),),
            _axis(one, margin=0.04),
            dataclasses.replace(upright, label="", scale=Scale(upright.scale.factor, ""))
            if place % columns
            else upright,
        )
        for place, one in enumerate(along)
    ]
    width, height = 1.0 + 2.5 * columns + (1.2 if columns == 1 else 0.0), 0.5 + 2.5 * rows
    return Sheet(tuple(panels), columns, width=width / columns, height=height / rows, shared="y")


class VariancePart(NamedTuple):
    """Parts of a variance, one number for each varied key, with the ends of their intervals."""

    label: str
    content: Array
    low: Array
    high: Array


def part_sheet(names: Sequence[str], parts: Sequence[VariancePart]) -> Sheet:
    """Return bars of the parts of the variance of a result that each key explains.

    Parameters
    ----------
    names : sequence of str
        The varied keys.
    parts : sequence of Part
        Side by side for each key.
    """
    places, thick = np.arange(float(len(names))), 0.8 / len(parts)
    bars = []
    for number, (part, colour) in enumerate(zip(parts, style.CYCLE, strict=False)):
        at = places + (number - (len(parts) - 1) / 2.0) * thick
        ends = np.maximum(np.stack([part.content - part.low, part.high - part.content]), 0.0)
        bars.append(Bars(at, part.content, colour, 0.9 * thick, name=part.label, ends=ends))
    across = PanelAxis("part of the variance", low=min(0.0, float(np.min([part.low for part in parts]))))
    panel = Panel(tuple(bars), across, PanelAxis(ticks=places, names=tuple(names), falling=True), grid="x")
    return Sheet((panel,), width=4.8, height=1.3 + 0.5 * len(names), below=len(parts))
