r"""Sliding wear of a line contact: a cylinder that slides across its line is worn to a flat.

.. math:: \frac{\mathrm df}{\mathrm ds} = \kappa\,p(x)

at every place of the contact, with the pressure of the profile as it is then.  It evens out: on a flat punch to
:math:`P/2b`, which its worn shape bears with :math:`f(b)-f(0) = \frac{4pb}{\pi E^*}\ln 2`; a cylinder is worn to a flat
of the cross-section :math:`\kappa P s = 2a^3/3R`, once that is much deeper than the elastic contact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.wear import Archard, OwnWear
from winkler.loading.path import OnePositiveLineForce
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import WORN
from winkler.problems.line.half_width import refuse_unless_strips, under_force
from winkler.problems.wear.input_checks import Cells, WearTolerance
from winkler.problems.wear.line_states import LineWearState
from winkler.problems.wear.line_validity import line_sliding_notes
from winkler.problems.wear.march import WearMoment
from winkler.problems.wear.nodes import GRID_GROWTH, graded_nodes
from winkler.problems.wear.stuck_core import refuse_unless_rising
from winkler.problems.wear.worn_grid import WornContact
from winkler.problems.wear.worn_states import OfDistance, pressed_moment, worn_history, worn_states
from winkler.values.checks.number_checks import Advice, FiniteQuantity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

ONE_BODY = Advice("the law of the body that stays in contact; where both wear in partial slip, use LineFrettingWear")


@value
class LineSlidingWear(OfDistance):
    """Wear of a cylindrical body that slides perpendicular to its axis under a steady load.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies before wear, homogeneous or layered.
    wear : Archard or OwnWear
        Law of wear of the body that stays in contact: the one with the profile, on a track much longer than the
        contact.
    normal : LineForce
        The steady normal force per length, one positive number.
    distance : float or ndarray, (steps,)
        Sliding distances [m] after which the contact is returned, summed over both directions; one number gives 41
        states up to it.
    count : int, optional
        Number of grid cells on one side of the middle.
    tolerance : float, optional
        Error of the worn depth in one jump, over the load per length over E*. Once the pressure is steady, it is
        relative to the sum of this and the maximum worn depth.
    layer_wears : bool, optional
        For a medium with layers: whether the uppermost layer wears, as on a coated roller that slides on a flat. By
        default the other body wears.

    Raises
    ------
    InvalidInput
        If a law, a force or a number is not of these kinds, or `layer_wears` is True on a medium without layers.
    OutsideValidity
        If the bodies relax.

    Notes
    -----
    The elastic response of a worn layer is assumed unchanged. `steps` raises an error when 5 % of its thickness are
    worn off. `validity` states the change of the stiffness for a uniformly thinner layer.

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448

    Examples
    --------
    A roller of 10 mm is worn to a flat, of which the cross-section is the rate times force and distance.

    >>> from winkler.laws.wear import Archard
    >>> from winkler.loading.loads import LineForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> worn = LineSlidingWear(bed, Archard(1e-14), LineForce(10e3), [0.0, 1e3], count=80).solve()
    >>> round(float(worn.worn_volume_per_length[-1] / (1e-14 * 10e3 * 1e3)), 9)
    1.0
    >>> round(float(worn.half_width[-1] / (1.5 * 10e-3 * 1e-14 * 10e3 * 1e3) ** (1 / 3)), 1)
    1.0
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        goals=("s", "m", "after which distances the contact is returned"),
        normal=("", None, "the steady normal force per length"),
        distance=("s", "m", "distance slid"),
        count=("n", "", "cells of the grid of places on one side"),
        tolerance=(r"\epsilon", "", "error of the worn depth in one jump, over the load per length over E*"),
        layer_wears=("", None, "whether the uppermost layer wears, and not the other body"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    wear: Annotated[Archard | OwnWear, ONE_BODY]
    normal: OnePositiveLineForce
    distance: FiniteQuantity
    count: Cells = 400
    tolerance: WearTolerance = 1e-3
    layer_wears: bool = False

    references: ClassVar[tuple[str, ...]] = ("archard_1953", "johnson_1985", "dimaki_2014")
    assumptions: ClassVar[frozenset[Assumption]] = WORN

    def __post_init__(self) -> None:
        _ = self.bed.medium.modulus
        super().__post_init__()

    def refuse(self, contact: WornContact, elapsed: float) -> None:
        """Raise an error if the contact reaches a falling part of the profile, or much of a layer would wear."""
        refuse_unless_rising("LineSlidingWear", self.bed, contact.radius)
        super().refuse(contact, elapsed)

    def _nodes(self) -> Array:
        bed = self.bed
        load = float(self.normal.force_per_length) / float(bed.medium.modulus)
        width = under_force(bed, np.array([load]))
        refuse_unless_strips(bed, width)
        return graded_nodes(0.0, min(GRID_GROWTH * float(width[0]), bed.reach, bed.rim), bed.rim, self.count)

    def steps(self, start: LineWearState | None = None) -> Iterator[LineWearState]:
        """Yield the contact at every requested distance.

        Parameters
        ----------
        start : LineWearState, optional
            A state of this problem from an earlier run. The computation continues from it, with the same numbers as
            without interruption.

        Raises
        ------
        OutsideValidity
            If the bodies touch in several strips, or the contact exceeds the profile. The error is raised at that
            step.
        NotConverged
            If jumps become too short.
        """
        return worn_states(self, start, self._nodes, everywhere=True)

    def state(self, moment: WearMoment) -> LineWearState:
        """Return the validity notes of the contact."""
        contact, touching, common = pressed_moment(self, moment)
        return LineWearState(**common, places=moment.nodes, force_per_length=contact.force, half_width=touching)

    def gathered(self, states: Iterable[LineWearState]) -> LineSlidingSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return worn_history(LineSlidingSolution, self, states)

    def solve(self) -> LineSlidingSolution:
        """Return the contact over the whole distance.

        Returns
        -------
        LineSlidingSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class LineSlidingSolution:
    """The solution of a `LineSlidingWear`, state by state.

    Parameters
    ----------
    problem : LineSlidingWear
        The problem that was solved.
    distance : ndarray, (steps,)
        s [m].
    force_per_length, half_width : ndarray, (steps,)
        P [N/m], a [m].
    mean_pressure : ndarray, (steps,)
        P / (2 a) [Pa].
    worn_depth : ndarray, (steps,)
        Maximum worn depth [m].
    worn_volume_per_length : ndarray, (steps,)
        Wear volume, per length of the line [m^2].
    states : tuple of LineWearState
        The states themselves, with the worn profiles.
    """

    __words__ = words(distance=("s", "m", "distance slid"))

    problem: LineSlidingWear
    distance: Array
    force_per_length: Array
    half_width: Array
    mean_pressure: Array
    worn_depth: Array
    worn_volume_per_length: Array
    states: tuple[LineWearState, ...]

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        stated = self.problem
        return line_sliding_notes(stated.bed, stated.tolerance, self.states, layer_wears=stated.layer_wears)
