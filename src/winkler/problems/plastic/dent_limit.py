"""The load that leaves a dent of a given depth: how far a contact may be loaded beyond the onset of yield."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Force
from winkler.numerics.equations.roots import between
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.plastic.first_loading import LAST_SHARE, WIDENING, FirstLoading, first_loading, refuse_unknown
from winkler.problems.plastic.indentation import PlasticIndentation, PlasticSolution
from winkler.values.checks.number_checks import Positive
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class DentLimit:
    """The load that leaves a dent of a given depth.

    A static load is often limited by the permitted dent, not by the onset of yield. In a rolling bearing, dents of
    rolling element and raceway together may be 1e-4 of the diameter of the rolling element (ISO 76).

    Parameters
    ----------
    bed : Foundation or EllipticFoundation
        As in `PlasticIndentation`.
    residual_depth : float
        d0 [m], positive: the permanent approach of the bodies, both dents together.

    Raises
    ------
    InvalidInput
        As in `PlasticIndentation`.

    References
    ----------
    ISO 76:2006, Rolling bearings - Static load ratings

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=208e9, poisson=0.3, strength=2.4e9)
    >>> ball = Foundation(Paraboloid(5e-3), HalfSpace(steel, steel))
    >>> limit = DentLimit(ball, residual_depth=1e-6).solve()
    >>> bool(limit.force > PlasticIndentation(ball, Force([1.0])).yield_force)
    True
    """

    bed: Bed
    residual_depth: Positive

    references: ClassVar[tuple[str, ...]] = ("johnson_1985", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED
    needs_round: ClassVar[str] = ""

    def __post_init__(self) -> None:
        refuse_unknown(type(self).__name__, self.bed)

    def solve(self) -> DentLimitSolution:
        """Return the load.

        Raises
        ------
        OutsideValidity
            If no load within the reach of the profile leaves such a dent. If the contact ends where the profile is much
            blunter than a paraboloid or sharper than a cone.
        """
        curve = first_loading(self.bed)
        radius = np.array([self._radius(curve)])
        force = float(curve.at(radius).force[0])
        state = next(PlasticIndentation(self.bed, Force(np.array([force]))).steps())
        elastic = Indentation(self.bed, Force(force)).solve()
        return DentLimitSolution(
            self, force, state.depth, state.radius, state.mean_pressure, float(elastic.peak_pressure)
        )

    def _radius(self, curve: FirstLoading) -> float:
        """Return the contact radius [m] under the load."""

        def excess(place: float) -> float:
            state = curve.at(np.array([math.exp(place)]))
            return float(state.depth[0] - state.recovery[0]) - self.residual_depth

        last = LAST_SHARE * curve.bed.reach
        low = float(at_depth(curve.bed, np.array([self.residual_depth]))[1][0])  # no contact of it keeps all its depth
        high = min(low := max(low, curve.onset), last)
        while excess(math.log(high)) <= 0.0:
            if high >= last:
                raise OutsideValidity(
                    f"DentLimit: no load within the reach of the profile ({curve.bed.reach:.6g} m) leaves a dent of "
                    f"{self.residual_depth:.6g} m; give a shallower one."
                )
            high = min(WIDENING * high, last)
        return math.exp(between(excess, math.log(low), math.log(high))) if high > low else low


@value
class DentLimitSolution:
    """The solution of `DentLimit`.

    Parameters
    ----------
    problem : DentLimit
        The problem that was solved.
    force, depth, radius, mean_pressure : float
        F_N [N], d [m], a [m] and F_N over the area [Pa] under the load; a as in `PlasticPress`.
    elastic_peak_pressure : float
        Maximum elastic (Hertz) pressure under this load, without yielding [Pa]: the contact stress in standards.
    """

    __words__ = words(
        elastic_peak_pressure=("p_{el}", "Pa", "maximum pressure without yielding"),
        released=("", None, "the contact under this load and after unloading"),
    )

    problem: DentLimit
    force: float
    depth: float
    radius: float
    mean_pressure: float
    elastic_peak_pressure: float

    @property
    def released(self) -> PlasticSolution:
        """The contact under this load and after unloading."""
        return PlasticIndentation(self.problem.bed, Force(np.array([self.force, 0.0]))).solve()

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return self.released.validity
