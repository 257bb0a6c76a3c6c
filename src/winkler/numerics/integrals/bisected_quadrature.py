"""Integrals of functions that are smooth but for kinks at unknown places: panels halved where they matter.

Springs that begin to slide leave a kink in whatever is summed over them, and where it lies is only known once the sum
is half done.  A panel is halved until its two halves add up to its own value; all integrals and panels that are
still open are evaluated together.

A kink may hide where the rule happens to be right before and after halving: the halves must agree on the first and
second moments too, which costs nothing more.  And it may hide beside the end of a panel: the rule is Lobatto's, which
evaluates the ends.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

NODES_PER_PANEL = 13
"""Nodes on each panel."""
AXIS_OFFSET = 1e-9
"""Offset from zero of a panel that begins there, over its width: at zero a function may not be defined."""
VARIABLE_POWER = 4
"""Springs are counted by the fourth root of their place: their stiffness may diverge towards the axis."""
MOST_HALVINGS = 60
"""How often a panel is halved at most."""
MOST_PANELS = 200_000
"""Largest number of open panels."""
LEAST_WIDTH_RATIO = 32.0 * np.finfo(float).eps
"""Width of a panel, in terms of its place, within which rounding dominates."""
Integrand = Callable[[Array, Array], Array]


def refined(function: Integrand, edges: Array, tolerance: Array, what: str) -> Array:
    """Return the integrals of many functions over the same interval.

    Parameters
    ----------
    function
        Takes places ``(k,)`` and the indices ``(k,)`` of the functions they belong to; returns values ``(k,)``.
    edges : ndarray, (p,)
        Ends of the panels to begin with, ascending from zero or above: known kinks, and places where much happens.
    tolerance : ndarray, (n,)
        Of each integral: how much halving a panel may change it, relative to the integral of the modulus.
    what : str
        What is integrated, for the message.

    Returns
    -------
    ndarray, (n,)

    Raises
    ------
    NotConverged
        If panels stay open.

    Examples
    --------
    >>> import numpy as np
    >>> kinked = lambda x, index: np.abs(x - 0.1 * np.sqrt(2.0))
    >>> round(float(refined(kinked, np.array([0.0, 1.0]), np.array([1e-13]), "a kink")[0]), 12)  # 1/2 - b + b^2
    0.378578643763
    """
    number = tolerance.size
    low = np.tile(edges[:-1], number)
    high = np.tile(edges[1:], number)
    which = np.repeat(np.arange(number), edges.size - 1)
    sums, modulus = _panels(function, low, high, which)
    total, size = np.zeros(number), np.zeros(number)
    for _ in range(MOST_HALVINGS):
        middle = 0.5 * (low + high)
        halves, moduli = _panels(
            function, np.concatenate([low, middle]), np.concatenate([middle, high]), np.concatenate([which, which])
        )
        left, right = halves.reshape(2, -1, 3).transpose(0, 2, 1)
        better = left[0] + right[0]
        first = 0.5 * (left[1] + right[1]) + 0.5 * (right[0] - left[0])
        second = 0.25 * (left[2] + right[2]) + 0.5 * (right[1] - left[1]) + 0.25 * better
        moved = np.max(np.abs(np.stack([better, first, second], axis=1) - sums), axis=1)
        scale = size + np.bincount(which, modulus, number)
        closed = (moved <= (tolerance * scale)[which]) | (high - low <= LEAST_WIDTH_RATIO * np.abs(high))
        total += np.bincount(which[closed], better[closed], number)
        size += np.bincount(which[closed], modulus[closed], number)
        again = ~closed
        if not again.any():
            return total
        low, high = np.concatenate([low[again], middle[again]]), np.concatenate([middle[again], high[again]])
        which = np.concatenate([which[again], which[again]])
        sums = halves.reshape(2, -1, 3)[:, again].reshape(-1, 3)
        modulus = moduli.reshape(2, -1)[:, again].ravel()
        if low.size > MOST_PANELS:
            break
    raise NotConverged(f"The {what} does not settle: {low.size} panels stay open after halving them.")


@functools.cache
def _lobatto() -> tuple[Array, Array]:
    """Return nodes of Lobatto's rule on [-1, 1], and what integral and first two moments weigh them with ``(n, 3)``."""
    legendre = np.polynomial.legendre.Legendre.basis(NODES_PER_PANEL - 1)
    place = np.concatenate([[-1.0], np.sort(legendre.deriv().roots().real), [1.0]])
    weights = 1.0 / (NODES_PER_PANEL * (NODES_PER_PANEL - 1) * legendre(place) ** 2)
    return place, np.stack([weights, weights * place, weights * place**2], axis=1)


def _panels(function: Integrand, low: Array, high: Array, which: Array) -> tuple[Array, Array]:
    """Return integral and first two moments ``(p, 3)`` on every panel, in halves of its width, and of the modulus."""
    place, weights = _lobatto()
    width = high - low
    x = np.minimum(low[:, None] + width[:, None] * (0.5 * (1.0 + place)), high[:, None])
    x[:, 0] = np.where(low > 0.0, low, AXIS_OFFSET * width)
    values = width[:, None] * function(x.ravel(), np.repeat(which, NODES_PER_PANEL)).reshape(x.shape)
    return values @ weights, np.abs(values) @ weights[:, 0]


def along_springs(function: Integrand, edges: Array, tolerance: Array, what: str) -> Array:
    """Return integrals as `refined` does, of functions that may diverge at zero like the stiffness of graded springs.

    Parameters
    ----------
    function, edges, tolerance, what
        As there; the first edge is not negative.
    """
    end = edges[-1]

    def counted(t: Array, index: Array) -> Array:
        x = np.clip(end * t**VARIABLE_POWER, edges[0], end)
        return np.asarray(function(x, index) * (VARIABLE_POWER * end * t ** (VARIABLE_POWER - 1)))

    return refined(counted, (edges / end) ** (1.0 / VARIABLE_POWER), tolerance, what)


def towards(end: float, edges: Sequence[float], halvings: int) -> Array:
    """Return ends of panels on (0, end): the edges inside it, and panels that halve their distance from the end.

    Parameters
    ----------
    end : float
        Where much may happen in little space.
    edges : sequence of float
        Other ends of panels.
    halvings : int
        How many.
    """
    inner = [b for b in edges if 0.0 < b < end]
    return np.unique(np.concatenate([[0.0], end * (1.0 - 0.5 ** np.arange(1, halvings + 1)), inner, [end]]))
