r"""The whole curve of equilibrium of an adhesive contact: stable or not, with every branch and every jump.

Depth and force are explicit functions of the contact radius; the curve is drawn by running through it.  A machine holds
only the branches on which its position grows with the radius; at the ends of a branch the edge of the contact runs on,
at the position of the machine, to the next radius that is stable there, or the contact is lost.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import AdhesionLaw
from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import EdgeStates, force_under, position
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.pull_off import MachineStiffness
from winkler.problems.adhesion.stability import Branch, branches
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.assumptions.declared import ADHESIVE
from winkler.problems.normal.solve_contact import end_of
from winkler.values.checks.number_checks import Advice, Positive, Whole
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

LEAST_STATES, MOST_STATES = 2, 1_000_000


@value
class Equilibrium:
    """All states of equilibrium of an adhesive contact up to a given radius.

    Parameters
    ----------
    bed : Bed
    law : ShortRange, Dugdale or DerjaguinMullerToporov
    reach : float
        The maximum contact radius [m]; not beyond the known range of the profile.
    machine_stiffness : float, optional
        Machine stiffness that decides stability [N/m]: 0 for a dead load, inf for fixed grips (the default).
    count : int, optional
        Number of points of the curve; kinks of the profile and limits of stability are added.

    Raises
    ------
    InvalidInput
        If a number is of the wrong sign or kind.
    OutsideValidity
        If the reach exceeds that of the profile.

    References
    ----------
    P. R. Guduru, J. Mech. Phys. Solids 55 (2007) 445-472, doi:10.1016/j.jmps.2006.09.007

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.adhesion import ShortRange
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1e-3), HalfSpace.between(Elastic(1e6, 0.5)))
    >>> curve = Equilibrium(bed, ShortRange(0.05), reach=2e-4).solve()
    >>> len(curve.branches), round(curve.branches[0].start * 1e6, 3)  # (pi R^2 w / (8 E*))^(1/3) in micrometres
    (1, 24.511)
    """

    __words__ = words(reach=("a_{max}", "m", "greatest contact radius of the curve"))

    bed: Bed
    law: AdhesionLaw
    reach: Annotated[Positive, Advice("the greatest contact radius")]
    machine_stiffness: MachineStiffness = math.inf
    count: Annotated[int, Whole(LEAST_STATES, MOST_STATES)] = 1000

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "johnson_kendall_roberts_1971", "guduru_2007")
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def __post_init__(self) -> None:
        end = end_of(self.bed)
        if self.reach > end:
            raise OutsideValidity(
                f"Equilibrium: reach {self.reach:.6g} m is beyond the end of the profile ({end:.6g} m); give at most "
                "that."
            )

    def solve(self) -> EquilibriumCurve:
        """Return the curve and its stable branches.

        Returns
        -------
        EquilibriumCurve

        Raises
        ------
        OutsideValidity
            If the law does not hold for the bed, or the profile has more waves than can be resolved.
        """
        states = states_of(self.bed, self.law)
        branches_ = branches(states, self.machine_stiffness, self.reach)
        limits = [radius for branch in branches_ for radius in branch]
        kinks = [b for b, _ in self.bed.kinks if b < self.reach]
        # d and F leave the origin with the root of the radius: steps that grow show it
        radius = np.unique(np.concatenate([self.reach * np.linspace(0.0, 1.0, self.count) ** 2, limits, kinks]))
        depth = states.depth(radius)
        starts, stops = (np.array(ends) for ends in zip(*branches_, strict=True)) if branches_ else (np.zeros(0),) * 2
        return EquilibriumCurve(self, radius, depth, force_under(states, depth, radius), starts, stops)


@value
class AdhesiveBranch:
    """A stretch of stable contact radii.

    Parameters
    ----------
    start, stop : float
        From which to which radius [m].
    start_depth, stop_depth : float
        d [m] there.
    start_force, stop_force : float
        F_N [N] there.
    """

    start: float
    stop: float
    start_depth: float
    stop_depth: float
    start_force: float
    stop_force: float


@value
class EquilibriumJump:
    """The edge of a contact runs from one radius to another while the machine stands still.

    Parameters
    ----------
    start, stop : float
        Contact radius before and after [m]; zero after: the contact is lost.
    start_depth, stop_depth : float
        d [m] before and after; after a loss, that of bodies which do not touch.
    start_force, stop_force : float
        F_N [N] before and after.
    """

    start: float
    stop: float
    start_depth: float
    stop_depth: float
    start_force: float
    stop_force: float


@value
class EquilibriumCurve:
    """The solution of `Equilibrium`.

    Parameters
    ----------
    problem : Equilibrium
        The problem that was solved.
    radius, depth, force : ndarray, (n,)
        a [m], d [m] and F_N [N] along the curve, by rising radius.
    starts, stops : ndarray, (branches,)
        Contact radii [m] where stable branches begin and end.
    """

    problem: Equilibrium
    radius: Array
    depth: Array
    force: Array
    starts: Array
    stops: Array

    other_axes: ClassVar[tuple[str, ...]] = ("starts", "stops")

    @property
    def stable(self) -> Array:
        """Which points are stable with the given machine stiffness, limits included, bool ``(n,)``."""
        inside = (self.radius[:, None] >= self.starts) & (self.radius[:, None] <= self.stops)
        return np.asarray(np.any(inside, axis=1))

    @property
    def branches(self) -> tuple[AdhesiveBranch, ...]:
        """The stable branches, by rising radius."""
        states = states_of(self.problem.bed, self.problem.law)
        return tuple(
            AdhesiveBranch(*_ends(states, start, stop)) for start, stop in zip(self.starts, self.stops, strict=True)
        )

    @property
    def jumps(self) -> tuple[EquilibriumJump, ...]:
        """Jumps of the contact edge from the ends of stable branches, first during pull-off, then during loading.

        The end of the curve and the first contact on loading are not listed as jumps.
        """
        problem = self.problem
        states, machine = states_of(problem.bed, problem.law), problem.machine_stiffness
        branches_ = [Branch(float(a), float(b)) for a, b in zip(self.starts, self.stops, strict=True)]
        inward = [
            _jump(states, machine, branch.start, branches_[:index], True) for index, branch in enumerate(branches_)
        ]
        outward = [
            _jump(states, machine, branch.stop, branches_[index + 1 :], False)
            for index, branch in enumerate(branches_[:-1])
            if branch.stop < branches_[index + 1].start
        ]
        return tuple(jump for jump in [*reversed(inward), *outward] if jump is not None)

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed, and how large the slopes are within the widest contact."""
        return adhesive_notes(self.problem.bed, self.problem.law, self.depth, self.radius)


def _ends(states: EdgeStates, start: float, stop: float) -> tuple[float, float, float, float, float, float]:
    radius = np.array([start, stop])
    depth = states.depth(radius)
    force = force_under(states, depth, radius)
    return start, stop, float(depth[0]), float(depth[1]), float(force[0]), float(force[1])


def _jump(
    states: EdgeStates, machine: float, radius: float, others: list[Branch], inward: bool
) -> EquilibriumJump | None:
    """Return the jump from the end of a branch to the nearest of the others that is stable there."""
    level = float(position(states, machine, np.array([radius]))[0])
    for branch in reversed(others) if inward else others:
        low, high = position(states, machine, np.array(branch))
        if low <= level <= high:
            target = branch.start
            if low < high:
                ends = (np.array([end]) for end in branch)
                target = float(between(lambda a, _: position(states, machine, a) - level, *ends)[0])
            return EquilibriumJump(*_ends(states, radius, target))
    if not inward or radius == 0.0:
        return None  # it runs on beyond the curve, or shrinks to a point without a jump
    start, _, depth, _, force, _ = _ends(states, radius, radius)
    apart = level if math.isinf(machine) else -math.inf if machine == 0.0 else level / machine
    return EquilibriumJump(start, 0.0, depth, apart, force, level if machine == 0.0 else 0.0)
