"""OpenDocument workbooks (.ods): read as other workbooks are, and within limits."""

from __future__ import annotations

import zipfile

import numpy as np
import pytest

from winkler.io.curves import read_curve, read_curves
from winkler.io.tables.relaxation_table import read_dynamic
from winkler.io.topography_file import read_topography
from winkler.io.workbooks.workbook_cells import is_workbook, sheets_of
from winkler.values.errors import InvalidInput

KIND = "application/vnd.oasis.opendocument.spreadsheet"
SPACES = " ".join(
    f'xmlns:{word}="urn:oasis:names:tc:opendocument:xmlns:{word}:1.0"' for word in ("office", "table", "text")
)
DEPTH = np.r_[np.linspace(0.0, 200.0, 60), np.linspace(199.0, 120.0, 30)]
FORCE = np.r_[1e-4 * np.linspace(0.0, 200.0, 60) ** 2, 4.0 * ((np.linspace(199.0, 120.0, 30) - 120.0) / 80.0) ** 1.5]


def _cell(content, times=1):
    repeated = f' table:number-columns-repeated="{times}"' * (times > 1)
    if content is None:
        return f"<table:table-cell{repeated}/>"
    if isinstance(content, str):
        return f'<table:table-cell office:value-type="string"{repeated}><text:p>{content}</text:p></table:table-cell>'
    shown = f"{content:.2f}".replace(".", ",")  # what the cell shows is not what it holds
    value = f'office:value-type="float" office:value="{content!r}"'
    return f"<table:table-cell {value}{repeated}><text:p>{shown}</text:p></table:table-cell>"


def _row(cells, times=1):
    repeated = f' table:number-rows-repeated="{times}"' * (times > 1)
    return f"<table:table-row{repeated}>{''.join(cells)}</table:table-row>"


def _rows(rows):
    return "".join(_row([_cell(cell) for cell in row]) for row in rows)


def _ods(path, sheets, *, before=""):
    body = "".join(f'<table:table table:name="{name}">{rows}</table:table>' for name, rows in sheets.items())
    body = f"<office:body><office:spreadsheet>{body}</office:spreadsheet></office:body>"
    content = f'<?xml version="1.0"?>{before}<office:document-content {SPACES}>{body}</office:document-content>'
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as pack:
        pack.writestr(zipfile.ZipInfo("mimetype"), KIND)
        pack.writestr("content.xml", content)
    return path


def _test_rows(scale=1.0):
    rows = zip(DEPTH.tolist(), (scale * FORCE).tolist(), strict=True)
    return [["Depth", "Load"], ["nm", "mN"], *map(list, rows)]


def test_a_test_in_a_sheet_is_a_curve(tmp_path):
    file = _ods(tmp_path / "test.ods", {"Test 001": _rows(_test_rows())})
    assert is_workbook(file)
    curve = read_curve(file)
    assert curve.position == pytest.approx(DEPTH * 1e-9)
    assert curve.force == pytest.approx(FORCE * 1e-3)


def test_sheets_are_tests(tmp_path):
    sheets = {f"Test {n}": _rows(_test_rows(float(n))) for n in (1, 2, 3)}
    curves = [placed.curve for placed in read_curves(_ods(tmp_path / "tests.ods", sheets))]
    assert [curve.force.max() for curve in curves] == pytest.approx([n * FORCE.max() * 1e-3 for n in (1, 2, 3)])


def test_moduli_and_maps_in_sheets(tmp_path):
    omega = [0.1, 1.0, 10.0, 100.0]
    table = [["omega [rad/s]", "G' [Pa]", "G'' [Pa]"], *([w, 1e3 * (1.0 + w), 50.0 * w] for w in omega)]
    moduli = read_dynamic(_ods(tmp_path / "moduli.ods", {"sweep": _rows(table)}))
    assert moduli.storage_shear == pytest.approx([1e3 * (1.0 + w) for w in omega])
    heights = np.arange(30.0).reshape(5, 6)
    file = _ods(tmp_path / "map.ods", {"map": _rows(heights.tolist())})
    rough = read_topography(file, unit="nm", lengths=(5e-6, 6e-6))
    assert np.ptp(rough.heights) == pytest.approx(29e-9)


def test_repeats_gaps_and_notes_are_as_the_program_shows_them(tmp_path):
    note = "<office:annotation><text:p>not this</text:p></office:annotation>"
    name = f'<table:table-cell office:value-type="string">{note}<text:p>a<text:s/>b</text:p></table:table-cell>'
    rows = _row([name, _cell(None, 2), _cell(1.5, 3), _cell(None, 16000)])
    rows += _row([_cell(None, 16384)], 3) + _row([_cell(2.0)], 2) + _row([_cell(None, 16384)], 10**6)
    (sheet,) = sheets_of(_ods(tmp_path / "gaps.ods", {"S": rows}))
    assert sheet.rows == [["a b", "", "", 1.5, 1.5, 1.5], [], [], [], [2.0], [2.0]]


BOMBS = {
    "rows": _row([_cell(1.0)], 10**6),
    "columns": _row([_cell(1.0, 10**6)]),
    "cells": _row([_cell(1.0, 400)], 10**5),
    "both": _row([_cell(1.0, 10**9)], 10**9),
    "far": _row([_cell(None)], 10**8) + _row([_cell(1.0)]),
    "long number": _row([_cell(1.0)], int("9" * 4000)),
}


@pytest.mark.parametrize("rows", BOMBS.values(), ids=list(BOMBS))
def test_two_kilobytes_do_not_fill_the_memory(tmp_path, rows):
    """Another reader wrote all repeats out, and ended the whole process where its memory was limited."""
    with pytest.raises(InvalidInput, match=r"more than \d+ (?:rows|cells)|columns, at most"):
        list(sheets_of(_ods(tmp_path / "bomb.ods", {"S": rows})))


def test_entities_are_refused(tmp_path):
    laughs = '<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>'
    row = "<table:table-row><table:table-cell><text:p>&b;</text:p></table:table-cell></table:table-row>"
    file = _ods(tmp_path / "laughs.ods", {"S": row}, before=laughs)
    with pytest.raises(InvalidInput, match="defines entities of its own"):
        list(sheets_of(file))


def test_damaged_files_are_one_sentence(tmp_path):
    whole = _ods(tmp_path / "whole.ods", {"S": _rows(_test_rows())})
    content = whole.read_bytes()
    cut = tmp_path / "cut.ods"
    cut.write_bytes(content[: len(content) // 2])
    with zipfile.ZipFile(tmp_path / "empty.ods", "w") as pack:
        pack.writestr(zipfile.ZipInfo("mimetype"), KIND)
    with zipfile.ZipFile(tmp_path / "broken.ods", "w") as pack:
        pack.writestr(zipfile.ZipInfo("mimetype"), KIND)
        pack.writestr("content.xml", "<office><unclosed>")
    for name in ("cut.ods", "empty.ods", "broken.ods"):
        with pytest.raises(InvalidInput, match=r"(?:workbook|archive) cannot be read \("):
            list(sheets_of(tmp_path / name))
