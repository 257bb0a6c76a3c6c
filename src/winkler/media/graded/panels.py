r"""g and g' of measured and designed profiles on a graded half-space, kept as polynomials on panels.

The slope of a measured profile is a cubic spline less one degree, a sum of truncated powers :math:`(r-b)_+^m`; its
transform is a sum of closed forms, one for every knot, too many to be summed at each call.
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.jacobi_quadrature import gauss_jacobi
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.transforms import graded_abel
from winkler.numerics.types import Array
from winkler.profiles.designed import Designed
from winkler.profiles.measured import Measured
from winkler.profiles.smoothing import Spline
from winkler.values.value import value

TOLERANCE = 1e-11
"""Error of g' on panels, relative to the steepest slope of the profile."""


@value
class _OnPanels:
    """A transform kept as Chebyshev series on panels: g', and g as its integral."""

    gap_panels: Panels
    slope_panels: Panels
    k: float

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self.gap_panels(np.asarray(x, dtype=float))

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self.slope_panels(np.asarray(x, dtype=float))

    def gap_integral(self, x: Array) -> Array:
        """The integral of x^k g from 0 to x [m^(2+k)]."""
        # x^k g integrated by parts: the integral of x^(1+k) g' on the same panels
        x = np.asarray(x, dtype=float)
        n = 1.0 + self.k
        return np.asarray((x**n * self.gap(x) - _weighted(self.slope_panels, n, x)) / n)


def _weighted(slope: Panels, n: float, x: Array) -> Array:
    """Return the integral of t^n slope(t) from 0 to every x, panel by panel."""
    nodes, weights = gauss_legendre(24)
    first, first_weights = gauss_jacobi(24, n)

    def between(low: Array, high: Array) -> Array:
        width = (high - low)[..., None]
        t = low[..., None] + width * nodes
        inner = (slope(t) * width * t**n) @ weights
        axis = (slope(high[..., None] * first) @ first_weights) * high ** (1.0 + n)
        return np.asarray(np.where(low == 0.0, axis, inner))

    edges = slope.edges
    whole = np.concatenate([[0.0], np.cumsum(between(edges[:-1], edges[1:]))])
    index = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, len(edges) - 2)
    return np.asarray(whole[index] + between(edges[index], x))


@functools.lru_cache(maxsize=64)
def measured(profile: Measured, k: float) -> _OnPanels:
    """Return the transform of measured points."""
    curve = profile.curve
    steepest = float(np.max(np.abs(curve.evaluate(np.linspace(0.0, curve.knots[-1], 1001), 1))))
    slope = fit_panels(lambda x: _spline_gap_slope(curve, k, x), curve.knots, TOLERANCE * steepest)
    return _OnPanels(slope.integral, slope, k)


def _spline_gap_slope(curve: Spline, k: float, x: Array) -> Array:
    """Return g' of a cubic spline in closed form, term by term of its truncated powers."""
    flat = np.maximum(x.ravel(), 1e-300)
    _, first, second, third = curve.derivatives[:, 0]
    w0 = graded_abel.half_beta(k)
    w2 = w0 / (2.0 + k)
    total = first * w0 + 2.0 * second * flat / (1.0 + k) + 1.5 * third * w2 * flat**2
    inner = curve.knots[1:-1]
    half_jumps = 0.5 * np.diff(curve.derivatives[3])
    for part in chunks(flat.size if inner.size else 0, inner.size, 500_000):
        total[part] += _slope_beyond(flat[part, None], inner, k) @ half_jumps
    return np.asarray(total.reshape(x.shape))


def _slope_beyond(x: Array, b: Array, k: float) -> Array:
    """Return what a slope (r - b)^2 beyond b adds to g'(x), x^-k (3 W2 - 4 b W1 + b^2 W0): its kinks cancel."""
    from scipy.special import betainc

    q = 0.5 * (1.0 + k)
    share = np.maximum(x - b, 0.0) * (x + b) / (x * x)
    w0 = np.where(share > 0.0, graded_abel.half_beta(k) * betainc(q, 0.5, np.minimum(share, 1.0)), 0.0)
    root = x * share**q
    return np.asarray((3.0 * x * x / (2.0 + k) + b * b) * w0 + b * root * (3.0 / (2.0 + k) - 2.0 / q))


@functools.lru_cache(maxsize=64)
def designed(profile: Designed, k: float) -> _OnPanels:
    """Return the transform of a body made to order."""

    def gap_slope(x: Array) -> Array:
        return graded_abel.gap_slope(profile.slope, profile.curvature, profile.joints, k, x)

    slope = fit_panels(gap_slope, profile.edges, profile.gap_tolerance)
    return _OnPanels(slope.integral, slope, k)
