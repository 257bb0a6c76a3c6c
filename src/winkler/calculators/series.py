"""Smooth functions as pieces of Chebyshev series: made of numbers of the package, read by kernels."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.polynomial import chebyshev

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

__all__ = ["DEGREE", "TOLERANCE", "series", "series_of_two", "table_of", "table_of_two"]

TOLERANCE = 1e-11
"""Error of a table between its nodes, over the greatest number of the same piece."""
DEGREE = 20
DEGREE_OF_TWO = 40
MOST_PIECES = 64
ALMOST_ONE = 1.0 + 1e-9
"""A number at the end of a table may be rounded beyond it."""
CHECKED = np.array([-0.97, -0.61, -0.13, 0.29, 0.74, 0.985])
"""Where a piece, from -1 to 1, is compared with the function."""


def series(table: Array, x: float) -> float:
    """Return what a table of `table_of` has at x; not-a-number outside its ends.

    Parameters
    ----------
    table : ndarray
    x : float
    """
    pieces = int(table[0])
    count = int(table[1])
    piece = 0
    while piece + 1 < pieces and x > table[3 + piece]:
        piece += 1
    low = table[2 + piece]
    high = table[3 + piece]
    t = (2.0 * x - low - high) / (high - low)
    if not -ALMOST_ONE <= t <= ALMOST_ONE:
        return math.nan
    first = 3 + pieces + piece * count
    above = 0.0
    here = 0.0
    for k in range(count - 1, 0, -1):
        below = 2.0 * t * here - above + table[first + k]
        above = here
        here = below
    return float(t * here - above + table[first])


def series_of_two(table: Array, x: float, y: float) -> float:
    """Return what a table of `table_of_two` has at x and y.

    Parameters
    ----------
    table : ndarray
    x, y : float
    """
    count = int(table[0])
    s = (2.0 * x - table[1] - table[2]) / (table[2] - table[1])
    t = (2.0 * y - table[3] - table[4]) / (table[4] - table[3])
    above = 0.0
    here = 0.0
    for j in range(count - 1, -1, -1):
        over = 0.0
        inner = 0.0
        for k in range(count - 1, 0, -1):
            below = 2.0 * t * inner - over + table[5 + j * count + k]
            over = inner
            inner = below
        row = t * inner - over + table[5 + j * count]
        if j > 0:
            under = 2.0 * s * here - above + row
            above = here
            here = under
        else:
            here = s * here - above + row
    return here


def table_of(function: Callable[[float], float], low: float, high: float, tolerance: float = TOLERANCE) -> Array:
    """Return a table of a function, bisected until its error is small enough.

    Parameters
    ----------
    function : callable
        Of one number.
    low, high : float
    tolerance : float, optional
        Greatest error between the nodes, over the greatest number of the same piece.

    Raises
    ------
    NotConverged
        If it needs too many pieces, as a function with noise does.
    """
    done: list[tuple[float, float, Array]] = []
    open_ = [(low, high)]
    while open_:
        a, b = open_.pop()
        middle, half = 0.5 * (a + b), 0.5 * (b - a)
        nodes = chebyshev.chebpts1(DEGREE + 1)
        values = np.array([function(float(middle + half * node)) for node in nodes])
        coefficients = chebyshev.chebfit(nodes, values, DEGREE)
        true = np.array([function(float(middle + half * place)) for place in CHECKED])
        error = np.max(np.abs(chebyshev.chebval(CHECKED, coefficients) - true))
        if error <= tolerance * np.max(np.abs(values)):
            done.append((a, b, coefficients))
        elif len(done) + len(open_) + 2 > MOST_PIECES:
            raise NotConverged(
                f"calculators: {MOST_PIECES} pieces from {low:g} to {high:g} are off by {error:.2g}; give a smoother "
                "function, or another variable."
            )
        else:
            open_ += [(middle, b), (a, middle)]
    edges = [done[0][0], *(end for _, end, _ in done)]
    return np.array([len(done), DEGREE + 1, *edges, *np.concatenate([part for _, _, part in done])])


def table_of_two(
    function: Callable[[float, float], float], first: tuple[float, float], second: tuple[float, float]
) -> Array:
    """Return a table of a function of two numbers: one product of Chebyshev series.

    Parameters
    ----------
    function : callable
    first, second : tuple of float
        Least and greatest of both numbers.

    Raises
    ------
    NotConverged
        If it is off by more than `TOLERANCE`.
    """
    nodes = chebyshev.chebpts1(DEGREE_OF_TWO + 1)

    def at(s: float, t: float) -> float:
        return function(_between(first, s), _between(second, t))

    values = np.array([[at(float(s), float(t)) for t in nodes] for s in nodes])
    inverse = np.linalg.inv(chebyshev.chebvander(nodes, DEGREE_OF_TWO))
    coefficients = inverse @ values @ inverse.T
    places = CHECKED[::2]
    true = np.array([[at(float(s), float(t)) for t in places] for s in places])
    error = np.max(np.abs(chebyshev.chebgrid2d(places, places, coefficients) - true))
    if not error <= TOLERANCE * np.max(np.abs(values)):
        raise NotConverged(f"calculators: a table of two numbers is off by {error:.2g}; give narrower ranges.")
    return np.array([DEGREE_OF_TWO + 1, *first, *second, *coefficients.ravel()])


def _between(ends: tuple[float, float], t: float) -> float:
    return 0.5 * (ends[0] + ends[1]) + 0.5 * (ends[1] - ends[0]) * t
