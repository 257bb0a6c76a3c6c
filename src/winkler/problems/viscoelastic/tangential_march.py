"""Springs that relax in both directions as a row: pressed, and dragged along the surface.

A sudden step is one step, however far it goes; one that takes time is halved until both halves bring the springs to
where the whole did (`winkler.problems.row`).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.equations.driven import driven
from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, of_creep, of_relaxation
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.numerics.springs.relaxing_friction import drag
from winkler.numerics.types import Array
from winkler.problems.row import Reached, Row, over
from winkler.problems.viscoelastic.dragged_cells import DragCells
from winkler.problems.viscoelastic.march import RESTING_FORCE, SpringRow
from winkler.values.errors import NotConverged, OutsideValidity

BOUND_ROUNDING = 1e-9
"""Part of the greatest bound that is rounding."""
FORCE_TOLERANCE = 1e-12
"""Part of what friction bears to which a shear force is met."""


def shear_relaxation(medium: ViscoelasticHalfSpace, share: float = 0.5) -> RelaxationSeries:
    """Return G*(t) [Pa] of a pair: the bodies bear the same traction, so their creep adds up.

    Of a disc it is (2 - nu)/4 of each, of another outline (1 - nu + nu s)/2 with its `share` s in this direction.
    """
    return _pair_relaxation(medium, lambda poisson: 0.5 * (1.0 - (1.0 - share) * poisson))


def twist_relaxation(medium: ViscoelasticHalfSpace) -> RelaxationSeries:
    """Return 8 G_t(t) [Pa] of a pair, by which its springs relax under a twist: 1/G_t = 1/G_1 + 1/G_2."""
    return _pair_relaxation(medium, lambda _: 0.125)


def _pair_relaxation(medium: ViscoelasticHalfSpace, part: Callable[[float], float]) -> RelaxationSeries:
    """Return the relaxation of a pair whose compliance is a part, by Poisson's ratio, of 1/G of each body."""
    bodies = [body for body in (medium.first, medium.second) if isinstance(body, ViscoelasticSolid | Elastic)]
    if len(bodies) == 1 and isinstance(bodies[0], ViscoelasticSolid):
        return bodies[0].series.scaled(1.0 / part(bodies[0].poisson))
    total = CreepSeries(0.0, 0.0, np.empty(0), np.empty(0))
    for body in bodies:
        if isinstance(body, Elastic):
            compliance = part(body.poisson) * 2.0 * (1.0 + body.poisson) / body.young
            total = total.plus(CreepSeries(compliance, 0.0, np.empty(0), np.empty(0)))
        else:
            total = total.plus(of_relaxation(body.series).scaled(part(body.poisson)))
    return of_creep(total)


class DragGoal(NamedTuple):
    """What is prescribed at a time [s]: a depth [m] or force [N] across the surface, a shift [m] or force along it."""

    time: float
    across: float
    along: float


class ErrorScales(NamedTuple):
    """What counts as little: errors of depth and shift [m], shear force [N], energy [J]; and the greatest force [N]."""

    depth: float
    shift: float
    shear_force: float
    energy: float
    force: float


class DraggedSprings(NamedTuple):
    """What springs remember that relax in both directions.

    Parameters
    ----------
    goal
        Where they are.
    row
        The springs across the surface.
    displaced, memory
        Along the surface [m], ``(n,)`` and ``(n, terms)``.
    free, stuck
        Which springs recover freely, and which stick, ``(n,)``.
    loads, bounds
        Along the surface and what friction bears, over the weights, ``(n,)``.
    shift, rate, slide
        U_x [m], and how fast depth and shift changed in the last step [m/s].
    force, radius, shear_force, stored
        F_N [N], a [m], F_x [N], and the energy of both directions [J].
    friction, bulk, pressing
        Lost to friction and in the bodies, and what of that pressing costs [J].
    ring
        Whether the contact is no disc.
    """

    goal: DragGoal
    row: SpringRow
    displaced: Array
    memory: Array
    free: Array
    stuck: Array
    loads: Array
    bounds: Array
    shift: float = 0.0
    rate: float = 0.0
    slide: float = 0.0
    force: float = 0.0
    radius: float = 0.0
    shear_force: float = 0.0
    stored: float = 0.0
    friction: float = 0.0
    bulk: float = 0.0
    pressing: float = 0.0
    ring: bool = False


class DraggedRow(Row[DragGoal, DraggedSprings]):
    """A row of springs that relax in both directions.

    Parameters
    ----------
    row : SpringRow
        Across the surface, before anything has happened.
    cells : DragCells
        Those that are dragged.
    shear : RelaxationSeries
        G*(t), of a twist 8 G_t(t).
    coefficient : float
        mu [-].
    by_depth, by_shift : bool
        What is prescribed.
    scales : ErrorScales
    course : callable, optional
        What is prescribed at a time [s], where steps are halved on a curve: losses in the bodies are compared too.
    """

    def __init__(
        self,
        row: SpringRow,
        cells: DragCells,
        shear: RelaxationSeries,
        coefficient: float,
        by_depth: bool,
        by_shift: bool,
        scales: ErrorScales,
        course: Callable[[float], DragGoal] | None = None,
    ) -> None:
        self.course = course
        self.row, self.shear, self.coefficient, self.scales = row, shear, coefficient, scales
        self.cells, self.owner = cells, cells.owner
        self.by_depth, self.by_shift = by_depth, by_shift
        # with a dashpot a spring bears at once where it is touched: forces jump, and only what they do settles
        self.jumps = row.series.viscosity > 0.0 and by_shift and not by_depth
        self.recovery = Recovery.of(shear)
        self.law = self.recovery.law(shear)

    def begin(self, goal: DragGoal) -> Reached[DraggedSprings]:
        """Return the springs at the first point, where what is not zero comes suddenly."""
        count = self.cells.place.size
        row, none, never = self.row.copy(), np.zeros(count), np.zeros(count, dtype=bool)
        row.motion[0] = min(goal.across, 0.0) if self.by_depth else row.depth
        memory = np.zeros((count, self.recovery.rates.size))
        return self._sudden(DraggedSprings(goal, row, none, memory, never, never, none, none), goal)

    def step(self, state: DraggedSprings, goal: DragGoal) -> Reached[DraggedSprings]:
        """Return the springs after depth and shift have changed steadily, or suddenly."""
        if goal.time == state.goal.time:
            return self._sudden(state, goal)
        # under a dashpot alongside forces jump with the rate: there the mean force of the step is prescribed
        viscous = self.row.series.viscosity > 0.0
        across = 0.5 * (state.goal.across + goal.across) if viscous else goal.across
        return self._go(state, goal, max(across, RESTING_FORCE * self.scales.force))

    def halfway(self, state: DraggedSprings, start: DragGoal, goal: DragGoal) -> DragGoal | None:
        """Return what is prescribed in the middle of a step that takes time."""
        middle = DragGoal(*(0.5 * (mine + its) for mine, its in zip(start, goal, strict=True)))
        if self.course is not None:
            middle = self.course(middle.time)
        return middle if start.time < middle.time < goal.time else None

    def apart(self, one: Reached[DraggedSprings], two: Reached[DraggedSprings]) -> float:
        """Return by how much forces, losses and motions differ, over what is allowed."""
        (here, there), scales = (one.state, two.state), self.scales
        return max(
            over(abs(one.work - two.work), scales.energy)
            if self.jumps
            else over(abs(here.shear_force - there.shear_force), scales.shear_force),
            over(abs(here.friction - there.friction), scales.energy),
            over(abs(here.shift - there.shift), scales.shift),
            0.0 if self.by_depth else over(abs(here.row.depth - there.row.depth), scales.depth),
            0.0 if self.course is None else over(abs(one.lost - two.lost), scales.energy),
        )

    def _sudden(self, state: DraggedSprings, goal: DragGoal) -> Reached[DraggedSprings]:
        """Press and then move the bodies at once, as far as a dashpot lets them."""
        stubborn = self.row.series.viscosity > 0.0
        here = goal._replace(along=state.shift if self.by_shift else state.shear_force)
        if stubborn and self.by_depth and goal.across > max(state.row.depth, 0.0):
            raise OutsideValidity(
                f"the depth rises suddenly to {goal.across:.6g} m at {goal.time:.6g} s, which a dashpot alongside "
                "responds to with an infinite force; give the step some time."
            )
        reached = Reached(state._replace(goal=goal), 0.0, 0.0)
        if self.by_depth or not stubborn:
            reached = self._go(reached.state, here, max(goal.across, 0.0))
        if self.shear.viscosity > 0.0:
            if not self.by_shift:
                return reached
            if goal.along != state.shift and np.any(reached.state.row.pressed):
                raise OutsideValidity(
                    f"the bodies are moved suddenly along the surface at {goal.time:.6g} s, which a dashpot alongside "
                    "responds to with an infinite force; give the step some time."
                )
        now = reached.state
        still = DragGoal(goal.time, now.row.depth, goal.along)
        moved = reached.then(self._go(now._replace(goal=goal), still, now.force))
        return moved._replace(state=moved.state._replace(goal=goal))

    def _go(self, state: DraggedSprings, goal: DragGoal, force: float) -> Reached[DraggedSprings]:
        """Return the springs after a step, which bear a force at its end, or in the mean as `SpringRow.towards` has it.

        A depth that is prescribed is that of the goal.
        """
        dt, row = goal.time - state.goal.time, state.row.copy()
        was, depth, place = row.pressed.copy(), row.depth, row.place.copy()
        change = goal.across - depth if self.by_depth else row.towards(force, dt, state.rate * dt, self.scales.force)
        pressed = row.march(np.array([change]), np.array([dt]))
        under = self.cells.under
        loads = self.cells.bounds(np.maximum(row.loads(), 0.0))
        if loads.min() < -BOUND_ROUNDING * loads.max():
            raise OutsideValidity(
                "the rings that would slide first are not the outer ones, since the layers spread their traction "
                "inwards; give a narrower contact."
            )
        bounds = np.where(loads > 0.0, self.coefficient * np.where(loads > 0.0, loads, 1.0), 0.0)
        # a free spring is caught when it and the body meet, while it recovers
        share = np.ones(under.size)
        caught = (row.pressed & ~was)[under]
        if np.any(caught):
            rates, these = row.law[4], under[caught]
            gap = row.springs.gap[these]
            apart = gap + place[these] - depth
            closed = row.depth - gap - np.exp(-rates * dt) @ state.row.memory[: rates.size, these]
            met = np.divide(apart, apart + closed, out=np.zeros(apart.size), where=apart + closed > 0.0)
            share[caught] = 1.0 - np.clip(met, 0.0, 1.0)
        moved, new, sums = self._dragged_to(state, bounds, share, dt, goal.along)
        shear_force, lost, work, stored, _, bulk = sums.tolist()
        new = new._replace(
            goal=goal,
            row=row,
            shift=state.shift + moved,
            rate=change / dt if dt > 0.0 else state.rate,
            slide=moved / dt if dt > 0.0 else state.slide,
            force=float(pressed.force[0]),
            radius=float(pressed.radius[0]),
            shear_force=shear_force,
            stored=float(pressed.stored[0]) + stored,
            friction=state.friction + lost,
            bulk=state.bulk + float(pressed.lost[0]) + bulk,
            pressing=state.pressing + float(pressed.lost[0]),
            ring=bool(pressed.ring[0]),
        )
        lost_in_all = new.friction - state.friction + new.bulk - state.bulk
        return Reached(new, float(pressed.work[0]) + work + lost, lost_in_all)

    def _dragged(
        self, state: DraggedSprings, bounds: Array, share: Array, dt: float, moved: float
    ) -> tuple[DraggedSprings, Array]:
        """Return the springs after the bodies have moved along the surface, and sums over them."""
        sums, count = np.empty(6), share.size
        new = state._replace(
            displaced=state.displaced.copy(),
            memory=state.memory.copy(),
            free=state.free.copy(),
            stuck=np.empty(count, dtype=bool),
            loads=np.empty(count),
            bounds=bounds,
        )
        drag(
            self.law, self.cells.weights, state.bounds, bounds, share, dt, moved, new.displaced, new.memory, new.free,
            new.loads, new.stuck, sums,
        )  # fmt: skip
        return new, sums

    def _dragged_to(
        self, state: DraggedSprings, bounds: Array, share: Array, dt: float, prescribed: float
    ) -> tuple[float, DraggedSprings, Array]:
        """Return how far the bodies move to a shift or a shear force, and what `_dragged` returns there."""
        if self.by_shift:
            moved = prescribed - state.shift
            return moved, *self._dragged(state, bounds, share, dt, moved)
        cells, endless = self.cells, math.isinf(self.coefficient)
        most = 0.0 if endless else float(cells.weights @ bounds)
        close = FORCE_TOLERANCE * max(most, abs(prescribed))
        if not endless and abs(prescribed) > most + close:
            raise OutsideValidity(
                f"a {cells.load} of {prescribed:.6g} {cells.unit} is prescribed, but the friction limit is "
                f"{most:.6g} {cells.unit}, and the bodies would "
                f"{'spin' if cells.motion == 'Angle' else 'slide away'}; press them harder, or give "
                f"{'an' if cells.motion == 'Angle' else 'a'} {cells.motion}."
            )
        stuck = self.scales.shear_force / self.scales.shift

        found = state, np.empty(0)

        def borne(moved: float) -> tuple[float, float]:
            nonlocal found
            found = _, sums = self._dragged(state, bounds, share, dt, moved)
            return float(sums[0]), float(sums[4]) if sums[4] > 0.0 else stuck

        needed = driven(borne, prescribed, state.slide * dt, close)
        if needed is not None:  # which was tried last
            return needed, *found
        raise NotConverged(
            f"the springs find no {cells.motion.lower()} at which they carry a {cells.load} of {prescribed:.6g} "
            f"{cells.unit}."
        )
