r"""Adhesion of rubber on separated scales of time: a relaxed body, whose edge opens at a speed that its pull decides.

The edge of the contact is a crack.  It recedes as fast as what is released there makes it,

.. math:: \mathcal G(a,d) = \frac{k'(a)\,(g(a)-d)^2}{4\pi a} = w(\dot a) , \qquad d + F/k_\mathrm{m} = D(t) ,

and closes without delay where that falls to the work of slow opening.  Between two points of the path the machine moves
steadily; of its work what is not stored is lost.

The edge of an adhesive contact as a crack whose speed is decided by its pull, carried along in time.

What is unknown in a step is the energy release rate that the edge meets at its end: it determines the speed, the speed
the place, and the place the energy release rate.  In these terms an edge that follows the machine closely, one that
lags behind and one that has lost its hold and collapses are the same, and no step is too stiff.  Every step of second
order (Alexander's, with both stages implicit) is made at once and in halves, which gives its error and removes most of
it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.laws.adhesion import ShortRange
from winkler.laws.crack import CrackLaw
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array, PerLoad, Q
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.edge import AdhesiveEdge, LoadingMachine, adhesive_edge
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ADHESIVE, BALANCED, RELAXING
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.values.checks.number_checks import POSITIVE_OR_INFINITE, Advice
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

RESTING_EXCESS = 1e-8
"""An edge that is driven by this part more than slow opening takes does not move."""


@value
class RubberCrack(PerLoad[Q]):
    """An adhesive contact of rubber at a moment, or at the points of its path.

    Parameters
    ----------
    time : float or ndarray, (steps,)
        [s].
    position : float or ndarray, (steps,)
        D [m], where the far end of the machine stands.
    depth, force, radius : float or ndarray, (steps,)
        d [m], F_N [N], a [m]; force and radius are zero apart.
    crack_speed : float or ndarray, (steps,)
        How fast the edge recedes [m/s]; zero where it rests or closes, infinite where nothing holds it.
    lowest_force : float or ndarray, (steps,)
        The lowest force since the beginning [N], negative if the bodies were pulled.
    work, energy : float or ndarray, (steps,)
        What the machine has spent since the beginning, and energy of bodies, machine and surfaces, less what closing
        has gained [J]; zero apart.
    dissipation : float or ndarray, (steps,)
        Energy lost since the beginning [J], in jumps and by opening.
    """

    __words__ = words(
        position=("D", "m", "where the far end of the machine stands"),
        work=("W", "J", "what the machine has spent since the beginning"),
    )

    time: Q
    position: Q
    depth: Q
    force: Q
    radius: Q
    crack_speed: Q
    lowest_force: Q
    work: Q
    energy: Q
    dissipation: Q


@value
class ViscoelasticAdhesionState(RubberCrack[float]):
    """An adhesive contact of rubber at one moment; its numbers are those of `RubberCrack`."""


MACHINE_STIFFNESS_RANGE = POSITIVE_OR_INFINITE._replace(demand="it must be positive{unit}, infinite for fixed grips")


@value
class ViscoelasticAdhesion:
    """Adhesive contact with a viscoelastic body, pressed and pulled off along a path.

    The bodies are initially apart and approach slowly up to the first point of the path.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium). A viscoelastic medium is assumed fully relaxed; RelaxingInProportion must contain
        the relaxed moduli.
    law : RateDependentWork or SaturatingWork
        The work of opening as a function of the speed.
    path : Path
        Positions of the drive of the machine over time, Path(time, Depth([...])).
    machine_stiffness : float, optional
        k_m [N/m] of the spring between the drive and the contact; infinite for fixed grips. A soft spring is almost a
        dead load.

    Raises
    ------
    InvalidInput
        If the body is a liquid at long times, its moduli are not the relaxed ones, or the law does not depend on speed.
        If the path prescribes forces or tangential motion, or the stiffness is not positive.

    References
    ----------
    D. Maugis, M. Barquins, J. Phys. D: Appl. Phys. 11 (1978) 1989-2023, doi:10.1088/0022-3727/11/14/011;
    M. Ciavarella, J. Adhes. Sci. Technol. (2021), doi:10.1080/01694243.2021.1882766

    Examples
    --------
    A ball with w_0 = 50 mJ/m^2 is pulled off rubber, slowly with 3/2 pi w_0 R (JKR), and faster with more.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.crack import RateDependentWork
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1e-3), HalfSpace(Elastic(young=1e6, poisson=0.5)))
    >>> law = RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    >>> for speed in (1e-12, 1e-8, 1e-7):
    ...     pulled = ViscoelasticAdhesion(bed, law, Path([0.0, 5e-5 / speed], Depth([5e-6, -45e-6]))).solve()
    ...     print(round(-pulled.lowest_force[-1] / (np.pi * 0.05 * 1e-3), 2))
    1.5
    1.94
    3.03
    """

    bed: Bed
    law: Annotated[CrackLaw, Advice("laws without a speed are those of AdhesiveCycle")]
    path: Path
    machine_stiffness: Annotated[float, MACHINE_STIFFNESS_RANGE] = math.inf

    references: ClassVar[tuple[str, ...]] = (
        "popov_hess_2015",
        "maugis_barquins_1978",
        "johnson_kendall_roberts_1971",
        "ciavarella_2021",
    )
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE | RELAXING | BALANCED
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def __post_init__(self) -> None:
        medium = self.bed.medium
        if isinstance(medium, ViscoelasticHalfSpace) and medium.relaxation.relaxed == 0.0:
            raise InvalidInput(
                "ViscoelasticAdhesion: the body creeps without limit and has no relaxed state to be pulled off from; "
                "give a solid with a relaxed modulus."
            )
        if isinstance(medium, RelaxingInProportion) and not math.isclose(medium.relaxation.relaxed, 1.0):
            raise InvalidInput(
                f"ViscoelasticAdhesion: the moduli of the medium belong to the shear modulus {medium.shear:g} Pa, and "
                "the body is taken as relaxed; give RelaxingInProportion(medium, solid, shear) with the relaxed moduli "
                f"in the medium and the relaxed shear modulus {medium.solid.series.relaxed:g} Pa."
            )
        if not isinstance(self.path.normal, Depth):
            raise InvalidInput(
                f"ViscoelasticAdhesion: a {type(self.path.normal).__name__} is prescribed; give Path(time, "
                "Depth([...])): a dead load is almost a machine with little stiffness."
            )
        if not isinstance(self.path.lateral, Shift) or np.any(self.path.along != 0.0):
            raise InvalidInput("ViscoelasticAdhesion: the path moves along the surface; leave the lateral load out.")

    @property
    def _relaxed(self) -> Bed:
        """The bed when all has relaxed."""
        medium = self.bed.medium
        if not offers(medium, RelaxingMedium):
            return self.bed
        assert isinstance(self.bed, OnMedium)
        if offers(medium, RelaxingByWaves):
            return self.bed.with_medium(medium.relaxed)
        if isinstance(medium, RelaxingInProportion):
            return self.bed.with_medium(medium.elastic)
        return self.bed.with_medium(HalfSpace(Elastic(medium.relaxation.relaxed, 0.0)))

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every point of the path."""
        return self.path.time.size

    def steps(self) -> Iterator[ViscoelasticAdhesionState]:
        """Yield the state at every point of the path.

        Raises
        ------
        OutsideValidity
            If the contact grows beyond the known range of the profile or is not a disc. The error is raised at that
            step, after all earlier states.
        NotConverged
            If the motion of the contact edge cannot be computed.
        """
        law, machine = self.law, LoadingMachine(1.0 / self.machine_stiffness)
        times, positions = self.path.time.tolist(), self.path.across.tolist()
        edge = adhesive_edge(self._relaxed, ShortRange(law.work), machine, max(positions))
        crack = Crack(edge, machine, law)
        crack.close(positions[0], positions[0])
        for i, (time, position) in enumerate(zip(times, positions, strict=True)):
            if i:
                crack.follow(positions[i - 1], position, time - times[i - 1])
            depth, force, release = crack.at(crack.radius, position)
            crack.lowest = min(crack.lowest, force)
            speed = float(law.speed(release)) if release > (1.0 + RESTING_EXCESS) * law.work else 0.0
            energy = crack.energy(crack.radius, position)
            yield ViscoelasticAdhesionState(
                time, position, depth, force, crack.radius, speed, crack.lowest, crack.work, energy, crack.lost
            )

    def gathered(self, states: Iterable[ViscoelasticAdhesionState]) -> ViscoelasticAdhesionSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return gather(ViscoelasticAdhesionSolution, self, states)

    def solve(self) -> ViscoelasticAdhesionSolution:
        """Return the whole path.

        Returns
        -------
        ViscoelasticAdhesionSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class ViscoelasticAdhesionSolution(RubberCrack[Array], Looped):
    """The solution of a `ViscoelasticAdhesion`, point by point; its numbers are those of `RubberCrack`.

    Parameters
    ----------
    problem : ViscoelasticAdhesion
        The problem that was solved.
    """

    problem: ViscoelasticAdhesion

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((self.problem.path.across,), self.position, self.force, self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        law = ShortRange(problem.law.work)
        contact = adhesive_notes(problem._relaxed, law, self.depth, self.radius)
        balance = energy_note(self.work, self.energy, self.dissipation)
        return (SEPARATED, *contact, balance, *relaxing_yield(problem.bed.medium), *self._cycle_notes)


SEPARATED = Note(
    Assumption.ADHESION,
    Standing.APPROXIMATE,
    "All viscous dissipation occurs at the contact edge. The body is assumed fully relaxed: the contact size "
    "over the speed of the edge is much longer than the relaxation times. The edge closes without delay. The "
    "work of adhesion during opening depends on the speed of the edge by the given law.",
    "D. Maugis, M. Barquins, J. Phys. D: Appl. Phys. 11 (1978) 1989-2023, doi:10.1088/0022-3727/11/14/011",
)


STAGE_WEIGHT = 1.0 - math.sqrt(0.5)
"""Of both stages of a step."""
LONGEST_STEP = 0.05
"""Longest step: by this part of its radius the edge recedes, of its stretch the machine moves."""
STEP_TOLERANCE = 1e-6
"""Error of a step, in terms of the radius at the beginning."""
LEAST_CONTACT = 1e-4
"""A contact of this part of its radius counts as parted, if the edge still recedes."""
SAMPLES = 401
"""Where the lowest force is sought between two steps."""
RADIUS_TOLERANCE = 1e-12
"""A place that moves by this part of the radius between two trials is found."""
MOST_TRIALS = 200
MOST_STEPS = 50_000
"""Steps between two points of a path."""
TIME_ROUNDING = 1e-12
"""Part of the machine's longest step that is none."""
INSTANT_SPEED = 1e9
"""An edge that crosses the contact so often while the machine makes its longest step takes no time."""


class _CrackState(NamedTuple):
    """Radius [m], the energy release rate there [J/m^2], force [N], and force times time since the start [N s]."""

    radius: float
    release: float
    force: float
    impulse: float


class Crack:
    """The edge of a contact that is carried along a path.

    Parameters
    ----------
    edge : AdhesiveEdge
        What it obeys when slow.
    machine : LoadingMachine
    law : CrackLaw
        How fast it opens.
    """

    def __init__(self, edge: AdhesiveEdge, machine: LoadingMachine, law: CrackLaw) -> None:
        self.edge, self.machine, self.law = edge, machine, law
        self.radius, self.lowest, self.pace, self.release = 0.0, 0.0, math.inf, 0.0
        self.work, self.lost = 0.0, 0.0
        self._stored = (0.0, 0.0, 0.0)

    def at(self, radius: float, position: float) -> tuple[float, float, float]:
        """Return depth [m], force [N] and energy release rate [J/m^2], the last one only where the edge is pulled."""
        if radius == 0.0:
            return position, 0.0, 0.0
        bed, place = self.edge.bed, np.array(radius)
        stiffness, load = float(bed.stiffness(place)), float(bed.gap_load(place))
        compliance = self.machine.compliance
        depth = (position + compliance * load) / (1.0 + compliance * stiffness)
        stretched = max(float(bed.gap(place)) - depth, 0.0)
        release = float(bed.normal_stiffness(place)) * stretched**2 / (2.0 * math.pi * radius)
        return depth, stiffness * depth - load, release

    def energy(self, radius: float, position: float) -> float:
        """Return what is stored in bodies and machine, less what closing has gained [J]."""
        if radius == 0.0:
            return 0.0
        if self._stored[:2] != (radius, position):  # where one leap ends, the next begins
            depth, force, place = self.edge.state(np.array([radius]), np.array([position]))
            energy = self.edge.energy(depth, force, place) + self.edge.control.energy(depth, force)
            self._stored = radius, position, float(energy[0])
        return self._stored[2]

    def close(self, start: float, position: float) -> None:
        """Let the machine move on and the edge advance as far as it closes: but for leaps all can be taken back."""
        before, lost = self.energy(self.radius, start), self.lost
        end, leaps = self.edge.closing.rise(self.radius, np.array([position]))
        if float(end[0]) >= self.edge.closing.places[-1] and self.edge.bed.reach < self.edge.bed.rim:
            raise OutsideValidity(
                f"ViscoelasticAdhesion: at the position {position:.6g} m the contact grows beyond the reach of the "
                f"profile ({self.edge.bed.reach:.6g} m), where nothing is known of it; turn back earlier."
            )
        for leap in leaps:
            loss = self.energy(leap.start, leap.level) - self.energy(leap.end, leap.level)
            if loss < -1e-10 * abs(self.energy(leap.end, leap.level)):
                raise OutsideValidity(
                    f"ViscoelasticAdhesion: at the position {leap.level:.6g} m the edge would have to run uphill "
                    f"to {leap.end:.6g} m: a ring of the body touches there first, and the contact is not a disc."
                )
            self.lost += max(loss, 0.0)
        self.radius = float(end[0])
        self.work += self.energy(self.radius, position) - before + self.lost - lost

    def follow(self, start: float, end: float, duration: float) -> None:
        """Let the machine move steadily from one position to another; at once, the edge has no time."""
        if duration > 0.0 and self.radius > 0.0:
            self._open(start, end, duration)
            start = end
        if end > start or self.radius > 0.0:
            self.close(start, end)

    def _open(self, start: float, end: float, duration: float) -> None:
        """Let the edge recede, until the time is over or the bodies part."""
        first, rate = self.radius, (end - start) / duration
        bed, place = self.edge.bed, np.array([first])
        stretch = float(griffith.stretch(bed, self.law.work, place)[0])
        # the depth follows a soft machine slowly
        yielding = 1.0 + float(bed.stiffness(place)[0]) * self.machine.compliance
        longest = LONGEST_STEP * yielding * stretch / abs(rate) if rate != 0.0 else math.inf
        fastest = INSTANT_SPEED * first / min(longest, duration)
        time, position = 0.0, start
        pace = min(self.pace, longest, duration)
        forces_reached = [(0.0, self.at(first, start)[1])]
        release = self.at(first, start)[2]
        for _ in range(MOST_STEPS):
            at_once = self.radius
            self._run(position, fastest, LEAST_CONTACT * first)
            if self.radius < at_once:
                self._drop(at_once, self.radius, position)
                release = self.at(self.radius, position)[2]
            if time >= duration or self.radius <= LEAST_CONTACT * first:
                break
            left = duration - time
            dt = left if pace >= (1.0 - 1e-9) * left else pace
            done = self._halves(position, rate, dt)
            error = abs(done[0].radius - done[2].radius) / (STEP_TOLERANCE * first) if done else math.inf
            if done is None or error > 1.0:
                pace = dt * max(0.2, 0.9 * error ** (-1.0 / 3.0))
                if pace < TIME_ROUNDING * min(longest, duration):  # nothing holds it: it recedes a little at once
                    at_once, self.radius = self.radius, self.radius * (1.0 - 0.01 * LONGEST_STEP)
                    self._drop(at_once, self.radius, position)
                    release = self.at(self.radius, position)[2]
                    pace = dt
                continue
            one, half, two = done
            before_it, self.radius = self.radius, min(two.radius + (two.radius - one.radius) / 3.0, self.radius)
            self.work += rate * (two.impulse + (two.impulse - one.impulse) / 3.0)
            self.lost += _opened(before_it, half.radius, self.radius, release, half.release, two.release, self.law.work)
            release = two.release
            time = duration if dt == left else time + dt
            position = end if dt == left else start + rate * time
            # how far machine and edge have come
            come = abs(rate) * dt / (yielding * stretch) + (before_it - self.radius) / first
            forces_reached.append((forces_reached[-1][0] + come, two.force))
            pace = min(dt * min(4.0, max(0.3, 0.9 * max(error, 1e-6) ** (-1.0 / 3.0))), longest)
            self.pace = pace
        else:
            raise NotConverged(f"ViscoelasticAdhesion: the edge takes ever shorter steps near {position:.6g} m.")
        if self.radius <= LEAST_CONTACT * first:
            self._drop(self.radius, 0.0, position)
            self.radius = 0.0
        self.lowest = min(self.lowest, _least(*np.array(forces_reached).T))

    def _drop(self, before: float, after: float, position: float) -> None:
        """Note what an edge loses that runs on while the machine does not move."""
        self.lost += max(self.energy(before, position) - self.energy(after, position), 0.0)

    def _run(self, position: float, most: float, least: float) -> None:
        """Let an edge that would be faster than `most` run at once to where it is not, or to the radius `least`."""

        def fast(radius: float) -> bool:
            return not float(self.law.speed(self.at(radius, position)[2])) <= most

        while self.radius > least and fast(self.radius):
            low, high = (1.0 - LONGEST_STEP) * self.radius, self.radius
            if not fast(low):
                while low < 0.5 * (low + high) < high:
                    middle = 0.5 * (low + high)
                    low, high = (low, middle) if fast(middle) else (middle, high)
            self.radius = low

    def _halves(self, position: float, rate: float, dt: float) -> tuple[_CrackState, _CrackState, _CrackState] | None:
        """Return where a step leads, made at once, half of it, and in halves; nothing if it is too long."""
        one = self._step(self.radius, position, rate, dt)
        half = self._step(self.radius, position, rate, 0.5 * dt) if one else None
        two = self._step(half.radius, position + 0.5 * rate * dt, rate, 0.5 * dt) if half else None
        if not (one and half and two):
            return None
        return one, half, two._replace(impulse=half.impulse + two.impulse)

    def _step(self, radius: float, position: float, rate: float, dt: float) -> _CrackState | None:
        """Return where one step leads."""
        first = self._stage(radius, radius, position + STAGE_WEIGHT * rate * dt, STAGE_WEIGHT * dt)
        if first is None:
            return None
        base = radius - (1.0 - STAGE_WEIGHT) / STAGE_WEIGHT * (radius - first.radius)
        second = self._stage(radius, base, position + rate * dt, STAGE_WEIGHT * dt)
        if second is None:
            return None
        return second._replace(impulse=dt * ((1.0 - STAGE_WEIGHT) * first.force + STAGE_WEIGHT * second.force))

    def _stage(self, radius: float, base: float, position: float, dt: float) -> _CrackState | None:
        """Return where the edge is that recedes from `base` for a time at the speed of where it comes to."""
        if base <= (1.0 - LONGEST_STEP) * radius:
            return None
        _, force, most = self.at(base, position)
        if most <= self.law.work:
            return _CrackState(base, most, force, 0.0)
        limit = float(self.law.opening(LONGEST_STEP * radius / dt))
        low, high = self.law.work, min(most, limit)
        f_low = most - low

        def excess(release: float) -> tuple[float, float, float]:
            place = max(base - dt * float(self.law.speed(release)), (1.0 - LONGEST_STEP) * radius)
            _, pull, there = self.at(place, position)
            return there - release, place, pull

        f_high, place, force = excess(high)
        # an edge that has lost its hold is driven by more, the farther it recedes
        while f_high > 0.0:
            if high >= limit:
                return None
            low, f_low, high = high, f_high, min(high + 4.0 * f_high, limit)
            f_high, place, force = excess(high)
        # from where the last stage came to; then the false position, which halves the end that stays (Illinois)
        release, side = high, 0
        trial = self.release if low < self.release < high else low + (high - low) * f_low / (f_low - f_high)
        for _ in range(MOST_TRIALS):
            if f_high == 0.0 or not low < trial < high:
                break
            f, new, force = excess(trial)
            settled = abs(new - place) <= RADIUS_TOLERANCE * radius
            release, place = trial, new
            if f > 0.0:
                low, f_low, f_high, side = trial, f, f_high * (0.5 if side > 0 else 1.0), 1
            else:
                high, f_high, f_low, side = trial, f, f_low * (0.5 if side < 0 else 1.0), -1
            if settled or f == 0.0:
                break
            trial = low + (high - low) * f_low / (f_low - f_high)
        self.release = release
        return _CrackState(place, release, force, 0.0)


def _opened(first: float, half: float, last: float, *releases: float) -> float:
    """Return what opening loses on a path of two halves: what is released beyond the work of closing, over the area.

    `releases` are the energy release rates at the three places, and the work of closing [J/m^2].
    """
    one, middle, two, work = (max(each, releases[3]) for each in releases)
    whole, part = first**2 - last**2, first**2 - half**2
    if not 0.0 < part < whole:
        return 0.5 * math.pi * max(whole, 0.0) * (one + two - 2.0 * work)
    # of the parabola through three places that need not be even
    share = part / whole
    weights = 0.5 - 1.0 / (6.0 * share), 1.0 / (6.0 * share * (1.0 - share)), 0.5 - 1.0 / (6.0 * (1.0 - share))
    return math.pi * whole * max(sum(w * (g - work) for w, g in zip(weights, (one, middle, two), strict=True)), 0.0)


def _least(distance: Array, forces: Array) -> float:
    """Return the lowest of forces along a distance, by the polynomial through the five places about it."""
    i = int(np.argmin(forces))
    if i in (0, forces.size - 1):
        return float(forces[i])
    near = slice(max(i - 2, 0), i + 3)
    x, y = distance[near], forces[near]
    if np.any(np.diff(x) <= 0.0):
        return float(forces[i])
    places = np.linspace(distance[i - 1], distance[i + 1], SAMPLES)
    between = np.zeros(SAMPLES)
    for k in range(x.size):
        others = np.delete(x, k)
        between += y[k] * np.prod((places[:, None] - others) / (x[k] - others), axis=1)
    return float(min(np.min(between), forces[i]))
