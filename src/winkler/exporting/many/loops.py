"""Loops over many contacts: each takes the step of a law, the same that is exported, from contact to contact.

All take the first contact and the one after the last, the kind of every contact, the tables of every kind, the state of
every contact, work space of one step, what goes in, and what comes out: `motion` and `answer` of one step, which of the
answers are `kept`, and `out` (contacts, kept).  What goes in has a row for each contact, or one row for all.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array
from winkler.problems.particles.ball_step import step_ball
from winkler.problems.particles.damped_step import step_damped
from winkler.problems.particles.particle_step import step_particle
from winkler.problems.particles.sheared_step import step_sheared
from winkler.problems.particles.table_step import step_attracted, step_table
from winkler.problems.plastic.yielding_step import step_yielding
from winkler.problems.viscoelastic.relaxing_step import step_relaxing

Whole = np.ndarray[tuple[int, ...], np.dtype[np.int64]]


@compiled
def first_beyond(numbers: Array, least: float, most: float) -> int:
    """Return the first place where a number is not between the bounds, not-a-number included; -1 if there is none."""
    for i in range(numbers.size):
        if not least <= numbers[i] <= most:
            return i
    return -1


@compiled
def loop_table(
    first: int, last: int, kind: Whole, depth: Array, force: Array, stiffness: Array, energy: Array, shear: Array,
    pressed: Array, motion: Array, answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let contacts without friction do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        step_table(depth[k], force[k], stiffness[k], energy[k], shear[k], motion, answer)
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_attracted(
    first: int, last: int, kind: Whole, depth: Array, force: Array, stiffness: Array, energy: Array, pull: Array,
    pressed: Array, motion: Array, answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let contacts with attraction of long range do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        step_attracted(depth[k], force[k], stiffness[k], energy[k], pull[k], motion, answer)
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_sheared(
    first: int, last: int, kind: Whole, depth: Array, force: Array, stiffness: Array, energy: Array, gap: Array,
    shear: Array, slope: Array, hold: Array, corners: Array, slopes: Array, displaced: Array, slips: Array, past: Array,
    bound: Array, ends: Array, shift: Array, borne: Array, stored: Array, lost: Array, pressed: Array, moved: Array,
    motion: Array, answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let contacts of any body of revolution with friction do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        j = i if moved.shape[0] > 1 else 0
        motion[1] = moved[j, 0]
        motion[2] = moved[j, 1]
        step_sheared(
            depth[k], force[k], stiffness[k], energy[k], gap[k], shear[k], slope[k], hold[k], corners[k], slopes[k],
            displaced[i], slips[i], past[i], bound, ends, shift, borne, stored, lost, motion, answer,
        )  # fmt: skip
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_balls(
    first: int, last: int, kind: Whole, law: Array, displaced: Array, twisted: Array, rolled: Array, past: Array,
    pressed: Array, moved: Array, twist: Array, roll: Array, motion: Array, answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let contacts of balls with friction, twist and rolling do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        j = i if moved.shape[0] > 1 else 0
        motion[1] = moved[j, 0]
        motion[2] = moved[j, 1]
        motion[3] = twist[i] if twist.size > 1 else twist[0]
        j = i if roll.shape[0] > 1 else 0
        motion[4] = roll[j, 0]
        motion[5] = roll[j, 1]
        step_ball(law[k], displaced[i], twisted[i], rolled[i], past[i], motion, answer)
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_particles(
    first: int, last: int, kind: Whole, law: Array, memory: Array, pressed: Array, motion: Array, answer: Array,
    kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let particles that yield, or balls that attract, do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        step_particle(law[k], memory[i], motion, answer)
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_yielding(
    first: int, last: int, kind: Whole, depth: Array, force: Array, stiffness: Array, energy: Array, square: Array,
    square_slope: Array, share: Array, share_slope: Array, place: Array, gap: Array, gap_slope: Array, gap_sum: Array,
    bends: Array, nodes: Array, weights: Array, law: Array, memory: Array, pressed: Array, motion: Array,
    answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let round bodies on metals that yield do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        step_yielding(
            depth[k], force[k], stiffness[k], energy[k], square[k], square_slope[k], share[k], share_slope[k], place[k],
            gap[k], gap_slope[k], gap_sum[k], bends[k], nodes[k], weights[k], law[k], memory[i], motion, answer,
        )  # fmt: skip
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_damped(
    first: int, last: int, kind: Whole, depth: Array, force: Array, stiffness: Array, energy: Array, delay: Array,
    past: Array, pressed: Array, duration: Array, motion: Array, answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let contacts with solids of springs and dashpots side by side do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        motion[1] = duration[i] if duration.size > 1 else duration[0]
        step_damped(depth[k], force[k], stiffness[k], energy[k], delay[k], past[i], motion, answer)
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]


@compiled
def loop_relaxing(
    first: int, last: int, kind: Whole, solid: Array, moduli: Array, times: Array, rates: Array, displaced: Array,
    back: Array, forth: Array, modes: Array, gap: Array, weight: Array, position: Array, place: Array, memory: Array,
    touching: Array, counts: Array, course: Array, past: Array, change: Array, span: Array, numbers: Array,
    pressed: Array, duration: Array, motion: Array, answer: Array, kept: Whole, out: Array,
) -> None:  # fmt: skip
    """Let contacts with bodies that relax do a step."""
    for i in range(first, last):
        k = kind[i] if kind.size > 1 else kind[0]
        motion[0] = pressed[i] if pressed.size > 1 else pressed[0]
        motion[1] = duration[i] if duration.size > 1 else duration[0]
        step_relaxing(
            solid[k], moduli[k], times[k], rates[k], displaced[k], back[k], forth[k], modes[k], gap[k], weight[k],
            position[k], place[i], memory[i], touching[i], counts[i], course[i], past[i], change, span, numbers, motion,
            answer,
        )  # fmt: skip
        for j in range(kept.size):
            out[i, j] = answer[kept[j]]
