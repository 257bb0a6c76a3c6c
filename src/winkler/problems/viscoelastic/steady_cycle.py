r"""A contact of relaxing bodies that is pressed and pushed to and fro for so long that its cycles repeat.

.. math:: d = d_0 + A_z\cos n\omega t ,\qquad U = A_x\cos(m\omega t+\varphi) \quad\text{or}\quad F_x = \dots

The row of `winkler.problems.viscoelastic.tangential` starts at rest at the mean depth and is carried from cycle to
cycle.  A memory that fades over :math:`\tau` is the displacement less its weighted mean, :math:`S = M(u-v)`, and v is
set to the mean of the cycle just followed, to which all cycles like it would lead.  Springs that part or slide change
that mean in turn; every third cycle the last two changes are continued as a geometric series (Aitken).  Neither alters
the cycle that repeats.
"""

from __future__ import annotations

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
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.tangential import dragged_notes, dragged_row
from winkler.problems.viscoelastic.tangential_march import DraggedRow, DraggedSprings, DragGoal
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["SteadyCycle", "Swing", "check_cycles", "depth_at_rest", "steady_cycle", "swing_notes"]

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
    series = relaxation_of(owner, bed)
    if frequency == 0.0:
        raise InvalidInput(
            f"{owner}: the bodies relax, so that the loss of a cycle depends on how long it lasts; give the frequency "
            "in Hz."
        )
    if series.relaxed == 0.0 or series.viscosity > 0.0:
        what = (
            "the body flows for ever and bears no steady load, so that no cycle repeats"
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
    relaxed = Force(float(normal.force) / relaxation_of("", bed).relaxed)
    return float(Indentation(elastic_like(bed), relaxed).solve().depth)


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
    goals, period = swing.goals(), swing.period
    deepest = np.full(2, swing.depth + swing.depth_amplitude)
    path = Path(np.array([0.0, period]), Depth(deepest), swing.lateral(np.full(2, swing.amplitude)))
    row = dragged_row(owner, bed, law, path, count, tolerance, swing.goal)
    row.owner = owner
    state, before, last = _at_rest(row, goals[0], swing), None, None
    allowed, small, error = max(STEADY_STEPS * tolerance, LEAST_STEADY), 0, math.inf
    for turn in range(MOST_CYCLES):
        start = state
        state, cycle = _through(row, bed, goals, start)
        if before is not None:
            previous, error = error, cycle.apart(before)
            cycle = cycle._replace(change=error)
            # what is left of a geometric series
            falls = min(error / previous, 0.99) if 0.0 < previous < math.inf else 0.5
            small = small + 1 if error * max(1.0, falls / (1.0 - falls)) <= allowed else 0
            if small == 2:
                if cycle.ring:
                    raise OutsideValidity(
                        f"{owner}: the body touches around a dent that does not recover within a cycle, so the "
                        "contact is not a disc; give a smaller amplitude of the depth, or a lower frequency."
                    )
                return cycle
        before = cycle
        state = _averaged(row, start, state, period)
        change = [two - one for one, two in zip(_memories(start), _memories(state), strict=True)]
        if turn % 3 == 2 and last is not None:
            state = _ahead(row, state, last, change, period)
        last = change
    raise NotConverged(
        f"{owner}: after {MOST_CYCLES} cycles loss and forces still change by {error:.2g} from one to the next; give a "
        "solid whose glassy modulus is less far above the relaxed one, or a lower frequency."
    )


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
