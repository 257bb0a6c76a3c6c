r"""Sliding wear: a body that slides loses what pressure and distance take off it, and runs in.

.. math:: \frac{\mathrm df}{\mathrm ds} = \kappa\,p(r)

at every point of the contact.  Under a steady force the pressure evens out: on a flat punch to :math:`F/(\pi b^2)`,
which its worn shape bears with :math:`f(b)-f(0) = \frac{4pb}{\pi E^*}(\frac\pi2-1)`; a ball is worn to a cap of the
volume :math:`\kappa F s = \pi a^4/4R`, once that is much deeper than the elastic contact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.laws.wear import Archard, OwnWear
from winkler.loading.path import OnePositiveNormal
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import WORN
from winkler.problems.wear.input_checks import Cells, WearTolerance, refuse_unless_pressed
from winkler.problems.wear.march import WearMoment
from winkler.problems.wear.states import WearState
from winkler.problems.wear.validity import sliding_notes
from winkler.problems.wear.worn_layers import cells_note, layer_notes
from winkler.problems.wear.worn_states import OfDistance, pressed_moment, round_nodes, worn_history, worn_states
from winkler.values.checks.number_checks import Advice, FiniteQuantity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

ONE_BODY = Advice("the law of the body that stays in contact; where both wear, use FrettingWear")


@value
class SlidingWear(OfDistance):
    """Wear of a body that slides under a steady load.

    Parameters
    ----------
    bed : Foundation
        Foundation(profile, medium) before wear; the bodies are elastic, with or without layers.
    wear : Archard or OwnWear
        Law of wear of the body that stays in contact.
    normal : Depth or Force
        The steady normal load, one positive number.
    distance : float or ndarray, (steps,)
        Sliding distances [m] after which the contact is returned, summed over both directions; one number gives 41
        states up to it.
    count : int, optional
        Number of grid cells along the radius.
    tolerance : float, optional
        Error of the worn depth in one jump, over the depth of the springs. Once the pressure is steady, it is relative
        to the approach of the bodies including wear.
    layer_wears : bool, optional
        For a medium with layers: whether the uppermost layer wears, as on a coated ball that slides on a flat. By
        default the other body wears, such as a pin on a coated disc.

    Raises
    ------
    InvalidInput
        If a law, a load or a number is not of these kinds, or `layer_wears` is True on a medium without layers.
    OutsideValidity
        If the medium is viscoelastic, or has no known pressure.

    Notes
    -----
    On layers and graded bodies pressures are superpositions of flat-punch solutions, as in `Indentation`. The elastic
    response of a worn layer is assumed unchanged. `steps` raises an error when 5 % of its thickness are worn off.
    `validity` states the change of the stiffness for a uniformly thinner layer.

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448

    Examples
    --------
    A ball of 1 mm is worn to a cap, of which the volume is the rate times force and distance.

    >>> from winkler.laws.wear import Archard
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(1e-3), HalfSpace.between(Elastic(210e9, 0.3), Elastic(210e9, 0.3)))
    >>> worn = SlidingWear(bed, Archard(1e-14), Force(1.0), [0.0, 50.0], count=80).solve()
    >>> round(float(worn.worn_volume[-1] / (1e-14 * 1.0 * 50.0)), 3)
    1.0
    >>> round(float(worn.radius[-1] / (4e-3 * 1e-14 * 50.0 / np.pi) ** 0.25), 1)
    1.0
    """

    __words__ = words(
        goals=("s", "m", "after which distances the contact is returned"),
        distance=("s", "m", "distance slid"),
        count=("n", "", "cells of the grid of radii"),
        tolerance=(r"\epsilon", "", "error of the worn depth in one jump, over the depth"),
        layer_wears=("", None, "whether the uppermost layer wears, and not the other body"),
    )

    bed: Foundation
    wear: Annotated[Archard | OwnWear, ONE_BODY]
    normal: OnePositiveNormal
    distance: FiniteQuantity
    count: Cells = 400
    tolerance: WearTolerance = 1e-3
    layer_wears: bool = False

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "dimaki_2014", "archard_1953")
    assumptions: ClassVar[frozenset[Assumption]] = WORN
    needs_round: ClassVar[str] = "wear, which follows the pressure from place to place,"

    def __post_init__(self) -> None:
        refuse_unless_pressed("SlidingWear", self.bed)
        super().__post_init__()

    def steps(self, start: WearState | None = None) -> Iterator[WearState]:
        """Yield the contact at every requested distance.

        Parameters
        ----------
        start : WearState, optional
            A state of this problem from an earlier run. The computation continues from it, with the same numbers as
            without interruption.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, the contact exceeds the profile, or more than 5 per cent of a layer is worn off.
            The error is raised at that step.
        NotConverged
            If jumps become too short.
        """
        return worn_states(self, start, lambda: round_nodes(self), everywhere=True)

    def state(self, moment: WearMoment) -> WearState:
        """Return the validity notes of the contact."""
        contact, touching, common = pressed_moment(self, moment)
        return WearState(
            **common, radii=moment.nodes, depth=contact.depth, force=contact.force, radius=touching
        )  # fmt: skip

    def gathered(self, states: Iterable[WearState]) -> SlidingSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        return worn_history(SlidingSolution, self, states)

    def solve(self) -> SlidingSolution:
        """Return the contact over the whole distance.

        Returns
        -------
        SlidingSolution

        Raises
        ------
        OutsideValidity, NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class SlidingSolution:
    """The solution of a `SlidingWear`, state by state.

    Parameters
    ----------
    problem : SlidingWear
        The problem that was solved.
    distance : ndarray, (steps,)
        s [m].
    depth, force, radius : ndarray, (steps,)
        d [m], F_N [N], a [m].
    worn_depth : ndarray, (steps,)
        Maximum worn depth [m].
    worn_volume : ndarray, (steps,)
        Wear volume [m^3].
    states : tuple of WearState
        The states themselves, with the worn profiles.
    """

    __words__ = words(distance=("s", "m", "distance slid"))

    problem: SlidingWear
    distance: Array
    depth: Array
    force: Array
    radius: Array
    worn_depth: Array
    worn_volume: Array
    states: tuple[WearState, ...]

    @property
    def mean_pressure(self) -> Array:
        """F / (pi a^2) [Pa], ``(steps,)``."""
        return np.asarray(self.force / (np.pi * self.radius**2))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        medium, coarse = problem.bed.medium, cells_note(self.states[0])
        layers = layer_notes(medium, self.states, coarse, layer_wears=problem.layer_wears)
        return (*sliding_notes(problem.bed, problem.tolerance, self.states), *layers)
