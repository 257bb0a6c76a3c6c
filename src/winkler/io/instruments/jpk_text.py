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

from winkler.errors import InvalidInput
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest, measures
from winkler.io.instruments.number_block import rows_of
from winkler.io.segments import directions, segment_fact
from winkler.io.tables.given_units import GivenFacts
from winkler.numerics.types import Array
from winkler.units import scale

__all__ = ["is_jpk_text", "tests_of_jpk_text"]

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
    rows = np.concatenate([one.rows for one in segments])
    height = next((word for word in (*HEIGHTS, *TIP_PLACES) if word in places), "")
    if not height:
        raise InvalidInput(f"{path}: none of its columns {', '.join(words)} is a height; export one, too.")
    of_tip = height in TIP_PLACES
    place = "depth" if of_tip else "position"
    spring = given.spring_constant or _number(first, "springConstant")
    factor, facts = _force_factor(units[places[DEFLECTION]], spring, given.sensitivity, first, path)
    position, force = -rows[:, places[height]], rows[:, places[DEFLECTION]] * factor
    numbers = np.repeat(np.arange(len(segments)), [len(one.rows) for one in segments])
    kinds = ", ".join(one.settings.get("segment", "?") for one in segments)
    columns = [
        InstrumentColumn(place, units[places[height]], position),
        InstrumentColumn("force", "N", force),
        *(
            InstrumentColumn("time", units[places[word]], rows[:, places[word]])
            for word in [word for word in TIMES if word in places][:1]
        ),
    ]
    notes = (
        f"{place} from '{words[places[height]]}', its sign changed, force from '{words[places[DEFLECTION]]}'",
        *facts,
        f"segments {kinds}; {segment_fact(position, force, numbers, 'segment')}",
    )
    x, y = (_number(first, key) for key in PLACES)
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


def _force_factor(
    unit: str, spring: float | None, sensitivity: float | None, settings: dict[str, str], path: object
) -> tuple[float, tuple[str, ...]]:
    """Return what makes a force [N] of a deflection in N, m or V, and the facts that were used."""
    if spring is None:
        raise InvalidInput(f"{path}: it states no spring constant, from which the depth follows; give spring_constant.")
    if measures(unit, "N"):
        return scale(unit, "N"), ()
    if measures(unit, "m"):
        return spring * scale(unit, "m"), ()
    stated = sensitivity or _number(settings, "sensitivity")
    if not measures(unit, "V") or stated is None:
        raise InvalidInput(
            f"{path}: the deflection is in {unit} and no sensitivity is stated; give sensitivity in m/V, or export the "
            "curve with a calibrated deflection."
        )
    origin = "given" if sensitivity else "from the file"
    return spring * stated * scale(unit, "V"), (f"sensitivity {stated:g} m/V {origin}",)


def _number(settings: dict[str, str], key: str) -> float | None:
    try:
        return float(settings[key].split()[0])
    except (KeyError, ValueError, IndexError):
        return None
