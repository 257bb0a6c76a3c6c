r"""Springs of a height map under friction, and how far they are from boundary elements with friction.

The springs know the normal contact of each depth and its stiffness along x and along y.  Under a steady depth they take
what slips to leave a contact of less depth,

.. math:: F_x = \mu\,(F_N - F_N^*), \qquad u_x = \mu\int_{d^*}^{d}\frac{k}{K_x}\,\mathrm dd',

with tractions along the shear alone (Ciavarella, Jaeger).  The boundary elements leave both open.  Both run through the
same loop of the shear force, along x and along y, at a depth that stays; the greatest differences are stated with the
springs.  Where the normal force changed as well, shifts of a ball and of ellipses stayed within them, losses within
three times as much.
"""

from __future__ import annotations

import dataclasses
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.directional import DirectionalBed
from winkler.laws.friction import Sliding
from winkler.loading.loads import Depth, ShearForce
from winkler.loading.path import Path
from winkler.media.mapped import MappedMedium
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.friction.tangential import Tangential, TangentialSolution
from winkler.problems.normal.indentation import Indentation
from winkler.problems.rough.reduce import Reduction, ReductionSolution
from winkler.problems.surface_friction.joint_loops import loop_difference
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, Positive, between
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

SHARES = (0.0, 0.25, 0.5, 0.75, 0.9, 0.45, 0.0, -0.5, -0.9)
"""Shear forces at which both are compared, over what friction bears."""

BETWEEN = 1.1
"""Differences at other shear forces than those compared, over the greatest there."""
LOSS_POWER = 3.0
"""Of the shear force, with which losses begin to grow."""


@value
class ReducedFriction:
    """Computation of a spring foundation that represents a height map under friction, with its error.

    Parameters
    ----------
    topography : Topography
        A non-periodic map.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace or DepthGradedHalfSpace
        Both bodies.
    law : Coulomb
        Law of friction.
    depth : float
        Maximum depth d [m] of the springs, at which they are compared with boundary elements.
    tolerance : float, optional
        As in `Reduction`.

    Raises
    ------
    InvalidInput
        As `Reduction` and `SurfaceTangential`.

    References
    ----------
    M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6;
    J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661

    Examples
    --------
    A ball without Poisson's ratio, where Cattaneo and Mindlin are right: what is left is that of the pixels.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> x = (np.arange(63) - 31) / 63.0
    >>> ball = Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])
    >>> body = Elastic(1.0, 0.0)
    >>> found = ReducedFriction(ball, HalfSpace.between(body, body), Coulomb(0.3), 0.05).solve()
    >>> found.shift_error < 0.005, found.loss_error < 0.02
    (True, True)
    """

    __words__ = words(reduction=("", None, "the problem of the springs under normal forces"))

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    law: Sliding
    depth: Positive
    tolerance: Annotated[float, between(1e-4, 0.1)] = 1e-3

    references: ClassVar[tuple[str, ...]] = (
        "ciavarella_1998", "jaeger_1995", "barber_1974", "kalker_1990", "polonsky_keer_1999",
    )  # fmt: skip
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED | {Assumption.UNCOUPLED, Assumption.SLIP}

    def __post_init__(self) -> None:
        _ = self.reduction, self._elements(0, 0.0)  # refuse what they would refuse later
        if not 0.0 < self.law.coefficient < np.inf:
            raise InvalidInput(
                f"ReducedFriction: the friction coefficient is {self.law.coefficient:.6g}; give a positive, finite one."
            )

    @property
    def reduction(self) -> Reduction:
        """The problem of the springs under normal forces."""
        return Reduction(self.topography, self.medium, self.depth, self.tolerance)

    def _elements(self, axis: int, most: float) -> SurfaceTangential:
        """Return the loop along x (0) or y (1) by boundary elements; friction bears so much [N]."""
        forces = np.zeros((len(SHARES), 2))
        forces[:, axis] = most * np.array(SHARES)
        return SurfaceTangential(
            self.topography, self.medium, self.law, Path.through(Depth(self.depth), ShearForce(forces))
        )

    def _springs(self, bed: DirectionalBed, most: float) -> Tangential:
        """Return the same loop by springs."""
        return Tangential(bed, self.law, Path.through(Depth(self.depth), ShearForce(most * np.array(SHARES))))

    def solve(self) -> ReducedFrictionSolution:
        """Return the springs, and both friction loops by springs and by boundary elements.

        Raises
        ------
        NotConverged
            If the tolerance of the reduction is not met, or stick and slip are not found.
        OutsideValidity
            If too few pixels touch.
        """
        reduced = self.reduction.solve()
        most = self.law.coefficient * min(self._borne(reduced.bed), float(reduced.force[-1]))
        along, across = (self._elements(axis, most).solve() for axis in range(2))
        springs = self._springs(reduced.bed, most).solve(), self._springs(reduced.bed.turned, most).solve()
        return ReducedFrictionSolution(self, reduced, along, across, *springs)

    def _borne(self, bed: DirectionalBed) -> float:
        """Return the normal force [N] of the springs at the greatest depth."""
        return float(np.ravel(Indentation(bed, Depth(self.depth)).solve().force)[0])


@value
class ReducedFrictionSolution:
    """The solution of a `ReducedFriction`.

    Parameters
    ----------
    problem : ReducedFriction
        The problem that was solved.
    reduction : ReductionSolution
        The springs under normal forces.
    along, across : SurfaceTangentialSolution
        The loops along x and along y by boundary elements.
    springs_along, springs_across : TangentialSolution
        The same loops by springs.
    """

    __words__ = words(
        along=("", None, "the loop along x by boundary elements"),
        across=("", None, "the loop along y by boundary elements"),
        springs_along=("", None, "the loop along x by springs"),
        springs_across=("", None, "the loop along y by springs"),
        reduction=("", None, "the springs under normal forces"),
        shift=("u_i", "m", "shift of the bodies by boundary elements, along x and y"),
        shift_error=("", "", "greatest difference of a shift from boundary elements, over the greatest shift"),
        loss_error=("", "", "greatest difference of a loss from boundary elements, over the greatest loss"),
    )

    problem: ReducedFriction
    reduction: ReductionSolution
    along: SurfaceTangentialSolution
    across: SurfaceTangentialSolution
    springs_along: TangentialSolution
    springs_across: TangentialSolution

    @property
    def bed(self) -> DirectionalBed:
        """The springs for shear along x, with a note on their error; `bed.turned` is for shear along y."""
        return dataclasses.replace(self.reduction.bed, shift_error=self.shift_error, loss_error=self.loss_error)

    @property
    def force(self) -> float:
        """F_N [N] of the boundary elements at the maximum depth."""
        return float(self.along.force[-1])

    @property
    def shear_force(self) -> Array:
        """The shear force of both loops [N], ``(points,)``, along x and along y."""
        return self.along.shear_force_x

    @property
    def shift(self) -> Array:
        """(u_x, u_y) [m] by boundary elements, ``(points, 2)``, of the loops along x and along y."""
        return np.stack((self.along.shift_x, self.across.shift_y), axis=1)

    @property
    def spring_shift(self) -> Array:
        """(u_x, u_y) [m] by springs, ``(points, 2)``."""
        return np.stack((self.springs_along.shift, self.springs_across.shift), axis=1)

    @property
    def shift_x(self) -> Array:
        """u_x [m] by boundary elements, ``(points,)``."""
        return self.along.shift_x

    @property
    def shift_y(self) -> Array:
        """u_y [m] by boundary elements, ``(points,)``."""
        return self.across.shift_y

    @property
    def spring_shift_x(self) -> Array:
        """u_x [m] by springs, ``(points,)``."""
        return self.springs_along.shift

    @property
    def spring_shift_y(self) -> Array:
        """u_y [m] by springs, ``(points,)``."""
        return self.springs_across.shift

    @property
    def shift_error(self) -> float:
        """Error of displacements [-]: 1.1 times the maximum relative difference, plus the misfit of forces."""
        pairs = zip(self.shift.T, self.spring_shift.T, strict=True)
        return BETWEEN * max(loop_difference(elements, springs) for elements, springs in pairs) + self.reduction.misfit

    @property
    def loss_error(self) -> float:
        """Error of the dissipation [-]: 1.1 times the maximum relative difference, plus 3 times the force misfit.

        The dissipated energy in partial slip is proportional to the third power of the shear force.
        """
        loops = (self.along, self.springs_along), (self.across, self.springs_across)
        missed = max(loop_difference(elements.dissipation, springs.dissipation) for elements, springs in loops)
        return BETWEEN * missed + LOSS_POWER * self.reduction.misfit

    @property
    def validity(self) -> tuple[Note, ...]:
        """Accuracy of the springs: forces, errors under friction, and the error of the boundary elements."""
        return (self.reduction.validity[0], *direction_notes(self.bed), *self.along.validity)
