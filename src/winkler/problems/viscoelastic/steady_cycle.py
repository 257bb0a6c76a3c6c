r"""A contact of relaxing bodies that is pressed and pushed to and fro for so long that its cycles repeat.

.. math:: d = d_0 + A_z\cos n\omega t ,\qquad U = A_x\cos(m\omega t+\varphi) \quad\text{or}\quad F_x = \dots

The row of `winkler.problems.viscoelastic.tangential` starts at rest at the mean depth and is carried from cycle to
cycle.  A memory that fades over :math:`\tau` is the displacement less its weighted mean, :math:`S = M(u-v)`, and v is
set to the mean of the cycle just followed, to which all cycles like it would lead.  Springs that part or slide change
that mean in turn; every third cycle the last two changes are continued as a geometric series (Aitken).  Neither alters
the cycle that repeats.
"""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Force, ShearForce, Shift
from winkler.loading.path import Path
from winkler.media.relaxing.relaxing_medium import relaxes
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.types import Array
from winkler.problems.method import Method, refuse_method
from winkler.problems.normal.indentation import Indentation
from winkler.problems.row import Reached, follow
from winkler.problems.viscoelastic.layered_drag import DraggedLayers, LayeredDrag, refuse_unknown_waves
from winkler.problems.viscoelastic.layered_path import contact_reach, is_layered
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.tangential import dragged_notes, dragged_row
from winkler.problems.viscoelastic.tangential_march import DraggedRow, DraggedSprings, DragGoal
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing

FINER = 4
"""Steps between two points of a cycle on layers that relax each by a law of its own."""
POINTS = 64
"""Of each oscillation; steps between them are halved on its curve."""
MOST_CYCLES = 300
ENDLESS = 1e6
"""Of the longest relaxation time, after which all has relaxed."""
STEADY_STEPS, LEAST_STEADY = 10.0, 1e-6
"""Part of loss and force by which the last cycles may differ: of the tolerance of a step, and at least."""


class Swing(NamedTuple):
    """A closed cycle.

    Parameters
    ----------
    period
        Of it [s].
    depth, depth_amplitude
        d_0 and A_z [m].
    lateral, amplitude
        What oscillates along the surface, Shift or ShearForce, and how far to each side [m] or [N].
    phase
        By which it is ahead of the depth, in its own cycle [rad].
    normal_cycles, lateral_cycles
        n and m.
    """

    period: float
    depth: float
    depth_amplitude: float
    lateral: type[Shift] | type[ShearForce]
    amplitude: float
    phase: float
    normal_cycles: int = 1
    lateral_cycles: int = 1

    def goal(self, time: float) -> DragGoal:
        """Return what is prescribed at a time."""
        turn = 2.0 * math.pi * time / self.period
        pressed = self.depth_amplitude * math.cos(self.normal_cycles * turn)
        pushed = self.amplitude * math.cos(self.lateral_cycles * turn + self.phase)
        return DragGoal(time, self.depth + pressed, pushed)

    def goals(self) -> list[DragGoal]:
        """Return what is prescribed at points of the cycle: evenly spaced, and where shift or depth turn."""
        n, m = self.normal_cycles, self.lateral_cycles
        even = np.arange(POINTS * max(n, m)) / (POINTS * max(n, m))
        aside = np.mod(np.arange(2 * m) / 2 - self.phase / (2.0 * np.pi), m) / m
        turns = np.unique(np.concatenate([even, np.arange(2 * n) / (2 * n), aside]))
        apart = np.append(True, np.diff(turns) > 1e-9)
        return [self.goal(self.period * turn) for turn in (*turns[apart].tolist(), 1.0)]


class SteadyCycle(NamedTuple):
    """One cycle of those that repeat.

    Parameters
    ----------
    shift, shear_force
        U [m] and F_x [N] at the points of the cycle.
    friction, bulk, pressing
        Lost to friction and in the bodies, and what of that the depth alone costs [J].
    change
        Part of loss or force by which the cycle differs from the one before [-].
    ring
        Whether the contact is no disc anywhere in it.
    contact
        Where it is deepest; its work and dissipation are those of pressing, in a cycle.
    stuck
        Stiffness without slip: the modulus of the complex one [N/m].
    """

    shift: Array
    shear_force: Array
    friction: float
    bulk: float
    pressing: float
    change: float
    ring: bool
    contact: ViscoelasticState
    stuck: float

    @property
    def loss(self) -> float:
        """Lost in all [J]."""
        return self.friction + self.bulk

    def apart(self, other: SteadyCycle) -> float:
        """Return the part of loss or force by which another cycle differs."""
        whole = self.loss
        pairs = [(self.friction, other.friction, whole), (self.bulk, other.bulk, whole)]
        for mine, its in ((self.shift, other.shift), (self.shear_force, other.shear_force)):
            pairs.append((float(np.ptp(mine)), float(np.ptp(its)), float(np.ptp(mine))))
        return max(abs(mine - its) / over if over > 0.0 else 0.0 for mine, its, over in pairs)


def check_cycles(owner: str, bed: Bed, frequency: float, method: Method) -> None:
    """Refuse a frequency of bodies that do not relax; of those that do, its lack, and what lets no cycle repeat.

    Raises
    ------
    InvalidInput
        Also if the springs do not relax by one function of time.
    """
    if not relaxes(bed.medium):
        if frequency > 0.0:
            raise InvalidInput(
                f"{owner}: the frequency is {frequency:.6g} Hz, but the bodies do not relax, and a cycle loses as much "
                "at each frequency; leave it out, or give a medium that relaxes, such as ViscoelasticHalfSpace."
            )
        return
    refuse_method(owner, method, (Method.AUTO, Method.SPRINGS))
    layered = is_layered(owner, bed)
    if layered:
        refuse_unknown_waves(bed, twisted=False)
    if frequency == 0.0:
        raise InvalidInput(
            f"{owner}: the bodies relax, so that the loss of a cycle depends on how long it lasts; give the frequency "
            "in Hz."
        )
    series = None if layered else relaxation_of(owner, bed)
    if series and (series.relaxed == 0.0 or series.viscosity > 0.0):
        what = (
            "the body creeps without limit and carries no steady load, so that no cycle repeats"
            if series.relaxed == 0.0
            else "a dashpot alongside has forces that jump wherever a spring begins to slide"
        )
        raise InvalidInput(
            f"{owner}: {what}; give a solid with a positive relaxed modulus and without a dashpot alongside, such as "
            "StandardSolid or Prony."
        )


def depth_at_rest(bed: Bed, normal: Depth | Force) -> float:
    """Return the depth after all time under a steady normal load [m]."""
    if isinstance(normal, Depth):
        return float(normal.depth)
    relaxed = 1.0 if is_layered("", bed) else relaxation_of("", bed).relaxed
    return float(Indentation(elastic_like(bed), Force(float(normal.force) / relaxed)).solve().depth)


def steady_cycle(owner: str, bed: Bed, law: Coulomb, swing: Swing, count: int, tolerance: float) -> SteadyCycle:
    """Return the cycle that repeats.

    Parameters
    ----------
    owner : str
        Kind of problem.
    bed : Bed
        On a medium that relaxes.
    law : Coulomb
    swing : Swing
    count, tolerance
        As of `winkler.problems.viscoelastic.tangential.dragged`.

    Raises
    ------
    OutsideValidity
        If the bed is pressed beyond what is known of it.
    NotConverged
        If a step does not settle, or the cycles do not repeat.
    """
    if is_layered(owner, bed):
        return _layered_cycle(owner, bed, law, swing, count, tolerance)
    goals, period = swing.goals(), swing.period
    deepest = np.full(2, swing.depth + swing.depth_amplitude)
    path = Path(np.array([0.0, period]), Depth(deepest), swing.lateral(np.full(2, swing.amplitude)))
    row = dragged_row(owner, bed, law, path, count, tolerance, swing.goal)
    row.owner = owner
    state, last = _at_rest(row, goals[0], swing), None
    settling = Settling(tolerance)
    for turn in range(MOST_CYCLES):
        start = state
        state, cycle = _through(row, bed, goals, start)
        settled = settling.settled(cycle)
        if settled:
            if settled.ring:
                raise OutsideValidity(
                    f"{owner}: the body touches around a dent that does not recover within a cycle, so the "
                    "contact is not a disc; give a smaller amplitude of the depth, or a lower frequency."
                )
            return settled
        state = _averaged(row, start, state, period)
        change = [two - one for one, two in zip(_memories(start), _memories(state), strict=True)]
        if turn % 3 == 2 and last is not None:
            state = _ahead(row, state, last, change, period)
        last = change
    raise settling.failed(owner)


class Settling:
    """Whether cycles repeat: twice less than allowed may be left of the geometric series of their changes."""

    def __init__(self, tolerance: float) -> None:
        self.allowed, self.small, self.error = max(STEADY_STEPS * tolerance, LEAST_STEADY), 0, math.inf
        self.last: SteadyCycle | None = None

    def settled(self, cycle: SteadyCycle) -> SteadyCycle | None:
        """Take the next cycle, and return it if it repeats."""
        if self.last is not None:
            previous, self.error = self.error, cycle.apart(self.last)
            cycle = cycle._replace(change=self.error)
            falls = min(self.error / previous, 0.99) if 0.0 < previous < math.inf else 0.5
            self.small = self.small + 1 if self.error * max(1.0, falls / (1.0 - falls)) <= self.allowed else 0
        self.last = cycle
        return cycle if self.small == 2 else None

    def failed(self, owner: str) -> NotConverged:
        """Return the error of cycles that do not repeat."""
        return NotConverged(
            f"{owner}: after {MOST_CYCLES} cycles loss and forces still change by {self.error:.2g} from one to the "
            "next; give a solid whose glassy modulus is less far above the relaxed one, or a lower frequency."
        )


def _layered_cycle(owner: str, bed: Bed, law: Coulomb, swing: Swing, count: int, tolerance: float) -> SteadyCycle:
    """Return the cycle that repeats on layers that relax each by a law of its own, as of `steady_cycle`.

    After every cycle what cells remember is mixed with what they did.
    """
    reach = contact_reach(owner, bed, Depth(0.0), swing.depth + swing.depth_amplitude)
    row = LayeredDrag(owner, bed, law.coefficient, twisted=False, reach=reach, count=count, tolerance=tolerance)
    by_force, goals, period = swing.lateral is ShearForce, swing.goals(), swing.period
    longest = ENDLESS * max(float(row.cells.times[-1]), float(row.along.times[-1]), period)
    state = row.begin(-2.0 * longest)

    def go(state: DraggedLayers, time: float, goal: DragGoal) -> DraggedLayers:
        point = row.march.go(time, Depth(0.0), state.pressed.state.depth, goal.across)
        return row.pushed(state, point, time - state.pressed.time, goal.along, by_force=by_force)

    for time in (-2.0 * longest, -longest, -period):
        state = go(state, time, DragGoal(time, swing.depth, 0.0))
    for share in np.arange(1, FINER + 1) / FINER:
        time = -period * (1.0 - share)
        at = DragGoal(time, swing.depth + share * swing.depth_amplitude, share * goals[0].along)
        state = go(state, time, at)
    settling, mixing = Settling(tolerance), Mixing()
    for _ in range(MOST_CYCLES):
        row.march.time = goals[0].time
        pressed = state.pressed._replace(time=goals[0].time)
        start = state = state._replace(pressed=pressed, friction=0.0, bulk=0.0)
        shift, force, lost = [state.motion], [state.load], row.march.lost
        for before, goal in itertools.pairwise(goals):
            for share in np.arange(1, FINER + 1) / FINER:
                time = before.time + share * (goal.time - before.time)
                state = go(state, time, goal if share == 1.0 else swing.goal(time))
            shift.append(state.motion)
            force.append(state.load)
        point, pressing = state.pressed, row.march.lost - lost
        numbers = (*point.numbers()[:4], pressing, point.stored, pressing)
        contact = ViscoelasticState(*numbers, bed, row.place, point.state.load, row.cells.displacement(point.state))
        stuck = abs(row.stiffness(point.state.held, 2.0 * math.pi / period))
        cycle = SteadyCycle(
            np.array(shift), np.array(force), state.friction, state.bulk + pressing, pressing, math.inf, False, contact,
            stuck,
        )  # fmt: skip
        settled = settling.settled(cycle)
        if settled:
            return settled
        state = _with_kept(state, mixing.next(_kept(start), _kept(state)))
        row.march.state = state.pressed.state
    raise settling.failed(owner)


KEPT = 4
"""Cycles of which differences are mixed."""


class Mixing:
    """Fixed points of a map of rows, by Anderson's mixing: what is left is made least over the last few differences."""

    def __init__(self) -> None:
        self.scales: Array = np.empty(0)
        self.starts: list[Array] = []
        self.ends: list[Array] = []

    def next(self, start: list[Array], end: list[Array]) -> list[Array]:
        """Return rows to go on from, after some have become others."""
        if not self.starts:
            self.scales = np.array([max(float(np.max(np.abs(row))), 1e-300) for row in end])
        shapes = [row.shape for row in end]
        one, two = (
            np.concatenate([(row / scale).ravel() for row, scale in zip(rows, self.scales, strict=True)])
            for rows in (start, end)
        )
        self.starts, self.ends = [*self.starts[-KEPT:], one], [*self.ends[-KEPT:], two]
        left = np.array(self.ends) - np.array(self.starts)
        if len(left) > 1:
            share = np.linalg.lstsq(np.diff(left, axis=0).T, left[-1], rcond=1e-10)[0]
            two = two - np.diff(np.array(self.ends), axis=0).T @ share
        ends = np.cumsum([math.prod(shape) for shape in shapes])[:-1]
        parts = zip(np.split(two, ends), shapes, self.scales, strict=True)
        return [scale * part.reshape(shape) for part, shape, scale in parts]


def _kept(state: DraggedLayers) -> list[Array]:
    """Return all that cells bring into the next cycle."""
    both = state.pressed.state, state.dragged
    return [state.ahead, *(row for cells in both for row in (cells.load, cells.waves, cells.memory))]


def _with_kept(state: DraggedLayers, rows: list[Array]) -> DraggedLayers:
    """Return cells that bring other rows."""
    ahead, *rest = rows
    both = state.pressed.state, state.dragged
    pressed, dragged = (
        cells._replace(load=part[0], waves=part[1], memory=part[2])
        for cells, part in zip(both, (rest[:3], rest[3:]), strict=True)
    )
    return state._replace(ahead=ahead, pressed=state.pressed._replace(state=pressed), dragged=dragged)


def _at_rest(row: DraggedRow, first: DragGoal, swing: Swing) -> DraggedSprings:
    """Return the springs after all time at the mean depth, and then moved to the first point of a cycle."""
    times = np.concatenate([1.0 / row.recovery.rates, row.shear.times, row.row.series.times, [swing.period]])
    while_ = ENDLESS * float(np.max(times))
    state = row.begin(DragGoal(-3.0 * while_, min(swing.depth, 0.0), 0.0)).state
    for time in (-2.0 * while_, -while_):
        state = row.step(state, DragGoal(time, swing.depth, 0.0)).state
    return row.step(state._replace(goal=DragGoal(-swing.period, swing.depth, 0.0)), first).state


def _through(
    row: DraggedRow, bed: Bed, goals: list[DragGoal], state: DraggedSprings
) -> tuple[DraggedSprings, SteadyCycle]:
    """Return the springs after a cycle, and the cycle."""
    start = state._replace(goal=goals[0], friction=0.0, bulk=0.0, pressing=0.0)
    reached = [Reached(start, 0.0, 0.0)]
    reached.extend(follow(row, goals[1:], (0, goals[0], reached[0])))
    states = [point.state for point in reached]
    end, springs = states[-1], row.row.springs
    contact = ViscoelasticState(
        time=goals[-1].time,
        depth=end.row.depth,
        force=end.force,
        radius=end.radius,
        work=end.pressing,
        stored_energy=float(end.row.copy().march(np.zeros(1), np.zeros(1)).stored[0]),
        dissipation=end.pressing,
        bed=bed,
        position=springs.position,
        line_load=springs.density(row.row.bed) * end.row.loads(),
        recess=end.row.place,
    )
    quick = abs(complex(row.shear.dynamic(np.array(2.0 * math.pi / goals[-1].time))))
    found = SteadyCycle(
        np.array([each.shift for each in states]),
        np.array([each.shear_force for each in states]),
        end.friction,
        end.bulk,
        end.pressing,
        math.inf,
        any(each.ring for each in states),
        contact,
        quick * float(np.sum(row.cells.weights)),
    )
    return end, found


def _memories(state: DraggedSprings) -> tuple[Array, Array]:
    """Return what springs remember, a line each: across the surface, and along it with where they are."""
    return state.row.memory.T, np.column_stack([state.memory, state.displaced])


def _averaged(row: DraggedRow, start: DraggedSprings, end: DraggedSprings, period: float) -> DraggedSprings:
    """Return the end of a cycle with the memories to which cycles like this one would lead."""
    across, memory = end.row.copy(), end.memory.copy()

    def average(series: RelaxationSeries, now: Array, then: Array, moved: Array) -> None:
        terms = series.times.size
        fading = np.exp(-period / series.times) / -np.expm1(-period / series.times)
        now[:, :terms] += (now[:, :terms] - then[:, :terms] - series.moduli * moved[:, None]) * fading

    average(row.row.series, across.memory.T, start.row.memory.T, across.place - start.row.place)
    average(row.shear, memory, start.memory, end.displaced - start.displaced)
    return end._replace(row=across, memory=memory)


def _ahead(
    row: DraggedRow, state: DraggedSprings, last: list[Array], changes: list[Array], period: float
) -> DraggedSprings:
    """Return the springs with their last two changes continued, each spring by its own ratio."""
    found = []
    pairs = zip((row.row.series, row.shear), _memories(state), last, changes, strict=True)
    for series, memory, one, two in pairs:
        # a free spring forgets more slowly than a pressed one, by the ratio of its moduli
        most = 1.0 - series.relaxed / abs(complex(series.dynamic(np.array(2.0 * math.pi / period))))
        whole = np.sum(one * one, axis=1)
        ratio = np.divide(np.sum(one * two, axis=1), whole, out=np.zeros(whole.size), where=whole > 0.0)
        ratio = np.clip(ratio, 0.0, most)
        found.append(memory + two * (ratio / (1.0 - ratio))[:, None])
    across = state.row.copy()
    across.memory[...] = found[0].T
    return state._replace(row=across, memory=found[1][:, :-1].copy(), displaced=found[1][:, -1].copy())


def swing_notes(bed: Bed, law: Coulomb, period: float, contact: ViscoelasticState) -> tuple[Note, ...]:
    """Return how far cycles that repeat can be trusted.

    Parameters
    ----------
    bed : Bed
    law : Coulomb
    period : float
        [s].
    contact : ViscoelasticState
        Where it is deepest.
    """
    repeats = Note(
        Assumption.STEADY,
        Standing.ASYMPTOTIC,
        "The springs were followed from cycle to cycle until dissipated energy and forces repeated. "
        "`cycle_change` is the relative difference of the last two cycles.",
        "hereditary springs followed from cycle to cycle",
    )
    slow = Note(
        Assumption.INERTIA,
        Standing.ASYMPTOTIC,
        "The motion is slow: inertia and waves in the bodies are neglected.",
        "quasi-static contact",
    )
    time, depth, radius = (
        np.array([0.0, period / POINTS, period]),
        np.array([contact.depth]),
        np.array([contact.radius]),
    )
    return (repeats, slow, *dragged_notes(bed, law, time, depth, radius))
