"""Saturation: the force stays at its largest or least value while the machine moves on."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

FEWEST_EQUAL_POINTS = 5
LEAST_EQUAL_TRAVEL = 0.01
LEAST_TENSION_SHARE = 0.05
"""Least tension over the range of forces for a detector at its lower end."""


def saturated_rows(position: Array, force: Array, level: float) -> tuple[Array, ...]:
    """Return the longest plateaus at the largest and at the least force during motion, as indices; few or none.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N].
    level : float
        Force out of contact [N].
    """
    least = float(force.min())
    # a coarse baseline may be constant, a tension is not
    has_tension = level - least > LEAST_TENSION_SHARE * float(np.ptp(force))
    ends = [float(force.max()), *([least] if has_tension else [])]
    return tuple(row for end in ends if (row := _longest_plateau(position, force, end)).size)


def _longest_plateau(position: Array, force: Array, end: float) -> Array:
    same = np.flatnonzero(force == end)
    rows = np.split(same, np.flatnonzero(np.diff(same) != 1) + 1)
    longest = max(rows, key=len)
    moved = float(np.ptp(position[longest])) if longest.size else 0.0
    enough = longest.size >= FEWEST_EQUAL_POINTS and moved > LEAST_EQUAL_TRAVEL * float(np.ptp(position))
    return longest if enough else longest[:0]
