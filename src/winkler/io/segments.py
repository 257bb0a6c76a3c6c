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
LEAST_FORCE_CHANGE = 0.2
"""Least change of force with the position, relative to the whole, of a stiff contact that hardly travels."""
LEAST_STIFF_TRAVEL, TRAVEL_TO_NOISE = 1e-3, 3.0
"""Least travel of a stiff contact, relative to the whole travel and to the noise of its ends."""
END_SHARE = 20
"""The ends of a segment are means of this part of its points."""


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
        if stiff := _stiff_direction(position, force, inside):
            direction[inside] = stiff
            continue
        if inside.size < LEAST_POINTS or abs(travel) > LARGEST_HOLD_TRAVEL * span:
            direction[inside] = np.sign(travel) if abs(travel) > LEAST_TRAVEL * span else HELD
            continue
        point_directions = point_directions if point_directions.size else found_directions(position, force)
        counts = [np.count_nonzero(point_directions[inside] == sign) for sign in (IN, OUT, HELD)]
        direction[inside] = (IN, OUT, HELD)[int(np.argmax(counts))]
    return direction


def _stiff_direction(position: Array, force: Array, inside: Array) -> float:
    """Return the direction of a segment whose force changes with its position, however little it travels; 0 if not.

    A hold either keeps its position, or its force, or they change against each other as the contact relaxes.
    """
    count = 1 + inside.size // END_SHARE
    begin, end = inside[:count], inside[-count:]
    travel, change = (float(column[end].mean() - column[begin].mean()) for column in (position, force))
    bends = np.abs(np.diff(position[inside], 2))
    noise = float(np.median(bends)) / (0.6745 * np.sqrt(6.0)) * np.sqrt(2.0 / count) if bends.size else 0.0
    least = max(LEAST_STIFF_TRAVEL * float(np.ptp(position)), TRAVEL_TO_NOISE * noise)
    if abs(travel) <= least or abs(change) <= LEAST_FORCE_CHANGE * float(np.ptp(force)) or travel * change <= 0.0:
        return 0.0
    return float(np.sign(travel))
