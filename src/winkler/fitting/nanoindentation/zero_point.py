r"""The point of first touch of an indentation, with its standard error.

The first part of the first loading is fitted by :math:`F = F_0 + K\,(D-D_0)_+^n`, with an exponent between that of a
flat
punch, 1, and above that of a cone, 2: a blunt tip passes from 3/2 to 2.  Points without contact before the touch fix
the
baseline :math:`F_0`; without them it is zero, and the touch is extrapolated.  The change with the fitted range is
part of the error: ranges of growing force are fitted, and the largest is taken that agrees with all smaller ones
(Lepski's rule), so that the changing exponent of a blunt tip does not shift the touch.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.noise.estimate import noise_of
from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["ZeroPoint", "found_zero_point", "white_noise"]

SMALLEST_WINDOW, WINDOW_RATIO, LARGEST_WINDOW = 25.0, 2.0, 0.25
"""Ranges of forces that are fitted: the smallest over the noise, the ratio, and the largest over the greatest force."""
AGREEMENT = 1.0
"""Greatest difference to the touch of a smaller range, in its standard errors, of a range that is taken."""
MOST_DOUBT = 3.0
"""Greatest contribution of the change with the range, in standard errors: small ranges may know nothing."""
MOST_STARTED = 300
"""Points from which a start is sought."""
LEAST_POINTS = 8
EXPONENTS = np.linspace(1.0, 2.4, 5)
EXPONENT_RANGE = (1.0, 2.6)
USUAL_EXPONENT, EXPONENT_SPREAD = 1.6, 0.25
"""Exponent of the first part of a loading, its standard deviation: 1 plastic under a ball, 3/2 elastic, 2 pyramid."""
CANDIDATES = 30
"""Positions that are tried as a start."""
MOST_POINTS = 3000


@value
class ZeroPoint:
    """Position of first touch.

    Parameters
    ----------
    position : float
        D_0 [m].
    error : float
        Its standard error [m], the doubt about the fitted range included.
    baseline : float
        Force before contact [N]; zero where no point was taken before contact.
    extrapolated : bool
        Whether no point was taken before contact.
    """

    __words__ = words(
        position=("D_0", "m", "position of first touch"),
        error=("u(D_0)", "m", "standard error of the position of first touch"),
        extrapolated=("", None, "whether no point was taken before contact"),
    )

    position: float
    error: float
    baseline: float
    extrapolated: bool


class _Touch(NamedTuple):
    position: float
    error: float
    baseline: float


def white_noise(samples: Array) -> float:
    """Return the white noise of samples of a smooth course, from their third differences (median)."""
    if samples.size < 5:
        return 0.0
    return float(np.median(np.abs(np.diff(samples, 3)))) / (0.6745 * math.sqrt(20.0))


def found_zero_point(curve: ForceCurve) -> ZeroPoint:
    """Return where an indentation first touches.

    Parameters
    ----------
    curve : ForceCurve
        With its first loading; corrected for drift, if there is any.

    Raises
    ------
    InvalidInput
        If the first loading has fewer than twelve points at low forces.
    """
    depth, force = curve.depth(0.0), curve.force
    first = curve.segments[0] if curve.segments else None
    end = first.last if first is not None and first.count >= LEAST_POINTS else int(np.argmax(force))
    depth, force = depth[: end + 1], force[: end + 1]
    found: list[_Touch] = []
    chosen = 0
    for limit in _windows(float(force.max()), white_noise(force)).tolist():
        count = int(np.argmax(force > limit)) or force.size
        if count < LEAST_POINTS:
            continue
        step = -(-count // MOST_POINTS)
        touch = _touch(depth[:count:step], force[:count:step])
        if not math.isfinite(touch.error):
            continue
        if any(abs(touch.position - one.position) > AGREEMENT * one.error for one in found):
            break
        chosen = count
        found.append(touch)
    if not found:
        raise InvalidInput(
            f"found_zero_point: curve '{curve.name}' has fewer than {LEAST_POINTS} points of contact at low forces "
            "of its first loading: give contact_point with its error."
        )
    taken = found[-1]
    doubt = min(max(abs(taken.position - one.position) for one in found), MOST_DOUBT * taken.error)
    error = math.hypot(taken.error, doubt)
    free = int(np.count_nonzero(depth[:chosen] < taken.position - 2.0 * error))
    position, baseline = taken.position, taken.baseline
    if free < 5:
        position, error = _not_before_the_first_point(depth, force, position, error)
    return ZeroPoint(position, error, baseline, free < 5)


def _not_before_the_first_point(depth: Array, force: Array, position: float, error: float) -> tuple[float, float]:
    """Return position and error of a touch from which the first force could have grown, as its power of at most 2."""
    least = 4.0 * max(float(force[0]), white_noise(force))
    next_one = int(np.argmax(force > least))
    step = max(float(depth[next_one] - depth[0]), 0.0)
    earliest, latest = float(depth[0]) - step, float(depth[0]) + step
    if earliest <= position <= latest:
        return position, error
    width = max(latest - earliest, white_noise(depth))
    bounded = min(max(position, earliest), latest)
    return bounded, max(width / math.sqrt(12.0), min(error, width))


def _windows(top: float, noise: float) -> Array:
    """Return the greatest forces of the ranges, growing."""
    largest = LARGEST_WINDOW * top
    smallest = min(max(SMALLEST_WINDOW * noise, 1e-4 * top), largest)
    count = 1 + round(math.log(largest / smallest) / math.log(WINDOW_RATIO))
    return np.geomspace(smallest, largest, max(count, 2))


def _touch(depth: Array, force: Array) -> _Touch:
    """Return position, error and baseline of the touch."""
    from scipy.optimize import least_squares

    low, high = float(depth.min()), float(depth.max())
    span, top = max(high - low, np.finfo(float).tiny), float(np.ptp(force)) or 1.0
    x, y = (depth - low) / span, force / top
    thin = -(-x.size // MOST_STARTED)
    start, free = _start(x[::thin], y[::thin])
    s_depth, s_force = white_noise(depth) / span, max(white_noise(force) / top, 1e-6)

    def law(p: Array) -> tuple[Array, Array]:
        gap = np.maximum(x - p[0], 1e-9)
        in_contact = x > p[0]
        course = np.exp(p[1]) * gap ** p[2] * in_contact
        columns = [-p[2] * course / gap, course, course * np.log(gap)]
        return course + (p[3] if free else 0.0), np.stack([*columns, *([np.ones_like(x)] if free else [])], axis=1)

    weight, prior = np.ones_like(x), s_force / EXPONENT_SPREAD
    low_bounds = [-1.0, -20.0, EXPONENT_RANGE[0], -1.0][: 3 + free]
    high_bounds = [0.98, 20.0, EXPONENT_RANGE[1], 1.0][: 3 + free]
    of_exponent = np.eye(3 + free)[2]
    p = np.clip(start[: 3 + free], low_bounds, high_bounds)
    for _ in range(2):
        result = least_squares(
            lambda q: np.append(weight * (law(q)[0] - y), prior * (q[2] - USUAL_EXPONENT)),  # noqa: B023
            p,
            jac=lambda q: np.vstack([weight[:, None] * law(q)[1], prior * of_exponent]),  # noqa: B023
            bounds=(low_bounds, high_bounds),
            x_scale=np.array([0.05, 0.3, 0.2, 0.05])[: 3 + free],
            max_nfev=100,
        )
        p = result.x
        slope = np.abs(law(p)[1][:, 0])
        weight = 1.0 / np.sqrt(1.0 + np.minimum((slope * s_depth / s_force) ** 2, 1e4))
    predicted, jacobian = law(p)
    if np.count_nonzero(x > p[0]) < LEAST_POINTS:
        return _Touch(low, math.inf, 0.0)
    try:
        noise = noise_of(weight * (y - predicted), weight[:, None] * jacobian, np.zeros((x.size, 0)))
        precision = np.linalg.inv(noise.covariance) + np.outer(of_exponent, of_exponent) / EXPONENT_SPREAD**2
        variance = max(float(np.linalg.inv(precision)[0, 0]), 0.0)
    except np.linalg.LinAlgError:  # so few points that they do not determine all numbers
        return _Touch(low, math.inf, 0.0)
    baseline = float(p[3]) * top if free else 0.0
    return _Touch(low + span * float(p[0]), span * math.sqrt(variance), baseline)


def _start(x: Array, y: Array) -> tuple[Array, bool]:
    """Return a start (D_0, ln K, n, F_0), and whether points before contact fix the baseline."""
    best, found = math.inf, np.array([0.0, 0.0, 1.5, 0.0])
    for place in np.linspace(-0.3, 0.95, CANDIDATES):
        gap = np.maximum(x - place, 0.0)
        if np.count_nonzero(gap) < 4:
            break
        before = x < place
        for exponent in EXPONENTS:
            course = gap**exponent
            rows = np.stack([course, np.ones_like(x)], axis=1) if np.count_nonzero(before) > 4 else course[:, None]
            numbers, *_ = np.linalg.lstsq(rows, y, rcond=None)
            misfit = float(np.sum((rows @ numbers - y) ** 2))
            if misfit < best and numbers[0] > 0.0:
                best = misfit
                found = np.array([place, math.log(numbers[0]), exponent, numbers[1] if numbers.size > 1 else 0.0])
    return found, bool(np.count_nonzero(x < found[0]) > 4)
