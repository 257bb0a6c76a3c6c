r"""Steps of a stiff system whose rates only damp: Runge-Kutta-Chebyshev, second order, as many stages as a step needs.

A step of s stages is stable up to :math:`\tfrac23(s^2-1)` over the fastest rate, where s steps of an ordinary method
reach 2 s: what wears is smoothed, and long waves matter long after short ones are gone.  The error of each step is
estimated from the rates at both ends.

B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J. Comput. Appl. Math. 88 (1998) 315-326,
doi:10.1016/S0377-0427(97)00219-7
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

MOST_STAGES = 100
DAMPING = 2.0 / 13.0


class _StageRule(NamedTuple):
    first: float
    rows: tuple[tuple[float, float, float, float], ...]


@functools.lru_cache(maxsize=MOST_STAGES)
def _rule(stages: int) -> _StageRule:
    w0 = 1.0 + DAMPING / stages**2
    t, dt, ddt = [1.0, w0], [0.0, 1.0], [0.0, 0.0]
    for _ in range(2, stages + 1):
        t.append(2.0 * w0 * t[-1] - t[-2])
        ddt.append(4.0 * dt[-1] + 2.0 * w0 * ddt[-1] - ddt[-2])
        dt.append(2.0 * t[-2] + 2.0 * w0 * dt[-1] - dt[-2])
    w1 = dt[stages] / ddt[stages]
    b = [0.0, 0.0] + [ddt[j] / dt[j] ** 2 for j in range(2, stages + 1)]
    b[0] = b[1] = b[2]
    rows = []
    for j in range(2, stages + 1):
        mu = 2.0 * b[j] * w0 / b[j - 1]
        nu = -b[j] / b[j - 2]
        to_rate = 2.0 * b[j] * w1 / b[j - 1]
        rows.append((mu, nu, to_rate, -(1.0 - b[j - 1] * t[j - 1]) * to_rate))
    return _StageRule(b[1] * w1, tuple(rows))


def longest(stages: int, fastest: float) -> float:
    """Return the longest stable step of so many stages, if nothing decays faster than `fastest`."""
    return 0.65 * (stages**2 - 1.0) / fastest if fastest > 0.0 else math.inf


def stages_for(length: float, fastest: float) -> int:
    """Return how many stages a step of this length needs, at least two."""
    return max(2, math.ceil(math.sqrt(1.0 + length * fastest / 0.65)))


def step(rates: Callable[[Array], Array], start: Array, first: Array, length: float, stages: int) -> Array:
    """Return the state after a step.

    Parameters
    ----------
    rates : callable
        State to its rates.
    start, first : ndarray
        The state, and its rates.
    length : float
    stages : int
        At least two.
    """
    rule = _rule(stages)
    before, now = start, start + rule.first * length * first
    for mu, nu, to_rate, to_first in rule.rows:
        following = (
            (1.0 - mu - nu) * start + mu * now + nu * before + length * (to_rate * rates(now) + to_first * first)
        )
        before, now = now, following
    return now


def step_error(start: Array, end: Array, first: Array, last: Array, length: float) -> Array:
    """Return the estimated error of a step, from states and rates at both ends."""
    return np.asarray(0.8 * (start - end) + 0.4 * length * (first + last))
