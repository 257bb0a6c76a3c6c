"""Pictures of sweeps with many points: maps over two keys, clouds of points over each key, and what each key tells."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.families import spans_decades, stretch
from winkler.plot.series import Scale, Series, common_scale, middle_scale

if TYPE_CHECKING:
    from winkler.plot.picture import Picture

__all__ = ["Part", "cloud_picture", "map_picture", "part_picture"]

ACROSS = 3
"""Panels side by side."""


def _scale(one: Series, steep: bool) -> Scale:
    return middle_scale(one.word.unit, one.content) if steep else common_scale(one)


def map_picture(along: Series, up: Series, of: Series) -> Picture:
    """Return a map of one answer over two varied quantities.

    Parameters
    ----------
    along, up : Series
        What was varied, ``(n,)`` and ``(m,)``.
    of : Series
        The answer, ``(n, m)``; places where it is NaN stay white.
    """
    from matplotlib.colors import LogNorm, Normalize

    across, above = np.argsort(along.content, kind="stable"), np.argsort(up.content, kind="stable")
    steep = spans_decades(of.content)
    scale = _scale(of, steep)
    with style.styled():
        figure = style.figure(width=4.8, height=3.9)
        axes = figure.add_subplot()
        sides = [(one, spans_decades(one.content)) for one in (along, up)]
        x, y = (one.shown(_scale(one, decades)) for one, decades in sides)
        content = of.shown(scale)[np.ix_(across, above)].T
        edges = (_edges(x[across], sides[0][1]), _edges(y[above], sides[1][1]))
        norm = (LogNorm if steep else Normalize)()
        mesh = axes.pcolormesh(*edges, content, cmap=style.shades(), norm=norm, rasterized=True)
        if np.nanmin(content) < np.nanmax(content):
            levels = _levels(content, steep)
            axes.contour(x[across], y[above], content, levels=levels, colors="black", linewidths=0.5)
        for axis, (_, decades) in zip((axes.xaxis, axes.yaxis), sides, strict=True):
            if decades:
                stretch(axes, axis)
        axes.set_xlabel(along.label(_scale(*sides[0])))
        axes.set_ylabel(up.label(_scale(*sides[1])))
        axes.grid(visible=False)
        bar = figure.colorbar(mesh, ax=axes)
        bar.set_label(of.label(scale))
        if steep:
            stretch(bar.ax, bar.ax.yaxis)
        bar.ax.minorticks_off()
    return figure


def _edges(places: Array, decades: bool) -> Array:
    """Return the ends of cells around rising places."""
    along = np.log(places) if decades else places
    middle = 0.5 * (along[1:] + along[:-1])
    found = np.concatenate([[2.0 * along[0] - middle[0]], middle, [2.0 * along[-1] - middle[-1]]])
    return np.asarray(np.exp(found) if decades else found)


def _levels(content: Array, steep: bool) -> Array:
    low, high = float(np.nanmin(content)), float(np.nanmax(content))
    ends = np.geomspace(low, high, 9) if steep else np.linspace(low, high, 9)
    return np.asarray(ends[1:-1])


def cloud_picture(along: Sequence[Series], of: Series) -> Picture:
    """Return one panel for every varied quantity: all points of a design, one answer over it.

    Parameters
    ----------
    along : sequence of Series
        What was varied, each ``(points,)``.
    of : Series
        The answer, ``(points,)``.
    """
    columns = min(ACROSS, len(along))
    rows = -(-len(along) // columns)
    steeper = spans_decades(of.content)
    upright = _scale(of, steeper)
    with style.styled():
        figure = style.figure(width=1.0 + 2.5 * columns + (1.2 if columns == 1 else 0.0), height=0.5 + 2.5 * rows)
        first = None
        for place, one in enumerate(along):
            axes = figure.add_subplot(rows, columns, place + 1, sharey=first)
            steep = spans_decades(one.content)
            across = _scale(one, steep)
            size = float(np.clip(200.0 / np.sqrt(of.content.size), 1.0, 12.0))
            axes.scatter(
                one.shown(across), of.shown(upright), s=size, color=style.BLUE, linewidths=0.0, rasterized=True
            )
            axes.margins(x=0.04, y=0.06)
            axes.set_xlabel(one.label(across))
            if place % columns == 0:
                axes.set_ylabel(of.label(upright))
            else:
                axes.tick_params(labelleft=False)
            if steep:
                stretch(axes, axes.xaxis)
            if steeper:
                stretch(axes, axes.yaxis)
            first = first or axes
    return figure


class Part(NamedTuple):
    """Parts of a variance, one number for each varied key, with the ends of their intervals."""

    label: str
    content: Array
    low: Array
    high: Array


def part_picture(names: Sequence[str], parts: Sequence[Part]) -> Picture:
    """Return bars of how much of the scatter of an answer each key makes.

    Parameters
    ----------
    names : sequence of str
        The varied keys.
    parts : sequence of Part
        Side by side for each key.
    """
    with style.styled():
        figure = style.figure(width=4.8, height=1.3 + 0.5 * len(names))
        axes = figure.add_subplot()
        places, thick = np.arange(len(names)), 0.8 / len(parts)
        for number, (part, colour) in enumerate(zip(parts, style.CYCLE, strict=False)):
            at = places + (number - (len(parts) - 1) / 2.0) * thick
            ends = np.maximum(np.stack([part.content - part.low, part.high - part.content]), 0.0)
            bars = {"ecolor": "black", "elinewidth": 0.8, "capsize": 2.0}
            axes.barh(at, part.content, height=0.9 * thick, color=colour, label=part.label, xerr=ends, error_kw=bars)
        axes.set_yticks(places, names)
        axes.invert_yaxis()
        axes.set_xlim(left=min(0.0, float(np.min([part.low for part in parts]))))
        axes.set_xlabel("part of the variance")
        axes.grid(visible=False, axis="y")
        figure.legend(loc="outside lower center", ncols=len(parts))
    return figure
