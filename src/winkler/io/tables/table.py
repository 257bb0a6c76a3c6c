r"""Tables of measured numbers.

A table is a text file (UTF-8, or Latin-1 as older instruments write it) with one row of numbers per line; cells are
separated by tabs, semicolons, commas or spaces.  Above the numbers stands a header that names columns and units::

    # tip 7, scanned 2024-05-02            lines above the header and behind # are not read
    radius [um], height [nm]               or  r (um);f (nm)  or  radius_um  height_nm  or a row of units below

Nothing is guessed or left out silently: what cannot be read is refused with its line.
"""

from __future__ import annotations

import math
import operator
import os
import re
from array import array
from collections.abc import Mapping, Sequence

import numpy as np

from winkler.io.tables.column import Column
from winkler.io.tables.decimal_commas import DecimalCommas
from winkler.io.tables.header import (
    Header,
    either,
    header_of,
    needs_of,
    placed_header,
    separator_of,
    stated_header,
    zero_of,
)
from winkler.io.tables.table_cells import cells_of, like_number, number_in
from winkler.io.tables.table_lines import table_lines
from winkler.io.text_file import headed
from winkler.numerics.types import Array
from winkler.values.checks.physical_size import LARGEST_NUMBER
from winkler.values.errors import InvalidInput
from winkler.values.units import scale
from winkler.values.value import value

__all__ = ["HEADER_AGAIN", "Column", "Table", "read_table"]


PADDED = ("\t", ";")
"""Separators behind which programs leave out empty cells at the end of a row; a comma may be a decimal one."""
PLAIN, ENDS = b"0123456789eE.+- \t\n", frozenset("0123456789.")
"""Letters of rows of plain numbers beside the separator, no mark of a comment among them; and the last one of a row."""
LAST = operator.itemgetter(slice(-1, None))
MARK = re.compile(r"<[A-Za-z /]{1,40}>")
"""A line by which some instruments end a block of numbers."""
END_OF_HEADER = re.compile(r"[A-Za-z*_-]{1,40}")
"""A single word by which some instruments end the header,"""
MOST_FOOTER = 5
"""Lines of words that may stand behind the last row and a blank line."""
HEADER_AGAIN = "the header stands again"
"""Of a table that is several."""
FIRST_ROWS = 2
"""and the number of rows above which it may stand."""


@value
class Table:
    """Columns read from a file.

    Parameters
    ----------
    path : str
        The file.
    values : ndarray, (rows, columns)
        Numbers in SI units, in the order of the requested columns.
    lines : ndarray, (rows,)
        The line of the file, counted from 1, on which each row stands.
    read_as : tuple of str
        Name and unit of each column as they stand in the header, such as "Load [uN]".
    numbers : tuple of int
        Number of each column in the file, counted from 1.
    repeats : tuple of int
        Lines on which the header stands again.
    """

    path: str
    values: Array
    lines: Array
    read_as: tuple[str, ...] = ()
    numbers: tuple[int, ...] = ()
    repeats: tuple[int, ...] = ()


def _plain_rows(lines: Sequence[str], separator: str | None, count: int, wanted: Sequence[int]) -> Array | None:
    """Return the wanted numbers of rows that all hold so many plain numbers and nothing else; None of other ones.

    They are parsed at once, to the same numbers as cell by cell.
    """
    text = "\n".join(lines)
    if not text.isascii() or text.encode().translate(None, PLAIN + (separator or "").encode()):
        return None
    if separator is None:
        sizes = {len(line.split()) for line in lines}
    else:
        sizes = {1 + count for count in map(operator.methodcaller("count", separator), lines)}
    if sizes != {count} or not set(map(LAST, lines)) <= ENDS:
        return None
    try:
        numbers = np.loadtxt(lines, dtype=float, comments=None, delimiter=separator, usecols=list(wanted), ndmin=2)
    except ValueError:
        return None
    return numbers if numbers.shape[0] == len(lines) and np.all(np.isfinite(numbers)) else None


def _differing(
    header: Header,
    columns: Sequence[Column],
    pair: int,
    place: int,
    file: str,
    given: Mapping[str, str] | None,
) -> InvalidInput:
    """Return the error that two columns of one name hold other numbers."""
    where = f"{file}, line {header.line}"
    return either(header.cells, (header.places[pair], place), columns[pair], header.twins, columns, where, given)


def _is_footer(lines: Sequence[str], separator: str | None) -> bool:
    """Return whether behind a blank line follow a few words and no row, such as the total time of a test."""
    words = [line.strip() for line in lines if line.strip()]
    return (
        not lines[0].strip()
        and len(words) <= MOST_FOOTER
        and not any(like_number(word) or (separator or "\t") in word for word in words)
    )


def read_table(
    path: str | os.PathLike[str],
    columns: Sequence[Column],
    *,
    units: Mapping[str, str] | None = None,
    repeated: bool = False,
    numbers: Mapping[str, int] | None = None,
    stated: str = "",
    gaps: Sequence[str] = (),
) -> Table:
    """Read columns of numbers from a text file with a header.

    Parameters
    ----------
    path : str or path
        The file.
    columns : sequence of Column
        The columns to read; each must stand in the header once, with a unit that fits.
    units : mapping of str to str, optional
        Units of columns that have none in the header, by the word of the column; see `winkler.io.tables.given_units`.
    repeated : bool, optional
        Whether the header may stand again between rows; it is passed over, and the numbers of the lines show it.
    numbers : mapping of str to int, optional
        The number of each column, counted from 1, in place of its name.
    stated : str, optional
        A header in place of that of the file.
    gaps : sequence of str, optional
        Words of the columns in which numbers may be missing; they are nan there.

    Returns
    -------
    Table

    Raises
    ------
    InvalidInput
        If the file cannot be read; the message names the line.
    """
    file = str(path)
    lines = table_lines(path, needs_of(columns), columns)
    head = headed(lines, file)
    if stated:
        header = stated_header(head, columns, stated, file)
    elif numbers:
        header = placed_header(head, columns, numbers, file, units)
    else:
        header = header_of(head, columns, file, units)
    separator = separator_of(lines, header)
    commas = DecimalCommas(file) if separator != "," else None
    above = {line.strip() for line in lines[max(header.line - 2, 0) : header.line] if line.strip()}
    again = above if repeated else frozenset[str]()
    rows_above = (cells_of(line, separator) for line in above)
    names = {tuple(row[p] for p in header.places) for row in rows_above if len(row) == len(header.cells)}
    repeats = list[int]()
    cells_read, places, incomplete = array("d"), array("q"), list[int]()
    needed = [number for number, column in enumerate(columns) if column.word not in gaps]
    short, last = 0, next((n for n in range(len(lines) - 1, -1, -1) if lines[n].strip()), 0)
    twins = [(pair, place) for pair, (_, *more) in enumerate(header.twins) for place in more]
    plain = _plain_rows(
        lines[header.line :], separator, len(header.cells), (*header.places, *(place for _, place in twins))
    )
    if plain is not None and twins:
        for number, (pair, place) in enumerate(twins, start=len(header.places)):
            if not np.array_equal(plain[:, pair], plain[:, number]):
                raise _differing(header, columns, pair, place, file, units)
        plain = np.ascontiguousarray(plain[:, : len(header.places)])
    if plain is not None:
        cells_read.frombytes(plain.tobytes())
        places.extend(range(header.line + 1, len(lines) + 1))
    for index in range(header.line, len(lines) if plain is None else 0):
        line = lines[index].partition("#")[0]
        if not line.strip():
            continue
        if repeated and MARK.fullmatch(line.strip()):
            continue
        if len(places) < FIRST_ROWS and len(header.cells) > 1 and END_OF_HEADER.fullmatch(line.strip()):
            continue
        if line.strip() in again:
            repeats.append(index + 1)
            continue
        if line.strip() in above:
            raise InvalidInput(f"{file}, line {index + 1}: {HEADER_AGAIN}; give each table a file of its own.")
        cells = cells_of(line, separator)
        while len(cells) > len(header.cells) and not cells[-1]:
            cells.pop()
        if len(cells) < len(header.cells) and separator == "\t":  # spaces in some rows, tabs in others
            spaced = cells_of(line, None)
            cells = spaced if len(spaced) == len(header.cells) and all(map(like_number, spaced)) else cells
        ends = max(header.places) < len(cells) < len(header.cells)
        if ends and separator in PADDED and (len(cells) == short or index < last):
            short = len(cells)
            cells += [""] * (len(header.cells) - short)
        if len(cells) != len(header.cells):
            if _is_footer(lines[index - 1 :], separator):
                break
            hint = "; if commas mark decimals or group thousands, write 1.5 and 1000" if "," in line else ""
            size = f"the line has {len(cells)} and the header {len(header.cells)} cells"
            second = next((n + 1 for n in range(index, len(lines)) if lines[n].strip() in above), 0)
            if second:
                hint = f"; {HEADER_AGAIN} in line {second}, give each table a file of its own"
            raise InvalidInput(f"{file}, line {index + 1}: {size}{hint}.")
        for pair, place in twins:
            if cells[place] != cells[header.places[pair]]:
                raise _differing(header, columns, pair, place, file, units)
        try:
            if "_" in line:
                raise ValueError("float() reads 1_000")
            row = [float(cells[place]) for place in header.places]
            if commas is not None:
                commas.see_points(cells)
        except ValueError:
            if not any(cells[place] for place in header.places):
                continue  # only columns that are not asked for go on
            if repeated and tuple(cells[place] for place in header.places) in names:  # of the second specimen
                repeats.append(index + 1)
                continue
            row = [
                number_in(
                    cells[p] if commas is None else commas.with_point(cells[p], index + 1),
                    f"{file}, line {index + 1}",
                    f"in the column '{header.cells[p]}' is not a number",
                )
                for p in header.places
            ]
        if not all(map(math.isfinite, row)) and not all(math.isfinite(row[number]) for number in needed):
            incomplete.append(index + 1)
        cells_read.extend(row)
        places.append(index + 1)
    if incomplete:
        more = len(incomplete) - 5
        listed = ", ".join(map(str, incomplete[:5])) + f" and {more} more" * (more > 0)
        few = "line" if len(incomplete) == 1 else "lines"
        raise InvalidInput(f"{file}: {few} {listed}: a number is missing or not finite; complete or delete the {few}.")
    if commas is not None:
        commas.refuse_ambiguous()
    if not places:
        raise InvalidInput(f"{file}: there are no numbers below the header in line {header.line}.")
    zeros = [zero_of(unit, column.unit) for column, unit in zip(columns, header.units, strict=True)]
    factors = np.array(
        [
            1.0 if zero else scale(column.unit, unit)
            for column, unit, zero in zip(columns, header.units, zeros, strict=True)
        ]
    )
    with np.errstate(over="ignore"):
        values = np.array(cells_read).reshape(-1, len(columns)) / factors + np.array(zeros)
    computable = ~np.any(np.abs(values) > LARGEST_NUMBER, axis=1)
    if not np.all(computable):
        place = places[int(np.argmin(computable))]
        raise InvalidInput(f"{file}, line {place}: a number is too large to be computed with in SI units; check it.")
    read_as = tuple(
        header.cells[place] if not unit or unit in header.cells[place] else f"{header.cells[place]} [{unit}]"
        for place, unit in zip(header.places, header.units, strict=True)
    )
    return Table(file, values, np.array(places), read_as, tuple(place + 1 for place in header.places), tuple(repeats))
