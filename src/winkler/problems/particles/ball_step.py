"""One step of one contact of balls, as `Contacts` does it for many: the kernel that is exported to other programs."""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.springs.contact_kernels import move_row, turn_one
from winkler.numerics.types import Array
from winkler.problems.particles.ball_forces import (
    bound_of_twist,
    force_of_ball,
    radius_of_ball,
    tilting_of_ball,
    twisting_of_ball,
)
from winkler.problems.particles.table_step import all_finite

BALL_NUMBERS = 9
"""Of a step: normal force, shear force (2), torque, moment of rolling (2), radius, energy stored, heat so far."""


@compiled
def step_ball(
    law: Array, displaced: Array, twisted: Array, rolled: Array, past: Array, motion: Array, answer: Array
) -> None:
    """Move one contact by one step.

    Parameters
    ----------
    law : ndarray, (9,)
        E*, G_t [Pa], R [m], mu [-], e [m], greatest depth [m]; distance of the springs [m], tangential stiffness of one
        [N/m], and how far one that slips is displaced over its compression [-].
    displaced : ndarray, (n, 2)
        Of the springs; with `twisted` (1,) and `rolled` (2,) what the contact remembers.
    past : ndarray, (2,)
        Depth before the step [m], heat so far [J].
    motion : ndarray, (6,)
        Depth at the end of the step; by which the bodies move (2), twist and roll (2) in it.
    answer : ndarray, (9,)
        Those of `BALL_NUMBERS`.
    """
    if motion[0] > law[5] or not all_finite(motion):
        for k in range(answer.size):
            answer[k] = math.nan
        return
    radius = law[2]
    x, y, square, loss = move_row(displaced, radius, law[6], law[8], past[0], motion[0], motion[1], motion[2])
    pressed = max(motion[0], 0.0)
    a = radius_of_ball(radius, pressed)
    force = force_of_ball(law[0], radius, pressed)
    before = radius_of_ball(radius, max(past[0], 0.0))
    energy = 0.5 * law[7] * square
    heat = law[7] * loss
    answer[0] = force
    answer[1] = law[7] * x
    answer[2] = law[7] * y
    answer[3] = 0.0
    if twisted[0] != 0.0 or motion[3] != 0.0:
        stiffness = twisting_of_ball(law[1], a)
        x, _, stored, lost = turn_one(
            twisted[0],
            0.0,
            twisting_of_ball(law[1], before),
            stiffness,
            bound_of_twist(law[3], force, a),
            motion[3],
            0.0,
        )
        twisted[0] = x
        answer[3] = stiffness * x
        energy += stored
        heat += lost
    answer[4] = 0.0
    answer[5] = 0.0
    if rolled[0] != 0.0 or rolled[1] != 0.0 or motion[4] != 0.0 or motion[5] != 0.0:
        stiffness = tilting_of_ball(law[0], a)
        x, y, stored, lost = turn_one(
            rolled[0], rolled[1], tilting_of_ball(law[0], before), stiffness, law[4] * force, motion[4], motion[5]
        )
        rolled[0] = x
        rolled[1] = y
        answer[4] = stiffness * x
        answer[5] = stiffness * y
        energy += stored
        heat += lost
    answer[6] = a
    answer[7] = energy
    past[0] = motion[0]
    past[1] += heat
    answer[8] = past[1]
