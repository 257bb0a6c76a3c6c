"""Rough outline of a curve without a model: onset of contact, noise, greatest force and tension."""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.medians import median
from winkler.numerics.types import Array

FEWEST = 10
"""Fewest points of one direction."""
SIGNAL_TO_NOISE = 5.0
"""Least force in contact over the noise."""
BASELINE_POINTS = 10
FAR_SHARE = 0.03
"""Part of the points, farthest from the sample, initially assumed free."""
FEWEST_FAR_POINTS = 5
MOST_SPLITS, BEHIND_DEGREE = 100, 3
"""Most trial ends of the baseline, and degree of the polynomial behind."""
LEAST_SLOPE_TO_ERROR, LEAST_FREE_SHARE = 4.0, 0.1
"""Least slope of a baseline over its standard error, and least part of the points on it."""
ROUNDING = 1e-15
"""What is added to sums of powers over their trace: polynomials that few points do not determine explain no more."""
MOST_SLOPE_SHARE = 0.3
"""Greatest slope of a baseline relative to the mean slope in contact."""


class CurveOutline(NamedTuple):
    """Rough outline of a curve.

    Parameters
    ----------
    contact_point : float
        Position below which the force stays within the noise [m].
    baseline : float
        Force of the line through the free points there [N].
    slope : float
        Of that line [N/m].
    noise : float
        Of the force [N].
    top : float
        Force at the largest position, above the baseline [N].
    pull : float
        Largest tension below the baseline [N], zero if it is within the noise.
    before : int
        Number of points before contact.
    """

    contact_point: float
    baseline: float
    slope: float
    noise: float
    top: float
    pull: float
    before: int


def single_direction(curve: ForceCurve) -> tuple[Array, Array]:
    """Return position and force of the approach, or else of the retraction, sorted towards the sample."""
    inward = curve.direction > 0.0
    selected = inward if np.count_nonzero(inward) >= FEWEST else curve.direction < 0.0
    chosen = np.flatnonzero(selected) if np.count_nonzero(selected) >= FEWEST else np.arange(curve.count)
    chosen = chosen[np.argsort(curve.position[chosen], kind="stable")]
    return curve.position[chosen], curve.force[chosen]


@functools.lru_cache(maxsize=2)
def outline(curve: ForceCurve) -> CurveOutline:
    """Return the rough outline of a curve; of the last ones it is kept, as checks and start of a fit both need it."""
    position, force = single_direction(curve)
    slope = _first_slope(position.tobytes(), force.tobytes())
    base = far_force(force - slope * position) + slope * position
    noise = median(np.abs(np.diff(force, 2))) / (0.6745 * math.sqrt(6.0))
    tip = max(3, force.size // 200)
    for _ in range(2):
        top = median(force[-tip:] - base[-tip:])
        pull = _pull(curve, noise, abs(top), slope)
        within_noise = np.flatnonzero(force <= base + max(4.0 * noise, 1e-3 * abs(top)))
        last = int(within_noise[-1]) if within_noise.size and top > 0.0 else int(0.5 * force.size)
        in_tension = np.flatnonzero(force < base - 0.5 * pull) if pull > 0.0 else within_noise[:0]
        free = int(0.9 * min([last, *in_tension[:1].tolist()]))
        if free < BASELINE_POINTS:
            break
        centred = position[:free] - position[:free].mean()
        slope = float(centred @ force[:free]) / max(float(centred @ centred), 1e-300)
        base = force[:free].mean() + slope * (position - position[:free].mean())
        noise = math.sqrt(float(np.sum((force - base)[:free] ** 2)) / (free - 2))
    return CurveOutline(float(position[last]), float(base[last]), slope, noise, top, pull, last)


@functools.lru_cache(maxsize=2)
def _first_slope(positions: bytes, forces: bytes) -> float:
    """Return the slope of the baseline, zero if a tilt is not certain or there is none [N/m].

    The points before a split follow a line, those behind it a cubic; the split with the least squares is taken.  The
    numbers are given as bytes, since the approach is looked at by itself and within the whole curve.
    """
    position, force = np.frombuffer(positions), np.frombuffer(forces)
    count, span = position.size, float(np.ptp(position))
    splits = np.unique(np.linspace(BASELINE_POINTS, count - BASELINE_POINTS, MOST_SPLITS).astype(int))
    if splits[0] < BASELINE_POINTS or not span > 0.0:
        return 0.0
    along, level = 2.0 * (position - position[0]) / span - 1.0, force - force.mean()
    powers = [np.ones(count)]
    for _ in range(2 * BEHIND_DEGREE):
        powers.append(powers[-1] * along)
    products = [power * level for power in powers[: BEHIND_DEGREE + 1]]
    starts = np.append(0, splits)
    sums, right = (np.cumsum([np.add.reduceat(row, starts) for row in rows], axis=1).T for rows in (powers, products))
    before = _explained(sums[:-1], right[:-1], 1)
    behind = _explained(sums[-1] - sums[:-1], right[-1] - right[:-1], BEHIND_DEGREE)
    split = int(splits[np.argmax(before + behind)])
    if split < LEAST_FREE_SHARE * count:
        return 0.0
    x, y = along[:split] - along[:split].mean(), level[:split] - level[:split].mean()
    spread = float(x @ x)
    if not spread > 0.0:
        return 0.0
    slope = float(x @ y) / spread
    left = y - slope * x
    certain = abs(slope) > LEAST_SLOPE_TO_ERROR * math.sqrt(float(left @ left) / max(split - 2, 1) / spread)
    behind_slope = float(np.ptp(level[split:])) / max(float(np.ptp(along[split:])), 1e-300)
    return 2.0 * slope / span if certain and abs(slope) < MOST_SLOPE_SHARE * behind_slope else 0.0


def _explained(sums: Array, right: Array, degree: int) -> Array:
    """Return the squares explained by polynomials ``(m,)``, from sums of powers and of their products with levels."""
    size = degree + 1
    matrices = sums[:, np.add.outer(np.arange(size), np.arange(size))]
    least = ROUNDING * np.trace(matrices, axis1=1, axis2=2)[:, None, None] * np.eye(size)
    solved = np.linalg.solve(matrices + least, right[:, :size, None])
    return np.asarray(np.sum(right[:, :size] * solved[:, :, 0], axis=1))


def far_force(force: Array) -> float:
    """Return the force far from the sample, of forces in the order of positions."""
    return median(force[: _far_count(force.size)])


def _far_count(points: int) -> int:
    return max(FEWEST_FAR_POINTS, int(FAR_SHARE * points))


def _pull(curve: ForceCurve, noise: float, top: float, slope: float) -> float:
    """Return the largest tension of either direction, relative to its far end and the slope of the baseline."""
    largest = 0.0
    for direction in (1.0, -1.0):
        own_points = curve.direction == direction
        if np.count_nonzero(own_points) < FEWEST:
            continue
        order = np.argsort(curve.position[own_points], kind="stable")
        force = (curve.force - slope * curve.position)[own_points][order]
        window = max(1, min(5, force.size // 50))
        smooth = np.convolve(force, np.ones(window) / window, mode="valid")
        pull = far_force(force) - float(smooth.min())
        # a median of n points has the variance pi/(2 n), in parts of that of one point
        uncertain = noise * math.sqrt(1.0 / window + 0.5 * math.pi / _far_count(force.size))
        if pull > SIGNAL_TO_NOISE * uncertain and pull > 1e-3 * top:
            largest = max(largest, pull)
    return largest
