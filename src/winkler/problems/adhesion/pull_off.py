r"""Pull-off: the last stable state of an adhesive contact that a machine pulls apart.

A machine of the stiffness :math:`k_m` prescribes :math:`D = d + F/k_m`.  The contact is lost where D is least among all
stable states; a dead load is :math:`k_m = 0`, fixed grips are :math:`k_m\to\infty`.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, TypeAlias

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import AdhesionLaw
from winkler.problems.adhesion.branches_beyond import branches_beyond
from winkler.problems.adhesion.edge_states import force_of, position
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.validity import adhesive_notes
from winkler.problems.assumptions.declared import ADHESIVE
from winkler.values.checks.number_checks import Number
from winkler.values.validity import Assumption, Note
from winkler.values.value import value

MachineStiffness: TypeAlias = Annotated[
    float, Number("give 0 for a dead load, inf for fixed grips, or a positive number{unit}", 0.0)
]
"""Stiffness of the machine that holds the bodies [N/m]."""


@value
class PullOff:
    """Pull-off of an adhesive contact.

    Parameters
    ----------
    bed : Bed
    law : ShortRange, Dugdale or DerjaguinMullerToporov
    machine_stiffness : float, optional
        [N/m]: 0 for a dead load (the default), inf for fixed grips, the cantilever's for a force microscope.

    Raises
    ------
    InvalidInput
        If the stiffness is negative.

    References
    ----------
    K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301-313, doi:10.1098/rspa.1971.0141

    Examples
    --------
    >>> import math
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.laws.adhesion import ShortRange
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1e-3), HalfSpace.between(Elastic(1e6, 0.5)))
    >>> round(PullOff(bed, ShortRange(0.05)).solve().force / (math.pi * 1e-3 * 0.05), 12)
    -1.5
    """

    bed: Bed
    law: AdhesionLaw
    machine_stiffness: MachineStiffness = 0.0

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "johnson_kendall_roberts_1971")
    assumptions: ClassVar[frozenset[Assumption]] = ADHESIVE
    needs_round: ClassVar[str] = "adhesion, whose edge runs round the contact,"

    def solve(self) -> PullOffSolution:
        """Return depth, force and radius of the last stable contact.

        Returns
        -------
        PullOffSolution

        Raises
        ------
        OutsideValidity
            If the law does not hold for the bed, or no stable contact exists.
        """
        states, machine = states_of(self.bed, self.law), self.machine_stiffness
        starts = np.array([branch.start for branch in branches_beyond(states, machine, 0.0)])
        radius = float(starts[np.argmin(position(states, machine, starts))])
        place = np.array([radius])
        return PullOffSolution(self, float(states.depth(place)[0]), float(force_of(states, place)[0]), radius)


@value
class PullOffSolution:
    """The solution of `PullOff`.

    Parameters
    ----------
    problem : PullOff
        The problem that was solved.
    depth, force, radius : float
        [m], [N], [m] just before the contact is lost; radius zero where it shrinks to a point without a jump.
    """

    problem: PullOff
    depth: float
    force: float
    radius: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed, and how large the slopes are."""
        return adhesive_notes(self.problem.bed, self.problem.law, np.array([self.depth]), np.array([self.radius]))
