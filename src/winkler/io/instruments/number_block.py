"""Rows of numbers between the lines of a text that an instrument wrote."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.io.instruments.instrument_test import InstrumentColumn
from winkler.io.tables.decimal_commas import DecimalCommas
from winkler.io.tables.table_cells import ABSENT, is_number
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput


def is_row(line: str, count: int, separator: str | None = "\t") -> bool:
    """Return whether a line holds so many cells, all of them numbers, some perhaps with a decimal comma."""
    cells = _cells(line, separator)
    return len(cells) >= count and all(_like(cell) for cell in cells[:count])


def rows_of(lines: Sequence[str], first: int, count: int, path: object, *, separator: str | None = "\t") -> Array:
    """Return the rows of numbers from a line on, up to the first line that is none ``(rows, count)``.

    Parameters
    ----------
    lines : sequence of str
        All lines of the file.
    first : int
        Index of the first row.
    count : int
        How many cells of each row are read; missing numbers are nan.
    path
        The file, for messages.
    separator : str, optional
        Between cells; white space if None.

    Raises
    ------
    InvalidInput
        If a comma may be decimal or group thousands.
    """
    commas, rows = DecimalCommas(str(path)), []
    for index in range(first, len(lines)):
        line = lines[index]
        if not line.strip():
            continue
        if not is_row(line, count, separator):
            break
        cells = (commas.with_point(cell, index + 1) for cell in _cells(line, separator)[:count])
        rows.append([float(cell) if is_number(cell) else math.nan for cell in cells])
    commas.refuse_ambiguous()
    return np.array(rows, dtype=float).reshape(-1, count)


def columns_of(
    names: Sequence[str], units: Sequence[str], rows: Array, path: object, where: str = ""
) -> tuple[InstrumentColumn, ...]:
    """Return the columns of some rows.

    Raises
    ------
    InvalidInput
        If there are no rows.
    """
    if not rows.size:
        raise InvalidInput(f"{path}: there are no numbers below the header{where}; export the test again.")
    return tuple(InstrumentColumn(*column) for column in zip(names, units, rows.T, strict=True))


def split_unit(cell: str) -> tuple[str, str]:
    """Return name and unit of a cell of a header: ``Force A [uN]``, ``Load (mN)``, ``Time_s``, ``Disp_nm``.

    Examples
    --------
    >>> split_unit("Sample Displace [um]"), split_unit("Time_s"), split_unit("Phase [#]")
    (('Sample Displace', 'um'), ('Time', 's'), ('Phase', ''))
    """
    cell = cell.strip().strip("\"'")
    for opened, closed in (("[", "]"), ("(", ")")):
        if cell.endswith(closed) and opened in cell:
            name, _, unit = cell[:-1].rpartition(opened)
            return name.strip(), unit.strip().strip("#-")
    name, _, unit = cell.rpartition("_")
    return (name.strip(), unit.strip()) if name else (cell, "")


def _cells(line: str, separator: str | None) -> list[str]:
    return [cell.strip() for cell in line.strip("\r\n").split(separator)]


def _like(cell: str) -> bool:
    return is_number(cell) or is_number(cell.replace(",", ".")) or (cell.lower() in ABSENT)


def stated_number(settings: dict[str, str], key: str) -> float | None:
    """Return the number with which a setting of an instrument begins; None where it is absent or begins with none."""
    try:
        return float(settings[key].split()[0])
    except (KeyError, ValueError, IndexError):
        return None
