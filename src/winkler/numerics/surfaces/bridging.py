"""Numbers on a grid that are missing, or should be: spikes, and the smoothest surface that bridges holes."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

WINDOW_PIXELS = 9
"""Along the side of the square that a spike must stand out of; it may fill a quarter of it."""


def bridged(numbers: Array, periodic: bool) -> Array:
    """Return the grid with Laplace's equation solved where it is nan; at a free border nothing flows through.

    Examples
    --------
    >>> bridged(np.array([[0.0, 1.0, 2.0], [0.0, np.nan, 2.0], [0.0, 1.0, 2.0]]), False)[1]
    array([0., 1., 2.])
    """
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import spsolve

    holes = np.isnan(numbers)
    count = int(np.count_nonzero(holes))
    if not count:
        return numbers
    index = np.full(numbers.shape, -1)
    index[holes] = np.arange(count)
    rows, columns, weights = [], [], []
    right, degree = np.zeros(count), np.zeros(count)
    i, j = np.nonzero(holes)
    for di, dj in ((-1, 0), (1, 0), (0, -1), (0, 1)):
        ni, nj = i + di, j + dj
        if periodic:
            ni, nj = ni % numbers.shape[0], nj % numbers.shape[1]
        there = (ni >= 0) & (ni < numbers.shape[0]) & (nj >= 0) & (nj < numbers.shape[1])
        me, ni, nj = np.arange(count)[there], ni[there], nj[there]
        degree[me] += 1.0
        other = index[ni, nj]
        fixed = other < 0
        np.add.at(right, me[fixed], numbers[ni[fixed], nj[fixed]])
        rows.append(me[~fixed])
        columns.append(other[~fixed])
        weights.append(np.full(np.count_nonzero(~fixed), -1.0))
    rows.append(np.arange(count))
    columns.append(np.arange(count))
    weights.append(degree)
    matrix = coo_array((np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns))), shape=(count, count))
    whole = numbers.copy()
    whole[holes] = spsolve(matrix.tocsc(), right)
    return whole


def spikes(numbers: Array, times: float, periodic: bool) -> Array:
    """Return where numbers lie outside of Tukey's fences: `times` the distance of the quartiles beyond a quartile.

    The quartiles are those of the numbers around, their distance at least the median of all such distances.  Holes are
    bridged before, and are no spikes.

    Examples
    --------
    >>> rough = np.sin(np.arange(20.0) ** 2)[:, None] + np.cos(np.arange(15.0) ** 2)[None, :]
    >>> rough[4, 4:6] = 20.0
    >>> np.argwhere(spikes(rough, 4.0, False))
    array([[4, 4],
           [4, 5]])
    """
    from scipy.ndimage import rank_filter

    holes = np.isnan(numbers)
    whole = bridged(numbers, periodic)
    around = np.zeros((WINDOW_PIXELS, WINDOW_PIXELS), dtype=bool)
    around[::2, ::2] = True  # every second one is enough
    quarter, mode = int(np.count_nonzero(around)) // 4, "wrap" if periodic else "reflect"
    low, high = (rank_filter(whole, rank, footprint=around, mode=mode) for rank in (quarter, 3 * quarter))
    distance = np.maximum(high - low, np.median(high - low))
    return np.asarray(((whole > high + times * distance) | (whole < low - times * distance)) & ~holes)
