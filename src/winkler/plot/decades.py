"""Quantities over many decades of time or frequency: lines on logarithmic axes, and the points behind them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from winkler.plot import style
from winkler.plot.families import spans_decades, stretch
from winkler.plot.series import Series, middle_scale

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

__all__ = ["Line", "draw_decades"]

FEW = 60
"""More points than these are not shown one by one."""
CROWDED = 5.0
"""Over more decades than these not each of them is labelled."""
LEAST = 1e-4
"""A logarithmic axis ends at this part of the greatest number."""


class Line(NamedTuple):
    """One quantity, its name for the legend, and points of it that were measured or asked for."""

    of: Series
    name: str = ""
    points: tuple[np.ndarray, np.ndarray] = (np.empty(0), np.empty(0))


def draw_decades(axes: Axes, along: Series, lines: Sequence[Line], ylabel: str = "") -> None:
    """Draw quantities of one unit over decades of another.

    Parameters
    ----------
    axes : Axes
        Empty.
    along : Series
        Positive numbers.
    lines : sequence of Line
        Over these.
    ylabel : str
        What they are together, without a unit; the label of the first one if empty.
    """
    from matplotlib.ticker import LogLocator

    contents = np.concatenate([np.ravel(line.of.content) for line in lines])
    across, upright = along.scale, middle_scale(lines[0].of.word.unit, contents)
    for place, line in enumerate(lines):
        colour = style.CYCLE[place]
        axes.plot(
            along.shown(across),
            line.of.shown(upright),
            color=colour,
            linestyle=style.DASHES[place % len(style.DASHES)],
            label=line.name or None,
        )
        x, y = line.points
        if 0 < x.size <= FEW:
            axes.plot(x / across.factor, y / upright.factor, "o", color=colour, markersize=4.0, zorder=5)
    axes.margins(x=0.04, y=0.08)
    stretch(axes, axes.xaxis)
    if np.ptp(np.log10(along.content)) > CROWDED:
        axes.xaxis.set_major_locator(LogLocator(numticks=5))
    if spans_decades(contents):
        lowest = max(0.7 * float(np.min(contents)), LEAST * float(np.max(contents)))
        axes.set_ylim(lowest / upright.factor, 1.5 * float(np.max(contents)) / upright.factor)
        stretch(axes, axes.yaxis)
    else:
        low, high = axes.get_ylim()
        axes.set_ylim(min(low, 0.0), high)
    axes.set_xlabel(along.label(across))
    axes.set_ylabel(f"{ylabel} [{upright.unit}]" if ylabel and upright.unit else ylabel or lines[0].of.label(upright))
    if len(lines) > 1:
        style.framed_legend(axes, loc="best")
