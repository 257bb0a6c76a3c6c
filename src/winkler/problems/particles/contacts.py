r"""Many small contacts of balls at once, each with its history: what a discrete element code needs at every step.

The normal force is Hertz', :math:`F_N=\tfrac43E^*\sqrt R\,d^{3/2}`.  The shear force is that of a row of springs for
each contact, which stick and slip (`winkler.numerics.springs.contact_kernels`).  A twist about the normal is borne up
to
:math:`\tfrac{3\pi}{16}\mu F_Na` with the stiffness :math:`\tfrac{16}3G_ta^3`; rolling up to :math:`e F_N` with
:math:`\tfrac43E^*a^3`, that of a disc that is tilted.  Shear, twist and rolling do not affect each other.
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.number_checks import NON_NEGATIVE, POSITIVE, Numbers, Whole, checked
from winkler.checks.physical_size import refuse_size
from winkler.errors import InvalidInput, OutsideValidity
from winkler.media.halfspace import HalfSpace
from winkler.numerics.springs.contact_kernels import move_balls, turn_balls
from winkler.numerics.threads import run_in_threads
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.normal.validity import steepness_note
from winkler.problems.particles.trace import PLANE, SIMILAR, SPRINGS, UNCOUPLED, ContactTrace
from winkler.validity import Assumption, Note
from winkler.values import value, words

__all__ = ["Contacts"]


@value
class Contacts:
    """Contacts of balls and their state; every array leads with the axis of the contacts.

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
        e [m]: the moment of rolling friction over the normal force; zero without.
    reach : ndarray, (contacts,)
        Greatest depth [m] that the springs are made for.
    depth : ndarray, (contacts,)
        d [m] at present, not positive without contact.
    displaced : ndarray, (contacts, n, 2)
        Of the springs along the surface [m], from the axis to the edge.
    twisted : ndarray, (contacts,)
        Elastic part of the twist [rad].
    rolled : ndarray, (contacts, 2)
        Elastic part of the rolling [rad].
    dissipation : ndarray, (contacts,)
        Heat of each contact since the beginning [J].

    Raises
    ------
    InvalidInput
        If the shapes do not agree, or a number has the wrong sign.
    """

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

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "hertz_1882", "mindlin_deresiewicz_1953")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED

    def __post_init__(self) -> None:
        many = np.shape(self.depth)
        if len(many) != 1:
            raise InvalidInput(f"Contacts: depth has the shape {many}; give one number for each contact.")
        for word in (*PROPERTIES, "twisted", "dissipation"):
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
            How many springs each contact has over the greatest contact radius.

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
        """Return the contacts one step later; within it depth, motion, twist and roll change in proportion.

        Parameters
        ----------
        depth : ndarray, (contacts,)
            d [m] after the step.
        motion : ndarray, (contacts, 2), optional
            By which the bodies move against each other along the surface [m].
        twist : ndarray, (contacts,), optional
            By which they turn about the normal [rad].
        roll : ndarray, (contacts, 2), optional
            By which they roll over each other [rad].

        Raises
        ------
        InvalidInput, OutsideValidity
            As `along`.
        """
        after, _ = self.along(
            np.asarray(depth, dtype=float)[..., np.newaxis],
            motion=_between(motion, 2),
            twist=_between(twist, 1),
            roll=_between(roll, 2),
        )
        return after

    def along(
        self, depth: ArrayLike, *, motion: ArrayLike = 0.0, twist: ArrayLike = 0.0, roll: ArrayLike = 0.0
    ) -> tuple[Contacts, ContactTrace]:
        """Return the contacts after many steps, and the forces and losses of every step.

        Parameters
        ----------
        depth : ndarray, (contacts, steps)
            d [m] after every step.
        motion : ndarray, (contacts, steps, 2), optional
            By which the bodies move along the surface in each step [m].
        twist : ndarray, (contacts, steps), optional
            By which they turn about the normal [rad].
        roll : ndarray, (contacts, steps, 2), optional
            By which they roll over each other [rad].

        Returns
        -------
        after : Contacts
        trace : ContactTrace

        Raises
        ------
        InvalidInput
            If a shape does not agree, or a number is not finite, or beyond all physics.
        OutsideValidity
            If a contact is pressed deeper than its reach; the message names it.
        """
        many = self.depth.size
        steps = np.shape(depth)[-1] if np.ndim(depth) else 1
        d = _filled("depth", depth, (many, steps))
        move = _filled("motion", motion, (many, steps, 2))
        turns = np.zeros((many, steps, 2))
        turns[:, :, 0] = _filled("twist", twist, (many, steps))
        rolls = _filled("roll", roll, (many, steps, 2))
        deep = np.flatnonzero(np.any(d > self.reach[:, np.newaxis], axis=1))
        if deep.size:
            raise OutsideValidity(
                f"Contacts: contact {deep[0]} is pressed {np.max(d[deep[0]]):g} m deep, beyond the "
                f"{self.reach[deep[0]]:g} m its springs were made for; make the contacts with a greater reach."
            )
        depths = np.concatenate([self.depth[:, np.newaxis], d], axis=1)
        pressed = np.maximum(depths, 0.0)
        radius = np.sqrt(self.curvature_radius[:, np.newaxis] * pressed)
        normal = _hertz(self, pressed)
        u, twisted, rolled = np.array(self.displaced), np.zeros((many, 2)), np.array(self.rolled)
        twisted[:, 0] = self.twisted
        shear, torque, moment = np.zeros((3, many, steps, 2))
        stored, lost = np.zeros((2, 3, many, steps))
        spacing = np.sqrt(self.curvature_radius * self.reach) / u.shape[1]
        slope = self.coefficient * self.modulus / self.shear_modulus
        single = 2.0 * self.shear_modulus * spacing
        twisting = 16.0 / 3.0 * self.torsional_modulus[:, np.newaxis] * radius**3
        most_twist = 3.0 * np.pi / 16.0 * self.coefficient[:, np.newaxis] * normal * radius
        tilting = 4.0 / 3.0 * self.modulus[:, np.newaxis] * radius**3
        most_roll = self.rolling_arm[:, np.newaxis] * normal

        def work(part: slice) -> None:
            move_balls(
                u[part],
                self.curvature_radius[part],
                spacing[part],
                single[part],
                slope[part],
                depths[part],
                move[part],
                shear[part],
                stored[0, part],
                lost[0, part],
            )
            for row, (held, stiffness, most, turn, borne) in enumerate(
                ((twisted, twisting, most_twist, turns, torque), (rolled, tilting, most_roll, rolls, moment)), 1
            ):
                turn_balls(
                    held[part], stiffness[part], most[part], turn[part], borne[part], stored[row, part], lost[row, part]
                )

        run_in_threads(work, many)
        heat = self.dissipation[:, np.newaxis] + np.cumsum(lost.sum(axis=0), axis=1)
        trace = ContactTrace(d, normal[:, 1:], shear, torque[:, :, 0], moment, stored.sum(axis=0), heat)
        after = dataclasses.replace(
            self,
            depth=d[:, -1],
            displaced=u,
            twisted=twisted[:, 0],
            rolled=rolled,
            dissipation=heat[:, -1],
        )
        return after, trace

    @property
    def radius(self) -> Array:
        """a [m], ``(contacts,)``; zero without contact."""
        return np.asarray(np.sqrt(self.curvature_radius * np.maximum(self.depth, 0.0)))

    @property
    def force(self) -> Array:
        """F_N [N], ``(contacts,)``."""
        return _hertz(self, np.maximum(self.depth, 0.0)[:, np.newaxis])[:, 0]

    @property
    def shear_force(self) -> Array:
        """The force that holds the bodies up along the surface [N], ``(contacts, 2)``."""
        return np.asarray(self._single[:, np.newaxis] * self.displaced.sum(axis=1))

    @property
    def torque(self) -> Array:
        """M_z that holds up a twist [N m], ``(contacts,)``."""
        return np.asarray(16.0 / 3.0 * self.torsional_modulus * self.radius**3 * self.twisted)

    @property
    def rolling_moment(self) -> Array:
        """The moment that holds up rolling [N m], ``(contacts, 2)``."""
        return np.asarray((4.0 / 3.0 * self.modulus * self.radius**3)[:, np.newaxis] * self.rolled)

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
        spacing = np.sqrt(self.curvature_radius * self.reach) / self.displaced.shape[1]
        return np.asarray(2.0 * self.shear_modulus * spacing)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the forces can be trusted."""
        slope = float(np.max(self.radius / self.curvature_radius, initial=0.0))
        return (SIMILAR, steepness_note(slope), SPRINGS, PLANE, UNCOUPLED)


PROPERTIES = (
    "curvature_radius",
    "modulus",
    "shear_modulus",
    "torsional_modulus",
    "coefficient",
    "rolling_arm",
    "reach",
)


def _hertz(contacts: Contacts, pressed: Array) -> Array:
    stiffness = 4.0 / 3.0 * contacts.modulus * np.sqrt(contacts.curvature_radius)
    return np.asarray(stiffness[:, np.newaxis] * pressed**1.5)


def _between(broadcast: ArrayLike, axes: int) -> Array:
    """Return what is given for one step with an axis of steps after that of the contacts."""
    numbers = np.asarray(broadcast, dtype=float)
    return np.expand_dims(numbers, axis=1) if numbers.ndim == axes else numbers


def _filled(word: str, broadcast: ArrayLike, shape: tuple[int, ...]) -> Array:
    numbers = np.asarray(broadcast, dtype=float)
    if numbers.shape not in ((), shape):
        raise InvalidInput(f"Contacts: {word} has the shape {numbers.shape}; give {shape}, or one number for all.")
    if not np.all(np.isfinite(numbers)):
        raise InvalidInput(f"Contacts: {word} holds what is no finite number; give finite ones in SI units.")
    refuse_size(f"Contacts: {word}", numbers)
    return np.ascontiguousarray(np.broadcast_to(numbers, shape))
