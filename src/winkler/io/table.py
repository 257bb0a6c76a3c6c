r"""Tables of measured numbers.

A table is a text file (UTF-8, or Latin-1 as older instruments write it) with one row of numbers per line; cells are
separated by tabs, semicolons, commas or spaces.  Above the numbers stands a header that names columns and units::

    # tip 7, scanned 2024-05-02            lines above the header and behind # are not read
    radius [um], height [nm]               or  r (um);f (nm)  or  radius_um  height_nm  or a row of units below

Nothing is guessed or left out silently: what cannot be read is refused with its line.
"""

from __future__ import annotations

import math
import os
import re
from array import array
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from winkler.content import LARGEST
from winkler.errors import InvalidInput
from winkler.io.text_file import lines_of
from winkler.numerics.types import Array
from winkler.units import comma_hint, comma_readings, scale
from winkler.values import value

__all__ = ["Column", "Table", "names_columns", "read_table"]

ABOVE = 500
"""Most lines above the numbers."""
SEPARATORS = ("\t", ";", ",", None)
COMMENT = "#% \t"
MISSING = frozenset({"", "nan", "na", "n/a", "-", "--", "none", "null", "inf", "-inf", "+inf", "infinity", "-infinity"})
NAME_AND_UNIT = (
    r"(.+?)\s*[\[(]([^\])]*)[\])]",
    r"(.+?)\s*/\s*(.+)",
    r"(.+?)\s+in\s+(\S+)",
    r"(.+)_([^_]+)",
    r"(\S+)\s+(\S+)",
)


@value
class Column:
    """A column that is wanted from a table.

    Parameters
    ----------
    word : str
        What it is, for messages.
    names : tuple of str
        Names in the header by which it is known, in lower case.
    unit : str
        SI unit in which it is wanted; empty for a plain number, which needs no unit in the header.
    usual : str, optional
        A unit that people write, for messages; the SI unit unless given.
    """

    word: str
    names: tuple[str, ...]
    unit: str
    usual: str = ""

    @property
    def example(self) -> str:
        """How it may stand in a header."""
        unit = self.usual or self.unit
        return f"{self.names[0]} [{unit}]" if unit else self.names[0]


@value
class Table:
    """Columns read from a file.

    Parameters
    ----------
    path : str
        The file.
    values : ndarray, (rows, columns)
        Numbers in SI units, in the order in which the columns were asked for.
    lines : ndarray, (rows,)
        The line of the file, counted from 1, on which each row stands.
    """

    path: str
    values: Array
    lines: Array


class _Header(NamedTuple):
    line: int
    separator: str | None
    cells: tuple[str, ...]
    places: tuple[int, ...]
    units: tuple[str, ...]


def read_table(path: str | os.PathLike[str], columns: Sequence[Column]) -> Table:
    """Read columns of numbers from a text file with a header.

    Parameters
    ----------
    path : str or path
        The file.
    columns : sequence of Column
        What is wanted; each must be found once, with a unit that fits.

    Returns
    -------
    Table

    Raises
    ------
    InvalidInput
        If the file cannot be read; the message names the line.
    """
    shown = str(path)
    lines = _lines(path, columns)
    header = _header(lines, columns, shown)
    separator = _separator(lines, header)
    numbers, places, absent = array("d"), array("d"), list[int]()
    for index in range(header.line, len(lines)):
        line = lines[index].partition("#")[0]
        if not line.strip():
            continue
        cells = _cells(line, separator)
        while len(cells) > len(header.cells) and not cells[-1]:
            cells.pop()
        if len(cells) != len(header.cells):
            hint = "; if commas mark decimals or group thousands, write 1.5 and 1000" if "," in line else ""
            size = f"the line has {len(cells)} and the header {len(header.cells)} cells"
            raise InvalidInput(f"{shown}, line {index + 1}: {size}{hint}.")
        try:
            if "_" in line:
                raise ValueError("float() reads 1_000")
            row = [float(cells[place]) for place in header.places]
        except ValueError:
            row = [_number(cells[place], f"{shown}, line {index + 1}", header.cells[place]) for place in header.places]
        if not all(map(math.isfinite, row)):
            absent.append(index + 1)
        numbers.extend(row)
        places.append(index + 1)
    if absent:
        listed = ", ".join(map(str, absent[:5])) + (f" and {len(absent) - 5} more" if len(absent) > 5 else "")
        few = "line" if len(absent) == 1 else "lines"
        raise InvalidInput(f"{shown}: {few} {listed}: a number is missing or not finite; complete or delete the {few}.")
    if not places:
        raise InvalidInput(f"{shown}: there are no numbers below the header in line {header.line}.")
    factors = np.array([scale(column.unit, unit) for column, unit in zip(columns, header.units, strict=True)])
    with np.errstate(over="ignore"):
        values = np.array(numbers).reshape(-1, len(columns)) / factors
    computable = np.all(np.abs(values) <= LARGEST, axis=1)
    if not np.all(computable):
        place = places[int(np.argmin(computable))]
        raise InvalidInput(f"{shown}, line {place}: a number is too large to be computed with in SI units; check it.")
    return Table(shown, values, np.array(places))


def names_columns(path: str | os.PathLike[str], columns: Sequence[Column]) -> bool:
    """Return whether the header of a table names all of these columns.

    Parameters
    ----------
    path : str or path
        The file.
    columns : sequence of Column
        What is looked for.

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    lines = _lines(path, columns)[:ABOVE]
    texts = [line.lstrip(COMMENT).rstrip() for line in lines if _may_name(line.lower(), columns)]
    rows = [_cells(text, separator) for text in texts if text for separator in SEPARATORS]
    return any(all(any(_named(cell, column)[0] for cell in cells) for column in columns) for cells in rows)


def _may_name(line: str, columns: Sequence[Column]) -> bool:
    """Return whether a line holds the letters of every column's name; rows of numbers are told quickly."""
    return all(any(name in line for name in column.names) for column in columns)


def _example(columns: Sequence[Column]) -> str:
    return ", ".join(column.example for column in columns)


def _lines(given: str | os.PathLike[str], columns: Sequence[Column]) -> list[str]:
    return lines_of(given, f"a header such as '{_example(columns)}', and numbers below")


def _cells(line: str, separator: str | None) -> list[str]:
    if separator is not None:
        return [cell.strip(" \t\"'") for cell in line.split(separator)]
    # a unit in brackets belongs to the name before it
    return re.findall(r"[^\s\[(]+(?:\s*[\[(][^\])]*[\])])?", line) if "[" in line or "(" in line else line.split()


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell


def _like_number(cell: str) -> bool:
    return _is_number(cell) or any(map(_is_number, comma_readings(cell)))


def _number(cell: str, where: str, column: str) -> float:
    if _is_number(cell):
        return float(cell)
    if cell.lower() in MISSING:
        return float("nan")
    if _like_number(cell):
        raise InvalidInput(f"{where}: '{cell}' has {comma_hint(cell)}.")
    raise InvalidInput(f"{where}: '{cell[:40]}' in the column '{column}' is not a number.")


def _named(cell: str, column: Column) -> tuple[bool, str]:
    """Return whether a cell of the header names the column, and the unit behind the name if there is one."""
    for pattern in NAME_AND_UNIT:
        match = re.fullmatch(pattern, cell)
        if match and match[1].lower() in column.names:
            return True, match[2].strip(" -")
    return cell.lower() in column.names, ""


def _header(lines: Sequence[str], columns: Sequence[Column], shown: str) -> _Header:
    """Return the first line in which every column is named."""
    for index, line in enumerate(lines[:ABOVE]):
        text = line.lstrip(COMMENT).rstrip()
        for separator in SEPARATORS if text else ():
            cells = _cells(text, separator)
            found = [[p for p, cell in enumerate(cells) if _named(cell, column)[0]] for column in columns]
            if not all(found):
                continue
            found = [
                _fitting(cells, places, column) if len(places) > 1 else places
                for column, places in zip(columns, found, strict=True)
            ]
            for column, places in zip(columns, found, strict=True):
                if len(places) > 1:
                    listed = " and ".join(f"'{cells[place]}'" for place in places)
                    raise InvalidInput(
                        f"{shown}, line {index + 1}: {listed} may each be the {column.word}; rename all but one."
                    )
            units = tuple(_named(cells[places[0]], column)[1] for column, places in zip(columns, found, strict=True))
            header = _Header(index + 1, separator, tuple(cells), tuple(places[0] for places in found), units)
            return _with_units(header, lines, columns, shown)
    raise InvalidInput(f"{shown}: {_without_header(lines, columns)}.")


def _fitting(cells: Sequence[str], places: list[int], column: Column) -> list[int]:
    """Return the places whose unit fits, if there is one such: instruments repeat a depth in m and in volts."""
    fitting = []
    for place in places:
        try:
            scale(_named(cells[place], column)[1], column.unit)
        except InvalidInput:
            continue
        fitting.append(place)
    return fitting if len(fitting) == 1 else places


def _with_units(header: _Header, lines: Sequence[str], columns: Sequence[Column], shown: str) -> _Header:
    """Take units that are not in the header from the row below it, and check that all fit."""
    where = f"{shown}, line {header.line}"
    needs = [bool(column.unit) for column in columns]
    given = zip(header.places, header.units, needs, strict=True)
    bare = [header.cells[place] for place, unit, need in given if need and not unit]
    if bare:
        below = _cells(lines[header.line].lstrip(COMMENT), header.separator) if header.line < len(lines) else []
        wanted = [below[place].strip("[]() ") for place in header.places] if len(below) == len(header.cells) else []
        missing = [need and (not unit or _like_number(unit)) for unit, need in zip(wanted, needs, strict=False)]
        if not wanted or any(missing):
            listed = " and ".join(f"'{name}'" for name in bare)
            example = _example(columns)
            raise InvalidInput(f"{where}: no unit stands with {listed}; write it in the header, as '{example}'.")
        header = header._replace(line=header.line + 1, units=tuple(wanted))
        where = f"{shown}, line {header.line}"
    plain = tuple(unit if need else unit.strip("-") for unit, need in zip(header.units, needs, strict=True))
    for column, unit in zip(columns, plain, strict=True):
        scale(unit, column.unit, what=f"{where}, {column.word}")
    return header._replace(units=plain)


def _without_header(lines: Sequence[str], columns: Sequence[Column]) -> str:
    """Return why no header was found."""
    example = _example(columns)
    above: list[str] = []
    for index, line in enumerate(lines[:ABOVE]):
        text = line.lstrip(COMMENT).rstrip()
        splits = [_cells(text, separator) for separator in SEPARATORS]
        if text == line.strip() and any(
            any(cells) and all(_like_number(cell) for cell in cells if cell) for cells in splits
        ):
            if not above:
                return f"numbers begin in line {index + 1} without a header above them; write one, as '{example}'"
            break
        if text:
            above = next((cells for cells in splits if len(cells) > 1), [text])
    missing = [column for column in columns if not any(_named(cell, column)[0] for cell in above)]
    wanted = " and no ".join(f"{column.word} ({', '.join(column.names)})" for column in missing)
    listed = ", ".join(f"'{cell[:40]}'" for cell in above[:20] if cell)
    return f"the header has no {wanted}, there are {listed}; name the columns, as in '{example}'"


def _separator(lines: Sequence[str], header: _Header) -> str | None:
    """Return what separates the cells of the numbers: as in the header, or otherwise if the first row says so."""
    first = next((line for line in lines[header.line :] if line.partition("#")[0].strip()), "")
    for separator in (header.separator, *SEPARATORS):
        cells = _cells(first.partition("#")[0], separator)
        if len(cells) == len(header.cells) and all(_is_number(cells[place]) for place in header.places):
            return separator
    return header.separator
