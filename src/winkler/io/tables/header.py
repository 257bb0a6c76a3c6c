"""The header of a table: which line names the columns, which units they have, and what separates the cells."""

from __future__ import annotations

import functools
import os
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from winkler.io.tables.column import Column, example_of
from winkler.io.tables.given_units import filled_units, refuse_contradiction
from winkler.io.tables.table_cells import cells_of, is_number, like_number, named, unit_in
from winkler.io.tables.table_lines import table_head
from winkler.values.errors import InvalidInput
from winkler.values.units import scale

SEPARATORS_TRIED = ("\t", ";", ",", None)
LEAST_TABS = 2
"""Tabs within a line from which on its names are apart by them, and may hold spaces."""
CELSIUS, CELSIUS_ZERO = ("degC", "°C", "deg C", "C"), 273.15
"""Units of a temperature in degrees Celsius; of another quantity C is the coulomb."""
PER_CENT = "%"
"""Unit of a part that stands in per cent or as a plain number, and must say which: as "-" where it is the number."""
PER_SECOND = ("1/s", "s-1", "s^-1")
"""Units in which an angular frequency is written too: its name says that it counts radians."""
WEIGHED = ("g", "kg", "lb")
"""Units in which some instruments write a force: its weight, gf, kgf and lbf."""
COMMENT_MARKS = "#% \t"
MOST_BETWEEN = 3
"""Most rows between the names and their units: empty, or such as "Waveform"."""
MOST_ALIKE = 3
"""Most columns of one name that a message lists."""
LONGEST_UNIT = 12
MOSTLY = 0.6
"""Least share of numbers in a row of them."""
NO_NUMBERS = re.compile(r"[^\d\s.,;eE+-]", re.ASCII)
NAME_LETTER = re.compile(r"[^\W\d_eE]")
"""A letter other than that of an exponent: rows of numbers have none."""


class Header(NamedTuple):
    """Line counted from 1, separator, cells, the places and units of the columns asked for, and what each repeats.

    Instruments write a time or a temperature again before a later group of columns: `twins` are the places of such a
    column with the same name, whose numbers must be the same.
    """

    line: int
    separator: str | None
    cells: tuple[str, ...]
    places: tuple[int, ...]
    units: tuple[str, ...]
    twins: tuple[tuple[int, ...], ...] = ()


def names_columns(
    path: str | os.PathLike[str], columns: Sequence[Column], *, head: Sequence[str] | None = None
) -> bool:
    """Return whether the header of a table names all of these columns.

    Parameters
    ----------
    path : str or path
        The file.
    columns : sequence of Column
        The columns.
    head : sequence of str, optional
        Lines among which its header stands, where they are known; see `header_lines`.

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    lines = table_head(path, needs_of(columns), columns) if head is None else head
    texts = [
        line.lstrip(COMMENT_MARKS).rstrip()
        for line in lines
        if NAME_LETTER.search(line) and _may_name(line.lower(), columns)
    ]
    rows = [cells_of(text, separator) for text in texts if text for separator in _separators(text)]
    return any(all(any(named(cell, column.names)[0] for cell in cells) for column in columns) for cells in rows)


def header_lines(path: str | os.PathLike[str], columns: Sequence[Column]) -> list[str]:
    """Return the lines that may be the header of a table: those among the first that are no row of numbers.

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    return list(_without_numbers(tuple(table_head(path, needs_of(columns), columns))))


@functools.lru_cache(maxsize=4)  # each kind of table that is tried asks for it
def _without_numbers(lines: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(line for line in lines if NO_NUMBERS.search(line))


def _separators(text: str) -> tuple[str | None, ...]:
    """Return what may separate the names of a header: no space where tabs do."""
    return SEPARATORS_TRIED[:-1] if text.strip().count("\t") >= LEAST_TABS else SEPARATORS_TRIED


def _may_name(line: str, columns: Sequence[Column]) -> bool:
    """Return whether a line holds the letters of every column's name; rows of numbers are excluded quickly."""
    return all(any(part in line for part in _first_parts(column.names)) for column in columns)


@functools.lru_cache(maxsize=256)
def _first_parts(names: tuple[str, ...]) -> frozenset[str]:
    """Return the first word of each name: behind it may stand a hyphen, a space or a low line."""
    return frozenset(re.split(r"[ _-]", name, maxsplit=1)[0] for name in names)


def needs_of(columns: Sequence[Column]) -> str:
    """Return what a file of such a table must hold, for messages."""
    return f"a header such as '{example_of(columns)}', and numbers below"


def header_of(lines: Sequence[str], columns: Sequence[Column], file: str, given: Mapping[str, str] | None) -> Header:
    """Return the first line in which every column is named; one behind a comment mark only if there is no other."""
    for index, line in sorted(enumerate(lines), key=lambda numbered: numbered[1].lstrip()[:1] in ("#", "%")):
        if not NAME_LETTER.search(line) or not _may_name(line.lower(), columns):
            continue
        text = _names_of(line, lines[index + 1 :])
        for separator in _separators(text):
            cells = cells_of(text, separator)
            candidates = [[p for p, cell in enumerate(cells) if named(cell, column.names)[0]] for column in columns]
            if not all(candidates):
                continue
            candidates = [
                _fitting(cells, places, column) if len(places) > 1 else places
                for column, places in zip(columns, candidates, strict=True)
            ]
            twins = tuple(tuple(places) for places in candidates)
            for column, places in zip(columns, twins, strict=True):
                if len({cells[place] for place in places}) > 1:
                    raise either(cells, places, column, twins, columns, f"{file}, line {index + 1}", given)
            units = tuple(
                named(cells[places[0]], column.names)[1] for column, places in zip(columns, candidates, strict=True)
            )
            header = Header(index + 1, separator, tuple(cells), tuple(places[0] for places in twins), units, twins)
            return _with_units(header, lines, columns, file, given)
    raise InvalidInput(f"{file}: {_without_header(lines, columns)}.")


def either(
    cells: Sequence[str],
    places: Sequence[int],
    column: Column,
    all_places: Sequence[Sequence[int]],
    columns: Sequence[Column],
    where: str,
    given: Mapping[str, str] | None,
) -> InvalidInput:
    """Return the error that several columns may each be the one asked for.

    Parameters
    ----------
    cells : sequence of str
        The header.
    places : sequence of int
        Of the columns that may be meant.
    column : Column
        What is asked for.
    all_places, columns : sequences
        The places of every column asked for.
    where : str
        File and line.
    given : mapping, optional
        Units that are given; None where the caller takes no numbers of columns.
    """
    listed = " and ".join(f"'{cells[place]}' (column {place + 1})" for place in places[:MOST_ALIKE])
    listed += f" and {len(places) - MOST_ALIKE} more" if len(places) > MOST_ALIKE else ""
    counted = ", ".join(f"{one.word} = {all_of[0] + 1}" for one, all_of in zip(columns, all_places, strict=True))
    remedy = "" if given is None else f", or give columns, such as columns = {{ {counted} }}"
    return InvalidInput(f"{where}: {listed} may each be the {column.word}; rename all but one{remedy}.")


def _names_of(line: str, below: Sequence[str]) -> str:
    """Return a header without its comment mark; with an empty first name, as of numbered rows, where rows have one."""
    if line.startswith("\t"):
        first = next((one for one in below if one.strip() and not NAME_LETTER.search(one)), "")
        if first.count("\t") >= line.rstrip().count("\t"):
            return line.rstrip()
    return line.lstrip(COMMENT_MARKS).rstrip()


def placed_header(
    lines: Sequence[str],
    columns: Sequence[Column],
    numbers: Mapping[str, int],
    file: str,
    given: Mapping[str, str] | None,
) -> Header:
    """Return the header of a table whose columns are given by their numbers, counted from 1.

    Names, and units in brackets behind them, are those of the row above the first numbers, if it has as many cells.

    Raises
    ------
    InvalidInput
        If no line has numbers in these columns, or a unit is missing.
    """
    places = tuple(numbers[column.word] - 1 for column in columns)
    for index, line in enumerate(lines):
        for separator in SEPARATORS_TRIED:
            row = cells_of(line.partition("#")[0].strip("\r\n "), separator)
            if len(row) <= max(places) or not all(like_number(row[place]) for place in places):
                continue
            above = next((text for text in reversed(lines[:index]) if text.strip()), "")
            names = cells_of(above.lstrip(COMMENT_MARKS).rstrip(), separator)
            if len(names) != len(row):
                names = [f"column {place + 1}" for place in range(len(row))]
            stated = [unit_in(names[place], column.unit) for place, column in zip(places, columns, strict=True)]
            header = Header(index, separator, tuple(names), places, tuple(stated))
            units = filled_units(stated, names, places, columns, given or {}, file)
            for column, unit in zip(columns, units, strict=True):
                if column.unit:
                    scale(unit, column.unit, what=f"{file}, {column.word}")
                    refuse_contradiction(column, unit, given, file)
            return header._replace(units=units)
    wanted = ", ".join(f"{column.word} in column {place + 1}" for column, place in zip(columns, places, strict=True))
    raise InvalidInput(f"{file}: no line has numbers for {wanted}; count the columns from 1.")


def stated_header(lines: Sequence[str], columns: Sequence[Column], text: str, file: str) -> Header:
    """Return the header that a caller states as the names of all columns, such as "omega [rad/s], g' [Pa], g'' [Pa]".

    Raises
    ------
    InvalidInput
        If it does not name the columns with units, or no line has as many numbers.
    """
    stated = header_of([text], columns, f"header = {text!r}", None)
    for index, line in enumerate(lines):
        for separator in SEPARATORS_TRIED:
            row = cells_of(line.partition("#")[0].strip("\r\n "), separator)
            if len(row) >= len(stated.cells) and all(like_number(row[place]) for place in stated.places):
                cells = (*stated.cells, *[""] * (len(row) - len(stated.cells)))
                return stated._replace(line=index, separator=separator, cells=cells)
    raise InvalidInput(f"{file}: no line has numbers for the columns of header = {text!r}; name those of the file.")


def _fitting(cells: Sequence[str], places: list[int], column: Column) -> list[int]:
    """Return the places whose unit fits, or else those without a unit, if there is one such.

    Instruments repeat a depth in m and in volts; and "Storage Compliance" is no storage in a unit of "Compliance".  Of
    several that fit, the one with the foremost name is meant; of t and T, which have one name, the one in its own case.
    """
    if column.foremost:
        first = [place for place in places if named(cells[place], (column.foremost,))[0]]
        places = first if len(first) == 1 else places
    if all(len(cells[place]) == 1 for place in places):
        own = [place for place in places if cells[place] in column.names]
        places = own if len(own) == 1 else places
    fitting, bare = [], []
    for place in places:
        unit = named(cells[place], column.names)[1]
        if not unit:
            bare.append(place)
            continue
        try:
            if not zero_of(unit, column.unit):
                scale(unit, column.unit)
        except InvalidInput:
            continue
        fitting.append(place)
    return next((chosen for chosen in (fitting, bare) if len(chosen) == 1), places)


def _with_units(
    header: Header, lines: Sequence[str], columns: Sequence[Column], file: str, given: Mapping[str, str] | None
) -> Header:
    """Take units that are not in the header from a row below it or from those given, and check that all fit."""
    where = f"{file}, line {header.line}"
    needs = [bool(column.unit) for column in columns]
    stated_units = zip(header.places, header.units, needs, strict=True)
    bare = [header.cells[place] for place, unit, need in stated_units if need and not unit]
    if bare:
        wanted, skipped = _units_below(lines, header, needs)
        if wanted:
            header = header._replace(line=header.line + 1 + skipped, units=tuple(wanted))
            where = f"{file}, line {header.line}"
        else:
            header = header._replace(
                units=filled_units(header.units, header.cells, header.places, columns, given, where)
            )
    plain = tuple(unit if need else unit.strip("-") for unit, need in zip(header.units, needs, strict=True))
    plain = tuple(
        "1" if column.unit == PER_CENT and unit == "-" else unit for column, unit in zip(columns, plain, strict=True)
    )
    plain = tuple(
        "rad/s" if column.word.startswith("angular") and unit in PER_SECOND else unit
        for column, unit in zip(columns, plain, strict=True)
    )
    plain = tuple(
        f"{unit}f" if column.unit == "N" and unit in WEIGHED else unit
        for column, unit in zip(columns, plain, strict=True)
    )
    for column, unit in zip(columns, plain, strict=True):
        if not zero_of(unit, column.unit):
            scale(unit, column.unit, what=f"{where}, {column.word}")
        refuse_contradiction(column, unit, given, where)
    return header._replace(units=plain)


def _units_below(lines: Sequence[str], header: Header, needs: Sequence[bool]) -> tuple[list[str], int]:
    """Return the units in a row below the header, and how many rows lie between: empty ones, or of other words."""
    for skipped in range(MOST_BETWEEN + 1):
        if header.line + skipped >= len(lines):
            break
        line = lines[header.line + skipped]
        splits = [cells_of(line.lstrip(marks), header.separator) for marks in (COMMENT_MARKS, " ")]
        cells = next((cells for cells in splits if len(cells) == len(header.cells)), splits[-1])
        if len(cells) != len(header.cells):
            if any(cells):
                break
            continue
        units = [cells[place].strip("[]() ") for place in header.places]
        if any(like_number(unit) for unit in units if unit):
            break
        if all(unit or not need for unit, need in zip(units, needs, strict=True)):
            return units, skipped
    return [], 0


def _are_units(cells: Sequence[str]) -> bool:
    """Return whether a row holds units alone, such as the row below the names."""

    def known(cell: str) -> bool:
        try:
            scale(cell, cell)
        except InvalidInput:
            return cell in CELSIUS
        return True

    texts = [cell.strip("[]() ") for cell in cells if cell.strip("[]()- ")]
    return bool(texts) and all(len(text) <= LONGEST_UNIT and known(text) for text in texts)


def bare_columns(path: str | os.PathLike[str]) -> int:
    """Return the number of cells in the first row of numbers of a text or a sheet; zero of other files."""
    try:
        lines = table_head(path, "numbers")
    except InvalidInput:
        return 0
    rows = (cells_of(line.strip(), separator) for line in lines for separator in SEPARATORS_TRIED if line.strip())
    return next((len(row) for row in rows if len(row) > 1 and all(map(like_number, row))), 0)


def names_seen(path: str | os.PathLike[str], columns: Sequence[Column]) -> str:
    """Return the row of names above the first numbers of a file, as a phrase; empty if there is none.

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    above, _ = _names_above(table_head(path, needs_of(columns), columns))
    listed = ", ".join(f"'{cell[:40]}'" for cell in above[:20] if cell)
    return f", whose columns are {listed}" if listed else ""


def _names_above(lines: Sequence[str]) -> tuple[list[str], int]:
    """Return the names above the first row of numbers, and the place of that row; the number of lines without one."""
    above: list[str] = []
    for index, line in enumerate(lines):
        text = line.lstrip(COMMENT_MARKS).rstrip()
        splits = [cells_of(text, separator) for separator in SEPARATORS_TRIED]
        if text == line.strip() and any(_are_numbers([cell for cell in cells if cell]) for cells in splits):
            return above, index
        if text:
            row = next((cells for cells in splits if len(cells) > 1), [text])
            if not above or not (_are_units(row) or len(row) == 1 < len(above)):  # a single word ends the header
                above = row
    return above, len(lines)


def _are_numbers(cells: Sequence[str]) -> bool:
    """Return whether a row holds numbers, perhaps with a label among them, such as the one of an interval."""
    count = sum(map(like_number, cells))
    return bool(cells) and (count == len(cells) or count > max(2.0, MOSTLY * len(cells)))


def _without_header(lines: Sequence[str], columns: Sequence[Column]) -> str:
    """Return why no header was found."""
    example = example_of(columns)
    above, index = _names_above(lines)
    if not above and index < len(lines):
        return f"numbers begin in line {index + 1} without a header above them; write one, as '{example}'"
    missing = [column for column in columns if not any(named(cell, column.names)[0] for cell in above)]
    wanted = " and no ".join(f"{column.word} ({', '.join(column.names)})" for column in missing)
    listed = ", ".join(f"'{cell[:40]}'" for cell in above[:20] if cell)
    return f"the header has no {wanted}, there are {listed}; name the columns, as in '{example}'"


def separator_of(lines: Sequence[str], header: Header) -> str | None:
    """Return the separator of the numbers: that of the header, or another one if it fits the first row."""
    first = next((line for line in lines[header.line :] if line.partition("#")[0].strip()), "")
    for separator in (header.separator, *SEPARATORS_TRIED):
        cells = cells_of(first.partition("#")[0], separator)
        fits = like_number if separator == header.separator else is_number  # 0,5;1;2,5 has three cells by commas, too
        if len(cells) == len(header.cells) and all(fits(cells[place]) for place in header.places):
            return separator
    return header.separator


def zero_of(unit: str, wanted: str) -> float:
    """Return the zero of degC [K] where a column holds temperatures; of other units nothing."""
    return CELSIUS_ZERO if wanted == "K" and unit in CELSIUS else 0.0
