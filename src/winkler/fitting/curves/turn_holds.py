"""Holds at a turn of a noisy signal that are too short for their density of samples to stand out.

About the turn, two straight lines joined by a level are compared with two parabolas that meet in a point, and with a
polynomial: the hold is one if it leaves clearly less, although it has fewer numbers.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

__all__ = ["turn_hold"]

MOST_REACH, FEWEST_REACH = 240, 12
"""Most and fewest points on each side of a turn."""
FEWEST_HELD, SMOOTH_DEGREE = 5, 6
"""Fewest points of a hold, and degree of the polynomial of a smooth turn."""
TRIALS = 17
"""Trial places of each end of the level; refined once."""
LEAST_GAIN = 30.0
"""Least difference of the squares left, over the variance of the noise."""
LEAST_RISE_TO_NOISE = 5.0
"""Least change along either side over the noise."""


def turn_hold(level: Array, noise: float, before: int, turn: int, behind: int) -> tuple[int, int] | None:
    """Return first and last point of the hold at a turn; None if there is none.

    Parameters
    ----------
    level : ndarray, (n,)
        The signal that the machine drives.
    noise : float
        Its standard deviation.
    before, turn, behind : int
        The turn, and those before and behind it.
    """
    reach = min(turn - before, behind - turn, MOST_REACH)
    if reach < FEWEST_REACH or not noise > 0.0:
        return None
    y = level[turn - reach : turn + reach + 1]
    x = np.arange(-reach, reach + 1.0)
    ends = np.linspace(-0.8 * reach, 0.8 * reach, TRIALS)
    start, stop, left = _best_level(x, y, ends, ends)
    fine = np.linspace(-1.0, 1.0, TRIALS) * 1.6 * reach / (TRIALS - 1)
    start, stop, left = _best_level(x, y, start + fine, stop + fine)
    variance = max(noise**2, left / max(x.size - 5, 1))
    peaked = _least_left(_peaks(x, np.linspace(-0.3 * reach, 0.3 * reach, TRIALS)), y)
    peaked = min(peaked, _left(np.polynomial.legendre.legvander(x / reach, SMOOTH_DEGREE), y))
    if stop - start < FEWEST_HELD or peaked - left < LEAST_GAIN * variance:
        return None
    columns = _flat(x, start, stop)
    _, rise, fall = np.linalg.lstsq(columns, y, rcond=None)[0]
    least = LEAST_RISE_TO_NOISE * noise
    if rise * fall >= 0.0 or abs(rise) * (start + reach) < least or abs(fall) * (reach - stop) < least:
        return None
    return turn + int(np.ceil(start)), turn + int(np.floor(stop))


def _best_level(x: Array, y: Array, starts: Array, stops: Array) -> tuple[float, float, float]:
    """Return the ends of the level that leaves least, and the squares that it leaves."""
    of_start, of_stop = (
        grid.ravel() for grid in np.meshgrid(np.arange(starts.size), np.arange(stops.size), indexing="ij")
    )
    first, last = starts[of_start], stops[of_stop]
    possible = (last >= first) & (first > x[0] + 2.0) & (last < x[-1] - 2.0)
    first, last, of_start, of_stop = (one[possible] for one in (first, last, of_start, of_stop))
    if not first.size:
        return 0.0, 0.0, float("inf")
    centred = y - y.mean()
    before, behind = np.minimum(x - starts[:, None], 0.0), np.maximum(x - stops[:, None], 0.0)
    products = np.zeros((first.size, 3, 3))  # the sides share no point
    products[:, 0, 0] = x.size
    for place, side, chosen in ((1, before, of_start), (2, behind, of_stop)):
        products[:, 0, place] = products[:, place, 0] = side.sum(axis=1)[chosen]
        products[:, place, place] = np.sum(side**2, axis=1)[chosen]
    right = np.stack(
        [np.full(first.size, centred.sum()), (before @ centred)[of_start], (behind @ centred)[of_stop]], axis=1
    )
    numbers = np.linalg.solve(products, right[..., None])[..., 0]
    left = float(centred @ centred) - np.einsum("gi,gi->g", numbers, right)
    best = int(np.argmin(left))
    return float(first[best]), float(last[best]), float(left[best])


def _flat(x: Array, start: float, stop: float) -> Array:
    return np.stack([np.ones(x.size), np.minimum(x - start, 0.0), np.maximum(x - stop, 0.0)], axis=1)


def _peaks(x: Array, places: Array) -> Array:
    """Return the columns of two parabolas that meet at each of the places, below each other ``(m, 5, n)``."""
    beside = (x - places[:, None]) / x[-1]
    before, behind = np.minimum(beside, 0.0), np.maximum(beside, 0.0)
    return np.stack([np.ones_like(beside), before, before**2, behind, behind**2], axis=1)


def _least_left(columns: Array, y: Array) -> float:
    """Return the least squares that any of several sets of columns ``(m, k, n)`` leaves."""
    centred = y - y.mean()  # every set holds a constant
    numbers = np.linalg.solve(columns @ columns.swapaxes(1, 2), (columns @ centred)[..., None])
    rest = centred - (numbers.swapaxes(1, 2) @ columns)[:, 0]
    return float(np.min(np.sum(rest**2, axis=1)))


def _left(columns: Array, y: Array) -> float:
    rest = y - columns @ np.linalg.lstsq(columns, y, rcond=None)[0]
    return float(rest @ rest)
