"""An answer in the numbers that a designer compares: what was asked, pressures, sizes, stresses, margin, losses.

One rule for all problems: the numbers of the headline, then those of `CALLED` that the solution declares, then those of
the contact inside it, then the stresses of the contact, where they are known.  The area follows from the radius of a
round contact, mean pressure and share from the area, nominal pressure and leak per width from the sides of a height
map.  A solution that declares one of them itself keeps its own.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.study.batch.outcome import Outcome, answers_of
from winkler.study.batch.points import SolvedPoint, sides_of_map
from winkler.study.chapters.contents import answer_of
from winkler.study.report.describe import settings_text
from winkler.study.report.headline.elastic_state import ElasticState, elastic_state, unknown_because
from winkler.study.report.headline.numbers import ALIKE, SoughtNumber, as_share, numbers_named, sought_numbers
from winkler.study.report.headline.shown_contact import (
    medium_of,
    most_pressed,
    shown_contact,
    shown_point,
    stressed_contact,
)
from winkler.values.errors import OutsideValidity, WinklerError
from winkler.values.readable import with_unit
from winkler.values.vocabulary import GLOSSARY, Word, word

CALLED: Mapping[str, str] = MappingProxyType(
    {
        "peak_pressure": "greatest pressure p0",
        "mean_pressure": "mean pressure",
        "nominal_pressure": "nominal pressure",
        "force": "force",
        "force_per_length": "force per length",
        "radius": "contact radius",
        "half_width": "half-width",
        "longitudinal_semi_axis": "longitudinal semi-axis",
        "lateral_semi_axis": "lateral semi-axis",
        "contact_length": "length in contact",
        "area": "contact area",
        "contact_share": "share in contact",
        "depth": "approach",
        "residual_depth": "depth of the dent",
        "max_shear": "greatest shear stress",
        "orthogonal_shear": "greatest shear along the surface",
        "von_mises": "greatest von Mises stress",
        "stresses": "stresses in the bodies",
        "yield_force": "load at which it yields",
        "yield_depth": "approach at which it yields",
        "yield_velocity": "velocity at which it yields",
        "yield_factor": "times its load at which it yields",
        "loss_per_cycle": "loss per cycle",
        "loss_per_cycle_per_length": "loss per cycle and length",
        "loss_per_distance": "loss per distance",
        "secant_stiffness": "secant stiffness",
        "loss_factor": "loss factor",
        "leak_per_width": "leak per width",
    }
)
"""Answer of a solution -> what the summary of a contact calls it, in the order of its rows."""
WORDS: Mapping[str, Word] = MappingProxyType(
    {
        **{name: GLOSSARY[name] for name in ("area", "mean_pressure", "nominal_pressure")},
        "contact_share": Word("A/A_0", "", "part of the surface that is in contact"),
        "leak_per_width": Word("Q/w", "m^2/s", "leak rate over the width of the seal"),
    }
)
"""What the numbers mean that follow from others."""
FORCES = ("force", "force_per_length")
STEELS = (100e9, 125e9)
"""Effective moduli of steel on steel [Pa]."""
OF_MAP = ("nominal_pressure", "contact_share")
STATIC_RATINGS = {"N": ("ball", 4.2e9), "N/m": ("roller", 4.0e9)}
"""Unit of the load -> bearing and peak pressure [Pa] of its static rating, ISO 76:2006."""


class SummaryNumber(NamedTuple):
    """One number of the summary.

    Parameters
    ----------
    key
        Name of the answer, or of the stress.
    name
        In words.
    number
        SI; of a range that which is farthest from zero.
    unit
        Its unit.
    text
        The number with its unit.
    remark
        Where it is, or what it is compared with; empty if there is nothing to add.
    """

    key: str
    name: str
    number: float
    unit: str
    text: str
    remark: str = ""

    def table(self) -> dict[str, Any]:
        """Return it as data for JSON."""
        known = None if self.key == "stresses" else self.number
        named = {"key": self.key, "name": self.name, "value": known, "unit": self.unit}
        return {**named, "text": self.text, "remark": self.remark}


def contact_summary(outcome: Outcome) -> tuple[SummaryNumber, ...]:
    """Return the numbers that a user asked for, those of the contact, and its stresses without friction.

    Of a sweep they are ranges, and stresses those of the point where the pressure is greatest.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    if not outcome.solved:
        return ()
    sought = sought_numbers(outcome)
    whole_curve = not answer_of(outcome.study.problem).headline
    each = [point.readable if whole_curve else numbers_of_contact(point) for point in outcome.solved]
    varied = {axis.key.rpartition(".")[2] for axis in outcome.study.sweep}
    names = [name for name in CALLED if any(name in one for one in each)]
    shown = {one.name for one in sought} | varied
    words = {name: outcome.word(name) if name in outcome.answers else WORDS[name] for name in names}
    rest = {name: entry for name, entry in words.items() if name not in shown}
    along = {name for name in rest if any(_varies(one[name]) for one in each if name in one)}
    ends = [{name: _greatest(one[name]) for name in rest if name in one} if outcome.study.axes else one for one in each]
    rows = {one.name: _row(one) for one in sought}
    for one in numbers_named(outcome, rest, ends):
        row = _row(one)
        of_path = one.name in along and bool(outcome.study.axes)
        rows[one.name] = row._replace(remark=f"the greatest, {row.remark}".rstrip(", ")) if of_path else row
    if not outcome.study.axes:
        point = shown_point(outcome)
        rows |= {row.key: row for row in _inside(point) if row.key not in rows}
        for row in _stresses(point):
            kept = rows.setdefault(row.key, row)
            rows[row.key] = kept if kept.remark else kept._replace(remark=row.remark)
        rows |= {name: rows[name]._replace(remark=_of_map(point, rows[name].remark)) for name in OF_MAP if name in rows}
    elif not outcome.study.design.draws:
        point = most_pressed(outcome.solved, each)
        where = f"at {settings_text(outcome.study, point.settings)}"
        stresses = (row._replace(remark=f"{row.remark}, {where}" if row.remark else where) for row in _stresses(point))
        rows |= {row.key: row for row in stresses if row.key not in rows and row.key not in varied}
    drawn = outcome.study.design.draws or "von_mises" in rows
    if reason := "" if drawn else unknown_because(most_pressed(outcome.solved, each)):
        rows["stresses"] = SummaryNumber("stresses", CALLED["stresses"], math.nan, "", "not computed", reason)
    order = [one.name for one in sought] + [name for name in CALLED if name not in shown]
    return tuple(rows[name] for name in order if name in rows)


def _varies(numbers: Array) -> bool:
    """Return whether numbers along the loads of a point differ."""
    finite = numbers[np.isfinite(numbers)]
    return finite.size > 1 and bool(np.ptp(finite) > ALIKE * np.max(np.abs(finite)))


def _greatest(numbers: Array) -> Array:
    """Return the number along the loads of a point that is farthest from zero, as an array of one."""
    finite = numbers[np.isfinite(numbers)]
    return finite[[int(np.argmax(np.abs(finite)))]] if finite.size else np.array([math.nan])


def _row(one: SoughtNumber) -> SummaryNumber:
    """Return a number of an answer as a row."""
    remark = one.remark
    if one.is_range and one.places:
        first, last = one.places
        key, _, said = last.partition(" = ")
        remark = f"at {first} … {said if first.startswith(f'{key} = ') and ',' not in first else last}"
    number = one.extreme if one.is_range or one.ends_at_zero else one.last
    return SummaryNumber(one.name, CALLED.get(one.name, one.label), number, one.word.unit or "", one.text, remark)


def _plain(key: str, number: float, unit: str, remark: str = "") -> SummaryNumber:
    text = as_share(number) if key.endswith("_share") else with_unit(number, unit)
    return SummaryNumber(key, CALLED[key], number, unit, text, remark)


def _inside(point: SolvedPoint) -> Iterator[SummaryNumber]:
    """Yield the numbers of the contact inside an answer, or of that which its pictures show."""
    try:
        inside = _numbers_inside(point.each[-1], shown_contact(point))
    except WinklerError:  # an answer without a contact under this load
        return
    where = answer_of(point.problem).contact_shown.partition(",")[0]
    for name, (entry, number) in inside.items():
        if not math.isnan(number):
            yield _plain(name, number, entry.unit or "", where)


def _of_map(point: SolvedPoint, remark: str) -> str:
    """Return a remark with the sides of the height map over which a number is a mean."""
    sides = sides_of_map(point.problem)
    if not sides.size:
        return remark
    whole = f"of the whole map, {' x '.join(with_unit(float(side), 'm') for side in sides)}"
    return f"{whole}; {remark}" if remark else whole


def _stresses(point: SolvedPoint) -> Iterator[SummaryNumber]:
    """Yield the greatest pressure and stresses of the contact pressed without friction, and the load of yield."""
    state = elastic_state(point)
    if state is None:
        return
    if not math.isnan(state.peak_pressure):
        yield _plain("peak_pressure", state.peak_pressure, "Pa", _rated(stressed_contact(point), state))
    for name, (stress, depth, body) in zip(("max_shear", "orthogonal_shear"), state.shears, strict=False):
        yield _plain(name, stress, "Pa", f"{_below(depth)}, {body}" if body else _below(depth))
    sharp = f"; {state.sharp}" if state.sharp else ""
    share = f"; {state.share:.3g} of the strength" if 0.0 < state.share != 1.0 and math.isnan(state.yield_load) else ""
    yield _plain("von_mises", state.von_mises, "Pa", f"{state.place(3)}, {state.under}{share}{sharp}")
    if math.isfinite(state.strength) and not math.isnan(state.yield_load):
        said = f"the greatest stress is {state.share:.3g} of the strength of the {state.body}"
        said = f"the greatest load is {1.0 / state.margin:.3g} times this" if math.isnan(state.depth) else said
        yield _plain("yield_force", state.yield_load, state.unit, said)


def _below(depth: float) -> str:
    return f"{with_unit(depth, 'm', 3)} below the surface" if depth else "at the surface"


def _rated(found: Any, state: ElasticState) -> str:
    """Return the share of the static rating of bearings, of ellipses and strips of steel; else nothing."""
    medium = medium_of(found)
    if not isinstance(medium, HalfSpace) or not (state.unit == "N/m" or hasattr(found, "lateral_semi_axis")):
        return ""
    if not STEELS[0] <= medium.modulus <= STEELS[1]:
        return ""
    name, rating = STATIC_RATINGS[state.unit]
    return f"{state.peak_pressure / rating:.3g} of the static rating of {name} bearings, {rating / 1e9:g} GPa (ISO 76)"


def numbers_of_contact(point: SolvedPoint) -> dict[str, Array]:
    """Return the numbers of a point along its loads, and what follows from its radius, area and map.

    Parameters
    ----------
    point
        A solved point.
    """
    found: dict[str, Array] = dict(point.readable)
    found |= {name: content for name, content in _following(found, point.problem).items() if name not in found}
    return found


def _numbers_inside(solution: Any, contact: Any) -> dict[str, tuple[Word, float]]:
    """Return the numbers of the contact that a solution holds, or that its pictures show, of its last load.

    Parameters
    ----------
    solution
        Of one load or many.
    contact
        The contact of the pictures, or None.
    """
    inside = getattr(solution, "contact", None) if contact is None else contact
    if inside is None or inside is solution:
        return {}
    answers = {name: np.atleast_1d(content) for name, content in answers_of(inside).items() if name in CALLED}
    following = _following(answers, getattr(inside, "problem", None))
    words = {name: WORDS[name] for name in following} | {name: word(type(inside), name) for name in answers}
    numbers = following | answers
    return {name: (words[name], float(content[-1])) for name, content in numbers.items() if content.size}


def _following(found: Mapping[str, Array], problem: Any) -> dict[str, Array]:
    """Return what follows from numbers of a contact."""
    given, more = dict(found), {}
    if "area" not in given and {"force", "radius"} <= given.keys() and (outline := _outline(problem)) is not None:
        with contextlib.suppress(OutsideValidity):  # a pyramid, whose outline is not known
            more["area"] = given["area"] = np.asarray(outline.area(np.asarray(given["radius"])))
    if {"area", "force"} <= given.keys():
        with np.errstate(invalid="ignore", divide="ignore"):
            more["mean_pressure"] = np.where(given["area"] > 0.0, given["force"] / given["area"], 0.0)
    sides = sides_of_map(problem)
    if sides.size:
        whole = float(np.prod(sides))
        more |= {"nominal_pressure": given["force"] / whole} if "force" in given else {}
        more |= {"contact_share": given["area"] / whole} if "area" in given else {}
        more |= {"leak_per_width": given["leak_rate"] / sides[1]} if "leak_rate" in given else {}
    return more


def _outline(problem: Any) -> Any:
    """Return the outline of a round contact by its bed; None where a problem has none."""
    return getattr(getattr(problem, "bed", None), "footprint", None)
