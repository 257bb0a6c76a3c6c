"""Element by element over large grids: by blocks of rows that stay in the cache, on all cores.

A pass over a grid that does not fit the cache costs the memory, and each array that it makes anew costs more; within a
block both are spared.  numpy lets other threads run meanwhile.  Arrays of other libraries are one block.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from winkler.numerics.arrays import dot

BLOCK_PIXELS = 2**16
"""Pixels of a block: a quarter of a MiB in single digits."""
LEAST_PIXELS = 2**18
"""Pixels below which a grid is one block."""


class RowBlocks:
    """The rows of a grid, in blocks.

    Parameters
    ----------
    like
        An array of two axes, of the library that is worked with.
    workers
        Threads.
    """

    def __init__(self, like: Any, workers: int) -> None:
        rows, columns = like.shape
        high = max(BLOCK_PIXELS // columns, 1)
        if not isinstance(like, np.ndarray) or rows * columns < LEAST_PIXELS:
            high = rows
        self.slices = [slice(start, min(start + high, rows)) for start in range(0, rows, high)]
        threads = min(workers, len(self.slices))
        self.pool = ThreadPoolExecutor(threads) if threads > 1 else None
        share = -(-len(self.slices) // threads)
        self.runs = [self.slices[start : start + share] for start in range(0, len(self.slices), share)]

    def each(self, work: Callable[[Any], Any]) -> list[Any]:
        """Do all blocks, and return what each gives, in their order."""
        if self.pool is None:
            return [work((part, ...)) for part in self.slices]
        done = list(self.pool.map(lambda run: [work((part, ...)) for part in run], self.runs))
        return [one for run in done for one in run]

    def total(self, work: Callable[[Any], tuple[float, ...]]) -> tuple[float, ...]:
        """Return the sums of the numbers that the blocks give."""
        return tuple(map(sum, zip(*self.each(work), strict=True)))

    def dot(self, one: Any, other: Any) -> float:
        """Return the sum of the products of two arrays."""
        return float(sum(self.each(lambda part: dot(one[part], other[part]))))
