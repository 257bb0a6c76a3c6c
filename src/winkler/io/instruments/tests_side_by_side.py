r"""Tests side by side in one table, and extension and retraction in columns of their own.

Of a name such as ``Y_lot_1_Fn_[mN]``, ``Depth 2 (nm)``, ``Calc_Ramp_Ex_nm`` or ``Defl_nN_Rt`` a part is the quantity,
one is the unit, and the rest is the label of the test.  Labels are those of tests if they differ in their numbers
alone; ``Ex`` and ``Rt`` are the two ways of one curve.  Equal names, too, are tests in the order of their columns.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.directions import IN, OUT
from winkler.io.curve_columns import DEPTH_NAMES, FORCE_NAMES, POSITION_NAMES, TIME_NAMES
from winkler.io.instruments.cantilever import force_factor
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest, measures
from winkler.io.instruments.number_block import is_row, rows_of
from winkler.io.tables.given_units import GivenFacts
from winkler.io.tables.header import NAME_LETTER
from winkler.io.tables.table_cells import is_number, like_number
from winkler.io.tables.table_lines import table_head, table_lines, table_sheets
from winkler.io.workbooks.workbook_cells import is_workbook
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

DEFLECTION_NAMES = ("defl", "deflection")
QUANTITIES = (
    ("force", (*FORCE_NAMES, *DEFLECTION_NAMES), "N"),
    ("deflection", DEFLECTION_NAMES, "m"),
    ("deflection", DEFLECTION_NAMES, "V"),
    ("depth", DEPTH_NAMES, "m"),
    ("position", POSITION_NAMES, "m"),
    ("time", TIME_NAMES, "s"),
)
"""Quantities, the names that may stand for each, and the unit that tells them apart from others of the name."""
LOADS, PLACES = {"force", "deflection"}, {"depth", "position"}
STATED = {
    "spring constant": re.compile(r'"?\\Spring Constant: ([-+.\deE]{1,30})\s*+"?'),
    "sensitivity": re.compile(r'"?\\@Sens\. DeflSens: V ([-+.\deE]{1,30}) nm/V"?'),
}
"""Lines of the settings that NanoScope writes above its numbers: spring constant [N/m], sensitivity [nm/V]."""
WAYS = {"ex": IN, "rt": OUT}
AXES = frozenset({"x", "y"})
UNIT = re.compile(r"[\[(]\s*([^\])]{1,20}?)\s*[\])]")
SUFFIX = re.compile(r"\.\d{1,3}\Z")
"""What pandas puts behind a name that stands again."""
WORDS = re.compile(r"[^\W\d_]+\.?|\d+|'")
SEPARATORS = ("\t", ";", ",")
MOST_WORDS = 12
FEWEST_COLUMNS = 4


class _Named(NamedTuple):
    """A column: its place and name, quantity, unit and label."""

    place: int
    name: str
    quantity: str
    unit: str
    label: tuple[str, ...]


class _Cantilever(NamedTuple):
    """Spring constant [N/m] and deflection per volt [m/V], where they are known, and where the latter is from."""

    spring: float | None
    sensitivity: float | None
    origin: str


def tests_side_by_side(path: str | os.PathLike[str], given: GivenFacts) -> Iterator[InstrumentTest] | None:
    """Return the tests of a table with several groups of columns; None if it is no such table.

    Raises
    ------
    InvalidInput
        If the times of one test differ between its columns, there are no numbers, or a position needs the spring
        constant.
    """
    parts = table_sheets(path) if is_workbook(Path(path)) else [path]
    return next((tests for part in parts if (tests := _tests_of_part(part, given)) is not None), None)


def _tests_of_part(path: str | os.PathLike[str], given: GivenFacts) -> Iterator[InstrumentTest] | None:
    head = table_head(path, "a force curve")
    for index, line in enumerate(head[:-1]):
        if not NAME_LETTER.search(line):
            continue
        for separator in SEPARATORS:
            if line.count(separator) < FEWEST_COLUMNS - 1:
                continue
            cells = [cell.strip().strip("\"'") for cell in line.lstrip("#% ").split(separator)]
            if any(like_number(cell) for cell in cells if cell):
                continue
            below = [cell.strip().strip("\"'[]()") for cell in head[index + 1].lstrip("#% ").split(separator)]
            has_units = len(below) == len(cells) and not any(like_number(cell) for cell in below if cell)
            groups = _groups(cells, below if has_units else [""] * len(cells))
            if groups and is_row(_first_row(head, index + 1 + has_units), len(cells), separator):
                cantilever = _cantilever(head[:index], given)
                bends = cantilever.spring is None and not given.rigid
                if bends and not all("depth" in group for group in groups.values()):
                    raise InvalidInput(
                        f"{path}: the table holds a position, and so the depth needs the bending of the cantilever; "
                        "give spring_constant in N/m, infinite where the position is the travel of the tip itself."
                    )
                return _tests(path, groups, index + 1 + has_units, len(cells), separator, cantilever)
    return None


def _cantilever(above: Sequence[str], given: GivenFacts) -> _Cantilever:
    """Return what makes a force of a deflection, as it is given or as NanoScope states it above the numbers."""
    found: dict[str, float] = {}
    for line in above:
        for what, pattern in STATED.items():
            if what not in found and (match := pattern.fullmatch(line.strip())) and is_number(match[1]):
                found[what] = float(match[1])
    spring = given.spring_constant or found.get("spring constant") or None
    if given.sensitivity:
        return _Cantilever(spring, given.sensitivity, "given")
    stated = found.get("sensitivity", 0.0)
    return _Cantilever(spring, stated * 1e-9 if stated > 0.0 else None, "from the file")


def _first_row(head: Sequence[str], start: int) -> str:
    return next((line for line in head[start:] if line.strip()), "")


def _groups(cells: Sequence[str], units: Sequence[str]) -> dict[tuple[str, ...], dict[str, list[_Named]]]:
    """Return the columns of each test by its label and their quantities; empty unless two hold a depth and a force."""
    groups: dict[tuple[str, ...], dict[str, list[_Named]]] = {}
    seen: dict[tuple[str, tuple[str, ...]], int] = {}
    named = [found for place, cell in enumerate(cells) if (found := _named(place, cell, units[place])) is not None]
    names = [SUFFIX.sub("", one.name) for one in named]
    repeated = len(set(names)) <= len(names) // 2 and not any(one.label for one in named)
    for one in named:
        label = one.label
        if repeated:
            number = seen[one.quantity, label] = seen.get((one.quantity, label), 0) + 1
            label = (str(number),)
        groups.setdefault(label, {}).setdefault(one.quantity, []).append(one)
    whole = {label: group for label, group in groups.items() if LOADS & set(group) and PLACES & set(group)}
    shapes = {tuple("#" if word.isdigit() else word for word in label) for label in whole}
    ways = set(whole) == {(way,) for way in WAYS}
    differ_in_numbers = len(shapes) == 1 and "#" in next(iter(shapes))
    return whole if len(whole) > 1 and (ways or differ_in_numbers) else {}


def _named(place: int, cell: str, below: str) -> _Named | None:
    """Return quantity, unit and label of a name; None if it is no quantity of a curve."""
    stated = UNIT.search(cell)
    words = WORDS.findall(UNIT.sub(" ", cell))
    if not words or len(words) > MOST_WORDS:
        return None
    if len(words) > 1 and words[0].lower() in AXES:
        words = words[1:]
    lower = [word.lower() for word in words]
    readings = [
        (end - begin, len(words[begin]), quantity, si, begin, end)
        for quantity, names, si in QUANTITIES
        for begin in range(len(words))
        for end in range(begin + 1, len(words) + 1)
        if " ".join(lower[begin:end]) in names
    ]
    # more words before fewer, and a word before a letter: H is the name of a sample in Y_H_2_Pd_[nm]
    for _, _, quantity, si, begin, end in sorted(readings, key=lambda one: (-one[0], -one[1])):
        rest = [*words[:begin], *words[end:]]
        unit = stated[1] if stated else below
        if not unit:
            unit = next((word for word in reversed(rest) if measures(word, si)), "")
            rest = [word for word in rest if word != unit]
        if measures(unit, si):
            return _Named(place, cell, quantity, unit, tuple(word.lower() for word in rest))
    return None


def _tests(
    path: str | os.PathLike[str],
    groups: dict[tuple[str, ...], dict[str, list[_Named]]],
    first: int,
    count: int,
    separator: str,
    cantilever: _Cantilever,
) -> Iterator[InstrumentTest]:
    rows = rows_of(table_lines(path, "a force curve"), first, count, path, separator=separator)
    path = Path(path)
    tests = [
        (
            label,
            *_with_force({what: _columns(rows, columns, path) for what, columns in group.items()}, cantilever, path),
        )
        for label, group in groups.items()
    ]
    if all(label[0] in WAYS for label, *_ in tests):
        origin = tuple(_origin(groups[label]) for label, *_ in tests)
        both = _both_ways(path, {label[0]: columns for label, columns, _ in tests}, origin)
        yield both._replace(notes=(*both.notes, *tests[0][2]), spring_constant=cantilever.spring)
        return
    for label, columns, facts in tests:
        name = f"{path.name}, test {' '.join(label)}"
        maker, notes = "text table, tests side by side", (_origin(groups[label]), *facts)
        spring = None if "depth" in columns else cantilever.spring
        yield InstrumentTest(maker, name, tuple(columns.values()), notes, spring_constant=spring)


def _with_force(
    columns: dict[str, InstrumentColumn], cantilever: _Cantilever, path: Path
) -> tuple[dict[str, InstrumentColumn], tuple[str, ...]]:
    """Return the columns of a test with the force of its deflection, where there is no other, and what made it."""
    bent = columns.pop("deflection", None)
    if bent is None or "force" in columns:
        return columns, ()
    factor, facts = force_factor(bent.unit, cantilever.spring, cantilever.sensitivity, cantilever.origin, path)
    return {**columns, "force": InstrumentColumn("force", "N", factor * bent.values)}, facts


def _columns(rows: Array, columns: Sequence[_Named], path: Path) -> InstrumentColumn:
    """Return a column under the name of its quantity; several, as one time for each signal, must agree."""
    each = [rows[:, one.place] for one in columns]
    if any(not np.allclose(each[0], other, rtol=1e-9, atol=0.0, equal_nan=True) for other in each[1:]):
        raise InvalidInput(
            f"{path}: the {columns[0].quantity} of test {' '.join(columns[0].label)} stands in {len(each)} columns "
            "that differ; keep one of them, or interpolate the signals to one time."
        )
    return InstrumentColumn(columns[0].quantity, columns[0].unit, each[0])


def _origin(group: dict[str, list[_Named]]) -> str:
    """Return from which columns a test is, as a phrase."""
    return f"from {', '.join(repr(one.name) for columns in group.values() for one in columns)}"


def _both_ways(path: Path, ways: dict[str, dict[str, InstrumentColumn]], origin: tuple[str, ...]) -> InstrumentTest:
    """Return extension and retraction as one test; retraction is turned round where it begins at the wrong end."""
    there, back = ways["ex"], ways["rt"]
    place = "position" if "position" in there else "depth"
    end = there[place].values[np.isfinite(there[place].values)][-1]
    x = back[place].values[np.isfinite(back[place].values)]
    turn = slice(None, None, -1) if abs(x[-1] - end) < abs(x[0] - end) else slice(None)
    x = x[turn]
    # the rows that a trigger saves are missing at the end of the extension, which goes to where retraction begins
    late = bool(np.isnan(there[place].values[-1])) and abs(x[0] - end) > 0.0
    if late:
        there = {**there, place: there[place]._replace(values=there[place].values + (x[0] - end))}
    columns = tuple(
        InstrumentColumn(name, column.unit, np.concatenate([column.values, back[name].values[turn]]))
        for name, column in there.items()
        if name in back and name != "time" and back[name].unit == column.unit
    )
    direction = np.repeat([IN, OUT], [there[place].values.size, back[place].values.size])
    notes = (
        *origin,
        "extension and retraction side by side" + ", retraction turned round" * (turn.step == -1),
        *(["extension moved to end where retraction begins"] if late else []),
    )
    return InstrumentTest("text table", path.name, columns, notes, direction=direction)
