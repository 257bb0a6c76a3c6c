"""Two methods for the g(x) of a noisy profile, side by side: a spline of the heights, and the integral form of T1.

Prints the table of docs/decisions/noisy-profiles.md: the root mean square error of g, relative to its largest value,
over twelve seeded profiles of 1,001 points.  For the integral form, g = H' with H(x) the integral of
r f / sqrt(x^2 - r^2) taken exactly over the polygon through the points, the number of pieces is the best one, chosen
with the true g: no method could do better.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import make_lsq_spline

import winkler as wk

PIECES = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32)
SHAPES = {"sphere, a = R/2": wk.Sphere(2.0), "sphero-cone": wk.SpheroConical(0.3, 1.0), "cone": wk.Cone(1.2)}


def half_integral(r: np.ndarray, f: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return H(x) of the polygon through the points."""
    result = np.zeros_like(x)
    for i, end in enumerate(x):
        inside = int(np.count_nonzero(r < end))
        places = np.append(r[:inside], end)
        heights = np.append(f[:inside], np.interp(end, r, f))
        root = np.sqrt(np.maximum(end**2 - places**2, 0.0))
        second = 0.5 * (end**2 * np.arcsin(np.minimum(places / end, 1.0)) - places * root)
        rise = np.diff(heights) / np.diff(places)
        result[i] = np.sum((heights[:-1] - rise * places[:-1]) * -np.diff(root) + rise * np.diff(second))
    return result


def errors(shape: wk.Shape, noise: float, seed: int) -> tuple[float, float]:
    """Return the errors of both methods for one noisy profile."""
    r = np.linspace(0.0, 1.0, 1001)
    true = shape.height(r)
    f = true + noise * true[-1] * np.random.default_rng(seed).standard_normal(r.size)
    x = np.linspace(0.05, 0.95, 91)
    g = shape.gap(x)

    def miss(found: np.ndarray) -> float:
        return float(np.sqrt(np.mean((found - g) ** 2)) / np.max(g))

    measured = wk.Measured(r, f)
    moment = half_integral(r, f - measured.curve.derivatives[0, 0], r[1:])
    knots = [np.r_[[0.0] * 5, np.linspace(0.0, 1.0, n + 1)[1:-1], [1.0] * 5] for n in PIECES]
    integral = min(miss(make_lsq_spline(r[1:], moment, t, 4).derivative()(x)) for t in knots)
    return miss(measured.gap(x)), integral


if __name__ == "__main__":
    print("| shape | noise | spline of the heights | integral form, best pieces |\n| --- | --- | --- | --- |")
    for name, shape in SHAPES.items():
        for noise in (1e-3, 1e-2):
            spline, integral = np.mean([errors(shape, noise, seed) for seed in range(12)], axis=0)
            print(f"| {name} | {noise:g} | {spline:.1e} | {integral:.1e} |")
