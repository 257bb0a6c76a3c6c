"""A row of relaxing springs that is carried along: by steady motion, to a force, or by an impulse."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.springs import Springs
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.relaxation import Recovery, advance, bearing
from winkler.numerics.spectra import RelaxationSeries
from winkler.numerics.types import Array

__all__ = ["Carried", "Row", "elastic_like", "relaxation_of"]

TRIALS = 200
MET = 1e-13
"""Part of the forces to which a prescribed one is met."""


class Carried(NamedTuple):
    """What one step did: force at its end [N], impulse [N s], work [J], and how both grow with the depth at its end."""

    force: float
    impulse: float
    work: float
    steepness: float
    swiftness: float


def relaxation_of(owner: str, bed: Bed) -> RelaxationSeries:
    """Return E*(t) of a bed; refuse one that does not relax."""
    medium = bed.medium
    if not isinstance(medium, ViscoelasticHalfSpace) or not isinstance(bed, Foundation | PlaneFoundation):
        raise InvalidInput(
            f"{owner}: the bed stands on a {type(medium).__name__}; give Foundation(profile, "
            "ViscoelasticHalfSpace(solid)); layers and gradings would need a g that does not change in time."
        )
    return medium.relaxation


def elastic_like(bed: Bed) -> Bed:
    """Return the bed on an elastic half-space with E* = 1 Pa: its shape is the same, g does not know the modulus."""
    assert isinstance(bed, Foundation | PlaneFoundation)
    return dataclasses.replace(bed, medium=HalfSpace(Elastic(1.0, 0.0)))


class Row:
    """Springs with their memories.

    Parameters
    ----------
    bed : Bed
        With E* = 1 Pa.
    springs : Springs
        Its springs.
    series : RelaxationSeries
        E*(t).
    """

    def __init__(self, bed: Bed, springs: Springs, series: RelaxationSeries) -> None:
        self.bed, self.springs, self.series = bed, springs, series
        self.recovery = Recovery.of(series)
        count, modes = springs.gap.size, self.recovery.rates.size
        self.gaps, self.weights = np.array(springs.gap), np.array(springs.stiffness)
        self.place, self.memory = np.zeros(count), np.zeros((count, modes))
        self.pressed = np.zeros(count, dtype=bool)
        self.depth, self.rising, self.rate = min(0.0, float(self.gaps[0])), True, 0.0

    def copy(self) -> Row:
        """Return a row that may be carried on without this one."""
        twin = object.__new__(Row)
        twin.__dict__.update(self.__dict__)
        twin.place, twin.memory, twin.pressed = self.place.copy(), self.memory.copy(), self.pressed.copy()
        return twin

    def move(self, change: float, dt: float) -> Carried:
        """Carry the row through a change of depth [m] at a steady rate, or suddenly if dt is zero."""
        series, recovery = self.series, self.recovery
        sums, spare = np.zeros(5), np.empty(self.memory.shape[1] + 1)
        advance(
            series.relaxed, series.viscosity, series.moduli, series.times,
            recovery.rates, recovery.from_displacement, recovery.from_memory, recovery.to_memory,
            self.gaps, self.weights, self.place, self.memory, self.pressed, self.depth, change, dt, sums, spare,
        )  # fmt: skip
        self.depth += change
        if change != 0.0:
            self.rising = change > 0.0
        self.rate = change / dt if dt > 0.0 else 0.0
        return Carried(*sums.tolist())

    def towards(self, force: float, dt: float, guess: float, scale: float) -> float:
        """Return the change of depth [m] after which the springs bear a force; the row stays where it is.

        With a dashpot alongside, whose forces jump with the rate and whenever a spring is caught, the mean force of the
        step is meant.  `scale` is a force that matters [N].
        """
        mean = self.series.viscosity > 0.0 and dt > 0.0
        low, high = -np.inf, np.inf
        stiff = self.series.relaxed + float(np.sum(self.series.moduli)) + (self.series.viscosity / dt if mean else 0.0)
        change, stride = guess, 0.5 * scale / (stiff * float(np.sum(self.weights)))
        for turn in range(TRIALS):
            trial = self.copy()
            done = trial.move(change, dt)
            excess = (done.impulse / dt if mean else done.force) - force
            steepness = done.swiftness / dt if mean else done.steepness
            if abs(excess) <= MET * scale:
                return change
            low, high = (low, min(high, change)) if excess > 0.0 else (max(low, change), high)
            newton = change - excess / steepness if steepness > 0.0 else np.inf
            bracketed = np.isfinite(low) and np.isfinite(high)
            if low < newton < high and not (bracketed and turn % 4 == 3):
                change = newton
            elif bracketed:
                middle = 0.5 * (low + high)
                if not low < middle < high:
                    return middle
                change = middle
            else:
                stride = max(2.0 * stride, 1e-6 * abs(change))
                change += stride if excess < 0.0 else -stride
        raise NotConverged(f"The springs find no depth at which they bear {force:.6g} N; take more of them.")

    def struck(self, momentum: float, mass: float, dt: float) -> float:
        """Return the mean velocity [m/s] of a body in one step: its momentum less half of the impulse it gets."""
        most = momentum / mass

        def excess(velocity: float) -> float:
            return 2.0 * (mass * velocity - momentum) + self.copy().move(velocity * dt, dt).impulse

        f_high = excess(most)
        if f_high <= 0.0:
            return most
        low, high = most - 0.5 * f_high / mass, most
        f_low = excess(low)
        for trial in range(TRIALS):
            middle = 0.5 * (low + high) if trial % 3 == 2 else low - f_low * (high - low) / (f_high - f_low)
            if not low < middle < high:
                break
            f = excess(middle)
            if f < 0.0:
                low, f_low = middle, f
            else:
                high, f_high = middle, f
            if abs(f) <= MET * abs(momentum) or f_high == f_low:
                return middle
        return 0.5 * (low + high)

    def loads(self) -> tuple[Array, float]:
        """Return the load of every spring per length [N/m], and the energy that all of them store [J]."""
        series = self.series
        loads, stored = np.empty(self.gaps.size), np.empty(self.gaps.size)
        bearing(
            series.relaxed, series.viscosity, series.moduli, self.recovery.to_memory,
            self.gaps, self.place, self.memory, self.pressed, self.rate, loads, stored,
        )  # fmt: skip
        return loads, float(self.weights @ stored)

    def force(self, loads: Array, radius: float) -> float:
        """Return the force [N] of loads [N/m] and a contact radius [m].

        A dashpot loads a spring as soon as it is caught, so that the sum over the springs climbs in stairs; the part
        between the last one and the edge is added.
        """
        force = float(self.weights @ loads)
        if self.rate > 0.0 and self.series.viscosity > 0.0 and radius > 0.0:
            whole = float(self.bed.stiffness(np.array([radius]))[0])
            force += self.series.viscosity * self.rate * (whole - float(np.sum(self.weights[self.pressed])))
        return force

    def radius(self, loads: Array) -> float:
        """Return the contact radius [m], between the last spring that is pressed and the first that is free.

        Where the contact widens, the gap under the free springs tells the edge; where it shrinks, the loads of the
        pressed ones.
        """
        gaps, x = self.gaps, self.springs.position
        inside = int(np.count_nonzero(self.pressed))
        if inside == 0:
            return 0.0
        if inside == gaps.size:
            return float(x[-1])
        low, high = float(gaps[inside - 1]), float(gaps[inside])
        if self.rising or inside < 2:
            free = gaps[inside:] + self.place[inside:] - self.depth
            slope = (free[1] - free[0]) / (gaps[inside + 1] - gaps[inside]) if free.size > 1 else 1.0
            edge = high - float(free[0] / slope) if slope > 0.0 else low
        else:
            fall = loads[inside - 2] - loads[inside - 1]
            edge = low + (float(loads[inside - 1] * (low - gaps[inside - 2]) / fall) if fall > 0.0 else high - low)
        part = min(max((edge - low) / (high - low), 0.0), 1.0)
        return float(np.sqrt(x[inside - 1] ** 2 + part * (x[inside] ** 2 - x[inside - 1] ** 2)))

    def refuse_rings(self, owner: str, time: float) -> None:
        """Refuse a contact of other springs than those about the axis."""
        if not self.pressed[: np.count_nonzero(self.pressed)].all():
            raise OutsideValidity(
                f"{owner}: at {time:.6g} s the body touches around a dent that has not recovered, so the contact is "
                "no disc, and the springs do not describe it; end the path before."
            )
