"""Segments of a measurement: on which the tip goes in, is held, and comes out."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

__all__ = ["directions"]

IN, HELD, OUT = 1.0, 0.0, -1.0
TRAVELLED = 0.1
"""Part of the whole way that the tip goes in a segment in which it is not held."""
STEADY = 0.02
"""A force that changes by less of itself is held."""


def directions(position: Array, force: Array, segment: Array) -> Array:
    """Return +1 where the tip goes in, 0 where it is held and -1 where it comes out ``(n,)``.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N].
    segment : ndarray, (n,) or (0,)
        A number for each segment.  Where segments are not told, the tip is held if the force or the position is steady
        all the time, and nothing is returned otherwise.
    """
    span = np.ptp(position)
    if not segment.size:
        steady = np.ptp(force) < STEADY * np.abs(force).max(initial=0.0) or span == 0.0
        return np.full(position.size, HELD) if steady else np.zeros(0)
    direction = np.zeros(position.size)
    for part in np.unique(segment):
        (members,) = np.nonzero(segment == part)
        travel = position[members[-1]] - position[members[0]]
        direction[members] = (IN if travel > 0.0 else OUT) if abs(travel) > TRAVELLED * span else HELD
    return direction
