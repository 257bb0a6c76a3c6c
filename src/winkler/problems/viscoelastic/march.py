"""A row of relaxing springs that is carried along: by steady motion, to a force, or by an impulse."""

from __future__ import annotations

import copy
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.foundation.springs import Springs
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.numerics.springs.relaxing_springs import (
    FORCED_NUMBERS,
    STEP_NUMBERS,
    advance_springs,
    advance_to_force,
    advance_under_forces,
)
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

NO_DEPTH = "the springs find no depth at which they carry its force; use more of them."
TOO_SHORT = "the depth under this force needs ever shorter steps; allow a greater tolerance."
RESTING_FORCE = 1e-11
"""A body under no force rests on the surface with this part of the greatest one."""


class SpringMemory(NamedTuple):
    """What steps did, (steps,): work and loss [J], and at their ends energy stored [J], radius [m], force [N], ring."""

    work: Array
    lost: Array
    stored: Array
    radius: Array
    force: Array
    ring: Array

    @classmethod
    def of(cls, row: SpringRow, rates: Array, numbers: Array) -> SpringMemory:
        """Read what a kernel has written.

        A dashpot loads a spring as soon as it is caught, so that the sum over the springs rises in steps; the part
        between the last one and the edge is added.
        """
        force, _, work, _, _, stored, radius, held, ring, lost = numbers.T
        climbing = (rates > 0.0) & (radius > 0.0)
        if row.series.viscosity > 0.0 and np.any(climbing):
            missing = row.bed.stiffness(radius[climbing]) - held[climbing]
            force = force.copy()
            force[climbing] += row.series.viscosity * rates[climbing] * missing
        return cls(work, lost, stored, radius, force, ring > 0.0)


def relaxation_of(owner: str, bed: Bed) -> RelaxationSeries:
    """Return by what the springs of a bed relax, E*(t) on half-spaces; refuse one that does not."""
    medium = bed.medium
    if offers(medium, RelaxingByWaves):
        raise InvalidInput(
            f"{owner}: {medium.reason} Wide and narrow contacts therefore relax differently. This problem needs "
            "one relaxation function for all springs. Use ViscoelasticIndentation, CreepTest, RelaxationTest, "
            f"HarmonicIndentation or ViscoelasticImpact, or give {medium.alike}."
        )
    if not offers(medium, RelaxingMedium) or not isinstance(bed, OnMedium):
        raise InvalidInput(
            f"{owner}: the bed stands on a {type(medium).__name__}; give Foundation(profile, "
            "ViscoelasticHalfSpace(solid)), RelaxingInProportion(medium, solid, shear) of a graded or layered medium, "
            "or ViscoelasticCoatedHalfSpace(layers, on) where layers relax each by a law of its own."
        )
    return medium.relaxation


def elastic_like(bed: Bed) -> Bed:
    """Return the bed as if it were elastic: on half-spaces with E* = 1 Pa, since g does not depend on the modulus."""
    assert isinstance(bed, OnMedium)
    assert offers(bed.medium, RelaxingMedium)
    return bed.with_medium(bed.medium.elastic)


class SpringRow:
    """Springs with their memories.

    Parameters
    ----------
    bed : Bed
        As if it were elastic.
    springs : Springs
        Its springs.
    series : RelaxationSeries
        By which their stiffness relaxes.
    """

    def __init__(self, bed: Bed, springs: Springs, series: RelaxationSeries) -> None:
        self.bed, self.springs, self.series = bed, springs, series
        recovery = Recovery.of(series)
        count = springs.gap.size
        self.law = recovery.law(series)
        self.row = np.array(springs.gap), np.array(springs.stiffness), np.array(springs.position)
        self.place, self.memory = np.zeros(count), np.zeros((recovery.rates.size, count))
        self.pressed, self.counts = np.zeros(count, dtype=bool), np.zeros(2, dtype=np.int64)
        # depth, whether it last rose, rate
        self.motion = np.array([min(0.0, float(springs.gap[0])), 1.0, 0.0])

    @property
    def _state(self) -> tuple[Array, Array, Array, Array]:
        """What the kernels change."""
        return self.place, self.memory, self.pressed, self.counts

    @property
    def depth(self) -> float:
        """Where the body is [m]."""
        return float(self.motion[0])

    def copy(self) -> SpringRow:
        """Return a row that may be carried on without this one."""
        twin = copy.copy(self)
        twin.place, twin.memory, twin.pressed = self.place.copy(), self.memory.copy(), self.pressed.copy()
        twin.counts, twin.motion = self.counts.copy(), self.motion.copy()
        return twin

    def march(self, changes: Array, spans: Array) -> SpringMemory:
        """Carry the row through changes of depth [m] at steady rates, or suddenly where a span [s] is zero."""
        numbers = np.empty((changes.size, STEP_NUMBERS))
        advance_springs(self.law, self.row, self._state, self.motion, changes, spans, numbers)
        return SpringMemory.of(self, np.divide(changes, spans, out=np.zeros(changes.size), where=spans > 0.0), numbers)

    def towards(self, force: float, dt: float, guess: float, scale: float) -> float:
        """Return the change of depth [m] after which the springs bear a force; the row stays where it is.

        With a dashpot alongside, whose forces jump with the rate and whenever a spring is caught, the mean force of the
        step is meant.  `scale` is a force that matters [N].
        """
        mean = self.series.viscosity > 0.0 and dt > 0.0
        wanted = np.array([force, 0.0, 1.0 / dt, 0.0] if mean else [force, 1.0, 0.0, 0.0])
        change, _ = advance_to_force(self.law, self.row, self._state, self.motion, wanted, dt, guess, scale)
        if math.isnan(change):
            raise NotConverged(f"The springs find no depth at which they carry {force:.6g} N; use more of them.")
        return float(change)

    def march_under(self, forces: Array, spans: Array, limits: Array, course: Array) -> tuple[Array, str]:
        """Carry the row through stretches in which a force changes steadily [N], or suddenly where a span [s] is zero.

        Parameters
        ----------
        forces : ndarray, (n + 1,)
            At the ends of the stretches.
        spans : ndarray, (n,)
        limits, course : ndarray, (2,) and (5,)
            As `advance_under_forces` takes them; `course` is carried on.

        Returns
        -------
        numbers : ndarray, (m, 6)
            Depth [m], radius [m], work [J], stored energy [J], loss [J] and whether the contact is a ring, after each
            stretch that was carried through.
        why : str
            What has kept the row from the next, if anything has.
        """
        numbers = np.empty((spans.size, FORCED_NUMBERS))
        least = np.maximum(forces, RESTING_FORCE * limits[1])
        reached, failure = advance_under_forces(
            self.law, self.row, self._state, self.motion, least, spans, limits, course, numbers
        )
        return numbers[:reached], ("", NO_DEPTH, TOO_SHORT)[failure]

    def struck(self, velocity: float, mass: float, dt: float) -> tuple[float, int]:
        """Return what becomes of a body that flies against the row for a time; the row stays where it is.

        Its mean velocity [m/s], which is its own less half of what the impulse takes, and how many springs are pressed
        after it.
        """
        momentum = 2.0 * mass * velocity
        wanted = np.array([momentum, 0.0, 1.0, 2.0 * mass / dt])
        change, held = advance_to_force(
            self.law, self.row, self._state, self.motion, wanted, dt, velocity * dt, abs(momentum)
        )
        if math.isnan(change):
            raise NotConverged("The springs find no impulse that stops the body; use more of them.")
        return float(change) / dt, int(held)

    def loads(self) -> Array:
        """Return the load of every spring over its weight, zero where it is free."""
        count = self.series.moduli.size
        rate = float(self.motion[2])
        loads = self.series.relaxed * self.place + self.series.viscosity * rate + self.memory[:count].sum(axis=0)
        return np.asarray(np.where(self.pressed, loads, 0.0))


def refuse_rings(owner: str, time: Array, ring: Array) -> None:
    """Refuse contacts of other springs than those about the axis."""
    if np.any(ring):
        raise OutsideValidity(
            f"{owner}: at {time[ring][0]:.6g} s the body touches around a dent that has not recovered, so the "
            "contact is not a disc, and the springs do not describe it; end the path before."
        )
