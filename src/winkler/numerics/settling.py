"""Integrals over a unit interval, with rules refined until the result settles.

`settled` evaluates many integrals at once; those that have settled drop out.  Gauss-Legendre rules come first
(analytic integrands converge geometrically), then the double-exponential rule, which does not mind algebraic or
logarithmic singularities at the ends of the interval.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.quadrature import gauss_legendre, tanh_sinh
from winkler.numerics.types import Array

__all__ = ["settled"]

TOLERANCE = 2e-13
"""Relative change, against the integral of the modulus, below which a result counts as settled."""
LAST_TOLERANCE = 1e-9
"""The same for the finest rule; beyond it the integral is refused."""
CHUNK = 2_000_000
"""Largest number of points of one evaluation, to bound memory."""

Integrand = Callable[[Array, Array], Array]

LADDER: tuple[tuple[str, int], ...] = (
    ("gauss", 12),
    ("gauss", 24),
    ("gauss", 48),
    ("gauss", 96),
    ("double exponential", 161),
    ("double exponential", 321),
    ("double exponential", 641),
)


def _rule(name: str, count: int) -> tuple[Array, Array]:
    if name == "gauss":
        return gauss_legendre(count)
    nodes, _, weights = tanh_sinh(count)
    return nodes, weights


def settled(integrand: Integrand, count: int, what: str, noise: Array | None = None) -> Array:
    """Integrate over the unit interval until the result settles.

    Parameters
    ----------
    integrand
        Called with nodes ``(n,)`` in (0, 1) and an index ``(m,)`` of the integrals wanted; returns ``(m, n)``.
    count
        How many integrals there are.
    what
        What is integrated, for the message.
    noise : ndarray, (count,), optional
        How far rounding of the argument spoils each integrand, relative to its modulus; a change of that size counts
        as settled.

    Returns
    -------
    ndarray, (count,)

    Raises
    ------
    NotConverged
        If a result still moves by more than 1e-9 of the integral of its modulus at the finest rule.
    """
    floor = np.zeros(count) if noise is None else 4.0 * noise
    result = np.zeros(count)
    open_index = np.arange(count)
    last = np.full(count, np.nan)
    change, size = last, last
    for name, points in LADDER:
        nodes, weights = _rule(name, points)
        current = np.empty(open_index.size)
        size = np.empty(open_index.size)
        step = max(1, CHUNK // points)
        for start in range(0, open_index.size, step):
            part = slice(start, start + step)
            values = integrand(nodes, open_index[part])
            current[part] = values @ weights
            size[part] = np.abs(values) @ weights
        result[open_index] = current
        change = np.abs(current - last)
        stays = ~(change <= np.maximum(TOLERANCE, floor[open_index]) * size)
        if not stays.any():
            return result
        open_index, last, change, size = open_index[stays], current[stays], change[stays], size[stays]
    relative = change / np.where(size > 0.0, size, 1.0)
    worst = float(np.max(relative))
    if not np.all(relative <= np.maximum(LAST_TOLERANCE, floor[open_index])):
        raise NotConverged(
            f"The integral for the {what} still moves by {worst:.1e} of its size at {LADDER[-1][1]} points; "
            "the shape is not smooth between its stated kinks: state them, or give the shape as measured points."
        )
    return result
