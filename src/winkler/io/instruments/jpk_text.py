"""Force curves that JPK's programs export as text: a head of ``# key: value`` above the numbers of each segment.

The heights are those of the piezo, which falls as the tip approaches; the deflection stands in N, m or V, and the head
states what makes a force of it.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from winkler.io.instruments.cantilever import force_factor
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest
from winkler.io.instruments.number_block import rows_of, stated_number
from winkler.io.segments import directions, segment_fact
from winkler.io.tables.given_units import GivenFacts
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

SETTING = re.compile(r"#\s*+([A-Za-z][\w.-]{0,80}):\s?(.*)")
HEIGHTS = (
    "smoothedmeasuredheight", "measuredheight", "capacitivesensorheight", "smoothedcapacitivesensorheight",
    "straingaugeheight", "smoothedstraingaugeheight", "height",
)  # fmt: skip
"""Columns of heights, those that were measured before that which was demanded."""
TIP_PLACES = ("verticaltipposition", "tipsampleseparation")
"""Columns from which JPK's program has subtracted the bending of the cantilever."""
DEFLECTION, TIMES = "vdeflection", ("seriestime", "time")
PLACES = ("xPosition", "yPosition")


class _SegmentRows(NamedTuple):
    """The settings of a segment, including those above it, and its rows."""

    settings: dict[str, str]
    rows: Array


def is_jpk_text(head: Sequence[str]) -> bool:
    """Return whether comment lines name columns, their units, and a deflection among them."""
    settings = {match[1]: match[2] for match in map(SETTING.match, head) if match}
    return "units" in settings and DEFLECTION in settings.get("columns", "").lower().split()


def tests_of_jpk_text(lines: Sequence[str], name: str, path: object, given: GivenFacts) -> Iterator[InstrumentTest]:
    """Yield the curve of a text, or each of a map, whose segments state the number of their curve.

    Raises
    ------
    InvalidInput
        If segments differ in their columns, there is no height, or nothing makes a force of the deflection.
    """
    curves = [
        (number, list(segments))
        for number, segments in itertools.groupby(_segments(lines, path), lambda one: one.settings.get("index", ""))
    ]
    for number, segments in curves:
        yield _test(segments, name if len(curves) == 1 else f"{name}, curve {number}", path, given)


def _test(segments: Sequence[_SegmentRows], name: str, path: object, given: GivenFacts) -> InstrumentTest:
    """Return one curve from its segments."""
    first = segments[0].settings
    if any(one.settings[key] != first[key] for one in segments for key in ("columns", "units")):
        raise InvalidInput(f"{path}: its segments differ in their columns or units; export each to a file of its own.")
    words, units = first["columns"].split(), first["units"].split()
    if len(words) != len(units):
        raise InvalidInput(f"{path}: it names {len(words)} columns and {len(units)} units; export the curve again.")
    places = {word.lower(): place for place, word in enumerate(words)}
    clock = next((word for word in TIMES if word in places), "")
    segments, turned = _turned(segments, places[clock]) if clock else (segments, 0)
    rows = np.concatenate([one.rows for one in segments])
    height = next((word for word in (*HEIGHTS, *TIP_PLACES) if word in places), "")
    if not height:
        raise InvalidInput(f"{path}: none of its columns {', '.join(words)} is a height; export one, too.")
    of_tip = height in TIP_PLACES
    place = "depth" if of_tip else "position"
    spring = given.spring_constant or stated_number(first, "springConstant")
    stated = given.sensitivity or stated_number(first, "sensitivity")
    origin = "given" if given.sensitivity else "from the file"
    factor, facts = force_factor(units[places[DEFLECTION]], spring, stated, origin, path)
    position, force = -rows[:, places[height]], rows[:, places[DEFLECTION]] * factor
    numbers = np.repeat(np.arange(len(segments)), [len(one.rows) for one in segments])
    kinds = ", ".join(one.settings.get("segment", "?") for one in segments)
    columns = [InstrumentColumn(place, units[places[height]], position), InstrumentColumn("force", "N", force)]
    if clock:
        columns.append(InstrumentColumn("time", units[places[clock]], rows[:, places[clock]]))
    notes = (
        f"{place} from '{words[places[height]]}', its sign changed, force from '{words[places[DEFLECTION]]}'",
        *facts,
        f"segments {kinds}; {segment_fact(position, force, numbers, 'segment')}",
        *([f"{turned} of {len(segments)} segments, written backwards, are turned round"] if turned else []),
    )
    x, y = (stated_number(first, key) for key in PLACES)
    return InstrumentTest(
        "JPK, text export",
        name,
        tuple(columns),
        notes,
        float("nan") if x is None else x,
        float("nan") if y is None else y,
        directions(position, force, numbers),
        spring_constant=math.inf if of_tip else spring,
    )


def _turned(segments: Sequence[_SegmentRows], clock: int) -> tuple[list[_SegmentRows], int]:
    """Return the segments with their rows in the order of time, and how many were written backwards.

    Older programs wrote the retraction from its end, so that approach and retraction have one order of heights.
    """
    fall = [bool(np.all(np.diff(one.rows[:, clock]) < 0.0)) and len(one.rows) > 1 for one in segments]
    turned = [one._replace(rows=one.rows[::-1]) if falls else one for one, falls in zip(segments, fall, strict=True)]
    return turned, sum(fall)


def _segments(lines: Sequence[str], path: object) -> list[_SegmentRows]:
    settings: dict[str, str] = {}
    segments = []
    above = True
    for index, line in enumerate(lines):
        if match := SETTING.match(line):
            settings[match[1]] = match[2].strip()
            above = True
        elif above and line.strip() and not line.startswith("#"):
            above = False
            if "columns" in settings and "units" in settings:
                count = len(settings["columns"].split())
                block = rows_of(lines, index, count, path, separator=None)
                segments.append(_SegmentRows(dict(settings), block))
    segments = [one for one in segments if len(one.rows)]
    if not segments:
        raise InvalidInput(f"{path}: there are no numbers below the names of the columns; export the curve again.")
    return segments
