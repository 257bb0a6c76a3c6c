"""Sheets of an OpenDocument workbook (.ods), read piece by piece within limits.

A cell or a row states how often it is repeated (OpenDocument 1.3, part 3, sections 19.675 and 19.679): two kilobytes
may stand for a thousand million cells, so that repeats are counted before they are written out.
"""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

from winkler.io.archive_file import archive
from winkler.values.errors import InvalidInput
from winkler.values.limits import TEXT_BYTES

Cell = str | float
CONTENT, KIND = "content.xml", b"application/vnd.oasis.opendocument.spreadsheet"
MARK = b"mimetype" + KIND
"""Name and contents of the first member of the archive, which is not packed (OpenDocument 1.3, part 2, section 3.3)."""
PIECE_BYTES = 2**18
MOST_CELLS = 10_000_000
"""Of a sheet, as its repeats state them."""
NUMBERS = ("float", "percentage", "currency")
CELLS = ("table:table-cell", "table:covered-table-cell")


class WorkbookSheet(NamedTuple):
    """A sheet: its name, and its rows of texts and numbers; empty cells are empty texts."""

    name: str
    rows: list[list[Cell]]


def is_open_document(start: bytes) -> bool:
    """Return whether a file begins as an OpenDocument workbook."""
    return start.startswith(b"PK\x03\x04") and start[30:].startswith(MARK)


def open_document_sheets(path: Path, refuse: Callable[[str, int, int], None]) -> Iterator[WorkbookSheet]:
    """Yield the sheets of an OpenDocument workbook, one at a time.

    Parameters
    ----------
    path : path
        The file.
    refuse : callable
        Takes the name of a sheet, a number of rows and one of columns, and raises where these are too many.

    Raises
    ------
    InvalidInput
        If the file is damaged, defines entities, or is too large.
    """
    remedy = "save it anew, or a sheet as text (CSV)"
    with archive(path, path, wrong="the workbook cannot be read", remedy=remedy, size=TEXT_BYTES) as pack:
        if CONTENT not in pack.namelist():
            raise zipfile.BadZipFile(f"it has no {CONTENT}")
        reading = _Reading(path, refuse)
        with pack.open(CONTENT) as file:
            while piece := file.read(PIECE_BYTES):
                reading.parser.Parse(piece, False)
                yield from reading.taken()
        reading.parser.Parse(b"", True)
        yield from reading.taken()


class _Reading:
    """What was read so far: the finished sheets, and the sheet, row and cell in which the text stands."""

    def __init__(self, path: Path, refuse: Callable[[str, int, int], None]) -> None:
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._text
        self.parser.StartDoctypeDeclHandler = self._refuse_definitions
        self._path, self._refuse = path, refuse
        self._sheets: list[WorkbookSheet] = []
        self._rows: list[list[Cell]] = []
        self._row: list[Cell] = []
        self._name, self._cell = "", ""
        self._empty_rows, self._empty_cells, self._row_times, self._cell_times = 0, 0, 1, 1
        self._kind, self._number = "", ""
        self._depth, self._count = 0, 0

    def taken(self) -> list[WorkbookSheet]:
        """Return the sheets that are complete, and forget them."""
        sheets, self._sheets = self._sheets, []
        return sheets

    def _refuse_definitions(self, *_: object) -> None:
        raise InvalidInput(f"{self._path}: the workbook defines entities of its own; save a sheet as text (CSV).")

    def _start(self, name: str, given: Mapping[str, str]) -> None:
        if name == "table:table":
            self._name, self._rows, self._empty_rows = given.get("table:name", ""), [], 0
            self._count = 0
        elif name == "table:table-row":
            self._row, self._empty_cells = [], 0
            self._row_times = _times(given, "table:number-rows-repeated")
        elif name in CELLS:
            self._cell, self._depth = "", 0
            self._kind = given.get("office:value-type", "")
            self._number = given.get("office:value", "")
            self._cell_times = _times(given, "table:number-columns-repeated")
        elif name == "text:p":
            self._depth += 1
            self._cell += " " * bool(self._cell)
        elif name == "office:annotation":  # its text is no part of the cell
            self._depth -= 10**6
        elif name in ("text:s", "text:tab"):
            self._cell += " "

    def _text(self, text: str) -> None:
        if self._depth > 0:
            self._cell += text

    def _end(self, name: str) -> None:
        if name == "text:p":
            self._depth -= 1
        elif name == "office:annotation":
            self._depth += 10**6
        elif name in CELLS:
            self._append_cell(float(self._number) if self._kind in NUMBERS else self._cell.strip())
        elif name == "table:table-row":
            self._append_row()
        elif name == "table:table":
            self._sheets.append(WorkbookSheet(self._name, self._rows))

    def _append_cell(self, cell: Cell) -> None:
        if cell == "":  # what is empty up to the end of a row is left out
            self._empty_cells += self._cell_times
            return
        self._refuse(self._name, 0, len(self._row) + self._empty_cells + self._cell_times)
        self._row += [""] * self._empty_cells + [cell] * self._cell_times
        self._empty_cells = 0

    def _append_row(self) -> None:
        if not self._row:
            self._empty_rows += self._row_times
            return
        self._refuse(self._name, len(self._rows) + self._empty_rows + self._row_times, 0)
        self._count += self._row_times * len(self._row)
        if self._count > MOST_CELLS:
            raise InvalidInput(f"{self._path}: the sheet '{self._name}' has more than {MOST_CELLS} cells; split it.")
        self._rows += [[] for _ in range(self._empty_rows)] + [self._row] * self._row_times
        self._empty_rows = 0


def _times(given: Mapping[str, str], word: str) -> int:
    """Return how often a cell or a row stands; at least once."""
    stated = given.get(word, "1")
    return max(int(stated), 1) if stated.isascii() and stated.isdecimal() and len(stated) < 10 else 10**9
