"""Start of a fit: candidates are evaluated on a part of the points, and a coarse fit improves the best of them."""

from __future__ import annotations

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.least_squares import solved
from winkler.fitting.search import Search
from winkler.fitting.task import FitTask
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array

__all__ = ["best_start", "contact_points"]

CONTACT_POINT_SHARES = (0.0, 0.1, 0.3, -0.1)
"""Distances of trial contact points before the rough one, relative to the remaining travel."""
NO_START = "fit: none of the starts is within the reach of the model; give starts or bounds."


def best_start(task: FitTask, rough_outline: CurveOutline | None, search: Search) -> Array:
    """Return the coordinates from which a fit should begin.

    Parameters
    ----------
    task : FitTask
    rough_outline : CurveOutline or None
        Rough outline of the approach; None without an approach.
    search : Search
        Counts the evaluations.
    """
    candidates = task.starts(rough_outline)
    if not task.starts_are_trials:
        candidates = list(candidates)
        if len(candidates) == 1:
            return candidates[0]
    coarse, starts, refusal = task.coarse, [], OutsideValidity(NO_START)
    for candidate in candidates:
        try:
            starts.append((candidate, float(np.sum(coarse.residuals(candidate) ** 2))))
        except OutsideValidity as error:
            refusal = refusal if task.starts_are_trials else error
            search.check()
            continue
        search.record(coarse.numbers(candidate), starts[-1][1], int(np.count_nonzero(coarse.weights)))
    if not starts:
        raise refusal
    starts.sort(key=lambda start: start[1])
    improved = []
    for candidate, _ in starts[: task.starts_improved]:
        improved.append(solved(coarse, candidate, search, coarse=True))
        if task.explained_by(improved[-1][1], coarse, rough_outline):
            break
    return min(improved, key=lambda start: start[1])[0]


def contact_points(task: FitTask, parameter: Parameter, rough_outline: CurveOutline) -> list[float]:
    """Return contact points [m] at which a fit may begin, from the outline of the approach."""
    rest = max(float(task.curve.position.max()) - rough_outline.contact_point, 1e-3 * parameter.scale)
    return [rough_outline.contact_point - share * rest for share in CONTACT_POINT_SHARES]
