"""Workbooks of Agilent, Keysight, KLA and MTS indenters (XP, G200, iMicro): a sheet for each test.

A sheet of a test has a row of names, a row of units, and below them the numbers; its first column may mark where
segments begin.  "Displacement Into Surface" and "Load On Sample" have the drift, the frame and the supporting springs
already subtracted (descriptions of these channels in methods of NanoSuite).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from winkler.io.curve_columns import DEPTH_NAMES, FORCE_NAMES, POSITION_NAMES
from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.number_block import columns_of, split_unit
from winkler.io.instruments.to_curve import is_results
from winkler.io.workbooks.workbook_cells import Cell, WorkbookSheet, sheets_of
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

TEST = re.compile(r"test\s*0*(\d+)", re.IGNORECASE)
NO_TESTS = ("results", "required inputs", "inputs editable post test", "calculations", "summary", "analyst project")
HEADER_ROWS = 30
TOLD = {"drift correction": "drift", "tip name": "tip", "poissons ratio": "Poisson's ratio"}
AREA = "area coefficient "
"""Columns of the sheets of results and inputs that the reading repeats."""
PLACES = ("x test position", "y test position")
END = "end"
KINDS = (("unload", -1.0), ("hold", 0.0), ("load", 1.0))
"""What the name of a segment says about its direction, the first that fits."""


def tests_of_workbook(path: Path) -> Iterator[InstrumentTest]:
    """Yield the tests of a workbook, in the order of their numbers where they have some.

    Raises
    ------
    InvalidInput
        If the workbook cannot be read, or no sheet holds a test.
    """
    sheets = list(sheets_of(path))
    about: dict[int, dict[str, Cell]] = {}
    for sheet in sheets:
        for number, facts in _facts(sheet).items():
            about.setdefault(number, {}).update(facts)
    numbered = [(int(match[1]), sheet) for sheet in sheets if (match := TEST.fullmatch(sheet.name.strip()))]
    chosen = sorted(numbered, key=lambda pair: pair[0]) or [
        (0, sheet) for sheet in sheets if sheet.name.strip().lower() not in NO_TESTS
    ]
    tests = [test for number, sheet in chosen if (test := _test(sheet, path, about.get(number, {}))) is not None]
    if not tests:
        listed = ", ".join(f"'{sheet.name}'" for sheet in sheets[:12])
        raise InvalidInput(
            f"{path}: no sheet of the workbook has a row that names a depth and a force; there are {listed}; of "
            "numbers without names give columns = { depth = 1, force = 2 } and units."
        )
    kept = [test for test in tests if not is_results(test)]
    lists = [f"'{test.name.removeprefix(f'{path.name}, ')}'" for test in tests if kept and is_results(test)]
    left_out = (f"taken for lists of results, without time, and left out: {', '.join(lists)}",) if lists else ()
    yield from [test._replace(notes=(*test.notes, *left_out)) for test in kept] or tests


def _header_row(sheet: WorkbookSheet) -> int | None:
    """Return the number of the row that names a depth and a force."""
    for index, row in enumerate(sheet.rows[:HEADER_ROWS]):
        words = {split_unit(cell)[0].lower() for cell in row if isinstance(cell, str) and cell}
        words |= {cell.lower() for cell in row if isinstance(cell, str)}
        if words & {*DEPTH_NAMES, *POSITION_NAMES} and words & set(FORCE_NAMES):
            return index
    return None


def _test(sheet: WorkbookSheet, path: Path, facts: dict[str, Cell]) -> InstrumentTest | None:
    """Return the test of a sheet, None if it holds no table of numbers."""
    header = _header_row(sheet)
    if header is None or header + 1 >= len(sheet.rows):
        return None
    cells = [cell if isinstance(cell, str) else "" for cell in sheet.rows[header]]
    below = sheet.rows[header + 1]
    named = [cell for name, cell in zip(cells, below, strict=False) if name]  # another table may stand beside it
    texts_below = all(isinstance(_number(cell), str) for cell in named) and any(named)
    units = [cell if isinstance(cell, str) else "" for cell in below] if texts_below else [""] * len(cells)
    both = [
        (cell, unit) if unit else split_unit(cell)
        for cell, unit in zip(cells, [*units, *[""] * len(cells)], strict=False)
    ]
    numbered = [place for place, (name, _) in enumerate(both) if name and name.lower() != "segment"]
    rows, marks, lines = [], [], []
    for line, row in enumerate(sheet.rows[header + 1 + texts_below :]):
        mark = str(row[0]).strip().lower() if row and isinstance(row[0], str) else ""
        if mark == END:
            break
        numbers = [_number(row[place]) if place < len(row) else "" for place in numbered]
        if mark or any(isinstance(number, float) for number in numbers):
            rows.append([number if isinstance(number, float) else math.nan for number in numbers])
            marks.append(mark if 0 not in numbered else "")
            lines.append(line)
    if not rows:
        return None
    names, stated = zip(*(both[place] for place in numbered), strict=True)
    table = np.array(rows)
    columns = columns_of(names, stated, table, path)
    kind = "of NanoSuite or Analyst (MTS, Agilent, Keysight, KLA)" if any(marks) else "of an instrument"
    x, y = (_metres(facts, place) for place in PLACES)
    name = f"{path.name}, {sheet.name}"
    return InstrumentTest(
        f"workbook {kind}", name, columns, _notes(names, facts), x, y, _directions(marks), np.array(lines)
    )


def _notes(names: tuple[str, ...], facts: dict[str, Cell]) -> tuple[str, ...]:
    notes = []
    if "displacement into surface" in [name.lower() for name in names]:
        notes.append(
            "the instrument has subtracted drift and frame from the displacement, and its springs from the load"
        )
    notes += [f"{word} {_shown(facts, key)}" for key, word in TOLD.items() if facts.get(key, "") != ""]
    if area := [_shown(facts, key) for key in facts if key.startswith(AREA) and not key.endswith(" unit")]:
        notes.append(f"area coefficients {', '.join(area)}")
    return tuple(notes)


def _shown(facts: dict[str, Cell], key: str) -> str:
    content, unit = facts[key], facts.get(f"{key} unit", "")
    return f"{content:.10g} {unit}".strip() if isinstance(content, float) else f"{content} {unit}".strip()


def _directions(marks: list[str]) -> Array:
    """Return the directions of marked segments; none unless each of them has a kind and none is a cycle."""
    named = [mark for mark in marks if mark]
    kinds = {mark: next((sign for word, sign in KINDS if word in mark), math.nan) for mark in named}
    if not named or not marks[0] or any(math.isnan(sign) for sign in kinds.values()) or len(kinds) < 2:
        return np.zeros(0)
    if any("cycle" in mark for mark in named):
        return np.zeros(0)
    directions, current = np.empty(len(marks)), 0.0
    for place, mark in enumerate(marks):
        current = kinds[mark] if mark else current
        directions[place] = current
    return directions


def _facts(sheet: WorkbookSheet) -> dict[int, dict[str, Cell]]:
    """Return what the sheets of results and inputs state about each test, by its number."""
    if sheet.name.strip().lower() not in NO_TESTS[:2] or len(sheet.rows) < 3:
        return {}
    names = [str(cell).lower() for cell in sheet.rows[0]]
    units = dict(zip(names, map(str, sheet.rows[1]), strict=False))
    found: dict[int, dict[str, Cell]] = {}
    for row in sheet.rows[2:]:
        number = str(row[0]).removesuffix(".0") if row else ""
        if number.isascii() and number.isdecimal():
            facts = {name: _number(cell) for name, cell in zip(names[1:], row[1:], strict=False) if cell != ""}
            found[int(number)] = facts | {f"{name} unit": units[name] for name in facts}
    return found


def _number(cell: Cell) -> Cell:
    """Return a number that a cell holds as text."""
    try:
        return float(cell)
    except ValueError:
        return cell


def _metres(facts: dict[str, Cell], place: str) -> float:
    content = facts.get(place, math.nan)
    return content * 1e-6 if isinstance(content, float) and facts.get(f"{place} unit", "") == "um" else math.nan
