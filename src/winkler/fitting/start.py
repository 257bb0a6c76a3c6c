"""Where a fit begins: every start is tried on a part of the points, and a coarse fit improves the best of them."""

from __future__ import annotations

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.curves.checks import Outline
from winkler.fitting.least_squares import solved
from winkler.fitting.search import Search
from winkler.fitting.task import Task
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array

__all__ = ["best_start", "contact_points"]

SHARES = (0.0, 0.1, 0.3, -0.1)
"""How far before the rough contact point a start lies, in parts of the rest."""


def best_start(task: Task, strokes: Outline | None, search: Search) -> Array:
    """Return the coordinates from which a fit should begin.

    Parameters
    ----------
    task : Task
    strokes : Outline or None
        What the approach looks like; none where there is no approach.
    search : Search
        Counts the evaluations.
    """
    begins = task.starts(strokes)
    if not task.starts_are_trials:
        begins = list(begins)
        if len(begins) == 1:
            return begins[0]
    coarse, starts = task.coarse, []
    for begin in begins:
        try:
            starts.append((begin, float(np.sum(coarse.residuals(begin) ** 2))))
        except OutsideValidity:
            if not task.starts_are_trials:
                raise
            search.check()
            continue
        search.seen(coarse.numbers(begin), starts[-1][1], int(np.count_nonzero(coarse.weights)))
    if not starts:
        raise OutsideValidity("fit: none of the starts is within the reach of the model; give starts or bounds.")
    starts.sort(key=lambda start: start[1])
    improved = [solved(coarse, begin, search, coarse=True) for begin, _ in starts[: task.starts_improved]]
    return min(improved, key=lambda start: start[1])[0]


def contact_points(task: Task, parameter: Parameter, strokes: Outline) -> list[float]:
    """Return contact points [m] at which a fit may begin, from the outline of the approach."""
    rest = max(float(task.curve.position.max()) - strokes.contact_point, 1e-3 * parameter.scale)
    return [strokes.contact_point - share * rest for share in SHARES]
