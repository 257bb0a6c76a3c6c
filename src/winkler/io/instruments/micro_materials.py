"""Text export of Micro Materials indenters (NanoTest): three columns without a header, and archives of many of them.

The columns are time [s], depth [nm] and load [mN].  Since the file does not say so, it is taken for such an export only
if its name ends in the number of the test and its place, as in ``Sample 3 6958 -4555.txt``, and the first column never
falls.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.number_block import columns_of, is_row, rows_of
from winkler.values.errors import InvalidInput

NAME = re.compile(r".*?(?<!\d)(\d++) (-?\d++) (-?\d++)\.txt", re.DOTALL | re.IGNORECASE)
"""Name, number of the test, and its place in um."""
COLUMNS = (("time", "s"), ("depth", "nm"), ("load", "mN"))


def is_micro_materials(head: Sequence[str], name: str) -> bool:
    """Return whether a text has such a name, and three numbers in its first lines."""
    first = [line for line in head[:10] if line.strip()]
    return bool(NAME.fullmatch(name) and first) and all(
        is_row(line, 3) and len(line.split("\t")) == 3 for line in first
    )


def tests_of_micro_materials(lines: Sequence[str], name: str, path: object) -> Iterator[InstrumentTest]:
    """Yield the one test of a file.

    Raises
    ------
    InvalidInput
        If the first column is no time, or a line holds something else.
    """
    rows = rows_of(lines, 0, 3, path)
    filled = sum(bool(line.strip()) for line in lines)
    if len(rows) != filled:
        raise InvalidInput(f"{path}: line {len(rows) + 1} holds no three numbers; export the test again.")
    if np.any(np.diff(rows[:, 0]) < 0.0):
        raise InvalidInput(
            f"{path}: the file has no header, and its first column falls, so that it is no time; write a header such "
            "as 'time [s], depth [nm], load [mN]'."
        )
    match = NAME.fullmatch(name)
    x, y = (1e-6 * float(match[index]) for index in (2, 3)) if match else (float("nan"), float("nan"))
    names, units = zip(*COLUMNS, strict=True)
    notes = ("the file has no header: time, depth and load, in s, nm and mN, are the order of this instrument",)
    yield InstrumentTest(
        "Micro Materials NanoTest, text export", name, columns_of(names, units, rows, path), notes, x, y
    )
