"""Sheets of line contacts of bodies that relax: force, half-width and pressures over time, and the pressure."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.line.contact import across, over
from winkler.plot.panel import NO_CONTACT, Area, Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.line_viscoelastic.indentation import LineViscoelasticSolution
from winkler.problems.line_viscoelastic.states import LineViscoelasticState

PLACES = 401
BESIDE = 1.15
"""Range of a picture over the half-width."""
STATES_DRAWN = 4
CEILING = 3.0
"""Greatest drawn pressure over the mean one where it is infinite."""


@sheet_of.register(LineViscoelasticSolution)
def line_viscoelastic_sheet(item: LineViscoelasticSolution, *, extent: float | None = None) -> Sheet:
    """Return force, half-width and pressures over time, and the distribution of the pressure at some moments."""
    panels = [over(item, name, "time") for name in ("force_per_length", "half_width")]
    names = ["force per length", "half-width"]
    chosen = _chosen(item)
    if chosen:
        end = checked_extent(extent) or BESIDE * max(state.half_width for state in chosen)
        panels.append(_pressures(chosen, end))
        names.append("pressure")
    else:
        panels.append(NO_CONTACT.plus(bare=True))
        names.append("no contact")
    return Sheet(titled(tuple(panels), *names), 3, width=3.9)


@sheet_of.register(LineViscoelasticState)
def line_viscoelastic_state_sheet(item: LineViscoelasticState, *, extent: float | None = None) -> Sheet:
    """Return the pressure at one moment."""
    if item.half_width == 0.0:
        return Sheet((NO_CONTACT.plus(title="no contact", bare=True),))
    end = checked_extent(extent) or BESIDE * item.half_width
    press, when = with_unit(item.force_per_length, "N/m"), with_unit(item.time, "s")
    return Sheet((_pressures([item], end),), height=3.1, title=f"pressed by {press} at {when}")


def _chosen(item: LineViscoelasticSolution) -> list[LineViscoelasticState]:
    """Return states with a contact, evenly spaced along the path, the widest among them."""
    touching = np.flatnonzero(item.half_width > 0.0)
    if not touching.size:
        return []
    wanted = touching[np.linspace(0, touching.size - 1, min(STATES_DRAWN, touching.size)).round().astype(int)]
    widest = int(np.argmax(item.half_width))
    return [item.states[index] for index in sorted({*wanted.tolist(), widest})]


def _pressures(states: list[LineViscoelasticState], end: float) -> Panel:
    x = np.linspace(-end, end, PLACES)
    pressures = [state.pressure(x) for state in states]
    usual = CEILING * max(state.mean_pressure for state in states)
    seen = [np.where(np.isfinite(pressure) & (pressure <= usual), pressure, np.nan) for pressure in pressures]
    marks: list[Line | Area] = [
        Line(x, pressure, colour, name=with_unit(state.time, "s") if len(states) > 1 else "")
        for colour, state, pressure in zip(style.CYCLE, states, seen, strict=False)
    ]
    if len(states) == 1:
        marks.append(Area(x, seen[0], 0.0, style.CYCLE[0], 0.12))
    most = float(np.nanmax([np.nanmax(pressure) for pressure in seen]))
    upright = PanelAxis.of(series("pressure", pressures[0]), scale_of("Pa", [most]), low=0.0, high=1.4 * most)
    return Panel(tuple(marks), across(end), upright, legend="upper right" if len(states) > 1 else "")
