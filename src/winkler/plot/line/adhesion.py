"""Sheets of line contacts that stick: pressure and surfaces of one load, half-width of many."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.line.contact import across, flat, mirrored, pressure_across, surface_panel
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled, zero
from winkler.plot.rough.roughness import models_panel
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.line.adhesion import LineAdhesionSolution

__all__ = ["line_adhesion_sheet"]

HALF_WIDTHS_DRAWN = 2.0
PULL_DRAWN = 1.5
"""Deepest tension that is drawn, over the greatest pressure or the tension in the middle."""


@sheet_of.register(LineAdhesionSolution)
def line_adhesion_sheet(item: LineAdhesionSolution, *, extent: float | None = None) -> Sheet:
    """Return pressure and surfaces of one load; of many loads the half-width over the force per length."""
    if np.ndim(item.half_width) > 0:
        panel = models_panel(flat(item, "force_per_length"), [(flat(item, "half_width"), "")])
        return Sheet((panel,), width=4.6)
    a = float(item.half_width)
    end = checked_extent(extent) or HALF_WIDTHS_DRAWN * a or 1.0
    title = f"{with_unit(float(item.force_per_length), 'N/m')} on a half-width of {with_unit(a, 'm')}"
    panels = titled((_pressure_panel(item, end), surface_panel(item, end)), "pressure", "distance of the surfaces")
    return Sheet(panels, height=3.1, title=title)


def _pressure_panel(item: LineAdhesionSolution, end: float) -> Panel:
    a = float(item.half_width)
    x, finite = pressure_across(item, end, 401)
    middle = finite[x < 0.5 * a] if a > 0.0 else finite
    level = float(np.nanmax(np.abs(middle))) or 1.0
    drawn = series("pressure", np.clip(finite, -PULL_DRAWN * level, PULL_DRAWN * level))
    most = float(np.nanmax(drawn.content))
    upright = PanelAxis.of(drawn, scale_of("Pa", [level]), low=-PULL_DRAWN * level, high=1.1 * max(most, 0.0) or None)
    return Panel((zero(), Line(*mirrored(x, drawn.content), style.RED)), across(end), upright)
