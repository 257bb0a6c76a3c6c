"""Solutions of ensembles of rough lines: depth, force and stiffness with their bands, and what it conducts."""

from __future__ import annotations

from typing import Any

from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.numerics.types import Array, Quantity, shaped
from winkler.problems.conduction.stiffness_analogy import conductance_of_stiffness
from winkler.values import value

__all__ = ["RoughSolution"]


@value
class RoughSolution:
    """Statistics of many rough lines under one load, or under many.

    Parameters
    ----------
    problem : RoughContact or RoughIndentation
        The problem that was solved.
    depth, force, stiffness : float or ndarray
        d [m], F [N], dF/dd [N/m]: the median of all lines, in the shape of the load.
    depth_band, force_band, stiffness_band : ndarray, (2, ...)
        Between these two lie eight of ten lines.
    """

    problem: Any
    depth: Quantity
    depth_band: Array
    force: Quantity
    force_band: Array
    stiffness: Quantity
    stiffness_band: Array

    def conductance(self, conductors: ElectricalConductors | HeatConductors) -> Quantity:
        """Return the conductance [S or W/K] of clean thick bodies, in the shape of the load.

        Raises
        ------
        OutsideValidity
            If there is a film, a plating or a rod.
        """
        share = conductance_of_stiffness(type(self.problem).__name__, self.problem.medium, conductors)
        return shaped(self.stiffness * share)
