r"""The power law of an unloading, F = T ((h - h_f)/(1 - h_f))^m, fitted with its covariance.

Depths are counted in parts of the greatest depth and forces in parts of the greatest force.  The covariance is that
under white and slow noise, see `winkler.fitting.noise`.  Its derivatives are taken at smoothed depths: at measured ones
they contain the noise of the residuals, and would seem to explain it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.noise.estimate import noise_of
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_EVALUATIONS = 200
SMOOTH_DEGREE = 5
EXPONENT_BOUNDS = (-12.0, 3.0)
"""Least and greatest ln(m - 1) that are tried."""
LEAST_FINAL_DEPTH = -10.0
"""Least h_f that is tried, in parts of the greatest depth."""


class UnloadingLaw(NamedTuple):
    """Numbers (ln of the force at the top, h_f, ln(m - 1)), their covariance, scatter, the force at all depths.

    Last are the part of the scatter's variance that is slow, the residuals of the fitted points, and their derivatives.
    """

    numbers: Array
    covariance: Array
    scatter: float
    fitted: Array
    slow_share: float
    residuals: Array
    jacobian: Array


def _smooth(depth: Array) -> Array:
    """Return depths without their noise: a polynomial of the order of the points."""
    from numpy.polynomial import legendre

    along = np.linspace(-1.0, 1.0, depth.size)
    return np.asarray(legendre.legval(along, legendre.legfit(along, depth, SMOOTH_DEGREE)))


def fitted_power_law(all_depths: Array, forces: Array, chosen: Array, *, with_noise: bool = True) -> UnloadingLaw:
    """Return the fitted law F = T ((h - h_f)/(1 - h_f))^m, everything in parts of the greatest.

    Without the noise of this unloading alone, covariance, scatter and its slow part are zero.
    """
    from scipy.optimize import least_squares

    depth, force = all_depths[chosen], forces[chosen]
    least = float(depth.min())

    def law(numbers: Array, depth: Array = depth) -> tuple[Array, Array]:
        share = (depth - numbers[1]) / (1.0 - numbers[1])
        power = 1.0 + np.exp(numbers[2])
        value_ = np.exp(numbers[0]) * np.maximum(share, 1e-12) ** power
        log = np.log(np.maximum(share, 1e-12))
        final = value_ * power * (1.0 / (1.0 - numbers[1]) - 1.0 / np.maximum(depth - numbers[1], 1e-12))
        return value_, np.stack([value_, final, value_ * log * (power - 1.0)], axis=1)

    best = None
    for share in (0.0, 0.5, 0.9):
        start = np.array([0.0, min(share * least, least - 1e-6), math.log(0.5)])
        result = least_squares(
            lambda at: law(at)[0] - force,
            start,
            jac=lambda at: law(at)[1],
            bounds=([-5.0, LEAST_FINAL_DEPTH, EXPONENT_BOUNDS[0]], [5.0, least - 1e-9, EXPONENT_BOUNDS[1]]),
            x_scale="jac",
            max_nfev=MOST_EVALUATIONS,
            ftol=1e-14,
            xtol=1e-14,
            gtol=1e-15,
        )
        if best is None or result.cost < best.cost:
            best = result
    if best is None or not best.success:
        raise NotConverged("OliverPharr: no power law fits the unloading; fit another part of it (upper, lower).")
    jacobian = law(best.x, np.maximum(_smooth(depth), least))[1]
    fitted = law(best.x, all_depths)[0]
    if not with_noise:
        return UnloadingLaw(best.x, np.zeros((3, 3)), 0.0, fitted, 0.0, np.asarray(-best.fun), jacobian)
    noise = noise_of(-best.fun, jacobian, np.zeros((depth.size, 0)))
    return UnloadingLaw(
        best.x, noise.covariance, noise.scatter, fitted, noise.slow_share, np.asarray(-best.fun), jacobian
    )
