"""Text files of FemtoTools indenters (FT-NMT, FT-I, FT-RS): comment lines behind ``//``, names with units, many tests.

A test ends where the phase (approach, loading, unloading) begins again, where the index counts on by a whole number, or
at the next comment lines.  The column
"Sample Displace" is the depth; a "Displacement" still contains the bending of the sensor.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.number_block import columns_of, rows_of, split_unit
from winkler.values.errors import InvalidInput

COMMENT = "//"
BETWEEN = re.compile(r"\s{2,}|(?<=\])\s")
"""Between the names of a header without tabs."""
PARTED_BY = ("phase", "index")
HEAD_LINES = 200


def is_femtotools(head: Sequence[str]) -> bool:
    """Return whether a comment line names a displacement, a force, and a phase or an index."""
    return any(_names(line) for line in head[:HEAD_LINES])


def tests_of_femtotools(lines: Sequence[str], name: str, path: object) -> Iterator[InstrumentTest]:
    """Yield the tests of a file.

    Raises
    ------
    InvalidInput
        If there are no numbers below the names.
    """
    headers = [index for index, line in enumerate(lines) if _names(line)]
    blocks = []
    cells: list[str] = []
    for header in headers:
        cells = _names(lines[header])
        first = header + 1
        while first < len(lines) and lines[first].startswith(COMMENT) and not _names(lines[first]):
            first += 1
        rows = rows_of(lines, first, len(cells), path, separator="\t" if "\t" in lines[header] else None)
        if not rows.size:
            continue
        word, place = _parting(cells)
        step = np.diff(np.floor(rows[:, place]))
        begins = np.flatnonzero(step < 0.0 if word == "phase" else step != 0.0) + 1
        blocks += [(cells, part) for part in np.split(rows, begins)]
    if not blocks:
        raise InvalidInput(f"{path}: there are no numbers below the names of the columns; export the tests again.")
    for number, (cells, part) in enumerate(blocks):
        names, units = zip(*map(split_unit, cells), strict=True)
        corrected = "sample displace" in [one.lower() for one in names]
        notes = () if corrected else ("the displacement may contain the bending of the sensor",)
        test = name if len(blocks) == 1 else f"{name}, test {number + 1}"
        yield InstrumentTest("FemtoTools, text file", test, columns_of(names, units, part, path), notes)


def _names(line: str) -> list[str]:
    """Return the names in a comment line, if it names a displacement, a force, and a phase or an index; else none."""
    if not line.startswith(COMMENT):
        return []
    text = line.lstrip("/ ").rstrip()
    cells = [cell.strip() for cell in (text.split("\t") if "\t" in text else BETWEEN.split(text))]
    words = [cell.lower() for cell in cells]
    named = all(any(word in cell for cell in words) for word in ("displace", "force")) and _parting(cells)[0]
    return cells if named else []


def _parting(cells: Sequence[str]) -> tuple[str, int]:
    """Return the word of the column by which tests are parted, and its place; no word if there is none."""
    return next(
        ((word, place) for word in PARTED_BY for place, cell in enumerate(cells) if cell.lower().startswith(word)),
        ("", 0),
    )
