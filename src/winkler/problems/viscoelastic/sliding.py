r"""The resistance of a viscoelastic body to a rigid one that slides or rolls over it at a steady speed.

In the frame of the rigid body every spring is pressed in from the leading edge on, relaxes meanwhile, and lets go
behind the middle where it would pull,

.. math:: q(x) = \int_x^a E^*\!\left(\frac{x'-x}{v}\right) g'(x')\,\mathrm dx', \qquad
          F = \int q\,\mathrm dx, \qquad F_x = \int q\,g'\,\mathrm dx ,

so that the front bears more than the back.  Sliding breaks the symmetry of revolution, and the line of springs is an
approximation: for any body of revolution it gives twice the true resistance at low speed and the true one at high
speed (`winkler.problems.viscoelastic.sliding_factor`).
"""

from __future__ import annotations

from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.path import OnePositiveNormal
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array, PerLoad, Q, like, shaped
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.assumptions.times import times_notes
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import contact_notes
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.problems.viscoelastic.passing import pass_at_depth, pass_under_load
from winkler.problems.viscoelastic.sliding_factor import share_of_line
from winkler.values.checks.number_checks import POSITIVE_QUANTITY, Whole
from winkler.values.errors import InvalidInput
from winkler.values.limits import RELAXING_SPRINGS
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

__all__ = ["SlidingLine", "SlidingResistance", "SlidingResistanceSolution"]


@value
class SlidingResistance(PerLoad[Q]):
    """A rigid body that slides without friction, or rolls, over a viscoelastic one at a steady speed.

    A ball that rolls freely leaves the same trace as one that slides, and meets the same resistance at its axle; what
    else resists rolling (slip, adhesion) is not in it.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, ViscoelasticHalfSpace(solid)); the edge of the contact is not a rim.
    normal : Depth or Force
        The steady load, one positive number.
    speed : float or ndarray
        v [m/s], positive; the results have its shape.
    count : int, optional
        Into how many parts the widest contact is cut; the error falls with its square, and is none of a paraboloid and
        a cone.

    Raises
    ------
    InvalidInput
        If the bed does not relax or a number is out of range.

    References
    ----------
    V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6;
    N. V. Brilliantov, T. Poeschel, Europhys. Lett. 42 (1998) 511-516, doi:10.1209/epl/i1998-00281-7

    Examples
    --------
    Slowly, a ball meets the resistance tau v F / R (E* = 1 Pa, tau = 1 s), half of that of the line.

    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.loading.loads import Depth
    >>> from winkler.materials.spring_and_dashpot import KelvinVoigt
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(KelvinVoigt(shear=0.25, viscosity=0.25)))
    >>> rolling = SlidingResistance(bed, Depth(0.01), [1e-6, 1e-3, 1e-2]).solve()
    >>> (rolling.coefficient / rolling.speed).round(3)
    array([1.   , 0.995, 0.969])
    """

    __words__ = words(count=("n", "", "into how many parts the contact is cut"))

    bed: Bed
    normal: OnePositiveNormal
    speed: Annotated[Q, POSITIVE_QUANTITY]
    count: Annotated[int, Whole(10, RELAXING_SPRINGS)] = 1000

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "brilliantov_poschel_1998")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING
    needs_round: ClassVar[str] = "sliding over a solid that relaxes behind the contact"

    def __post_init__(self) -> None:
        if not isinstance(self.bed.medium, ViscoelasticHalfSpace):
            raise InvalidInput(
                f"SlidingResistance: the bed stands on a {type(self.bed.medium).__name__}; how far a line of springs "
                "is off what the body loses in sliding is known on half-spaces only: give Foundation(profile, "
                "ViscoelasticHalfSpace(solid))."
            )
        relaxation_of("SlidingResistance", self.bed)

    def solve(self) -> SlidingResistanceSolution[Q]:
        """Return the resistance at every speed.

        Returns
        -------
        SlidingResistanceSolution

        Raises
        ------
        OutsideValidity
            If the load is beyond what is known of the profile, the contact reaches a rim or is no disc, or the body
            touches again behind.
        NotConverged
            If the depth under a force is not found.
        """
        medium = self.bed.medium
        assert isinstance(medium, ViscoelasticHalfSpace)
        rows = []
        for speed in np.ravel(np.asarray(self.speed, dtype=float)).tolist():
            done = pass_under_load(self.bed, self.normal, self.count, speed)
            share = share_of_line(medium.creep, speed, *done.touching)
            sums = done.depth, done.force, done.radius, done.trailing_edge, done.shear_force
            rows.append((*sums, share * done.shear_force))
        columns: list[Q] = [like(np.array(column), self.speed) for column in zip(*rows, strict=True)]
        return SlidingResistanceSolution(self, self.speed, *columns)


@value
class SlidingLine:
    """The springs under a body that slides towards +x, in its frame.

    Parameters
    ----------
    position : ndarray, (n,)
        x [m], from the leading edge to where the body is as far above the surface again.
    line_load : ndarray, (n,)
        q(x) [N/m], zero behind the trailing edge.
    """

    position: Array
    line_load: Array


@value
class SlidingResistanceSolution(PerLoad[Q]):
    """The solution of a `SlidingResistance`; every quantity has the shape of the speed.

    Parameters
    ----------
    problem : SlidingResistance
        The problem that was solved.
    speed : float or ndarray
        v [m/s].
    depth, force : float or ndarray
        d [m], F_N [N].
    radius : float or ndarray
        a [m], from the middle to the leading edge.
    trailing_edge : float or ndarray
        x [m] where the springs let go, negative behind the middle.
    line_shear_force : float or ndarray
        F_x [N] of the line of springs, positive against the motion.
    shear_force : float or ndarray
        F_x [N] of the body: that of the line, less what waves aslant do not lose.
    """

    __words__ = words(coefficient=(r"\mu", "", "resistance over normal force"))

    problem: SlidingResistance[Q]
    speed: Q
    depth: Q
    force: Q
    radius: Q
    trailing_edge: Q
    line_shear_force: Q
    shear_force: Q

    @property
    def coefficient(self) -> Q:
        """F_x / F_N [-] of the body, its coefficient of friction."""
        return shaped(np.asarray(self.shear_force) / self.force)

    def line(self, index: int | tuple[int, ...] = ()) -> SlidingLine:
        """Return the springs at one speed.

        Parameters
        ----------
        index : int or tuple of int, optional
            Which one; left out if there is only one.

        Raises
        ------
        InvalidInput
            If there is no such speed.
        """
        try:
            speed, depth = (float(np.asarray(each)[index]) for each in (self.speed, self.depth))
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.line: there is no speed {index!r} in a solution of shape {np.shape(self.speed)}."
            ) from None
        done = pass_at_depth(self.problem.bed, self.problem.count, depth, speed)
        return SlidingLine(done.place, done.loads)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed = self.problem.bed
        depth, radius = (np.ravel(np.asarray(column)) for column in (self.depth, self.radius))
        passing = (2.0 * radius / np.ravel(np.asarray(self.speed)))[radius > 0.0]
        times = times_notes(bed.medium, float(np.min(passing)), float(np.max(passing))) if passing.size else ()
        return (
            *bed.notes,
            APPROXIMATE,
            *times,
            *contact_notes(elastic_like(bed), depth, radius),
            *relaxing_yield(bed.medium),
        )


APPROXIMATE = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "A contact that slides is not one of revolution. For every body of revolution the springs give twice the "
    "resistance at low speed and the right one at high speed. shear_force corrects this as if the pressure were one "
    "of revolution. Against pressures computed in three dimensions it is too high at the peak: by a tenth for a "
    "solid that is twice as stiff when glassy as when relaxed. It is too high by a third if ten times, by a half if "
    "a hundred times, and by less away from the peak.",
    "energy of the moving pressure, compared with the half-space's hereditary integral on a grid",
)
