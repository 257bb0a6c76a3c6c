"""Moments of harmonic oscillations: evenly spaced, and at every turning point.

Time is counted in turns: one turn is one cycle.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.limits import PATH_POINTS

MOMENT_TOLERANCE = 1e-9
"""Moments closer than that are one: at a turning point the sine does not resolve them."""


def sine(turns: Array) -> Array:
    """Return sin(2 pi t), exactly zero, one and minus one at quarters of turns.

    Parameters
    ----------
    turns : ndarray
        t [-].

    Returns
    -------
    ndarray
        The same shape.

    Examples
    --------
    >>> sine(np.array([0.0, 0.25, 0.5, 0.75, 1.0]))
    array([ 0.,  1.,  0., -1.,  0.])
    """
    quarters = 4.0 * np.asarray(turns, dtype=float)
    nearest = np.round(quarters)
    rest = 0.5 * np.pi * (quarters - nearest)
    whole = np.mod(nearest, 4.0)
    even = np.where(whole == 0.0, 1.0, -1.0) * np.sin(rest)
    odd = np.where(whole == 1.0, 1.0, -1.0) * np.cos(rest)
    return np.asarray(np.where(np.mod(whole, 2.0) == 0.0, even, odd) + 0.0)


def oscillation_moments(cycles: float, count: int, waves: tuple[tuple[float, float], ...] = ((1.0, 0.0),)) -> Array:
    """Return moments from 0 to `cycles` at which waves sin(2 pi (rate t + lead)) are to be known.

    Parameters
    ----------
    cycles : float
        How long [turns], positive.
    count : int
        Even spacing: moments in each cycle of the fastest wave, at least one.
    waves : tuple of (rate, lead), optional
        Cycles per turn, and by how many turns a wave is ahead.

    Returns
    -------
    ndarray, (steps,)
        Rising; with the ends and every turning point of every wave.

    Raises
    ------
    InvalidInput
        If a number is not positive, or there would be too many moments.

    Examples
    --------
    >>> oscillation_moments(1.0, 5)
    array([0.  , 0.2 , 0.25, 0.4 , 0.6 , 0.75, 0.8 , 1.  ])
    """
    for word, number in (("cycles", cycles), *(("the ratio of frequencies", rate) for rate, _ in waves)):
        if isinstance(number, bool) or not isinstance(number, int | float) or not 0.0 < number < math.inf:
            raise InvalidInput(f"An oscillation: {word} is {number!r}; it must be a positive, finite number.")
    if isinstance(count, bool) or not isinstance(count, int) or count < 1:
        raise InvalidInput(f"An oscillation: count is {count!r}; give a whole number of points per cycle, at least 1.")
    fastest = max(rate for rate, _ in waves)
    total = math.ceil(cycles * fastest * count)
    if total > PATH_POINTS:
        raise InvalidInput(f"An oscillation: {cycles:g} cycles of {count} points are more than {PATH_POINTS} points.")
    parts = [np.linspace(0.0, cycles, total + 1)]
    for rate, lead in waves:
        first, last = math.ceil(2.0 * lead - 0.5), math.floor(2.0 * (rate * cycles + lead) - 0.5)
        parts.append((np.arange(first, last + 1) / 2.0 + 0.25 - lead) / rate)
    moments = np.sort(np.clip(np.concatenate(parts), 0.0, cycles))
    distinct: Array = moments[np.append(True, np.diff(moments) > MOMENT_TOLERANCE)]
    distinct[-1] = cycles
    return distinct
