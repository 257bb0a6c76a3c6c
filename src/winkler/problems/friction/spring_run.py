"""Springs one by one as a row: how far each is displaced along a path, and what drives it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, slipping_springs
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Depth, Force, Shift
from winkler.loading.path import Path
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.springs.slip_pull import pull_line
from winkler.numerics.springs.spring_work import work_on_springs
from winkler.numerics.types import Array, Quantity
from winkler.problems.friction.spring_states import SpringLaw, SpringState
from winkler.problems.normal.indentation import Indentation
from winkler.problems.row import Reached, Row, follow
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

__all__ = ["SingleSprings", "SpringPlaces", "pressed_along", "springs_under"]

UNREACHABLE_BOUND = 1e100
"""Instead of an infinite bound: so far no spring is ever displaced, and its square is still a number."""
FORCE_TOLERANCE = 1e-12
"""Relative error of a prescribed shear force in the plane."""
MOST_NEWTON_STEPS = 60
"""Steps of Newton's method."""
BOUND_TOLERANCE = 1e-9
"""A spring this close to its bound, in parts of it, slips."""


def pressed_along(bed: Bed, path: Path) -> tuple[Array, Array, Array]:
    """Return depth, force and radius at every point; equal points are solved once."""
    distinct, where = np.unique(path.across, return_inverse=True)
    load = Depth(distinct) if isinstance(path.normal, Depth) else Force(distinct)
    contact = Indentation(bed, load).solve()
    depth, force, radius = (np.asarray(q)[where] for q in (contact.depth, contact.force, contact.radius))
    return depth, force, radius


def springs_under(bed: Bed, radius: float, count: int) -> Springs:
    """Return springs up to a radius; none if nothing touches."""
    if radius == 0.0:
        return Springs(np.zeros(0), np.zeros(0), np.zeros(0), np.zeros(0))
    return Springs.of(slipping_springs(bed), radius, count)


class SpringPlaces(NamedTuple):
    """What springs remember: u_t [m] ``(2, n)``, whether they slip, and the shift of the bodies [m] ``(2,)``.

    `force` and `stored` are what they bear [N] and store [J].
    """

    u: Array
    slips: Array
    shift: Array
    force: Quantity
    stored: float


class SingleSprings(Row[int, SpringPlaces]):
    """The springs under a path one by one: how far each is displaced, and what drives them.

    Goals are the points of the path: a step between two of them is straight, and never halved.  One direction with
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
        self.depth, self.force, self.radius = pressed_along(bed, path)
        self.springs = springs = springs_under(bed, float(np.max(self.radius)), count)
        # the springs' own depth, at which they bear the true force: so friction sums to the coefficient times it
        own = np.where(self.force > 0.0, springs.depth(self.force), self.depth) if springs.gap.size else self.depth
        self.own = np.concatenate([own[:1], own])
        # writable copies: a kernel is compiled anew for arrays of another kind
        self.gap, self.stiffness = springs.gap.copy(), springs.tangential_stiffness
        self.line = not path.in_plane
        self.driven = isinstance(path.lateral, Shift)
        along = path.along
        self.along = np.column_stack([along, np.zeros(along.size)]) if self.line else along
        self.shift = np.zeros((self.along.shape[0] + 1, 2))
        if self.driven:
            self.shift[1:] = self.along
        self.slope, self.hold = np.zeros(springs.gap.size), 1.0
        match law:
            case Coulomb(coefficient):
                self.slope = min(coefficient, UNREACHABLE_BOUND) / springs.mindlin_ratio
            case StaticKinetic(static, kinetic):
                self.slope, self.hold = kinetic / springs.mindlin_ratio, static / kinetic
        self.plain = self.line and self.hold == 1.0 and isinstance(law, Coulomb | StaticKinetic)
        self.u = np.zeros((2, springs.gap.size))
        self.slips = np.zeros(springs.gap.size, dtype=bool)

    def begin(self, goal: int) -> Reached[SpringPlaces]:
        """Return the springs at the first point, pressed straight down and moved after."""
        return self.step(SpringPlaces(np.zeros_like(self.u), np.zeros_like(self.slips), np.zeros(2), 0.0, 0.0), goal)

    def step(self, state: SpringPlaces, goal: int) -> Reached[SpringPlaces]:
        """Return the springs at the next point."""
        self.u[:], self.slips[:], self.shift[goal] = state.u, state.slips, state.shift
        force, stored, lost = self.advance(goal, goal + 1)
        work = self._work(goal, state.u.T, state.slips)
        shift = self.shift[goal + 1].copy()
        places = SpringPlaces(self.u.copy(), self.slips.copy(), shift, force[0], float(stored[0]))
        return Reached(places, work, float(lost[0]))

    def bound(self, start: int, end: int) -> Array:
        """Return how far slipping springs are displaced at the ends of steps, (end - start, n)."""
        pressed = np.maximum(self.own[start:end, np.newaxis] - self.gap, 0.0)
        law = self.law
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

    def advance(self, start: int, end: int) -> tuple[Array, Array, Array]:
        """Go from point `start` - 1 to `end` - 1; return shear force, stored energy and loss of every step."""
        steps = end - start
        stored, lost = np.zeros(steps), np.zeros(steps)
        if self.plain:
            return self._advance_line(start, end, np.zeros(steps), stored, lost), stored, lost
        force = np.zeros((steps, 2))
        bound = self.bound(start, end + 1)
        for t in () if self.driven else range(steps):
            one = slice(t, t + 1)
            self._find(start + t, bound[t : t + 2])
            self._go(start + t, bound[t : t + 2], force[one], stored[one], lost[one])
        if self.driven:
            self._go(start, bound, force, stored, lost)
        return force[:, 0] if self.line else force, stored, lost

    def _advance_line(self, start: int, end: int, force: Array, stored: Array, lost: Array) -> Array:
        u = self.u[0]
        fixed = self.gap, self.stiffness, self.slope, self.own[start : end + 1]
        shift = self.shift[start : end + 1, 0].copy()
        if self.driven:
            march_line(u, *fixed, shift, force, stored, lost)
            return force
        done = pull_line(u, *fixed, self.along[start:end, 0].copy(), shift, force, stored, lost)
        self.shift[start : end + 1, 0] = shift
        if done < end - start:
            self._refuse(start + done)
        return force

    def _go(self, start: int, bound: Array, force: Array, stored: Array, lost: Array) -> None:
        end = start + stored.size + 1
        own, shift = self.own[start:end], self.shift[start:end]
        march_plane(self.u, self.slips, self.gap, self.stiffness, bound, self.hold, own, shift, force, stored, lost)

    def _refuse(self, index: int) -> None:
        shear = float(np.linalg.norm(self.along[index]))
        most = self.hold * float(self.stiffness @ self.bound(index + 1, index + 2)[0])
        raise OutsideValidity(
            f"a shear force of {shear:.6g} N is prescribed where friction bears {most:.6g} N at most, and the bodies "
            "would slide away; give a smaller one, or a Shift."
        )

    def _find(self, index: int, bound: Array) -> None:
        """Find the shift in the plane that gives a force, by Broyden's method from the stiffness of stuck springs."""
        target, start = self.along[index], self.shift[index]
        size = float(np.linalg.norm(target))
        if size > self.hold * float(self.stiffness @ bound[1]) * (1.0 + FORCE_TOLERANCE):
            self._refuse(index)
        stuck = float(self.stiffness @ (bound[1] > 0.0))
        self.shift[index + 1] = start
        if stuck == 0.0:
            return
        scale = size + float(self.stiffness @ np.hypot(*self.u))
        own, ends = self.own[index : index + 2], np.vstack([start, start])
        u, slips, pull, rest = self.u.copy(), self.slips.copy(), np.zeros((1, 2)), np.zeros((2, 1))

        def short(at: Array) -> Array:
            u[:], slips[:], ends[1] = self.u, self.slips, at
            march_plane(u, slips, self.gap, self.stiffness, bound, self.hold, own, ends, pull, rest[0], rest[1])
            return np.asarray(target - pull[0])

        at, left, rise = start.copy(), short(start), stuck * np.eye(2)
        for _ in range(MOST_NEWTON_STEPS):
            missed = float(np.linalg.norm(left))
            if missed <= FORCE_TOLERANCE * scale:
                self.shift[index + 1] = at
                return
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

    def _work(self, index: int, u: Array, slips: Array) -> float:
        """Return the work on springs that were at u, on the path to point `index` [J]."""
        depths, move = self.own[index : index + 2].tolist(), self.shift[index + 1] - self.shift[index]
        bounds = self.bound(index, index + 2)
        return float(self.stiffness @ work_on_springs(u, slips, self.gap, bounds, self.hold, tuple(depths), move))

    def states(self) -> Iterator[SpringState]:
        """Yield the springs as they stand at every point."""
        for index, (places, work, lost) in enumerate(follow(self, range(self.path.time.size))):
            line = self.line
            yield SpringState(
                float(self.path.time[index]),
                float(self.depth[index]),
                float(self.force[index]),
                float(self.radius[index]),
                self.bed,
                self.springs,
                float(places.shift[0]) if line else places.shift,
                float(places.force) if line else places.force,
                self._stick_radius(index, places),
                work,
                places.stored,
                lost,
                places.u[0] if line else places.u.T.copy(),
            )

    def _stick_radius(self, index: int, places: SpringPlaces) -> float:
        """Return the place from which on springs slip: where what is left to the bound, drawn on, ends."""
        bound = self.bound(index + 1, index + 2)[0]
        size = np.hypot(*places.u)
        touching = int(np.count_nonzero(bound > 0.0))
        left = (bound - size)[:touching]
        slip = places.slips[:touching] if self.hold > 1.0 else left <= BOUND_TOLERANCE * bound[:touching]
        free = np.flatnonzero(slip)
        if not free.size:
            return float(self.radius[index])
        first = int(free[0])
        if first < 2 or self.hold > 1.0:
            return float(self.springs.position[first]) if first else 0.0
        x, slope = self.springs.position, (left[first - 2] - left[first - 1])
        width = self.gap[first - 1] - self.gap[first - 2]
        part = left[first - 1] * width / (slope * (self.gap[first] - self.gap[first - 1])) if slope > 0.0 else 1.0
        return float(x[first - 1] + min(part, 1.0) * (x[first] - x[first - 1]))
