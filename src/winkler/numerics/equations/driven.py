"""The motion under which a row of springs that stick and slide bears a given load."""

from __future__ import annotations

import math
from collections.abc import Callable

MOST_TRIALS = 200
"""At most so many motions are tried."""


def driven(bears: Callable[[float], tuple[float, float]], target: float, guess: float, slack: float) -> float | None:
    """Return a motion under which springs bear a load; None if none is found.

    Parameters
    ----------
    bears : callable
        Takes a motion; returns the load, which never falls with it, and a positive stiffness: that of the springs which
        stick, or of all.  It is called last with the motion that is returned.
    target : float
        The load.
    guess : float
        Where the search begins.
    slack : float
        By how much the load may be missed.

    Examples
    --------
    Two springs, of which the softer one slides from a load of 1 on:

    >>> driven(lambda u: (min(u, 1.0) + 2.0 * u, 3.0 if u < 1.0 else 2.0), 5.0, 0.0, 1e-12)
    2.0
    """
    motion, low, high = guess, -math.inf, math.inf
    low_miss = high_miss = 0.0
    before = math.inf
    last: tuple[float, float, float] | None = None
    for tried in range(MOST_TRIALS):
        load, stiffness = bears(motion)
        miss = load - target
        if abs(miss) <= slack or (low < high and math.nextafter(low, high) >= high):
            return motion
        if miss < 0.0:
            low, low_miss = motion, miss
        else:
            high, high_miss = motion, miss
        ahead = _root((motion, miss, stiffness), last)
        last = motion, miss, stiffness
        settles, before = abs(miss) <= 0.5 * before, abs(miss)
        if math.isfinite(low) and math.isfinite(high) and not (low < ahead < high and settles):
            share = -low_miss / (high_miss - low_miss) if tried % 2 else 0.5
            ahead = low + (high - low) * min(max(share, 0.01), 0.99)
        if ahead == motion:
            return motion
        motion = ahead
    return None


def _root(here: tuple[float, float, float], before: tuple[float, float, float] | None) -> float:
    """Return where a load is met, from motion, miss and stiffness of the last two tries."""
    twist, miss, stiffness = here
    newton = twist - miss / stiffness
    if before is None or miss == before[1]:
        return newton
    # the motion as a cubic of the miss, which has both values and both slopes
    change, part = miss - before[1], -before[1] / (miss - before[1])
    slopes = (1.0 - part) / before[2] - part / stiffness
    cubic = before[0] + part * (part * (3.0 - 2.0 * part) * (twist - before[0]) + (1.0 - part) * change * slopes)
    return cubic if abs(cubic - newton) < 0.5 * abs(newton - twist) else newton
