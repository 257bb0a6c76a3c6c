"""Families of curves: an answer over one varied quantity, one curve for each value of another."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.plot import style
from winkler.plot.series import Scale, Series, common_scale, middle_scale

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

    from winkler.plot.picture import Picture

__all__ = ["bar_picture", "draw_bars", "draw_family", "family_picture", "spans_decades", "stretch"]

TELLABLE = len(style.CYCLE)
"""So many curves are told apart by colour; more take the shades of a map."""
DECADES = 1.5
"""Values that span more decades than this are shown on a logarithmic axis."""


def spans_decades(content: np.ndarray) -> bool:
    """Return whether numbers are positive and better seen on a logarithmic axis."""
    known = content[np.isfinite(content)]
    if known.size < 3 or known.min() <= 0.0:
        return False
    return bool(np.log10(known.max() / known.min()) > DECADES)


def draw_family(
    axes: Axes,
    along: Sequence[Series],
    of: Sequence[Series],
    labels: Sequence[str],
    *,
    logarithmic: bool = True,
    ordered: bool = True,
) -> None:
    """Draw one curve for every pair of series.

    Parameters
    ----------
    axes : Axes
        Empty.
    along, of : sequence of Series
        Of one quantity each.
    labels : sequence of str
        One for each curve; empty for a single one.
    logarithmic : bool
        Whether axes whose values span decades are made logarithmic.
    ordered : bool
        Whether points are joined by their place along the axis; if not, in the order in which they are given.
    """
    steep = logarithmic and spans_decades(np.concatenate([one.content.ravel() for one in along]))
    steeper = steep and spans_decades(np.concatenate([one.content.ravel() for one in of]))
    across = _scale(along, steep)
    upright = _scale(of, steeper)
    many = len(of) > TELLABLE
    for place, (x, y) in enumerate(zip(along, of, strict=True)):
        colour = style.shades()(0.15 + 0.85 * place / (len(of) - 1)) if many else style.CYCLE[place]
        order = np.argsort(x.content, kind="stable") if ordered else np.arange(x.content.size)
        axes.plot(
            x.shown(across)[order],
            y.shown(upright)[order],
            color=colour,
            linestyle="-" if many else style.DASHES[place % len(style.DASHES)],
            marker="o" if order.size <= 40 else "",
            markersize=4.0,
            label=labels[place] if not many or place in (0, len(of) // 2, len(of) - 1) else None,
        )
    axes.margins(x=0.04, y=0.06)
    for axis, decades in ((axes.xaxis, steep), (axes.yaxis, steeper)):
        if decades:
            stretch(axes, axis)
    axes.set_xlabel(along[0].label(across))
    axes.set_ylabel(of[0].label(upright))


def _scale(many: Sequence[Series], steep: bool) -> Scale:
    """Return one scale for all: by the greatest number, or on a logarithmic axis by the middle one."""
    if steep:
        return middle_scale(many[0].word.unit, np.concatenate([one.content.ravel() for one in many]))
    return common_scale(*many)


def stretch(axes: Axes, axis: Axis) -> None:
    """Make one axis logarithmic, with plain numbers at its ticks."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    if axis is axes.xaxis:
        axes.set_xscale("log")
    else:
        axes.set_yscale("log")
    low, high = axis.get_view_interval()
    few = np.log10(high / low) < 2.5
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if few else (1.0,), numticks=12))
    axis.set_major_formatter(FuncFormatter(lambda number, _: f"{number:g}"))
    axis.set_minor_formatter(NullFormatter())


def draw_bars(axes: Axes, names: Sequence[str], of: Series) -> None:
    """Draw one bar for every name: an answer for shapes or solids that are no numbers.

    Parameters
    ----------
    axes : Axes
        Empty.
    names : sequence of str
    of : Series
        One number for each name; none where it is NaN.
    """
    places = np.arange(len(names))
    axes.barh(places, np.nan_to_num(of.shown()), color=style.BLUE, height=0.62)
    axes.set_yticks(places, names)
    axes.invert_yaxis()
    axes.set_xlabel(of.label())
    axes.grid(visible=False, axis="y")


def family_picture(
    along: Sequence[Series], of: Sequence[Series], labels: Sequence[str], *, ordered: bool = True
) -> Picture:
    """Return a figure of one answer over one varied quantity.

    Parameters
    ----------
    along, of : sequence of Series
        One pair for each curve.
    labels : sequence of str
        One for each curve; a legend is shown if there are several.
    ordered : bool, optional
        Whether points are joined by their place along the axis; if not, in the order in which they are given.
    """
    with style.styled():
        figure = style.figure(width=4.6, height=3.3 if len(labels) < 2 else 3.9)
        axes = figure.add_subplot()
        draw_family(axes, along, of, labels, ordered=ordered)
        if len(labels) > 1:
            handles, told = axes.get_legend_handles_labels()
            figure.legend(handles, told, loc="outside lower center", ncols=1 if max(map(len, told)) > 28 else 2)
    return figure


def bar_picture(names: Sequence[str], of: Series) -> Picture:
    """Return a figure of one answer for things that are no numbers: one bar each.

    Parameters
    ----------
    names : sequence of str
        What was varied: one for each bar.
    of : Series
        One number for each bar.
    """
    with style.styled():
        figure = style.figure(width=4.6, height=max(1.6, 0.9 + 0.3 * len(names)))
        draw_bars(figure.add_subplot(), names, of)
    return figure
