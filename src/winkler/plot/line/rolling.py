"""Sheets of rolling line contacts: creep curve and traction of Carter."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.loading import LineShearForce
from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Rule, Sheet, note, points, titled
from winkler.plot.series import scale_of, series
from winkler.problems.line_rolling.steady import LineRollingSolution, sliding_creepage
from winkler.problems.rolling.creepage import Creepage

__all__ = ["line_rolling_sheet"]

POINTS = 121
BEYOND_SLIDING = 1.35
"""Range of a creep curve relative to the creepage at full sliding."""
PLACES = 401


@sheet_of.register(LineRollingSolution)
def line_rolling_sheet(item: LineRollingSolution, *, extent: float | None = None) -> Sheet:
    """Return the force over the creepage, and the traction of the greatest force."""
    a = float(item.contact.half_width)
    one = _strongest(item)
    end = checked_extent(extent) or 1.1 * a
    panels = titled((_creep_panel(item), _traction_panel(one, end)), "creep force", "traction, rolling to the right")
    return Sheet(panels, height=3.1)


def _strongest(item: LineRollingSolution) -> LineRollingSolution:
    """Return the solution of the one drive with the greatest force."""
    if np.ndim(item.stick_share) == 0:
        return item
    index = int(np.argmax(np.abs(item.shear_force_per_length)))
    if isinstance(item.problem.drive, LineShearForce):
        drive: LineShearForce | Creepage = LineShearForce(float(np.ravel(item.shear_force_per_length)[index]))
    else:
        drive = Creepage(longitudinal=float(np.ravel(item.longitudinal_creepage)[index]))
    return dataclasses.replace(item.problem, drive=drive).solve()


def _creep_panel(item: LineRollingSolution) -> Panel:
    creepage = np.ravel(np.asarray(item.longitudinal_creepage, dtype=float))
    ratio = np.ravel(np.asarray(item.traction_ratio)) * np.sign(creepage)
    limit = sliding_creepage(item.contact, item.problem.friction.coefficient)
    most = max(BEYOND_SLIDING * limit, float(np.max(np.abs(creepage))))
    along = np.linspace(-most if np.min(creepage) < 0.0 else 0.0, most, POINTS)
    curve = dataclasses.replace(item.problem, drive=Creepage(longitudinal=along)).solve()
    forces = np.asarray(curve.traction_ratio) * np.sign(along)
    of = series("longitudinal_creepage", along, LineRollingSolution)
    across = PanelAxis.of(of)
    marks = (
        Line(along, forces, style.BLUE),
        points(creepage, ratio, style.RED),
        Rule(1.0, width=0.9, dash=style.DOTTED),
    )
    return Panel(marks, across, PanelAxis(r"force $Q/(\mu P)$", margin=0.1))


def _traction_panel(one: LineRollingSolution, end: float) -> Panel:
    a, c = float(one.contact.half_width), float(one.stick_share) * float(one.contact.half_width)
    x = np.unique(np.concatenate([np.linspace(-end, end, PLACES), [-a, a, a - 2.0 * c]]))
    sign = np.sign(float(one.shear_force_per_length)) or 1.0
    bound = sign * one.problem.friction.coefficient * one.contact.pressure(x)
    traction = one.traction(x)
    sticks = (x >= a - 2.0 * c) & (x <= a)
    marks = [
        Line(x, bound, style.MUTED, dash=style.DASHES[1], name=r"$\mu p$"),
        Line(x, traction, style.RED, name="$q$"),
        Area(x, np.where(sticks, traction, np.nan), 0.0, alpha=0.15),
    ]
    marks += [note("shaded: sticks")] if c > 0.0 else []
    upright = PanelAxis.of(series("traction", traction), scale_of("Pa", bound), margin=0.1)
    return Panel(tuple(marks), PanelAxis("$x$", scale_of("m", [end]), low=-end, high=end), upright, legend="upper left")
