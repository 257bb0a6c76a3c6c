"""Rules of quadrature for many points at once, grouped so that those with the same rule are summed together."""

from __future__ import annotations

import functools
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

__all__ = ["PAIRS_PER_CHUNK", "POINTS_PER_BLOCK", "Indices", "point_groups"]

Indices = NDArray[np.intp]

POINTS_PER_BLOCK = 20_000
"""Largest number of points at once."""
PAIRS_PER_CHUNK = 1 << 16
"""Largest number of (point, node) pairs at once: the temporary arrays stay in the cache."""


def point_groups(chosen: Indices, parts: Indices, count: Indices) -> Iterator[tuple[Indices, Array, Array]]:
    """Yield points with the same rule, and its nodes and weights, in pieces of at most `PAIRS_PER_CHUNK` pairs."""
    for some, many in np.unique(np.stack([parts[chosen], count[chosen]]), axis=1).T:
        members = chosen[(parts[chosen] == some) & (count[chosen] == many)]
        nodes, weights = _rule(int(some), int(many))
        for start in range(0, members.size, step := max(PAIRS_PER_CHUNK // nodes.size, 1)):
            yield members[start : start + step, None], nodes, weights


@functools.lru_cache(maxsize=256)
def _rule(parts: int, count: int) -> tuple[Array, Array]:
    """Return the Gauss-Legendre rule of `count` nodes on each of equal `parts` of [0, 1]."""
    nodes, weights = gauss_legendre(count)
    return (np.arange(parts)[:, None] + nodes).ravel() / parts, np.tile(weights, parts) / parts
