"""The lines of a table, whether it is a text, a sheet of a workbook, or a part of one of these."""

from __future__ import annotations

import dataclasses
import functools
import math
import os
from collections.abc import Sequence
from pathlib import Path

from winkler.io.tables.column import Column
from winkler.io.tables.table_cells import is_number, named
from winkler.io.text_file import existing, head_of, headed, lines_of
from winkler.io.workbooks.workbook_cells import Cell, is_workbook, sheets_of
from winkler.values.errors import InvalidInput
from winkler.values.limits import HEADER_LINES, TEXT_BYTES

LEAST_ROWS, LEAST_NUMBERS = 3, 2
"""Of a sheet that is taken for a table."""


@dataclasses.dataclass(frozen=True)
class TablePart(os.PathLike[str]):
    """A part of a file that is a table by itself; readers of tables take it in place of a path.

    Parameters
    ----------
    path : str
        The file.
    lines : tuple of str
        As many as the file has above the part and in it, so that their numbers are those of the file.
    label : str, optional
        What tells it from the other parts, for messages.
    temperature : float, optional
        The temperature [K] that stands beside its names; nan if there is none.
    """

    path: str
    lines: tuple[str, ...]
    label: str = ""
    temperature: float = math.nan

    def __fspath__(self) -> str:
        return self.path

    def __str__(self) -> str:
        return f"{self.path}, {self.label}" if self.label else self.path


def table_lines(path: str | os.PathLike[str], needs: str, columns: Sequence[Column] = ()) -> list[str]:
    """Return the lines of a text, or of a sheet with a table, its cells apart by tabs.

    Parameters
    ----------
    path : str or path
        The file.
    needs : str
        What it should hold, for an empty one.
    columns : sequence of Column, optional
        Columns by which one of several sheets is chosen: the first whose header names all; else the first table.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    if isinstance(path, TablePart):
        return list(path.lines)
    file = existing(path, "a text file")
    return list(_chosen(_sheets(file), columns).lines) if is_workbook(file) else lines_of(file, needs)


def table_head(path: str | os.PathLike[str], needs: str, columns: Sequence[Column] = ()) -> list[str]:
    """Return the lines among which the header of a table stands; parameters as for `table_lines`.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    if isinstance(path, TablePart):
        return headed(list(path.lines), str(path))
    file = existing(path, "a text file")
    if is_workbook(file):
        return headed(list(_chosen(_sheets(file), columns).lines), str(path))
    return head_of(file, needs)


def table_sheets(path: str | os.PathLike[str]) -> list[TablePart]:
    """Return the sheets of a workbook that are tables, or the first one if none is.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    return list(_sheets(existing(path, "a workbook")))


def sheets_naming(path: str | os.PathLike[str], columns: Sequence[Column]) -> list[TablePart]:
    """Return the sheets of a workbook whose headers name all columns; none of a text.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    if isinstance(path, TablePart) or not is_workbook(file := existing(path, "a workbook")):
        return []
    return [sheet for sheet in _sheets(file) if _names(sheet.lines, columns)]


def _sheets(path: Path) -> tuple[TablePart, ...]:
    status = path.stat()
    return _read_sheets(path, status.st_size, status.st_mtime_ns)


@functools.lru_cache(maxsize=1)  # the header is looked at for each quantity, and a workbook is slow to unpack
def _read_sheets(path: Path, size: int, changed: int) -> tuple[TablePart, ...]:
    """Return the tables of a workbook of this size and time [ns] of its last change, or its first sheet."""
    first_sheet: tuple[TablePart, ...] = ()
    tables: list[TablePart] = []
    letters = 0
    try:
        for sheet in sheets_of(path):
            filled = [place for row in sheet.rows for place, cell in enumerate(row) if cell != ""]
            first, end = min(filled, default=0), max(filled, default=-1) + 1
            lines = []
            for row in sheet.rows:
                cells = [_text(cell) for cell in row[first:end]]
                letters += sum(map(len, cells)) + end - first
                if letters > TEXT_BYTES:  # many cells may refer to one long text
                    raise InvalidInput(
                        f"{path}: its sheets hold more than {TEXT_BYTES / 1e6:.0f} MB of text; split it."
                    )
                lines.append("\t".join([*cells, *[""] * (end - first - len(cells))]))
            part = TablePart(str(path), tuple(lines), f"sheet '{sheet.name}'")
            first_sheet = first_sheet or (part,)
            if sum(_numbers(row) >= LEAST_NUMBERS for row in sheet.rows) >= LEAST_ROWS:
                tables.append(part)
    except InvalidInput:
        if not tables:  # a later sheet that is too large does not hide a table before it
            raise
    return tuple(tables) or first_sheet


def _chosen(sheets: tuple[TablePart, ...], columns: Sequence[Column]) -> TablePart:
    """Return the first sheet that names all columns, else the first."""
    if columns and len(sheets) > 1:
        sheets = (*(sheet for sheet in sheets if _names(sheet.lines, columns)), *sheets)
    return next(iter(sheets), TablePart("", ()))


def _names(lines: Sequence[str], columns: Sequence[Column]) -> bool:
    rows = ([cell for cell in line.split("\t") if cell and not is_number(cell)] for line in lines[:HEADER_LINES])
    return any(
        all(any(named(cell, column.names)[0] for cell in cells) for column in columns)
        for cells in rows
        if len(cells) >= len(columns)
    )


def _numbers(row: list[Cell]) -> int:
    return sum(isinstance(cell, float) or is_number(cell) for cell in row)


def _text(cell: Cell) -> str:
    return repr(cell) if isinstance(cell, float) else " ".join(cell.split())
