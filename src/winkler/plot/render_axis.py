"""One axis of matplotlib with its label, limits, scale and ticks."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from winkler.plot.panel import PanelAxis

__all__ = ["set_axis", "thin_ticks"]

MOST_TICKS_ACROSS = 7
"""Parts of a horizontal axis; more of them with labels as long as -0.25 run into each other in a narrow panel."""

NARROW = 0.8
"""Width over height of a panel with equal scales below which its horizontal axis has fewer ticks."""


def set_axis(axes: Axes, side: str, one: PanelAxis) -> None:
    """Set label, limits, scale and ticks of one axis."""
    axis, upright = (axes.xaxis, False) if side == "x" else (axes.yaxis, True)
    set_limits = axes.set_ylim if upright else axes.set_xlim
    get_limits = axes.get_ylim if upright else axes.get_xlim
    if one.log:
        (axes.set_yscale if upright else axes.set_xscale)("log")
    low, high = (None if end is None else end / one.scale.factor for end in (one.low, one.high))
    if low is not None or high is not None:
        set_limits(low, high)
    if one.headroom:
        bottom, top = get_limits()
        set_limits(bottom, top + one.headroom * (top - bottom))
    if one.falling:
        axis.set_inverted(True)
    if one.log and one.plain:
        low, high = axis.get_view_interval()
        is_narrow = np.log10(high / low) < 2.5
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if is_narrow else (1.0,), numticks=12))
        axis.set_major_formatter(FuncFormatter(lambda number, _: f"{number:g}"))
        axis.set_minor_formatter(NullFormatter())
    if one.log and one.sparse:
        axis.set_minor_formatter("")
    if one.parts:
        axis.set_major_locator(
            LogLocator(numticks=one.parts) if one.log else MaxNLocator(nbins=one.parts, integer=True)
        )
    elif not upright and not one.log:
        axis.set_major_locator(MaxNLocator(nbins=MOST_TICKS_ACROSS, steps=[1, 2, 2.5, 5, 10]))
    if one.ticks is not None:
        axis.set_ticks(one.ticks / one.scale.factor, one.names or None)
    (axes.set_ylabel if upright else axes.set_xlabel)(one.title, color=one.colour)


def thin_ticks(axes: Axes, across: PanelAxis) -> None:
    """Leave fewer ticks on the horizontal axis of a panel that equal scales make narrow."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    ratio = abs((right - left) / (top - bottom)) if top != bottom else 1.0
    if ratio < NARROW and across.ticks is None and not (across.parts or across.log):
        parts = max(2, round(MOST_TICKS_ACROSS * ratio / NARROW) - 1)
        axes.xaxis.set_major_locator(MaxNLocator(nbins=parts, steps=[1, 2, 2.5, 5, 10]))
