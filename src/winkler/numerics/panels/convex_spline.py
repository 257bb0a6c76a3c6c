r"""A convex curve F(d) through points: its slope k = dF/dd is a rising spline, fitted by non-negative least squares.

.. math:: k(d) = c_0 + \sum_j c_j\,I_j(s) , \qquad s = (d/D)^\beta , \qquad c_j \ge 0 , \qquad F(d) = \int_0^d k ,

with I-splines :math:`I_j`, cubic or (where there are many) quintic, which rise from 0 to 1.  The exponent makes the
slope of a power law a straight line in s: a paraboloid has beta = 1/2, a cone 1.  Which exponent, how many pieces, and
whether the curve starts with a finite slope (a flat end) is decided by generalised cross-validation.

References
----------
J. O. Ramsay, Monotone regression splines in action, Statistical Science 3 (1988) 425-441
"""

from __future__ import annotations

import itertools

import numpy as np

from winkler.numerics.integrals.jacobi_quadrature import gauss_jacobi
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.panels.chebyshev import Panels
from winkler.numerics.types import Array
from winkler.values.value import value

EXPONENTS = (0.25, 1.0 / 3.0, 0.5, 2.0 / 3.0, 1.0, 1.5, 2.0)
LEAST_RISE = 1e-7
"""Smallest share of the greatest slope by which k rises over the whole curve: it never stands still."""
FEWEST_POINTS_PER_PIECE = 12
MOST_PIECES = 32
NORMAL_MEDIAN = 0.6744897501960817
"""Of the modulus of a normal variable with unit deviation."""
MOST_EXPONENTS = 3
"""How many exponents are tried with many pieces."""
CUBIC, QUINTIC = 3, 5
QUINTIC_PIECES = 4
"""From so many pieces on the splines are quintic: data that need them are clean."""
MOST_GROUPS = 500
FLAT_GAIN_RATIO = 2.0
"""By how much a flat end must lower the score: it must earn its keep."""
LEAST_FLAT_SHARE = 0.2
"""Least part that a flat end must have in the force at the first points."""


@value
class ConvexCurve:
    """A convex F(d) with F(0) = 0 and a slope that rises from k(0) >= 0.

    Parameters
    ----------
    depth : float
        D [m], where the curve ends.
    beta : float
        Exponent of the variable s = (d/D)^beta.
    panels : Panels
        k [N/m] in s, from 0 to 1.
    misfit : float
        Root mean square distance of the points from the curve [N].
    """

    depth: float
    beta: float
    panels: Panels
    misfit: float

    @property
    def joints(self) -> Array:
        """Where in s one polynomial visibly joins the next; quintic ones do so too smoothly to be visible."""
        return self.panels.edges[1:-1] if self.panels.coefficients.shape[1] == CUBIC + 1 else np.zeros(0)

    def stiffness(self, s: Array) -> Array:
        """k [N/m] at s."""
        return np.asarray(np.maximum(self.panels(s), 0.0))

    def rise(self, s: Array) -> Array:
        """dk/ds [N/m]."""
        return self.panels.derivative(s)

    def depth_at(self, s: Array) -> Array:
        """d [m] at s."""
        return np.asarray(self.depth * np.asarray(s, dtype=float) ** (1.0 / self.beta))

    def place(self, stiffness: Array) -> Array:
        """Return s where the slope is `stiffness`, between its least and its greatest value."""
        knots = self.panels.edges
        at_knots = self.panels(knots)
        target = np.clip(np.asarray(stiffness, dtype=float), at_knots[0], at_knots[-1])
        index = np.clip(np.searchsorted(at_knots, target, side="right") - 1, 0, len(knots) - 2)
        low, high = knots[index], knots[index + 1]
        s = low + (high - low) * (target - at_knots[index]) / (at_knots[index + 1] - at_knots[index])
        for _ in range(60):
            miss, slope = self.panels(s) - target, self.rise(s)
            low, high = np.where(miss <= 0.0, s, low), np.where(miss >= 0.0, s, high)
            new = s - miss / np.where(slope > 0.0, slope, np.inf)
            new = np.where((new >= low) & (new <= high) & (slope > 0.0), new, 0.5 * (low + high))
            done = np.all(np.abs(new - s) <= 2e-16 * s)
            s = new
            if done:
                break
        return np.asarray(s)


def first_concave_part(depth: Array, force: Array, tolerance: float) -> tuple[float, float] | None:
    """Return the first two depths between which a curve through 0 and the points is not convex; None if it is.

    Depths strictly ascending and positive; slopes may fall by `tolerance` of the greatest one.
    """
    d, f = np.concatenate([[0.0], depth]), np.concatenate([[0.0], force])
    slopes = np.diff(f) / np.diff(d)
    falls = np.flatnonzero(np.diff(slopes) < -tolerance * np.max(np.abs(slopes)))
    if falls.size:
        return float(d[falls[0]]), float(d[falls[0] + 2])
    return None


def local_scatter(depth: Array, force: Array) -> float:
    """Return how far a typical point lies from the cubic through its four neighbours, as one standard deviation.

    A single jump does not move the median; waves longer than five points are not scatter.
    """
    i = np.arange(2, len(depth) - 2)
    others = np.stack([i - 2, i - 1, i + 1, i + 2])
    places = depth[others]
    weights = np.ones(others.shape)
    for j, k in itertools.permutations(range(4), 2):
        weights[j] *= (depth[i] - places[k]) / (places[j] - places[k])
    misses = (np.sum(weights * force[others], axis=0) - force[i]) / np.sqrt(1.0 + np.sum(weights**2, axis=0))
    return float(np.median(np.abs(misses)) / NORMAL_MEDIAN)


def fit_convex(depth: Array, force: Array) -> ConvexCurve:
    """Return the convex curve that predicts best.

    Parameters
    ----------
    depth : ndarray, (n,)
        Ascending, positive [m], n >= 6.
    force : ndarray, (n,)
        [N], with or without scatter.
    """
    most = max(1, min(MOST_PIECES, len(depth) // 3))
    betas = [_apparent(depth, force), *EXPONENTS]
    floor = (1e-12 * float(np.max(np.abs(force)))) ** 2
    best: tuple[float, ConvexCurve] | None = None
    for pieces in (1, 2, 4, 8, 16, 32):
        if pieces > most:
            break
        tried = [(*_fitted(depth, force, beta, pieces), beta) for beta in betas]
        tried.sort(key=lambda item: item[0])
        score, curve, _ = tried[0]
        if best is None or score < 0.9 * best[0]:
            best = score, curve
        if score <= floor:
            break
        if pieces >= QUINTIC_PIECES:
            betas = [beta for _, _, beta in tried[:MOST_EXPONENTS]]
    assert best is not None
    return best[1]


def _apparent(depth: Array, force: Array) -> float:
    """Return the exponent of the slope if the curve were a power law: that of its first third."""
    part = (force > 0.0) & (depth <= max(0.33 * depth[-1], depth[min(5, len(depth) - 1)]))
    if np.count_nonzero(part) < 3:
        return 0.5
    slope = float(np.polyfit(np.log(depth[part]), np.log(force[part]), 1)[0])
    return min(max(slope - 1.0, 0.05), 3.0)


def _basis(knots: Array, s: Array, degree: int) -> Array:
    """Return the I-splines at s, ``(len(s), pieces + degree - 1)``: sums of B-splines from the j-th on."""
    from scipy.interpolate import BSpline

    full = np.concatenate([np.zeros(degree), knots, np.ones(degree)])
    design = BSpline.design_matrix(np.clip(s, 0.0, 1.0), full, degree).toarray()
    rising: Array = np.cumsum(design[:, ::-1], axis=1)[:, ::-1][:, 1:]
    return rising


def _series(knots: Array, degree: int) -> Array:
    """Return the I-splines as Chebyshev series on every piece, ``(pieces, degree + 1, splines)``."""
    points = np.polynomial.chebyshev.chebpts1(degree + 1)
    low, high = knots[:-1, None], knots[1:, None]
    values = _basis(knots, (0.5 * (low + high) + 0.5 * (high - low) * points).ravel(), degree)
    matrix = np.linalg.inv(np.polynomial.chebyshev.chebvander(points, degree))
    return np.asarray(np.einsum("km,imj->ikj", matrix, values.reshape(len(low), degree + 1, -1)))


def _integrals(knots: Array, series: Array, s: Array, beta: float, depth: float) -> Array:
    """Return the integral of every I-spline over the depth from 0 to d(s), ``(len(s), splines)``, for ascending s."""
    n, degree = 1.0 / beta, series.shape[1] - 1
    piece = np.clip(np.searchsorted(knots, s, side="left") - 1, 0, len(knots) - 2)
    nodes, weights = gauss_legendre(FEWEST_POINTS_PER_PIECE)
    first, first_weights = gauss_jacobi(FEWEST_POINTS_PER_PIECE, n - 1.0)

    def moments(index: Array, end: Array) -> Array:
        low, width = knots[index][:, None], (knots[index + 1] - knots[index])[:, None]
        at = low + (end[:, None] - low) * nodes
        measure = (end[:, None] - low) * weights * n * at ** (n - 1.0)
        start = index == 0
        at[start], measure[start] = end[start, None] * first, n * end[start, None] ** n * first_weights
        basis = np.polynomial.chebyshev.chebvander(2.0 * (at - low) / width - 1.0, degree)
        return np.asarray(np.einsum("pq,pqk->pk", measure, basis))

    pieces = np.arange(len(knots) - 1)
    whole = np.einsum("ik,ikj->ij", moments(pieces, knots[1:]), series)
    before = np.concatenate([np.zeros((1, whole.shape[1])), np.cumsum(whole, axis=0)])
    own = moments(piece, s)
    result = before[piece]
    bounds = np.searchsorted(piece, np.arange(len(knots)))
    for index in pieces:  # s ascends: the points of a piece lie side by side
        rows = slice(bounds[index], bounds[index + 1])
        result[rows] += own[rows] @ series[index]
    return np.asarray(depth * result)


def _grouped(rows: Array) -> Array:
    """Return averages of neighbouring rows, at most 500: they hold as much of a curve, in less time."""
    size = -(-len(rows) // MOST_GROUPS)
    if size == 1:
        return rows
    starts = np.arange(0, len(rows), size)
    counts = np.diff(np.append(starts, len(rows)))
    sums = np.add.reduceat(rows, starts, axis=0)
    return np.asarray(sums / (counts if rows.ndim == 1 else counts[:, None]))


def _fitted(depth: Array, force: Array, beta: float, pieces: int) -> tuple[float, ConvexCurve]:
    """Return the score of generalised cross-validation and the curve, with or without a flat end."""
    from scipy.optimize import nnls

    end = float(depth[-1])
    degree = CUBIC if pieces < QUINTIC_PIECES else QUINTIC
    s = (depth / end) ** beta
    knots = np.concatenate([[0.0], np.quantile(s, np.linspace(0.0, 1.0, pieces + 1)[1:-1]), [1.0]])
    splines = _series(knots, degree)
    matrix = _integrals(knots, splines, s, beta, end)
    least = LEAST_RISE * float(np.max(np.abs(force))) / end / matrix.shape[1]
    target = force - least * matrix.sum(axis=1)
    whole = np.column_stack([matrix, depth])
    rows, aim = _grouped(whole), _grouped(target)
    size = np.linalg.norm(rows, axis=0)
    head = slice(0, max(1, len(depth) // 50))
    score, best_fit = np.inf, np.zeros(whole.shape[1])
    for columns in (whole.shape[1] - 1, whole.shape[1]):
        flat = columns == whole.shape[1]
        some, misfit = nnls(rows[:, :columns] / size[:columns], aim, maxiter=200 * columns)
        coefficients = np.append(some / size[:columns], np.zeros(whole.shape[1] - columns))
        if flat and coefficients[-1] * np.mean(depth[head]) < LEAST_FLAT_SHARE * np.mean(force[head]):
            continue
        share = min((int(np.count_nonzero(some)) + 1) / len(rows), 0.95)
        own = float(misfit**2 / len(rows) / (1.0 - share) ** 2) * (FLAT_GAIN_RATIO if flat else 1.0)
        if own < score:
            score, best_fit = own, coefficients
    misfit = float(np.sqrt(np.mean((whole @ best_fit - target) ** 2)))
    series = splines @ (best_fit[:-1] + least)
    series[:, 0] += best_fit[-1]
    return score, ConvexCurve(end, beta, Panels(knots, series), misfit)
