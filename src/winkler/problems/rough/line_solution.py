"""Ensembles of rough lines: what they refuse, and their solutions with bands, conductance and the waves left out."""

from __future__ import annotations

import math
from typing import Annotated, Any, TypeAlias

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.conduction.stiffness_analogy import conductance_of_stiffness
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.yield_of_pressure import spots_yield_notes
from winkler.problems.rough.layered_lines import conducting_medium
from winkler.values.checks.number_checks import Whole, affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS, MOST_SPRINGS
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value

CUT_OFF_ROUNDING = 1e-9


Realisations: TypeAlias = Annotated[int, Whole(1, MOST_SPRINGS)]
LineSprings: TypeAlias = Annotated[int, Whole(16, MOST_SPRINGS)]


def check_ensemble(owner: str, load: Force | Depth, realisations: int, count: int) -> None:
    """Refuse loads that are none or pull, and more springs than are computed with."""
    affordable(owner, "springs of all realisations", realisations * count, MOST_NUMBERS)
    least_load = float(np.min(numbers_of(load)))
    if least_load <= 0.0:
        raise InvalidInput(
            f"{owner}: the load {least_load:.6g} is not positive; without adhesion surfaces are pressed together."
        )


@value
class RoughSolution(PerLoad[Q]):
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
    depth: Q
    depth_band: Array
    force: Q
    force_band: Array
    stiffness: Q
    stiffness_band: Array

    def conductance(self, conductors: ElectricalConductors | HeatConductors) -> Q:
        """Return the conductance [S or W/K] of clean thick bodies, in the shape of the load.

        Raises
        ------
        OutsideValidity
            If there is a film, a plating or a rod, or the bodies have layers.
        """
        owner = type(self.problem).__name__
        share = conductance_of_stiffness(owner, conducting_medium(owner, self.problem.medium), conductors)
        return shaped(self.stiffness * share)

    @property
    def area(self) -> Q:
        """True area of contact [m^2]."""
        raise NotImplementedError

    @property
    def _line_notes(self) -> tuple[Note, ...]:
        """Return whether spots in contact yield, and if waves are longer than the line, or shorter than two springs."""
        problem = self.problem
        spectrum, length, count = problem.spectrum, problem.length, problem.count
        if isinstance(problem.medium, HomogeneousMedium):
            yielding = spots_yield_notes(problem.medium, float(np.max(np.asarray(self.force) / np.asarray(self.area))))
        else:
            yielding = unknown_yield(problem.medium, "the stresses below rough spots are not computed in layers")
        left_out = []
        if spectrum.smallest * length < 2.0 * math.pi * (1.0 - CUT_OFF_ROUNDING):
            left_out.append(f"longer than the line ({length:.4g} m)")
        if spectrum.greatest * length > math.pi * count * (1.0 + CUT_OFF_ROUNDING):
            left_out.append(f"shorter than two springs ({2.0 * length / count:.4g} m; give a larger count)")
        if not left_out:
            return yielding
        return (
            *yielding,
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE,
                f"Waves of the spectrum {' and '.join(left_out)} are not represented in the one-dimensional profile.",
                "the points of a discrete Fourier transform",
            ),
        )
