"""Sheets of line contacts that stick: pressure and surfaces of one load, half-width of many."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.line.contact import across, one_strip, over
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, zero
from winkler.plot.series import places, scale_of, series
from winkler.problems.line.adhesion import LineAdhesionSolution

PULL_DRAWN = 1.5
"""Deepest tension that is drawn, over the greatest pressure or the tension in the middle."""


@sheet_of.register(LineAdhesionSolution)
def line_adhesion_sheet(item: LineAdhesionSolution, *, extent: float | None = None) -> Sheet:
    """Return pressure and surfaces of one load; of many loads the half-width over the force per length."""
    if np.ndim(item.half_width) > 0:
        return Sheet((over(item, "half_width"),), width=4.6)
    return one_strip(item, _pressure_panel, extent)


def _pressure_panel(item: LineAdhesionSolution, end: float) -> Panel:
    a = float(item.half_width)
    marks = (a, *(b for b, _ in item.problem.bed.kinks if b < end)) if a > 0.0 else ()
    x = places(end, marks, count=401)
    pressure = item.pressure(x)
    finite = np.where(np.isfinite(pressure), pressure, np.nan)
    middle = finite[x < 0.5 * a] if a > 0.0 else finite
    level = float(np.nanmax(np.abs(middle))) or 1.0
    drawn = series("pressure", np.clip(finite, -PULL_DRAWN * level, PULL_DRAWN * level))
    most = float(np.nanmax(drawn.content))
    upright = PanelAxis.of(drawn, scale_of("Pa", [level]), low=-PULL_DRAWN * level, high=1.1 * max(most, 0.0) or None)
    return Panel((zero(), Line(*style.mirrored(x, drawn.content), style.RED)), across(end), upright)
