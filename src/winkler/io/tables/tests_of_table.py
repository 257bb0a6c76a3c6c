r"""Several tests in one table of moduli: side by side under names that stand again, or below each other.

Side by side, ``Frequency, G', G'', Frequency, G', G''`` stands in one row, or one frequency beside all moduli; the
temperature of each test is in its names, ``G' (20 °C) [Pa]``, or in a row above them.  Below each other, the header
stands again, the numbers of the points begin again at one, or times or frequencies at the first of them.  Sheets of a
workbook that name the same columns are tests, too, if one is asked for.
"""

from __future__ import annotations

import functools
import math
import os
import re
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeVar

from winkler.io.tables.column import Column
from winkler.io.tables.header import COMMENT_MARKS, SEPARATORS_TRIED, needs_of, zero_of
from winkler.io.tables.table import read_table
from winkler.io.tables.table_cells import cells_of, is_number, like_number, named
from winkler.io.tables.table_lines import TablePart, sheets_naming, table_head, table_lines
from winkler.values.errors import InvalidInput

R = TypeVar("R")

TEMPERATURE = re.compile(r"[\[(]? ?(-?\d{1,4}(?:[.,]\d{1,4})?) ?(°C|degC|deg C|ºC|C|K)(?![^\W_]) ?[\])]?")
"""A temperature in a name whose words have one space between them."""
SUFFIX = re.compile(r"\.\d{1,3}\Z")
"""What pandas puts behind a name that stands again."""
COUNTERS = ("meas. pts.", "meas. pts", "point no.", "point", "pt.", "no.", "messpkt.")
SHEET = "sheet "
"""How the label of a sheet begins."""
ROWS_ABOVE = 4
"""Rows above the names in which temperatures are looked for."""
SAME_START, FEWEST_AGAIN = 1e-6, 4
"""Relative difference of the first numbers of tests, and fewest rows of one, where the first number stands again."""
FEWEST_NUMBERS = 2
"""Of the columns asked for in a row of a test; one alone is a number beside a word above the next test."""
MOST_TESTS, MOST_LETTERS, MOST_LINES = 200, 20_000_000, 10_000_000
"""Of tests in a table, letters of tests side by side, and lines of all tests below each other with those above them."""


class _Names(NamedTuple):
    """The row of names: its index among the lines, separator, cells, and the places of each column asked for."""

    line: int
    separator: str | None
    cells: tuple[str, ...]
    places: tuple[tuple[int, ...], ...]


def of_one_test(
    path: str | os.PathLike[str],
    headers: Sequence[Sequence[Column]],
    test: int,
    read: Callable[[str | os.PathLike[str]], R],
    *,
    since: Column | None = None,
) -> R:
    """Return what is read of one test of a table, or of the whole table where it is one.

    Parameters
    ----------
    path : str or path
    headers : sequence of sequences of Column
        Columns that may name a table, the first that do.
    test : int
        Number of the test, counted from 1; zero if none is given.
    read : callable
        Reads a table.
    since : Column, optional
        Time that each test must count from its own step.

    Raises
    ------
    InvalidInput
        If the table holds several tests and none is given, or fewer than that, or the time goes on from the one before.
    """
    if not test:
        parts = parts_of_table(path, headers, below=False)  # one of them alone may have the usual names
        if len(parts) < 2:
            try:
                return read(path)
            except InvalidInput:
                parts = parts_of_table(path, headers)
                if len(parts) < 2:
                    raise
        listed = "; ".join(f"{number}: {part.label}" for number, part in enumerate(parts[:8], start=1))
        more = f"; and {len(parts) - 8} more" * (len(parts) > 8)
        raise InvalidInput(f"{path}: it holds {len(parts)} tests ({listed}{more}); give one, as in test = 1.")
    parts = _tests_of_sheets(path, headers)
    if not 0 < test <= len(parts):
        raise InvalidInput(f"{path}: test is {test}, and it holds {len(parts)}; give a number from 1 on.")
    part = parts[test - 1]
    if since is not None and test > 1 and not part.label.startswith(SHEET):
        end, begin = (read_table(one, (since,)).values[place, 0] for one, place in ((parts[test - 2], -1), (part, 0)))
        if begin >= end:
            raise InvalidInput(
                f"{part}: its time begins at {begin:.4g} s, where test {test - 1} ends, and is not that since its own "
                "step; save it by itself, with time and response from that step on."
            )
    return read(part)


def _tests_of_sheets(path: str | os.PathLike[str], headers: Sequence[Sequence[Column]]) -> list[TablePart]:
    """Return the tests of all sheets of a workbook that name the same columns, or those of a text."""
    for columns in headers:
        sheets = sheets_naming(path, columns)
        if len(sheets) > 1:
            parts = [(sheet, parts_of_table(sheet, headers)) for sheet in sheets]
            return [one if len(of_sheet) > 1 else sheet for sheet, of_sheet in parts for one in of_sheet]
        if sheets:
            break
    return parts_of_table(path, headers)


def parts_of_table(
    path: str | os.PathLike[str], headers: Sequence[Sequence[Column]], *, below: bool = True
) -> list[TablePart]:
    """Return the tests of a table; one if there is only one, or no header.

    Parameters
    ----------
    path : str or path
    headers : sequence of sequences of Column
        Columns that may name a table, the first that do.
    below : bool, optional
        Whether tests below each other are parted, too.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds more tests than are read.
    """
    for columns in headers:
        names = _names(table_head(path, needs_of(columns), columns), columns)
        if names is not None:
            lines = table_lines(path, needs_of(columns), columns)
            parts = _side_by_side(path, lines, names) or (_below_each_other(path, lines, names) if below else [])
            return parts or [TablePart(str(path), tuple(lines))]
    return [TablePart(str(path), tuple(table_lines(path, "a header, and numbers below")))]


def _refuse_many(path: str | os.PathLike[str], count: int, is_large: bool) -> None:
    if count > MOST_TESTS or is_large:
        raise InvalidInput(f"{path}: it holds {count} tests, too many or too long to be read from one table; split it.")


def _names(lines: Sequence[str], columns: Sequence[Column]) -> _Names | None:
    for index, line in enumerate(lines):
        text = line.lstrip(COMMENT_MARKS).rstrip("\r\n")
        for separator in SEPARATORS_TRIED if text.strip() else ():
            cells = tuple(_plain(cell) for cell in cells_of(text, separator))
            places = tuple(
                tuple(place for place, cell in enumerate(cells) if cell and named(cell, column.names)[0])
                for column in columns
            )
            if all(places):
                return _Names(index, separator, cells, places)
    return None


@functools.lru_cache(maxsize=4096)
def _plain(cell: str) -> str:
    """Return a name without the temperature in it and what pandas puts behind it."""
    return SUFFIX.sub("", " ".join(TEMPERATURE.sub(" ", " ".join(cell.split())).split()))


def _temperature(cells: Sequence[str]) -> float:
    """Return the first temperature [K] in some cells; nan if there is none."""
    for cell in cells:
        if (match := TEMPERATURE.search(" ".join(cell.split()))) is not None:
            unit = match[2].replace("º", "°")
            return float(match[1].replace(",", ".")) + zero_of(unit, "K")
    return math.nan


def _side_by_side(path: str | os.PathLike[str], lines: Sequence[str], names: _Names) -> list[TablePart]:
    """Return the groups of columns in which all names stand again; none if they do not."""
    counts = {len(places) for places in names.places} - {1}
    alike = all(len({names.cells[place].lower() for place in places}) == 1 for places in names.places)
    if len(counts) != 1 or not alike or len(names.places[-1]) == 1 or len(names.places[-2]) == 1:
        return []
    count = counts.pop()
    _refuse_many(path, count, sum(map(len, lines)) > MOST_LETTERS)
    shared = [places[0] for places in names.places if len(places) == 1]
    groups = [sorted(places[number] for places in names.places if len(places) > 1) for number in range(count)]
    lead = _lead(names.cells, groups)
    begins = [min(group) - lead for group in groups]
    ends = [*begins[1:], len(names.cells)]
    apart = all(max(group) < end for group, end in zip(groups, ends, strict=True))
    first = max(names.line - ROWS_ABOVE, 0)
    above = [cells_of(line.lstrip(COMMENT_MARKS), names.separator) for line in lines[first : names.line]]
    own = cells_of(lines[names.line].lstrip(COMMENT_MARKS).rstrip("\r\n"), names.separator)
    mark = names.separator or "\t"
    rows = [cells_of(line, names.separator) if line.strip() else [] for line in lines[names.line + 1 :]]
    parts = []
    for group, begin, end in zip(groups, begins, ends, strict=True):
        chosen = [*shared, *(range(begin, end) if apart else group)]
        warm = _temperature([own[place] for place in chosen if place not in shared])
        if math.isnan(warm) and apart:
            warm = _temperature([cell for row in reversed(above) for cell in row[begin:end]])
        taken = [mark.join(row[place] if place < len(row) else "" for place in chosen) for row in rows]
        header = mark.join(names.cells[place] for place in chosen)
        label = f"columns {min(group) + 1} to {max(group) + 1}" + f", {warm:g} K" * math.isfinite(warm)
        parts.append(TablePart(str(path), (*[""] * names.line, header, *taken), label, warm))
    return parts


def _lead(cells: Sequence[str], groups: Sequence[Sequence[int]]) -> int:
    """Return how many columns before each group belong to it: their names stand before all groups, and in none."""
    lead = 0
    ends = [-1, *(max(group) for group in groups[:-1])]
    while all(
        min(group) - lead - 1 > end and cells[min(group) - lead - 1].lower() == cells[min(groups[0]) - lead - 1].lower()
        for group, end in zip(groups, ends, strict=True)
    ):
        lead += 1
    return lead


def _begun_again(rows: list[int], lines: Sequence[str], names: _Names) -> list[list[int]]:
    """Return the rows of each test where the first named column, of times or frequencies, begins again at its first."""
    place, numbers = names.places[0][0], list[float]()
    for index in rows:
        cell = cells_of(lines[index], names.separator)[place]
        numbers.append(float(cell.replace(",", ".")) if is_number(cell.replace(",", ".")) else math.nan)
    begins = [0]
    for index, number in enumerate(numbers):
        back = abs(number - numbers[begins[-1]]) <= SAME_START * abs(number)
        if back and index - begins[-1] >= FEWEST_AGAIN and number != numbers[index - 1]:
            begins.append(index)
    return [rows[first:end] for first, end in zip(begins, [*begins[1:], len(rows)], strict=True)]


def _below_each_other(path: str | os.PathLike[str], lines: Sequence[str], names: _Names) -> list[TablePart]:
    """Return the tests below each other; none if there is one."""
    head = lines[names.line].strip()
    wanted = [places[0] for places in names.places]
    counts = names.cells[0].lower() in COUNTERS or (len(names.cells) > 1 and names.cells[1].lower() in COUNTERS)
    counter = 0 if names.cells[0].lower() in COUNTERS else 1
    tests: list[list[int]] = [[]]
    before = math.inf
    for index in range(names.line + 1, len(lines)):
        if lines[index].strip() == head:
            tests.append([])
            before = math.inf
            continue
        cells = cells_of(lines[index], names.separator)
        numbers = [place < len(cells) and like_number(cells[place]) for place in wanted]
        if not numbers[-1] or sum(numbers) < min(FEWEST_NUMBERS, len(numbers)):
            continue
        if counts and cells[counter].isdecimal():
            number = int(cells[counter]) if len(cells[counter]) < 10 else math.inf
            if number == 1 and before < math.inf and tests[-1]:
                tests.append([])
            before = number
        tests[-1].append(index)
    tests = [rows for rows in tests if rows]
    if len(tests) == 1:
        tests = _begun_again(tests[0], lines, names)
    if len(tests) < 2:
        return []
    _refuse_many(path, len(tests), len(tests) * len(lines) > MOST_LINES)
    top = (*[""] * names.line, *lines[names.line : tests[0][0]])
    return [
        TablePart(
            str(path),
            (*top, *[""] * (rows[0] - len(top)), *_only(lines, rows)),
            f"lines {rows[0] + 1} to {rows[-1] + 1}",
        )
        for rows in tests
    ]


def _only(lines: Sequence[str], rows: list[int]) -> list[str]:
    """Return the lines from the first to the last of some rows, the others empty."""
    kept = set(rows)
    return [lines[index] if index in kept else "" for index in range(rows[0], rows[-1] + 1)]
