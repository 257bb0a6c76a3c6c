"""Sheets of viscoelastic contacts: along a path, at one time of it, and in an impact."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import energies_panel, loop_panel
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.series import headline, series_of, with_unit
from winkler.plot.viscoelastic.springs import pressure_panel, recovering_panel
from winkler.problems.viscoelastic.impact import ViscoelasticImpactSolution
from winkler.problems.viscoelastic.indentation import ViscoelasticSolution
from winkler.problems.viscoelastic.states import ViscoelasticState

LEAST_FORCE_SHARE = 0.1
"""The last contact under at least this part of the greatest force is drawn."""


@without_extent(ViscoelasticSolution)
def path_sheet(item: ViscoelasticSolution) -> Sheet:
    """Return the loop, force, depth and contact over time, energies; below springs and pressure of a late contact."""
    state = _late_state(item)
    time = series_of(item, "time")
    force = series_of(item, "force")
    panels = (
        loop_panel(series_of(item, "depth"), force, float(item.dissipation[-1])),
        curves_panel(time, [(force, "")], label="force $F_N$"),
        depth_and_radius(item),
        energies_panel(item, {"dissipation": "lost", "stored_energy": "stored"}, height_factor=1.2),
        recovering_panel(state, item.problem.bed),
        pressure_panel(state),
    )
    when = f" at {with_unit(state.time, 's', 3)}"
    titles = ("force over depth", "force", "depth and contact", "energy", f"springs{when}", f"pressure{when}")
    return Sheet(titled(panels, *titles), 3, width=3.9)


def _late_state(item: ViscoelasticSolution) -> ViscoelasticState:
    """Return the last state under at least `LEAST_FORCE_SHARE` of the greatest force, by marching again."""
    bearing = np.flatnonzero(item.force >= LEAST_FORCE_SHARE * np.max(item.force))
    last = int(bearing[-1]) if bearing.size else 0
    return next(itertools.islice(item.problem.steps(), last, None))


def depth_and_radius(item: Any) -> Panel:
    """Return the depth, and on a second axis the contact radius, over time."""
    time, depth, radius = (series_of(item, name) for name in ("time", "depth", "radius"))
    sides: dict[str, Any] = {"low": 0.0, "high": 1.08 * float(np.max(depth.content))}
    if np.min(depth.content) < 0.0:
        sides = {"margin": 0.08}
    return Panel(
        (
            Line(time.content, depth.content),
            Line(time.content, radius.content, style.RED, dash=style.DASHES[1], beside=True),
        ),
        PanelAxis.of(time, margin=0.0),
        PanelAxis.of(depth, colour=style.BLUE, **sides),
        beside=(PanelAxis.of(radius, low=0.0, colour=style.RED),),
    )


@without_extent(ViscoelasticState)
def state_sheet(item: ViscoelasticState) -> Sheet:
    """Return the springs at one time, including those that recover, and the pressure."""
    title = headline(item, "time", "force", "depth", "radius")
    panels = titled((recovering_panel(item), pressure_panel(item)), "springs", "pressure $p(r)$")
    return Sheet(panels, height=3.3, title=title)


@without_extent(ViscoelasticImpactSolution)
def impact_sheet(item: ViscoelasticImpactSolution) -> Sheet:
    """Return force over depth and over time, velocity, depth and contact of an impact."""
    time = series_of(item, "time")
    force = series_of(item, "force")
    panels = (
        loop_panel(series_of(item, "depth"), force, float(item.dissipation)),
        curves_panel(time, [(force, "")], label="force $F_N$"),
        curves_panel(time, [(series_of(item, "velocity"), "")], label="velocity of approach $v$"),
        depth_and_radius(item),
    )
    title = f"restitution $e$ = {item.restitution:.4g}   contact for {with_unit(item.duration, 's')}"
    titles = ("force over depth", "force", "velocity", "depth and contact")
    return Sheet(titled(panels, *titles), 2, height=3.1, title=title)
