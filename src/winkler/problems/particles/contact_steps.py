r"""Steps of many contacts of balls: shear, twist and rolling follow the bodies until friction is overcome.

The normal force is that of Hertz, :math:`F_N=\tfrac43E^*\sqrt R\,d^{3/2}`, with :math:`a=\sqrt{Rd}`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.checks.physical_size import refuse_size
from winkler.errors import InvalidInput
from winkler.numerics.springs.contact_kernels import move_balls, turn_balls
from winkler.numerics.threads import run_in_threads
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.particles.trace import ContactTrace

__all__ = ["BallPairs", "FrictionState", "follow_contacts", "numbers_of_shape", "with_step_axis"]


class BallPairs(NamedTuple):
    """What does not change in contacts of two balls, ``(contacts,)`` each; as in `Contacts`."""

    curvature_radius: Array
    modulus: Array
    shear_modulus: Array
    torsional_modulus: Array
    coefficient: Array
    rolling_arm: Array
    reach: Array

    def radius(self, pressed: Array) -> Array:
        """Return a [m] at depths [m], ``(contacts, steps)``."""
        return np.asarray(np.sqrt(self.curvature_radius[:, np.newaxis] * pressed))

    def force(self, pressed: Array) -> Array:
        """Return F_N [N] at depths [m], ``(contacts, steps)``."""
        stiffness = 4.0 / 3.0 * self.modulus * np.sqrt(self.curvature_radius)
        return np.asarray(stiffness[:, np.newaxis] * pressed**1.5)

    def twisting(self, radius: Array) -> Array:
        """Return the stiffness against a twist [N m], ``(contacts, steps)``."""
        return np.asarray(16.0 / 3.0 * self.torsional_modulus[:, np.newaxis] * radius**3)

    def tilting(self, radius: Array) -> Array:
        """Return the stiffness against rolling [N m], ``(contacts, steps)``."""
        return np.asarray(4.0 / 3.0 * self.modulus[:, np.newaxis] * radius**3)

    def spacing(self, count: int) -> Array:
        """Return the distance of so many springs [m]."""
        return np.asarray(np.sqrt(self.curvature_radius * self.reach) / count)

    def single(self, count: int) -> Array:
        """Return the tangential stiffness of one of so many springs, on both sides of the axis [N/m]."""
        return np.asarray(2.0 * self.shear_modulus * self.spacing(count))


class FrictionState(NamedTuple):
    """What friction holds in every contact, and the heat it has caused; as in `Contacts`."""

    displaced: Array
    twisted: Array
    rolled: Array
    dissipation: Array


def follow_contacts(
    pairs: BallPairs, before: FrictionState, depth: Array, motion: Array, twist: Array, roll: Array
) -> tuple[FrictionState, ContactTrace]:
    """Return what friction holds after many steps, and the forces and losses of every step.

    Parameters
    ----------
    pairs : BallPairs
    before : FrictionState
        Before the first step.
    depth : ndarray, (contacts, steps + 1)
        d [m] before the first step and after every one.
    motion : ndarray, (contacts, steps, 2)
        Along the surface in each step [m].
    twist : ndarray, (contacts, steps)
        [rad].
    roll : ndarray, (contacts, steps, 2)
        [rad].
    """
    many, steps = twist.shape
    pressed = np.maximum(depth, 0.0)
    radius, normal = pairs.radius(pressed), pairs.force(pressed)
    turns = np.zeros((many, steps, 2))
    turns[:, :, 0] = twist
    u, twisted, rolled = np.array(before.displaced), np.zeros((many, 2)), np.array(before.rolled)
    twisted[:, 0] = before.twisted
    shear, torque, moment = np.zeros((3, many, steps, 2))
    stored, lost = np.zeros((2, 3, many, steps))
    spacing, single = pairs.spacing(u.shape[1]), pairs.single(u.shape[1])
    slope = pairs.coefficient * pairs.modulus / pairs.shear_modulus
    twisting, tilting = pairs.twisting(radius), pairs.tilting(radius)
    most_twist = 3.0 * np.pi / 16.0 * pairs.coefficient[:, np.newaxis] * normal * radius
    most_roll = pairs.rolling_arm[:, np.newaxis] * normal

    def work(part: slice) -> None:
        move_balls(
            u[part],
            pairs.curvature_radius[part],
            spacing[part],
            single[part],
            slope[part],
            depth[part],
            motion[part],
            shear[part],
            stored[0, part],
            lost[0, part],
        )
        for row, (held, stiffness, most, turn, borne) in enumerate(
            ((twisted, twisting, most_twist, turns, torque), (rolled, tilting, most_roll, roll, moment)), 1
        ):
            turn_balls(
                held[part], stiffness[part], most[part], turn[part], borne[part], stored[row, part], lost[row, part]
            )

    run_in_threads(work, many)
    heat = before.dissipation[:, np.newaxis] + np.cumsum(lost.sum(axis=0), axis=1)
    trace = ContactTrace(depth[:, 1:], normal[:, 1:], shear, torque[:, :, 0], moment, stored.sum(axis=0), heat)
    return FrictionState(u, twisted[:, 0], rolled, heat[:, -1]), trace


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
