r"""Steps of many contacts of balls: shear, twist and rolling follow the bodies until friction is overcome.

The normal force is that of Hertz, :math:`F_N=\tfrac43E^*\sqrt R\,d^{3/2}`, with :math:`a=\sqrt{Rd}`.
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, TypeVar

import numpy as np

from winkler.numerics.springs.contact_kernels import move_balls, turn_balls
from winkler.numerics.threads import run_in_threads
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.particles.ball_forces import (
    ball_force,
    ball_radius,
    tilting_stiffness,
    twisting_bound,
    twisting_stiffness,
)
from winkler.problems.particles.trace import ContactTrace
from winkler.values.checks.number_checks import NON_NEGATIVE, POSITIVE, Numbers
from winkler.values.checks.physical_size import refuse_size
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

__all__ = ["BallContacts", "follow_contacts", "numbers_of_shape", "with_step_axis"]


@value
class BallContacts:
    """Contacts of two balls each, and what friction holds in them; as in `Contacts`."""

    __words__ = words(
        coefficient=(r"\mu", "", "friction coefficient"),
        reach=("d_{max}", "m", "greatest depth that the springs are made for"),
    )

    curvature_radius: Annotated[Array, Numbers(POSITIVE, fewest=0)]
    modulus: Annotated[Array, Numbers(POSITIVE, fewest=0)]
    shear_modulus: Annotated[Array, Numbers(POSITIVE, fewest=0)]
    torsional_modulus: Annotated[Array, Numbers(POSITIVE, fewest=0)]
    coefficient: Annotated[Array, Numbers(NON_NEGATIVE, fewest=0)]
    rolling_arm: Annotated[Array, Numbers(NON_NEGATIVE, fewest=0)]
    reach: Annotated[Array, Numbers(POSITIVE, fewest=0)]
    depth: Array
    displaced: Array
    twisted: Array
    rolled: Array
    dissipation: Array

    def radius_at(self, pressed: Array) -> Array:
        """Return a [m] at depths [m], ``(contacts, steps)``."""
        return np.asarray(ball_radius(self.curvature_radius[:, np.newaxis], pressed))

    def force_at(self, pressed: Array) -> Array:
        """Return F_N [N] at depths [m], ``(contacts, steps)``."""
        return np.asarray(ball_force(self.modulus[:, np.newaxis], self.curvature_radius[:, np.newaxis], pressed))

    def twisting(self, radius: Array) -> Array:
        """Return the stiffness against a twist [N m], ``(contacts, steps)``."""
        return np.asarray(twisting_stiffness(self.torsional_modulus[:, np.newaxis], radius))

    def tilting(self, radius: Array) -> Array:
        """Return the stiffness against rolling [N m], ``(contacts, steps)``."""
        return np.asarray(tilting_stiffness(self.modulus[:, np.newaxis], radius))

    def spacing(self, count: int) -> Array:
        """Return the distance of so many springs [m]."""
        return np.asarray(np.sqrt(self.curvature_radius * self.reach) / count)

    def single(self, count: int) -> Array:
        """Return the tangential stiffness of one of so many springs, on both sides of the axis [N/m]."""
        return np.asarray(2.0 * self.shear_modulus * self.spacing(count))


Balls = TypeVar("Balls", bound=BallContacts)


def follow_contacts(pairs: Balls, after: Array, motion: Array, twist: Array, roll: Array) -> tuple[Balls, ContactTrace]:
    """Return the contacts after many steps, and the forces and losses of every step.

    Parameters
    ----------
    pairs : BallContacts
        Before the first step.
    after : ndarray, (contacts, steps)
        d [m] after every step.
    motion : ndarray, (contacts, steps, 2)
        Along the surface in each step [m].
    twist : ndarray, (contacts, steps)
        [rad].
    roll : ndarray, (contacts, steps, 2)
        [rad].
    """
    many, steps = twist.shape
    depth = np.concatenate([pairs.depth[:, np.newaxis], after], axis=1)
    pressed = np.maximum(depth, 0.0)
    radius, normal = pairs.radius_at(pressed), pairs.force_at(pressed)
    turns = np.zeros((many, steps, 2))
    turns[:, :, 0] = twist
    u, twisted, rolled = np.array(pairs.displaced), np.zeros((many, 2)), np.array(pairs.rolled)
    twisted[:, 0] = pairs.twisted
    shear, torque, moment = np.zeros((3, many, steps, 2))
    stored, lost = np.zeros((2, 3, many, steps))
    spacing, single = pairs.spacing(u.shape[1]), pairs.single(u.shape[1])
    slope = pairs.coefficient * pairs.modulus / pairs.shear_modulus
    twisting, tilting = pairs.twisting(radius), pairs.tilting(radius)
    most_twist = twisting_bound(pairs.coefficient[:, np.newaxis], normal, radius)
    most_roll = pairs.rolling_arm[:, np.newaxis] * normal

    sheared = (u, pairs.curvature_radius, spacing, single, slope, depth, motion, shear, stored[0], lost[0])
    twist_rows = (twisted, twisting, most_twist, turns, torque, stored[1], lost[1])
    roll_rows = (rolled, tilting, most_roll, roll, moment, stored[2], lost[2])

    def work(part: slice) -> None:
        move_balls(*(row[part] for row in sheared))
        for rows in (twist_rows, roll_rows):
            turn_balls(*(row[part] for row in rows))

    run_in_threads(work, many)
    heat = pairs.dissipation[:, np.newaxis] + np.cumsum(lost.sum(axis=0), axis=1)
    trace = ContactTrace(after, normal[:, 1:], shear, torque[:, :, 0], moment, stored.sum(axis=0), heat)
    moved = dataclasses.replace(
        pairs, depth=after[:, -1], displaced=u, twisted=twisted[:, 0], rolled=rolled, dissipation=heat[:, -1]
    )
    return moved, trace


def with_step_axis(values: ArrayLike, axes: int) -> Array:
    """Return what is given for one step with an axis of steps after that of the contacts."""
    numbers = np.asarray(values, dtype=float)
    return np.expand_dims(numbers, axis=1) if numbers.ndim == axes else numbers


def numbers_of_shape(word: str, values: ArrayLike, shape: tuple[int, ...]) -> Array:
    """Return finite numbers of a shape, from these or from one for all; refuse what is neither."""
    numbers = np.asarray(values, dtype=float)
    if numbers.shape not in ((), shape):
        raise InvalidInput(f"Contacts: {word} has the shape {numbers.shape}; give {shape}, or one number for all.")
    if not np.all(np.isfinite(numbers)):
        raise InvalidInput(f"Contacts: {word} holds what is no finite number; give finite ones in SI units.")
    refuse_size(f"Contacts: {word}", numbers)
    return np.ascontiguousarray(np.broadcast_to(numbers, shape))
