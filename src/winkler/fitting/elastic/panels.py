r"""Two functions of the contact radius as Chebyshev series on panels that double in size from the axis on.

Above a kink b their variable is :math:`y = \sqrt{a^2-b^2}`; panels are halved until both functions are resolved.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

DEGREE = 14
RESOLUTION = 1e-10
MOST_HALVINGS = 6
PANEL_DOUBLINGS = 10

Pair = Callable[[Array], tuple[Array, Array]]


class PanelSeries(NamedTuple):
    """Two functions as Chebyshev series ``(panels, degree + 1)`` on panels from y = `left` to `right` [m]."""

    base: Array
    left: Array
    right: Array
    levels: Array
    others: Array


def resolved(function: Pair, low: float, high: float, kinks: Array) -> PanelSeries:
    """Return two functions of the radius as series.

    Parameters
    ----------
    function
        Takes radii ``(m,)`` [m], returns both values, ``(m,)`` each.
    low, high : float
        Range of radii [m].
    kinks : ndarray
        Radii from `low` on, below `high`, where the functions are not smooth [m].
    """
    return PanelSeries(*_resolved(function, *_panels(low, high, kinks), high))


@functools.lru_cache(maxsize=1)
def panel_nodes() -> tuple[Array, Array, Array]:
    """Return nodes on (-1, 1), the matrix to Chebyshev coefficients, and from there to powers."""
    nodes = np.polynomial.chebyshev.chebpts1(DEGREE + 1)
    matrix = np.linalg.inv(np.polynomial.chebyshev.chebvander(nodes, DEGREE))
    powers = np.zeros((DEGREE + 1, DEGREE + 1))
    for k in range(DEGREE + 1):
        row = np.polynomial.chebyshev.cheb2poly(np.eye(DEGREE + 1)[k])
        powers[k, : row.size] = row
    return nodes, matrix, powers


def _panels(low: float, high: float, kinks: Array) -> tuple[Array, Array, Array]:
    """Return panels that double, in y = sqrt(a^2 - base^2): their bases, and y where they begin and end."""
    bases, lefts, rights = [], [], []
    for base, end in zip([0.0, *kinks.tolist()], [*kinks.tolist(), high], strict=True):
        if end == low:
            continue
        stop = math.sqrt((end - base) * (end + base))
        first = low if base == 0.0 and low > 0.0 else (stop * 2.0**-PANEL_DOUBLINGS if base == 0.0 else 0.25 * base)
        doubled = first * 2.0 ** np.arange(max(0, math.ceil(math.log2(stop / first) - 1e-9)))
        edges = np.append(doubled[doubled < stop * (1.0 - 1e-9)], stop)
        if base > 0.0 or low == 0.0:  # from the kink, or from the axis, on
            edges = np.concatenate([[0.0], edges])
        bases += [base] * (edges.size - 1)
        lefts += edges[:-1].tolist()
        rights += edges[1:].tolist()
    return np.array(bases), np.array(lefts), np.array(rights)


def _resolved(function: Pair, base: Array, left: Array, right: Array, high: float) -> tuple[Array, ...]:
    """Return panels, halved until both functions are resolved: base, ends, Chebyshev coefficients of both."""
    nodes, matrix, _ = panel_nodes()
    order = np.arange(base.size, dtype=float)
    done: list[tuple[Array, ...]] = []
    for depth in range(MOST_HALVINGS + 1):
        y = 0.5 * (left + right)[:, None] + 0.5 * (right - left)[:, None] * nodes
        radius = np.minimum(np.where(base[:, None] > 0.0, np.hypot(base[:, None], y), y), high)
        rows = [np.asarray(column).reshape(radius.shape) @ matrix.T for column in function(radius.ravel())]
        is_resolved = np.ones(base.size, dtype=bool)
        for row in rows:
            size = np.abs(row).max(axis=1)
            is_resolved &= np.abs(row[:, -2:]).sum(axis=1) <= RESOLUTION * np.maximum(size, 1e-6 * size.max())
        if depth == MOST_HALVINGS:
            is_resolved[:] = True
        done.append(tuple(column[is_resolved] for column in (order, base, left, right, *rows)))
        if is_resolved.all():
            break
        bad = ~is_resolved
        middle = 0.5 * (left[bad] + right[bad])
        base, order = np.tile(base[bad], 2), np.concatenate([order[bad], order[bad] + 0.5 ** (depth + 1)])
        left, right = np.concatenate([left[bad], middle]), np.concatenate([middle, right[bad]])
    columns = [np.concatenate(column) for column in zip(*done, strict=True)]
    rank = np.argsort(columns[0], kind="stable")
    return tuple(column[rank] for column in columns[1:])
