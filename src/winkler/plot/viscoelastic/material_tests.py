"""Sheets of tests of viscoelastic bodies: after a step of force or depth, and under a small oscillation."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.decades import Line, draw_decades
from winkler.plot.draw import draw
from winkler.plot.series import series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.problems.viscoelastic.material_tests import CreepTest, HarmonicSolution, StepSolution

if TYPE_CHECKING:
    from winkler.plot.picture import Picture

__all__ = ["harmonic_sheet", "step_sheet"]

POINTS = 121
AROUND = 100.0
"""One moment, or one frequency, is shown within so many times more and less."""
TITLES = {"depth": "the body sinks", "radius": "the contact widens", "force": "the force falls"}


@draw.register(StepSolution)
def step_sheet(item: StepSolution, *, extent: float | None = None) -> Picture:
    """Return how a body sinks under a force that stays, or how the force falls at a depth that stays."""
    refuse_extent(item, extent)
    names = ("depth", "radius") if isinstance(item.problem, CreepTest) else ("force",)
    asked = np.asarray(item.time)
    along = series("StepSolution", "time", _between(asked))
    curve = dataclasses.replace(item.problem, time=along.content).solve()
    with style.styled():
        figure = style.figure(len(names), width=4.6, height=3.3)
        panels = np.atleast_1d(figure.subplots(1, len(names)))
        for axes, name in zip(panels, names, strict=True):
            of = series("StepSolution", name, getattr(curve, name))
            draw_decades(axes, along, [Line(of, points=(asked, np.asarray(getattr(item, name))))])
            axes.set_title(TITLES[name])
    return figure


@draw.register(HarmonicSolution)
def harmonic_sheet(item: HarmonicSolution, *, extent: float | None = None) -> Picture:
    """Return storage and loss stiffness over the frequency, and the tangent of loss; what was asked as points."""
    refuse_extent(item, extent)
    asked = np.ravel(np.asarray(item.problem.angular_frequency, dtype=float))
    along = series("HarmonicIndentation", "angular_frequency", _between(asked))
    curve = dataclasses.replace(item.problem, angular_frequency=along.content).solve()

    def line(name: str, label: str = "") -> Line:
        points = (asked, np.ravel(np.asarray(getattr(item, name), dtype=float)))
        return Line(series("HarmonicSolution", name, np.asarray(getattr(curve, name))), label, points)

    with style.styled():
        figure = style.figure(2, width=4.6, height=3.3)
        left, right = figure.subplots(1, 2)
        pair = [line("storage_stiffness", "storage $k'$"), line("loss_stiffness", "loss $k''$")]
        draw_decades(left, along, pair, "stiffness")
        draw_decades(right, along, [line("loss_tangent")])
        left.set_title("storage and loss stiffness")
        right.set_title("loss over storage")
        figure.suptitle(f"about $d$ = {told(item.depth, 'm')}   $a$ = {told(item.radius, 'm')}")
    return figure


def _between(asked: Array) -> Array:
    """Return numbers across the decades that were asked about, or around the only one."""
    low, high = float(np.min(asked)), float(np.max(asked))
    if high <= low * (1.0 + 1e-12):
        low, high = low / AROUND, high * AROUND
    return np.geomspace(low, high, POINTS)
