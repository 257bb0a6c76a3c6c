"""Sheets of tests of viscoelastic bodies: after a step of force or depth, and under a small oscillation."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.plot.curves import Quantity, answered, curves_panel, decades_around
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Sheet, titled
from winkler.plot.series import series, with_unit
from winkler.problems.viscoelastic.material_tests import CreepTest, StepSolution
from winkler.problems.viscoelastic.oscillation import HarmonicSolution

POINTS = 121
FACTOR_AROUND = 100.0
"""Range drawn around a single time or frequency, as a factor."""
PANEL_TITLES = {"depth": "depth over time", "radius": "contact radius over time", "force": "force over time"}


@without_extent(StepSolution)
def step_sheet(item: StepSolution) -> Sheet:
    """Return depth and contact radius under a constant force, or the force at a constant depth."""
    names = ("depth", "radius") if isinstance(item.problem, CreepTest) else ("force",)
    along = series("time", decades_around(item.time, FACTOR_AROUND, POINTS))
    curve = dataclasses.replace(item.problem, time=along.content).solve()
    panels = []
    for name in names:
        panels.append(curves_panel(along, [answered(curve, item, "time", name)]).plus(title=PANEL_TITLES[name]))
    return Sheet(tuple(panels), width=4.6, height=3.3)


@without_extent(HarmonicSolution)
def harmonic_sheet(item: HarmonicSolution) -> Sheet:
    """Return storage and loss stiffness over the frequency, and the tangent of loss; requested points marked."""
    requested = np.ravel(np.asarray(item.problem.angular_frequency, dtype=float))
    along = series("angular_frequency", decades_around(requested, FACTOR_AROUND, POINTS))
    curve = dataclasses.replace(item.problem, angular_frequency=along.content).solve()

    def quantity(name: str, label: str = "") -> Quantity:
        points = (requested, np.ravel(np.asarray(getattr(item, name), dtype=float)))
        return Quantity(series(name, np.asarray(getattr(curve, name)), HarmonicSolution), label, points)

    pair = [quantity("storage_stiffness", "storage $k'$"), quantity("loss_stiffness", "loss $k''$")]
    panels = curves_panel(along, pair, label="stiffness"), curves_panel(along, [quantity("loss_tangent")])
    title = f"about $d$ = {with_unit(item.depth, 'm')}   $a$ = {with_unit(item.radius, 'm')}"
    return Sheet(titled(panels, "storage and loss stiffness", "loss over storage"), width=4.6, height=3.3, title=title)
