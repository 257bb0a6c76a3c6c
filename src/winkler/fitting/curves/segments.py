"""The segments of a force curve: loading, holds, partial unloadings, and the last unloading, which is evaluated."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

import numpy as np

from winkler.fitting.curves.directions import HELD, IN, OUT
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value, words

LEAST_PEAK_SHARE = 0.9
"""Least force at the start of the last unloading, relative to the greatest."""


class SegmentKind(Enum):
    """Kinds of segments."""

    LOADING = "loading"
    HOLD = "hold"
    PARTIAL_UNLOADING = "partial unloading"
    LAST_UNLOADING = "last unloading"


KIND_DIRECTIONS = {"loading": IN, "hold": HELD, "unloading": OUT, "partial unloading": OUT, "last unloading": OUT}


@value
class Segment:
    """A part of one direction.

    Parameters
    ----------
    kind : SegmentKind
        loading, hold, partial unloading, or last unloading: the last one from (nearly) the maximum force.  A hold
        within it does not end it, and what comes after that hold belongs to it.
    first, last : int
        Indices of its first and last point in the curve.
    """

    __words__ = words(
        kind=("", None, "loading, hold, partial unloading or last unloading"),
        first=("", None, "index of the first point"),
        last=("", None, "index of the last point"),
    )

    kind: SegmentKind
    first: int
    last: int

    @property
    def count(self) -> int:
        """Number of points."""
        return self.last - self.first + 1


def segments_of(direction: Array, force: Array) -> tuple[Segment, ...]:
    """Return the segments of a curve, in the order in which they were measured.

    Parameters
    ----------
    direction : ndarray, (n,)
        +1 where the tip goes in, 0 where it is held, -1 where it comes out.
    force : ndarray, (n,)
        [N].
    """
    turns = np.flatnonzero(np.diff(direction)) + 1
    ends = [(int(part[0]), int(part[-1])) for part in np.split(np.arange(direction.size), turns)]
    directions = [float(direction[first]) for first, _ in ends]
    tops: dict[int, float] = {}
    """First segment of each unloading, and the force at its start."""
    start = -1
    for place, sign in enumerate(directions):
        if sign == IN:
            start = -1
        elif sign == OUT and start < 0:
            start = place
            first = ends[place][0]
            tops[place] = float(force[max(first - 1, 0) : first + 1].max())
    greatest = max(tops.values(), default=0.0)
    last = max(
        (place for place, top in tops.items() if top >= LEAST_PEAK_SHARE * greatest), default=max(tops, default=-1)
    )
    after = next((place for place in range(max(last, 0), len(directions)) if directions[place] == IN), len(directions))
    kinds = {IN: SegmentKind.LOADING, HELD: SegmentKind.HOLD, OUT: SegmentKind.PARTIAL_UNLOADING}
    return tuple(
        Segment(SegmentKind.LAST_UNLOADING if sign == OUT and last <= place < after else kinds[sign], *ends[place])
        for place, sign in enumerate(directions)
    )


def stated_directions(stated: Sequence[tuple[str, int]], count: int) -> Array:
    """Return the directions ``(count,)`` of segments that are stated by kind and first point.

    Parameters
    ----------
    stated : sequence of (str, int)
        "loading", "hold" or "unloading", and the index of the first point; each lasts until the next one begins.
    count : int
        Number of points of the curve.

    Raises
    ------
    InvalidInput
        If a kind is unknown, or the first points do not begin at 0 and grow.
    """
    direction = np.empty(count)
    before = -1
    for place, line in enumerate(stated):
        try:
            kind, first = line
        except (TypeError, ValueError):
            raise InvalidInput(
                f"segments: line {place} is {line!r}; give a kind and its first point, as ('hold', 120)."
            ) from None
        if kind not in KIND_DIRECTIONS:
            raise InvalidInput(
                f"segments: line {place} is a '{kind}'{suggest(str(kind), KIND_DIRECTIONS)}; give loading, hold or "
                "unloading."
            )
        is_integer = not isinstance(first, bool) and isinstance(first, int | np.integer)
        if not is_integer or not before < first < count or (place == 0 and first != 0):
            raise InvalidInput(
                f"segments: line {place} begins at the point {first!r}; begin at 0, and give growing indices below "
                f"{count}, the number of points."
            )
        direction[first:] = KIND_DIRECTIONS[kind]
        before = int(first)
    if before < 0:
        raise InvalidInput("segments: none are given; state them as ('loading', 0), ('hold', 120), ('unloading', 180).")
    return direction
