"""Integrals over a unit interval, with rules refined until the result settles.

`settled` evaluates many integrals at once; those that have settled drop out.  Gauss-Legendre rules come first
(analytic integrands converge geometrically), then the double-exponential rule, which does not mind algebraic or
logarithmic singularities at the ends of the interval, then Gauss-Legendre rules on many panels, for many waves.  A
result has settled when two rules of the same family agree.  Four panels of 48 points never follow one of 96: at a
singular end both err by the same amount, to leading order, and agree before they are right.

`scipy.integrate.tanhsinh` reaches the same digits (`benchmarks/bench_scipy.py`).  It takes five times as long or more
for one integral, and for a thousand that are smooth; for a thousand with singular ends about as long.
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre, tanh_sinh
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

TOLERANCE = 2e-13
"""Relative change, against the integral of the modulus, below which a result counts as settled."""
LAST_TOLERANCE = 1e-9
"""The same for the finest rule; beyond it the integral is refused."""
POINTS_PER_CHUNK = 2_000_000
"""Largest number of points of one evaluation, to bound memory."""

Integrand = Callable[[Array, Array], Array]

RULE_LADDER: tuple[tuple[str, int], ...] = (
    ("gauss", 12),
    ("gauss", 24),
    ("gauss", 48),
    ("gauss", 96),
    ("double exponential", 81),
    ("double exponential", 161),
    ("double exponential", 321),
    ("double exponential", 641),
    ("gauss", 768),
    ("gauss", 3072),
)
POINTS_PER_PANEL = 48
"""Points on each panel of a Gauss-Legendre rule of more than twice as many."""


def _rule(name: str, count: int) -> tuple[Array, Array]:
    if name == "gauss":
        return gauss_legendre(count) if count <= 2 * POINTS_PER_PANEL else _panelled(count // POINTS_PER_PANEL)
    nodes, _, weights = tanh_sinh(count)
    return nodes, weights


@functools.lru_cache(maxsize=8)
def _panelled(panels: int) -> tuple[Array, Array]:
    nodes, weights = gauss_legendre(POINTS_PER_PANEL)
    start = np.arange(panels)[:, None]
    return ((start + nodes) / panels).ravel(), np.tile(weights / panels, panels)


def settled(
    integrand: Integrand, count: int, what: str, noise: Array | None = None, against: Array | float = 0.0
) -> Array:
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
    against : ndarray, (count,), or float, optional
        What the results will be added to: an integral smaller than that is measured against it.

    Returns
    -------
    ndarray, (count,)

    Raises
    ------
    NotConverged
        If a result still moves by more than 1e-9 of the integral of its modulus at the finest rule.
    """
    floor = np.zeros(count) if noise is None else 4.0 * noise
    least = np.broadcast_to(against, (count,))
    result = np.zeros(count)
    moved = np.full(count, np.inf)
    last = {name: np.full(count, np.nan) for name, _ in RULE_LADDER}
    waiting = np.arange(count)
    for name, points in RULE_LADDER:
        nodes, weights = _rule(name, points)
        for part in (waiting[some] for some in chunks(waiting.size, points, POINTS_PER_CHUNK)):
            values = integrand(nodes, part)
            current, size = values @ weights, np.maximum(np.abs(values) @ weights, least[part])
            with np.errstate(invalid="ignore"):  # two infinite sums have no difference, which settles nothing
                change = np.abs(current - last[name][part]) / np.where(size > 0.0, size, 1.0)
            last[name][part] = current
            better = change <= moved[part]
            result[part] = np.where(better, current, result[part])
            moved[part] = np.where(better, change, moved[part])
        waiting = waiting[~(moved[waiting] <= np.maximum(TOLERANCE, floor[waiting]))]
        if not waiting.size:
            return result
    if np.any(moved[waiting] > np.maximum(LAST_TOLERANCE, floor[waiting])):
        raise NotConverged(
            f"The integral for the {what} still moves by {np.max(moved[waiting]):.1e} of its size at "
            f"{RULE_LADDER[-1][1]} points; the shape is not "
            "smooth between its stated kinks: state them, or give the shape as measured "
            "points."
        )
    return result
