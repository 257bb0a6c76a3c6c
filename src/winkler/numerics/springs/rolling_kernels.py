r"""A line of springs that rolls to and fro, step by step: each step carries every spring on by one place.

In the frame of the contact the springs come in at one end with no load and leave at the other, so that one array over
the places of the contact is the whole state.  In a step a spring gains what the bodies shift, times its stiffness, and
is cut back to its bound; one that has come in within the step gains only its part of it.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

MOST_ITERATIONS = 200
FORCE_TOLERANCE = 1e-15
"""Of the sliding force, within which a prescribed force is met."""


@compiled
def moved(load: Array, bound: Array, part: float, direction: int, gain: float, result: Array) -> None:
    """Write what springs bear after one step: carried on, pulled and cut back.

    Parameters
    ----------
    load, bound : ndarray, (n,)
        What they bear and can bear, along x.
    part
        How much of the step a spring that comes in takes part in, 0 to 1.
    direction
        1 if the contact moves towards +x, -1 if towards -x, 0 if it stays.
    gain
        What a spring gains that sticks all along.
    result : ndarray, (n,)
        Receives the result.
    """
    last = load.size - 1
    for k in range(load.size):
        source = k + direction
        value = part * gain if source < 0 or source > last else load[source] + gain
        result[k] = min(max(value, -bound[k]), bound[k])


@compiled
def roll(load: Array, bound: Array, part: float, gain: float, count: int) -> None:
    """Roll towards +x with a prescribed shift.

    Parameters
    ----------
    load : ndarray, (n,)
        What the springs bear; is changed.
    bound : ndarray, (n,)
        What they can bear.
    part, gain
        As in `moved`.
    count
        Number of steps.
    """
    result = np.empty(load.size)
    for _ in range(count):
        moved(load, bound, part, 1, gain, result)
        for k in range(load.size):
            load[k] = result[k]


@compiled
def push(
    load: Array, bound: Array, weight: Array, part: float, direction: int, force: float, count: int
) -> tuple[float, bool]:
    """Roll under a prescribed force, and return what sticking springs have gained, and whether friction bears it.

    Parameters
    ----------
    load : ndarray, (n,)
        What the springs bear; is changed.
    bound, weight : ndarray, (n,)
        What they can bear, and the length each stands for.
    part, direction
        As in `moved`.
    force
        The sum of load times weight after every step.
    count
        Number of steps.
    """
    result, gained = np.empty(load.size), 0.0
    capacity, most = 0.0, 0.0
    for k in range(load.size):
        capacity += weight[k] * bound[k]
        most = max(most, bound[k])
    for _ in range(count):
        low, high = -2.0 * most, 2.0 * most
        gain, best = 0.0, np.inf
        for _ in range(MOST_ITERATIONS):
            moved(load, bound, part, direction, gain, result)
            missing, slope = force, 0.0
            for k in range(load.size):
                missing -= weight[k] * result[k]
                if abs(result[k]) < bound[k]:
                    source = k + direction
                    slope += weight[k] * (part if source < 0 or source >= load.size else 1.0)
            best = min(best, abs(missing))
            if abs(missing) <= FORCE_TOLERANCE * capacity:
                break
            if missing > 0.0:
                low = gain
            else:
                high = gain
            following = gain + missing / slope if slope > 0.0 else low - 1.0
            if not low < following < high:
                following = 0.5 * (low + high)
            if following == gain or high - low <= FORCE_TOLERANCE * most:
                break
            gain = following
        if best > 1e-9 * capacity:
            return gained, False
        for k in range(load.size):
            load[k] = result[k]
        gained += gain
    return gained, True
