r"""Impact: a body that strikes a surface, straight or obliquely, with or without spin, and with dry friction.

The bodies are rigid but for the contact, whose force is that of slow motion.  With the approach velocity
:math:`v=\dot d`, and :math:`w=\dot u_x` of the touching points, which spin :math:`\omega` moves by :math:`\ell\omega`,

.. math:: m\dot v = -F_N(d), \qquad \dot w = -\Bigl(\frac1m+\frac{\ell^2}{I}\Bigr)F_x, \qquad w = v_x - \ell\omega .

The shear force of the springs is followed through sticking, sliding and turning back without a grid
(`winkler.problems.impact.march`), on layers and gradings ring by ring (`winkler.problems.impact.ring_march`); friction
is all that takes energy.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.laws.friction import Coulomb
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import BALANCED, SHEARED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.inertia import wave_loss, wave_note
from winkler.problems.impact.march import stages
from winkler.problems.impact.motion import ImpactMoment, ImpactProblem, turning
from winkler.problems.impact.ring_march import RingMarch, march_rings
from winkler.problems.impact.states import ImpactHistory, ImpactStage, ImpactState
from winkler.problems.impact.validity import Moments, gravity_note, refuse_unlikely_spin, slip_notes
from winkler.problems.normal.force_curve import deepest, normal_curve
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import FRICTIONLESS, SurfaceFriction, slid_depth
from winkler.problems.ring_slip.ring_table import RingTable
from winkler.problems.ring_slip.sliding_springs import sliding_springs
from winkler.values.checks.number_checks import Finite, NonNegative, Positive, PositiveNotTiny, PositiveOrInfinite
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value


@value
class Impact:
    """Impact of a body on a surface.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).  With friction and tangential motion: on a medium with one ratio of
        tangential to normal stiffness of all springs, on bonded layers, or on a body graded in depth.
    law : Coulomb
        Coulomb(coefficient); infinite if slip is excluded, zero without friction.
    mass : float
        m [kg] of the body; for two free bodies m1 m2 / (m1 + m2).
    velocity : float
        v [m/s] of approach at first touch, positive.
    lateral_velocity : float, optional
        v_x [m/s] of the centre of mass along the surface at first touch.
    angular_velocity : float, optional
        omega [rad/s] at first touch, about the axis in the surface perpendicular to the motion; positive for a ball
        that rolls forwards.  It needs a lever.
    inertia : float, optional
        I [kg m^2] about that axis through the centre of mass; infinite if the body does not turn.  It needs a lever.
    lever : float, optional
        Distance from the centre of mass to the surface [m]: for a ball its radius.
    count : int, optional
        Number of moments at which states are returned; the motion does not depend on them.

    Raises
    ------
    InvalidInput
        If a number has the wrong sign or type, or friction exceeds 1e5 but is finite. If a body has spin or inertia
        without a lever, or a lever without inertia and angular velocity.

    References
    ----------
    N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, doi:10.1016/0043-1648(76)90201-5;
    I. A. Lyashenko, V. L. Popov, Sci. Rep. 5 (2015) 8479, doi:10.1038/srep08479

    Examples
    --------
    A rubber ball thrown forwards without spin goes on with forward spin, slower.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> radius, mass = 0.02, 0.04
    >>> bed = Foundation(Paraboloid(radius), HalfSpace.between(Elastic(young=5e6, poisson=0.5)))
    >>> thrown = Impact(bed, Coulomb(0.8), mass=mass, velocity=1.0, lateral_velocity=0.5,
    ...                 inertia=0.4 * mass * radius**2, lever=radius).solve()
    >>> print(f"{thrown.lateral_velocity[-1]:.4f} m/s, {thrown.angular_velocity[-1]:.3f} rad/s")
    0.3208 m/s, 22.406 rad/s
    """

    bed: Bed
    law: Coulomb
    mass: PositiveNotTiny
    velocity: Positive
    lateral_velocity: Finite = 0.0
    angular_velocity: Finite = 0.0
    inertia: PositiveOrInfinite = math.inf
    lever: NonNegative = 0.0
    count: Moments = 201

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "hertz_1882",
        "maw_barber_fawcett_1976",
        "lyashenko_popov_2015",
    )
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | BALANCED | {Assumption.INERTIA}
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        refuse_unlikely_spin("Impact", self.law, self.mass, self.angular_velocity, self.inertia, self.lever)

    @property
    def sliding_velocity(self) -> float:
        """Relative tangential velocity of the contact points at first touch, v_x - lever omega [m/s]."""
        return self.lateral_velocity - self.lever * self.angular_velocity

    @property
    def mobility(self) -> float:
        """Change of the tangential velocity of the contact points per tangential impulse, 1/m + lever^2 / I [1/kg]."""
        return 1.0 / self.mass + self.lever**2 / self.inertia

    @property
    def _slides(self) -> bool:
        return self.law.coefficient > 0.0 and self.sliding_velocity != 0.0

    @property
    def total(self) -> int:
        """Number of states that `steps` yields."""
        return self.count

    def steps(self) -> Iterator[ImpactState]:
        """Yield the state at `count` moments, evenly spaced from first touch to the end of contact.

        Raises
        ------
        OutsideValidity
            If the depth exceeds the known range of the profile, or a contact along the path is not a disc. If the
            impact is oblique, the springs have different stiffness ratios, and the medium is not a coating. The error
            is raised before the first state.
        NotConverged
            If the profile is too rough, or the time integration stops.
        """
        depth, ratio, table = deepest(self.bed, 0.5 * self.mass * self.velocity**2), 1.0, None
        if self._slides:
            radius = float(at_depth(self.bed, np.array([depth]))[1][0])
            ratio, table = sliding_springs("Impact", self.bed, self.law.coefficient, radius)
        moving = self.mass, self.mobility, self.velocity, self.sliding_velocity
        motion = ImpactProblem(normal_curve(self.bed, depth), depth, *moving, ratio, self.law.coefficient)
        if table is None:
            yield from states_along(self.bed, motion, self.count)
        else:
            yield from ring_states(self.bed, motion, table, self.count)

    def gathered(self, states: Iterable[ImpactState]) -> ImpactSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        every = list(states)
        stages = joined_stages([stage for state in every for stage in state.stages], every[-1].time)
        return gather(ImpactSolution, self, every, duration=every[-1].duration, stages=stages)

    def solve(self) -> ImpactSolution:
        """Return the whole impact.

        Returns
        -------
        ImpactSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class ImpactSolution(ImpactHistory[Array]):
    """The solution of an `Impact`, moment by moment; its numbers are those of `ImpactHistory`.

    Parameters
    ----------
    problem : Impact
        The problem that was solved.
    stages : tuple of ImpactStage
        The phases of the impact: full stick, or slip of the contact edge in one direction.
    duration : float
        Contact time [s], also of a solution that was stopped before.
    """

    problem: Impact
    stages: tuple[ImpactStage, ...]
    duration: float

    @property
    def _impulse(self) -> Array:
        """What the shear force has transferred since first touch [N s]."""
        return np.asarray((self.problem.sliding_velocity - self.sliding_velocity) / self.problem.mobility)

    @property
    def lateral_velocity(self) -> Array:
        """v_x [m/s] of the centre of mass, ``(steps,)``."""
        return np.asarray(self.problem.lateral_velocity - self._impulse / self.problem.mass)

    @property
    def angular_velocity(self) -> Array:
        """omega [rad/s], ``(steps,)``."""
        problem = self.problem
        return np.asarray(problem.angular_velocity + problem.lever / problem.inertia * self._impulse)

    @property
    def kinetic_energy(self) -> Array:
        """Kinetic energy available to the contact, m v^2/2 + w^2/(2 kappa) [J], ``(steps,)``.

        The rest of the energy belongs to the rolling motion, which contact forces do not change.
        """
        problem = self.problem
        return np.asarray(0.5 * problem.mass * self.velocity**2 + 0.5 * self.sliding_velocity**2 / problem.mobility)

    @property
    def balance(self) -> Array:
        """Sum of kinetic, elastic and dissipated energy over the energy at first touch, ``(steps,)``; should be one."""
        total = self.kinetic_energy + self.energy + self.stored_energy + self.dissipation
        return np.asarray(total / total[0])

    @property
    def restitution(self) -> float:
        """Rebound velocity over approach velocity [-]; nan if the time integration was stopped before."""
        return -float(self.velocity[-1]) / self.problem.velocity if self.time[-1] == self.duration else math.nan

    @property
    def lateral_restitution(self) -> float:
        """The same ratio for tangential velocities [-]: -1 without friction, at most 1; nan if they are zero."""
        before = self.problem.sliding_velocity
        return -float(self.sliding_velocity[-1]) / before if before and self.time[-1] == self.duration else math.nan

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact at its widest, slowness, gravity, friction."""
        problem = self.problem
        widest = int(np.argmax(self.depth))
        depth, force, radius = (x[widest : widest + 1] for x in (self.depth, self.force, self.radius))
        bed = problem.bed
        modulus = float(bed.normal_stiffness(radius)[0])
        share = wave_loss(modulus=modulus, mass=problem.mass, size=bed.size, velocity=problem.velocity)
        mu = problem.law.coefficient
        slides = problem._slides
        rubbing = (
            SurfaceFriction(mu, slid_depth(mu, self.depth, self.force, self.shear_force)) if slides else FRICTIONLESS
        )
        mechanical = self.kinetic_energy + self.energy + self.stored_energy
        balance = energy_note(np.full(mechanical.size, mechanical[0]), mechanical, self.dissipation)
        pressed = indentation_notes(bed, depth, radius, rubbing)
        if isinstance(bed, Foundation) and isinstance(bed.medium, HalfSpace):
            pressed = tuple(_beyond_yield(note) for note in pressed)
        notes = [*pressed, balance, wave_note(share), gravity_note(force)]
        if slides:
            notes += slip_notes(bed, mu, float(radius[0]))
        return tuple(notes)


def _beyond_yield(note: Note) -> Note:
    """Return a note on yield with the problem that follows an impact beyond it; others as they are."""
    if note.assumption is not Assumption.ELASTIC or note.standing is not Standing.OUTSIDE:
        return note
    return dataclasses.replace(note, statement=f"{note.statement} PlasticImpact goes on where a body yields.")


SHORTEST_STAGE = 0.01
"""Part of the duration that a stage of rings lasts at least: at the edge single steps stick and slide by turns."""


def states_along(bed: Bed, motion: ImpactProblem, count: int) -> Iterator[ImpactState]:
    """Yield the state at `count` moments, evenly spaced from first touch to the end of contact."""
    turn = turning(motion)
    times = np.linspace(0.0, 2.0 * turn, count)
    done, begun = 0, tuple[ImpactStage, ...]()
    for stage in stages(motion, turn):
        begun = (*begun, ImpactStage(stage.start, stage.end, stage.sign))
        stop = int(np.searchsorted(times, stage.end, side="right"))
        requested = times[done:stop]
        moments = [stage.moment(time) for time in requested.tolist()]
        if stop == count:
            moments[-1] = _parted(moments[-1])
        if moments:
            yield from _states_at(bed, requested, moments, begun, 2.0 * turn)
            done, begun = stop, ()


def ring_states(bed: Bed, motion: ImpactProblem, table: RingTable, count: int) -> Iterator[ImpactState]:
    """Yield the state at `count` moments, of rings that slide."""
    march = march_rings(motion, table, count)
    end = float(march.time[-1])
    times = np.linspace(0.0, end, count)
    words = ("depth", "velocity", "shift", "sliding", "shear", "stored", "lost", "stick")
    columns = [np.interp(times, march.time, getattr(march, word)) for word in words]
    every, sides = _ring_stages(march)
    starts = [stage.start for stage in every]
    known = np.searchsorted(starts, times, side="left")
    known[0], known[-1] = 1, len(starts)
    radii = at_depth(bed, columns[0])[1]
    before = 0
    for i, row in enumerate(zip(*(column.tolist() for column in columns), strict=True)):
        depth, velocity, shift, sliding, shear, kept, lost, stick = row
        _, force, pressed = motion.curve.at(depth) if depth > 0.0 else (0.0, 0.0, 0.0)
        radius = float(radii[i])
        yield ImpactState(
            time=float(times[i]),
            depth=depth,
            shift=shift,
            velocity=velocity,
            sliding_velocity=sliding,
            force=force,
            shear_force=shear,
            radius=radius,
            stick_radius=min(stick, radius),
            energy=pressed,
            stored_energy=kept,
            dissipation=lost,
            side=int(sides[min(max(int(np.searchsorted(march.time, times[i])) - 1, 0), sides.size - 1)]),
            stages=tuple(every[before : int(known[i])]),
            duration=end,
        )
        before = max(before, int(known[i]))


def _ring_stages(march: RingMarch) -> tuple[list[ImpactStage], NDArray[np.int_]]:
    """Return the stages, and the side of every step; what lasts a few steps at the edge counts to what was before."""
    sides = march.side.copy()
    turns = [0, *(np.flatnonzero(np.diff(sides)) + 1).tolist(), sides.size]
    for first, last in pairwise(turns):
        if first > 0 and last - first < SHORTEST_STAGE * sides.size:
            sides[first:last] = sides[first - 1]
    turns = [0, *(np.flatnonzero(np.diff(sides)) + 1).tolist(), sides.size]
    stages = [
        ImpactStage(float(march.time[first]), float(march.time[last]), int(sides[first]))
        for first, last in pairwise(turns)
    ]
    return stages, sides


def _states_at(
    bed: Bed, times: Array, moments: list[ImpactMoment], begun: tuple[ImpactStage, ...], duration: float
) -> list[ImpactState]:
    gaps = np.maximum([(moment.depth, moment.stuck) for moment in moments], 0.0)
    radii = at_depth(bed, gaps.ravel())[1].reshape(-1, 2)
    states: list[ImpactState] = []
    for time, moment, (depth, _), (radius, stick) in zip(
        times.tolist(), moments, gaps.tolist(), radii.tolist(), strict=True
    ):
        quantities = {**moment._asdict(), "depth": depth}
        del quantities["stuck"]
        states.append(
            ImpactState(
                time=time,
                radius=radius,
                stick_radius=min(stick, radius),
                side=begun[-1].side,
                stages=() if states else begun,
                duration=duration,
                **quantities,
            )
        )
    return states


def _parted(end: ImpactMoment) -> ImpactMoment:
    """Return the moment after the last springs have parted: what they still stored is lost."""
    nothing = dict.fromkeys(("depth", "force", "shear_force", "energy", "stored_energy", "stuck"), 0.0)
    return end._replace(dissipation=end.dissipation + end.stored_energy, **nothing)


def joined_stages(parts: list[ImpactStage], last: float) -> tuple[ImpactStage, ...]:
    """Return the stages up to a time [s], those of one side after the other as one."""
    joined: list[ImpactStage] = []
    for stage in parts:
        end = min(stage.end, last)
        if joined and stage.side == joined[-1].side:
            joined[-1] = ImpactStage(joined[-1].start, end, stage.side)
        else:
            joined.append(ImpactStage(stage.start, end, stage.side))
    return tuple(joined)
