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

__all__ = ["set_axis", "thin_ticks"]

MOST_TICKS_ACROSS = 7
"""Parts of a horizontal axis; more of them with labels as long as -0.25 run into each other in a narrow panel."""

LEAST_LABELLED_SPANS = ((0.7, (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)), (2.5, (1.0, 2.0, 5.0)))
"""Decades that an axis spans at most -> the digits labelled there; over more decades powers of ten alone."""

LONG, SYMBOL_WIDTH = 34, 10
"""Letters of a label beside which a panel of usual height has room, and those that a symbol and its unit take."""

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
    if one.log:
        low, high = axis.get_view_interval()
        span = np.log10(high / low)
        digits = next((digits for most, digits in LEAST_LABELLED_SPANS if span < most), (1.0,))
        axis.set_major_locator(LogLocator(subs=digits, numticks=12))
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
    (axes.set_ylabel if upright else axes.set_xlabel)(_broken(one.title) if upright else one.title, color=one.colour)


def _broken(title: str) -> str:
    """Return a long label of an upright axis in two lines: the second one begins with the symbol, or is one half."""
    name, dollar, symbol = title.partition(" $")
    if len(name) + min(len(symbol), SYMBOL_WIDTH) <= LONG:
        return title
    if dollar and len(name) <= LONG:
        return f"{name}\n${symbol}"
    words = name.split(" ")
    half = next(count for count in range(1, len(words) + 1) if 2 * len(" ".join(words[:count])) >= len(name))
    return "\n".join(part for part in (" ".join(words[:half]), " ".join(words[half:]) + dollar + symbol) if part)


def thin_ticks(axes: Axes, across: PanelAxis) -> None:
    """Leave fewer ticks on the horizontal axis of a panel that equal scales make narrow."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    ratio = abs((right - left) / (top - bottom)) if top != bottom else 1.0
    if ratio < NARROW and across.ticks is None and not (across.parts or across.log):
        parts = max(2, round(MOST_TICKS_ACROSS * ratio / NARROW) - 1)
        axes.xaxis.set_major_locator(MaxNLocator(nbins=parts, steps=[1, 2, 2.5, 5, 10]))
