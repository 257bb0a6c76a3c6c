"""Sheets of rollers of finite length: pressures of one load on the contact and along the roller; curves of many."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.axis import edges_of
from winkler.plot.dispatch import without_extent
from winkler.plot.line.contact import over, pressures_over
from winkler.plot.panel import Line, Map, Panel, PanelAxis, Rule, Sheet, note, titled
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.rollers.roller_contact import RollerSolution
from winkler.problems.rollers.roller_state import RollerState

FEWEST_LOADS = 2
SHARP_ROOM = 1.8
"""What is drawn of a pressure that is infinite at a sharp end, over the median along the roller."""


@without_extent(RollerSolution)
def roller_sheet(item: RollerSolution) -> Sheet:
    """Return the pressure on the contact and along the roller; for many loads also depth, pressures and moment."""
    state = item.last
    panels = [*titled((_map_panel(item), _along_panel(item), _loads_panel(item)), *TITLES)]
    if np.size(item.force) >= FEWEST_LOADS:
        curves = over(item, "depth", "force"), pressures_over(item, "force", "middle", "middle_pressure")
        panels += titled(curves, "depth", "pressures")
    return Sheet(tuple(panels), 3, width=4.2, height=3.1, title=_headline(state))


TITLES = ("pressure on the contact", "pressure along the roller", "force per length")


def _headline(state: RollerState) -> str:
    parts = [f"{with_unit(state.force, 'N')} at a depth of {with_unit(state.depth, 'm')}"]
    if state.tilt != 0.0:
        parts.append(f"tilt {state.tilt * 1e3:.3g} mrad, moment {with_unit(state.moment, 'N m', 3)}")
    if math.isfinite(state.edge_factor):
        parts.append(f"greatest pressure {state.edge_factor:.3g} times that in the middle")
    return ";  ".join(parts)


def _limit(item: RollerSolution) -> float:
    """Return the greatest pressure that is drawn [Pa]."""
    state = item.last
    if math.isfinite(state.peak_pressure):
        return state.peak_pressure
    return SHARP_ROOM * float(np.median(state.pressure_along[state.pressure_along > 0.0]))


def _length_axis(item: RollerSolution) -> PanelAxis:
    half = 0.5 * item.problem.length
    return PanelAxis("place along the roller $x$", scale_of("m", [half]), low=-1.02 * half, high=1.02 * half)


def _map_panel(item: RollerSolution) -> Panel:
    state, limit = item.last, _limit(item)
    pressure = series("pressure", np.where(state.pressure > 0.0, state.pressure, np.nan))
    bar = PanelAxis.of(pressure, scale_of("Pa", [limit]), low=0.0, high=limit)
    look: dict[str, Any] = {"extend": "neither" if math.isfinite(state.peak_pressure) else "max", "place": "inset"}
    image = Map(state.edges, edges_of(state.y), pressure.content.T, bar, kind="cells", **look)
    y = PanelAxis("across $y$", scale_of("m", state.y))
    return Panel((image,), _length_axis(item), y, grid="")


def _along_panel(item: RollerSolution) -> Panel:
    state, limit = item.last, _limit(item)
    along = series("pressure", state.pressure_along)
    upright = PanelAxis.of(along, scale_of("Pa", [limit]), low=0.0, high=1.1 * limit)
    mean = item.last.force / item.problem.length
    hertz = math.sqrt(mean * item.problem.medium.modulus / (math.pi * item.problem.radius))
    marks: tuple[Any, ...] = (
        Line(state.x, along.content, style.RED, name="roller"),
        Rule(hertz, colour=style.MUTED, dash=style.DASHES[1], name="endless, even"),
    )
    panel = Panel(marks, _length_axis(item), upright, legend="lower center")
    return (
        panel if math.isfinite(state.peak_pressure) else panel.plus(note("infinite at the sharp end", "upper centre"))
    )


def _loads_panel(item: RollerSolution) -> Panel:
    state = item.last
    load = series("force_per_length", state.force_per_length)
    sharp = not math.isfinite(state.peak_pressure)
    loaded = state.force_per_length[state.force_per_length > 0.0]
    most = SHARP_ROOM * float(np.median(loaded)) if sharp else float(np.max(loaded))
    upright = PanelAxis.of(load, scale_of("N/m", [most]), low=0.0, high=1.1 * most)
    return Panel((Line(state.x, load.content, style.BLUE),), _length_axis(item), upright)
