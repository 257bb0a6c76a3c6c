"""One axis of matplotlib with its label, limits, scale and ticks."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import (
    LogFormatterSciNotation,
    LogLocator,
    MaxNLocator,
    NullFormatter,
    ScalarFormatter,
    StrMethodFormatter,
)

from winkler.plot.panel import PanelAxis
from winkler.plot.svg.scales import MOST_TICKS_ACROSS, broken, digits_of_decades, narrow_parts


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
    if one.log:
        low, high = axis.get_view_interval()
        axis.set_major_locator(LogLocator(subs=digits_of_decades(low, high), numticks=12))
        power_of_ten = LogFormatterSciNotation(labelOnlyBase=False, minor_thresholds=(np.inf, np.inf))
        short = one.plain and low >= 1e-4 and high < 1e6  # others are written with powers of ten
        axis.set_major_formatter(StrMethodFormatter("{x:g}") if short else power_of_ten)
        axis.set_minor_formatter(NullFormatter())
    if one.parts:
        axis.set_major_locator(
            LogLocator(numticks=one.parts) if one.log else MaxNLocator(nbins=one.parts, integer=True)
        )
    elif not upright and not one.log:
        axis.set_major_locator(MaxNLocator(nbins=MOST_TICKS_ACROSS, steps=[1, 2, 2.5, 5, 10]))
    formatter = axis.get_major_formatter()
    if isinstance(formatter, ScalarFormatter):
        formatter.set_useOffset(False)
    if one.ticks is not None:
        axis.set_ticks(one.ticks / one.scale.factor, one.names or None)
    (axes.set_ylabel if upright else axes.set_xlabel)(broken(one.title) if upright else one.title, color=one.colour)


def thin_ticks(axes: Axes, across: PanelAxis) -> None:
    """Leave fewer ticks on the horizontal axis of a panel that equal scales make narrow."""
    parts = narrow_parts(across, axes.get_xlim(), axes.get_ylim())
    if parts:
        axes.xaxis.set_major_locator(MaxNLocator(nbins=parts, steps=[1, 2, 2.5, 5, 10]))
