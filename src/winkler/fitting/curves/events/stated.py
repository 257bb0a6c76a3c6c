"""Events that are stated by points, in place of those that are found."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest

NOTHING, FREE = 0.0, 1.0
MARKS = {"baseline": FREE, "pop-in": 2.0, "snap-in": 3.0, "pull-off": 4.0}
"""Events that can be stated, and their marks in `ForceCurve.marks`."""


def stated_marks(stated: Sequence[tuple[str, int, int]], count: int) -> Array:
    """Return the marks ``(count,)`` of events stated by kind, first and last point.

    Parameters
    ----------
    stated : sequence of (str, int, int)
        "baseline", "pop-in", "snap-in" or "pull-off"; empty: nothing happened.
    count : int
        Number of points of the curve.

    Raises
    ------
    InvalidInput
        If a kind is unknown, or a range leaves the curve.
    """
    marks = np.full(count, NOTHING)
    for place, line in enumerate(stated):
        try:
            kind, first, last = line
        except (TypeError, ValueError):
            raise InvalidInput(
                f"events: line {place} is {line!r}; give a kind, its first and its last point, as ('pop-in', 120, 121)."
            ) from None
        if kind not in MARKS:
            raise InvalidInput(
                f"events: line {place} is a '{kind}'{suggest(str(kind), MARKS)}; give {', '.join(MARKS)}."
            )
        numbers = [not isinstance(end, bool) and isinstance(end, int | np.integer) for end in (first, last)]
        if not all(numbers) or not 0 <= first <= last < count:
            raise InvalidInput(
                f"events: line {place} spans the points {first!r} to {last!r}; give indices from 0 to {count - 1}, the "
                "first not above the last."
            )
        marks[first : last + 1] = MARKS[kind]
    return marks
