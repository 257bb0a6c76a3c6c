"""From least squares to generalised least squares: steps under the noise that the residuals show."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.least_squares import bounds
from winkler.fitting.noise.estimate import NoiseEstimate, noise_of
from winkler.fitting.search import Search
from winkler.fitting.task import FitTask, Prediction
from winkler.numerics.types import Array

__all__ = ["Generalised", "generalised"]

MOST_STEPS = 6
SETTLED_ERRORS = 0.02
"""Greatest last step in standard errors."""
MOST_HALVINGS = 4
LONGEST_STEP = 1.0
LEAST_GAIN = -0.5
"""Least change of the logarithm of the likelihood by a step."""


class Generalised(NamedTuple):
    """Coordinates ``(p,)``, the prediction and its weighted derivatives ``(n, p)`` there, and the noise."""

    coordinates: Array
    prediction: Prediction
    jacobian: Array
    noise: NoiseEstimate


def generalised(task: FitTask, coordinates: Array, search: Search) -> Generalised:
    """Return generalised least squares from the coordinates of least squares; at a bound, these.

    Parameters
    ----------
    task : FitTask
    coordinates : ndarray, (p,)
    search : Search
        Counts the predictions.
    """
    here = _at(task, coordinates)
    low, high = bounds(task.parameters, coordinates)
    margin = 1e-6 * (1.0 + np.abs(coordinates))
    if np.any(coordinates <= low + margin) or np.any(coordinates >= high - margin):
        return here
    for _ in range(MOST_STEPS):
        errors = np.sqrt(np.diag(here.noise.covariance))
        step = here.noise.step
        if not np.max(np.abs(step) / errors) > SETTLED_ERRORS:
            break
        step = step * min(1.0, LONGEST_STEP / float(np.max(np.abs(step))))
        further = _stepped(task, here, step, low + margin, high - margin, search)
        if further is None:
            break
        here = further
    return here


def _stepped(
    task: FitTask, here: Generalised, step: Array, low: Array, high: Array, search: Search
) -> Generalised | None:
    """Return the fit after a step that does not make the residuals less likely, halved where needed."""
    for _ in range(MOST_HALVINGS):
        try:
            further = _at(task, np.clip(here.coordinates + step, low, high))
        except OutsideValidity:
            search.check()
        else:
            residuals = (task.measured - further.prediction.fitted) * task.weights
            count = int(np.count_nonzero(task.weights))
            search.record(task.numbers(further.coordinates), float(residuals @ residuals), count)
            if further.noise.likelihood - here.noise.likelihood > LEAST_GAIN:
                return further
        step = 0.5 * step
    return None


def _at(task: FitTask, coordinates: Array) -> Generalised:
    prediction = task.prediction(coordinates)
    jacobian = task.instrument(coordinates, prediction)
    residuals = (task.measured - prediction.fitted) * task.weights
    return Generalised(coordinates, prediction, jacobian, noise_of(residuals, jacobian, task.disturbances))
