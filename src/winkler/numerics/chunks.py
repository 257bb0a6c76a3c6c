"""Large tables in parts: rows at once, and sums over waves at many places."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from winkler.numerics.types import Array

ENTRIES = 1_000_000


def chunks(rows: int, each: int, most: int = ENTRIES) -> Iterator[slice]:
    """Yield rows together, so many that of `each` numbers a row at most `most` are held at once."""
    step = max(1, most // max(each, 1))
    return (slice(start, start + step) for start in range(0, rows, step))


def wave_sums(function: Callable[[Array], Array], x: Array, k: Array, weights: Array) -> Array:
    """Return the sums of weights times a function of k x over all k, in the shape of x."""
    flat, found = np.ravel(x), np.empty(np.size(x))
    for part in chunks(flat.size, k.size):
        found[part] = function(np.outer(flat[part], k)) @ weights
    return found.reshape(np.shape(x))
