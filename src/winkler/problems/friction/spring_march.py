r"""Springs that remember: a contact that is sheared in the plane, or with a friction law of any kind, step by step.

Every spring in contact follows the bodies until it bears no more; then it slips, on a bound that the law of friction
sets: in proportion to its load (Coulomb), higher before it first slips, or by another law.  In the plane the bound is
a circle, and a spring that slips turns towards the motion.  Between two points of the path the bodies move straight,
and the springs follow that motion exactly, however far it goes.

One direction and Coulomb friction have an exact solution without any springs, `winkler.problems.friction.tangential`;
the springs agree with it to second order in their distance.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.number_checks import Whole
from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading import Depth, Force, ShearForce, Shift
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.springs.slip_pull import pull_line
from winkler.numerics.springs.spring_work import work_on_springs
from winkler.numerics.types import Array, Quantity
from winkler.path import Path
from winkler.problems.assumptions.coupling import coefficient_of, sticking_note
from winkler.problems.assumptions.declared import BALANCED, SHEARED
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.friction.spring_states import SpringLaw, SpringProblem, SpringState, spring_notes
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.stiffness_ratio import refuse_plane
from winkler.validity import Assumption, Note
from winkler.values import value, words

__all__ = ["SpringMarch", "SpringState", "SpringTrace", "march_springs"]

BLOCK = 256
"""Steps that go through the kernel together."""
UNREACHABLE_BOUND = 1e100
"""Instead of an infinite bound: so far no spring is ever displaced, and its square is still a number."""
FORCE_TOLERANCE = 1e-12
"""Relative error of a prescribed shear force in the plane."""
MOST_NEWTON_STEPS = 60
"""Steps of Newton's method."""
BOUND_TOLERANCE = 1e-9
"""A spring this close to its bound, in parts of it, slips."""


@value
class SpringTrace:
    """What springs bore and lost along a path; arrays over its points.

    Parameters
    ----------
    problem : SpringMarch
        The problem that was solved.
    depth, force, radius : ndarray, (steps,)
        d [m], F_N [N], a [m].
    shift, shear_force : ndarray, (steps,) or (steps, 2)
        u_x [m], F_x [N].
    stored_energy, dissipation : ndarray, (steps,)
        Of the tangential displacement, and lost since the beginning [J].
    """

    __words__ = words(work=("W", "J", "what the lateral motion has spent since the beginning"))

    problem: SpringMarch
    depth: Array
    force: Array
    radius: Array
    shift: Array
    shear_force: Array
    stored_energy: Array
    dissipation: Array

    @property
    def time(self) -> Array:
        """t [s], (steps,)."""
        return self.problem.path.time

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (*self.problem.validity, energy_note(self.work, self.stored_energy, self.dissipation))

    @property
    def work(self) -> Array:
        """What the lateral motion has spent since the beginning [J], (steps,): found by going the path once more."""
        return np.array([state.work for state in self.problem.steps()])


@value
class SpringMarch:
    """A contact that is pressed and sheared along a path, by a row of springs.

    Between two points depth and shift go straight.  Where forces are prescribed they are met at the points; in between
    they are those of a straight step, so give as many points as it takes.

    Parameters
    ----------
    bed : Bed
        Profile and medium.
    law : Coulomb, StaticKinetic or any law with a method shear_bound
        How the surfaces rub: `winkler.problems.friction.spring_states.OwnLaw` defines the form of a law of one's own.
    path : Path
        Depth or normal force; shift or shear force, in one direction or in the plane.
    count : int, optional
        How many springs; 400 unless given.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction in Contact Mechanics and Friction, Springer 2015, ch. 5,
    doi:10.1007/978-3-642-53876-6
    """

    bed: Bed
    law: SpringLaw
    path: Path
    count: Annotated[int, Whole(2, what="springs")] = 400

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015",)
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED | BALANCED

    def __post_init__(self) -> None:
        if not isinstance(self.path.lateral, Shift | ShearForce):
            raise InvalidInput(
                f"SpringMarch: the path's lateral load is a {type(self.path.lateral).__name__}; give Shift or "
                "ShearForce."
            )
        refuse_plane("SpringMarch", self.bed, self.path)

    def steps(self) -> Iterator[SpringState]:
        """Yield the springs at every point of the path.

        Raises
        ------
        OutsideValidity
            If a prescribed shear force is more than friction bears; what comes before is yielded.
        NotConverged
            If a shear force in the plane is not met.
        """
        run = _Run(self)
        lost = work = 0.0
        for index in range(self.path.time.size):
            before, slips = run.u.T.copy(), run.slips.copy()
            force, stored, waste = run.advance(index, index + 1)
            lost, work = lost + float(waste[0]), work + run.work(index, before, slips)
            yield run.state(index, force[0], work, float(stored[0]), lost)

    def solve(self) -> SpringTrace:
        """Return what the springs bear and lose; the same as from `steps`, faster.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps` does.
        """
        run = _Run(self)
        size = self.path.time.size
        parts = [run.advance(start, min(start + BLOCK, size)) for start in range(0, size, BLOCK)]
        force, stored, waste = (np.concatenate([part[k] for part in parts]) for k in range(3))
        return SpringTrace(
            self,
            run.depth,
            run.force,
            run.radius,
            run.shift[1:] if self.path.in_plane else run.shift[1:, 0],
            force,
            stored,
            np.cumsum(waste),
        )

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed of shape and medium, how exact the springs are, and how exact the rule is."""
        springs = _row(self, float(np.max(_contact(self)[2], initial=0.0)))
        return (
            *self.bed.notes,
            sticking_note(self.bed.medium, coefficient_of(self.law)),
            *direction_notes(self.bed),
            *spring_notes(springs, self.law, in_plane=self.path.in_plane),
        )


def march_springs(problem: SpringProblem, count: int = 400) -> Iterator[SpringState]:
    """Yield the springs of a sheared contact at every point of its path; see `SpringMarch.steps`."""
    return SpringMarch(problem.bed, problem.law, problem.path, count).steps()


def _contact(problem: SpringMarch) -> tuple[Array, Array, Array]:
    """Return depth, force and radius at every point; equal points are solved once."""
    distinct, where = np.unique(problem.path.across, return_inverse=True)
    load = Depth(distinct) if isinstance(problem.path.normal, Depth) else Force(distinct)
    contact = Indentation(problem.bed, load).solve()
    depth, force, radius = (np.asarray(q)[where] for q in (contact.depth, contact.force, contact.radius))
    return depth, force, radius


def _row(problem: SpringMarch, radius: float) -> Springs:
    """Return springs up to a radius; none if nothing touches."""
    if radius == 0.0:
        return Springs(np.zeros(0), np.zeros(0), np.zeros(0), np.zeros(0))
    return Springs.of(problem.bed, radius, problem.count)


class _Run:
    """The march itself: the springs' displacement and what drives them.

    One direction with Coulomb friction runs in a kernel of its own; everything else as motion in the plane.
    """

    def __init__(self, problem: SpringMarch) -> None:
        self.problem = problem
        self.depth, self.force, self.radius = _contact(problem)
        self.springs = springs = _row(problem, float(np.max(self.radius)))
        # the springs' own depth, at which they bear the true force: so friction sums to the coefficient times it
        own = np.where(self.force > 0.0, springs.depth(self.force), self.depth) if springs.gap.size else self.depth
        self.own = np.concatenate([own[:1], own])
        # writable copies: a kernel is compiled anew for arrays of another kind
        self.gap, self.stiffness = springs.gap.copy(), springs.tangential_stiffness
        self.line = not problem.path.in_plane
        self.driven = isinstance(problem.path.lateral, Shift)
        along = problem.path.along
        self.along = np.column_stack([along, np.zeros(along.size)]) if self.line else along
        self.shift = np.zeros((self.along.shape[0] + 1, 2))
        if self.driven:
            self.shift[1:] = self.along
        self.slope, self.hold = np.zeros(springs.gap.size), 1.0
        match problem.law:
            case Coulomb(coefficient):
                self.slope = min(coefficient, UNREACHABLE_BOUND) / springs.mindlin_ratio
            case StaticKinetic(static, kinetic):
                self.slope, self.hold = kinetic / springs.mindlin_ratio, static / kinetic
        self.plain = self.line and self.hold == 1.0 and isinstance(problem.law, Coulomb | StaticKinetic)
        self.u = np.zeros((2, springs.gap.size))
        self.slips = np.zeros(springs.gap.size, dtype=bool)

    def bound(self, start: int, end: int) -> Array:
        """Return how far slipping springs are displaced at the ends of steps, (end - start, n)."""
        pressed = np.maximum(self.own[start:end, np.newaxis] - self.gap, 0.0)
        law = self.problem.law
        if isinstance(law, Coulomb | StaticKinetic):
            return np.asarray(self.slope * pressed)
        density = self.springs.density(self.problem.bed)
        borne = np.asarray(law.shear_bound(density * pressed), dtype=float)
        if borne.shape != pressed.shape or not np.all(np.isfinite(borne)) or np.any(borne < 0.0):
            raise InvalidInput(
                f"SpringMarch: {type(law).__name__}.shear_bound must return finite loads, not negative, in the "
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
            f"shear force {shear:.6g} N at index {index} is more than friction bears there, {most:.6g} N: the bodies "
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
            f"SpringMarch: the shear force at index {index} is missed by {np.linalg.norm(left):.3g} N; give more "
            "points on the path, or a Shift."
        )

    def work(self, index: int, u: Array, slips: Array) -> float:
        """Return the work on springs that were at u, on the path to point `index` [J]."""
        depths, move = self.own[index : index + 2].tolist(), self.shift[index + 1] - self.shift[index]
        bounds = self.bound(index, index + 2)
        return float(self.stiffness @ work_on_springs(u, slips, self.gap, bounds, self.hold, tuple(depths), move))

    def state(self, index: int, force: Quantity, work: float, stored: float, lost: float) -> SpringState:
        """Return the springs as they stand after point `index`."""
        shift = self.shift[index + 1]
        line = self.line
        return SpringState(
            self.problem.bed,
            self.springs,
            float(self.problem.path.time[index]),
            float(self.depth[index]),
            float(self.force[index]),
            float(self.radius[index]),
            float(shift[0]) if line else shift.copy(),
            float(force) if line else force,
            self._stick_radius(index),
            work,
            stored,
            lost,
            self.u[0].copy() if line else self.u.T.copy(),
        )

    def _stick_radius(self, index: int) -> float:
        """Return the place from which on springs slip: where what is left to the bound, drawn on, ends."""
        bound = self.bound(index + 1, index + 2)[0]
        size = np.hypot(*self.u)
        touching = int(np.count_nonzero(bound > 0.0))
        left = (bound - size)[:touching]
        slip = self.slips[:touching] if self.hold > 1.0 else left <= BOUND_TOLERANCE * bound[:touching]
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
