r"""Many small contacts of balls at once, each with its history: what a discrete element code needs at every step.

The normal force is Hertz', :math:`F_N=\tfrac43E^*\sqrt R\,d^{3/2}`.  The shear force is that of a row of springs for
each contact, which stick and slip (`winkler.numerics.springs.contact_kernels`).  A twist about the normal is borne up
to :math:`\tfrac{3\pi}{16}\mu F_Na` with the stiffness :math:`\tfrac{16}3G_ta^3`; rolling up to :math:`e F_N` with
:math:`\tfrac43E^*a^3`, that of a disc that is tilted.  Shear, twist and rolling do not affect each other.

Steps of many contacts of balls: shear, twist and rolling follow the bodies until friction is overcome.

The normal force is that of Hertz, :math:`F_N=\tfrac43E^*\sqrt R\,d^{3/2}`, with :math:`a=\sqrt{Rd}`.
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, ClassVar, TypeVar

import numpy as np

from winkler.media.halfspace import HalfSpace
from winkler.numerics.springs.contact_kernels import move_balls, turn_balls
from winkler.numerics.threads import run_in_threads
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.normal.validity import steepness_note
from winkler.problems.particles.ball_forces import (
    ball_force,
    ball_radius,
    tilting_stiffness,
    twisting_bound,
    twisting_stiffness,
)
from winkler.problems.particles.trace import PLANE, SIMILAR, SPRINGS, UNCOUPLED, ContactTrace
from winkler.values.checks.number_checks import NON_NEGATIVE, POSITIVE, Numbers, Whole, checked
from winkler.values.checks.physical_size import refuse_size
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


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
    """Return the contacts after many steps, and forces and dissipated energies of every step.

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


@value
class Contacts(BallContacts):
    """Contacts of balls with their state; the first axis of every array is that of the contacts.

    Make new ones with `Contacts.apart`.  They do not attract each other; for that see `AdhesiveImpact` and
    `ElasticPlasticParticle`.

    Parameters
    ----------
    curvature_radius : ndarray, (contacts,)
        R [m] of each pair, 1/R = 1/R1 + 1/R2.
    modulus, shear_modulus, torsional_modulus : ndarray, (contacts,)
        E*, G* and G_t [Pa] of each pair.
    coefficient : ndarray, (contacts,)
        Friction coefficient mu [-].
    rolling_arm : ndarray, (contacts,)
        e [m]: the moment of rolling friction over the normal force; zero without rolling friction.
    reach : ndarray, (contacts,)
        Maximum depth [m] for which the springs are defined.
    depth : ndarray, (contacts,)
        d [m] at present, not positive without contact.
    displaced : ndarray, (contacts, n, 2)
        Tangential deflections of the springs [m], from the axis to the edge.
    twisted : ndarray, (contacts,)
        Elastic part of the twist [rad].
    rolled : ndarray, (contacts, 2)
        Elastic part of the rolling [rad].
    dissipation : ndarray, (contacts,)
        Dissipated energy of each contact since the beginning [J].

    Raises
    ------
    InvalidInput
        If the shapes do not agree, or a number has the wrong sign.
    """

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "hertz_1882", "mindlin_deresiewicz_1953")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED

    def __post_init__(self) -> None:
        many = np.shape(self.depth)
        if len(many) != 1:
            raise InvalidInput(f"Contacts: depth has the shape {many}; give one number for each contact.")
        for word in [field.name for field in dataclasses.fields(self) if field.name not in ("displaced", "rolled")]:
            if np.shape(getattr(self, word)) != many:
                raise InvalidInput(
                    f"Contacts: {word} has the shape {np.shape(getattr(self, word))} for {many[0]} contacts; give one "
                    "number for each."
                )
        shape = np.shape(self.displaced)
        if (
            len(shape) != 3
            or shape[0] != many[0]
            or shape[1] < 1
            or shape[2] != 2
            or np.shape(self.rolled) != (*many, 2)
        ):
            raise InvalidInput(
                f"Contacts: displaced has the shape {shape} and rolled {np.shape(self.rolled)} for {many[0]} contacts; "
                "give (contacts, springs, 2) and (contacts, 2)."
            )

    @classmethod
    def apart(
        cls,
        medium: HalfSpace,
        *,
        curvature_radius: ArrayLike,
        coefficient: ArrayLike,
        reach: ArrayLike,
        rolling_arm: ArrayLike = 0.0,
        count: int = 32,
    ) -> Contacts:
        """Return contacts that do not touch yet.

        Parameters
        ----------
        medium : HalfSpace
            The pair of solids.
        curvature_radius, coefficient, reach, rolling_arm : float or ndarray, (contacts,)
            One number for all, or one for each.
        count : int, optional
            Number of springs of each contact over the maximum contact radius.

        Raises
        ------
        InvalidInput
            If the shapes do not agree, or a number has the wrong sign.

        Examples
        --------
        >>> from winkler.materials.elastic import Elastic
        >>> glass = HalfSpace.between(Elastic(70e9, 0.22), Elastic(70e9, 0.22))
        >>> beads = Contacts.apart(glass, curvature_radius=[1e-3, 2e-3], coefficient=0.3, reach=2e-6)
        >>> beads = beads.moved([1e-6, 1e-6], motion=[[0.5e-6, 0.0], [0.1e-6, 0.1e-6]])
        >>> (np.hypot(*beads.shear_force.T) / beads.force).round(3)
        array([0.3  , 0.124])
        """
        checked(Whole(1, what="springs"), "Contacts", "count", count)
        moduli = (medium.modulus, medium.shear_modulus, medium.torsional_modulus)
        try:
            broadcast = np.broadcast_arrays(*np.atleast_1d(curvature_radius, *moduli, coefficient, rolling_arm, reach))
        except ValueError as error:
            raise InvalidInput(f"Contacts: one number for all, or one for each contact; {error}") from None
        radii, normal, shear, torsional, friction, arm, deepest = (np.array(x, dtype=float) for x in broadcast)
        many = broadcast[0].shape
        return cls(
            curvature_radius=radii,
            modulus=normal,
            shear_modulus=shear,
            torsional_modulus=torsional,
            coefficient=friction,
            rolling_arm=arm,
            reach=deepest,
            depth=np.zeros(many),
            displaced=np.zeros((*many, count, 2)),
            twisted=np.zeros(many),
            rolled=np.zeros((*many, 2)),
            dissipation=np.zeros(many),
        )

    def moved(
        self, depth: ArrayLike, *, motion: ArrayLike = 0.0, twist: ArrayLike = 0.0, roll: ArrayLike = 0.0
    ) -> Contacts:
        """Return the contacts after one step, in which depth, motion, twist and roll change linearly in time.

        Parameters
        ----------
        depth : ndarray, (contacts,)
            d [m] after the step.
        motion : ndarray, (contacts, 2), optional
            Relative tangential displacement of the bodies in this step [m].
        twist : ndarray, (contacts,), optional
            Relative rotation about the normal [rad].
        roll : ndarray, (contacts, 2), optional
            Relative rolling rotation [rad].

        Raises
        ------
        InvalidInput, OutsideValidity
            As `along`.
        """
        after, _ = self.along(
            np.asarray(depth, dtype=float)[..., np.newaxis],
            motion=with_step_axis(motion, 2),
            twist=with_step_axis(twist, 1),
            roll=with_step_axis(roll, 2),
        )
        return after

    def along(
        self, depth: ArrayLike, *, motion: ArrayLike = 0.0, twist: ArrayLike = 0.0, roll: ArrayLike = 0.0
    ) -> tuple[Contacts, ContactTrace]:
        """Return the contacts after many steps, and forces and dissipated energies of every step.

        Parameters
        ----------
        depth : ndarray, (contacts, steps)
            d [m] after every step.
        motion : ndarray, (contacts, steps, 2), optional
            Relative tangential displacement of the bodies in each step [m].
        twist : ndarray, (contacts, steps), optional
            Relative rotation about the normal [rad].
        roll : ndarray, (contacts, steps, 2), optional
            Relative rolling rotation [rad].

        Returns
        -------
        after : Contacts
        trace : ContactTrace

        Raises
        ------
        InvalidInput
            If a shape does not agree, or a number is not finite, or far outside any physical range.
        OutsideValidity
            If a contact is pressed deeper than its reach; the message names it.
        """
        many = self.depth.size
        steps = np.shape(depth)[-1] if np.ndim(depth) else 1
        d = numbers_of_shape("depth", depth, (many, steps))
        move = numbers_of_shape("motion", motion, (many, steps, 2))
        turns = numbers_of_shape("twist", twist, (many, steps))
        rolls = numbers_of_shape("roll", roll, (many, steps, 2))
        deep = np.flatnonzero(np.any(d > self.reach[:, np.newaxis], axis=1))
        if deep.size:
            raise OutsideValidity(
                f"Contacts: contact {deep[0]} is pressed {np.max(d[deep[0]]):g} m deep, beyond the "
                f"{self.reach[deep[0]]:g} m its springs were made for; make the contacts with a greater reach."
            )
        return follow_contacts(self, d, move, turns, rolls)

    @property
    def radius(self) -> Array:
        """a [m], ``(contacts,)``; zero without contact."""
        return self.radius_at(np.maximum(self.depth, 0.0)[:, np.newaxis])[:, 0]

    @property
    def force(self) -> Array:
        """F_N [N], ``(contacts,)``."""
        return self.force_at(np.maximum(self.depth, 0.0)[:, np.newaxis])[:, 0]

    @property
    def shear_force(self) -> Array:
        """The tangential force that resists the motion [N], ``(contacts, 2)``."""
        return np.asarray(self._single[:, np.newaxis] * self.displaced.sum(axis=1))

    @property
    def torque(self) -> Array:
        """The torque M_z that resists a twist [N m], ``(contacts,)``."""
        return np.asarray(self.twisting(self.radius[:, np.newaxis])[:, 0] * self.twisted)

    @property
    def rolling_moment(self) -> Array:
        """The moment that resists rolling [N m], ``(contacts, 2)``."""
        return np.asarray(self.tilting(self.radius[:, np.newaxis]) * self.rolled)

    @property
    def energy(self) -> Array:
        """Elastic energy of pressing, 2 F_N d / 5 [J], ``(contacts,)``."""
        return np.asarray(0.4 * self.force * np.maximum(self.depth, 0.0))

    @property
    def stored_energy(self) -> Array:
        """Elastic energy of shear, twist and rolling [J], ``(contacts,)``."""
        shear = 0.5 * self._single * np.sum(self.displaced**2, axis=(1, 2))
        return np.asarray(
            shear + 0.5 * self.torque * self.twisted + 0.5 * np.sum(self.rolling_moment * self.rolled, axis=1)
        )

    @property
    def _single(self) -> Array:
        """Tangential stiffness of one spring, on both sides of the axis [N/m]."""
        return self.single(self.displaced.shape[1])

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the forces can be trusted."""
        slope = float(np.max(self.radius / self.curvature_radius, initial=0.0))
        return (SIMILAR, steepness_note(slope), SPRINGS, PLANE, UNCOUPLED)
