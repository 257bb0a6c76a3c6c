"""Columns of the factor of an inverse, each from the response of pixels near its own."""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

REACH = 3
"""How far pixels count, in cells of their level."""
MOST_NEAR = (2 * REACH + 1) ** 2
"""Most pixels that can count for one."""
LEAST_PIVOT = 1e-14
"""Of the response of a pixel to itself: smaller pivots are rounding."""


@compiled
def fill_columns(
    fresh: Array,
    x: Array,
    y: Array,
    rank: Array,
    table: Array,
    cell: int,
    kernel: Array,
    periodic: bool,
    members: Array,
    values: Array,
    counts: Array,
    factor: Array,
) -> None:
    """Fill the columns of the pixels that are new on a level.

    Parameters
    ----------
    fresh : ndarray, (k,)
        These pixels.
    x, y, rank : ndarray, (n,)
        Places, and ranks from coarse to fine, of all pixels.
    table : ndarray, (cx, cy)
        The pixel that stands for each cell of this level; -1 for none.
    cell : int
        Side of the cells [pixels].
    kernel : ndarray, (nx, ny)
        Displacement at (i, j) under one pixel at (0, 0).
    periodic : bool
        Whether distances go round.
    members, values : ndarray, (n, MOST_NEAR)
        Pixels and numbers of every column, which are written.
    counts : ndarray, (n,)
        How many they are, which is written.
    factor : ndarray, (MOST_NEAR, MOST_NEAR)
        Room to work in.
    """
    wide, high = kernel.shape
    across, along = table.shape
    for i in fresh:
        near, a, b = 0, x[i] // cell, y[i] // cell
        for da in range(-REACH, REACH + 1):
            for db in range(-REACH, REACH + 1):
                ca, cb = a + da, b + db
                if periodic and across > 2 * REACH + 1:
                    ca %= across
                if periodic and along > 2 * REACH + 1:
                    cb %= along
                if ca < 0 or cb < 0 or ca >= across or cb >= along:
                    continue
                j = table[ca, cb]
                if j < 0 or rank[j] >= rank[i]:
                    continue
                dx, dy = abs(x[i] - x[j]), abs(y[i] - y[j])
                if periodic:
                    dx, dy = min(dx, wide - dx), min(dy, high - dy)
                if dx * dx + dy * dy <= (REACH * cell) ** 2:
                    members[i, near] = j
                    near += 1
        members[i, near] = i
        near += 1
        counts[i] = near
        factor[:near, :near] = 0.0
        for r in range(near):
            for c in range(r + 1):
                one, other = members[i, r], members[i, c]
                left = kernel[abs(x[one] - x[other]), abs(y[one] - y[other])]
                for k in range(c):
                    left -= factor[r, k] * factor[c, k]
                if r == c:
                    factor[r, r] = math.sqrt(max(left, LEAST_PIVOT * kernel[0, 0]))
                else:
                    factor[r, c] = left / factor[c, c]
        for r in range(near - 1, -1, -1):
            left = 1.0 if r == near - 1 else 0.0
            for k in range(r + 1, near):
                left -= factor[k, r] * values[i, k]
            values[i, r] = left / factor[r, r]
