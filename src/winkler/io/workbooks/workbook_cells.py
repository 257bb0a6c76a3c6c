"""Sheets of a workbook as rows of texts and numbers: .xls by xlrd, .xlsx by openpyxl, .ods, and named arrays."""

from __future__ import annotations

import contextlib
import functools
import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from winkler.io.archive_file import refuse_large_archive
from winkler.io.foreign import quiet, sentence_of
from winkler.io.memory import limited_memory
from winkler.io.text_file import refuse_large
from winkler.io.workbooks.array_workbook import array_sheets, is_array_workbook
from winkler.io.workbooks.open_document import Cell, WorkbookSheet, is_open_document, open_document_sheets
from winkler.values.errors import InvalidInput
from winkler.values.limits import TEXT_BYTES

__all__ = ["Cell", "WorkbookSheet", "is_spreadsheet", "is_workbook", "sheets_of"]

OLD, NEW = b"\xd0\xcf\x11\xe0", b"PK\x03\x04"
ENDINGS = (".xls", ".xlsx", ".xlsm", ".ods")
ARRAY_ENDINGS = (".h5", ".hdf5", ".hdf", ".mat")
START_BYTES = 128
MOST_COLUMNS = 500
MOST_ROWS = 200_000
"""Of a sheet: more take longer than 5 s."""


def is_workbook(path: Path) -> bool:
    """Return whether a file is a spreadsheet, or one of named arrays."""
    return is_array_workbook(path) if path.suffix.lower() in ARRAY_ENDINGS else is_spreadsheet(path)


def is_spreadsheet(path: Path) -> bool:
    """Return whether a file is named and begins as the workbook of a spreadsheet."""
    with path.open("rb") as file:
        start = file.read(4)
    return path.suffix.lower() in ENDINGS and start in (OLD, NEW)


def sheets_of(path: Path) -> Iterator[WorkbookSheet]:
    """Yield the sheets of a workbook, one at a time.

    Raises
    ------
    InvalidInput
        If the package that reads it is not installed, the file is damaged, or it is too large.
    """
    refuse_large(path, TEXT_BYTES)
    with path.open("rb") as file:
        start = file.read(START_BYTES)
    remedy = "save it anew, or a sheet as text (CSV)"
    with sentence_of(path, "the workbook cannot be read", remedy, also=(AssertionError,)), quiet():
        if path.suffix.lower() in ARRAY_ENDINGS:
            yield from array_sheets(path, functools.partial(_refuse_large, path))
            return
        if start.startswith(OLD):
            yield from _old(path)
            return
        refuse_large_archive(path, "save a part of the tests")
        if not is_open_document(start):
            yield from _new(path)
            return
        with limited_memory(path):
            yield from open_document_sheets(path, functools.partial(_refuse_large, path))


def _old(path: Path) -> Iterator[WorkbookSheet]:
    try:
        import xlrd
    except ImportError:
        raise _missing(path, "xlrd") from None
    with limited_memory(path):
        book = xlrd.open_workbook(
            str(path), logfile=io.StringIO(), on_demand=True, ignore_workbook_corruption=True, formatting_info=False
        )
    with contextlib.closing(_Released(book)):
        for name in book.sheet_names():
            with limited_memory(path), _without_drawings():
                sheet = book.sheet_by_name(name)
                _refuse_wide(path, name, sheet.ncols)
                rows = [[_cell(cell) for cell in sheet.row_values(row)] for row in range(sheet.nrows)]
                book.unload_sheet(name)
            yield WorkbookSheet(name, rows)


@contextlib.contextmanager
def _without_drawings() -> Iterator[None]:
    """Read cells of a sheet and pass over its drawings: xlrd refuses a whole sheet where one of them is damaged."""
    from xlrd.sheet import Sheet

    read = Sheet.handle_obj
    Sheet.handle_obj = lambda sheet, data: None
    try:
        yield
    finally:
        Sheet.handle_obj = read


class _Released:
    """Releases the memory of a book of xlrd when it is closed."""

    def __init__(self, book: Any) -> None:
        self.book = book

    def close(self) -> None:
        self.book.release_resources()


def _new(path: Path) -> Iterator[WorkbookSheet]:
    try:
        import openpyxl
    except ImportError:
        raise _missing(path, "openpyxl") from None
    with limited_memory(path):
        book = openpyxl.load_workbook(path, read_only=True, data_only=True, keep_links=False)
    with contextlib.closing(book):
        for sheet in book.worksheets:
            with limited_memory(path):
                _refuse_long(path, sheet.title, sheet.max_row or 0)  # as the file states it
                sheet.reset_dimensions()
                rows: list[list[Cell]] = []
                for row in sheet.iter_rows(values_only=True):
                    _refuse_long(path, sheet.title, len(rows) + 1)
                    _refuse_wide(path, sheet.title, len(row))
                    rows.append([_cell(cell) for cell in row])
            yield WorkbookSheet(sheet.title, rows)


def _cell(content: Any) -> Cell:
    if isinstance(content, bool) or content is None:
        return "" if content is None else str(content)
    return float(content) if isinstance(content, int | float) else str(content).strip()


def _refuse_large(path: Path, name: str, rows: int, columns: int) -> None:
    _refuse_long(path, name, rows)
    _refuse_wide(path, name, columns)


def _refuse_long(path: Path, name: str, count: int) -> None:
    if count > MOST_ROWS:
        raise InvalidInput(
            f"{path}: the sheet '{name}' has more than {MOST_ROWS} rows; save it as text (CSV), of which more are read."
        )


def _refuse_wide(path: Path, name: str, count: int) -> None:
    if count > MOST_COLUMNS:
        raise InvalidInput(
            f"{path}: the sheet '{name}' has {count} columns, at most {MOST_COLUMNS} are read; delete those "
            "that are not needed."
        )


def _missing(path: Path, package: str) -> InvalidInput:
    return InvalidInput(
        f"{path}: workbooks need {package}; install it with pip install 'winkler[nanoindentation]', or save a sheet as "
        "text (CSV)."
    )
