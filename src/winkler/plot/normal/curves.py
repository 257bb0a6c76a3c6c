"""The curves of a contact: load of the springs, pressure, displacement of the surface, and answers over many loads."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.fields import SurfaceFields, restore
from winkler.foundation.bed import Pressed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import is_singular, is_torn, marks_of
from winkler.plot.medium import OFF_AXIS
from winkler.plot.series import Curve, Series, places, scale_of, series, told
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.answer import Restorable
from winkler.problems.normal.indentation import IndentationSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "draw_curve",
    "draw_line_load",
    "draw_pressure",
    "draw_surface",
    "draw_surface_pressure",
    "force_depth",
    "line_load",
    "load_curves",
    "surface",
]

MARKED = 40
"""Curves of at most so many points show each of them."""
POINTS = 121
"""Points of F(d)."""
CEILING = 3.0
"""Where a pressure is infinite, its axis ends at so many mean pressures."""


def line_load(solution: Restorable, extent: float) -> Curve:
    """Return q(x) on both sides of the axis, with its jumps at a pinned edge.

    Parameters
    ----------
    solution
        For one load.
    extent : float
        [m].
    """
    pressed = solution.pressed
    a = pressed.radius
    x = np.concatenate([[OFF_AXIS * a], places(a, marks_of(pressed)), [a]]) if a > 0.0 else np.zeros(1)
    q = pressed.bed.normal_stiffness(x) * pressed.value(x) if a > 0.0 else np.zeros(1)
    x, q = np.append(x, [a, max(extent, a)]), np.append(q, [0.0, 0.0])
    both = style.mirrored(x, q)
    return Curve(series("IndentationSolution", "x", both[0]), series("IndentationSolution", "line_load", both[1]))


def surface(solution: Restorable, extent: float) -> SurfaceFields:
    """Return the fields on the surface at places that suit a picture: dense towards kinks and edge, never on them.

    Parameters
    ----------
    solution
        For one load.
    extent : float
        [m].
    """
    return restore(solution, places(extent, marks_of(solution.pressed), count=320))


def load_curves(solution: IndentationSolution | AdhesiveSolution) -> dict[str, Curve]:
    """Return force, contact radius and stiffness over the depth, of a solution for many loads.

    Not the stiffness of bodies that stick: it has no bounds where they come apart.
    """
    order = np.argsort(np.ravel(solution.depth), kind="stable")

    def sorted_series(name: str) -> Series:
        return series("IndentationSolution", name, np.ravel(getattr(solution, name))[order])

    depth = sorted_series("depth")
    names = ("force", "radius") if isinstance(solution, AdhesiveSolution) else ("force", "radius", "stiffness")
    return {name: Curve(depth, sorted_series(name)) for name in names}


def force_depth(pressed: Pressed) -> Curve:
    """Return F(d) from first touch to a contact, NaN where the contact cannot be one disc on the way.

    Parameters
    ----------
    pressed : Pressed
        Where the curve ends.

    Notes
    -----
    The curve is followed by the contact radius, d = g(a): a disc needs every spring inside compressed, so that g(a)
    is not below any g(x) inside.  A contact that is pinned at its rim goes on with constant stiffness.
    """
    bed, a = pressed.bed, pressed.radius * np.linspace(0.0, 1.0, POINTS)
    depth = np.asarray(bed.gap(a), dtype=float)
    force = bed.stiffness(a) * depth - bed.gap_load(a)
    force = np.where(depth >= np.maximum.accumulate(depth), force, np.nan)
    end = bed.stiffness(a[-1:]) * pressed.depth - bed.gap_load(a[-1:])
    depth, force = np.append(depth, pressed.depth), np.append(force, end)
    return Curve(series("IndentationSolution", "depth", depth), series("IndentationSolution", "force", force))


def draw_curve(axes: Axes, curve: Curve, colour: str = style.BLUE, **options: Any) -> None:
    """Draw one quantity over another, with labelled axes; every point too where they are few.

    Parameters
    ----------
    axes : Axes
    curve : Curve
    colour : str
    options
        Passed on to matplotlib's plot.
    """
    few = curve.along.content.size <= MARKED
    options.setdefault("marker", "o" if few else "")
    axes.plot(curve.along.shown(), curve.of.shown(), color=colour, **options)
    axes.set_xlabel(curve.along.label())
    axes.set_ylabel(curve.of.label())
    axes.margins(x=0.03 if few else 0.0)


def draw_line_load(
    axes: Axes, solution: Restorable, extent: float, force: float | None = None, pull: float = 0.0
) -> None:
    """Draw q(x); the area below it is the force, that above it where springs pull counted negative.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution
        For one load.
    extent : float
        [m].
    force : float, optional
        [N], told in the picture.
    pull : float, optional
        What attraction from afar adds to the pull [N]: the springs bear it beside the force.
    """
    curve = line_load(solution, extent)
    draw_curve(axes, curve, style.RED, marker="")
    x, q = curve.along.shown(), curve.of.shown()
    for part, colour in ((np.maximum(q, 0.0), style.RED), (np.minimum(q, 0.0), style.BLUE)):
        axes.fill_between(x, part, color=colour, alpha=0.16, linewidth=0.0)
    if not np.any(q != 0.0):
        axes.set_ylim(0.0, 1.0)
        style.note(axes, "no contact", where="upper centre")
        return
    away = q[np.abs(curve.along.content) >= 0.03 * solution.pressed.radius]
    top, bottom = 1.12 * max(float(np.max(away)), 0.0), 1.12 * min(float(np.min(away)), 0.0)
    axes.set_ylim(bottom, top)
    if bottom < 0.0:
        axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    if force is not None:
        sum_ = "$F_N$" if pull == 0.0 else "$F_N + F_w$"
        axes.text(
            0.0,
            0.36 * (top if q[q.size // 2] > 0.0 else bottom),
            f"area = {sum_}\n= {told(force + pull, 'N')}",
            ha="center",
            va="center",
            fontsize=8.5,
            linespacing=1.5,
        )


def draw_pressure(axes: Axes, solution: Restorable, extent: float, mean: float | None = None, remark: str = "") -> None:
    """Draw p(r), mirrored at the axis; where it is infinite, the picture ends and says so.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution
        For one load.
    extent : float
        [m].
    mean : float, optional
        Mean pressure [Pa], drawn as a line.
    remark : str, optional
        Added to what is said where the edge pulls with infinite tension.
    """
    fields = surface(solution, extent)
    _pressure(axes, fields, solution.pressed, mean, remark)


def _pressure(axes: Axes, fields: SurfaceFields, pressed: Pressed, mean: float | None, remark: str) -> None:
    radius, singular = pressed.radius, is_singular(pressed)
    r, p = series("SurfaceFields", "r", fields.r), series("SurfaceFields", "pressure", fields.pressure)
    finite = p.content[np.isfinite(p.content)]
    top = 1.12 * float(np.max(finite, initial=0.0))
    if singular and mean:
        top = min(top, CEILING * mean)
    bottom = 1.12 * float(np.min(finite, initial=0.0))
    if is_torn(pressed):
        usual = float(np.median(np.abs(finite[fields.r[np.isfinite(p.content)] < pressed.radius])))
        top = min(top, CEILING * usual)
        bottom = max(bottom, -2.0 * max(top, usual))
    scale = scale_of("Pa", [top, bottom])
    across = r.scale
    x, y = style.mirrored(r.shown(), p.shown(scale))
    axes.plot(x, y, color=style.BLUE)
    axes.fill_between(x, y, color=style.BLUE, alpha=0.14, linewidth=0.0)
    axes.set_xlim(-np.max(x), np.max(x))
    axes.set_ylim(bottom / scale.factor, top / scale.factor if top > bottom else 1.0)
    if bottom < 0.0:
        axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    if mean:
        span = np.array([-radius, 1.06 * radius]) / across.factor
        axes.plot(span, np.full(2, mean / scale.factor), color=style.INK, linewidth=1.0, linestyle=(0, (4, 3)))
        axes.text(1.1 * span[1], mean / scale.factor, f"mean\n{told(mean, 'Pa')}", ha="left", va="center", fontsize=8.5)
    if radius == 0.0:
        style.note(axes, "no contact", where="upper centre")
    if is_torn(pressed):
        style.note(axes, f"infinite tension at the edge, cut off{remark}", where="lower centre")
    elif singular:
        where = "upper centre" if pressed.edge > 0.0 else "upper right"
        style.note(axes, "infinite where\nthe curve leaves", where=where)
    axes.set_xlabel(r.label(across))
    axes.set_ylabel(p.label(scale))


def draw_surface_pressure(axes: Axes, fields: SurfaceFields) -> None:
    """Draw restored pressures over r.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : SurfaceFields
        r of shape (n,).
    """
    order = np.argsort(fields.r, kind="stable")
    pressure = np.where(np.isfinite(fields.pressure), fields.pressure, np.nan)[order]
    curve = Curve(series("SurfaceFields", "r", fields.r[order]), series("SurfaceFields", "pressure", pressure))
    draw_curve(axes, curve)
    if not np.any(pressure < 0.0):
        axes.set_ylim(0.0, None)


def draw_surface(axes: Axes, fields: SurfaceFields) -> None:
    """Draw the displacement of the surface and the distance of the surfaces, over r.

    Parameters
    ----------
    axes : Axes
        Empty.
    fields : SurfaceFields
    """
    r, sunk = series("SurfaceFields", "r", fields.r), series("SurfaceFields", "displacement", fields.displacement)
    gap = series("SurfaceFields", "gap", np.where(np.isfinite(fields.gap), fields.gap, np.nan))
    known: Array = gap.content[np.isfinite(gap.content)]
    top = 1.6 * float(np.max(np.abs(sunk.content), initial=0.0)) or 1.1 * float(np.max(known, initial=0.0)) or 1.0
    scale = scale_of("m", [top])
    order = np.argsort(r.content, kind="stable")
    few = "o" if order.size <= MARKED else ""
    axes.plot(r.shown()[order], sunk.shown(scale)[order], color=style.BLUE, marker=few, label="displacement $u_z$")
    axes.plot(
        r.shown()[order],
        gap.shown(scale)[order],
        color=style.GREEN,
        marker=few,
        linestyle=style.DASHES[1],
        label="separation $h$",
    )
    axes.set_ylim(1.2 * min(float(np.min(sunk.content, initial=0.0)), 0.0) / scale.factor, top / scale.factor)
    axes.set_xlabel(r.label())
    axes.set_ylabel(f"along the axis [{scale.unit}]")
    style.framed_legend(axes, loc="upper right")
