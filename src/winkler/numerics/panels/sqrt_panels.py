r"""Functions that start a square root at known places: quadrature nodes between them, and polynomials for them.

Just above a kink b everything in a contact is smooth in :math:`y=\sqrt{x^2-b^2}`, not in x.  `nodes` spreads
Gauss-Legendre points in that variable between given edges; `fit` keeps a function as Chebyshev series in it, on panels
that are halved until each series ends.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre, growing, tanh_sinh
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged
from winkler.values.value import value

DEGREE = 17
MOST_HALVINGS = 44
"""How often a panel may be halved; one that narrow, at a singular end, is accepted as it is."""
MOST_PANELS = 4000
NOISE_RATIO = 1e4
"""A series that does not get shorter on halving, and ends this near to its tolerance, ends in rounding noise."""


def doubled(kinks: Sequence[float], end: float) -> Array:
    """Return the kinks below `end`, and after each its doubles up to the next: beyond 2 b the root at b is smooth."""
    inner = sorted({b for b in kinks if 0.0 < b < end})
    places = list(inner)
    for b, following in zip(inner, [*inner, end][1:], strict=True):
        places += growing(2.0 * b, following, 2.0)
    return np.array(sorted(places))


def _base(kinks: Array, low: Array) -> Array:
    """Return for pieces that start at `low` the kink whose root they feel, or zero."""
    if kinks.size == 0:
        return np.zeros(np.shape(low))
    index = np.searchsorted(kinks, low * (1.0 + 4e-16), side="right") - 1
    last = np.where(index >= 0, kinks[np.maximum(index, 0)], 0.0)
    return np.where(low < 2.0 * last, np.minimum(last, low), 0.0)


def nodes(edges: Array, kinks: Array, count: int) -> tuple[Array, Array]:
    """Return nodes and weights on consecutive pieces, row by row.

    Parameters
    ----------
    edges : ndarray, (m, e)
        Ascending in each row; empty pieces are allowed.
    kinks : ndarray
        Ascending places where square roots start; each must be among the edges of a row that contains it.
    count
        Gauss-Legendre nodes per piece; the first piece of a row gets a double-exponential rule, for whatever happens
        at its start.

    Returns
    -------
    x, weights : ndarray, (m, n)
    """
    base = _base(kinks, edges[:, :-1])
    low, high = root_difference(edges[:, :-1], base), root_difference(edges[:, 1:], base)
    places, shares = gauss_legendre(count)
    first, _, first_shares = tanh_sinh(4 * count + 1)
    y = [low[:, :1] + (high - low)[:, :1] * first]
    w = [(high - low)[:, :1] * first_shares]
    b = [np.broadcast_to(base[:, :1], y[0].shape)]
    if edges.shape[1] > 2:
        y.append((low[:, 1:, None] + (high - low)[:, 1:, None] * places).reshape(len(edges), -1))
        w.append(((high - low)[:, 1:, None] * shares).reshape(len(edges), -1))
        b.append(np.repeat(base[:, 1:], count, axis=1))
    distance, measure, kink = (np.concatenate(parts, axis=1) for parts in (y, w, b))
    x = np.clip(np.hypot(kink, distance), edges[:, :1], edges[:, -1:])
    # of the rounded x, where an inverse root will be taken: it cancels exactly
    rooted = np.where(kink > 0.0, root_difference(x, kink), distance)
    return x, measure * np.where(x > 0.0, rooted / np.where(x > 0.0, x, 1.0), 1.0)


@value
class RootPanels:
    """Functions on consecutive panels, as Chebyshev series in y = sqrt(x^2 - base^2).

    Parameters
    ----------
    edges : ndarray, (panels + 1,)
        Ascending.
    base : ndarray, (panels,)
        The kink whose root matters.
    coefficients : ndarray, (functions, panels, degree + 1)
    """

    edges: Array
    base: Array
    coefficients: Array

    def __call__(self, x: Array) -> Array:
        """Return the functions ``(functions, *x.shape)``; beyond the ends the outer panels go on."""
        x = np.asarray(x, dtype=float)
        index = np.clip(np.searchsorted(self.edges, x, side="left") - 1, 0, self.base.size - 1)
        base = self.base[index]
        low, high = root_difference(self.edges[index], base), root_difference(self.edges[index + 1], base)
        t = np.clip((2.0 * root_difference(x, base) - low - high) / (high - low), -1.0, 1.0)
        double = 2.0 * t
        result = np.empty((len(self.coefficients), *x.shape))
        for function, series in enumerate(self.coefficients):
            # row by row: one table of all coefficients at all places would not fit into the cache
            rows = np.ascontiguousarray(series.T)
            last, current = np.zeros_like(t), np.zeros_like(t)
            for row in rows[:0:-1]:
                last, current = current, row[index] + double * current - last
            result[function] = rows[0][index] + t * current - last
        return result

    def slope(self, x: Array) -> Array:
        """Return the derivatives by x ``(functions, *x.shape)``; infinite just at a kink, where a root starts."""
        width = np.diff(root_difference(np.array([self.edges[:-1], self.edges[1:]]), self.base), axis=0)[0]
        derived = np.polynomial.chebyshev.chebder(self.coefficients, axis=2) * (2.0 / width[:, None])
        by_root = RootPanels(self.edges, self.base, derived)(x)
        index = np.clip(np.searchsorted(self.edges, x, side="left") - 1, 0, self.base.size - 1)
        y = root_difference(np.asarray(x, dtype=float), self.base[index])
        with np.errstate(divide="ignore"):
            return np.asarray(np.where(self.base[index] > 0.0, by_root * (x / y), by_root))


def fit(
    function: Callable[[Array], Array], edges: Array, kinks: Array, tolerances: Callable[[Array], Array]
) -> RootPanels:
    """Return functions as panels.

    Parameters
    ----------
    function
        Takes places ``(n,)``, returns ``(functions, n)``.
    edges : ndarray
        Where to begin, ascending; kinks in between must be among them.
    kinks : ndarray
        Ascending.
    tolerances
        Takes values ``(functions, n)`` of any panels, returns the absolute error wanted of each function.

    Raises
    ------
    NotConverged
        If more than 4000 panels would be needed.
    """
    angle = np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)
    points = np.cos(0.5 * angle) ** 2
    matrix = np.cos(np.outer(np.arange(DEGREE + 1), angle)) * (2.0 / (DEGREE + 1))
    matrix[0] *= 0.5
    low, high = edges[:-1], edges[1:]
    targets: Array | None = None
    done: list[tuple[float, float, Array]] = []
    before = np.full((1, low.size), np.inf)
    for depth in range(MOST_HALVINGS + 1):
        base = _base(kinks, low)
        start, stop = root_difference(low, base), root_difference(high, base)
        x = np.clip(
            np.hypot(base[:, None], start[:, None] + (stop - start)[:, None] * points), low[:, None], high[:, None]
        )
        values = function(x.ravel())
        targets = tolerances(values) if targets is None else np.maximum(targets, tolerances(values))
        series = values.reshape(len(values), *x.shape) @ matrix.T
        tail = np.sum(np.abs(series[..., -3:]), axis=-1)
        noise = (tail > 0.3 * before) & (tail <= NOISE_RATIO * targets[:, None])
        good = np.all((tail <= targets[:, None]) | noise, axis=0) | (depth == MOST_HALVINGS)
        done += [(low[i], base[i], series[:, i]) for i in np.flatnonzero(good)]
        if good.all():
            break
        if len(done) + 2 * np.count_nonzero(~good) > MOST_PANELS:
            raise NotConverged(
                f"A function of x is not smooth near x = {low[~good][0]:.6g} m and cannot be tabulated; smooth the "
                "profile, or state where its slope jumps."
            )
        middle, before = np.hypot(base, 0.5 * (start + stop))[~good], np.tile(tail[:, ~good], 2)
        low, high = np.concatenate([low[~good], middle]), np.concatenate([middle, high[~good]])
    done.sort(key=lambda panel: panel[0])
    starts, bases, parts = zip(*done, strict=True)
    return RootPanels(np.array([*starts, edges[-1]]), np.array(bases), np.stack(parts, axis=1))
