"""First yield in the curves of a study: the force of the first pop-in of each, and their statistics."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.measurement import NanoindentationSolution
from winkler.fitting.nanoindentation.pop_ins import PopInStatistics, pop_in_statistics

__all__ = ["FEWEST", "first_pop_in", "first_yield"]

FEWEST = 3
"""Curves with a pop-in of which statistics are made."""


def first_pop_in(solution: NanoindentationSolution) -> float:
    """Return the force [N] at the first pop-in of the first loading; nan where there is none."""
    curve = solution.problem.curve
    loading = next((part for part in curve.segments if part.kind is SegmentKind.LOADING), None)
    for event in curve.events.of("pop-in"):
        force = float(curve.force[max(event.first - 1, 0)]) - solution.zero_point.baseline
        if (loading is None or event.first <= loading.last) and force > 0.0:
            return force
    return math.nan


def first_yield(
    solutions: Sequence[NanoindentationSolution], forces: Sequence[float], tip_radius: float, tip_radius_error: float
) -> PopInStatistics | None:
    """Return the statistics of first yield with the mean reduced modulus of the curves; None with fewer than three."""
    known = [one for one in forces if math.isfinite(one)]
    if len(known) < FEWEST:
        return None
    modulus = float(np.mean([one.modulus[one.deepest] for one in solutions]))
    return pop_in_statistics(known, modulus, tip_radius, tip_radius_error=tip_radius_error)
