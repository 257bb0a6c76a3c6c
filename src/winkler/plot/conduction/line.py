"""Sheets of line contacts that conduct a current: the resistance over the force per length, and its parts."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.loading.loads import LineForce
from winkler.plot.curves import Quantity, answered, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Sheet
from winkler.plot.series import row_of, with_unit
from winkler.problems.conduction.line_constriction import LineConstrictionSolution
from winkler.values.errors import OutsideValidity

POINTS, DECADES_BEYOND = 41, 1.5
PARTS = (
    ("resistance_per_length", "whole"),
    ("first_constriction_per_length", "first body"),
    ("second_constriction_per_length", "second body"),
    ("film_resistance_per_length", "film"),
)


@without_extent(LineConstrictionSolution)
def line_constriction_sheet(item: LineConstrictionSolution) -> Sheet:
    """Return the resistance times length and its parts over the force per length, around the requested loads."""
    requested = np.ravel(np.asarray(item.force_per_length, dtype=float))
    requested = requested[requested > 0.0]
    if not requested.size:
        raise OutsideValidity("draw: the bodies do not touch, so there is nothing to show; press harder.")
    low, high = np.log10(np.min(requested)), np.log10(np.max(requested))
    wide = DECADES_BEYOND if high - low < 1.0 else 0.0
    force = np.logspace(low - wide, high + 0.5 * wide, POINTS)
    contact = dataclasses.replace(item.problem.contact, load=LineForce(force))
    curve = dataclasses.replace(item.problem, contact=contact).solve()
    whole, *parts = (answered(curve, item, "force_per_length", name, label) for name, label in PARTS)
    rows = [whole, *(Quantity(part.of, part.name) for part in parts if np.any(part.of.content > 0.0))]
    panel = curves_panel(row_of(curve, "force_per_length"), rows, label="resistance times length")
    single, found = np.ndim(item.half_width) == 0, float(np.ravel(item.resistance_per_length)[0])
    title = f"{with_unit(found, 'ohm m')} at {with_unit(float(requested[0]), 'N/m')}" if single else ""
    return Sheet((panel,), width=5.4, height=3.3, title=title)
