"""Generalised least squares of area coefficients and frame compliance over the readings of reference samples."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.fitting.nanoindentation.readings import area_of
from winkler.numerics.types import Array

COMMON_ZERO = 0.25
"""Part of the variance of the zero points that all curves share: their laws of the first contact fail alike."""
DEPTH_STEP = 1e-5
GAUSS_STEPS = 3
NARROWER = 0.5
"""Width of what is expected of a coefficient over that of the one before: later ones are corrections of a pyramid."""
PLACES = 256
"""Places at which the coefficients of a frame are averaged."""
COARSE_FRAMES, FINE_FRAMES = 48, 32
FEWEST_LIKELY = 8
"""Likely frames of a grid that needs no finer one."""
MOST_REFINEMENTS = 6
STIFFEST_SHARE = 0.95
"""Greatest compliance of the frame in parts of the least measured one."""
TAIL = 0.025
"""Part of the probability beyond each end of an interval."""
NORMAL_WIDTH = 1.959963984540054
"""Half-width of that interval of a normal distribution, in standard deviations."""
LEAST_WEIGHT = 1e-6
"""Least weight of a frame that is looked at more closely."""


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
    """Frame compliance and coefficients, their covariance, residuals, factor of the scatter, and weights of counts."""

    numbers: Array
    covariance: Array
    residuals: Array
    factor: float
    weights: Array


def _residuals(numbers: Array, readings: ReferenceReadings, shape_factor: float, shift: Array | float = 0.0,
               softer: Array | float = 0.0) -> Array:  # fmt: skip
    """Return ln of the contact's measured compliance over that of the model."""
    own = np.maximum(readings.compliance + softer - numbers[0], 1e-3 * readings.compliance)
    contact = readings.depth + shift - numbers[0] * readings.force - readings.intercept * readings.force * own
    contact = np.maximum(contact, 1e-3 * readings.depth)
    area = np.maximum(area_of(numbers[1:], contact), np.finfo(float).tiny)
    return np.asarray(np.log(own * 2.0 * shape_factor * readings.reference * np.sqrt(area / np.pi)))


def fitted_area(
    readings: ReferenceReadings, counts: Sequence[int], shape_factor: float, known: float | None
) -> AreaFit:
    """Return frame compliance and coefficients as middles of their intervals over frames and numbers of coefficients.

    Each frame and number of coefficients counts by the probability of the readings, averaged over all coefficients
    that are not negative.  All numbers of coefficients, and all frames from no compliance to nearly the least one
    measured, are equally probable before.  The noise of a residual belongs to the frame: it is relative to the
    compliance of the contact, which a soft frame leaves small.
    """
    frames = _likely_frames(readings, max(counts), shape_factor) if known is None else np.array([known])
    found = _conditional(frames, counts, readings, shape_factor)
    by_frame = found.weights.sum(axis=1)
    share = found.weights / np.maximum(by_frame, np.finfo(float).tiny)[:, None]
    courses = np.einsum("fc,fck->fk", share, found.means)
    low, middle, high = _ends(frames, by_frame)
    fitted = by_frame > 0.0
    numbers, *ends = (
        np.array([place, *(np.interp(place, frames[fitted], course) for course in courses[fitted].T)])
        for place in (middle, low, high)
    )
    along = (ends[1] - ends[0]) / (2.0 * NORMAL_WIDTH)
    slope = along / along[0] if along[0] > 0.0 else np.zeros_like(along)
    size = float(readings.depth.max())
    scale = np.array([size ** (2.0 - 2.0 ** (1 - n)) for n in range(max(counts))])
    apart = (found.means - numbers[1:] - (frames - middle)[:, None, None] * slope[1:]) * scale
    covariance = np.outer(along, along)
    covariance[1:, 1:] += np.einsum("fc,fci,fcj->ij", found.weights, apart, apart) / np.outer(scale, scale)
    covariance[1:, 1:] += np.einsum("fc,fcij->ij", found.weights, found.covariances)
    residuals = _residuals(numbers, readings, shape_factor)
    return AreaFit(numbers, covariance, residuals, found.factor, found.weights.sum(axis=0))


def _likely_frames(readings: ReferenceReadings, count: int, shape_factor: float) -> Array:
    """Return frames over all that are likely; the greatest number of coefficients makes more of them likely."""
    frames = np.linspace(0.0, STIFFEST_SHARE, COARSE_FRAMES) * float(readings.compliance.min())
    for _ in range(MOST_REFINEMENTS):
        weights = _conditional(frames, [count], readings, shape_factor).weights[:, 0]
        likely = np.flatnonzero(weights > LEAST_WEIGHT * weights.max())
        ends = frames[[max(likely[0] - 1, 0), min(likely[-1] + 1, frames.size - 1)]]
        frames = np.linspace(ends[0], ends[1], FINE_FRAMES)
        if likely.size >= FEWEST_LIKELY:
            break
    return frames


def _ends(frames: Array, weights: Array) -> tuple[float, float, float]:
    """Return the ends of the central interval of 95 % of the frame, and its middle between them."""
    if frames.size == 1:
        return float(frames[0]), float(frames[0]), float(frames[0])
    steps = 0.5 * (weights[1:] + weights[:-1])
    reached = np.concatenate([[0.0], np.cumsum(steps)]) / steps.sum()
    low, high = np.interp([TAIL, 1.0 - TAIL], reached, frames).tolist()
    return low, 0.5 * (low + high), high


class _Conditional(NamedTuple):
    """Of f frames and c numbers of coefficients: weights, coefficients and their covariances; factor of the scatter."""

    weights: Array
    means: Array
    covariances: Array
    factor: float


def _conditional(
    frames: Array, counts: Sequence[int], readings: ReferenceReadings, shape_factor: float
) -> _Conditional:
    most, size = max(counts), readings.force.size
    squares = np.full((frames.size, len(counts)), np.inf)
    freedom = np.ones(squares.shape)
    lines: dict[tuple[int, int], _LinearArea] = {}
    for place, frame in enumerate(frames.tolist()):
        own = readings.compliance - frame
        contact = readings.depth - frame * readings.force - readings.intercept * readings.force * own
        if not np.all(contact > 0.0):
            continue
        measured = np.pi * (1.0 / (2.0 * shape_factor * readings.reference * own)) ** 2
        powers = np.stack([contact ** (2.0 ** (1 - n)) for n in range(most)], axis=1)
        first = _line(powers, measured, np.eye(size)).numbers
        whiten = np.linalg.inv(np.linalg.cholesky(covariance_of(np.array([frame, *first]), readings, shape_factor)))
        for number, count in enumerate(counts):
            line = _line(powers[:, :count], measured, whiten)
            lines[place, number], squares[place, number] = line, float(line.left @ line.left)
            used = np.count_nonzero(line.numbers) + (frames.size > 1)
            freedom[place, number] = np.maximum(size - used, 1.0)
    factor = float(np.min(squares / freedom))
    free = max(float(freedom.flat[int(np.argmin(squares / freedom))]), 1.0)
    wide = max(factor, 1.0) * free / max(free - 2.0, 1.0)
    logarithms = np.full(squares.shape, -np.inf)
    means, covariances = np.zeros((*squares.shape, most)), np.zeros((*squares.shape, most, most))
    for (place, number), line in lines.items():
        count = counts[number]
        logarithms[place, number], means[place, number, :count], covariances[place, number, :count, :count] = _averaged(
            line, max(factor, 1.0), wide
        )
    weights = np.exp(logarithms - logarithms.max())
    return _Conditional(weights / weights.sum(), means, covariances, factor)


class _LinearArea(NamedTuple):
    """Coefficients, none below zero, residuals of unit variance there, their slopes, and what is expected before.

    Slopes are those by the coefficients over `scale`.
    """

    numbers: Array
    left: Array
    rows: Array
    scale: Array


def _line(powers: Array, measured: Array, whiten: Array) -> _LinearArea:
    """Return the most likely coefficients of a given frame, and the residuals about them."""
    from scipy.optimize import nnls

    area, shift = measured, np.zeros(measured.size)
    for _ in range(GAUSS_STEPS):
        rows = whiten @ (0.5 * powers / area[:, None])
        size = np.linalg.norm(rows, axis=0)
        numbers = nnls(rows / size, whiten @ (0.5 - shift))[0] / size
        area = np.maximum(powers @ numbers, 1e-3 * measured)
        shift = 0.5 * np.log(area / measured)
    deepest = int(np.argmax(measured))
    scale = measured[deepest] / powers[deepest] * NARROWER ** np.arange(powers.shape[1])
    return _LinearArea(numbers, whiten @ shift, whiten @ (0.5 * powers / area[:, None]) * scale, scale)


def _averaged(line: _LinearArea, scatter: float, wide: float) -> tuple[float, Array, Array]:
    """Return the logarithm of the probability of the readings, and mean and covariance of the coefficients.

    Before the readings, the area that a coefficient adds at the deepest of them is half of a normal distribution, as
    wide as the whole area for the first coefficient, half as wide for each next one.  What is below zero is cut off
    coefficient by coefficient (Geweke, Hajivassiliou, Keane).

    References
    ----------
    V. Hajivassiliou, D. McFadden, P. Ruud, J. Econometrics 72 (1996) 85-134, doi:10.1016/0304-4076(94)01716-6
    """
    from scipy.special import log_ndtr, ndtri_exp

    count, share = line.numbers.size, line.numbers / line.scale
    inverse = np.eye(count) + line.rows.T @ line.rows / scatter
    covariance = np.linalg.inv(inverse)
    middle = covariance @ (line.rows.T @ (line.rows @ share - line.left)) / scatter
    residuals = line.left + line.rows @ (middle - share)
    lower = np.linalg.cholesky(covariance)
    uniform = _uniform(count)
    normal, inside = np.zeros((len(uniform), count)), np.zeros(len(uniform))
    for k in range(count):
        end = log_ndtr((middle[k] + normal[:, :k] @ lower[k, :k]) / lower[k, k])
        normal[:, k] = -ndtri_exp(end + np.log(uniform[:, k]))
        inside += end
    weights = np.exp(inside - inside.max())
    size = float(residuals @ residuals) / scatter + float(middle @ middle)
    volume = float(np.log(weights.mean()) + inside.max() + np.sum(np.log(lower.diagonal()))) + count * math.log(2.0)
    weights /= weights.sum()
    shares = middle + normal @ lower.T
    mean = weights @ shares
    apart = (shares - mean) * np.sqrt(weights * wide / scatter)[:, None] * line.scale
    return volume - 0.5 * size, mean * line.scale, apart.T @ apart


@functools.cache
def _uniform(count: int) -> Array:
    """Return places that fill a cube evenly, none on its faces: parts of multiples of irrational numbers."""
    roots = np.sqrt([2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0])[:count]
    return np.asarray(np.modf(np.arange(1, PLACES + 1)[:, None] * roots)[0])


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
