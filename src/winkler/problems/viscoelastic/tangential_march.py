"""The march of relaxing springs that are pressed and dragged along the surface, in steps chosen by their error."""

from __future__ import annotations

import copy
import math
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.materials.elastic import Elastic
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, of_creep, of_relaxation
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.numerics.springs.relaxing_friction import drag
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.force_driven import RESTING_FORCE, SHORTEST_STEP
from winkler.problems.viscoelastic.march import SpringRow

__all__ = ["ErrorScales", "ShearedMarch", "ShearedRowState", "StepTarget", "shear_relaxation", "sudden_step", "travel"]

MOST_TRIALS = 200
FORCE_TOLERANCE = 1e-12
"""Part of what friction bears to which a shear force is met."""


def shear_relaxation(medium: ViscoelasticHalfSpace, share: float = 0.5) -> RelaxationSeries:
    """Return G*(t) [Pa] of a pair: the bodies bear the same traction, so their creep adds up.

    Of a disc it is (2 - nu)/4 of each, of another outline (1 - nu + nu s)/2 with its `share` s in this direction.
    """
    bodies = [body for body in (medium.first, medium.second) if isinstance(body, ViscoelasticSolid | Elastic)]
    if len(bodies) == 1 and isinstance(bodies[0], ViscoelasticSolid):
        return bodies[0].series.scaled(2.0 / (1.0 - (1.0 - share) * bodies[0].poisson))
    total = CreepSeries(0.0, 0.0, np.empty(0), np.empty(0))
    for body in bodies:
        if isinstance(body, Elastic):
            compliance = (1.0 - (1.0 - share) * body.poisson) * (1.0 + body.poisson) / body.young
            total = total.plus(CreepSeries(compliance, 0.0, np.empty(0), np.empty(0)))
        else:
            total = total.plus(of_relaxation(body.series).scaled(0.5 * (1.0 - (1.0 - share) * body.poisson)))
    return of_creep(total)


class StepTarget(NamedTuple):
    """What is prescribed: a depth [m] or force [N] across the surface, a shift [m] or shear force [N] along it."""

    across: float
    along: float

    def towards(self, other: StepTarget, part: float) -> StepTarget:
        """Return what is prescribed at a part of the step to another one."""
        return StepTarget(*(mine + (its - mine) * part for mine, its in zip(self, other, strict=True)))


class ErrorScales(NamedTuple):
    """What counts as little: errors of depth and shift [m], shear force [N], energy [J]; and the greatest force [N]."""

    depth: float
    shift: float
    shear_force: float
    energy: float
    force: float


class ShearedRowState(NamedTuple):
    """What a row bears and has spent: F [N], a [m], F_x [N], U [J], lost by friction, in bodies, work [J], a ring."""

    force: float
    radius: float
    shear_force: float
    stored: float
    friction: float
    bulk: float
    work: float
    ring: bool


AT_REST = ShearedRowState(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False)


class ShearedMarch:
    """A row of springs that relax in both directions.

    Parameters
    ----------
    row : SpringRow
        Across the surface.
    shear : RelaxationSeries
        G*(t).
    coefficient : float
        mu [-].
    by_depth, by_shift : bool
        What is prescribed.
    """

    def __init__(
        self, row: SpringRow, shear: RelaxationSeries, coefficient: float, by_depth: bool, by_shift: bool
    ) -> None:
        self.row, self.shear, self.coefficient = row, shear, coefficient
        self.by_depth, self.by_shift = by_depth, by_shift
        count = row.springs.gap.size
        recovery = Recovery.of(shear)
        self.law = recovery.law(shear)
        self.displaced, self.memory = np.zeros(count), np.zeros((count, recovery.rates.size))
        self.free = np.zeros(count, dtype=bool)
        self.loads, self.bounds, self.stuck = np.zeros(count), np.zeros(count), np.zeros(count, dtype=bool)
        self.shift, self.rate, self.slide, self.turn = 0.0, 0.0, 0.0, AT_REST
        self.pressing, self.shearing = 0.0, 0.0

    def copy(self) -> ShearedMarch:
        """Return a row that may be carried on without this one."""
        twin = copy.copy(self)
        twin.row, twin.displaced, twin.memory = self.row.copy(), self.displaced.copy(), self.memory.copy()
        twin.free = self.free.copy()
        return twin

    def _bounds(self) -> Array:
        """How much every spring bears along the surface, over its weight."""
        loads = np.maximum(self.row.loads(), 0.0)
        return np.where(loads > 0.0, self.coefficient * np.where(loads > 0.0, loads, 1.0), 0.0)

    def step(self, goal: StepTarget, dt: float, force: float, scales: ErrorScales) -> ShearedMarch:
        """Return the row after a step to what is prescribed at its end.

        `force` is what the springs are to bear across the surface, at the end or in the mean as `Row.towards` has it.
        """
        new = self.copy()
        row, was, depth, place = self.row, self.row.pressed, self.row.depth, self.row.place
        change = goal.across - depth if self.by_depth else row.towards(force, dt, self.rate * dt, scales.force)
        done = new.row.march(np.array([change]), np.array([dt]))
        new.rate = change / dt if dt > 0.0 else self.rate
        new.bounds = new._bounds()
        # a free spring is caught when the body has come down to where it stands
        share = np.ones(was.size)
        caught = new.row.pressed & ~was
        if change != 0.0 and np.any(caught):
            away = (row.springs.gap[caught] + place[caught] - depth) / change
            share[caught] = 1.0 - np.clip(away, 0.0, 1.0)
        moved = goal.along - self.shift if self.by_shift else self._shift_under(new.bounds, share, dt, goal.along)
        sums, new.loads, new.stuck = np.empty(6), np.empty(was.size), np.empty(was.size, dtype=bool)
        drag(
            self.law, row.row[1], self.bounds, new.bounds, share, dt, moved, new.displaced, new.memory, new.free,
            new.loads, new.stuck, sums,
        )  # fmt: skip
        shear_force, lost, work, stored, _, bulk = sums.tolist()
        new.shift, new.slide = self.shift + moved, moved / dt if dt > 0.0 else self.slide
        new.pressing = self.pressing + float(done.work[0])
        new.shearing = self.shearing + work + lost
        new.turn = ShearedRowState(
            float(done.force[0]), float(done.radius[0]), shear_force, float(done.stored[0]) + stored,
            self.turn.friction + lost, self.turn.bulk + float(done.lost[0]) + bulk, new.pressing + new.shearing,
            bool(done.ring[0]),
        )  # fmt: skip
        return new

    def _shift_under(self, bounds: Array, share: Array, dt: float, prescribed: float) -> float:
        """Return by how much the bodies move until the springs bear a shear force."""
        weights = self.row.row[1]
        most = float(weights @ np.where(np.isfinite(bounds), bounds, 0.0)) if math.isfinite(self.coefficient) else 0.0
        close = FORCE_TOLERANCE * max(most, abs(prescribed))
        if math.isfinite(self.coefficient) and abs(prescribed) > most + close:
            raise OutsideValidity(
                f"Tangential: friction bears {most:.6g} N, less than the shear force of {prescribed:.6g} N "
                "that is prescribed; the bodies slide away: press them harder, or prescribe a Shift."
            )
        sums, loads, stuck = np.empty(6), np.empty(weights.size), np.empty(weights.size, dtype=bool)
        low, high, moved, stride = -math.inf, math.inf, self.slide * dt, 0.0
        for turn in range(MOST_TRIALS):
            drag(
                self.law, weights, self.bounds, bounds, share, dt, moved, self.displaced.copy(), self.memory.copy(),
                self.free.copy(), loads, stuck, sums,
            )  # fmt: skip
            short = prescribed - float(sums[0])
            if abs(short) <= close:
                return moved
            low, high = (moved, high) if short > 0.0 else (low, moved)
            newton = moved + short / sums[4] if sums[4] > 0.0 else math.copysign(math.inf, short)
            if low < newton < high and turn % 4 != 3:
                moved = float(newton)
            elif math.isfinite(low) and math.isfinite(high):
                middle = 0.5 * (low + high)
                if not low < middle < high:
                    return middle
                moved = middle
            else:
                stride = max(2.0 * stride, abs(moved), float(np.max(np.abs(self.displaced))), 1e-9 * self.row.depth)
                moved += math.copysign(stride, short)
        raise NotConverged(f"The springs find no shift at which they bear the shear force {prescribed:.6g} N.")


def sudden_step(row: ShearedMarch, goal: StepTarget, time: float, scales: ErrorScales) -> ShearedMarch:
    """Press and then move the bodies at once, as far as a dashpot lets them."""
    stubborn = row.row.series.viscosity > 0.0
    here = StepTarget(goal.across, row.shift if row.by_shift else row.turn.shear_force)
    rising = row.by_depth and goal.across > max(row.row.depth, 0.0)
    if stubborn and rising:
        raise OutsideValidity(
            f"Tangential: at {time:.6g} s the depth rises suddenly to {goal.across:.6g} m, which a "
            "dashpot alongside responds to with an infinite force; give the step some time."
        )
    if row.by_depth or not stubborn:
        row = row.step(here, 0.0, max(goal.across, 0.0), scales)
    if row.shear.viscosity > 0.0:
        if not row.by_shift:
            return row
        if goal.along != row.shift and np.any(row.row.pressed):
            raise OutsideValidity(
                f"Tangential: at {time:.6g} s the bodies are moved suddenly along the surface, which a "
                "dashpot alongside responds to with an infinite force; give the step some time."
            )
    return row.step(StepTarget(row.row.depth, goal.along), 0.0, row.turn.force, scales)


def travel(
    row: ShearedMarch, start: StepTarget, end: StepTarget, duration: float, pace: float, scales: ErrorScales
) -> tuple[ShearedMarch, float]:
    """Carry a row from one point of the path to the next, and return the pace at which it arrives.

    Every step is made at once and in halves; the halves are used, and what both disagree by is its error.
    """
    mean = row.row.series.viscosity > 0.0
    parts = (0.25, 0.75, 0.5) if mean else (0.5, 1.0, 1.0)
    done, pace = 0.0, min(pace, duration)
    while done < duration:
        dt = min(pace, duration - done)
        if duration - done - dt < 1e-9 * duration:
            dt = duration - done
        begin, step = done / duration, dt / duration
        middle, last = (start.towards(end, begin + part * step) for part in (0.5, 1.0))
        early, late, both = (
            max(start.towards(end, begin + part * step).across, RESTING_FORCE * scales.force) for part in parts
        )
        half = row.step(middle, 0.5 * dt, early, scales)
        two = half.step(last, 0.5 * dt, late, scales)
        one = row.step(last, dt, both, scales)
        error = max(
            abs(one.turn.shear_force - two.turn.shear_force) / scales.shear_force,
            abs(one.turn.friction - two.turn.friction) / scales.energy,
            abs(one.shift - two.shift) / scales.shift,
            0.0 if row.by_depth else abs(one.row.depth - two.row.depth) / scales.depth,
        )
        if error > 1.0:
            if dt < SHORTEST_STEP * duration:
                raise NotConverged("Tangential: the springs need ever shorter steps; allow a greater tolerance.")
            pace = dt * max(0.2, 0.9 * error ** (-1.0 / 3.0))
            continue
        row = two
        done = duration if dt == duration - done else done + dt
        pace = dt * min(4.0, max(0.3, 0.9 * max(error, 1e-6) ** (-1.0 / 3.0)))
    return row, pace
