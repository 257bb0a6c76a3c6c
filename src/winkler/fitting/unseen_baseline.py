"""A curve wholly in contact whose free tilt takes the beginning of the contact for a baseline.

Under noise the foot of a contact is a straight line, so that a fit with a free tilt places the contact point inside the
curve, with a modulus that is too low.  Then a contact that begins at the first point or before it, with its own scale,
baseline and tilt, describes the curve as well; a curve that shows its baseline excludes it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.task import FitTask, Prediction
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation

__all__ = ["extra_squares", "unseen_baseline"]

BEGINNINGS = (0.0, 0.05, 0.15, 0.4, 1.0)
"""Contact points before the first position, in parts of the travel."""
EXCLUDED = 14.0
"""Weighted squares by which a contact from the first point on has to be worse, as of models that are compared."""


def unseen_baseline(
    task: FitTask, coordinates: Array, prediction: Prediction, effective_count: float
) -> Iterator[Flag]:
    """Yield `no_baseline` for a fit with a free tilt that a contact from the first point on describes as well.

    Parameters
    ----------
    task : FitTask
        Of a contact without adhesion and relaxation; others have no such flag.
    coordinates : ndarray, (p,)
        Of the fit.
    prediction : Prediction
        There.
    effective_count : float
        Number of independent points.
    """
    names = [parameter.name for parameter in task.parameters]
    if not isinstance(task.model, Indentation) or not {"tilt", "contact_point"} <= set(names):
        return
    if extra_squares(task, coordinates, prediction, effective_count) < EXCLUDED:
        yield Flag(
            "no_baseline",
            "With a free tilt, a contact from the first point on describes the curve as well: no baseline is seen, and "
            "contact point, tilt and modulus may be far off; fix the tilt, or begin farther out.",
        )


def extra_squares(task: FitTask, coordinates: Array, prediction: Prediction, effective_count: float) -> float:
    """Return by how many weighted squares of independent points the best contact from the first point on is worse.

    Scale of the force, baseline and tilt are found anew for each contact point, by linear least squares.
    """
    weights, position = task.weights, task.curve.position
    squares = float(np.sum(((task.measured - prediction.fitted) * weights) ** 2))
    count = max(int(np.count_nonzero(weights)) - len(task.parameters), 1)
    first, travel = float(position.min()), float(np.ptp(position))
    place = next(n for n, parameter in enumerate(task.parameters) if parameter.name == "contact_point")
    others = []
    for share in BEGINNINGS:
        moved = coordinates.copy()
        moved[place] = task.parameters[place].inward(first - share * travel)
        numbers = task.numbers(moved)
        contact = task.prediction(moved).fitted - task.line(numbers)
        columns = np.stack([np.ones(position.size), (position - first) / travel, contact], axis=1) * weights[:, None]
        size = np.linalg.norm(columns, axis=0)
        if not size[-1] > 0.0:
            continue
        columns /= size
        found = np.linalg.lstsq(columns, task.measured * weights, rcond=None)[0]
        if found[-1] > 0.0:
            others.append(float(np.sum((task.measured * weights - columns @ found) ** 2)))
    if not others or squares == 0.0:
        return np.inf
    return (min(others) / squares - 1.0) * min(count, effective_count)
