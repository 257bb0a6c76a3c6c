"""Start of a fit: candidates are evaluated on a part of the points, and a coarse fit improves the best of them."""

from __future__ import annotations

import contextlib

import numpy as np

from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.least_squares import solved
from winkler.fitting.search import Search
from winkler.fitting.task import FitTask
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

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
    candidates, coarse = iter(task.starts(rough_outline)), task.coarse
    starts: list[tuple[Array, float]] = []
    improved: dict[bytes, tuple[Array, float]] = {}
    refusal = OutsideValidity(NO_START)

    def explains(candidate: Array) -> bool:
        """Improve a start, unless that was done, and return whether the curve needs no other."""
        if candidate.tobytes() not in improved:
            improved[candidate.tobytes()] = solved(coarse, candidate, search, coarse=True)
        return task.explained_by(improved[candidate.tobytes()][1], coarse, rough_outline)

    if not task.starts_are_trials:
        first = next(candidates)
        if task.has_one_optimum:
            with contextlib.suppress(OutsideValidity):
                if explains(first):
                    return improved[first.tobytes()][0]
        rest = list(candidates)
        if not rest:
            return first
        candidates = iter([first, *rest])
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
    for candidate, _ in starts[: task.starts_improved]:
        if explains(candidate):
            break
    return min(improved.values(), key=lambda start: start[1])[0]


def contact_points(task: FitTask, parameter: Parameter, rough_outline: CurveOutline) -> list[float]:
    """Return contact points [m] at which a fit may begin, from the outline of the approach."""
    rest = max(float(task.curve.position.max()) - rough_outline.contact_point, 1e-3 * parameter.scale)
    return [rough_outline.contact_point - share * rest for share in CONTACT_POINT_SHARES]
