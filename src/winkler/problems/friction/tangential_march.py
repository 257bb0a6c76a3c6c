"""The march of a contact that is pressed and moved in one direction, its springs distinguished by their gap.

A step that is straight in depth and shift is one move of `SlipMemory`, however long.  Where a prescribed force bends
it, it is halved until the halves bring the springs to where the whole did.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.loading import Depth, Shift
from winkler.path import Path
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.slip_sums import SlipSums
from winkler.problems.normal.force_curve import normal_curve
from winkler.problems.normal.indentation import IndentationSolution

__all__ = ["CURVED_STEP_TOLERANCE", "SlipPath", "SlipPoint"]

CURVED_STEP_TOLERANCE = 3e-5
"""Curved steps are halved until springs and loss end elsewhere by less than this part of the greatest there are."""
UNTOUCHED_DEPTH = 1e-9
"""Depth [m] to which the normal curve is made for bodies that never touch, and never evaluated."""
SHORTEST_STEP = 2.0**-40
"""Part of a step that is no longer halved."""
SLIDING_TOLERANCE = 1e-12
"""A shear force beyond what friction bears by no more than this part of it is that of sliding."""
FORCE_TOLERANCE = 4e-15
"""A shear force is met to this part of what friction bears."""
MOST_NEWTON_STEPS = 200
"""Steps of Newton's method, halving where that leads astray."""


class SlipPoint(NamedTuple):
    """The end of a step.

    Parameters
    ----------
    memory : SlipMemory
        What the springs remember.
    shift, shear_force : float
        U [m], F_x [N].
    lost, spent : float
        Energy lost on the path, and work of the bodies [J].
    """

    memory: SlipMemory
    shift: float
    shear_force: float
    lost: float
    spent: float


class SlipPath:
    """The steps between the points of a path.

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

    def __init__(self, bed: Bed, coefficient: float, ratio: float, path: Path, contact: IndentationSolution) -> None:
        self.coefficient, self.ratio, self.beta = coefficient, ratio, coefficient / ratio
        self.depths: list[float] = np.atleast_1d(contact.depth).tolist()
        self.forces: list[float] = np.atleast_1d(contact.force).tolist()
        self.along: list[float] = path.along.tolist()
        self.driven = isinstance(path.lateral, Shift)
        self.pressed = isinstance(path.normal, Depth)
        deepest = max(*self.depths, 0.0)
        self.sums = SlipSums(normal_curve(bed, deepest if deepest > 0.0 else UNTOUCHED_DEPTH))
        stiffness, _, _ = self.sums.at(deepest)
        greatest = float(np.max(np.abs(path.along)))
        size = greatest if self.driven or stiffness == 0.0 else greatest / (ratio * stiffness)
        size = min(self.beta * deepest, size) if deepest > 0.0 else 0.0
        self.allowed = CURVED_STEP_TOLERANCE * size, CURVED_STEP_TOLERANCE * ratio * stiffness * size**2

    def points_reached(self) -> Iterator[SlipPoint]:
        """Yield the end of every step, the first one pressed straight down and moved after."""
        memory, _ = SlipMemory.fresh().moved(self.depths[0], 0.0, self.beta)
        here = self._leap(0, SlipPoint(memory, 0.0, 0.0, 0.0, 0.0), self.depths[0], self.along[0])
        yield here
        for index in range(1, len(self.depths)):
            here = self._go(index, here._replace(lost=0.0, spent=0.0))
            yield here

    def stored(self, memory: SlipMemory) -> float:
        """Return the energy stored in the springs' displacement along the surface [J]."""
        return self.ratio * self.sums.stored(memory)

    def _go(self, index: int, start: SlipPoint) -> SlipPoint:
        """Go to a point of the path."""
        (before, after), (first, last) = self.depths[index - 1 : index + 1], self.along[index - 1 : index + 1]
        # with no change of shift it does not matter when the depth changes
        if before == after or (self.driven and (self.pressed or first == last)):
            return self._leap(index, start, after, last)
        forces = self.forces[index - 1 : index + 1]

        def place(share: float) -> tuple[float, float]:
            """Return the depth at a part of the step, and what is prescribed along the surface then."""
            depth = before + (after - before) * share
            if self.pressed:
                return depth, first + (last - first) * share
            time = (self.sums.at(depth)[1] - forces[0]) / (forces[1] - forces[0])
            return depth, first + (last - first) * min(max(time, 0.0), 1.0)

        ends = {0.0: (before, first), 1.0: (after, last)}
        here, done = start, 0.0
        goals = [1.0]
        while goals:
            goal = goals[-1]
            middle = 0.5 * (done + goal)
            whole = self._leap(index, here, *ends[goal])
            half = self._leap(index, here, *place(middle))
            two = self._leap(index, half, *ends[goal])
            if goal - done <= SHORTEST_STEP or self._alike(whole, two):
                # the loss of pieces falls short with the square of their length: the two extrapolate to that of the
                # curved step
                lost = max(two.lost + (two.lost - whole.lost) / 3.0, here.lost)
                spent = two.spent + (two.spent - whole.spent) / 3.0
                here, done = two._replace(lost=lost, spent=spent), goals.pop()
            else:
                ends[middle] = place(middle)
                goals.append(middle)
        return here

    def _alike(self, one: SlipPoint, two: SlipPoint) -> bool:
        """Return whether two end states are the same but for a small part of displacements and energies on the path."""
        apart = one.memory.apart(two.memory)
        # springs that all slide in the end forget how they came there, what it has cost does not
        near, cheap = self.allowed
        return max(apart, abs(one.shift - two.shift)) <= near and abs(one.lost - two.lost) <= cheap

    def _leap(self, index: int, start: SlipPoint, depth: float, target: float) -> SlipPoint:
        """Go straight in depth and shift, to a shift or to a shear force."""
        change = target - start.shift if self.driven else self._change(index, start.memory, depth, target)
        step = start.memory.worked(depth, change, self.beta)
        shift = target if self.driven else start.shift + change
        lost = max(self.ratio * self.sums.lost(step.losses), 0.0)
        spent = self.ratio * self.sums.spent(step, change)
        force = self.ratio * self.sums.shear(step.memory)
        return SlipPoint(step.memory, shift, force, start.lost + lost, start.spent + spent)

    def _change(self, index: int, memory: SlipMemory, depth: float, target: float) -> float:
        """Return the shift that brings a shear force about; the smallest if all slides."""
        force = self.sums.at(depth)[1] if depth > 0.0 else 0.0
        most = self.coefficient * force if force > 0.0 else 0.0
        if abs(target) > most * (1.0 + SLIDING_TOLERANCE):
            raise OutsideValidity(
                f"Tangential: at index {index} of the path a shear force of {target:.6g} N is prescribed where "
                f"friction bears {most:.6g} N at most, and the bodies would slide away; give a smaller one, or a Shift."
            )
        if depth <= 0.0:
            return 0.0
        change, slope, short = 0.0, 0.0, 0.0

        def look(at: float) -> tuple[float, float]:
            after, _ = memory.moved(depth, at, self.beta)
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
        raise NotConverged(
            f"Tangential: the shear force at index {index} of the path is missed by {abs(short):.3g} N; give more "
            "points."
        )

    def _until_all_slide(self, memory: SlipMemory, depth: float, side: float) -> float:
        """Return how far the bodies move until every spring slides to a side [m]."""
        # what a spring lacks to its bound falls with its gap: the one on the axis is the last, or those that come
        return max(self.beta * depth - side * memory.on_axis, self.beta * (depth - memory.depth), 0.0)
