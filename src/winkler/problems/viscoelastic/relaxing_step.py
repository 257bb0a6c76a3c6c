"""One step of a contact with a viscoelastic body: the kernel that is exported to other programs."""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.springs.relaxing_springs import advance_springs
from winkler.numerics.types import Array

SUDDEN = 1e-20
"""Part of the shortest relaxation time in which nothing relaxes, to the last digit: rates over it would overflow."""
ENDLESS = 1e12
"""Of the longest relaxation time, after which all has relaxed; sums over longer ones would overflow."""


@compiled
def step_relaxing(
    solid: Array, moduli: Array, times: Array, rates: Array, displaced: Array, back: Array, forth: Array, modes: Array,
    gap: Array, weight: Array, position: Array, place: Array, memory: Array, pressed: Array, counts: Array,
    course: Array, past: Array, change: Array, span: Array, numbers: Array, motion: Array, answer: Array,
) -> None:  # fmt: skip
    """Move one contact by one step at a steady rate, or suddenly where the step takes no time, or next to none.

    Parameters
    ----------
    solid : ndarray, (3,)
        E* after all relaxation [Pa], viscosity of a dashpot alongside [Pa s], greatest depth [m].
    moduli, times, rates, displaced, back, forth, modes
        The rest of the law of `advance_springs`.
    gap, weight, position : ndarray, (n,)
        Its springs.
    place, memory, pressed, counts : ndarray
        Its state, (n,), (k, n), (n,), (2,).
    course : ndarray, (3,)
        Its motion: depth, whether it last rose, rate.
    past : ndarray, (2,)
        Work and loss since the beginning [J].
    change, span, numbers
        Work space, (1,), (1,), (1, 10).
    motion : ndarray, (2,)
        Depth at the end of the step [m], its duration [s].
    answer : ndarray, (6,)
        Force [N], radius [m], work, stored energy, loss [J], 1 where the contact is no disc.
    """
    if motion[0] > solid[2] or not math.isfinite(motion[0]) or not motion[1] >= 0.0:
        for k in range(answer.size):
            answer[k] = math.nan
        return
    change[0] = motion[0] - course[0]
    quick = motion[1]
    slow = 0.0
    for i in range(times.size):
        quick = min(quick, SUDDEN * times[i])
        slow = max(slow, ENDLESS * times[i])
    span[0] = min(motion[1], slow) if motion[1] > quick else 0.0
    law = (solid[0], solid[1], moduli, times, rates, displaced, back, forth, modes)
    advance_springs(law, (gap, weight, position), (place, memory, pressed, counts), course, change, span, numbers)
    past[0] += numbers[0, 2]
    past[1] += numbers[0, 9]
    answer[0] = numbers[0, 0]
    answer[1] = numbers[0, 6]
    answer[2] = past[0]
    answer[3] = numbers[0, 5]
    answer[4] = past[1]
    answer[5] = numbers[0, 8]
