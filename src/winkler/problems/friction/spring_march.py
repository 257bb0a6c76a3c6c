r"""Springs that remember: a contact that is sheared in the plane, or with a friction law of any kind, step by step.

Every spring in contact follows the bodies until it bears no more; then it slips, on a bound that the law of friction
sets: in proportion to its load (Coulomb), higher before it first slips, or by another law.  In the plane the bound is
a circle, and a spring that slips turns towards the motion.  Between two points of the path the bodies move straight,
and the springs follow that motion exactly, however far it goes.

One direction and Coulomb friction have an exact solution without any springs, `winkler.problems.friction.tangential`;
the springs agree with it to second order in their distance.
"""

from __future__ import annotations

import collections
from collections.abc import Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import ShearForce, Shift
from winkler.loading.path import Path
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import coefficient_of, sticking_note
from winkler.problems.assumptions.declared import BALANCED, SHEARED
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.assumptions.energy import energy_note
from winkler.problems.friction.spring_run import SingleSprings, pressed_along, springs_under
from winkler.problems.friction.spring_states import SpringLaw, SpringState, spring_notes
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.stiffness_ratio import refuse_plane
from winkler.values.checks.number_checks import Whole
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

__all__ = ["SpringMarch", "SpringState", "SpringTrace"]

BLOCK = 256
"""Steps that go through the kernel together."""


@value
class SpringTrace(Looped):
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
    def _loop(self) -> PathLoop:
        path = self.problem.path
        return PathLoop((path.across, path.along), self.shift, self.shear_force, self.dissipation)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        balance = energy_note(self.work, self.stored_energy, self.dissipation)
        return (*self.problem.validity, balance, *self._cycle_notes)

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

    @property
    def _row(self) -> SingleSprings:
        return SingleSprings("SpringMarch", self.bed, self.law, self.path, self.count)

    def steps(self) -> Iterator[SpringState]:
        """Yield the springs at every point of the path.

        Raises
        ------
        OutsideValidity
            If a prescribed shear force is more than friction bears; what comes before is yielded.
        NotConverged
            If a shear force in the plane is not met.
        """
        yield from self._row.states()

    def solve(self) -> SpringTrace:
        """Return what the springs bear and lose; the same as from `steps`, faster.

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps` does.
        """
        run, size = self._row, self.path.time.size
        try:
            parts = [run.advance(start, min(start + BLOCK, size)) for start in range(0, size, BLOCK)]
        except (OutsideValidity, NotConverged):
            collections.deque(self.steps(), maxlen=0)  # says at which point
            raise
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
        radius = float(np.max(pressed_along(self.bed, self.path)[2], initial=0.0))
        springs = springs_under(self.bed, radius, self.count)
        return (
            *self.bed.notes,
            sticking_note(self.bed.medium, coefficient_of(self.law)),
            *direction_notes(self.bed),
            *spring_notes(springs, self.law, in_plane=self.path.in_plane),
        )
