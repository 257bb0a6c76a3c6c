r"""Normal contact with adhesion: any profile on any medium, under a force, at a depth, or with a contact radius.

Of the states of equilibrium (`winkler.problems.adhesion.edge_states`) a dead load keeps those whose force grows with
the radius, fixed grips those whose depth does.  Where several are stable, the widest is meant: the one that is left
after pressing firmly.  At a rim the edge is held, and depth and force grow with :math:`\mathrm dF = k\,\mathrm dd`.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.laws.adhesion import AdhesionLaw, ShortRange
from winkler.loading.loads import Depth, Force, Radius
from winkler.loading.path import load_number
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PowerOfDepth, PressedWaves, offers
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, PerLoad, Q, like
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.edge_states import EdgeStates, depth_under, force_under, margin
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.pull_off import PullOff, PullOffSolution
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.adhesion.widest_contact import stable_counts, widest
from winkler.problems.assumptions.declared import ADHESIVE
from winkler.problems.normal.solve_contact import at_end, end_of
from winkler.problems.one_load import picked, single
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

FIXED_GRIPS, DEAD_LOAD = float("inf"), 0.0


@value
class AdhesiveIndentation(PerLoad[Q]):
    """An adhesive body pressed into another one or pulled off it.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) on any medium, or another bed.
    law : ShortRange, Dugdale or DerjaguinMullerToporov
        Law of attraction between the surfaces; with hysteresis, the work of opening is used.
    load : Force, Depth or Radius
        A force is a dead load, a depth means fixed grips. For an array the results have its shape.

    References
    ----------
    K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301-313, doi:10.1098/rspa.1971.0141;
    D. Maugis, J. Colloid Interface Sci. 150 (1992) 243-269, doi:10.1016/0021-9797(92)90285-T

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> rubber = HalfSpace.between(Elastic(young=1e6, poisson=0.5))
    >>> contact = AdhesiveIndentation(Foundation(Paraboloid(1e-3), rubber), ShortRange(0.05), Force(0.0)).solve()
    >>> round(contact.radius * 1e6, 4)  # (9 pi R^2 w / (2 E*))^(1/3) in micrometres
    80.934
    """

    bed: Bed
    law: AdhesionLaw
    load: Force[Q] | Depth[Q] | Radius[Q]

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "johnson_kendall_roberts_1971", "maugis_1992")
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def solve(self) -> AdhesiveSolution[Q]:
        """Return depth, force, radius, and whether the state is stable.

        Returns
        -------
        AdhesiveSolution

        Raises
        ------
        OutsideValidity
            If a load is below the pull-off force (the message names it and the indices) or beyond the reach of the
            profile. If the law is not valid for this foundation.
        """
        states = states_of(self.bed, self.law)
        given: Q = load_number(self.load)  # type: ignore[assignment]
        prescribed = np.asarray(given, dtype=float)
        flat = prescribed.ravel()
        match self.load:
            case Depth():
                radius = widest(states, FIXED_GRIPS, flat, "depth", "m")
                results = flat, force_under(states, flat, radius), radius
                stable = np.ones(flat.shape, dtype=bool)
            case Force():
                radius = widest(states, DEAD_LOAD, flat, "force", "N")
                results = depth_under(states, flat, radius), flat, radius
                stable = np.ones(flat.shape, dtype=bool)
            case _:
                depth, force, radius, stable = _at_radius(states, flat)
                results = depth, force, radius
        held = stable.reshape(prescribed.shape) if prescribed.ndim else bool(stable[0])
        d, f, a = (like(part, given) for part in results)
        return AdhesiveSolution(self, d, f, a, held)


def _at_radius(states: EdgeStates, radius: Array) -> tuple[Array, Array, Array, Array]:
    """Return the equilibria of given radii; stable under a dead load or not."""
    end = end_of(states.bed)
    beyond = radius > end
    if np.any(radius == end) and not np.isfinite(at_end(states.bed)[0]):
        beyond |= radius == end
    if beyond.any():
        wall = "the rim of the body" if states.bed.rim <= states.bed.reach else "the reach of the profile"
        raise OutsideValidity(f"radius {radius[beyond][0]:.6g} m is beyond {wall} ({end:.6g} m); give a smaller one.")
    depth = states.depth(radius)
    stable = np.full(radius.shape, states.from_nothing())
    inner = (radius > 0.0) & (radius < states.bed.rim)
    if inner.any():
        stable[inner] = margin(states, DEAD_LOAD, radius[inner]) >= 0.0
    stable[radius == states.bed.rim] = True
    return depth, force_under(states, depth, radius), radius.copy(), stable


@value
class AdhesiveSolution(PerLoad[Q]):
    """The solution of an `AdhesiveIndentation`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : AdhesiveIndentation
        The problem that was solved.
    depth : float or ndarray
        d [m], approach positive.
    force : float or ndarray
        F_N [N], compression positive.
    radius : float or ndarray
        a [m].
    stable : bool or ndarray
        Whether the state is stable under control of its load; for a prescribed radius, stability under a dead load.
    """

    problem: AdhesiveIndentation[Q]
    depth: Q
    force: Q
    radius: Q
    stable: bool | Array

    per_load: ClassVar[str] = "depth"

    @property
    def _states(self) -> EdgeStates:
        return states_of(self.problem.bed, self.problem.law)

    @property
    def energy_release_rate(self) -> Q:
        """G [J/m^2] at the edge: the work of adhesion for a free edge, less for an edge at a rim."""
        law = self.problem.law
        if isinstance(law, ShortRange):
            depth, radius = np.asarray(self.depth), np.asarray(self.radius)
            return like(griffith.energy_release_rate(self.problem.bed, depth, radius), self.depth)
        return like(np.full(np.shape(self.depth), law.work), self.depth)

    @property
    def stress_intensity(self) -> Q:
        """K_I = sqrt(2 E* G) [Pa m^(1/2)] of the tension at the edge; zero under laws with a range.

        E* is that of the surface: of the uppermost layer, where there are layers. Raises `OutsideValidity` for moduli
        that vanish at the surface, whose tension is singular with another power.
        """
        if not isinstance(self.problem.law, ShortRange):
            return like(np.zeros(np.shape(self.depth)), self.depth)
        medium = self.problem.bed.medium
        if offers(medium, PowerOfDepth) and medium.exponent != 0.0:
            raise OutsideValidity(
                f"stress_intensity: on a modulus that grows with the power {medium.exponent:g} of the depth the "
                f"tension at the edge is singular with the power {0.5 * (medium.exponent - 1.0):g}, not -1/2; use "
                "energy_release_rate, which is meant the same on every medium."
            )
        if isinstance(medium, HomogeneousMedium) or offers(medium, PressedWaves) or offers(medium, PowerOfDepth):
            return like(np.sqrt(2.0 * medium.modulus * np.asarray(self.energy_release_rate)), self.depth)
        raise OutsideValidity(
            f"stress_intensity: the surface modulus of a {type(medium).__name__} is not known; use energy_release_rate."
        )

    @property
    def stiffness(self) -> Q:
        """dF/dd along the equilibria [N/m]: k(a) for an edge at a rim, infinite where the depth is stationary."""
        bed, radius = self.problem.bed, np.ravel(self.radius)
        result = np.array(bed.stiffness(radius), dtype=float)
        free = (radius > 0.0) & (radius < bed.rim)
        if free.any():
            depth, force = self._states.slopes(radius[free])
            result[free] = np.where(depth != 0.0, force / np.where(depth != 0.0, depth, 1.0), np.inf)
        return like(result, self.depth)

    @property
    def energy(self) -> Q:
        """Elastic energy U [J], without the surface energy (-work pi a^2 for an attraction without range)."""
        states = self._states
        parts = [
            _elastic_energy(states.pressed(float(d), float(a))) if a > 0.0 else 0.0
            for d, a in zip(np.ravel(self.depth), np.ravel(self.radius), strict=True)
        ]
        return like(np.array(parts), self.depth)

    @property
    def pull_off(self) -> PullOffSolution:
        """The point at which the contact separates under a dead load."""
        return PullOff(self.problem.bed, self.problem.law).solve()

    @property
    def pressed(self) -> PressedSprings:
        """The displacement of the springs, for computing fields; available for one load, not for an array."""
        return self._states.pressed(single(self.depth, "fields"), float(self.radius))

    def at(self, index: int | tuple[int, ...]) -> AdhesiveSolution[float]:
        """Return the solution of one load of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such load.
        """
        load, depth, force, radius = picked(self.problem.load, index, self.depth, self.force, self.radius)
        stable = bool(np.asarray(self.stable)[index])
        problem = AdhesiveIndentation(self.problem.bed, self.problem.law, load)
        return AdhesiveSolution(problem, depth, force, radius, stable)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the law's range, slopes, size of the body, other stable states."""
        problem = self.problem
        notes = adhesive_notes(problem.bed, problem.law, np.ravel(self.depth), np.ravel(self.radius))
        match problem.load:
            case Force():
                count = stable_counts(self._states, DEAD_LOAD, np.ravel(self.force))
            case Depth():
                count = stable_counts(self._states, FIXED_GRIPS, np.ravel(self.depth))
            case _:
                return notes
        if int(np.max(count)) < 2:
            return notes
        return (
            *notes,
            Note(
                Assumption.EQUILIBRIUM,
                Standing.EXACT,
                f"Up to {int(np.max(count))} contact radii are stable under one load. The largest is returned, "
                "which remains after firm pressing. AdhesiveCycle follows a load history.",
                "all limits of stability along the states of equilibrium",
            ),
        )


def _elastic_energy(pressed: PressedSprings) -> float:
    """Return half the integral of k' u^2 [J] over compressed and pulled springs."""
    bed = pressed.bed

    def density(x: Array) -> Array:
        return np.asarray(bed.normal_stiffness(x) * pressed.value(x) ** 2)

    return float(abel.integral(density, [b for b, _ in pressed.kinks], np.array(pressed.radius)))
