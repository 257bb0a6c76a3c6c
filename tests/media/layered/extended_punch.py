"""A flat punch on equal panels in extended precision: no graded panels, no turned path, no tables.

The transform of M is summed on the real axis, and the equation of the punch is refined until its rest, computed in long
double, vanishes.
"""

from __future__ import annotations

import math

import numpy as np
import scipy.linalg

LONG = np.longdouble
PI = LONG("3.14159265358979323846264338")
COUNT = 20
DEGREE = 22


def gauss() -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights on [0, 1], by Newton's method in long double."""
    x = np.polynomial.legendre.leggauss(COUNT)[0].astype(LONG)
    for _ in range(3):
        before, last = np.ones_like(x), x.copy()
        for k in range(2, COUNT + 1):
            before, last = last, ((2 * k - 1) * x * last - (k - 1) * before) / LONG(k)
        slope = COUNT * (before - x * last) / (1 - x * x)
        x = x - last / slope
    return (x + 1) / 2, 1 / ((1 - x * x) * slope * slope)


NODES, WEIGHTS = gauss()


def panels(edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    width = np.diff(edges)[:, None]
    return (edges[:-1, None] + width * NODES).ravel(), (width * WEIGHTS).ravel()


def kernel(response, end: float, step: float) -> np.ndarray:
    """Chebyshev series of C(x) on pieces of [0, end]."""
    edges, width, widest = [LONG(0)], LONG(1e-3) / LONG(response.span), LONG(min(0.6, 8.0 / end))
    while edges[-1] < 23.0 / response.length:
        edges.append(edges[-1] + min(width, widest))
        width *= 2
    xi, weights = panels(np.array(edges, dtype=LONG))
    weights = weights * response.excess(xi) * 2 / PI
    k = np.arange(DEGREE, dtype=LONG)
    angle = PI * (k + LONG(0.5)) / DEGREE
    invert = np.cos(np.outer(k, angle)) * 2 / LONG(DEGREE)
    invert[0] /= 2
    starts = np.arange(math.ceil(end / step) + 1) * LONG(step)
    places = LONG(step) * (np.cos(angle) + 1) / 2
    return np.array([invert @ (np.cos(np.outer(low + places, xi)) @ weights) for low in starts])


def at(series: np.ndarray, x: np.ndarray, step: float) -> np.ndarray:
    which = np.minimum((x / step).astype(int), len(series) - 1)
    t = 2 * (x / LONG(step) - which) - 1
    last, current = np.zeros_like(t), np.zeros_like(t)
    for k in range(DEGREE - 1, 0, -1):
        last, current = current, series[which, k] + 2 * t * current - last
    return series[which, 0] + t * current - last


def punch(response, a: float, *, step: float, odd: bool = False) -> float:
    """The mean of phi over the radius a; if odd, 3 / a^3 times the integral of x theta."""
    series, sign = kernel(response, 2.0 * a, step), -1 if odd else 1
    x, weights = panels(np.linspace(LONG(0), LONG(a), round(a / step) + 1))
    both = at(series, np.abs(x[:, None] - x), step) + sign * at(series, x[:, None] + x, step)
    matrix = np.eye(x.size, dtype=LONG) + both / 2 * weights
    factors, right = scipy.linalg.lu_factor(matrix.astype(float)), x if odd else np.ones(x.size, dtype=LONG)
    found = np.zeros(x.size, dtype=LONG)
    for _ in range(8):
        found = found + scipy.linalg.lu_solve(factors, (right - matrix @ found).astype(float))
    return float(weights @ (x * found) * 3 / LONG(a) ** 3) if odd else float(weights @ found / LONG(a))
