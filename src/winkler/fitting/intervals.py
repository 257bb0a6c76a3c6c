r"""Intervals by profile likelihood.

A parameter is fixed at a value and all others are fitted again; the interval ends where the generalised sum of squares,
under the mean white and slow noise of the fit, has grown by

.. math:: \Delta = \frac{\mathrm{var}}{\mathrm{var}_0}\,t^2 ,

with the variance of the parameter with and without the uncertainty of the noise, and the half-width t of the mixture of
noises in standard errors.  It follows a curved valley of the misfit, and is the same for a parameter and its logarithm.
`FitEstimate.interval` has its ends to first
order in the curvature (`winkler.fitting.curvature`).
"""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.elastic.task import ElasticTask, elastic_task
from winkler.fitting.least_squares import bounds, solved
from winkler.fitting.noise.whitening import whitening_of
from winkler.fitting.outcome import Fit
from winkler.fitting.search import Search
from winkler.numerics.types import Array

MOST_STEPS = 40
INTERVAL_TOLERANCE = 2e-3
LEAST_GROWTH = 1e-10


def profile_interval(found: Fit, name: str, confidence: float = 0.95) -> tuple[float, float]:
    """Return the interval of a fitted number by profile likelihood.

    Parameters
    ----------
    found : Fit
    name : str
        Name of the parameter.
    confidence : float
        Between 0 and 1.

    Returns
    -------
    tuple of float
        Lower and upper end; limited by its bounds.

    Raises
    ------
    InvalidInput
        If the number was not free.
    NotConverged
        If a fit of the other parameters does not converge.

    References
    ----------
    D. M. Bates, D. G. Watts, Nonlinear Regression Analysis and Its Applications, Wiley 1988, ch. 6
    """
    index = found.index(name)
    free = {one: (low, high) for one, low, high in zip(found.names, found.lows, found.highs, strict=True)}
    task = elastic_task(found.curve, found.model, free, np.mean(found.weights) / found.weights)
    parameter = task.parameters[index]
    fitted = np.array([p.inward(n) for p, n in zip(task.parameters, found.values.tolist(), strict=True)])
    task = _decorrelated(task, fitted)
    best, least = solved(task, fitted, Search())
    jacobian = task.decorrelated(task.slopes(best))
    plain = float(np.linalg.inv(jacobian.T @ jacobian)[index, index])
    error = found.error(name) / abs(parameter.change(found.value(name)))
    width = found.quantile(confidence, name)
    allowed = error**2 / plain * width**2
    low, high = bounds(task.parameters, best)
    ends = []
    for side, bound in ((-1.0, float(low[index])), (1.0, float(high[index]))):
        end = _end(task, best, index, side * width * error, bound, least, allowed)
        shift = float(fitted[index] - best[index]) if end != bound else 0.0  # the noise is not one, but a mean of many
        ends.append(parameter.outward(end + shift))
    return ends[0], ends[1]


def _decorrelated(task: ElasticTask, coordinates: Array) -> ElasticTask:
    """Return the task whose least squares are generalised ones, under the noise of its residuals."""
    residuals = (task.measured - task.predicted(coordinates).fitted) * task.weights
    noise = task.noise_of(residuals, task.slopes(coordinates))
    return task._replace(whitening=whitening_of(noise))


def _end(task: ElasticTask, best: Array, index: int, step: float, bound: float, least: float, allowed: float) -> float:
    """Return the coordinate at which the sum of squares has grown by what is allowed, or the wall before."""
    parameter = task.parameters[index]
    rest = task._replace(parameters=task.parameters[:index] + task.parameters[index + 1 :])
    others = np.delete(best, index)
    limit = abs(bound - best[index])

    def excess(distance: float, begin: Array) -> tuple[float, Array]:
        """Return the excess of the root of the growth over the allowed one; nearly linear in the distance."""
        number = parameter.outward(float(best[index]) + math.copysign(distance, step))
        fixed = rest._replace(fixed=((parameter.name, number),))
        if begin.size:
            begin, misfit = solved(fixed, begin, Search())
        else:
            misfit = float(np.sum(fixed.residuals(begin) ** 2))
        return math.sqrt(max(misfit - least, 0.0) / allowed) - 1.0, begin

    near, below = 0.0, -1.0
    far = min(abs(step), limit)
    above, others = excess(far, others)
    for _ in range(MOST_STEPS):
        if above >= 0.0:
            break
        if far >= limit:
            return bound
        near, below = far, above
        far = min(far * min(max(1.3 / (above + 1.0 + LEAST_GROWTH), 1.2), 4.0), limit)
        above, others = excess(far, others)
    for _ in range(MOST_STEPS):
        middle = near + (far - near) * float(np.clip(-below / (above - below), 0.05, 0.95))
        growth, others = excess(middle, others)
        if abs(growth) <= INTERVAL_TOLERANCE:
            return float(best[index]) + math.copysign(middle, step)
        if growth < 0.0:
            near, below = middle, growth
        else:
            far, above = middle, growth
        if far - near <= INTERVAL_TOLERANCE * far:
            break
    return float(best[index]) + math.copysign(0.5 * (near + far), step)
