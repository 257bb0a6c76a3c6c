"""Functions on an interval as Chebyshev polynomials on adaptive panels."""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.types import Array, ComplexArray, Curve
from winkler.values.errors import NotConverged
from winkler.values.value import value

DEGREE = 16
MOST_PANELS = 4096


@value
class Panels:
    """A piecewise polynomial: Chebyshev coefficients on consecutive panels.

    Parameters
    ----------
    edges : ndarray, (panels + 1,)
        Ascending.
    coefficients : ndarray, (panels, degree + 1)
        On each panel, in Chebyshev polynomials of the panel's own variable from -1 to 1.
    """

    edges: Array
    coefficients: ComplexArray

    def __call__(self, x: Array) -> Array:
        """Evaluate by Clenshaw's recurrence; outside the interval the outer panels go on."""
        x = np.asarray(x, dtype=float)
        if x.size == 1:
            return np.full(x.shape, self._at(x.item()))
        index = np.clip(np.searchsorted(self.edges, x, side="right") - 1, 0, len(self.edges) - 2)
        low, high = self.edges[index], self.edges[index + 1]
        t = (2.0 * x - low - high) / (high - low)
        # row by row: one table of all coefficients at all places would not fit into the cache
        rows = np.ascontiguousarray(self.coefficients.T)
        double = 2.0 * t
        last = np.zeros_like(t)
        current = np.zeros_like(t)
        for row in rows[:0:-1]:
            last, current = current, row[index] + double * current - last
        result: Array = rows[0][index] + t * current - last
        return result

    def _at(self, x: float) -> float:
        """Evaluate at one place, by the same operations."""
        index = min(max(int(self.edges.searchsorted(x, side="right")) - 1, 0), self.edges.size - 2)
        low, high = self.edges[index : index + 2].tolist()
        t = (2.0 * x - low - high) / (high - low)
        first, *others = self.coefficients[index].tolist()
        double, last, current = 2.0 * t, 0.0, 0.0
        for coefficient in reversed(others):
            last, current = current, coefficient + double * current - last
        return float(first + t * current - last)

    @property
    def derivative(self) -> Panels:
        """The derivative, panel by panel."""
        width = np.diff(self.edges)[:, None]
        derived = np.polynomial.chebyshev.chebder(self.coefficients, axis=1) * 2.0 / width
        return Panels(self.edges, derived)

    @property
    def integral(self) -> Panels:
        """The integral from the first edge on, continuous."""
        width = np.diff(self.edges)[:, None]
        raised = np.polynomial.chebyshev.chebint(self.coefficients, axis=1) * 0.5 * width
        signs = np.where(np.arange(raised.shape[1]) % 2 == 0, 1.0, -1.0)
        start = raised @ signs
        gain = raised.sum(axis=1) - start
        raised[:, 0] += np.concatenate([[0.0], np.cumsum(gain)[:-1]]) - start
        return Panels(self.edges, raised)


@functools.lru_cache(maxsize=8)
def _matrix(degree: int) -> tuple[Array, Array]:
    """Return Chebyshev nodes on [-1, 1] and the matrix from values there to coefficients."""
    nodes = np.polynomial.chebyshev.chebpts1(degree + 1)
    return nodes, np.linalg.inv(np.polynomial.chebyshev.chebvander(nodes, degree))


def fit_nodes(edges: Array) -> Array:
    """Return the places ``(panels, n)`` at which `panels_from` evaluates a function."""
    nodes, _ = _matrix(DEGREE)
    return np.asarray(0.5 * (edges[:-1] + edges[1:])[:, None] + 0.5 * np.diff(edges)[:, None] * nodes)


def panels_from(edges: Array, values: Array) -> Panels:
    """Return the function that has these values ``(panels, n)`` at `fit_nodes`."""
    return Panels(edges, np.asarray(values @ _matrix(DEGREE)[1].T))


def fit_panels(function: Curve, edges: Array, tolerance: float, most: int = MOST_PANELS) -> Panels:
    """Return `function` as panels, halved until each resolves it.

    Parameters
    ----------
    function
        Smooth inside each of the given panels, or at least continuous.
    edges : ndarray
        Where to start, ascending.
    tolerance
        Absolute error wanted, in the units of the function.
    most
        How many panels at most; 4096 unless given.

    Raises
    ------
    NotConverged
        If more panels would be needed.
    """
    nodes, matrix = _matrix(DEGREE)
    done: list[tuple[float, Array]] = []
    low, high = np.asarray(edges[:-1], dtype=float), np.asarray(edges[1:], dtype=float)
    while low.size:
        points = 0.5 * (low + high)[:, None] + 0.5 * (high - low)[:, None] * nodes
        values = np.asarray(function(points))
        coefficients = values @ matrix.T
        tail = np.abs(coefficients[:, -3:]).sum(axis=1)
        # no curve is smoother than the rounding of its values, which differs from machine to machine
        rounding = 4.0 * np.finfo(float).eps * np.max(np.abs(values), axis=1)
        good = (tail <= np.maximum(tolerance, rounding)) | (high - low <= 1e-9 * (edges[-1] - edges[0]))
        done.extend(zip(low[good], coefficients[good], strict=True))
        middle = 0.5 * (low[~good] + high[~good])
        low, high = np.concatenate([low[~good], middle]), np.concatenate([middle, high[~good]])
        if len(done) + low.size > most:
            raise NotConverged(
                f"A curve needs more than {most} panels to be resolved to {tolerance:.1e}; it is too rough: "
                "smooth it, or give fewer points."
            )
    done.sort(key=lambda panel: panel[0])
    return Panels(np.array([start for start, _ in done] + [float(edges[-1])]), np.array([panel for _, panel in done]))


def stationary(panels: Panels) -> Array:
    """Return the places inside the panels where the derivative vanishes, all of them, ascending."""
    places = []
    for low, high, row in zip(panels.edges[:-1], panels.edges[1:], panels.derivative.coefficients, strict=True):
        if abs(row[0]) > np.abs(row[1:]).sum():
            continue
        large = np.flatnonzero(np.abs(row) > np.finfo(float).eps * np.max(np.abs(row)))
        if large.size and large[-1] > 0:
            roots = np.polynomial.chebyshev.chebroots(row[: large[-1] + 1])
            near = roots.real[(np.abs(roots.imag) < 1e-6) & (np.abs(roots.real) < 1.0)]
            places.append(0.5 * (low + high) + 0.5 * (high - low) * np.sort(near))
    return np.concatenate(places) if places else np.zeros(0)
