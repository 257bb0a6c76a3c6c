"""Least squares within bounds, every evaluation counted by the search."""

from __future__ import annotations

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.fitting.search import Search
from winkler.fitting.task import FitTask, Prediction
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array

__all__ = ["bounds", "solved"]

MOST_PREDICTIONS = 1000
"""A hold too short for its relaxation time takes some 500 to settle in the flat valley of its misfit."""
COARSE_PREDICTIONS, COARSELY_SETTLED = 25, 1e-3
LOGARITHM_RANGE = 30.0
"""Greatest distance of a logarithm from its start."""
REFUSED_RESIDUAL = 10.0
"""Residual outside the validity of the theory, relative to the norm of the measured quantity."""


def solved(task: FitTask, coordinates: Array, search: Search, *, coarse: bool = False) -> tuple[Array, float]:
    """Return the coordinates of least squares, and the sum there.

    Parameters
    ----------
    task : FitTask
    coordinates : ndarray, (p,)
        Start.
    search : Search
        Counts the predictions.
    coarse : bool
        Whether a few predictions suffice.

    Raises
    ------
    NotConverged
        If the predictions do not suffice, unless it is coarse, or the time limit is reached.
    """
    from scipy.optimize import least_squares

    low, high = bounds(task.parameters, coordinates)
    margin = 1e-9 * (1.0 + np.abs(coordinates))
    inside = np.maximum(np.minimum(coordinates, high - margin), low + margin)
    size = float(np.linalg.norm(task.measured * task.weights)) or 1.0
    count = int(np.count_nonzero(task.weights))
    evaluations, settled = (COARSE_PREDICTIONS, COARSELY_SETTLED) if coarse else (MOST_PREDICTIONS, task.settled)
    last: dict[bytes, Prediction] = {}
    search.begin()

    def predicted(at: Array) -> Prediction:
        key = at.tobytes()
        if key not in last:
            last.clear()
            last[key] = task.prediction(at)
        return last[key]

    def misfit(at: Array) -> Array:
        try:
            residuals = task.residuals_of(predicted(at)) / -size
        except OutsideValidity:
            if np.array_equal(at, inside):
                raise
            residuals = np.full(task.measured.size, REFUSED_RESIDUAL)  # outside the validity of the theory
        search.record(task.numbers(at), float(residuals @ residuals) * size**2, count)
        return residuals

    def slopes(at: Array) -> Array:
        search.check()
        return task.decorrelated(task.jacobian(at, predicted(at)) / size)

    result = least_squares(
        misfit,
        inside,
        jac=slopes,
        bounds=(low, high),
        x_scale="jac",
        max_nfev=evaluations,
        ftol=settled,
        xtol=settled,
        gtol=1e-15,
    )
    if not result.success and not coarse:
        raise NotConverged(
            f"fit: least squares have not settled after {evaluations} predictions; give bounds or starts nearer to the "
            "answer, or fewer free numbers."
        )
    return np.asarray(result.x), float(2.0 * result.cost) * size**2


def bounds(parameters: tuple[Parameter, ...], coordinates: Array) -> tuple[Array, Array]:
    """Return the lowest and highest coordinates, logarithms not too far from where they begin."""
    low = np.array([parameter.inward(parameter.low) for parameter in parameters])
    high = np.array([parameter.inward(parameter.high) for parameter in parameters])
    wide = np.array([LOGARITHM_RANGE if parameter.logarithmic else np.inf for parameter in parameters])
    return np.maximum(low, coordinates - wide), np.minimum(high, coordinates + wide)
