"""The force under which a body below pixels begins to yield."""

from __future__ import annotations

import math
from collections.abc import Callable

from winkler.values.errors import NotConverged

MOST_TRIALS = 20
SHARE_TOLERANCE = 1e-4
"""By which part the greatest stress may differ from the strength."""
HERTZ_POWER, LEAST_POWER, MOST_POWER = 1.0 / 3.0, 0.02, 3.0
"""Power of the force by which the greatest stress rises: the first guess, and what is believed of others."""
MOST_CHANGE = math.log(20.0)
"""Of the logarithm of the force in one trial."""


def force_at_yield(share: Callable[[float], float], force: float, start: float, owner: str = "SurfaceContact") -> float:
    """Return the force [N] at which the greatest stress is the strength.

    Parameters
    ----------
    share : callable
        Takes a force [N], returns the greatest stress over the strength.
    force, start : float
        A force and its share.
    owner : str
        The problem, for the message.

    Raises
    ------
    NotConverged
        If none is found.
    """
    if abs(start - 1.0) <= SHARE_TOLERANCE:
        return force
    power, before = HERTZ_POWER, (force, start)
    for _ in range(MOST_TRIALS):
        change = -math.log(before[1]) / power
        following = before[0] * math.exp(min(max(change, -MOST_CHANGE), MOST_CHANGE))
        found = share(following)
        if abs(found - 1.0) <= SHARE_TOLERANCE:
            return following
        power = math.log(found / before[1]) / math.log(following / before[0])
        power = min(max(power, LEAST_POWER), MOST_POWER)
        before = following, found
    raise NotConverged(
        f"{owner}: the force at which yielding begins is not found within {MOST_TRIALS} trials; it lies near "
        f"{before[0]:.6g} N: solve contacts around it, and compare their maximum stresses."
    )
