"""Least squares within bounds, every evaluation counted by the search."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.fitting.search import Search
from winkler.fitting.task import FitTask
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

MOST_PREDICTIONS = 1000
"""A hold too short for its relaxation time takes some 500 to settle in the flat valley of its misfit."""
COARSE_PREDICTIONS, COARSELY_SETTLED = 25, 1e-3
MOST_FULL_STEPS = 12
LEAST_GAIN, NEGLIGIBLE_GAIN = 0.25, 1e-3
"""Least gain of a full step in parts of what is expected, and gain without effect in parts of the tolerance."""
LEAST_EIGENVALUE = 1e-10
"""Of the product of the derivatives, columns of unit length: below it steps are too inaccurate."""
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
    low, high = bounds(task.parameters, coordinates)
    margin = 1e-9 * (1.0 + np.abs(coordinates))
    inside = np.maximum(np.minimum(coordinates, high - margin), low + margin)
    size = float(np.linalg.norm(task.measured * task.weights)) or 1.0
    count = int(np.count_nonzero(task.weights))
    evaluations, settled = (COARSE_PREDICTIONS, COARSELY_SETTLED) if coarse else (MOST_PREDICTIONS, task.settled)
    search.begin()

    def misfit(at: Array) -> Array:
        try:
            residuals = task.residuals(at) / -size
        except OutsideValidity:
            if np.array_equal(at, inside):
                raise
            residuals = np.full(task.measured.size, REFUSED_RESIDUAL)  # outside the validity of the theory
        search.record(task.numbers(at), float(residuals @ residuals) * size**2, count)
        return residuals

    def slopes(at: Array) -> Array:
        search.check()
        return task.decorrelated(task.slopes(at) / size)

    begun = inside
    if task.has_one_optimum:
        begun, squares = _stepped(misfit, slopes, inside, low, high, settled)
        if squares is not None:
            return begun, squares * size**2
    from scipy.optimize import least_squares

    result = least_squares(
        misfit,
        begun,
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
            f"fit: least squares have not converged after {evaluations} predictions; give bounds or starts nearer "
            "to the answer, or fewer free numbers."
        )
    return np.asarray(result.x), float(2.0 * result.cost) * size**2


def _stepped(
    misfit: Callable[[Array], Array],
    slopes: Callable[[Array], Array],
    start: Array,
    low: Array,
    high: Array,
    settled: float,
) -> tuple[Array, float | None]:
    """Return the coordinates that full steps of Gauss and Newton reach, and the sum there; None if they do not settle.

    Most fits of one optimum settle after a few.  Where a step leaves the bounds, gains less than a part of what it
    should, or hardly determines a number, a trust region has to go on.
    """
    here, residuals = start, misfit(start)
    squares = float(residuals @ residuals)
    for _ in range(MOST_FULL_STEPS):
        jacobian = slopes(here)
        length = np.linalg.norm(jacobian, axis=0)
        if not np.all((length > 0.0) & (length < np.inf)):
            return here, None
        values, vectors = np.linalg.eigh((jacobian.T @ jacobian) / np.outer(length, length))
        if not values[0] > LEAST_EIGENVALUE:
            return here, None
        along = vectors.T @ ((jacobian.T @ residuals) / length)
        expected = float(np.sum(along**2 / values))
        further = here - (vectors @ (along / values)) / length
        if np.any(further <= low) or np.any(further >= high):
            return here, None
        if expected < NEGLIGIBLE_GAIN * settled * squares:
            return here, squares
        is_small = np.linalg.norm(further - here) < settled * (settled + np.linalg.norm(here))
        residuals = misfit(further)
        reached = float(residuals @ residuals)
        gained = squares - reached
        if is_small or (gained < LEAST_GAIN * expected and expected < settled * squares):
            return (further, reached) if gained > 0.0 else (here, squares)
        if not gained >= LEAST_GAIN * expected:
            return here, None
        here, squares = further, reached
        if gained < settled * squares:
            return here, squares
    return here, None


def bounds(parameters: tuple[Parameter, ...], coordinates: Array) -> tuple[Array, Array]:
    """Return the lowest and highest coordinates, logarithms not too far from where they begin."""
    low = np.array([parameter.inward(parameter.low) for parameter in parameters])
    high = np.array([parameter.inward(parameter.high) for parameter in parameters])
    wide = np.array([LOGARITHM_RANGE if parameter.logarithmic else np.inf for parameter in parameters])
    return np.maximum(low, coordinates - wide), np.minimum(high, coordinates + wide)
