"""Segments of a measurement: on which the tip goes in, is held, and comes out."""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.directions import HELD, IN, OUT, found_directions
from winkler.numerics.types import Array

__all__ = ["directions"]

FEWEST = 10
"""Of a segment of fewer points the ends are compared."""
FAR = 0.5
"""Part of the whole way that no tip goes while it is held."""
TRAVELLED = 0.1
"""Part of the whole way between the ends of such a segment, if the tip is not held."""
STEADY = 0.02
"""A force that changes by less of itself is held."""


def directions(position: Array, force: Array, segment: Array) -> Array:
    """Return +1 where the tip goes in, 0 where it is held and -1 where it comes out ``(n,)``.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N].
    segment : ndarray, (n,) or (0,)
        A number for each segment: what most of its points do counts for all of them.  Where segments are not told, the
        tip is held if the force or the position is steady all the time, and nothing is returned otherwise.
    """
    if not segment.size:
        steady = np.ptp(force) < STEADY * np.abs(force).max(initial=0.0) or np.ptp(position) == 0.0
        return np.full(position.size, HELD) if steady else np.zeros(0)
    found, direction, span = np.zeros(0), np.empty(position.size), np.ptp(position)
    for part in np.unique(segment):
        (mine,) = np.nonzero(segment == part)
        travel = position[mine[-1]] - position[mine[0]]
        if mine.size < FEWEST or abs(travel) > FAR * span:
            direction[mine] = np.sign(travel) if abs(travel) > TRAVELLED * span else HELD
            continue
        found = found if found.size else found_directions(position, force)
        ways = [np.count_nonzero(found[mine] == way) for way in (IN, OUT, HELD)]
        direction[mine] = (IN, OUT, HELD)[int(np.argmax(ways))]
    return direction
