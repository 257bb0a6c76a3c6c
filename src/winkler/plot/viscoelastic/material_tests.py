"""Sheets of tests of viscoelastic bodies: after a step of force or depth, and under a small oscillation."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.numerics.types import Array
from winkler.plot.decades import Quantity, decades_panel
from winkler.plot.drawing import sheet_of
from winkler.plot.panel import Sheet, titled
from winkler.plot.series import series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.problems.viscoelastic.material_tests import CreepTest, HarmonicSolution, StepSolution

__all__ = ["harmonic_sheet", "step_sheet"]

POINTS = 121
AROUND = 100.0
"""One moment, or one frequency, is shown within so many times more and less."""
TITLES = {"depth": "the body sinks", "radius": "the contact widens", "force": "the force falls"}


@sheet_of.register(StepSolution)
def step_sheet(item: StepSolution, *, extent: float | None = None) -> Sheet:
    """Return how a body sinks under a force that stays, or how the force falls at a depth that stays."""
    refuse_extent(item, extent)
    names = ("depth", "radius") if isinstance(item.problem, CreepTest) else ("force",)
    asked = np.asarray(item.time)
    along = series("time", _between(asked))
    curve = dataclasses.replace(item.problem, time=along.content).solve()
    panels = []
    for name in names:
        of = series(name, getattr(curve, name))
        panel = decades_panel(along, [Quantity(of, points=(asked, np.asarray(getattr(item, name))))])
        panels.append(panel.plus(title=TITLES[name]))
    return Sheet(tuple(panels), width=4.6, height=3.3)


@sheet_of.register(HarmonicSolution)
def harmonic_sheet(item: HarmonicSolution, *, extent: float | None = None) -> Sheet:
    """Return storage and loss stiffness over the frequency, and the tangent of loss; what was asked as points."""
    refuse_extent(item, extent)
    asked = np.ravel(np.asarray(item.problem.angular_frequency, dtype=float))
    along = series("angular_frequency", _between(asked))
    curve = dataclasses.replace(item.problem, angular_frequency=along.content).solve()

    def quantity(name: str, label: str = "") -> Quantity:
        points = (asked, np.ravel(np.asarray(getattr(item, name), dtype=float)))
        return Quantity(series(name, np.asarray(getattr(curve, name)), HarmonicSolution), label, points)

    pair = [quantity("storage_stiffness", "storage $k'$"), quantity("loss_stiffness", "loss $k''$")]
    panels = decades_panel(along, pair, "stiffness"), decades_panel(along, [quantity("loss_tangent")])
    title = f"about $d$ = {told(item.depth, 'm')}   $a$ = {told(item.radius, 'm')}"
    return Sheet(titled(panels, "storage and loss stiffness", "loss over storage"), width=4.6, height=3.3, title=title)


def _between(asked: Array) -> Array:
    """Return numbers across the decades that were asked about, or around the only one."""
    low, high = float(np.min(asked)), float(np.max(asked))
    if high <= low * (1.0 + 1e-12):
        low, high = low / AROUND, high * AROUND
    return np.geomspace(low, high, POINTS)
