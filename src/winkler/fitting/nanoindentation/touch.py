r"""Fit of the first part of a loading by a law of the touch: position, standard error and baseline.

Laws of the first part of a loading: a power of the depth, or the area function of a known tip.

Without the tip, :math:`F = K x^n` with the depth :math:`x` since first touch.  With it, the depth is that of the
contact and its elastic rim,

.. math:: x = h_c + \kappa\sqrt{A(h_c)}, \qquad F = K\,A(h_c)\,h_c^{\,q},

so that a blunt tip changes the exponent as it does: :math:`\kappa = \epsilon\sqrt\pi H/(2E_r)`, and q is the change of
the hardness with depth, negative for a size effect and positive where the first contact is elastic.

Calibrated coefficients of both signs may give an area that falls or is negative close to the apex.  Below the depth
from which on :math:`A\sim h^m` with m from 1 (a ball) to 2 (a cone), that power takes its place.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.noise.estimate import noise_of
from winkler.numerics.types import Array

LEAST_POINTS = 8
MOST_STARTED = 300
"""Points from which a start is sought."""
CANDIDATES = 30
"""Positions that are tried as a start."""
STEPS = 2
"""Fits, each with the weights of the one before."""
DETERMINED = 1e-4
"""Least part of the effect of a number of the law that no other number has; below it only its prior knows it."""


class Touch(NamedTuple):
    """Position [m], its standard error [m], and force before contact [N]."""

    position: float
    error: float
    baseline: float


def white_noise(samples: Array) -> float:
    """Return the white noise of samples of a smooth course, from their third differences (median)."""
    if samples.size < 5:
        return 0.0
    return float(np.median(np.abs(np.diff(samples, 3)))) / (0.6745 * math.sqrt(20.0))


def fitted_touch(depth: Array, force: Array, coefficients: Array, rim: float) -> Touch:
    """Return position, error and baseline of the touch.

    Parameters
    ----------
    depth, force : ndarray, (n,)
        Of the first part of the loading [m], [N].
    coefficients : ndarray, (k,)
        Of the area function of the tip; none where it is not known.
    rim : float
        kappa of the sample, where the area function is known.
    """
    from scipy.optimize import least_squares

    low, high = float(depth.min()), float(depth.max())
    span, top = max(high - low, np.finfo(float).tiny), float(np.ptp(force)) or 1.0
    law = _law(coefficients, rim, span)
    x, y = (depth - low) / span, force / top
    thin = -(-x.size // MOST_STARTED)
    start, free = _start(x[::thin], y[::thin], law)
    s_depth, s_force = white_noise(depth) / span, max(white_noise(force) / top, 1e-6)
    own = len(law.means)
    places = np.arange(2, 2 + own)
    means, spreads = np.array(law.means), np.array(law.spreads)

    def predicted(p: Array) -> tuple[Array, Array]:
        in_contact = x > p[0]
        shape, slope, rest = law.course(np.maximum(x - p[0], 0.0), p[places])
        scale = np.exp(p[1]) * in_contact
        columns = [-scale * slope, scale * shape, *(scale * one for one in rest)]
        return scale * shape + (p[2 + own] if free else 0.0), np.stack(
            [*columns, *([np.ones_like(x)] if free else [])], axis=1
        )

    weight, prior = np.ones_like(x), s_force / spreads
    count = 2 + own + free
    latest = float(np.partition(x, -LEAST_POINTS)[-LEAST_POINTS]) if x.size >= LEAST_POINTS else 1.0
    edges = [(-1.0, latest), (-30.0, 30.0), *law.limits, (-1.0, 1.0)][:count]
    low_bounds, high_bounds = np.array(edges).T
    of_prior = np.eye(count)[places]
    p = np.clip(start[:count], low_bounds, high_bounds)
    for _ in range(STEPS):
        result = least_squares(
            lambda q: np.append(weight * (predicted(q)[0] - y), prior * (q[places] - means)),  # noqa: B023
            p,
            jac=lambda q: np.vstack([weight[:, None] * predicted(q)[1], prior[:, None] * of_prior]),  # noqa: B023
            bounds=(low_bounds, high_bounds),
            x_scale=np.array([0.05, 0.3, *([0.2, 0.05][:own]), 0.05])[:count],
            max_nfev=100,
        )
        p = result.x
        slope = np.abs(predicted(p)[1][:, 0])
        weight = 1.0 / np.sqrt(1.0 + np.minimum((slope * s_depth / s_force) ** 2, 1e4))
    course, jacobian = predicted(p)
    if np.count_nonzero(x > p[0]) < LEAST_POINTS or p[0] >= high_bounds[0]:
        return Touch(low, math.inf, 0.0)  # too few points in contact, or a touch on its bound
    weighted = weight[:, None] * jacobian
    known = _determined(weighted, places)
    chosen = of_prior[:, known]
    try:
        noise = noise_of(weight * (y - course), weighted[:, known], np.zeros((x.size, 0)))
        precision = np.linalg.inv(noise.covariance) + (chosen.T / spreads**2) @ chosen
        variance = float(np.linalg.inv(precision)[0, 0])
    except np.linalg.LinAlgError:  # so few points that they do not determine all numbers
        return Touch(low, math.inf, 0.0)
    if not variance >= 0.0:  # unknown, not zero
        return Touch(low, math.inf, 0.0)
    baseline = float(p[2 + own]) * top if free else 0.0
    return Touch(low + span * float(p[0]), span * math.sqrt(variance), baseline)


def _determined(jacobian: Array, places: Array) -> Array:
    """Return the columns whose numbers the curve determines beside the others.

    Of a pyramid the elastic rim changes only the factor of the force, and of a short range the exponent hardly more:
    the covariance has no inverse then, and an error of the touch would follow from rounding.
    """
    kept = list(range(jacobian.shape[1]))
    unit = jacobian / np.maximum(np.linalg.norm(jacobian, axis=0), np.finfo(float).tiny)
    for place in reversed(places.tolist()):
        others = [one for one in kept if one != place]
        left = unit[:, place] - unit[:, others] @ np.linalg.lstsq(unit[:, others], unit[:, place], rcond=None)[0]
        if float(np.linalg.norm(left)) < DETERMINED:
            kept = others
    return np.array(kept)


def _law(coefficients: Array, rim: float, span: float) -> TouchLaw:
    """Return the law for depths in parts of the range."""
    if not coefficients.size:
        return TouchByPower()
    scaled = coefficients * span ** (2.0 ** (1.0 - np.arange(coefficients.size)) - 2.0)
    return TouchByArea.of(scaled, rim)


def _start(x: Array, y: Array, law: TouchLaw) -> tuple[Array, bool]:
    """Return a start (D_0, ln K, the law's own, F_0), and whether points before contact fix the baseline."""
    best, found = math.inf, np.array([0.0, 0.0, *law.starts[0], 0.0])
    for place in np.linspace(-0.3, 0.95, CANDIDATES):
        gap = np.maximum(x - place, 0.0)
        if np.count_nonzero(gap) < 4:
            break
        before = x < place
        for own in law.starts:
            course = law.course(gap, np.array(own))[0] * (gap > 0.0)
            rows = np.stack([course, np.ones_like(x)], axis=1) if np.count_nonzero(before) > 4 else course[:, None]
            numbers, *_ = np.linalg.lstsq(rows, y, rcond=None)
            misfit = float(np.sum((rows @ numbers - y) ** 2))
            if misfit < best and numbers[0] > 0.0:
                best = misfit
                found = np.array([place, math.log(numbers[0]), *own, numbers[1] if numbers.size > 1 else 0.0])
    return found, bool(np.count_nonzero(x < found[0]) > 4)


NODES = 400
BALL, CONE = 1.0, 2.0
"""Exponents of their sections over the depth."""
SMALLEST = 1e-9
"""Least depth since touch, in parts of the fitted range: derivatives stay finite."""


class TouchByPower(NamedTuple):
    """f = x^n; 1 for plastic contact of a ball, 3/2 for an elastic one, 2 for a pyramid."""

    means: tuple[float, ...] = (1.6,)
    spreads: tuple[float, ...] = (0.25,)
    limits: tuple[tuple[float, float], ...] = ((1.0, 2.6),)
    starts: tuple[tuple[float, ...], ...] = ((1.0,), (1.35,), (1.7,), (2.05,), (2.4,))

    def course(self, gap: Array, numbers: Array) -> tuple[Array, Array, Array]:
        """Return f, df/dx and the derivative by the exponent."""
        gap = np.maximum(gap, SMALLEST)
        power = gap ** numbers[0]
        return power, numbers[0] * power / gap, (power * np.log(gap))[None, :]


POWER_SPREAD = 0.25
"""Standard deviation of q."""
RIM_SPREAD = 0.3
"""Standard deviation of kappa in parts of it: the hardness at first touch is not that at the peaks."""


class TouchByArea(NamedTuple):
    """f = A(h_c) h_c^q with x = h_c + kappa sqrt(A), by the coefficients of A for depths in parts of the range.

    Parameters
    ----------
    coefficients : ndarray, (m,)
    apex : tuple of float
        Depth below which A is a power, and its exponent; zero depth where A grows from the apex on.
    means, spreads, limits, starts
        Of q and kappa, as of a `TouchByPower`.
    """

    coefficients: Array
    apex: tuple[float, float]
    means: tuple[float, ...]
    spreads: tuple[float, ...]
    limits: tuple[tuple[float, float], ...]
    starts: tuple[tuple[float, ...], ...]

    @staticmethod
    def of(coefficients: Array, rim: float) -> TouchByArea:
        """Return the law of a tip on a sample whose kappa is known from its unloadings."""
        limits, starts = ((-0.6, 0.8), (0.0, 4.0 * rim)), ((0.0, rim), (-0.4, rim))
        apex, spreads = apex_of(coefficients), (POWER_SPREAD, RIM_SPREAD * rim)
        return TouchByArea(coefficients, apex, (0.0, rim), spreads, limits, starts)

    def course(self, gap: Array, numbers: Array) -> tuple[Array, Array, Array]:
        """Return f, df/dx and the derivatives by q and kappa."""
        power, rim = float(numbers[0]), float(numbers[1])
        nodes = np.linspace(0.0, math.sqrt(max(float(gap.max()), SMALLEST)), NODES) ** 2
        reached = nodes + rim * np.sqrt(self._area(nodes)[0])
        height = np.maximum(np.interp(gap, reached, nodes), SMALLEST)
        for _ in range(2):  # the nodes are close enough for two steps of Newton
            size, slope = self._area(height)
            excess = height + rim * np.sqrt(size) - np.maximum(gap, SMALLEST)
            height = np.maximum(height - excess / (1.0 + 0.5 * rim * slope / np.sqrt(size)), 0.1 * height)
        size, slope = self._area(height)
        law = size * height**power
        by_height = law * (slope / size + power / height)
        by_gap = by_height / (1.0 + 0.5 * rim * slope / np.sqrt(size))
        return law, by_gap, np.stack([law * np.log(height), -by_gap * np.sqrt(size)])

    def _area(self, height: Array) -> tuple[Array, Array]:
        """Return A and dA/dh at depths."""
        end, exponent = self.apex
        deep = np.maximum(height, max(end, SMALLEST))
        size, slope = _polynomial(self.coefficients, deep)
        below, share = height < end, height / deep
        power = size * share**exponent
        return np.where(below, power, size), np.where(below, exponent * size * share ** (exponent - 1.0) / deep, slope)


def apex_of(coefficients: Array) -> tuple[float, float]:
    """Return the depth, in parts of the range, below which an area is a power of the depth, and its exponent.

    The depth is zero where the area is positive and grows from the apex on, and one where it grows nowhere.

    Examples
    --------
    >>> apex_of(np.array([24.5, 1.0]))
    (0.0, 1.0)
    """
    depths = np.geomspace(SMALLEST, 1.0, NODES)
    size, slope = _polynomial(coefficients, depths)
    wrong = (size <= 0.0) | (slope <= 0.0)
    if not np.any(wrong):
        return 0.0, BALL
    exponent = np.where(wrong, 0.0, depths * slope / np.where(wrong, 1.0, size))
    inside = (exponent >= BALL) & (exponent <= CONE)
    inside[: int(np.flatnonzero(wrong)[-1])] = False
    place = int(np.argmax(inside)) if np.any(inside) else NODES - 1
    return float(depths[place]), float(np.clip(exponent[place], BALL, CONE))


def _polynomial(coefficients: Array, height: Array) -> tuple[Array, Array]:
    exponents = 2.0 ** (1.0 - np.arange(coefficients.size))
    parts = coefficients[:, None] * height[None, :] ** exponents[:, None]
    return np.asarray(parts.sum(axis=0)), np.asarray((exponents[:, None] * parts).sum(axis=0) / height)


TouchLaw = TouchByPower | TouchByArea
"""A law F = K f(x) with further numbers, all in parts of the fitted range and its greatest force."""
