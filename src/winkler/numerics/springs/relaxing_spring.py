r"""One relaxing spring under a rigid body, carried from event to event: exact within a step, however long.

Its arguments are those of `winkler.numerics.springs.relaxing_springs`, which carries rows of them.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.integrals.exponential_integrals import fading, losses
from winkler.numerics.jit import compiled

MOST_EVENTS = 64
"""More within one step are rounding: a line and m exponentials vanish together m + 1 times at most."""
MOST_TRIALS = 200
TIME_TOLERANCE = 1e-15
"""Part of its time, or of the shortest relaxation time, to which an event is found."""
FIRST_TRIAL_RATIO = 1e-3
"""Part of a bracket that is tried next where nothing is known of its beginning."""


@compiled
def rotated(offset, matrix, u, memory, spare):  # type: ignore[no-untyped-def]
    """Turn memories of a pressed spring into those of a free one, or back."""
    for k in range(memory.size):
        spare[k] = 0.0
        if k < matrix.shape[0]:
            spare[k] = offset[k] * u
            for i in range(matrix.shape[1]):
                spare[k] += matrix[k, i] * memory[i]
    for k in range(memory.size):
        memory[k] = spare[k]


@compiled
def jump(law, gap, depth, change, u, memory, pressed, spare):  # type: ignore[no-untyped-def]
    """Move one spring by a sudden change of depth; return place, whether it is pressed, its load, and work."""
    relaxed, moduli = law[0], law[2]
    glassy, q, part = relaxed + np.sum(moduli), 0.0, depth + change - gap - u
    if pressed:
        q = relaxed * u
        for i in range(moduli.size):
            q += memory[i]
        part = change if q + glassy * change >= 0.0 else -q / glassy
    elif part > 0.0:
        rotated(law[5], law[7], 0.0, memory, spare)
    else:
        return u, False, 0.0, 0.0
    # a jump of linear springs: the mean of the forces at its ends does the work of the part that is pressed
    work = (q + 0.5 * glassy * part) * part
    for i in range(moduli.size):
        memory[i] += moduli[i] * part
    if pressed and part != change:
        rotated(law[5], law[6], u + part, memory, spare)
        return u + part, False, 0.0, work
    return u + part, True, q + glassy * part, work


@compiled
def _allowance(law, gap, place, rate, u, memory, pressed, t):  # type: ignore[no-untyped-def]
    """Return what must not fall below zero, at the time t of steady motion: the load, or the distance of the body."""
    if pressed:
        q = law[0] * (u + rate * t) + law[1] * rate
        for i in range(law[2].size):
            gone = -np.expm1(-t / law[3][i])
            q += memory[i] * (1.0 - gone) + law[2][i] * law[3][i] * rate * gone
        return q
    distance = gap - place - rate * t
    for k in range(law[4].size):
        distance += memory[k] * np.exp(-law[4][k] * t)
    return distance


@compiled
def carry(law, gap, depth, rate, dt, u, mine, pressed, spare, phi):  # type: ignore[no-untyped-def]
    """Carry one spring through a step; return place, whether it is pressed, its load at the end, impulse and loss."""
    relaxed, viscosity, moduli, times, rates = law[0], law[1], law[2], law[3], law[4]
    left, place, impulse, lost, caught, quick = dt, depth, 0.0, 0.0, False, dt
    for i in range(times.size):
        quick = min(quick, times[i])
    for events in range(MOST_EVENTS + 1):
        begin = _allowance(law, gap, place, rate, u, mine, pressed, 0.0)
        # what has just been caught bears nothing yet; below zero is rounding
        begin = max(begin, 0.0) if caught else begin
        end = _allowance(law, gap, place, rate, u, mine, pressed, left)
        turns = (end < 0.0 or (pressed and begin < 0.0)) and events < MOST_EVENTS
        span = left
        if turns:
            low, high, f_low, f_high = 0.0, left if begin > 0.0 else 0.0, begin, end
            for trial in range(MOST_TRIALS):
                if high - low <= TIME_TOLERANCE * max(high, quick):
                    break
                middle = low + (high - low) * f_low / (f_low - f_high)
                if trial % 3 == 2:  # what fades may be over in a tiny part of the step
                    middle = (
                        FIRST_TRIAL_RATIO * high
                        if low < FIRST_TRIAL_RATIO * FIRST_TRIAL_RATIO * high
                        else np.sqrt(low * high)
                    )
                if not low < middle < high:
                    middle = 0.5 * (low + high)
                f = _allowance(law, gap, place, rate, u, mine, pressed, middle)
                if f >= 0.0:
                    low, f_low = middle, f
                if f <= 0.0:
                    high, f_high = middle, f
            span = low if pressed else high
        if pressed:
            travel = rate * span
            impulse += relaxed * (u + 0.5 * travel) * span + viscosity * travel
            lost += viscosity * rate * travel
            for i in range(moduli.size):
                x, rise = span / times[i], moduli[i] * travel
                fading(x, phi)
                first, mixed, second = losses(x, phi)
                impulse += span * (mine[i] * phi[0] + rise * phi[1])
                lost += (mine[i] * (first * mine[i] + mixed * rise) + second * rise * rise) / moduli[i]
                mine[i] = mine[i] * np.exp(-x) + rise * phi[0]
            u += travel
        else:
            u = 0.0
            for k in range(rates.size):
                lost -= law[8][k] * mine[k] * mine[k] * np.expm1(-2.0 * rates[k] * span)
                mine[k] *= np.exp(-rates[k] * span)
                u += mine[k]
        if not turns:
            break
        left = max(left - span, 0.0)
        place += rate * span
        if pressed:
            rotated(law[5], law[6], u, mine, spare)
        else:
            u = place - gap
            rotated(law[5], law[7], 0.0, mine, spare)
        pressed = caught = not pressed
    return u, pressed, end if pressed else 0.0, impulse, lost
