"""Generalised least squares of area coefficients and frame compliance over the readings of reference samples."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.fitting.nanoindentation.readings import area_of
from winkler.numerics.types import Array

__all__ = ["COMMON_ZERO", "AreaFit", "ReferenceReadings", "covariance_of", "fitted_area", "slope_of"]

COMMON_ZERO = 0.25
"""Part of the variance of the zero points that all curves share: their laws of the first contact fail alike."""
DEPTH_STEP = 1e-5


class ReferenceReadings(NamedTuple):
    """Peaks of all unloadings: numbers, the curve and reference of each, and covariances of one curve each."""

    force: Array
    depth: Array
    compliance: Array
    intercept: Array
    reference: Array
    zero: Array
    blocks: list[tuple[Array, Callable[[Array, Array], Array]]]


class AreaFit(NamedTuple):
    """Frame compliance and coefficients, their covariance, residuals, criterion, and factor of the scatter."""

    numbers: Array
    covariance: Array
    residuals: Array
    criterion: float
    factor: float


def _residuals(numbers: Array, readings: ReferenceReadings, shape_factor: float, shift: Array | float = 0.0,
               softer: Array | float = 0.0) -> Array:  # fmt: skip
    """Return ln of the contact's measured compliance over that of the model."""
    own = np.maximum(readings.compliance + softer - numbers[0], 1e-3 * readings.compliance)
    contact = readings.depth + shift - numbers[0] * readings.force - readings.intercept * readings.force * own
    contact = np.maximum(contact, 1e-3 * readings.depth)
    area = np.maximum(area_of(numbers[1:], contact), np.finfo(float).tiny)
    return np.asarray(np.log(own * 2.0 * shape_factor * readings.reference * np.sqrt(area / np.pi)))


def fitted_area(readings: ReferenceReadings, count: int, shape_factor: float, known: float | None) -> AreaFit:
    """Return the generalised least-squares fit with `count` coefficients, those at zero left out."""
    from scipy.optimize import least_squares

    size = float(readings.depth.max())
    scale = np.array([float(readings.compliance.min()), *(size ** (2.0 - 2.0 ** (1 - n)) for n in range(count))])
    start = np.zeros(1 + count)
    area = np.pi * (1.0 / (2.0 * shape_factor * readings.reference * readings.compliance)) ** 2
    start[1] = float(np.median(area / (0.8 * readings.depth) ** 2))
    start[0] = 0.05 if known is None else known / scale[0]
    start[2:] = 0.02
    free = np.arange(1 + count) if known is None else np.arange(1, 1 + count)
    x = start.copy()
    whiten: Array = np.eye(readings.force.size)
    for _ in range(4):

        def misfit(part: Array) -> Array:
            full = x.copy()
            full[free] = part
            return np.asarray(whiten @ _residuals(full * scale, readings, shape_factor))  # noqa: B023

        high = np.full(free.size, np.inf)
        high[free == 0] = 0.95
        result = least_squares(misfit, np.clip(x[free], 1e-9, 0.9 * high), bounds=(0.0, high), xtol=1e-12, ftol=1e-12)
        x[free] = result.x
        covariance = covariance_of(x * scale, readings, shape_factor)
        whiten = np.linalg.inv(np.linalg.cholesky(covariance))
    active = np.array([place for place in free.tolist() if place <= 1 or x[place] > 1e-6])
    x[[place for place in free.tolist() if place not in active]] = 0.0
    residuals = _residuals(x * scale, readings, shape_factor)
    white = whiten @ residuals
    freedom = max(residuals.size - active.size, 1)
    factor = float(white @ white) / freedom
    rows = np.stack(
        [whiten @ slope_of(x * scale, place, scale[place], readings, shape_factor) for place in active], axis=1
    )
    inner = np.linalg.pinv(rows.T @ rows) * max(factor, 1.0) * freedom / max(freedom - 2, 1)
    whole = np.zeros((1 + count, 1 + count))
    whole[np.ix_(active, active)] = inner * np.outer(scale[active], scale[active])
    size_of = residuals.size
    criterion = size_of * math.log(max(factor, 1.0) * freedom / size_of + 1e-300) + math.log(size_of) * active.size
    criterion += (freedom * factor / max(factor, 1.0)) if factor < 1.0 else 0.0
    return AreaFit(x * scale, whole, residuals, criterion, factor)


def slope_of(numbers: Array, place: int, scale: float, readings: ReferenceReadings, shape_factor: float) -> Array:
    """Return the derivative of the residuals by a number in parts of its scale."""
    step = np.zeros(numbers.size)
    step[place] = DEPTH_STEP * scale
    ahead, behind = (_residuals(numbers + sign * step, readings, shape_factor) for sign in (1.0, -1.0))
    return (ahead - behind) / (2.0 * DEPTH_STEP)


def covariance_of(numbers: Array, readings: ReferenceReadings, shape_factor: float) -> Array:
    """Return the covariance of the residuals by noise, zero points and drifts."""
    deep, soft = DEPTH_STEP * readings.depth, DEPTH_STEP * readings.compliance
    by_depth, by_compliance = (
        (
            _residuals(numbers, readings, shape_factor, **{name: step})
            - _residuals(numbers, readings, shape_factor, **{name: -step})
        )
        / (2.0 * step)
        for name, step in (("shift", deep), ("softer", soft))
    )
    covariance = np.zeros((readings.force.size, readings.force.size))
    for which, block in readings.blocks:
        covariance[np.ix_(which, which)] = block(by_depth[which], by_compliance[which])
    together = by_depth * readings.zero
    covariance += COMMON_ZERO * np.outer(together, together)
    floor = (1e-6) ** 2 * np.eye(covariance.shape[0])
    return covariance + floor
