"""Sheets of wavy half-planes: pressure and surfaces of one load over two pitches, share and pressures of many."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.line.contact import across, distance_panel, over, pressure_axis, pressures_over
from winkler.plot.panel import Line, Panel, Sheet, titled
from winkler.plot.series import with_unit
from winkler.problems.line_strips.periodic import PeriodicSolution

PLACES = 481


@sheet_of.register(PeriodicSolution)
def periodic_sheet(item: PeriodicSolution, *, extent: float | None = None) -> Sheet:
    """Return pressure and surfaces of one load; of many loads the contact's share and the pressures."""
    if np.ndim(item.half_width) > 0:
        along = "nominal_pressure"
        pressures = pressures_over(item, along, "mean of the strips")
        return Sheet(titled((over(item, "contact_share", along), pressures), "contact", "pressure"))
    end = checked_extent(extent) or item.problem.pitch
    x = np.linspace(-end, end, PLACES)
    share = f"{100.0 * float(item.contact_share):.3g} % of the surface in contact"
    title = f"{with_unit(float(item.nominal_pressure), 'Pa')}, {share}"
    panels = titled((_pressure_panel(item, x), _surface_panel(item, x)), "pressure", "distance of the surfaces")
    return Sheet(panels, height=3.1, title=title)


def _pressure_panel(item: PeriodicSolution, x: np.ndarray) -> Panel:
    finite, upright = pressure_axis(item.pressure(x))
    even = np.full(2, float(item.nominal_pressure))
    nominal = Line(x[[0, -1]], even, style.MUTED, dash=style.DASHES[1], name="nominal")
    return Panel((nominal, Line(x, finite, style.RED)), across(float(x[-1])), upright, legend="upper right")


def _surface_panel(item: PeriodicSolution, x: np.ndarray) -> Panel:
    pitch = item.problem.pitch
    place = np.abs(x - pitch * np.round(x / pitch))
    before = np.asarray(item.problem.bed.profile.height(place), dtype=float)
    return distance_panel(x, before, item.separation(x), across(float(x[-1])), legend="upper right")
