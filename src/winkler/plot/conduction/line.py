"""Sheets of line contacts that conduct a current: the resistance over the force per length, and its parts."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.loading.loads import LineForce
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, points
from winkler.plot.series import middle_scale, scale_of, series, with_unit
from winkler.problems.conduction.line_constriction import LineConstrictionSolution
from winkler.values.errors import OutsideValidity

POINTS, DECADES_BEYOND = 41, 1.5
PARTS = (
    ("resistance_per_length", "whole", style.RED, style.DASHES[0]),
    ("first_constriction_per_length", "first body", style.BLUE, style.DASHES[1]),
    ("second_constriction_per_length", "second body", style.GREEN, style.DASHES[2]),
    ("film_resistance_per_length", "film", style.ORANGE, style.DASHES[3]),
)


@without_extent(LineConstrictionSolution)
def line_constriction_sheet(item: LineConstrictionSolution) -> Sheet:
    """Return the resistance times length and its parts over the force per length, around the requested loads."""
    requested = np.ravel(np.asarray(item.force_per_length, dtype=float))
    whole = np.ravel(np.asarray(item.resistance_per_length, dtype=float))[requested > 0.0]
    requested = requested[requested > 0.0]
    if not requested.size:
        raise OutsideValidity("draw: the bodies do not touch, so there is nothing to show; press harder.")
    low, high = np.log10(np.min(requested)), np.log10(np.max(requested))
    wide = DECADES_BEYOND if high - low < 1.0 else 0.0
    force = np.logspace(low - wide, high + 0.5 * wide, POINTS)
    contact = dataclasses.replace(item.problem.contact, load=LineForce(force))
    curve = dataclasses.replace(item.problem, contact=contact).solve()
    marks = []
    for name, label, colour, dash in PARTS:
        part = series(name, np.asarray(getattr(curve, name)), type(item))
        if np.any(part.content > 0.0):
            marks.append(Line(force, part.content, colour, dash=dash, name=label))
    across = PanelAxis("force per length $P$", middle_scale("N/m", force), log=True)
    most = float(np.max(curve.resistance_per_length))
    upright = PanelAxis("resistance times length", scale_of("ohm m", [most]), low=0.0, high=1.5 * most)
    single = np.ndim(item.half_width) == 0
    title = f"{with_unit(float(whole[0]), 'ohm m')} at {with_unit(float(requested[0]), 'N/m')}" if single else ""
    dots = points(requested, whole, name="requested", order=5.0)
    return Sheet((Panel((*marks, dots), across, upright, legend="upper right"),), width=5.4, height=3.3, title=title)
