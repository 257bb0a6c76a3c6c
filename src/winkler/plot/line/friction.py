"""Sheets of sheared line contacts: loop, traction and slip along a path, and the stress below one state of it."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import sheet_of, without_extent
from winkler.plot.extent import checked_extent
from winkler.plot.friction.curves import loop_panel, mirrored_bounds
from winkler.plot.line.contact import across
from winkler.plot.normal.stresses import stress_map
from winkler.plot.panel import NO_CONTACT, Area, Band, Line, Panel, PanelAxis, Rule, Sheet, note, titled, zero
from winkler.plot.series import places, scale_of, series, with_unit
from winkler.problems.line_friction.marched_states import LineMarchedState
from winkler.problems.line_friction.states import LineTangentialState
from winkler.problems.line_friction.tangential import LineTangentialSolution
from winkler.values.errors import OutsideValidity

ACROSS, DOWN = 81, 41
"""Places of a map of stresses."""
WIDTHS_DRAWN, STRESS_WIDTHS_DRAWN = 1.25, 2.0
CEILING = 3.0
"""Greatest drawn traction over mu times the mean pressure where it is infinite."""
DEEPEST_SURFACE = 1e-6
"""Depth of the uppermost row of a map, over the half-width: beside a sharp edge the surface itself has no number."""


@without_extent(LineTangentialSolution)
def line_tangential_sheet(item: LineTangentialSolution) -> Sheet:
    """Return the loop of the shear force, and traction and slip of the last contact of the path."""
    shift, force = (
        series(name, getattr(item, name), LineTangentialSolution) for name in ("slip_shift", "shear_force_per_length")
    )
    loop = loop_panel(shift, force).plus(note(_lost(item), "upper left"))
    touching = np.flatnonzero(item.half_width > 0.0)
    if not touching.size:
        return Sheet(titled((loop, NO_CONTACT), "shear force over the shift by slip", "no contact"))
    last = item.states[int(touching[-1])]
    when = "" if last is item.states[-1] else " (last contact)"
    panels = (loop, _traction_panel(last, WIDTHS_DRAWN * last.half_width), _slip_panel(last))
    names = "shear force over the shift by slip", f"traction{when}", f"slip{when}"
    return Sheet(titled(panels, *names), 3, width=3.9)


@sheet_of.register(LineTangentialState)
@sheet_of.register(LineMarchedState)
def line_tangential_state_sheet(item: LineTangentialState | LineMarchedState, *, extent: float | None = None) -> Sheet:
    """Return traction, slip and, in a body that deforms, the stress below the surface of one state."""
    extent = checked_extent(extent)
    a = item.half_width
    if a == 0.0:
        return Sheet((NO_CONTACT.plus(title="no contact", bare=True),))
    panels = [_traction_panel(item, extent or WIDTHS_DRAWN * a), _slip_panel(item)]
    names = ["traction", "slip"]
    try:
        panels.append(_stress_panel(item, extent or STRESS_WIDTHS_DRAWN * a))
        names.append("stress below the surface")
    except OutsideValidity:  # neither body has stresses that are known: the other panels stand
        pass
    pull, press = with_unit(item.shear_force_per_length, "N/m"), with_unit(item.force_per_length, "N/m")
    return Sheet(titled(panels, *names), len(panels), width=4.2, title=f"pressed by {press}, sheared by {pull}")


def _lost(item: LineTangentialSolution) -> str:
    lost = float(item.dissipation_per_length[-1])
    return f"lost along the path: {with_unit(lost, 'J/m')}" if lost > 0.0 else "nothing lost"


def _stuck(item: LineTangentialState | LineMarchedState) -> list[Any]:
    c, middle = item.stick_half_width, item.stick_middle
    return [Band(middle - c, middle + c, name="stick")] if c > 0.0 else []


def _places(item: LineTangentialState | LineMarchedState, end: float) -> Array:
    """Return places on either side, dense at the edges of all strips."""
    if isinstance(item, LineMarchedState):
        strips: list[tuple[float, float]] = [(item.stick_middle, item.stick_half_width)]
    else:
        strips = [(strip.middle, strip.half_width) for strip in item.strips]
    edges = [abs(middle + side * half_width) for middle, half_width in strips for side in (-1.0, 1.0)]
    marks = tuple(sorted({edge for edge in (*edges, item.half_width) if 0.0 < edge < end}))
    x = places(end, marks, count=240)
    return np.unique(np.concatenate([-x, x]))


def _traction_panel(item: LineTangentialState | LineMarchedState, end: float) -> Panel:
    x = _places(item, end)
    mu = item.law.coefficient
    bound, rubbed = mu * item.pressure(x), item.traction(x)
    usual = CEILING * mu * item.force_per_length / (2.0 * item.half_width)
    seen = [np.where(np.isfinite(row) & (np.abs(row) <= usual), row, np.nan) for row in (bound, rubbed)]
    top = float(np.nanmax(np.abs(seen)))
    right = x >= 0.0
    marks = (
        *_stuck(item),
        *mirrored_bounds(x[right], seen[0][right], r"$\pm\mu p$"),
        Line(x, seen[1], style.RED, name="$q$"),
        Area(x, seen[1], 0.0, style.RED, 0.12),
        zero(),
    )
    low = -top if float(np.nanmin(seen[1])) < 0.0 else 0.0
    of, scale = series("traction", rubbed), scale_of("Pa", [top])
    upright = PanelAxis.of(of, scale, low=1.15 * low, high=1.45 * top if top > 0.0 else scale.factor)
    return Panel(marks, across(end), upright, legend="upper right")


def _slip_panel(item: LineTangentialState | LineMarchedState) -> Panel:
    end = WIDTHS_DRAWN * item.half_width
    x = _places(item, item.half_width)
    ahead = series("slip", item.slip(x))
    edges = (Rule(side * item.half_width, upright=True, width=0.9, dash=style.DOTTED) for side in (-1.0, 1.0))
    marks = (*_stuck(item), Line(x, ahead.content, style.BLUE, name="second body ahead"), *edges, zero())
    upright = PanelAxis("slip", scale_of("m", ahead.content), margin=0.08, headroom=0.35)
    return Panel(marks, across(end), upright, legend="upper center")


def _stress_panel(item: LineTangentialState | LineMarchedState, end: float) -> Panel:
    x, z = np.linspace(-end, end, ACROSS), end * np.linspace(0.0, 1.0, DOWN) ** 1.6
    fields = item.stresses(x[:, None], z[None, :] + DEEPEST_SURFACE * item.half_width)
    along, down = np.broadcast_arrays(x[:, None], z[None, :])
    return stress_map(series("x", along), series("z", down), series("von_mises", fields.von_mises), "$x$")
