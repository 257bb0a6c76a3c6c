"""The smoothing spline through measured points, its stiffness chosen by cross-validation."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

MOST_INTERPOLATED_POINTS = 256
"""Up to so many points a spline through all of them is a candidate; more are always fitted by fewer pieces."""
MOST_PIECES = 512


class Spline(NamedTuple):
    """A cubic spline on [0, L] and how it came about.

    `knots` (k + 1,) ascending from 0; `derivatives` (4, k): f, f', f'', f''' at the start of each piece; `residual` the
    root mean square misfit [m], `scatter` that with which points predict each other; `through` whether it passes
    through all points; `rounded` whether f'(0) = 0 was imposed.
    """

    knots: Array
    derivatives: Array
    residual: float
    scatter: float
    through: bool
    rounded: bool

    @property
    def pieces(self) -> int:
        """Number of cubic pieces."""
        return len(self.knots) - 1

    def evaluate(self, r: Array, order: int = 0) -> Array:
        """Return the spline (order 0), its slope (1) or its curvature (2)."""
        index = np.clip(np.searchsorted(self.knots, r, side="right") - 1, 0, self.pieces - 1)
        t = r - self.knots[index]
        total = np.zeros_like(t)
        for power in range(3, order - 1, -1):
            total = total * t / (power - order + 1) + self.derivatives[power][index]
        return total


def choose(r: Array, f: Array) -> Spline:
    """Return the spline that predicts best.

    Parameters
    ----------
    r : ndarray, (n,)
        Strictly ascending, not negative, n >= 6.
    f : ndarray, (n,)
        Heights.

    Returns
    -------
    Spline
    """
    best, score = _fitted_best(r, f)
    if len(r) <= MOST_INTERPOLATED_POINTS:
        predicted = _left_out(r, f)
        scatter = float(np.sqrt(predicted))
        through = _through(r, f, scatter, rounded=False)
        if predicted < score:
            slope_noise = 4.0 * scatter + 1e-12 * np.ptp(f)
            even = _through(r, f, scatter, rounded=True)
            start = float(through.evaluate(np.zeros(1), 1)[0])
            if start < 0.0 or (start * r[r > 0.0][0] <= slope_noise and _agrees(even, through, r)):
                return even
            return through
    return best


def _agrees(even: Spline, free: Spline, r: Array) -> bool:
    """Whether imposing a round apex keeps the curve between the first points where it was."""
    middle = 0.5 * (r[1:4] + r[:3])
    change = np.abs(even.evaluate(middle) - free.evaluate(middle))
    return bool(np.all(change <= 0.02 * np.abs(free.evaluate(middle) - free.evaluate(np.zeros(1)))))


def _left_out(r: Array, f: Array) -> float:
    """Return the mean squared error with which the cubic through its four neighbours predicts a point."""
    i = np.arange(2, len(r) - 2)
    others = [i - 2, i - 1, i + 1, i + 2]
    predicted = np.zeros(len(i))
    for j in others:
        weight = np.ones(len(i))
        for k in others:
            if k is not j:
                weight = weight * (r[i] - r[k]) / (r[j] - r[k])
        predicted += weight * f[j]
    return float(np.mean((predicted - f[i]) ** 2))


def _through(r: Array, f: Array, scatter: float, *, rounded: bool) -> Spline:
    """Return the not-a-knot cubic spline through the points; an even one if the apex is to be round."""
    from scipy.interpolate import CubicSpline

    if rounded:
        inner = r > 0.0
        mirrored = CubicSpline(np.concatenate([-r[inner][::-1], r]), np.concatenate([f[inner][::-1], f]))
        knots, derivatives = _from_zero(mirrored.x, mirrored.c)
        derivatives[1, 0] = 0.0
    else:
        spline = CubicSpline(r, f)
        knots, derivatives = _from_zero(spline.x, spline.c)
    return Spline(knots, derivatives, 0.0, scatter, True, rounded)


def _from_zero(x: Array, c: Array) -> tuple[Array, Array]:
    """Return knots from 0 on and f, f', f'', f''' at their starts, of pieces with coefficients c, cubic first."""
    start = int(np.clip(np.searchsorted(x, 0.0, side="right") - 1, 0, len(x) - 2))
    knots = x[start:].copy()
    derivatives = np.array([c[3], c[2], 2.0 * c[1], 6.0 * c[0]])[:, start:].copy()
    shift = -knots[0]
    f, first, second, third = derivatives[:, 0]
    derivatives[:, 0] = (
        f + shift * (first + shift * (second / 2.0 + shift * third / 6.0)),
        first + shift * (second + shift * third / 2.0),
        second + shift * third,
        third,
    )
    knots[0] = 0.0
    return knots, derivatives


def _fitted_best(r: Array, f: Array) -> tuple[Spline, float]:
    """Climb the ladder of piece counts until generalised cross-validation no longer improves."""
    most = max(1, min(MOST_PIECES, len(r) // 4))
    floor = (1e-11 * np.ptp(f)) ** 2
    tried: dict[int, tuple[Spline, float]] = {}

    def score(pieces: int) -> float:
        if pieces not in tried:
            tried[pieces] = _fitted(r, f, pieces)
        return tried[pieces][1]

    pieces, worse = 1, 0
    best = pieces
    while pieces <= most and worse < 2:
        worse = 0 if score(pieces) <= score(best) else worse + 1
        best = pieces if score(pieces) < 0.98 * score(best) else best
        if score(best) <= floor:
            break
        pieces *= 2
    for between in (3 * best // 4, 3 * best // 2):
        if 1 <= between <= most and score(between) < 0.98 * score(best):
            best = between
    return tried[best]


def _fitted(r: Array, f: Array, pieces: int) -> tuple[Spline, float]:
    """Return the least-squares cubic spline with so many pieces, and its generalised cross-validation score."""
    from scipy.interpolate import BSpline, PPoly

    inner = np.quantile(r, np.linspace(0.0, 1.0, pieces + 1)[1:-1])
    knots = np.concatenate([np.zeros(4), inner, np.full(4, r[-1])])
    design = BSpline.design_matrix(r, knots, 3)
    normal, right = (design.T @ design).toarray(), design.T @ f
    free, misfit = _solve(normal, right, design, f)
    count = len(right)
    spread = (misfit / max(len(r) - count, 1)) + (1e-13 * np.ptp(f)) ** 2
    rounded = False
    if len(r) > count:
        # f'(0) = 0 means that the first two coefficients are equal: kept if the misfit does not mind
        joined = np.vstack([normal[:2].sum(axis=0), normal[2:]])
        joined = np.hstack([joined[:, :2].sum(axis=1, keepdims=True), joined[:, 2:]])
        part, misfit_round = _solve(
            joined, np.concatenate([[right[0] + right[1]], right[2:]]), design, f, repeat_first=True
        )
        if free[1] < free[0] or misfit_round <= misfit + 6.0 * spread:  # no tip falls from its apex
            free, misfit, rounded = part, misfit_round, True
    score = (misfit / len(r)) / (1.0 - min((count - rounded) / len(r), 0.99)) ** 2
    poly = PPoly.from_spline(BSpline(knots, free, 3))
    keep = np.diff(poly.x) > 0.0
    x = np.concatenate([poly.x[:-1][keep], [poly.x[-1]]])
    start, derivatives = _from_zero(x, poly.c[:, keep])
    if rounded:
        derivatives[1, 0] = 0.0
    residual = float(np.sqrt(misfit / len(r)))
    return Spline(start, derivatives, residual, float(np.sqrt(score)), False, rounded), float(score)


def _solve(normal: Array, right: Array, design, f: Array, *, repeat_first: bool = False):  # type: ignore[no-untyped-def]
    """Solve the normal equations; return all coefficients and the sum of squared misfits."""
    from scipy.linalg import solveh_banded

    banded = np.zeros((4, len(right)))
    for k in range(min(4, len(right))):
        banded[3 - k, k:] = np.diagonal(normal, k)
    banded[3] *= 1.0 + 1e-15
    part = solveh_banded(banded, right)
    full = np.concatenate([part[:1], part]) if repeat_first else part
    return full, float(np.sum((design @ full - f) ** 2))
