r"""Smallest balls about points of three dimensions that come in pairs, mirrored at a plane.

A ball about (x, y, w) with w the square of the distance from the plane has the radius
:math:`\max_i\sqrt{(x_i-c_x)^2+(y_i-c_y)^2+w_i}`.  A point outside is exchanged for one of those that touch, of which
three are enough.

E. Welzl, Lect. Notes Comput. Sci. 555 (1991) 359-370, doi:10.1007/BFb0038202
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

EXCHANGES, SETTLED = 1000, 1e-13
"""At most so many points are exchanged, until none lies farther outside than this part of the square."""


@compiled
def smallest_balls(across: Array, down: Array, raised: Array, square: Array, centre: Array, touched: Array) -> None:
    """Write the smallest balls about columns of points (x, y, +-sqrt(w)), whose middles lie at z = 0.

    Parameters
    ----------
    across, down, raised : ndarray, (n, d)
        x, y and w.
    square : ndarray, (d,)
        For the squares of the radii.
    centre : ndarray, (2, d)
        For the middles.
    touched : ndarray of int64, (3, d)
        For up to three points on each ball, -1 for none.
    """
    count = across.shape[0]
    basis, trial, found = np.empty(3, np.int64), np.empty(3, np.int64), np.empty(3, np.int64)
    for column in range(across.shape[1]):
        x, y, w = across[:, column], down[:, column], raised[:, column]
        size, basis[0] = 1, 0
        for i in range(count):
            if w[i] > w[basis[0]]:
                basis[0] = i
        cx, cy, level = x[basis[0]], y[basis[0]], w[basis[0]]
        for _ in range(EXCHANGES):
            worst, most = 0, -1.0
            for i in range(count):
                here = (x[i] - cx) ** 2 + (y[i] - cy) ** 2 + w[i]
                if here > most:
                    worst, most = i, here
            if most <= level * (1.0 + SETTLED):
                break
            # the new place touches; of what touched before at most two remain
            best, best_x, best_y, best_size = math.inf, cx, cy, 0
            for one in range(-1, size):
                for two in range(-1, max(one, 0)):
                    trial[0], length = worst, 1
                    if one >= 0:
                        trial[length] = basis[one]
                        length += 1
                    if two >= 0:
                        trial[length] = basis[two]
                        length += 1
                    px, py = x[worst], y[worst]
                    if length == 2:
                        dx, dy = x[trial[1]] - px, y[trial[1]] - py
                        share = 0.5 * (1.0 + (w[trial[1]] - w[worst]) / (dx * dx + dy * dy))
                        px, py = px + share * dx, py + share * dy
                    elif length == 3:
                        dx, dy = x[trial[1]] - px, y[trial[1]] - py
                        ex, ey = x[trial[2]] - px, y[trial[2]] - py
                        f = 0.5 * (dx * dx + dy * dy + w[trial[1]] - w[worst])
                        g = 0.5 * (ex * ex + ey * ey + w[trial[2]] - w[worst])
                        twice = dx * ey - dy * ex
                        px, py = px + (f * ey - g * dy) / twice, py + (g * dx - f * ex) / twice
                    here = (x[worst] - px) ** 2 + (y[worst] - py) ** 2 + w[worst]
                    inside = here < best
                    for k in range(size):
                        i = basis[k]
                        inside = inside and (x[i] - px) ** 2 + (y[i] - py) ** 2 + w[i] <= here * (1.0 + SETTLED)
                    if inside:
                        best, best_x, best_y, best_size = here, px, py, length
                        for k in range(3):  # to compile an assignment of slices takes seconds
                            found[k] = trial[k]
            if best_size == 0 or best <= level:
                break  # rounding
            cx, cy, level, size = best_x, best_y, best, best_size
            for k in range(3):
                basis[k] = found[k]
        square[column], centre[0, column], centre[1, column] = level, cx, cy
        for k in range(3):
            touched[k, column] = basis[k] if k < size else -1
