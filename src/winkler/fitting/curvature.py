r"""Where the quadratic interval fails: profile likelihood at its ends, and the stretches that correct it.

A number is moved to the end of its interval, the others along with it, and the change of the prediction is compared
with the one by the derivatives, both without what the other numbers can follow,

.. math:: \tau = \frac{|P(f(\beta+\delta) - f(\beta))|}{|P J\delta|} .

Where a common step of all numbers changes the prediction as the derivatives say, within a few hundredths (the relative
curvature of Bates and Watts), nothing else is computed.

References
----------
D. M. Bates, D. G. Watts, Nonlinear Regression Analysis and Its Applications, Wiley 1988, ch. 6 and 7
"""

from __future__ import annotations

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.estimate import REFERENCE_WIDTH
from winkler.fitting.least_squares import bounds
from winkler.fitting.task import FitTask
from winkler.numerics.types import Array

__all__ = ["stretches_of"]

LEAST_CURVATURE = 0.03
"""Least relative curvature for which the ends are corrected."""
MOST_CORRECTIONS = 4
LEAST_STRETCH, GREATEST_STRETCH = 0.2, 5.0
CORRECTED = 0.01


def stretches_of(task: FitTask, coordinates: Array, covariance: Array) -> Array:
    """Return factors ``(p, 2)`` of the lower and upper half-widths of intervals; 1 where the model is nearly linear.

    Parameters
    ----------
    task : FitTask
    coordinates : ndarray, (p,)
        Of the fit.
    covariance : ndarray, (p, p)
    """
    stretches = np.ones((coordinates.size, 2))
    coarse = task.coarse
    low, high = bounds(task.parameters, coordinates)
    errors = np.sqrt(np.diag(covariance))
    prediction = coarse.prediction(coordinates)
    jacobian = coarse.jacobian(coordinates, prediction)

    def change(step: Array) -> Array | None:
        """Return the weighted change of the prediction, None beyond bounds or validity."""
        place = coordinates + step
        if np.any(place <= low) or np.any(place >= high):
            return None
        try:
            return np.asarray((coarse.prediction(place).fitted - prediction.fitted) * coarse.weights)
        except OutsideValidity:
            return None

    together = REFERENCE_WIDTH * (covariance / errors).mean(axis=1)
    found = [change(sign * together) for sign in (-1.0, 1.0)]
    along = jacobian @ together
    whole = float(np.linalg.norm(along))
    if all(one is not None and np.linalg.norm(one - s * along) <= LEAST_CURVATURE * whole
           for one, s in zip(found, (-1.0, 1.0), strict=True)):
        return stretches
    for index in range(coordinates.size):
        basis = np.linalg.qr(np.delete(jacobian, index, axis=1))[0] if coordinates.size > 1 else jacobian[:, :0]
        direction = covariance[:, index] / errors[index]
        linear = jacobian @ direction
        unit = float(np.linalg.norm(linear - basis @ (basis.T @ linear)))
        for side, sign in enumerate((-1.0, 1.0)):
            stretch = 1.0
            for _ in range(MOST_CORRECTIONS):
                moved = change(sign * REFERENCE_WIDTH * stretch * direction)
                if moved is None or not unit > 0.0:
                    break
                reached = float(np.linalg.norm(moved - basis @ (basis.T @ moved))) / (REFERENCE_WIDTH * unit)
                if abs(reached - 1.0) <= CORRECTED or not reached > 0.0:
                    break
                stretch = float(np.clip(stretch / reached, LEAST_STRETCH, GREATEST_STRETCH))
            stretches[index, side] = stretch if abs(stretch - 1.0) > LEAST_CURVATURE else 1.0
    return stretches
