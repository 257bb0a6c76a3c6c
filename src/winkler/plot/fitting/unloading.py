"""Pictures of a measured indentation: its segments as they were found, and how its last unloading was read."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.fitting.curves.segments import Segment, SegmentKind
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Scale, Series
from winkler.vocabulary import Word

if TYPE_CHECKING:
    from winkler.fitting.curves.curve import ForceCurve
    from winkler.fitting.unloading.oliver_pharr import OliverPharrSolution
    from winkler.plot.picture import Picture

__all__ = ["segments_sheet", "unloading_sheet"]

COLOURS = {
    SegmentKind.LOADING: style.BLUE,
    SegmentKind.HOLD: style.ORANGE,
    SegmentKind.PARTIAL_UNLOADING: style.SKY,
    SegmentKind.LAST_UNLOADING: style.GREEN,
}
NAMED = 0.03
"""Part of the axis from which on a segment has room for its name."""
HEADROOM = 0.45
"""Part of the forces that is left above them for the names."""


def segments_sheet(curve: ForceCurve) -> Picture:
    """Return a figure of a curve: its segments in their order, each with its name, and force over position.

    Parameters
    ----------
    curve : ForceCurve
    """
    with style.styled():
        figure = style.figure(width=9.2, height=3.4)
        left, right = figure.subplots(1, 2)
        _in_order(left, curve, curve.segments)
        _over_depth(right, Series("position", Word("D", "m", "position"), curve.position), curve, curve.segments)
        left.set_title("segments")
        right.set_title("force over position")
        style.framed_legend(right, loc="upper left")
    return figure


def unloading_sheet(item: OliverPharrSolution) -> Picture:
    """Return a figure of a reading: the segments, the fitted unloading, its slope at the peak, and the contact depth.

    Parameters
    ----------
    item : OliverPharrSolution
    """
    problem = item.problem
    curve, segments = problem.curve, problem.curve.segments
    depth = Series("depth", Word("h", "m", "depth"), curve.depth(problem.contact_point))
    with style.styled():
        figure = style.figure(width=9.2, height=3.6)
        left, right = figure.subplots(1, 2)
        _in_order(left, curve, segments)
        across, upright = _over_depth(right, depth, curve, segments)
        share = np.linspace(0.0, 1.0, 200)
        law = item.final_depth + share * (item.depth - item.final_depth)
        right.plot(
            law / across.factor,
            item.fitted_force * share**item.exponent / upright.factor,
            color=style.RED,
            lw=1.2,
            label=f"$F \\propto (h-h_f)^{{{item.exponent:.3g}}}$",
        )
        fitted = depth.content[item.fitted_points.astype(int)]
        right.axvspan(fitted.min() / across.factor, fitted.max() / across.factor, color=style.GREEN, alpha=0.08, lw=0.0)
        foot = item.depth - item.fitted_force / item.stiffness
        right.plot(
            np.array([foot, item.depth]) / across.factor,
            np.array([0.0, item.fitted_force]) / upright.factor,
            color=style.INK,
            lw=1.0,
            ls=(0, (4, 2)),
            label="stiffness $S$",
        )
        right.plot(item.depth / across.factor, item.force / upright.factor, "o", color=style.INK, ms=4.0, label="peak")
        right.axvline(item.contact_depth / across.factor, color=style.MUTED, lw=0.9, label="contact depth $h_c$")
        left.set_title("segments")
        right.set_title("the unloading and its stiffness")
        style.framed_legend(right, loc="upper left")
    return figure


def _in_order(axes: Any, curve: ForceCurve, segments: tuple[Segment, ...]) -> None:
    """Draw the force over time, or over the number of the point, with the segments behind it."""
    order = (
        Series("time", Word("t", "s", "time"), curve.time)
        if curve.timed
        else Series("point", Word("", "", "point"), np.arange(float(curve.count)))
    )
    force = Series("force", Word("F", "N", "force"), curve.force)
    along = order.shown(order.scale)
    span = float(np.ptp(along)) or 1.0
    for part in segments:
        start, end = along[part.first], along[min(part.last + 1, curve.count - 1)]
        axes.axvspan(start, end, color=COLOURS[part.kind], alpha=0.14, lw=0.0)
        if end - start > NAMED * span:
            axes.text(
                0.5 * (start + end),
                0.98,
                part.kind.value,
                rotation=90.0,
                ha="center",
                va="top",
                fontsize=8.0,
                transform=axes.get_xaxis_transform(),
            )
    axes.plot(along, force.shown(force.scale), color=style.INK, lw=1.2)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + HEADROOM * (high - low))
    axes.set_xlabel(order.label(order.scale))
    axes.set_ylabel(force.label(force.scale))


def _over_depth(axes: Any, depth: Series, curve: ForceCurve, segments: tuple[Segment, ...]) -> tuple[Scale, Scale]:
    """Draw force over depth, one colour for each kind of segment, and return both scales."""
    force = Series("force", Word("F", "N", "force"), curve.force)
    across, upright = depth.scale, force.scale
    x, y = depth.shown(across), force.shown(upright)
    for kind, colour in COLOURS.items():
        mine = [_with_start(part, x, y) for part in segments if part.kind is kind]
        for place, (places, forces) in enumerate(mine):
            label = kind.value if place == 0 else None
            axes.plot(places, forces, ".-", color=colour, ms=2.5, lw=0.8, label=label, rasterized=curve.count > 4000)
    axes.set_xlabel(depth.label(across))
    axes.set_ylabel(force.label(upright))
    axes.margins(x=0.02, y=0.04)
    return across, upright


def _with_start(part: Segment, x: Array, y: Array) -> tuple[Array, Array]:
    """Return a segment joined to the last point of the one before."""
    mine = slice(max(part.first - 1, 0), part.last + 1)
    return x[mine], y[mine]
