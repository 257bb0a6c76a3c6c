"""Springs distinguished by their gap as a row, of a contact that is pressed and moved in one direction.

A step that is straight in depth and shift is one move of `SlipMemory`, however long.  Where a prescribed force bends
it, it is halved until the halves bring the springs to where the whole did (`winkler.problems.row`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple, TypeVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.slip_sums import SlipSums
from winkler.problems.friction.steady_gaps import GapPlays, turned_memories
from winkler.problems.friction.straight_step import LEAST_DEPTH
from winkler.problems.normal.force_curve import NormalCurves
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.ring_slip.steady_path import steady_history
from winkler.problems.row import CURVED_STEP_TOLERANCE, Reached, Row, follow, over
from winkler.values.errors import NotConverged, OutsideValidity

__all__ = ["PressedRow", "SlipGoal", "SlipRow", "SlipState", "refuse_shear"]

MANY = 20
"""Points of a path from which on its turning points take less time than its steps."""
UNTOUCHED_DEPTH = 1e-9
"""Depth [m] to which the normal curve is made for bodies that never touch, and never evaluated."""
SLIDING_TOLERANCE = 1e-12
"""A shear force beyond what friction bears by no more than this part of it is that of sliding."""
FORCE_TOLERANCE = 4e-15
"""A shear force is met to this part of what friction bears."""
MOST_NEWTON_STEPS = 200
"""Steps of Newton's method, halving where that leads astray."""


State = TypeVar("State")


class SlipGoal(NamedTuple):
    """What is prescribed at a moment: d [m] with F_N [N], and U [m] or F_x [N], in the plane ``(2,)``."""

    depth: float
    force: float
    along: Any


class PressedRow(Row[SlipGoal, State]):
    """Springs under a path of depths or normal forces, and of shifts or shear forces.

    Parameters
    ----------
    path : Path
    """

    order: int | None = 2
    curves, bends = True, False
    """Whether steps are halved where a prescribed force bends them; whether a shear force bends them in itself."""

    def __init__(self, path: Path) -> None:
        self.greatest = float(np.max(np.abs(path.along)))
        self.driven, self.pressed = isinstance(path.lateral, Shift), isinstance(path.normal, Depth)

    def _allow(self, stiffness: float, most: float) -> None:
        """Set what counts as little, from the stiffness without slip [N/m] and the greatest bound of a spring [m]."""
        size = min(most, self.greatest if self.driven or stiffness == 0.0 else self.greatest / stiffness)
        self.allowed = CURVED_STEP_TOLERANCE * size, CURVED_STEP_TOLERANCE * stiffness * size**2

    @property
    def _unbent(self) -> bool:
        """Whether no step is ever bent."""
        return not self.curves or (self.driven and self.pressed)

    def _straight(self, steady: Any, same: Any) -> Any:
        """Return whether steps are straight, under a steady depth or not, to the same load along the surface or not."""
        # with no change of shift it does not matter when the depth changes
        return (steady & (self.driven or not self.bends)) | ((steady | self.driven) & same)

    def force_at(self, depth: float) -> float:
        """Return the normal force at a depth [N]."""
        raise NotImplementedError

    def halfway(self, state: State, start: SlipGoal, goal: SlipGoal) -> SlipGoal | None:
        """Return what is prescribed at the middle of the depths."""
        steady = start.depth == goal.depth
        if self._unbent or self._straight(steady, np.all(start.along == goal.along)):
            return None
        depth, force, share = 0.5 * (start.depth + goal.depth), start.force, 0.5
        if not (self.pressed or steady):
            force = self.force_at(depth)
            share = min(max((force - start.force) / (goal.force - start.force), 0.0), 1.0)
        return SlipGoal(depth, force, start.along + (goal.along - start.along) * share)


def refuse_shear(shear: float, most: float) -> None:
    """Refuse a shear force [N] where friction bears less [N]."""
    raise OutsideValidity(
        f"a shear force of {shear:.6g} N is prescribed, but the friction limit is {most:.6g} N, and the bodies "
        "would slide away; give a smaller one, or a Shift."
    )


class SlipState(NamedTuple):
    """What the springs remember, and the shift [m]."""

    memory: SlipMemory
    shift: float


class PathPoint(NamedTuple):
    """A point of a path: shift [m], shear force [N], energies [J], and what the springs remember."""

    shift: float
    shear_force: float
    work: float
    stored: float
    lost: float
    memory: SlipMemory


class SlipRow(PressedRow[SlipState]):
    """The springs under a path.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    ratio : float
        c_T/c_N [-] of every spring.
    path : Path
    contact : IndentationSolution
        The contact without friction at every point of the path.
    """

    owner = "Tangential"

    def __init__(self, bed: Bed, coefficient: float, ratio: float, path: Path, contact: IndentationSolution) -> None:
        self.coefficient, self.ratio, self.beta = coefficient, ratio, coefficient / ratio
        pressed = (np.atleast_1d(quantity).tolist() for quantity in (contact.depth, contact.force, path.along))
        super().__init__(path)
        self.goals = [SlipGoal(*goal) for goal in zip(*pressed, strict=True)]
        deepest = max(0.0, *(goal.depth for goal in self.goals))
        self._curves = NormalCurves(bed, deepest if deepest > 0.0 else UNTOUCHED_DEPTH)
        depths = np.atleast_1d(contact.depth)
        self.sums = SlipSums(self._curves, self._curves.many(depths) if deepest > 0.0 and depths.size >= MANY else None)
        stiffness, _, _ = self.sums.at(deepest)
        self._allow(ratio * stiffness, self.beta * deepest if deepest > 0.0 else 0.0)

    def points(self) -> Iterator[PathPoint]:
        """Yield the springs at every point of the path, many of them under a steady depth all at once.

        Raises
        ------
        OutsideValidity, NotConverged
            As `step`.
        """
        goals, depth = self.goals, self.goals[0].depth
        reached = None
        steady = len(goals) >= MANY and all(goal.depth == depth for goal in goals)
        if steady and depth >= LEAST_DEPTH and 0.0 < self.beta < math.inf:
            for index, point in enumerate(self._turned(depth)):
                yield point
                reached = index, goals[index], Reached(SlipState(point.memory, point.shift), point.work, point.lost)
        # what friction does not bear is refused, at its step
        for (memory, shift), work, lost in follow(self, goals[reached[0] + 1 if reached else 0 :], reached):
            yield PathPoint(shift, self.shear_force(memory), work, self.stored(memory), lost, memory)

    def _turned(self, depth: float) -> Iterator[PathPoint]:
        """Yield the points of a path under a steady depth, as far as friction bears what is prescribed."""
        along = [goal.along for goal in self.goals]
        springs = GapPlays(self._curves.greatest(), depth, self.beta, self.ratio)
        if not self.driven:
            most = self.coefficient * self.sums.at(depth)[1]
            allowed = most * (1.0 + SLIDING_TOLERANCE)
            borne = next((i for i, force in enumerate(along) if abs(force) > allowed), len(along))
            slides, limit = most * (1.0 - FORCE_TOLERANCE), 2.0 * float(springs.whole[1])
            along = [2.0 * f if abs(f) < slides else math.copysign(limit, f) for f in along[:borne]]
        history = steady_history(springs, along, not self.driven)
        shift = along if self.driven else history.motion.tolist()
        halves = (0.5 * each for each in (history.load, history.stored))
        load, stored = (each.tolist() for each in halves)
        rows = zip(shift, load, history.work.tolist(), stored, history.lost.tolist(), strict=True)
        for row, memory in zip(rows, turned_memories(depth, self.beta, history), strict=True):
            yield PathPoint(*row, memory)

    def begin(self, goal: SlipGoal) -> Reached[SlipState]:
        """Return the springs pressed straight down, and moved after."""
        memory = SlipMemory.fresh().moved(goal.depth, 0.0, self.beta).memory
        return self.step(SlipState(memory, 0.0), goal)

    def step(self, state: SlipState, goal: SlipGoal) -> Reached[SlipState]:
        """Return the springs after a step that is straight in depth and shift, to a shift or to a shear force."""
        change = goal.along - state.shift if self.driven else self._change(state.memory, goal.depth, goal.along)
        memory, lost, work = state.memory.moved(goal.depth, change, self.beta, self.sums)
        shift = goal.along if self.driven else state.shift + change
        return Reached(SlipState(memory, shift), self.ratio * work, max(self.ratio * lost, 0.0))

    def force_at(self, depth: float) -> float:
        """Return as `PressedRow.force_at`."""
        return self.sums.at(depth)[1]

    def apart(self, one: Reached[SlipState], two: Reached[SlipState]) -> float:
        """Return by how much displacements and energies differ, over a small part of those on the path."""
        (here, shift), (there, other) = one.state, two.state
        near, cheap = self.allowed
        # springs that all slide in the end forget how they came there, what it has cost does not
        return max(over(max(here.apart(there), abs(shift - other)), near), over(abs(one.lost - two.lost), cheap))

    def shear_force(self, memory: SlipMemory) -> float:
        """Return F_x [N]."""
        return self.ratio * self.sums.shear(memory)

    def stored(self, memory: SlipMemory) -> float:
        """Return the energy stored in the springs' displacement along the surface [J]."""
        return self.ratio * self.sums.stored(memory)

    def _change(self, memory: SlipMemory, depth: float, target: float) -> float:
        """Return the shift that brings a shear force about; the smallest if all slides."""
        force = self.sums.at(depth)[1] if depth > 0.0 else 0.0
        most = self.coefficient * force if force > 0.0 else 0.0
        if abs(target) > most * (1.0 + SLIDING_TOLERANCE):
            refuse_shear(abs(target), most)
        if depth <= 0.0:
            return 0.0
        change, slope, short = 0.0, 0.0, 0.0

        def look(at: float) -> tuple[float, float]:
            after = memory.moved(depth, at, self.beta).memory
            return target - self.ratio * self.sums.shear(after), self.ratio * self.sums.stiffness(after, memory.depth)

        short, slope = look(0.0)
        if depth == memory.depth:  # what slid before sticks when it turns: at first no step is too long
            slope = self.ratio * self.sums.at(depth)[0]
        if math.isinf(self.beta):
            return short / slope
        if abs(target) >= most * (1.0 - FORCE_TOLERANCE):
            return math.copysign(self._until_all_slide(memory, depth, math.copysign(1.0, target)), target)
        # no spring is displaced by more than its bound
        end = 2.0 * self.beta * (max(depth, abs(depth - memory.depth)) + max(memory.depth, 0.0))
        low, high = -end, end
        for _ in range(MOST_NEWTON_STEPS):
            if abs(short) <= FORCE_TOLERANCE * most or high - low <= FORCE_TOLERANCE * end:
                return change
            low, high = (change, high) if short > 0.0 else (low, change)
            following = change + short / slope if slope > 0.0 else math.inf
            change = following if low < following < high else 0.5 * (low + high)
            short, slope = look(change)
        raise NotConverged(f"a shear force of {target:.6g} N is missed by {abs(short):.3g} N; give more points.")

    def _until_all_slide(self, memory: SlipMemory, depth: float, side: float) -> float:
        """Return how far the bodies move until every spring slides to a side [m]."""
        # what a spring lacks to its bound falls with its gap: the one on the axis is the last, or those that come
        return max(self.beta * depth - side * memory.on_axis, self.beta * (depth - memory.depth), 0.0)
