r"""Impact of a body that sticks: snap-in, loss at pull-off, and the velocity below which it stays.

While the edge of the contact follows Griffith's balance under fixed grips (`winkler.problems.adhesion.cycle`), the body
moves by :math:`m\dot v=-F(d)`, with one curve of forces for the approach and another for the rebound.  Where the edge
loses its hold it runs on at once; what its potential falls by is lost, and so is what opening costs more than closing
has gained.  A ball leaves with

.. math:: e = \sqrt{1-(v_\mathrm{s}/v)^2}, \qquad
          \tfrac12 m v_\mathrm{s}^2 = 7.092\left(\frac{w^5R^4}{E^{*2}}\right)^{1/3},

and not at all if it arrives more slowly than that.

How a body moves into an adhesive contact and back: two curves of force over the depth, and the motion along them.

In each direction the force is smooth between the depths at which the edge runs on, comes free, or passes a kink of the
profile; there it is laid on panels, and the motion :math:`m\ddot d=-F(d)` is integrated from one such depth to the
next.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Depth
from winkler.numerics.equations.marching import IntegratedStates, StopCondition, integrate_to_stop
from winkler.numerics.equations.roots import between
from winkler.numerics.equations.turning import Leap, Slopes
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.types import Array
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.cycle_states import AdhesiveJump
from winkler.problems.adhesion.edge import AdhesiveEdge, LoadingMachine, adhesive_edge
from winkler.problems.adhesion.edge_states import stored_energy
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ADHESIVE, BALANCED
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.assumptions.inertia import wave_loss, wave_note
from winkler.problems.impact.states import AdhesiveImpactHistory, AdhesiveImpactState
from winkler.problems.impact.validity import Moments, gravity_note
from winkler.problems.normal.force_curve import rough_depth
from winkler.values.checks.number_checks import Advice, Positive, PositiveNotTiny
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

RANGE_ADVICE = Advice("attraction from afar begins before the touch")


@value
class AdhesiveImpact:
    """Normal impact of an adhesive body.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium).
    law : ShortRange
        ShortRange(work), or with hysteresis ShortRange(work_closing=..., work_opening=...).
    mass : float
        m [kg] of the body; for two free bodies m1 m2 / (m1 + m2).
    velocity : float
        v [m/s] of approach at first touch, positive.
    count : int, optional
        Number of times at which states are returned; the time of maximum depth is added.

    Raises
    ------
    InvalidInput
        If a number is of the wrong sign or kind, or the law is another one.

    References
    ----------
    C. Thornton, Z. Ning, Powder Technol. 99 (1998) 154-162, doi:10.1016/S0032-5910(98)00099-0

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), HalfSpace(Elastic(1.0, 0.0)))
    >>> sticking = (2.0 * 7.092195972e-5) ** 0.5  # at w = 1e-3 and m = 1
    >>> impact = AdhesiveImpact(bed, ShortRange(1e-3), mass=1.0, velocity=2.0 * sticking).solve()
    >>> round(impact.restitution, 6), round(0.75**0.5, 6)
    (0.866025, 0.866025)
    """

    bed: Bed
    law: Annotated[ShortRange, RANGE_ADVICE]
    mass: PositiveNotTiny
    velocity: Positive
    count: Moments = 201

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "johnson_kendall_roberts_1971",
        "thornton_ning_1998",
    )
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE | BALANCED | {Assumption.INERTIA}
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: `count`, plus one if the state of maximum depth is not among them."""
        return self.count + 1

    def steps(self) -> Iterator[AdhesiveImpactState]:
        """Yield the state at `count` moments, evenly spaced, and at the maximum depth.

        Raises
        ------
        OutsideValidity
            If the body is pressed in beyond the known range of its profile, or a contact along the path is not a disc.
        NotConverged
            If the profile is too rough, or the time integration stops.
        """
        moved = impact_motion(self.bed, self.law, self.mass, self.velocity)
        times = np.union1d(np.linspace(0.0, moved.duration, self.count), [moved.turn]).tolist()
        motion = [moved.at(time) for time in times]
        depths = np.array([depth for depth, _ in motion])
        depths[0], depths[times.index(moved.turn)] = 0.0, moved.deepest
        if not moved.captured:  # a little beyond where the edge loses its hold
            depths[-1] = moved.parting - SEPARATION_MARGIN * (moved.deepest - moved.parting)
        cycle = AdhesiveCycle(self.bed, self.law, Depth(depths))
        for time, (depth, velocity), state in zip(times, motion, cycle.steps(), strict=True):
            elastic = float(stored_energy(self.bed, np.array([state.depth]), np.array([state.radius]))[0])
            yield AdhesiveImpactState(
                time=time,
                depth=depth,
                velocity=velocity,
                force=state.force,
                radius=state.radius,
                energy=elastic - self.law.work_closing * np.pi * state.radius**2,
                dissipation=state.dissipation,
                jumps=state.jumps,
                duration=moved.duration,
                captured=moved.captured,
            )

    def gathered(self, states: Iterable[AdhesiveImpactState]) -> AdhesiveImpactSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        every = list(states)
        return gather(
            AdhesiveImpactSolution,
            self,
            every,
            jumps=tuple(jump for state in every for jump in state.jumps),
            duration=every[-1].duration,
            captured=every[-1].captured,
        )

    def solve(self) -> AdhesiveImpactSolution:
        """Return the impact until the bodies part, or turn back in contact.

        Returns
        -------
        AdhesiveImpactSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


SEPARATION_MARGIN = 1e-9
"""Part of the whole depth by which bodies are drawn beyond the last hold."""


@value
class AdhesiveImpactSolution(AdhesiveImpactHistory[Array]):
    """The solution of an `AdhesiveImpact`, moment by moment; its numbers are those of `AdhesiveImpactHistory`.

    Parameters
    ----------
    problem : AdhesiveImpact
        The problem that was solved.
    jumps : tuple of AdhesiveJump
        All jumps: snap-in, pull-off and those between.
    duration : float
        Contact time, or until they stand still during the rebound [s], also of a solution that was stopped
        before.
    captured : bool
        Whether the body stays in contact and oscillates there.
    """

    problem: AdhesiveImpact
    jumps: tuple[AdhesiveJump, ...]
    duration: float
    captured: bool

    @property
    def kinetic_energy(self) -> Array:
        """m v^2 / 2 [J], ``(steps,)``."""
        return np.asarray(0.5 * self.problem.mass * self.velocity**2)

    @property
    def balance(self) -> Array:
        """Sum of kinetic, elastic and dissipated energy over the energy at first touch, ``(steps,)``; should be one."""
        total = self.kinetic_energy + self.energy + self.dissipation
        return np.asarray(total / (0.5 * self.problem.mass * self.problem.velocity**2))

    @property
    def restitution(self) -> float:
        """Rebound velocity over approach velocity [-]; zero if the body stays, nan if `steps` was stopped."""
        if self.captured:
            return 0.0
        return -float(self.velocity[-1]) / self.problem.velocity if self.time[-1] == self.duration else math.nan

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: attraction, slopes, slowness, gravity, jumps."""
        problem = self.problem
        modulus = float(problem.bed.normal_stiffness(np.array([np.max(self.radius)]))[0])
        share = wave_loss(modulus=modulus, mass=problem.mass, size=problem.bed.size, velocity=problem.velocity)
        energy_at_start = np.full(self.time.size, 0.5 * problem.mass * problem.velocity**2)
        verdict = "it stays, and oscillates in contact without end in this theory" if self.captured else "it leaves"
        return (
            *adhesive_notes(problem.bed, problem.law, self.depth, self.radius),
            energy_note(energy_at_start, self.kinetic_energy + self.energy, self.dissipation),
            wave_note(share),
            gravity_note(self.force),
            Note(
                Assumption.EQUILIBRIUM,
                Standing.ASYMPTOTIC,
                f"The contact edge advances in {len(self.jumps)} jumps, in which the body hardly moves. The "
                f"released energy is dissipated completely: {verdict}.",
                "Griffith's balance at every limit of stability, under fixed grips",
            ),
        )


PRECISION = 3e-14
LONGEST_DURATION = 1e6
FORCE_RESOLUTION = 1e-12
"""Of the greatest force: close to where the edge loses its hold, rounding of its radius matters."""
DOUBLINGS = 200
STEPS_PER_PANEL = 8


class ImpactMotion(NamedTuple):
    """The motion from first touch until the bodies part, or turn back in contact.

    Parameters
    ----------
    legs : tuple of IntegratedStates
        Depth [m] and velocity [m/s], piece after piece.
    turn : float
        When the depth is greatest [s].
    deepest : float
        Greatest depth [m].
    parting : float
        Depth at which nothing holds the edge any more [m].
    captured : bool
        Whether the body turns back before it comes free.
    """

    legs: tuple[IntegratedStates, ...]
    turn: float
    deepest: float
    parting: float
    captured: bool

    @property
    def duration(self) -> float:
        """When it ends [s]."""
        return self.legs[-1].end

    def at(self, time: float) -> tuple[float, float]:
        """Return depth [m] and velocity [m/s]."""
        leg = next((leg for leg in self.legs if time <= leg.end), self.legs[-1])
        depth, velocity = leg.at(time)
        return float(depth), float(velocity)


def impact_motion(bed: Bed, law: ShortRange, mass: float, velocity: float) -> ImpactMotion:
    """Return the motion of a body into contact and back.

    Raises
    ------
    OutsideValidity
        If the profile ends before the body is stopped.
    NotConverged
        If the march comes to a halt.
    """
    energy = 0.5 * mass * velocity**2
    edge, forces = _approach_path(bed, law, energy)
    stop = _first_passage(forces, energy)
    place = float(edge.closing.rise(0.0, np.array([stop]))[0][0])
    back, parting = _rebound_path(edge, place, stop)
    legs = _march(forces, mass, 0.0, np.array([0.0, velocity]))
    turn = legs[-1].end
    legs += _march(back[::-1], mass, turn, np.array([stop, 0.0]))
    return ImpactMotion(tuple(legs), turn, stop, parting, legs[-1].stopped[1])


def _breaks(bed: Bed, curve: Slopes, leaps: list[Leap], low: float, high: float, more: float = np.inf) -> Array:
    """Return the depths from `low` to `high` between which the force is smooth."""
    kinks = np.array([b for b, _ in bed.kinks if 0.0 < b < curve.places[-1]])
    levels = curve.curve(kinks) if kinks.size else kinks
    inner = np.array([*levels, *(leap.level for leap in leaps), more])
    space = 1e-9 * (high - low)
    return np.unique([low, *inner[(inner > low + space) & (inner < high - space)], high])


def _fitted(
    edge: AdhesiveEdge, path: Callable[[Array], tuple[Array, list[Leap]]], breaks: Array, order: int
) -> list[Panels]:
    """Return the force on every stretch between breaks; the path is followed with depths rising (1) or falling (-1)."""

    def force(depths: Array) -> Array:
        flat = depths.ravel()
        sorting = np.argsort(order * flat)
        places, _ = path(flat[sorting])
        result = np.empty(flat.shape)
        result[sorting] = edge.state(places, flat[sorting])[1]
        return result.reshape(depths.shape)

    greatest = float(np.max(np.abs(force(breaks))))
    return [fit_panels(force, np.array(ends), FORCE_RESOLUTION * greatest) for ends in pairwise(breaks)]


def _approach_path(bed: Bed, law: ShortRange, energy: float) -> tuple[AdhesiveEdge, list[Panels]]:
    """Return the edge and the forces of the approach, as far as they need to stop the body."""
    highest = 2.0 * rough_depth(bed, energy)
    for _ in range(DOUBLINGS):
        edge = adhesive_edge(bed, law, LoadingMachine(0.0), highest)
        ends = bed.reach < bed.rim and edge.closing.places[-1] >= bed.reach
        last = min(highest, float(edge.closing.levels[-1])) if ends else highest
        _, leaps = edge.closing.rise(0.0, np.array([last]))
        breaks = _breaks(bed, edge.closing, leaps, 0.0, last)
        forces = _fitted(edge, lambda depths, edge=edge: edge.closing.rise(0.0, depths), breaks, 1)  # type: ignore[misc]
        if sum(_gained(piece) for piece in forces) > energy:
            return edge, forces
        if last < highest:
            raise OutsideValidity(
                f"AdhesiveImpact: {energy:.6g} J press the body beyond its reach ({bed.reach:.6g} m); describe more "
                "of the profile, or give a slower or lighter body."
            )
        highest *= 2.0
    raise NotConverged(f"AdhesiveImpact: no depth was found that stops {energy:.6g} J.")


def _gained(piece: Panels) -> float:
    return float(piece.integral(piece.edges[-1:])[0])


def _first_passage(forces: list[Panels], energy: float) -> float:
    """Return the first depth at which the work of the forces reaches an energy."""
    done = 0.0
    for piece in forces:
        work = piece.integral
        part = np.linspace(0.0, 1.0, STEPS_PER_PANEL + 1)[:-1]
        depths = np.append((piece.edges[:-1, None] + np.diff(piece.edges)[:, None] * part).ravel(), piece.edges[-1])
        spent = done + work(depths) - energy
        beyond = np.flatnonzero(spent >= 0.0)
        if beyond.size and beyond[0] == 0:  # rounding: the last piece has reached it
            return float(depths[0])
        if beyond.size:
            low, high = depths[beyond[0] - 1], depths[beyond[0]]
            return between(functools.partial(_missing, work=work, energy=energy - done), low, high)
        done += _gained(piece)
    raise NotConverged(f"AdhesiveImpact: no depth was found that stops {energy:.6g} J.")


def _missing(depth: float, work: Panels, energy: float) -> float:
    return float(work(np.array(depth))) - energy


def _rebound_path(edge: AdhesiveEdge, place: float, stop: float) -> tuple[list[Panels], float]:
    """Return the forces of the rebound, deepest last, and where the bodies part."""
    levels = edge.opening.levels
    below = float(np.min(levels)) - 0.01 * float(np.ptp(levels))
    _, leaps = edge.opening.fall(place, np.array([below]))
    parting = next((leap.level for leap in leaps if leap.end == 0.0), 0.0)
    free = float(edge.opening.curve(np.array([place]))[0])
    breaks = _breaks(edge.bed, edge.opening, leaps, parting, stop, free)
    return _fitted(edge, lambda depths: edge.opening.fall(place, depths), breaks, -1), parting


def _march(forces: list[Panels], mass: float, time: float, state: Array) -> list[IntegratedStates]:
    """Return the motion through stretches of force, until they end or the body stands."""
    inward = bool(state[1] > 0.0)
    legs = []
    for piece in forces:
        legs.append(_through(piece, mass, time, state, inward))
        time, state = legs[-1].end, legs[-1].last
        if legs[-1].stopped[1]:
            break
    return legs


def _through(piece: Panels, mass: float, time: float, state: Array, inward: bool) -> IntegratedStates:
    low, high = float(piece.edges[0]), float(piece.edges[-1])
    goal, direction = (high, 1) if inward else (low, -1)
    width = high - low
    fast = abs(float(state[1])) + (float(np.max(np.abs(piece(piece.edges)))) * width / mass) ** 0.5

    def rates(time: float, state: Array) -> list[float]:
        return [float(state[1]), -float(piece(np.clip(state[0], low, high))) / mass]

    passed = StopCondition(lambda time, state: float(state[0]) - goal, direction)
    stands = StopCondition(lambda time, state: float(state[1]), -direction)
    span = (time, time + LONGEST_DURATION * width / fast)
    scales, stops = np.array([width, fast]), (passed, stands)
    integrated = integrate_to_stop(
        rates, span, state, unit=width / fast, precision=PRECISION, scales=scales, stops=stops
    )
    if not any(integrated.stopped):
        raise NotConverged(
            f"AdhesiveImpact: the body hangs between {low:.6g} m and {high:.6g} m, where hardly a force moves it; "
            "change its velocity a little."
        )
    return integrated
