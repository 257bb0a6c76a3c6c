"""The tables of a folder of results as one workbook for spreadsheets, a sheet for each.

openpyxl writes 16 digits of a number, the tables as text all 17.  A spreadsheet knows neither nan nor infinity: the
first is an empty cell, the other a text.  A text that begins like a formula stays a text, and equal tables make equal
bytes.
"""

from __future__ import annotations

import contextlib
import csv
import io
import re
import zipfile
from collections.abc import Mapping
from typing import Any

WORKBOOK = "tables.xlsx"
MOST_ROWS = 1_048_575
"""Of a sheet, below its heading: what is longer goes on in the next."""
MOST_LETTERS = 31
"""Of the name of a sheet."""
TIMES = re.compile(rb">[^<>]*(?=</dcterms:)")


def workbook_file(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """Return a workbook of the tables (.csv) among files, those in folders left out: its name -> content."""
    import openpyxl

    book = openpyxl.Workbook(write_only=True)
    for name, content in files.items():
        stem, _, ending = name.rpartition(".")
        if ending != "csv" or "/" in stem:
            continue
        heading, *rows = csv.reader(io.StringIO(content.decode("utf-8"), newline=""))
        for part, start in enumerate(range(0, max(len(rows), 1), MOST_ROWS), 1):
            mark = f" {part}" if part > 1 else ""
            sheet = book.create_sheet(f"{stem[: MOST_LETTERS - len(mark)]}{mark}")
            sheet.freeze_panes = "A2"
            for row in [heading, *rows[start : start + MOST_ROWS]]:
                sheet.append([_cell(sheet, text) for text in row])
    store = io.BytesIO()
    book.save(store)
    return {WORKBOOK: _dateless(store)}


def _cell(sheet: Any, text: str) -> Any:
    from openpyxl.cell import WriteOnlyCell
    from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE

    if text in ("", "nan"):
        return None
    for kind in (int, float):
        with contextlib.suppress(ValueError):
            number = kind(text)
            if repr(number) == text and abs(number) < float("inf"):  # a curve named 007 is no number
                return number
    cell = WriteOnlyCell(sheet, ILLEGAL_CHARACTERS_RE.sub("\ufffd", text))
    cell.data_type = "s"
    return cell


def _dateless(store: io.BytesIO) -> bytes:
    """Return the archive without the time at which it was written."""
    bare = io.BytesIO()
    with zipfile.ZipFile(store) as archive, zipfile.ZipFile(bare, "w", zipfile.ZIP_DEFLATED) as new:
        for name in archive.namelist():
            content = archive.read(name)
            if name == "docProps/core.xml":
                content = TIMES.sub(b">1980-01-01T00:00:00Z", content)
            new.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return bare.getvalue()
