r"""The march of an oblique impact on a coating: rings with the kernels of the layers, in small steps of time.

Depth and force of the normal motion are known beforehand, and its own mirror image.  Along the surface each step of
the length :math:`\tau` moves the touching points by :math:`\Delta U`, with the mean shear force F of the rings over it,

.. math:: \Delta U = \tfrac12\tau(w_0+w_1), \qquad w_1 = w_0-\kappa\tau F(\Delta U) ,

so that what the motion loses is what :math:`F\Delta U` stores and wears off, to rounding.  Errors fall with the square
of steps and rings.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.marching import StopCondition
from winkler.numerics.types import Array
from winkler.problems.impact.motion import ImpactProblem, integrate
from winkler.problems.ring_slip.ring_table import PressedStep, RingTable, SlidingRings, pressed_step, slide, stored
from winkler.values.errors import NotConverged

STEPS = 400
"""Steps while the bodies approach, at a mobility of 1/m; more in proportion to the frequency along the surface."""
MOST_STEPS = 20_000
TRIALS = 60
"""At most so many shifts are tried in a step."""
TRIAL_TOLERANCE = 1e-14
"""Part of the length of a step by which its shift may be missed."""


class RingMarch(NamedTuple):
    """An impact at the ends of its steps.

    Parameters
    ----------
    time, depth, velocity, shift, sliding, shear, stored, lost, stick : ndarray, (steps + 1,)
        t [s], d [m], v [m/s], U [m], w [m/s], F_x [N], energies [J], radius up to which no ring slides [m].
    side : ndarray, (steps,)
        To which side the outermost ring slides in each step.
    nested : bool
        Whether all that slid in any step was one outer ring.
    """

    time: Array
    depth: Array
    velocity: Array
    shift: Array
    sliding: Array
    shear: Array
    stored: Array
    lost: Array
    stick: Array
    side: Array
    nested: bool


def march_rings(motion: ImpactProblem, table: RingTable, moments: int = 2, refinement: int = 1) -> RingMarch:
    """Return the whole impact.

    Parameters
    ----------
    motion : ImpactProblem
        Its ratio is not read.
    table : RingTable
        Up to the contact at the greatest depth.
    moments : int, optional
        So many moments, evenly spaced, are to be among the ends of the steps, unless they are more than these.
    refinement : int, optional
        By how much steps are shorter.

    Raises
    ------
    NotConverged
        If the shift of a step is not found.
    """
    time, depth, velocity = _approach(motion, table, moments - 1, refinement)
    step = time[1]
    total = time.size
    shift, sliding, shear, kept, lost, stick = (np.zeros(total) for _ in range(6))
    side = np.zeros(total - 1, dtype=int)
    sliding[0], load, nested = motion.sliding, np.zeros(table.gaps.size), True
    stiffest = 0.5 * motion.mobility * step * step * table.modulus * float(np.sum(table.weights))
    for i in range(total - 1):
        pressed = pressed_step(table, float(depth[i]), float(depth[i + 1]))
        rings = _step(motion, table, load, pressed, (float(sliding[i]), step, stiffest))
        load = rings.load
        sliding[i + 1] = sliding[i] - motion.mobility * step * rings.force
        shift[i + 1] = shift[i] + 0.5 * step * (sliding[i] + sliding[i + 1])
        shear[i + 1], kept[i + 1] = float(np.sum(table.weights * load)), stored(table, load)
        lost[i + 1] = lost[i] + rings.loss
        inside = np.flatnonzero(pressed.part > 0.0)
        slides = np.flatnonzero(rings.side[inside])
        within = float(table.edges[int(np.count_nonzero(table.gaps < depth[i + 1]))])
        stick[i + 1] = min(float(table.edges[inside[slides[0]]]), within) if slides.size else within
        if slides.size:
            side[i] = int(rings.side[inside[-1]])
            nested = nested and bool(np.all(rings.side[inside[slides[0] :]] == side[i]) and side[i] != 0)
    return RingMarch(time, depth, velocity, shift, sliding, shear, kept, lost, stick, side, nested)


def _approach(motion: ImpactProblem, table: RingTable, parts: int, refinement: int) -> tuple[Array, Array, Array]:
    """Return times [s], depths [m] and velocities [m/s] of the normal motion, mirrored about the greatest depth."""

    def rates(time: float, state: Array) -> list[float]:
        return [state[1], -motion.curve.at(state[0])[1] / motion.mass]

    longest = 2.0 * motion.depth / motion.velocity
    stands = StopCondition(lambda time, state: state[1], -1)
    integrated = integrate(motion, rates, (0.0, longest), np.array([0.0, motion.velocity]), [stands])
    along = motion.mobility * table.modulus * float(np.sum(table.weights))
    across = motion.curve.at(motion.depth)[0] / motion.mass
    count = min(math.ceil(STEPS * refinement * math.sqrt(max(along / across, 1.0))), MOST_STEPS)
    if parts <= 2 * count:
        each = -(-2 * count // parts)
        count = parts * (each + each * parts % 2) // 2
    time = np.linspace(0.0, integrated.end, count + 1)
    depth, velocity = integrated.at(time)
    depth[0], velocity[-1] = 0.0, 0.0
    depth = np.minimum(np.maximum(depth, 0.0), motion.depth)
    whole = np.concatenate([time, 2.0 * integrated.end - time[-2::-1]])
    return whole, np.concatenate([depth, depth[-2::-1]]), np.concatenate([velocity, -velocity[-2::-1]])


def _step(
    motion: ImpactProblem, table: RingTable, load: Array, pressed: PressedStep, moving: tuple[float, float, float]
) -> SlidingRings:
    """Return the rings after a step; `moving` are w [m/s] before it, its length [s], and the steepest trial's slope.

    What a trial misses rises with the shift, by one at least and by one more than `stiffest` at most.
    """
    sliding, step, stiffest = moving
    free = step * sliding
    shift = free - 0.5 * motion.mobility * step * step * float(np.sum(table.weights * load * pressed.part))
    scale = max(abs(free), abs(shift), step * abs(motion.sliding) * 1e-3)
    low, high, slope = -math.inf, math.inf, 1.0 + 0.5 * stiffest
    last: tuple[float, float] | None = None
    for _ in range(TRIALS):
        rings = slide(table, load, pressed, shift)
        miss = shift - free + 0.5 * motion.mobility * step * step * rings.force
        if abs(miss) <= TRIAL_TOLERANCE * scale:
            return rings
        low, high = (shift, high) if miss < 0.0 else (low, shift)
        if last is not None and shift != last[0]:
            slope = min(max((miss - last[1]) / (shift - last[0]), 1.0), 1.0 + stiffest)
        last = shift, miss
        ahead = shift - miss / slope
        if not low < ahead < high:
            ahead = 0.5 * (low + high)
        if ahead == shift or math.nextafter(low, high) >= high:
            return rings
        shift = ahead
    raise NotConverged(
        "Impact: the displacement in a step of the annular elements was not found; give a smaller tangential mobility."
    )
