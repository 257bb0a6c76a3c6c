"""Rows of plain numbers, which are parsed at once, are read as cell by cell."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.io.tables import table

ROWS = {
    "plain": "1,2,3\n4,5,6\n",
    "signs and exponents": "+1.5e-3,-2E+04,.5\n-0,1e0,7.\n",
    "blanks around": " 1 , 2 ,3\n4,  5,6 \n",
    "seventeen digits": "0.12345678901234567,1.7976931348623157e308,5e-324\n1,2,3\n",
    "a row between": "1,2,3\n\n4,5,6\n",
    "a comment": "1,2,3\n4,5,6 # last\n",
    "a missing number": "1,nan,3\n4,5,6\n",
    "an empty cell": "1,,3\n4,5,6\n",
    "two numbers in a cell": "1 2,3,4\n4,5,6\n",
    "no number at all": "1,-,3\n4,5,6\n",
    "a number too many": "1,2,3,4\n4,5,6\n",
    "a point alone": "1,.,3\n4,5,6\n",
    "too large": "1,1e999,3\n4,5,6\n",
    "groups of three": "1.000.000,2,3\n4,5,6\n",
}
HEADS = {
    ",": "depth [nm],force [nN],time [s]\n",
    ";": "depth [nm];force [nN];time [s]\n",
    "\t": "depth [nm]\tforce [nN]\ttime [s]\n",
}
COLUMNS = (
    table.Column("depth", ("depth",), "m"),
    table.Column("force", ("force",), "N"),
    table.Column("time", ("time",), "s"),
)


def ending(path):
    try:
        return table.read_table(path, COLUMNS)
    except wk.WinklerError as error:
        return str(error)


@pytest.mark.parametrize("separator", HEADS)
@pytest.mark.parametrize("rows", ROWS)
def test_both_ways_end_alike(rows, separator, tmp_path, monkeypatch):
    path = tmp_path / "table.csv"
    path.write_text(HEADS[separator] + ROWS[rows].replace(",", separator))
    at_once = ending(path)
    monkeypatch.setattr(table, "_plain_rows", lambda *_: None)
    by_cells = ending(path)
    if isinstance(by_cells, str):
        assert at_once == by_cells
    else:
        assert np.array_equal(at_once.values, by_cells.values, equal_nan=True)
        assert at_once == by_cells


def test_plain_rows_are_parsed_at_once():
    found = table._plain_rows(["1,2.5,3", "4,5,-6e-3"], ",", 3, (0, 2))
    np.testing.assert_array_equal(found, [[1.0, 3.0], [4.0, -6e-3]])
