r"""Where the quadratic interval fails: profile likelihood at its ends, and the stretches that correct it.

A number is moved to the end of its interval, the others along with it, and the change of the prediction is compared
with the one by the derivatives, both without what the other numbers can follow,

.. math:: \tau = \frac{|P(f(\beta+\delta) - f(\beta))|}{|P J\delta|} ,

decorrelated by the noise.  The half-width is divided by it, some times over.

Where a common step of all numbers changes the prediction as the derivatives say, within a few hundredths (the relative
curvature of Bates and Watts), nothing else is computed.

References
----------
D. M. Bates, D. G. Watts, Nonlinear Regression Analysis and Its Applications, Wiley 1988, ch. 6 and 7
"""

from __future__ import annotations

import numpy as np

from winkler.fitting.estimate import REFERENCE_WIDTH
from winkler.fitting.least_squares import bounds
from winkler.fitting.noise.estimate import NoiseEstimate
from winkler.fitting.noise.whitening import whitening_of
from winkler.fitting.task import FitTask
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

LEAST_CURVATURE = 0.03
"""Least relative curvature for which the ends are corrected."""
MOST_CORRECTIONS = 4
LEAST_STRETCH, GREATEST_STRETCH = 0.2, 5.0
CORRECTED = 0.01


def stretches_of(task: FitTask, coordinates: Array, covariance: Array, noise: NoiseEstimate) -> Array:
    """Return factors ``(p, 2)`` of the lower and upper half-widths of intervals; 1 where the model is nearly linear.

    Parameters
    ----------
    task : FitTask
    coordinates : ndarray, (p,)
        Of the fit.
    covariance : ndarray, (p, p)
    noise : NoiseEstimate
    """
    stretches = np.ones((coordinates.size, 2))
    if _is_linear(task.coarse, coordinates, covariance):
        return stretches
    whitening = whitening_of(noise)
    jacobian = whitening.of(task.slopes(coordinates))
    for index in range(coordinates.size):
        basis = np.linalg.qr(np.delete(jacobian, index, axis=1))[0] if coordinates.size > 1 else jacobian[:, :0]
        direction = covariance[:, index] / np.sqrt(covariance[index, index])
        unit = _length(jacobian @ direction, basis)
        for side, sign in enumerate((-1.0, 1.0)):
            stretch = 1.0
            for _ in range(MOST_CORRECTIONS):
                moved = _change(task, coordinates, sign * REFERENCE_WIDTH * stretch * direction)
                if moved is None or not unit > 0.0:
                    break
                reached = _length(whitening.of(moved), basis) / (REFERENCE_WIDTH * unit)
                if abs(reached - 1.0) <= CORRECTED or not reached > 0.0:
                    break
                stretch = float(np.clip(stretch / reached, LEAST_STRETCH, GREATEST_STRETCH))
            stretches[index, side] = stretch
    return stretches


def _is_linear(task: FitTask, coordinates: Array, covariance: Array) -> bool:
    """Return whether a common step of all numbers changes the prediction as the derivatives say, either way."""
    together = REFERENCE_WIDTH * (covariance / np.sqrt(np.diag(covariance))).mean(axis=1)
    along = task.slopes(coordinates) @ together
    limit = LEAST_CURVATURE * float(np.linalg.norm(along))
    for sign in (-1.0, 1.0):
        moved = _change(task, coordinates, sign * together)
        if moved is None or np.linalg.norm(moved - sign * along) > limit:
            return False
    return True


def _change(task: FitTask, coordinates: Array, step: Array) -> Array | None:
    """Return the weighted change of the prediction by a step, None beyond bounds or validity.

    The prediction before the step is read after that behind it, as both need the same cells (`FitTask.resolution`).
    """
    low, high = bounds(task.parameters, coordinates)
    place = coordinates + step
    if np.any(place <= low) or np.any(place >= high):
        return None
    try:
        ahead = task.prediction(place).fitted
        return np.asarray((ahead - task.predicted(coordinates).fitted) * task.weights)
    except OutsideValidity:
        return None


def _length(column: Array, basis: Array) -> float:
    """Return the norm of a column without its part in a basis."""
    return float(np.linalg.norm(column - basis @ (basis.T @ column)))
