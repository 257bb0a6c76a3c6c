"""Text export of FischerScope indenters (HM 2000, Picodentor): many tests in one file, each a table F, h, t.

The header of the table has no units.  Those of the instrument are mN, um and s, as the line of the test parameters
("300.000mN/120s") and the greatest depth in um show.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.number_block import columns_of, rows_of
from winkler.values.errors import InvalidInput

TEST = re.compile(r"Block\s*:\s*(\d+)\s+Value\s*:\s*(\d+)\s*")
TABLE = re.compile(r"F\s+h\s+t\s*")
PLACE = re.compile(r"x=\s*(-?[\d.,]+)\s+y=\s*(-?[\d.,]+)\s*")
UNITS = {"F": ("mN", "force"), "h": ("um", "position"), "t": ("s", "time")}
TOLD = ("Indenter shape correction", "EIT/(1-vs^2)\t", "HIT\t", "hmax\t")
HEAD_LINES = 400


def is_fischerscope(head: Sequence[str]) -> bool:
    """Return whether a text is such an export: a block with a value, and the table."""
    return any(TEST.fullmatch(line) for line in head[:HEAD_LINES])


def tests_of_fischerscope(
    lines: Sequence[str], name: str, path: object, units: dict[str, str]
) -> Iterator[InstrumentTest]:
    """Yield the tests of a file; `units` given for force, position and time take the place of mN, um and s.

    Raises
    ------
    InvalidInput
        If a test has no numbers, or there is no test.
    """
    begins = [index for index, line in enumerate(lines) if TEST.fullmatch(line)]
    count = 0
    for begin, end in zip(begins, [*begins[1:], len(lines)], strict=True):
        block, value = TEST.fullmatch(lines[begin]).groups()  # type: ignore[union-attr]
        table = next((index for index in range(begin, end) if TABLE.fullmatch(lines[index])), None)
        if table is None:
            continue
        count += 1
        words = lines[table].split()
        known = {word: units.get(key, unit) for word, (unit, key) in UNITS.items()}
        rows = rows_of(lines[:end], table + 1, len(words), path)
        columns = columns_of(words, [known[word] for word in words], rows, path, f" of value {value}")
        x, y = _place(lines[begin:table])
        told = [" ".join(line.split()) for line in lines[begin - 3 : table] if line.startswith(TOLD)]
        notes = ("the file states no units: mN, um and s are those of the instrument", *told)
        test = f"{name}, block {block}, value {value}" if len(begins) > 1 else name
        yield InstrumentTest("FischerScope, text export", test, columns, notes, x, y)
    if not count:
        raise InvalidInput(f"{path}: none of its tests has a table 'F h t'; export the curves with the results.")


def _place(lines: Sequence[str]) -> tuple[float, float]:
    """Return the place of a test [m]; nan if it is not stated."""
    for line in lines:
        if match := PLACE.match(line):
            x, y = (float(number.replace(",", ".")) * 1e-3 for number in match.groups())
            return x, y
    return float("nan"), float("nan")
