"""Sheets of measured holds of several contact radii: forces with a poroelastic body, and times over the radius."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.holds.held_contacts import HeldContactsSolution
from winkler.fitting.holds.held_force import HeldForce
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, points, titled
from winkler.plot.series import Series, with_unit
from winkler.problems.poroelastic.held import PoroelasticRelaxation
from winkler.values.vocabulary import Word

POINTS = 121
DEVIATIONS = 1.96
"""Half-width of an interval of 95 % in standard errors."""


@without_extent(HeldContactsSolution)
def holds_sheet(item: HeldContactsSolution) -> Sheet:
    """Return the forces over those at first, with the fitted body, and the shifts with both laws."""
    holds = sorted(item.problem.holds, key=lambda hold: hold.radius)
    return Sheet(
        titled((_forces(item, holds), _shifts(item)), "holds, and the poroelastic body", "times over the radius"),
        width=4.6,
        height=3.3,
    )


def _forces(item: HeldContactsSolution, holds: list[HeldForce]) -> Panel:
    marks: list[Line] = []
    for place, hold in enumerate(holds):
        colour = style.CYCLE[place % len(style.CYCLE)]
        first = item.shear * hold.unit_force
        at = np.geomspace(hold.time[0], hold.time[-1], POINTS)
        body = PoroelasticRelaxation(
            hold.profile, item.shear, item.poisson, item.diffusivity, depth=hold.depth, time=at
        ).solve()
        marks.append(
            points(hold.time, hold.force / first, colour, size=2.5, name=f"$a$ = {with_unit(hold.radius, 'm')}")
        )
        marks.append(Line(at, body.force / first, colour, width=1.0))
    time = np.concatenate([hold.time for hold in holds])
    share = np.concatenate([hold.force / (item.shear * hold.unit_force) for hold in holds])
    return Panel(
        tuple(marks),
        PanelAxis.of(Series("time", Word("t", "s", "time since the depth was reached"), time), log=True, plain=True),
        PanelAxis.of(Series("share", Word("F_N/F_0", "", "force over that at first"), share), margin=0.08),
        legend="best",
    )


def _shifts(item: HeldContactsSolution) -> Panel:
    radius, logarithm = item.radius, np.log(item.shift_factor)
    factor = item.shift_factor
    error = np.vstack(
        [factor - np.exp(logarithm - DEVIATIONS * item.shift_error), np.exp(logarithm + DEVIATIONS * item.shift_error)]
    )
    error[1] -= factor
    ends = np.geomspace(radius[0], radius[-1], POINTS)
    marks = [
        Line(ends, (ends / radius[0]) ** power, colour, width=1.2, dash=dash, name=name)
        for power, colour, dash, name in (
            (2.0, style.BLUE, (), "liquid"),
            (0.0, style.ORANGE, (4.0, 2.0), "viscoelastic"),
        )
    ]
    marks.append(points(radius, factor, style.RED, size=4.0, width=1.0, dash=(), error_y=error, name="shifts, 95 %"))
    high = max(float(np.max(factor + error[1])), math.exp(2.0 * math.log(radius[-1] / radius[0])))
    drawn = np.array([float(np.min(factor - error[0])), high])
    return Panel(
        tuple(marks),
        PanelAxis.of(Series("radius", Word("a", "m", "contact radius"), radius), margin=0.05),
        PanelAxis.of(
            Series("shift", Word("t/t_1", "", "times over those of the smallest contact"), drawn), margin=0.08
        ),
        legend="best",
    )
