"""Sheets of poroelastic contacts held at a constant depth: the force over time."""

from __future__ import annotations

import dataclasses

from winkler.plot import style
from winkler.plot.curves import answered, curves_panel, decades_around
from winkler.plot.dispatch import without_extent
from winkler.plot.marks import Rule
from winkler.plot.panel import Sheet
from winkler.plot.series import series, with_unit
from winkler.problems.poroelastic.held import PoroelasticSolution

POINTS = 121
FACTOR_AROUND = 100.0
"""Range drawn around a single time, as a factor."""


@without_extent(PoroelasticSolution)
def poroelastic_sheet(item: PoroelasticSolution) -> Sheet:
    """Return the force over time, requested times marked, with the forces at first and at last."""
    along = series("time", decades_around(item.time, FACTOR_AROUND, POINTS))
    curve = dataclasses.replace(item.problem, time=along.content).solve()
    panel = curves_panel(along, [answered(curve, item, "time", "force")])
    limits = tuple(Rule(force, colour=style.MUTED, dash=(4.0, 2.0)) for force in (item.first_force, item.last_force))
    title = f"$a$ = {with_unit(item.radius, 'm')}   $a^2/D$ = {with_unit(item.relaxation_time, 's')}"
    return Sheet((dataclasses.replace(panel, marks=(*panel.marks, *limits)),), width=4.6, height=3.3, title=title)
