r"""A rigid body strikes a viscoelastic one, and rebounds slower.

.. math:: m\,\ddot d = -F(t)

with the springs of `winkler.problems.viscoelastic.indentation`, which let go before they would pull.  In every step
the body moves steadily, with the mean of its velocities before and after, and is slowed by the exact impulse of the
springs; so what it loses in kinetic energy is exactly the work done on them.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import BALANCED, RELAXING
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.inertia import wave_loss, wave_note
from winkler.problems.assumptions.times import times_notes
from winkler.problems.normal.length_scale import shape_length
from winkler.problems.normal.solve_contact import at_depth, at_end
from winkler.problems.viscoelastic.layered_march import LayeredMarch, TooNarrow, cells_of
from winkler.problems.viscoelastic.layered_notes import layered_notes, resolution_note
from winkler.problems.viscoelastic.layered_path import WIDENED, contact_reach, is_layered, uppermost
from winkler.problems.viscoelastic.march import SpringMemory, SpringRow, elastic_like, refuse_rings, relaxation_of
from winkler.problems.viscoelastic.validity import relaxing_notes
from winkler.values.checks.number_checks import Positive, PositiveNotTiny, Whole, between
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

FIRST_STEPS = 125
"""Steps in the time that the body would take, unslowed, to its greatest depth, of the first of ever finer marches."""
MOST_STEPS = 16_000
LONGEST_CONTACT = 400
"""Longest contact, in these times."""
DEEPEST = 0.05
"""Part of the depth at which a profile ends with which trials on layers begin at the most."""
SHALLOW = 0.25
"""A trial on layers that reaches less than this part of the depth that was expected is made again, with that depth."""
REST_ENERGY = 1e-14
"""Part of the kinetic energy with which a body no longer moves."""
DEPTH_TOLERANCE = 1e-2
"""Relative error of that depth."""
SAMPLES = 257
TRIAL_CELLS = 60
"""Springs or cells of the march that determines how deep the body gets."""


@value
class ViscoelasticImpact:
    """Normal impact of a rigid body on a viscoelastic one.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium) with a ViscoelasticHalfSpace, a ViscoelasticCoatedHalfSpace or a PoroelasticFilm.
    mass : float
        m [kg].
    velocity : float
        v [m/s] of approach at first touch, positive.
    count : int, optional
        Number of springs, or cells on layers with separate relaxation functions.
    tolerance : float, optional
        Tolerance of the restitution, reached by halving the steps.

    Raises
    ------
    InvalidInput
        If the medium is not viscoelastic, or a number is out of range.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6

    Examples
    --------
    A ball on a Maxwell solid whose relaxation time is that of the impact, (m^2 / (E*^2 R v))^(1/5).

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(Maxwell(shear=0.25, relaxation_time=1.0)))
    >>> round(ViscoelasticImpact(bed, mass=1.0, velocity=1.0).solve().restitution, 4)
    0.2801
    """

    __words__ = words(count=("n", "", "how many springs"))

    bed: Bed
    mass: PositiveNotTiny
    velocity: Positive
    count: Annotated[int, Whole(2, RELAXING_SPRINGS)] = 500
    tolerance: Annotated[float, between(1e-9, 0.1)] = 1e-5

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "popov_willert_hess_2018",
        "lee_radok_1960",
        "ting_1966",
    )
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | BALANCED | {Assumption.INERTIA}
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not is_layered("ViscoelasticImpact", self.bed, self.count):
            relaxation_of("ViscoelasticImpact", self.bed)

    def solve(self) -> ViscoelasticImpactSolution:
        """Return the whole impact.

        Returns
        -------
        ViscoelasticImpactSolution

        Raises
        ------
        OutsideValidity
            If the body is pressed beyond the known range of its profile, or its contact is not a disc.
        NotConverged
            If the restitution does not converge, or the body neither comes to rest nor leaves.
        """
        scale, layered = self._scale(), is_layered("", self.bed)
        # the first march only determines how wide the contact gets
        reach = 1.5 * scale
        while True:
            trial = self._march(reach, scale / self.velocity / FIRST_STEPS, TRIAL_CELLS).greatest_depth()
            if trial > reach:
                scale, reach = scale * (2.0 if layered else 1.0), 2.0 * reach
            elif trial < SHALLOW * scale and layered:
                scale, reach = 2.0 * trial, 3.0 * trial
            else:
                break
        reach = 1.02 * trial
        finer, last = FIRST_STEPS, math.nan
        while finer <= MOST_STEPS:
            march = self._march(reach, scale / self.velocity / finer, self.count)
            restitution = -march.velocity / self.velocity
            if abs(restitution - last) <= 3.0 * self.tolerance:
                return ViscoelasticImpactSolution(self, *np.array(march.lines).T)
            finer, last = 2 * finer, restitution
        raise NotConverged(
            f"ViscoelasticImpact: the restitution does not converge within {self.tolerance:g}; allow more, or "
            "give more springs."
        )

    def _scale(self) -> float:
        """Return the depth [m] at which the stiffness at the rate of the impact has taken the kinetic energy."""
        energy = 0.5 * self.mass * self.velocity**2
        if energy == 0.0:
            raise OutsideValidity(
                f"ViscoelasticImpact: the kinetic energy of {self.mass:g} kg at {self.velocity:g} m/s is below the "
                "smallest floating-point number; check the units."
            )
        if is_layered("", self.bed):  # the uppermost layer alone, of which trials make what the layers are
            elastic = uppermost(self.bed)
            last = DEEPEST * at_end(elastic)[0] if elastic.reach < elastic.rim else math.inf
            if math.isfinite(last) and _stored(elastic, last) <= energy:
                return last
            return _depth_of(elastic, energy, 1e-3 * shape_length(elastic))
        elastic, series = elastic_like(self.bed), relaxation_of("", self.bed)
        # any number to begin with
        modulus = series.glassy if math.isfinite(series.glassy) else max(series.relaxed, series.viscosity)
        depth, last = _depth_of(elastic, energy / modulus, 1e-3 * shape_length(elastic)), 0.0
        for _ in range(60):
            if abs(depth - last) <= DEPTH_TOLERANCE * depth:
                break
            modulus = abs(complex(series.dynamic(np.array(self.velocity / depth))))
            depth, last = _depth_of(elastic, energy / modulus, depth), depth
        return depth

    def _march(self, deepest: float, dt: float, count: int) -> Flight:
        if is_layered("", self.bed):
            reach = contact_reach("ViscoelasticImpact", self.bed, Depth(deepest), deepest)
            while True:
                row = StruckCells(self.bed, reach, count)
                try:
                    return self._flown(Flight(row, self.mass, self.velocity), deepest, dt)
                except TooNarrow:
                    reach = WIDENED * reach
        elastic = elastic_like(self.bed)
        _, radius = at_depth(elastic, np.array([deepest]))
        springs = Springs.of(elastic, float(radius[0]), count)
        springy = SpringRow(elastic, springs, relaxation_of("", self.bed))
        return self._flown(Flight(springy, self.mass, self.velocity), deepest, dt)

    def _flown(self, flight: Flight, deepest: float, dt: float) -> Flight:
        for _ in range(int(LONGEST_CONTACT * deepest / self.velocity / dt)):
            going = flight.goes_on(dt)
            slow = flight.velocity**2 < REST_ENERGY * self.velocity**2
            resting = slow and flight.time > 2.0 * deepest / self.velocity
            if not going or resting or (flight.row.depth > deepest and math.isinf(self.bed.rim)):
                return flight
        raise NotConverged(
            "ViscoelasticImpact: the body neither comes to rest nor leaves; give the solid a shorter relaxation time."
        )


def _depth_of(elastic: Bed, energy: float, guess: float) -> float:
    """Return the depth [m] of a bed, as if it were elastic, that stores an energy [J], to a part in a thousand."""
    low = high = guess
    while _stored(elastic, high) < energy:
        low, high = high, 2.0 * high
    while _stored(elastic, low) >= energy:
        low, high = 0.5 * low, low
    for _ in range(10):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _stored(elastic, middle) < energy else (low, middle)
    return high


def _stored(elastic: Bed, depth: float) -> float:
    """Return the integral of the force over the depth [J]."""
    if not elastic.rising:  # every radius is sought by itself: one, and what its springs have stored
        _, radius = at_depth(elastic, np.array([depth]))
        springs = Springs.of(elastic, float(radius[0]), SAMPLES)
        return 0.5 * float(springs.stiffness @ (depth - springs.gap) ** 2)
    depths = np.linspace(0.0, depth, SAMPLES)[1:]
    _, radii = at_depth(elastic, depths)
    forces = elastic.stiffness(radii) * depths - elastic.gap_load(radii)
    return float((np.sum(forces) - 0.5 * forces[-1]) * depth / (SAMPLES - 1))


@value
class ViscoelasticImpactSolution:
    """The solution of a `ViscoelasticImpact`.

    Parameters
    ----------
    problem : ViscoelasticImpact
        The problem that was solved.
    time : ndarray, (steps,)
        Time since first touch [s], up to the separation of the last spring, or rest.
    depth : ndarray, (steps,)
        d [m].
    velocity : ndarray, (steps,)
        Velocity of approach [m/s], negative during the rebound.
    force : ndarray, (steps,)
        F_N [N].
    radius : ndarray, (steps,)
        a [m].
    stored_energy : ndarray, (steps,)
        Elastic energy of all springs, also of those that recover freely [J].
    bulk_loss : ndarray, (steps,)
        Energy dissipated in the bodies since first touch [J]: the sum over the dashpots of all springs.
    """

    __words__ = words(stored_energy=("U", "J", "energy stored in all springs, also in those set free"))

    problem: ViscoelasticImpact
    time: Array
    depth: Array
    velocity: Array
    force: Array
    radius: Array
    stored_energy: Array
    bulk_loss: Array

    @property
    def kinetic_energy(self) -> Array:
        """m v^2 / 2 [J], ``(steps,)``."""
        return np.asarray(0.5 * self.problem.mass * self.velocity**2)

    @property
    def restitution(self) -> float:
        """Rebound velocity over approach velocity [-]; zero if the body comes to rest."""
        return max(0.0, -float(self.velocity[-1]) / self.problem.velocity)

    @property
    def duration(self) -> float:
        """Contact time [s]."""
        return float(self.time[-1])

    @property
    def dissipation(self) -> float:
        """Kinetic energy absorbed by the impact [J]; part of it is released later as the surface recovers."""
        if self.restitution == 0.0:
            return float(self.kinetic_energy[0])
        return float(self.stored_energy[-1] + self.bulk_loss[-1])

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes and size of the body, slowness."""
        bed, widest = self.problem.bed, np.array([np.max(self.radius)])
        if layered := is_layered("", bed):
            modulus = float(bed.with_medium(bed.medium.glassy).normal_stiffness(widest)[0])  # type: ignore[attr-defined]
        else:
            series = relaxation_of("ViscoelasticImpact", bed)
            stiffest = series.glassy
            if not math.isfinite(stiffest):
                stiffest = max(series.relaxed, series.viscosity / self.duration)
            modulus = stiffest * float(elastic_like(bed).normal_stiffness(widest)[0])
        share = wave_loss(modulus=modulus, mass=self.problem.mass, size=bed.size, velocity=self.problem.velocity)
        times = times_notes(bed.medium, float(np.min(np.diff(self.time))), self.duration)
        balance = energy_note(self.kinetic_energy[0] - self.kinetic_energy, self.stored_energy, self.bulk_loss)
        own = (*times, balance, wave_note(share))
        if not layered:
            return relaxing_notes(bed, self.depth, self.radius, own)
        coarse = replace(self.problem, count=max(2, self.problem.count // 2)).solve()
        change = abs(coarse.restitution - self.restitution)
        return layered_notes(self.problem, self, own, resolution_note(bed, "the restitution", change, float(widest[0])))


class StruckCells:
    """Cells on layers with separate relaxation functions, with what a `Flight` asks of a row of springs."""

    def __init__(self, bed: Bed, reach: float, count: int) -> None:
        self.contact = LayeredMarch("ViscoelasticImpact", bed, cells_of(bed, reach, count), 0.0)
        self.cells, self.depth, self.state = self.contact.cells, 0.0, self.contact.state

    def struck(self, velocity: float, mass: float, dt: float) -> tuple[float, int]:
        """Return the mean velocity [m/s] of a body in a step, and how many cells bear after it.

        The load of each cell changes steadily, and so does the force: its impulse is that of its mean, and what is
        left of the motion is a spring of the stiffness 4 m / dt^2 beside the cells.
        """
        inertia = 4.0 * mass / dt**2
        thrown = inertia * (self.depth + velocity * dt) - self.contact.state.force
        self.state = self.cells.step(self.contact.state, dt, None, thrown, inertia)
        if self.state.held == self.cells.count and not self.contact.pinned:
            raise TooNarrow
        return (self.state.depth - self.depth) / dt, self.state.held

    def march(self, changes: Array, spans: Array) -> SpringMemory:
        """Go on to where the body was just struck."""
        before, after = self.contact.state, self.state
        self.contact.state, self.depth = after, self.depth + float(changes[0])
        self.contact.time += float(spans[0])
        self.contact.examine()
        lost, stored = self.cells.lost(before, after, float(spans[0])), self.cells.stored(after)
        work = 0.5 * (before.force + after.force) * float(changes[0])
        numbers = (work, lost, stored, after.radius, after.force, False)
        return SpringMemory._make(np.array([each]) for each in numbers)


class Flight:
    """A body of a mass [kg] that flies against a row of springs, and what it has met so far."""

    def __init__(self, row: SpringRow | StruckCells, mass: float, velocity: float) -> None:
        self.row, self.mass = row, mass
        self.time, self.velocity, self.lost = 0.0, velocity, 0.0
        self.lines = [(0.0, 0.0, velocity, 0.0, 0.0, 0.0, 0.0)]

    def greatest_depth(self) -> float:
        """Return the greatest depth so far [m]."""
        return max(line[1] for line in self.lines)

    def goes_on(self, dt: float) -> bool:
        """Fly for a time, or until the last spring lets go; return whether one is still pressed."""
        mean, held = self.row.struck(self.velocity, self.mass, dt)
        if self.velocity < 0.0 and held == 0:
            mean, dt = self._parting(dt)
            done = self.row.march(np.array([mean * dt]), np.array([dt]))
            self._arrive(mean, dt, done._replace(force=np.zeros(1), radius=np.zeros(1)))
            return False
        done = self.row.march(np.array([mean * dt]), np.array([dt]))
        self._arrive(mean, dt, done)
        refuse_rings("ViscoelasticImpact", np.array([self.time]), done.ring)
        return True

    def _arrive(self, mean: float, dt: float, done: SpringMemory) -> None:
        self.velocity, self.time = 2.0 * mean - self.velocity, self.time + dt
        depth = self.lines[-1][1] + mean * dt
        self.lost += float(done.lost[0])
        ends = float(done.force[0]), float(done.radius[0]), float(done.stored[0]), self.lost
        self.lines.append((self.time, depth, self.velocity, *ends))

    def _parting(self, dt: float) -> tuple[float, float]:
        """Return the mean velocity in the step that ends when the last spring lets go, and its length."""
        low, high = 0.0, dt
        for _ in range(40):
            middle = 0.5 * (low + high)
            _, held = self.row.struck(self.velocity, self.mass, middle)
            low, high = (middle, high) if held else (low, middle)
        return self.row.struck(self.velocity, self.mass, high)[0], high
