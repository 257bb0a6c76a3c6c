"""Parallel evaluation of many independent items in threads; the function must release the interpreter lock."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

LEAST_ITEMS_PER_THREAD = 256
"""Pieces that are not worth a thread of their own."""


def cores() -> int:
    """Return how many cores this process may use."""
    if sys.platform == "emscripten":
        return 1
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run_in_threads(work: Callable[[slice], None], count: int) -> None:
    """Do all pieces from 0 to `count`, a run of neighbours on each core.

    Parameters
    ----------
    work : callable
        Takes the slice of pieces it is to do; kernels are compiled by a first call with none.
    count : int
        How many there are.

    Examples
    --------
    >>> import numpy as np
    >>> squares = np.zeros(5)
    >>> def work(part):
    ...     squares[part] = np.arange(5.0)[part] ** 2
    >>> run_in_threads(work, 5)
    >>> squares
    array([ 0.,  1.,  4.,  9., 16.])
    """
    work(slice(0, 0))
    threads = min(cores(), max(count // LEAST_ITEMS_PER_THREAD, 1))
    if threads == 1:
        work(slice(0, count))
        return
    edges = [count * thread // threads for thread in range(threads + 1)]
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(work, [slice(*pair) for pair in zip(edges[:-1], edges[1:], strict=True)]))
