"""``segments`` and ``events`` of ``[fit]``: the segments of a curve, and what happened, stated instead of detected.

::

    segments = ["loading 0 s", "hold 12 s", "unloading 17 s"]    # times, or numbers of points: "hold 1200"
    segments = "found"                                          # detected from the curve, whatever the file states
    events = ["baseline 0 s to 2.5 s", "pop-in 3.1 s"]          # also snap-in and pull-off
    events = "none"                                             # nothing happened
"""

from __future__ import annotations

import dataclasses
import re
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.directions import found_directions
from winkler.fitting.curves.events.stated import MARKS
from winkler.fitting.curves.segments import SegmentKind
from winkler.study.language.quantities import WHERE, wrong
from winkler.values.errors import InvalidInput, suggest
from winkler.values.units import quantity

FOUND, NONE = "found", "none"
EXAMPLE = '["loading 0 s", "hold 12 s", "unloading 17 s"]'
MOST_LISTED = 12
EVENTS_EXAMPLE = '["baseline 0 s to 2.5 s", "pop-in 3.1 s"]'
EVENT = re.compile(r"\s*([a-z]+(?:-[a-z]+)?)\s+(\S.*?)(?:\s+to\s+(\S.*?))?\s*")


def stated_segments(raw: Any) -> tuple[str, ...]:
    """Refuse what is neither "found" nor a list of kinds with their beginnings."""
    if raw in (FOUND, [FOUND]):
        return (FOUND,)
    if not isinstance(raw, list | tuple) or not raw or not all(isinstance(item, str) for item in raw):
        wrong(f"{WHERE} is {raw!r}; give 'found', or a list of kinds with their beginnings, such as {EXAMPLE}.")
    for item in raw:
        if item == FOUND or not item.partition(" ")[2].strip():
            wrong(f"{WHERE} holds '{item}', which has no beginning; give a list such as {EXAMPLE}.")
    return tuple(raw)


def segmented(curve: ForceCurve, stated: tuple[str, ...]) -> ForceCurve:
    """Return a curve with the segments that are stated.

    Parameters
    ----------
    curve : ForceCurve
    stated : tuple of str
        From `stated_segments`.

    Raises
    ------
    InvalidInput
        If a kind or a beginning is none, or times are stated of a curve that has none.
    """
    if stated == (FOUND,):
        return dataclasses.replace(curve, direction=found_directions(curve.position, curve.force))
    return curve.with_segments([_line(item, curve) for item in stated])


def _line(text: str, curve: ForceCurve) -> tuple[str, int]:
    kind, beginning = _parts(text)
    if beginning.isdigit():
        return kind, int(beginning)
    start = quantity(beginning, "s", what=f"fit.segments, '{text}'")
    if not curve.timed:
        raise InvalidInput(f"fit.segments: '{text}' is a time, and the curve has none; state the number of the point.")
    return kind, int(np.searchsorted(curve.time, start))


def _parts(text: str) -> tuple[str, str]:
    """Return kind and beginning of a line such as 'partial unloading 12.5 s'."""
    for place, mark in enumerate(text):
        if mark.isdigit() or mark in "+-.":
            return text[:place].strip(), text[place:].strip()
    raise InvalidInput(f"fit.segments: '{text}' has no beginning; give a list such as {EXAMPLE}.")


def segments_text(curve: ForceCurve) -> tuple[str, ...]:
    """Return a sentence about the segments of a curve that is more than one loading and one unloading."""
    parts = curve.segments
    kinds = [part.kind for part in parts]
    plain = ([SegmentKind.LOADING], [SegmentKind.LAST_UNLOADING], [SegmentKind.LOADING, SegmentKind.LAST_UNLOADING])
    if kinds in plain:
        return ()
    listed = [f"{part.kind.value} ({part.first} to {part.last})" for part in parts[:MOST_LISTED]]
    more = f" and {len(parts) - MOST_LISTED} more" if len(parts) > MOST_LISTED else ""
    return (f"segments: by the numbers of their points, {', '.join(listed)}{more}.",)


def stated_events(raw: Any) -> tuple[str, ...]:
    """Refuse what is neither "found", "none" nor a list of events with their points or times."""
    if raw in (FOUND, [FOUND]):
        return ()
    if raw in (NONE, [NONE]):
        return (NONE,)
    if not isinstance(raw, list | tuple) or not raw or not all(isinstance(item, str) for item in raw):
        wrong(f"{WHERE} is {raw!r}; give 'found', 'none', or a list of events, such as {EVENTS_EXAMPLE}.")
    for item in raw:
        line = EVENT.fullmatch(item)
        if line is None:
            wrong(f"{WHERE} holds '{item}', which is no event with its place; give a list such as {EVENTS_EXAMPLE}.")
        elif line[1] not in MARKS:
            wrong(f"{WHERE} holds '{item}', a '{line[1]}'{suggest(line[1], MARKS)}; there are {', '.join(MARKS)}.")
    return tuple(raw)


def with_stated_events(curve: ForceCurve, stated: tuple[str, ...]) -> ForceCurve:
    """Return a curve with the events that are stated; the same if none are.

    Parameters
    ----------
    curve : ForceCurve
    stated : tuple of str
        From `stated_events`.

    Raises
    ------
    InvalidInput
        If a place is none, or lies outside the curve, or times are stated of a curve that has none.
    """
    if not stated:
        return curve
    return curve.with_events([] if stated == (NONE,) else [_event(item, curve) for item in stated])


def _event(text: str, curve: ForceCurve) -> tuple[str, int, int]:
    line = EVENT.fullmatch(text)
    if line is None:
        raise InvalidInput(f"fit.events: '{text}' is no event with its place; give a list such as {EVENTS_EXAMPLE}.")
    kind, begin, end = line.groups()
    first = _point(begin, text, curve)
    return kind, first, first if end is None else _point(end, text, curve)


def _point(place: str, text: str, curve: ForceCurve) -> int:
    if place.isdigit():
        return int(place)
    moment = quantity(place, "s", what=f"fit.events, '{text}'")
    if not curve.timed:
        raise InvalidInput(f"fit.events: '{text}' is a time, and the curve has none; state the number of the point.")
    return min(int(np.searchsorted(curve.time, moment)), curve.count - 1)


def events_text(stated: tuple[str, ...]) -> tuple[str, ...]:
    """Return a sentence about the events that are stated; empty if none are."""
    if not stated:
        return ()
    if stated == (NONE,):
        return ("events: stated as none; snap-in, pop-ins and pull-off were not sought.",)
    return (f"events: as stated, {', '.join(stated)}.",)
