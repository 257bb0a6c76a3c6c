"""Directions of the segments of a measurement: the tip approaches, is held, or retracts."""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.directions import HELD, IN, OUT, found_directions
from winkler.numerics.types import Array

__all__ = ["directions"]

LEAST_POINTS = 10
"""Of a segment with fewer points only its ends are compared."""
LARGEST_HOLD_TRAVEL = 0.5
"""Largest travel during a hold, relative to the whole travel."""
LEAST_TRAVEL = 0.1
"""Least travel between the ends of a short segment in which the tip is not held, relative to the whole travel."""
STEADY_FORCE_CHANGE = 0.02
"""Relative change of force below which the force is held."""


def directions(position: Array, force: Array, segment: Array) -> Array:
    """Return +1 where the tip approaches, 0 where it is held and -1 where it retracts ``(n,)``.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N].
    segment : ndarray, (n,) or (0,)
        The segment number of each point; the direction of most points of a segment holds for all of them.  Without
        segments the tip is held if the force or the position is constant throughout, else an empty array is returned.
    """
    if not segment.size:
        steady = np.ptp(force) < STEADY_FORCE_CHANGE * np.abs(force).max(initial=0.0) or np.ptp(position) == 0.0
        return np.full(position.size, HELD) if steady else np.zeros(0)
    point_directions, direction, span = np.zeros(0), np.empty(position.size), np.ptp(position)
    for part in np.unique(segment):
        (inside,) = np.nonzero(segment == part)
        travel = position[inside[-1]] - position[inside[0]]
        if inside.size < LEAST_POINTS or abs(travel) > LARGEST_HOLD_TRAVEL * span:
            direction[inside] = np.sign(travel) if abs(travel) > LEAST_TRAVEL * span else HELD
            continue
        point_directions = point_directions if point_directions.size else found_directions(position, force)
        counts = [np.count_nonzero(point_directions[inside] == sign) for sign in (IN, OUT, HELD)]
        direction[inside] = (IN, OUT, HELD)[int(np.argmax(counts))]
    return direction
