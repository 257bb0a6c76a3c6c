"""Files of Hysitron indenters: ``.hld`` with all settings, and the text export of nanoDMA.

In an ``.hld`` the column of the displacement has the compliance of the machine and the drift already subtracted: it is
the polynomial of the detector's voltage, less "Machine Comp" times the force, less "Drift Rate" times the time.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.io.instruments.instrument_test import InstrumentTest
from winkler.io.instruments.number_block import columns_of, rows_of, split_unit
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

SETTING = re.compile(r"([^:]{1,60}):[ \t]*(.*)")
TOLD = ("Machine Comp", "Drift Rate", "Disp Shift", "Force Shift", "Tip ID", "FB Mode")
"""Settings that the reading repeats."""
POINTS = "Test Data Points"


def is_hld(head: Sequence[str]) -> bool:
    """Return whether a text begins as an ``.hld`` does."""
    return bool(head) and head[0].startswith("File Version: Hysitron")


def is_nano_dma(head: Sequence[str]) -> bool:
    """Return whether a text begins as an export of nanoDMA does."""
    return bool(head) and head[0].startswith("nanoDMA Text Export")


def tests_of_hld(lines: Sequence[str], name: str, path: object) -> Iterator[InstrumentTest]:
    """Yield the one test of an ``.hld``.

    Raises
    ------
    InvalidInput
        If the test data are missing or incomplete.
    """
    settings: dict[str, str] = {}
    segments: list[dict[str, str]] = []
    for line in lines:
        if (match := SETTING.fullmatch(line.rstrip())) is None:
            continue
        word, content = match.groups()
        if word == "Segment Number":
            segments.append({})
        if segments and word.startswith("Segment "):
            segments[-1][word] = content
        settings.setdefault(word, content)
    start = next((index for index, line in enumerate(lines) if line.startswith(POINTS)), None)
    if start is None or start + 1 >= len(lines):
        raise InvalidInput(f"{path}: the file has no '{POINTS}'; it ends before the test, so save it anew.")
    names, units = zip(*(split_unit(cell) for cell in lines[start + 1].rstrip().split("\t")), strict=True)
    rows = rows_of(lines, start + 2, len(names), path)
    stated = settings[POINTS].strip()
    if stated.isdecimal() and int(stated) != len(rows):
        raise InvalidInput(f"{path}: the file states {stated} points of the test and holds {len(rows)}; save it anew.")
    notes = [f"{word} {settings[word].strip()}" for word in TOLD if settings.get(word, "").strip()]
    notes.insert(0, "the instrument has subtracted the compliance of the machine and the drift from the displacement")
    yield InstrumentTest(
        settings["File Version"].strip() + ", .hld",
        name,
        columns_of(names, units, rows, path),
        tuple(notes),
        direction=_directions(segments, len(rows)),
    )


def _directions(segments: Sequence[dict[str, str]], count: int) -> Array:
    """Return the directions of the demanded segments; none if their points are not those of the file."""
    try:
        points = [int(segment["Segment Points"]) for segment in segments]
        demands = [
            [float(segment[f"Segment {end} Demand"].split()[0]) for end in ("Begin", "End")] for segment in segments
        ]
    except (KeyError, ValueError, IndexError):
        return np.zeros(0)
    if sum(points) != count:
        return np.zeros(0)
    return np.repeat([float(np.sign(end - begin)) for begin, end in demands], points)


def tests_of_nano_dma(lines: Sequence[str], name: str, path: object) -> Iterator[InstrumentTest]:
    """Yield the one test of an export of nanoDMA.

    Raises
    ------
    InvalidInput
        If it has no table.
    """
    header = next((index for index, line in enumerate(lines) if "(nm)" in line and "\t" in line), None)
    if header is None:
        raise InvalidInput(f"{path}: the export of nanoDMA has no header with units; export it again.")
    names, units = zip(*(split_unit(cell) for cell in lines[header].strip().split("\t")), strict=True)
    rows = rows_of(lines, header + 1, len(names), path)
    yield InstrumentTest("Hysitron nanoDMA, text export", name, columns_of(names, units, rows, path))
