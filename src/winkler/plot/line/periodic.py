"""Sheets of wavy half-planes: pressure and surfaces of one load over two pitches, share and pressures of many."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.line.contact import across, flat
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.rough.roughness import models_panel
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.line_strips.periodic import PeriodicSolution

__all__ = ["periodic_sheet"]

PLACES = 481


@sheet_of.register(PeriodicSolution)
def periodic_sheet(item: PeriodicSolution, *, extent: float | None = None) -> Sheet:
    """Return pressure and surfaces of one load; of many loads the contact's share and the pressures."""
    if np.ndim(item.half_width) > 0:
        along = flat(item, "nominal_pressure")
        pressures = [(flat(item, "mean_pressure"), "mean of the strips")]
        if np.isfinite(item.peak_pressure).all():
            pressures.insert(0, (flat(item, "peak_pressure"), "greatest"))
        shares = models_panel(along, [(flat(item, "contact_share"), "")])
        return Sheet(titled((shares, models_panel(along, pressures, label="pressure")), "contact", "pressure"))
    end = checked_extent(extent) or item.problem.pitch
    x = np.linspace(-end, end, PLACES)
    share = f"{100.0 * float(item.contact_share):.3g} % of the surface in contact"
    title = f"{with_unit(float(item.nominal_pressure), 'Pa')}, {share}"
    panels = titled((_pressure_panel(item, x), _surface_panel(item, x)), "pressure", "distance of the surfaces")
    return Sheet(panels, height=3.1, title=title)


def _pressure_panel(item: PeriodicSolution, x: np.ndarray) -> Panel:
    pressure = item.pressure(x)
    finite = np.where(np.isfinite(pressure), pressure, np.nan)
    most = float(np.nanmax(finite))
    drawn = series("pressure", finite)
    upright = PanelAxis.of(drawn, scale_of("Pa", [most]), low=0.0, high=1.1 * most if most > 0.0 else None)
    even = np.full(2, float(item.nominal_pressure))
    nominal = Line(x[[0, -1]], even, style.MUTED, dash=style.DASHES[1], name="nominal")
    return Panel((nominal, Line(x, finite, style.RED)), across(float(x[-1])), upright, legend="upper right")


def _surface_panel(item: PeriodicSolution, x: np.ndarray) -> Panel:
    pitch = item.problem.pitch
    place = np.abs(x - pitch * np.round(x / pitch))
    before = series("separation", np.asarray(item.problem.bed.profile.height(place), dtype=float))
    most = float(np.max(before.content))
    upright = PanelAxis.of(before, scale_of("m", [most or 1.0]), low=0.0, high=1.05 * most if most > 0.0 else None)
    marks = (
        Line(x, before.content, style.MUTED, dash=style.DASHES[1], name="before"),
        Line(x, item.separation(x), style.BLUE, name="pressed"),
    )
    return Panel(marks, across(float(x[-1])), upright, legend="upper right")
