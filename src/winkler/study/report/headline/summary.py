"""The elastic contact of an answer in the numbers that a designer compares: pressures, sizes, stresses, margin."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.loading.loads import Depth
from winkler.media.halfspace import HalfSpace
from winkler.problems.line.indentation import LineSolution
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.subsurface.contact_stress import ContactStress
from winkler.study.batch.outcome import Outcome
from winkler.study.report.figures import shown_contact, shown_point
from winkler.study.report.headline.elastic_state import ElasticState, elastic_state
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.readable import with_unit

__all__ = ["SummaryNumber", "contact_summary"]

STEELS = (100e9, 125e9)
"""Effective moduli of steel on steel [Pa]."""
STATIC_RATINGS = {"N": ("ball", 4.2e9), "N/m": ("roller", 4.0e9)}
"""Unit of the load -> bearing and peak pressure [Pa] of its static rating, ISO 76:2006."""


class SummaryNumber(NamedTuple):
    """One number of the summary.

    Parameters
    ----------
    name
        In words.
    number
        SI.
    unit
        Its unit.
    remark
        Where it is, or what it is compared with; empty if there is nothing to add.
    """

    name: str
    number: float
    unit: str
    remark: str = ""

    @property
    def text(self) -> str:
        """The number with its unit."""
        return with_unit(self.number, self.unit)


def contact_summary(outcome: Outcome) -> tuple[SummaryNumber, ...]:
    """Return the numbers of the elastic contact that the pictures show, pressed without friction.

    There are none of a sweep, nor where the contact or its stresses are not known.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    if outcome.study.sweep or not outcome.solved:
        return ()
    point = shown_point(outcome)
    state = elastic_state(point)
    if state is None:
        return ()
    contact = shown_contact(point)
    found = contact if isinstance(contact, IndentationSolution) else point.each[-1]
    rated, sharp = _rated(found, state), f"; {state.sharp}" if state.sharp else ""
    rows = [
        SummaryNumber("greatest pressure p0", state.peak_pressure, "Pa", rated),
        *_sizes(found),
        *_shear(found),
        SummaryNumber(
            "greatest von Mises stress",
            state.von_mises,
            "Pa",
            f"{with_unit(state.depth, 'm', 3)} below the surface, {state.body}{sharp}",
        ),
    ]
    if math.isfinite(state.strength):
        share = f"the greatest stress is {state.von_mises / state.strength:.3g} of the strength of the {state.body}"
        rows.append(SummaryNumber("load at which it yields", state.yield_load, state.unit, share))
    return tuple(row for row in rows if not math.isnan(row.number))


def _sizes(found: Any) -> list[SummaryNumber]:
    """Return load, mean pressure, size and approach of a contact."""
    line = isinstance(found, LineSolution)
    names = {
        "mean pressure": ("mean_pressure", "Pa"),
        "force per length" if line else "force": ("force_per_length" if line else "force", "N/m" if line else "N"),
        "contact radius": ("radius", "m"),
        "half-width": ("half_width", "m"),
        "longitudinal semi-axis": ("longitudinal_semi_axis", "m"),
        "lateral semi-axis": ("lateral_semi_axis", "m"),
        "contact area": ("area", "m^2"),
        "approach": ("depth", "m"),
    }
    rows = []
    for name, (attribute, unit) in names.items():
        number = getattr(found, attribute, None)
        if isinstance(number, float | np.ndarray | np.floating) and np.size(number):
            rows.append(SummaryNumber(name, float(np.ravel(number)[-1]), unit))
    known = {row.name: row.number for row in rows}
    if "contact area" not in known and "contact radius" in known:
        rows.append(SummaryNumber("contact area", math.pi * known["contact radius"] ** 2, "m^2"))
    return rows


def _bed(found: Any) -> Any:
    """Return the bed of a contact, or its problem where that names the bodies; a moment of a history has a bed alone."""
    problem = getattr(found, "problem", found)
    return getattr(problem, "bed", problem)


def _shear(found: Any) -> list[SummaryNumber]:
    """Return the greatest shear stress in homogeneous bodies; none where it is infinite or not known."""
    bed = _bed(found)
    if not isinstance(getattr(bed, "medium", None), HalfSpace):
        return []
    try:
        if isinstance(found, IndentationSolution):
            solved = ContactStress(Indentation(bed, Depth(float(np.ravel(found.depth)[-1])))).solve()
        elif isinstance(found, EllipticSolution | LineSolution) and np.size(found.peak_pressure) == 1:
            solved = ContactStress(found.problem).solve()
        else:
            return []
    except (InvalidInput, OutsideValidity):
        return []
    return [
        SummaryNumber(name, number, "Pa", f"{with_unit(abs(depth), 'm', 3)} below the surface")
        for name, number, depth in (
            ("greatest shear stress", solved.max_shear, solved.max_shear_depth),
            ("greatest shear along the surface", solved.orthogonal_shear, solved.orthogonal_shear_depth),
        )
    ]


def _rated(found: Any, state: ElasticState) -> str:
    """Return the share of the static rating of bearings, of ellipses and strips of steel; else nothing."""
    medium = getattr(_bed(found), "medium", None)
    if isinstance(found, IndentationSolution) or not isinstance(medium, HalfSpace):
        return ""
    if not STEELS[0] <= medium.modulus <= STEELS[1]:
        return ""
    name, rating = STATIC_RATINGS[state.unit]
    return f"{state.peak_pressure / rating:.3g} of the static rating of {name} bearings, {rating / 1e9:g} GPa (ISO 76)"
