"""Springs one by one as a row: how far each is displaced along a path, and what drives it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, slipping_springs
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.springs.slip_pull import pull_line
from winkler.numerics.springs.spring_work import work_on_line, work_on_springs
from winkler.numerics.types import Array
from winkler.problems.friction.spring_states import SpringLaw, SpringState
from winkler.problems.friction.tangential_march import PressedRow, SlipGoal, refuse_shear
from winkler.problems.normal.indentation import Indentation
from winkler.problems.row import Reached, follow, over
from winkler.values.errors import InvalidInput, NotConverged

__all__ = ["SingleSprings", "SpringPlaces"]

UNREACHABLE_BOUND = 1e100
"""Instead of an infinite bound: so far no spring is ever displaced, and its square is still a number."""
FORCE_TOLERANCE = 1e-12
"""Relative error of a prescribed shear force in the plane."""
MOST_NEWTON_STEPS = 60
"""Steps of Newton's method."""
BOUND_TOLERANCE = 1e-9
"""A spring this close to its bound, in parts of it, slips."""


class SpringPlaces(NamedTuple):
    """What springs remember: u_t [m] ``(2, n)``, whether they slip, their depth and the shift of the bodies [m].

    `force` and `stored` are what they bear along the surface [N] ``(2,)`` and store [J].
    """

    u: Array
    slips: Array
    depth: float
    shift: Array
    force: Array
    stored: float


class SingleSprings(PressedRow[SpringPlaces]):
    """The springs under a path one by one: how far each is displaced, and what drives them.

    A step is straight in their own depth, at which they bear the true force, and in the shift.  One direction with
    Coulomb friction runs in a kernel of its own; everything else as motion in the plane.

    Parameters
    ----------
    owner : str
        Kind of problem, for messages.
    bed : Bed
    law : Coulomb, StaticKinetic or OwnLaw
    path : Path
    count : int
        Of springs.
    """

    def __init__(self, owner: str, bed: Bed, law: SpringLaw, path: Path, count: int) -> None:
        self.owner, self.bed, self.law, self.path = owner, bed, law, path
        load = Depth(path.across) if isinstance(path.normal, Depth) else Force(path.across)
        contact = Indentation(bed, load).solve()
        self.contact = [np.asarray(q) for q in (contact.depth, contact.force, contact.radius)]
        depth, force, radius = self.contact
        none, widest = np.zeros(0), float(np.max(radius))
        springs = Springs.of(slipping_springs(bed), widest, count) if widest > 0.0 else Springs(none, none, none, none)
        self.springs = springs
        own = np.where(force > 0.0, springs.depth(force), depth) if springs.gap.size else depth
        self.line, along = not path.in_plane, path.along
        along = np.column_stack([along, np.zeros(along.size)]) if self.line else along
        rows = zip(own.tolist(), force.tolist(), along, strict=True)
        super().__init__(path, [SlipGoal(*row) for row in rows])
        # writable copies: a kernel is compiled anew for arrays of another kind
        self.gap, self.stiffness = springs.gap.copy(), springs.tangential_stiffness
        self.slope, self.hold = np.zeros(springs.gap.size), 1.0
        match law:
            case Coulomb(coefficient):
                self.slope = min(coefficient, UNREACHABLE_BOUND) / springs.mindlin_ratio
            case StaticKinetic(static, kinetic):
                self.slope, self.hold = kinetic / springs.mindlin_ratio, static / kinetic
        self.plain = self.line and self.hold == 1.0 and isinstance(law, Coulomb | StaticKinetic)
        # where springs drop to a lesser bound each does so at its own time, and halves never agree
        self.curves = self.hold == 1.0
        self.bends = self.curves and not self.line
        deepest = self.bound(float(np.max(own)))
        self._allow(float(np.sum(self.stiffness[deepest > 0.0])), float(np.max(deepest, initial=0.0)))

    def begin(self, goal: SlipGoal) -> Reached[SpringPlaces]:
        """Return the springs at the first point, pressed straight down and moved after."""
        count, none = self.gap.size, np.zeros(2)
        return self.step(
            SpringPlaces(np.zeros((2, count)), np.zeros(count, dtype=bool), goal.depth, none, none, 0.0), goal
        )

    def step(self, state: SpringPlaces, goal: SlipGoal) -> Reached[SpringPlaces]:
        """Return the springs after a straight step, to a shift or to a shear force."""
        u, slips, own = state.u.copy(), state.slips.copy(), np.array([state.depth, goal.depth])
        bounds = np.array([self.bound(depth) for depth in own.tolist()])
        ends, force, stored, lost = np.array([state.shift, goal.along]), np.zeros((1, 2)), np.zeros(1), np.zeros(1)
        if self.plain:
            fixed, shift = (self.gap, self.stiffness, self.slope, own), ends[:, 0].copy()
            if self.driven:
                march_line(u[0], *fixed, shift, force[:, 0], stored, lost)
            elif pull_line(u[0], *fixed, goal.along[:1].copy(), shift, force[:, 0], stored, lost) < 1:
                self._refuse(goal, bounds[1])
            ends[:, 0] = shift
        else:
            if not self.driven:
                ends[1] = self._found(state, goal, bounds)
            march_plane(u, slips, self.gap, self.stiffness, bounds, self.hold, own, ends, force, stored, lost)
        depths, move = (own[0], own[1]), ends[1] - ends[0]
        if self.plain:
            worked = work_on_line(state.u[0], self.gap, bounds, depths, move[0])
        else:
            worked = work_on_springs(state.u.T, state.slips, self.gap, bounds, self.hold, depths, move)
        places = SpringPlaces(u, slips, goal.depth, ends[1], force[0], float(stored[0]))
        return Reached(places, float(self.stiffness @ worked), float(lost[0]))

    def apart(self, one: Reached[SpringPlaces], two: Reached[SpringPlaces]) -> float:
        """Return by how much displacements and losses differ, over a small part of those on the path."""
        (here, there), (near, cheap) = (one.state, two.state), self.allowed
        moved = float(np.max(np.abs(here.u - there.u), initial=0.0)), float(np.max(np.abs(here.shift - there.shift)))
        return max(over(max(moved), near), over(abs(one.lost - two.lost), cheap))

    def force_at(self, depth: float) -> float:
        """Return as `PressedRow.force_at`."""
        return self.springs.force(depth)

    def bound(self, depth: float) -> Array:
        """Return how far slipping springs are displaced at a depth [m], ``(n,)``; zero out of contact."""
        pressed, law = np.maximum(depth - self.gap, 0.0), self.law
        if isinstance(law, Coulomb | StaticKinetic):
            return np.asarray(self.slope * pressed)
        density = self.springs.density(slipping_springs(self.bed))
        borne = np.asarray(law.shear_bound(density * pressed), dtype=float)
        if borne.shape != pressed.shape or not np.all(np.isfinite(borne)) or np.any(borne < 0.0):
            raise InvalidInput(
                f"{self.owner}: {type(law).__name__}.shear_bound must return finite loads, not negative, in the "
                "shape of those it is given."
            )
        return np.where(pressed > 0.0, borne / (density * self.springs.mindlin_ratio), 0.0)

    def _refuse(self, goal: SlipGoal, bound: Array) -> None:
        refuse_shear(float(np.linalg.norm(goal.along)), self.hold * float(self.stiffness @ bound))

    def _found(self, state: SpringPlaces, goal: SlipGoal, bounds: Array) -> Array:
        """Return the shift in the plane that gives a force, by Broyden's method from the stiffness of stuck springs."""
        target, start = goal.along, state.shift
        size = float(np.linalg.norm(target))
        if size > self.hold * float(self.stiffness @ bounds[1]) * (1.0 + FORCE_TOLERANCE):
            self._refuse(goal, bounds[1])
        stuck = float(self.stiffness @ (bounds[1] > 0.0))
        if stuck == 0.0:
            return start
        scale = size + float(self.stiffness @ np.hypot(*state.u))
        own, ends = np.array([state.depth, goal.depth]), np.vstack([start, start])
        u, slips, pull, rest = state.u.copy(), state.slips.copy(), np.zeros((1, 2)), np.zeros((2, 1))

        def short(at: Array) -> Array:
            u[:], slips[:], ends[1] = state.u, state.slips, at
            march_plane(u, slips, self.gap, self.stiffness, bounds, self.hold, own, ends, pull, rest[0], rest[1])
            return np.asarray(target - pull[0])

        at, left, rise = start.copy(), short(start), stuck * np.eye(2)
        for _ in range(MOST_NEWTON_STEPS):
            missed = float(np.linalg.norm(left))
            if missed <= FORCE_TOLERANCE * scale:
                return at
            step = np.linalg.solve(rise, left)
            after = short(at + step)
            if np.linalg.norm(after) >= 0.9 * missed:
                # a corner lies between: measure the stiffness anew, and take a shorter step if need be
                nudge = 1e-7 * max(float(np.linalg.norm(step)), 1e-3 * scale / stuck)
                rise = np.column_stack([(left - short(at + nudge * e)) / nudge for e in np.eye(2)])
                rise += 1e-9 * stuck * np.eye(2)
                step = np.linalg.solve(rise, left)
                after = short(at + step)
                while np.linalg.norm(after) >= missed and np.linalg.norm(step) > 1e-15 * np.linalg.norm(at):
                    step *= 0.5
                    after = short(at + step)
            change = left - after - rise @ step
            at, left, rise = at + step, after, rise + np.outer(change, step) / float(step @ step)
        raise NotConverged(
            f"a shear force of {size:.6g} N is missed by {np.linalg.norm(left):.3g} N; give more points, or a Shift."
        )

    def states(self) -> Iterator[SpringState]:
        """Yield the springs as they stand at every point."""
        depths, forces, radii = (each.tolist() for each in self.contact)
        columns = zip(self.path.time.tolist(), depths, forces, radii, follow(self, self.goals), strict=True)
        for time, depth, force, radius, (places, work, lost) in columns:
            line = self.line
            yield SpringState(
                time,
                depth,
                force,
                radius,
                self.bed,
                self.springs,
                float(places.shift[0]) if line else places.shift,
                float(places.force[0]) if line else places.force,
                self._stick_radius(radius, places),
                work,
                places.stored,
                lost,
                places.u[0] if line else places.u.T.copy(),
            )

    def _stick_radius(self, radius: float, places: SpringPlaces) -> float:
        """Return the place from which on springs slip: where what is left to the bound, drawn on, ends."""
        bound = self.bound(places.depth)
        size = np.hypot(*places.u)
        touching = int(np.count_nonzero(bound > 0.0))
        left = (bound - size)[:touching]
        slip = places.slips[:touching] if self.hold > 1.0 else left <= BOUND_TOLERANCE * bound[:touching]
        free = np.flatnonzero(slip)
        if not free.size:
            return radius
        first = int(free[0])
        if first < 2 or self.hold > 1.0:
            return float(self.springs.position[first]) if first else 0.0
        x, slope = self.springs.position, (left[first - 2] - left[first - 1])
        width = self.gap[first - 1] - self.gap[first - 2]
        part = left[first - 1] * width / (slope * (self.gap[first] - self.gap[first - 1])) if slope > 0.0 else 1.0
        return float(x[first - 1] + min(part, 1.0) * (x[first] - x[first - 1]))
