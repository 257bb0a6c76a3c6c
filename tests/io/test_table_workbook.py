"""The tables of a folder of results as a workbook: the same numbers, to 16 digits, and no formula."""

from __future__ import annotations

import csv
import io
import re
import sys
import zipfile

import pytest

import winkler as wk
from winkler.io.workbooks import table_workbook as workbook
from winkler.io.workbooks.workbook_cells import sheets_of
from winkler.study.batch.run import run
from winkler.study.language.reading import read_study
from winkler.study.report.writing import outcome_files

openpyxl = pytest.importorskip("openpyxl")

STUDY = """title = "A ball"
[problem]
kind = "indentation"
load = { kind = "force", force = ["1 N", "2 N", "4 N"] }
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }
[fields]
r = { from = "0 a", to = "2 a", count = 5 }
[output]
figures = []
report = false
workbook = true
"""


def test_the_sheets_are_the_tables(tmp_path):
    path = tmp_path / "ball.toml"
    path.write_text(STUDY, encoding="utf-8")
    files = outcome_files(run(read_study(path)))
    assert b"workbook = true" in files["study.toml"]
    (tmp_path / "tables.xlsx").write_bytes(files[workbook.WORKBOOK])
    sheets = {sheet.name: sheet.rows for sheet in sheets_of(tmp_path / "tables.xlsx")}
    assert set(sheets) == {name.removesuffix(".csv") for name in files if name.endswith(".csv")}
    assert {"results", "surface"} <= set(sheets)
    for name, rows in sheets.items():
        heading, *numbers = csv.reader(io.StringIO(files[f"{name}.csv"].decode("utf-8")))
        assert rows[0] == heading
        assert len(rows) == len(numbers) + 1
        for row, texts in zip(rows[1:], numbers, strict=True):
            assert row == [pytest.approx(float(text), rel=1e-15, abs=0.0) if text != "nan" else "" for text in texts]


def written(content, tmp_path, name="names.csv"):
    (tmp_path / "a.xlsx").write_bytes(workbook.workbook_file({name: content.encode("utf-8")})[workbook.WORKBOOK])
    return openpyxl.load_workbook(tmp_path / "a.xlsx")


def test_what_a_spreadsheet_would_take_for_something_else(tmp_path):
    """Formulas, numbers with zeros in front, not a number, infinity, letters that XML forbids."""
    words = ['=HYPERLINK("http://a.b")', "007", "nan", "inf", "1e5", "bell\x07", "-0.0", "12", "1e-300"]
    store = io.StringIO()
    csv.writer(store).writerows([["curve"], *([word] for word in words)])
    sheet = written(store.getvalue(), tmp_path)["names"]
    cells = [row[0] for row in sheet.iter_rows(min_row=2)]
    assert [cell.value for cell in cells] == [words[0], "007", None, "inf", "1e5", "bell\ufffd", 0.0, 12, 1e-300]
    assert cells[0].data_type == "s"


def test_long_tables_go_on_in_the_next_sheet(tmp_path, monkeypatch):
    monkeypatch.setattr(workbook, "MOST_ROWS", 3)
    content = "n [-]\n" + "".join(f"{number}\n" for number in range(7))
    book = written(content, tmp_path, "a_name_of_more_than_thirty_one_letters.csv")
    assert book.sheetnames == [
        "a_name_of_more_than_thirty_one_letters"[:n] + mark for n, mark in ((31, ""), (29, " 2"), (29, " 3"))
    ]
    found = [row[0] for sheet in book for row in sheet.iter_rows(min_row=2, values_only=True)]
    assert found == list(range(7))
    assert all(sheet["A1"].value == "n [-]" for sheet in book)


def test_equal_tables_make_equal_bytes():
    """No time stands in the archive, neither beside its parts nor in them."""
    files = {"a.csv": b"n [-]\n1\n"}
    content = workbook.workbook_file(files)
    assert workbook.workbook_file(files) == content
    (made,) = content.values()
    with zipfile.ZipFile(io.BytesIO(made)) as archive:
        assert {part.date_time for part in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        times = re.findall(rb"[12][09]\d\d-\d\d", b"".join(map(archive.read, archive.namelist())))
    assert set(times) == {b"1980-01"}


def test_without_openpyxl_the_study_is_refused_before_it_runs(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    path = tmp_path / "ball.toml"
    path.write_text(STUDY, encoding="utf-8")
    with pytest.raises(
        wk.InvalidInput, match=r"workbook needs openpyxl; install it with pip install 'winkler\[xlsx\]'"
    ):
        read_study(path)
