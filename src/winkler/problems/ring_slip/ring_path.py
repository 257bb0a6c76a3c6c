"""A contact whose rings slide, followed along a path: what a twist and a push on coatings have in common."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.loading.loads import Angle, Depth, Shift
from winkler.loading.path import Path
from winkler.media.offers import TwistedWaves, offers
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.ring_slip.ring_states import BoundOf, TwistedSprings
from winkler.problems.ring_slip.steady_path import HistoryPoint, falls, steady_points
from winkler.problems.ring_slip.torsion_march import (
    MOST_HALVINGS,
    TORQUE_MARGIN,
    presses_between,
    square,
    step_to,
    torque_of,
    torsion_step,
    trapezoid,
    unrounded,
)
from winkler.problems.ring_slip.torsion_pieces import TwistMemory, fresh
from winkler.problems.row import CURVED_STEP_TOLERANCE, Reached, Row, follow, over

LEVEL_TOLERANCE = 1e-12
"""Part of the level by which two contacts may differ whose bounds are the same."""

Springs = TypeVar("Springs", bound=TwistedSprings)

ANGLE_TOLERANCE = 1e-4
"""Error of motion, load and loss where halves are needed, over what the contact bears at most on its path."""


class RingGoal(NamedTuple):
    """What is prescribed at a moment on the way to a point: a press, and a motion [Pa] or a load."""

    point: int
    press: PressedState
    target: float


class RingMemory(NamedTuple):
    """The springs on the way to a point of a path.

    Parameters
    ----------
    memory : TwistMemory
    motion : float
        As in `HistoryPoint` [Pa].
    rate : float
        Motion over the change of the level in the last step, from which that of the next is sought.
    point : int
    nested : bool
        Whether all that slid on the way to this point was one outer ring, and slid to one side.
    """

    memory: TwistMemory
    motion: float
    rate: float
    point: int
    nested: bool


class RingRow(Row[RingGoal, RingMemory]):
    """The springs of a contact whose rings slide; energies are over 4 G_t of a twist, and half of that of a push.

    Parameters
    ----------
    bound : TwistBound
    goals : list of RingGoal
        Those of the points of the path.
    moved : bool
        Whether the motion is prescribed, not the load.
    """

    order: int | None = 2

    def __init__(self, bound: TwistBound, goals: list[RingGoal], moved: bool) -> None:
        self.bound, self.moved, self.owner = bound, moved, bound.owner
        press = max((goal.press for goal in goals), key=lambda each: (each.radius, each.level))
        stiffness = bound.inertia(press.radius) if press.radius > 0.0 else 1.0
        greatest, most = max(abs(goal.target) for goal in goals), bound.most(press)
        load = min(most, greatest * stiffness) if moved else greatest if bound.endless else most
        motion = greatest if moved else load / stiffness
        self.allowed = tuple(CURVED_STEP_TOLERANCE * each for each in (motion, load, 0.25 * load * motion))
        """Of motion [Pa], load and loss."""

    def begin(self, goal: RingGoal) -> Reached[RingMemory]:
        """Return the springs pressed straight down, and moved after."""
        memory = torsion_step(self.bound, fresh(min(goal.press.level, 0.0)), goal.press, 0.0).memory
        return self.step(RingMemory(memory, 0.0, 0.0, goal.point, True), goal)

    def step(self, state: RingMemory, goal: RingGoal) -> Reached[RingMemory]:
        """Return the springs after load and motion have changed in proportion, to a motion or to a load."""
        bound, memory = self.bound, state.memory
        press = unrounded(memory.press, goal.press)
        change = press.level - memory.press.level
        if not self.moved:
            step = step_to(bound, memory, press, goal.target, state.rate * change)
        else:
            twist = goal.target - state.motion
            straight = self._straight(memory.press, press, twist)
            step = torsion_step(bound, memory, press, twist) if straight else trapezoid(bound, memory, press, twist)
        nested = step.nested and (state.nested or state.point != goal.point)
        motion = goal.target if self.moved else state.motion + step.twist
        rate = step.twist / change if change != 0.0 else 0.0
        return Reached(RingMemory(step.memory, motion, rate, goal.point, nested), step.work, step.loss)

    def _straight(self, before: PressedState, press: PressedState, twist: float) -> bool:
        """Return whether one step by a motion leaves every spring where it must be.

        Where a bound is not a concave function of the load, a spring that slides may stick again while both change.
        """
        return twist == 0.0 or press == before or self.bound.endless or self.bound.concave

    def halfway(self, state: RingMemory, start: RingGoal, goal: RingGoal) -> RingGoal | None:
        """Return what is prescribed at the middle of the radii, or of the loads under which the body is filled."""
        first, bound = state.memory.press, self.bound
        last = unrounded(first, goal.press)
        if first == last or (self.moved and self._straight(first, last, goal.target - state.motion)):
            return None
        for halving in range(1, MOST_HALVINGS + 1):
            between = presses_between(bound, first, last, 2**halving)[:-1]
            if between:
                press = between[len(between) // 2]
                share = (press.level - first.level) / (last.level - first.level)
                return RingGoal(goal.point, press, start.target + (goal.target - start.target) * share)
        return None

    def apart(self, one: Reached[RingMemory], two: Reached[RingMemory]) -> float:
        """Return by how much motion, load and loss differ, over a small part of what the contact bears."""
        here, there = one.state, two.state
        loads = [torque_of(self.bound, each.memory) for each in (here, there)] if self.moved else [0.0, 0.0]
        misses = abs(here.motion - there.motion), abs(loads[0] - loads[1]), abs(one.lost - two.lost)
        return max(over(*pair) for pair in zip(misses, self.allowed, strict=True))


class RingPoint(NamedTuple, Generic[Springs]):
    """The contact at a point of a path.

    `normal` are the numbers of `RoundNormal`; `at` has the motion in rad or m and energies in J; `limit` is what
    friction bears at most [N m] or [N].
    """

    normal: tuple[float, float, float, float]
    at: HistoryPoint
    limit: float
    springs: Springs


def ring_points(
    bed: Bed, coefficient: float, path: Path, unit: float, springs_of: type[Springs]
) -> Iterator[RingPoint[Springs]]:
    """Yield the contact at every point of a path.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    path : Path
    unit : float
        What a stuck spring bears over its motion: 8 G_t of a twist [Pa], G* of a push [Pa].
    springs_of : type
        `TwistedSprings`, or a class of them.

    Raises
    ------
    OutsideValidity
        If friction does not bear a prescribed load, at that point.
    NotConverged
        If a step is too long.
    """
    forced, bound_of = not isinstance(path.normal, Depth), springs_of.bound_of
    depth, force, radius = _pressed(bed, path, forced)
    widest = float(np.max(radius))
    bound = bound_of(bed, coefficient, widest if widest > 0.0 else _own_length(bed), forced)
    excess = np.where(radius >= bed.rim, depth - bed.gap(radius), 0.0)
    # the panels of the widest contact do not resolve one that is narrower than they are
    felt = np.where(radius >= bound.narrowest, radius, 0.0)
    rows = (path.across, felt, np.maximum(excess, 0.0))
    presses = [PressedState(*row) for row in zip(*(each.tolist() for each in rows), strict=True)]
    moved = isinstance(path.lateral, Angle | Shift)
    targets = [unit * each if moved else each for each in path.along.tolist()]
    history = _steady if all(each == presses[0] for each in presses) and falls(bound, presses[0]) else _marched
    for i, point in enumerate(history(bound, presses, targets, moved)):
        at = point._replace(
            motion=float(path.along[i]) if moved else point.motion / unit,
            work=2.0 * point.work / unit,
            stored=point.stored / unit,
            lost=2.0 * point.lost / unit,
        )
        normal = float(path.time[i]), float(depth[i]), float(force[i]), float(radius[i])
        limit = _limit(bound, presses[i], float(radius[i]), bound_of)
        yield RingPoint(normal, at, limit, springs_of(bed, coefficient, bound.widest, forced, at.memory))


def _limit(bound: TwistBound, press: PressedState, radius: float, bound_of: BoundOf) -> float:
    """Return what friction bears at most, of a contact that is not felt on panels that are made for it."""
    if 0.0 < radius < bound.narrowest:
        bound = bound_of(bound.bed, bound.coefficient, radius, bound.forced)
        press = press._replace(radius=radius)
    return bound.most(press)


def _own_length(bed: Bed) -> float:
    """Return a radius [m] for the tables of bodies that never touch; of no effect where the body has no length."""
    return float(bed.medium.response.length) if offers(bed.medium, TwistedWaves) else 1.0


def _pressed(bed: Bed, path: Path, forced: bool) -> tuple[Array, Array, Array]:
    """Return depths, forces and radii along the path."""
    across = path.across
    pressed = across[:1] if np.all(across == across[0]) else across  # a steady load is solved once
    depth, radius = at_force(bed, pressed) if forced else at_depth(bed, pressed)
    depth, radius = np.broadcast_to(depth, across.shape), np.broadcast_to(radius, across.shape)
    force = across if forced else bed.stiffness(radius) * depth - bed.gap_load(radius)
    return depth, np.where(radius > 0.0, force, 0.0), radius


def _steady(
    bound: TwistBound, presses: list[PressedState], targets: list[float], moved: bool
) -> Iterator[HistoryPoint]:
    """Yield the points of a path under a steady load, all at once."""
    press = presses[0]
    limit = bound.most(press)
    most = limit if bound.slides else limit * (1.0 - TORQUE_MARGIN)
    targets = targets if moved else [bound.borne(each, limit) for each in targets]
    borne = len(targets) if moved else next((i for i, each in enumerate(targets) if abs(each) > most), len(targets))
    points = steady_points(bound, press, targets[:borne], not moved)
    yield from points
    if borne < len(targets):
        goals = [RingGoal(point, press, target) for point, target in enumerate(targets)]
        row = RingRow(bound, goals, moved)
        next(follow(row, goals[borne:], (borne - 1, goals[borne], row.begin(RingGoal(0, press, 0.0)))))  # refuses


def _marched(
    bound: TwistBound, presses: list[PressedState], targets: list[float], moved: bool
) -> Iterator[HistoryPoint]:
    """Yield the points of a path one after the other."""
    goals = [RingGoal(point, *goal) for point, goal in enumerate(zip(presses, targets, strict=True))]
    for state, work, lost in follow(RingRow(bound, goals, moved), goals):
        memory, motion = state.memory, state.motion
        at = (motion, torque_of(bound, memory), _stick_radius(memory))
        yield HistoryPoint(*at, work, square(bound, memory), lost, state.nested, memory)


def _stick_radius(memory: TwistMemory) -> float:
    """Return the radius up to which no spring is at the bound of the contact as it is."""
    for piece in memory.pieces:
        same = abs(piece.bound.level - memory.press.level) <= LEVEL_TOLERANCE * abs(memory.press.level)
        if piece.side != 0.0 and piece.held == 0.0 and piece.entered == 0.0 and same:
            return piece.low
    return memory.press.radius
