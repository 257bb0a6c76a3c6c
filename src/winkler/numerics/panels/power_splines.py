r"""Stiffness and gap between measured points: splines of the logarithms, so that power laws come out exactly.

With b the radius of a flat end (zero without one), ln g is a cubic spline of ln(x - b), ln k one of ln x; below the
first point both go on as power laws.  The integral of k' g is a Gauss rule on every piece.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.numerics.integrals.jacobi_quadrature import gauss_jacobi
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

RULE_NODES = 16


class PowerSplines:
    """The splines of one bed: ln g over ln(x - b) and ln k over ln x, with b the radius of a flat end."""

    def __init__(self, radii: Array, stiffnesses: Array, depths: Array) -> None:
        self.flat = float(radii[0]) if depths[0] == 0.0 else 0.0
        above = depths > 0.0
        self.v = np.log(radii[above] - self.flat)
        self.log_gap = _rising_spline(self.v, np.log(depths[above]))
        stiff = stiffnesses > 0.0
        self.w = np.log(radii[stiff])
        self.log_stiffness = _rising_spline(self.w, np.log(stiffnesses[stiff]))
        self.edges = np.exp(self.v)
        nodes, weights = gauss_legendre(RULE_NODES)
        self.nodes, self.weights = nodes, weights
        self.first = float(self._start(self.edges[:1])[0])
        self.whole = self.first + np.concatenate([[0.0], np.cumsum(self._between(self.v[:-1], self.v[1:]))])

    def gap(self, x: Array) -> tuple[Array, Array]:
        """Return g and g'."""
        y = x - self.flat
        inside = y > 0.0
        safe = np.where(inside, y, 1.0)
        height, rise = _read(self.log_gap, self.v, np.log(safe))
        height = np.exp(np.where(inside, height, -np.inf))
        return height, height * rise / safe

    def stiffness(self, x: Array) -> tuple[Array, Array]:
        """Return k and k'."""
        inside = x > 0.0
        safe = np.where(inside, x, 1.0)
        height, rise = _read(self.log_stiffness, self.w, np.log(safe))
        height = np.exp(np.where(inside, height, -np.inf))
        return height, height * rise / safe

    def stiffness_bend(self, x: Array) -> Array:
        """Return k'', for x > 0."""
        return _bent(self.log_stiffness, self.w, x)

    def gap_bend(self, x: Array) -> Array:
        """Return g'', for x > b; zero under the flat end."""
        y = x - self.flat
        inside = y > 0.0
        return np.where(inside, _bent(self.log_gap, self.v, np.where(inside, y, 1.0)), 0.0)

    def _between(self, low: Array, high: Array) -> Array:
        """Integrate k' g over pieces of ln(x - b)."""
        y = np.exp(low[:, None] + (high - low)[:, None] * self.nodes)
        product = self.gap(self.flat + y)[0] * self.stiffness(self.flat + y)[1] * y
        return np.asarray((product @ self.weights) * (high - low))

    def _start(self, y: Array) -> Array:
        """Integrate k' g from b to b + y, below the first point, where g is a power."""
        n = float(_read(self.log_gap, self.v, self.v[:1] - 1.0)[1][0])
        m = float(_read(self.log_stiffness, self.w, self.w[:1] - 1.0)[1][0])
        power = n if self.flat > 0.0 else n + m - 1.0
        nodes, weights = gauss_jacobi(RULE_NODES, power)
        places = y[:, None] * nodes
        product = self.gap(self.flat + places)[0] * self.stiffness(self.flat + places)[1]
        return np.asarray(((product / nodes**power) @ weights) * y)

    def load(self, x: Array) -> Array:
        """Return the integral of k' g from 0 to x."""
        y = np.maximum(x - self.flat, 0.0).ravel()
        result = np.zeros(y.shape)
        low = (y > 0.0) & (y <= self.edges[0])
        result[low] = self._start(y[low])
        (up,) = np.nonzero(y > self.edges[0])
        v = np.log(y[up])
        index = np.clip(np.searchsorted(self.v, v, side="left") - 1, 0, len(self.v) - 1)
        result[up] = self.whole[index] + self._between(self.v[index], v)
        return result.reshape(np.shape(x))


def _rising_spline(x: Array, y: Array) -> Any:
    """Return a cubic spline through points that rise; one with fewer derivatives if the smoothest one falls."""
    from scipy.interpolate import CubicSpline, PchipInterpolator

    spline = CubicSpline(x, y)
    dense = np.concatenate([x[:-1] + (x[1:] - x[:-1]) * share for share in (0.0, 0.25, 0.5, 0.75)])
    return spline if np.min(spline(np.append(dense, x[-1]), 1)) > 0.0 else PchipInterpolator(x, y)


def _read(spline: Callable[..., Array], x: Array, place: Array) -> tuple[Array, Array]:
    """Return value and slope; beyond the ends straight lines."""
    inside = np.clip(place, x[0], x[-1])
    rise = spline(inside, 1)
    return spline(inside) + rise * (place - inside), rise


def _bent(spline: Callable[..., Array], x: Array, place: Array) -> Array:
    """Return the second derivative of a function of `place` whose logarithm is a spline of that of `place`."""
    w = np.log(place)
    height, rise = _read(spline, x, w)
    inside = (w >= x[0]) & (w <= x[-1])
    bend = np.where(inside, spline(np.clip(w, x[0], x[-1]), 2), 0.0)
    return np.asarray(np.exp(height) * (rise * (rise - 1.0) + bend) / (place * place))
