"""The curves of a contact: load of the springs, pressure, displacement of the surface, and results over many loads."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fields.restoration import SurfaceFields, restore
from winkler.foundation.bed import PressedSprings
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import has_tensile_singularity, is_singular, marks_of
from winkler.plot.medium import OFFSET_FROM_AXIS
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Text, note, points, zero
from winkler.plot.series import Curve, places, scale_of, series, with_unit
from winkler.problems.answer import Restorable

MOST_MARKED_POINTS = 40
"""Points of a curve are marked individually up to this number."""
POINTS = 121
"""Points of F(d)."""
LEAST_AREA = 0.02
"""Part of the greatest line load above which an area is shaded."""
PRESSURE_CEILING = 3.0
"""Greatest drawn pressure over its mean where it is infinite."""


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
    x = np.concatenate([[OFFSET_FROM_AXIS * a], places(a, marks_of(pressed)), [a]]) if a > 0.0 else np.zeros(1)
    q = pressed.bed.normal_stiffness(x) * pressed.value(x) if a > 0.0 else np.zeros(1)
    x, q = np.append(x, [a, max(extent, a)]), np.append(q, [0.0, 0.0])
    both = style.mirrored(x, q)
    return Curve(series("x", both[0]), series("line_load", both[1]))


def surface(solution: Restorable, extent: float) -> SurfaceFields:
    """Return the fields on the surface at points dense towards kinks and edge, but not on them.

    Parameters
    ----------
    solution
        For one load.
    extent : float
        [m].
    """
    return restore(solution, places(extent, marks_of(solution.pressed), count=320))


def force_depth(pressed: PressedSprings) -> Curve:
    """Return F(d) from first touch to a contact, NaN where the contact area is not a single disc.

    Parameters
    ----------
    pressed : PressedSprings
        Last point of the curve.

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
    return Curve(series("depth", depth), series("force", force))


def curve_panel(curve: Curve, colour: str = style.BLUE, **look: Any) -> Panel:
    """Return one quantity over another, with markers up to `MOST_MARKED_POINTS` points.

    Parameters
    ----------
    curve : Curve
    colour : str
    look
        Of the `Line`.
    """
    is_sparse = curve.along.content.size <= MOST_MARKED_POINTS
    line = Line(curve.along.content, curve.of.content, colour, **({"marker": "o" if is_sparse else ""} | look))
    return Panel((line,), PanelAxis.of(curve.along, margin=0.03 if is_sparse else 0.0), PanelAxis.of(curve.of))


def loaded_so_far(pressed: PressedSprings, force: float) -> Panel:
    """Return F(d) up to a contact, and the contact itself as a point."""
    curve = force_depth(pressed)
    panel = curve_panel(curve, marker="").plus(points(pressed.depth, force, clipped=False))
    return panel.plus(across=PanelAxis.of(curve.along), upright=PanelAxis.of(curve.of, low=0.0))


def line_load_panel(solution: Restorable, extent: float, force: float | None = None, pull: float = 0.0) -> Panel:
    """Return q(x); the area below it is the force, that above it where springs pull counted negative.

    Parameters
    ----------
    solution
        For one load.
    extent : float
        [m].
    force : float, optional
        [N], written into the picture.
    pull : float, optional
        Long-range attraction [N], borne by the springs in addition to the force.
    """
    curve = line_load(solution, extent)
    x, q = curve.along.content, curve.of.content
    marks: list[Any] = [
        Area(x, part, 0.0, colour, 0.16)
        for part, colour in ((np.maximum(q, 0.0), style.RED), (np.minimum(q, 0.0), style.BLUE))
        if np.max(np.abs(part)) > LEAST_AREA * np.max(np.abs(q))
    ]
    marks.append(Line(x, q, style.RED))
    across = PanelAxis.of(curve.along, low=-float(np.max(x)), high=float(np.max(x)))
    if not np.any(q != 0.0):
        return Panel(
            (*marks, note("no contact", "upper centre")),
            across,
            PanelAxis.of(curve.of, low=0.0, high=curve.of.scale.factor),
        )
    off_axis = q[np.abs(x) >= 0.03 * solution.pressed.radius]
    top, bottom = 1.12 * max(float(np.max(off_axis)), 0.0), 1.12 * min(float(np.min(off_axis)), 0.0)
    marks += [zero()] if bottom < 0.0 else []
    if force is not None:
        text = f"area = {'$F_N$' if pull == 0.0 else '$F_N + F_w$'}\n= {with_unit(force + pull, 'N')}"
        marks.append(Text(0.0, 0.36 * (top if q[q.size // 2] > 0.0 else bottom), text, spacing=1.5))
    return Panel(tuple(marks), across, PanelAxis.of(curve.of, low=bottom, high=top))


def pressure_panel(solution: Restorable, extent: float, mean: float | None = None, remark: str = "") -> Panel:
    """Return p(r), mirrored at the axis; an infinite pressure is cut off, with a note.

    Parameters
    ----------
    solution
        For one load.
    extent : float
        [m].
    mean : float, optional
        Mean pressure [Pa], drawn as a line.
    remark : str, optional
        Added to the note on infinite tension at the edge.
    """
    fields, pressed = surface(solution, extent), solution.pressed
    radius, singular, in_tension = pressed.radius, is_singular(pressed), has_tensile_singularity(pressed)
    r, p = series("r", fields.r), series("pressure", fields.pressure)
    finite = p.content[np.isfinite(p.content)]
    top = 1.12 * float(np.max(finite, initial=0.0))
    if singular and mean:
        top = min(top, PRESSURE_CEILING * mean)
    bottom = 1.12 * float(np.min(finite, initial=0.0))
    if in_tension:
        typical_pressure = float(np.median(np.abs(finite[fields.r[np.isfinite(p.content)] < pressed.radius])))
        top = min(top, PRESSURE_CEILING * typical_pressure)
        bottom = max(bottom, -2.0 * max(top, typical_pressure))
    scale = scale_of("Pa", [top, bottom])
    x, y = style.mirrored(r.content, p.content)
    marks: list[Any] = [Area(x, y, 0.0), Line(x, y)]
    marks += [zero()] if bottom < 0.0 else []
    if mean:
        ends = np.array([-radius, 1.06 * radius])
        marks.append(Line(ends, np.full(2, mean), style.INK, width=1.0, dash=style.DASHED))
        marks.append(Text(1.1 * ends[1], mean, f"mean\n{with_unit(mean, 'Pa')}", across="left"))
    marks += [note("no contact", "upper centre")] if radius == 0.0 else []
    if in_tension:
        marks.append(note(f"infinite tension at the edge, cut off{remark}", "lower centre"))
    elif singular:
        marks.append(note("infinite where\nthe curve leaves", "upper centre" if pressed.edge > 0.0 else "upper right"))
    end = float(np.max(x))
    upright = PanelAxis.of(p, scale, low=bottom, high=top if top > bottom else scale.factor)
    return Panel(tuple(marks), PanelAxis.of(r, low=-end, high=end), upright)


def surface_panel(fields: SurfaceFields) -> Panel:
    """Return the displacement of the surface and the distance of the surfaces, over r."""
    order = np.argsort(fields.r, kind="stable")
    r, sunk = (np.asarray(part, dtype=float)[order] for part in (fields.r, fields.displacement))
    gap = np.where(np.isfinite(fields.gap), fields.gap, np.nan)[order]
    finite_gap: Array = gap[np.isfinite(gap)]
    top = 1.6 * float(np.max(np.abs(sunk), initial=0.0)) or 1.1 * float(np.max(finite_gap, initial=0.0)) or 1.0
    is_sparse = "o" if order.size <= MOST_MARKED_POINTS else ""
    lines = (
        Line(r, sunk, marker=is_sparse, name="displacement $u_z$"),
        Line(r, gap, style.GREEN, marker=is_sparse, dash=style.DASHES[1], name="separation $h$"),
    )
    low = 1.2 * min(float(np.min(sunk, initial=0.0)), 0.0)
    upright = PanelAxis("along the axis", scale_of("m", [top]), low=low, high=top)
    return Panel(lines, PanelAxis.of(series("r", r)), upright, legend="upper right")
