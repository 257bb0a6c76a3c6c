"""``segments`` of ``[fit]``: the segments of a curve, stated instead of detected.

::

    segments = ["loading 0 s", "hold 12 s", "unloading 17 s"]    # times, or numbers of points: "hold 1200"
    segments = "found"                                          # detected from the curve, whatever the file states
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.directions import found_directions
from winkler.fitting.curves.segments import SegmentKind
from winkler.study.language.quantities import WHERE, wrong
from winkler.units import quantity

__all__ = ["FOUND", "segmented", "segments_text", "stated_segments"]

FOUND = "found"
EXAMPLE = '["loading 0 s", "hold 12 s", "unloading 17 s"]'
MOST_LISTED = 12


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
