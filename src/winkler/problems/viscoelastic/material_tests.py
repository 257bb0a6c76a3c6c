r"""Tests of viscoelastic bodies with closed solutions: creep and relaxation.

While the contact does not shrink, elastic solutions stay true with the load replaced by its hereditary integral (Lee
and Radok).  With :math:`\mathcal F(d)` the force of the bed at :math:`E^*=1`, a step of force and a step of depth give

.. math:: \mathcal F(d(t)) = F\,C(t) , \qquad F(t) = E^*(t)\,\mathcal F(d) .

On layers that relax each by a law of its own the step is followed by a march, and the contact radius changes in both.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Force
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.assumptions.times import times_notes
from winkler.problems.normal.indentation import Indentation
from winkler.problems.viscoelastic.layered_notes import layered_notes
from winkler.problems.viscoelastic.layered_path import is_layered, stepped
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.problems.viscoelastic.validity import relaxing_notes
from winkler.values.checks.number_checks import Positive, PositiveRow
from winkler.values.validity import Assumption, Note
from winkler.values.value import value


@value
class CreepTest:
    """A constant force, applied in one step.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium) with a ViscoelasticHalfSpace or a ViscoelasticCoatedHalfSpace.
    force : float
        F_N [N], positive.
    time : ndarray, (steps,)
        Time since the step [s], positive.

    Raises
    ------
    InvalidInput
        If the medium is not viscoelastic, or a number is out of range.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(Maxwell(shear=0.25, relaxation_time=2.0)))
    >>> CreepTest(bed, 0.01, [6.0]).solve().radius ** 3  # 3/4 F R (1 + t / tau) / E*
    array([0.03])
    """

    bed: Bed
    force: Positive
    time: PositiveRow

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "lee_radok_1960")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not is_layered("CreepTest", self.bed):
            relaxation_of("CreepTest", self.bed)

    def solve(self) -> StepSolution:
        """Return depth and contact radius over time.

        Returns
        -------
        StepSolution

        Raises
        ------
        OutsideValidity
            If the depth exceeds the known range of its profile, or the contact on layers is not a disc.
        NotConverged
            If the cells do not resolve the layers.
        """
        medium = self.bed.medium
        assert offers(medium, RelaxingMedium)
        if is_layered("CreepTest", self.bed):
            return StepSolution(self, self.time, *stepped("CreepTest", self.bed, self.time, Force(self.force)))
        sunk = Indentation(elastic_like(self.bed), Force(self.force * medium.creep.at(self.time))).solve()
        return StepSolution(self, self.time, sunk.depth, np.full(self.time.shape, self.force), sunk.radius)


@value
class RelaxationTest:
    """A constant depth, applied in one step.

    Parameters
    ----------
    bed : Bed
        Foundation(profile, medium) with a ViscoelasticHalfSpace or a ViscoelasticCoatedHalfSpace.
    depth : float
        d [m], positive.
    time : ndarray, (steps,)
        Time since the step [s], positive.

    Raises
    ------
    InvalidInput
        If the medium is not viscoelastic, or a number is out of range.

    References
    ----------
    E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438-444, doi:10.1115/1.3644020

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.spring_and_dashpot import Maxwell
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
    >>> bed = Foundation(Paraboloid(1.0), ViscoelasticHalfSpace(Maxwell(shear=0.25, relaxation_time=2.0)))
    >>> RelaxationTest(bed, 0.25, [2.0]).solve().force * 6.0  # a^3 = 1/8: 1/6 exp(-1)
    array([0.36787944])
    """

    bed: Bed
    depth: Positive
    time: PositiveRow

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "lee_radok_1960")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if not is_layered("RelaxationTest", self.bed):
            relaxation_of("RelaxationTest", self.bed)

    def solve(self) -> StepSolution:
        """Return the decrease of the force with time.

        Returns
        -------
        StepSolution

        Raises
        ------
        OutsideValidity
            If the depth is beyond the known range of the profile, or the contact on layers is not a disc.
        NotConverged
            If the cells do not resolve the layers.
        """
        if is_layered("RelaxationTest", self.bed):
            return StepSolution(self, self.time, *stepped("RelaxationTest", self.bed, self.time, Depth(self.depth)))
        held = Indentation(elastic_like(self.bed), Depth(self.depth)).solve()
        force = float(held.force) * relaxation_of("", self.bed).at(self.time)
        depth, radius = (np.full(self.time.shape, float(number)) for number in (self.depth, held.radius))
        return StepSolution(self, self.time, depth, force, radius)


@value
class StepSolution:
    """The solution of a `CreepTest` or a `RelaxationTest`.

    Parameters
    ----------
    problem : CreepTest or RelaxationTest
        The problem that was solved.
    time : ndarray, (steps,)
        Since the step [s].
    depth : ndarray, (steps,)
        d [m].
    force : ndarray, (steps,)
        F_N [N].
    radius : ndarray, (steps,)
        a [m].
    """

    problem: CreepTest | RelaxationTest
    time: Array
    depth: Array
    force: Array
    radius: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed = self.problem.bed
        depth, radius = np.broadcast_arrays(np.ravel(self.depth), np.ravel(self.radius))
        times = times_notes(bed.medium, float(np.min(self.time)), float(np.max(self.time)))
        if is_layered("validity", bed):
            return layered_notes(self.problem, self, times)
        return relaxing_notes(bed, depth, radius, times)
