"""One step of one contact of balls, as `Contacts` does it for many: the kernel that is exported to other programs."""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.springs.contact_kernels import move_balls, turn_balls
from winkler.numerics.types import Array
from winkler.problems.particles.ball_forces import (
    bound_of_twist,
    force_of_ball,
    radius_of_ball,
    tilting_of_ball,
    twisting_of_ball,
)

__all__ = ["BALL_NUMBERS", "step_ball"]

BALL_NUMBERS = 9
"""Of a step: normal force, shear force (2), torque, moment of rolling (2), radius, energy stored, heat so far."""


@compiled
def step_ball(
    law: Array, radius: Array, spacing: Array, single: Array, slope: Array, displaced: Array, twisted: Array,
    rolled: Array, past: Array, ends: Array, stiffness: Array, most: Array, lateral: Array, borne: Array, stored: Array,
    lost: Array, motion: Array, answer: Array,
) -> None:  # fmt: skip
    """Move one contact by one step.

    Parameters
    ----------
    law : ndarray, (6,)
        E*, G_t [Pa], R [m], mu [-], e [m], greatest depth [m].
    radius, spacing, single, slope : ndarray, (1,)
        As `move_balls` takes them.
    displaced : ndarray, (1, n, 2)
        Of the springs; with `twisted` (1, 2) and `rolled` (1, 2) what the contact remembers.
    past : ndarray, (2,)
        Depth before the step [m], heat so far [J].
    ends, stiffness, most, lateral, borne, stored, lost
        Work space, (1, 2), (1, 2), (1, 2), (1, 1, 2), (1, 1, 2), (1, 1), (1, 1).
    motion : ndarray, (6,)
        Depth at the end of the step; by which the bodies move (2), twist and roll (2) in it.
    answer : ndarray, (9,)
        Those of `BALL_NUMBERS`.
    """
    if motion[0] > law[5]:
        for k in range(answer.size):
            answer[k] = math.nan
        return
    ends[0, 0] = past[0]
    ends[0, 1] = motion[0]
    lateral[0, 0, 0] = motion[1]
    lateral[0, 0, 1] = motion[2]
    move_balls(displaced, radius, spacing, single, slope, ends, lateral, borne, stored, lost)
    heat = lost[0, 0]
    energy = stored[0, 0]
    answer[1] = borne[0, 0, 0]
    answer[2] = borne[0, 0, 1]
    for k in range(2):
        pressed = max(ends[0, k], 0.0)
        a = radius_of_ball(law[2], pressed)
        force = force_of_ball(law[0], law[2], pressed)
        stiffness[0, k] = twisting_of_ball(law[1], a)
        most[0, k] = bound_of_twist(law[3], force, a)
        answer[0] = force
        answer[6] = a
    lateral[0, 0, 0] = motion[3]
    lateral[0, 0, 1] = 0.0
    turn_balls(twisted, stiffness, most, lateral, borne, stored, lost)
    heat += lost[0, 0]
    energy += stored[0, 0]
    answer[3] = borne[0, 0, 0]
    for k in range(2):
        pressed = max(ends[0, k], 0.0)
        stiffness[0, k] = tilting_of_ball(law[0], radius_of_ball(law[2], pressed))
        most[0, k] = law[4] * force_of_ball(law[0], law[2], pressed)
    lateral[0, 0, 0] = motion[4]
    lateral[0, 0, 1] = motion[5]
    turn_balls(rolled, stiffness, most, lateral, borne, stored, lost)
    answer[4] = borne[0, 0, 0]
    answer[5] = borne[0, 0, 1]
    answer[7] = energy + stored[0, 0]
    past[0] = motion[0]
    past[1] += heat + lost[0, 0]
    answer[8] = past[1]
