"""The lines of a table, whether it is a text or a sheet of a workbook."""

from __future__ import annotations

import functools
import os
from pathlib import Path

from winkler.io.tables.table_cells import is_number
from winkler.io.text_file import existing, head_of, headed, lines_of
from winkler.io.workbooks.workbook_cells import Cell, is_workbook, sheets_of

__all__ = ["table_head", "table_lines"]

LEAST_ROWS, LEAST_NUMBERS = 3, 2
"""Of the first sheet that is taken for a table."""


def table_lines(path: str | os.PathLike[str], needs: str) -> list[str]:
    """Return the lines of a text, or of the first sheet with a table, its cells apart by tabs.

    Parameters
    ----------
    path : str or path
        The file.
    needs : str
        What it should hold, for an empty one.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    file = existing(path, "a text file")
    return list(_sheet(file)) if is_workbook(file) else lines_of(file, needs)


def table_head(path: str | os.PathLike[str], needs: str) -> list[str]:
    """Return the lines among which the header of a table stands; parameters as for `table_lines`.

    Raises
    ------
    InvalidInput
        If it cannot be read.
    """
    file = existing(path, "a text file")
    return headed(list(_sheet(file)), str(path)) if is_workbook(file) else head_of(file, needs)


def _sheet(path: Path) -> tuple[str, ...]:
    status = path.stat()
    return _lines_of_sheet(path, status.st_size, status.st_mtime_ns)


@functools.lru_cache(maxsize=1)  # the header is looked at for each quantity, and a workbook is slow to unpack
def _lines_of_sheet(path: Path, size: int, changed: int) -> tuple[str, ...]:
    """Return the lines of the first sheet with a table, of a workbook of this size and time [ns] of its last change."""
    first: tuple[str, ...] = ()
    for sheet in sheets_of(path):
        filled = [place for row in sheet.rows for place, cell in enumerate(row) if cell != ""]
        first_column, end = min(filled, default=0), max(filled, default=-1) + 1
        cells = [[_text(cell) for cell in row[first_column:end]] for row in sheet.rows]
        lines = tuple("\t".join([*row, *[""] * (end - first_column - len(row))]) for row in cells)
        first = first or lines
        if sum(_numbers(row) >= LEAST_NUMBERS for row in sheet.rows) >= LEAST_ROWS:
            return lines
    return first


def _numbers(row: list[Cell]) -> int:
    return sum(isinstance(cell, float) or is_number(cell) for cell in row)


def _text(cell: Cell) -> str:
    return repr(cell) if isinstance(cell, float) else " ".join(cell.split())
