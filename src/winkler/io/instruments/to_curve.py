"""From the columns of a test to its force curve: which of them is taken for what, and what is left out."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.io.continuous_loading import (
    HARDNESS_NAMES,
    YOUNG_NAMES,
    StatedResults,
    loading_stiffness,
    stated_results,
    stiffness_fact,
)
from winkler.io.curve_columns import (
    DEPTH_NAMES,
    FORCE_NAMES,
    POSITION_NAMES,
    STIFFNESS_NAMES,
    TIME_NAMES,
    by_preference,
)
from winkler.io.foreign import in_file
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest, measures
from winkler.io.placed_curves import PlacedCurve, name_of_test, reading_of
from winkler.io.swapped_columns import is_list, refuse_list, signs
from winkler.io.tables.given_units import GivenFacts, key_of, unit_asked
from winkler.io.tables.several_tests import parts_of_tests
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.units import scale

LARGEST_NUMBER = 1e100
"""Instruments write 1.8e308 for a number that they could not compute."""
ROLES = {
    "depth": ((*DEPTH_NAMES, *POSITION_NAMES), "m"),
    "force": (FORCE_NAMES, "N"),
    "time": (TIME_NAMES, "s"),
    "stiffness": (STIFFNESS_NAMES, "N/m"),
}
NEEDED = ("depth", "force")
MOST_RESULTS = 50
"""Rows with moduli and without times that are a list: a test has more."""


def curves_of_test(test: InstrumentTest, path: object, given: GivenFacts) -> list[PlacedCurve]:
    """Return the curve of a test, or those of several below each other in its columns.

    Their ``reading`` states what was taken for what.

    Parameters
    ----------
    test : InstrumentTest
    path
        The file, for messages.
    given : GivenFacts
        Units of columns without one, and the spring constant of a spring behind the tip whose bending the depth still
        contains.

    Raises
    ------
    InvalidInput
        If there is no depth or no force, a unit is missing or contradicts the file, or hardly a row has both.
    """
    where, units = f"{path}: '{test.name}'", given.units
    spring_constant = test.spring_constant if test.spring_constant is not None else given.spring_constant
    found = {role: _column(test.columns, names, unit) for role, (names, unit) in ROLES.items()}
    if missing := [role for role in NEEDED if found[role] is None]:
        there = ", ".join(f"'{column.name}'" for column in test.columns[:20])
        names = "; ".join(f"{role} ({', '.join(ROLES[role][0][:7])} ...)" for role in missing)
        raise InvalidInput(f"{where} has no column for {names}; there are {there}.")
    chosen = {role: column for role, column in found.items() if column is not None}
    lacking = [role for role in chosen if not (chosen[role].unit or units.get(key_of(role)))]
    if lacking:
        asked = [chosen[role].name for role in lacking]
        raise InvalidInput(f"{unit_asked(where, asked, [key_of(role) for role in lacking])}.")
    factors = {role: _factor(role, column, units, where) for role, column in chosen.items()}
    numbers = {role: column.values * factors[role] for role, column in chosen.items()}
    usable = np.all([_is_number(chosen[role].values) for role in ("depth", "force", "time") if role in chosen], axis=0)
    left_out = int(np.count_nonzero(~usable))
    if np.count_nonzero(usable) < 2:
        raise InvalidInput(f"{where}: {np.count_nonzero(usable)} rows hold depth and force; it needs at least 2.")
    depth, force = numbers["depth"][usable], numbers["force"][usable]
    if "time" not in chosen:
        refuse_list(where, [chosen[role].name for role in NEEDED], depth, force, results=_has_results(test))
    of_depth, of_force, turned = signs(depth, force)
    depth, force = of_depth * depth, of_force * force
    time = numbers["time"][usable] if "time" in numbers else np.zeros(0)
    averaged = any(column.name.lower().startswith("standard deviation") for column in test.columns)
    if falling := averaged and bool(np.any(np.diff(time) < 0.0)):
        time = np.zeros(0)
    direction = test.direction[usable] if test.direction.size else np.zeros(0)
    machine = spring_constant if spring_constant is not None else math.inf
    origin = "given" if given.spring_constant is not None else "from the file"
    rows = (test.rows if test.rows.size else np.arange(usable.size))[usable]
    # rows without numbers within a test are no gap between two
    parts = parts_of_tests(depth, force, time, rows) if test.rows.size and not direction.size else [slice(None)]
    curves = []
    for number, part in enumerate(parts, start=1):
        name = name_of_test(test.name, number, len(parts))
        at, load, clock = depth[part], force[part], time[part] if time.size else time
        continuous = None
        if "stiffness" in chosen:
            valid = _is_number(chosen["stiffness"].values)[usable]
            stiffness = np.where(valid, numbers["stiffness"][usable], math.nan)[part]
            with in_file(path):
                continuous = loading_stiffness(at, load, stiffness, clock, name)
        facts = [
            ", ".join(f"{role} from {_named(chosen[role], role, units)}" for role in chosen if role != "stiffness"),
            turned,
            stiffness_fact(_named(chosen["stiffness"], "stiffness", units), continuous)
            if "stiffness" in chosen
            else "",
            "an average of several tests, whose time falls and is left out" if falling else "",
            f"{left_out} row{'s' * (left_out != 1)} without numbers left out" if left_out else "",
            f"spring constant {spring_constant:g} N/m {origin}" if spring_constant is not None else "",
            *test.notes,
        ]
        reading = reading_of(test.instrument, facts, number, len(parts), at, load)
        with in_file(path):
            curve = ForceCurve(at, load, machine, clock, direction, name, reading=reading)
        curves.append(PlacedCurve(curve, test.x, test.y, continuous, _stated(test, at, usable, part)))
    return curves


def is_results(test: InstrumentTest) -> bool:
    """Return whether the columns of a test are a list of results, one row for each test, and no test itself.

    Such a list has no time.  It has moduli or hardnesses in few rows, or rows of which none follows the one before.
    """
    found = {role: _column(test.columns, names, unit) for role, (names, unit) in ROLES.items()}
    depth, force = found["depth"], found["force"]
    if found["time"] is not None or depth is None or force is None:
        return False
    both = np.isfinite(depth.values) & np.isfinite(force.values)
    results = _has_results(test)
    few = results and np.count_nonzero(both) <= MOST_RESULTS
    return bool(few or is_list(depth.values[both], force.values[both], results=results))


def _has_results(test: InstrumentTest) -> bool:
    return any(_column(test.columns, names, "Pa") is not None for names in (YOUNG_NAMES, HARDNESS_NAMES))


def _column(columns: Sequence[InstrumentColumn], names: Sequence[str], unit: str) -> InstrumentColumn | None:
    """Return the column with the first of the names whose unit fits or is not stated."""
    for name in by_preference(names):
        for column in columns:
            if column.name.lower().strip() == name and (not column.unit or measures(column.unit, unit)):
                return column
    return None


def _stated(test: InstrumentTest, depth: Array, usable: Array, part: slice) -> StatedResults | None:
    """Return the modulus and hardness that stand in the columns of a test, in units that the file states."""
    found = [_column(test.columns, names, "Pa") for names in (YOUNG_NAMES, HARDNESS_NAMES)]
    numbers = [
        np.where(_is_number(one.values), one.values, math.nan)[usable][part] * scale(one.unit, "Pa")
        if one is not None and one.unit
        else np.full(depth.size, math.nan)
        for one in found
    ]
    return stated_results(depth, *numbers)


def _factor(role: str, column: InstrumentColumn, units: Mapping[str, str], where: str) -> float:
    key, wanted = key_of(role), ROLES[role][1]
    given = units.get(key, "")
    if column.unit and given and scale(column.unit, wanted) != scale(given, wanted):
        raise InvalidInput(
            f"{where}: the file states '{column.unit}' for '{column.name}', and units gives {key} = '{given}'; leave "
            f"{key} out of units, or correct the file."
        )
    return scale(column.unit or given, wanted)


def _named(column: InstrumentColumn, role: str, units: Mapping[str, str]) -> str:
    if column.unit:
        return f"'{column.name}' [{column.unit}]"
    return f"'{column.name}' [{units[key_of(role)]}, given]"


def _is_number(values: Array) -> Array:
    with np.errstate(invalid="ignore"):
        return np.isfinite(values) & (np.abs(values) < LARGEST_NUMBER)
