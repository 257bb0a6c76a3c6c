"""Springs one by one as a row: how far each is displaced along a path, and what drives it."""

from __future__ import annotations

import collections
import functools
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, slipping_springs
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path
from winkler.numerics.springs.slip_history import follow_line, follow_plane
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.types import Array, Quantity
from winkler.problems.friction.slip_stack import SlipGoal, refuse
from winkler.problems.friction.spring_states import SpringLaw, SpringState
from winkler.problems.friction.tangential_march import PressedRow
from winkler.problems.normal.indentation import Indentation
from winkler.problems.row import Reached, follow, over
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

UNREACHABLE_BOUND = 1e100
"""Instead of an infinite bound: so far no spring is ever displaced, and its square is still a number."""
FORCE_TOLERANCE = 1e-12
"""Relative error of a prescribed shear force in the plane."""
MOST_NEWTON_STEPS = 60
"""Steps of Newton's method."""
ENERGIES = "work", "stored_energy", "dissipation"
BLOCK = 256
"""Steps that go through a kernel together."""


class SpringPlaces(NamedTuple):
    """What springs remember: u_t [m] ``(2, n)``, whether they slip, their depth and the shift of the bodies [m].

    `force` and `stored` are what they bear along the surface [N] ``(2,)`` and store [J]; up to the radius `stuck` [m]
    none slips, infinity where none does at all.
    """

    u: Array
    slips: Array
    depth: float
    shift: Array
    force: Array
    stored: float
    stuck: float


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
        self.own = np.asarray(own, dtype=float)
        self.line, along = not path.in_plane, path.along
        self.along = np.column_stack([along, np.zeros(along.size)]) if self.line else along
        super().__init__(path)
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
        deepest = self.bound(np.max(self.own))
        self._allow(float(np.sum(self.stiffness[deepest > 0.0])), float(np.max(deepest, initial=0.0)))

    @functools.cached_property
    def goals(self) -> list[SlipGoal]:
        """What is prescribed at the points of the path."""
        return [SlipGoal(*row) for row in zip(self.own.tolist(), self.contact[1].tolist(), self.along, strict=True)]

    def straight(self) -> bool:
        """Return whether no step is bent by a prescribed force, so that whole blocks of steps go through one kernel."""
        return (self.driven or self.plain) and self.unbent(self.own, self.along)

    def fresh(self, depth: float) -> SpringPlaces:
        """Return springs that are pressed to a depth, and have not been moved."""
        count, none = self.gap.size, np.zeros(2)
        return SpringPlaces(np.zeros((2, count)), np.zeros(count, dtype=bool), depth, none, none, 0.0, np.inf)

    def begin(self, goal: SlipGoal) -> Reached[SpringPlaces]:
        """Return the springs at the first point, pressed straight down and moved after."""
        return self.step(self.fresh(goal.depth), goal)

    def step(self, state: SpringPlaces, goal: SlipGoal) -> Reached[SpringPlaces]:
        """Return the springs after a straight step, to a shift or to a shear force."""
        places, _, _, (_, lost, work, _) = self._march(state, np.array([goal.depth]), goal.along[np.newaxis])
        return Reached(places, float(work[0]), float(lost[0]))

    def _march(self, state: SpringPlaces, depths: Array, along: Array) -> tuple[SpringPlaces, Array, Array, Array]:
        """Go straight steps; return where they end, and of each of them shift, shear force, and `sums` of the kernel.

        To shear forces in the plane it is one step.
        """
        u, slips, own, size = state.u.copy(), state.slips.copy(), np.append(state.depth, depths), depths.size
        shift, force, sums = np.vstack([state.shift, along]), np.zeros((size, 2)), np.zeros((4, size))
        fixed = u, slips, self.gap, self.stiffness
        if self.plain:
            line, load, target = shift[:, 0].copy(), np.zeros(size), along[: 0 if self.driven else size, 0].copy()
            done = follow_line(*fixed, self.slope, self.springs.position, own, target, line, load, sums)
            if done < size:
                self._refuse(along[done], self.bound(own[done + 1]))
            shift[:, 0], force[:, 0] = line, load
        else:
            bounds = self.bound(own)
            if not self.driven:
                shift[1] = self._found(state, own, along[0], bounds)
            follow_plane(*fixed, bounds, self.hold, self.springs.position, own, shift, force, sums)
        places = SpringPlaces(u, slips, float(own[-1]), shift[-1], force[-1], float(sums[0, -1]), float(sums[3, -1]))
        return places, shift[1:], force, sums

    def apart(self, one: Reached[SpringPlaces], two: Reached[SpringPlaces]) -> float:
        """Return by how much displacements and losses differ, over a small part of those on the path."""
        (here, there), (near, cheap) = (one.state, two.state), self.allowed
        moved = float(np.max(np.abs(here.u - there.u), initial=0.0)), float(np.max(np.abs(here.shift - there.shift)))
        return max(over(max(moved), near), over(abs(one.lost - two.lost), cheap))

    def force_at(self, depth: float) -> float:
        """Return as `PressedRow.force_at`."""
        return self.springs.force(depth)

    def bound(self, depth: Array) -> Array:
        """Return how far slipping springs are displaced at depths [m], ``(..., n)``; zero out of contact."""
        pressed, law = np.maximum(depth[..., np.newaxis] - self.gap, 0.0), self.law
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

    def _refuse(self, along: Array, bound: Array) -> None:
        refuse(float(np.linalg.norm(along)), self.hold * float(self.stiffness @ bound))

    def _found(self, state: SpringPlaces, own: Array, target: Array, bounds: Array) -> Array:
        """Return the shift in the plane that gives a force, by Broyden's method from the stiffness of stuck springs."""
        start = state.shift
        size = float(np.linalg.norm(target))
        if size > self.hold * float(self.stiffness @ bounds[1]) * (1.0 + FORCE_TOLERANCE):
            self._refuse(target, bounds[1])
        stuck = float(self.stiffness @ (bounds[1] > 0.0))
        if stuck == 0.0:
            return start
        scale = size + float(self.stiffness @ np.hypot(*state.u))
        ends = np.vstack([start, start])
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

    def history(self) -> tuple[dict[str, Array], SpringState]:
        """Return what the springs are at every point of a straight path, by the name of the quantity, and at the last.

        Raises
        ------
        OutsideValidity
            If friction does not bear a prescribed shear force.
        """
        places, parts, size = self.fresh(float(self.own[0])), [], self.own.size
        try:
            for start in range(0, size, BLOCK):
                cut = slice(start, start + BLOCK)
                places, shift, force, sums = self._march(places, self.own[cut], self.along[cut])
                parts.append((shift, force, sums.T))
        except OutsideValidity:
            collections.deque(follow(self, self.goals), maxlen=0)  # says at which point
            raise
        shift, force, sums = (np.concatenate(part) for part in zip(*parts, strict=True))
        stored, lost, work, stuck = sums.T
        numbers = self._numbers(slice(None), shift, force, stuck, np.cumsum(work), stored, np.cumsum(lost))
        return numbers, self._state(places, {name: column[-1] for name, column in numbers.items()})

    def states(self) -> Iterator[SpringState]:
        """Yield the springs as they stand at every point."""
        for point, (places, work, lost) in enumerate(follow(self, self.goals)):
            along = places.shift, places.force, places.stuck
            yield self._state(places, self._numbers(point, *along, work, places.stored, lost))

    def _numbers(
        self, points: int | slice, shift: Array, force: Array, stuck: Quantity, *energies: Quantity
    ) -> dict[str, Any]:
        """Return the numbers of a state, or of all; energies are work, stored and lost [J]."""
        depth, pressing, radius = (each[points] for each in self.contact)
        numbers = self.path.time[points], depth, pressing, radius
        along = (shift[..., 0], force[..., 0]) if self.line else (shift, force)
        names = "time", "depth", "force", "radius", "shift", "shear_force", "stick_radius", *ENERGIES
        return dict(zip(names, (*numbers, *along, np.minimum(stuck, radius), *energies), strict=True))

    def _state(self, places: SpringPlaces, numbers: dict[str, Any]) -> SpringState:
        displacement = places.u[0] if self.line else places.u.T.copy()
        return SpringState(bed=self.bed, springs=self.springs, displacement=displacement, **numbers)
