"""A pool of processes of this machine, or a cluster: items are computed in parallel, results return as they are ready.

Items are sent in batches that last a fraction of a second each, so that short ones cost little communication and the
results of long ones return at once.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import Executor
from typing import Annotated, Any, TypeVar

from winkler.study.batch.cluster import Cluster, connected
from winkler.values.checks.number_checks import Number
from winkler.values.errors import InvalidInput
from winkler.values.value import value

T = TypeVar("T")
R = TypeVar("R")


@value
class Machine:
    """All processors of this machine, as soon as tasks have taken a while, and those that are left will, too.

    Parameters
    ----------
    patience : float, optional
        Time after which further processes are started, if what is left takes as long [s]; starting them does. Time that
        other programs take of a busy machine does not count.
    """

    patience: Annotated[float, Number("it must be zero or a positive time in s", 0.0)] = 1.0

    @property
    def processors(self) -> int:
        """Number of processors."""
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


Workers = int | Cluster | Machine | Executor
"""A number of processes of this machine, a cluster, as many processors as are worth it, or somebody's executor."""

BATCH_SECONDS = 0.25
"""Intended duration of a batch [s]."""
BATCHES_PER_WORKER = 3
"""Batches in progress for every worker."""
MOST_ITEMS = 1024


def checked_workers(workers: Workers) -> Workers:
    """Return `workers`, or refuse what is no whole number from 1 on, no cluster, not the machine and no executor."""
    if isinstance(workers, Cluster | Machine):
        return workers
    if isinstance(workers, Executor):
        from concurrent.futures import ThreadPoolExecutor

        if isinstance(workers, ThreadPoolExecutor):
            raise InvalidInput(
                "workers: an executor of threads computes no faster than one; give one of processes, such as "
                "concurrent.futures.ProcessPoolExecutor(4)."
            )
        return workers
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise InvalidInput(f"workers is {workers!r}; give a whole number from 1 on.")
    return workers


def completed(
    compute: Callable[[T], R], todo: Sequence[T], workers: int | Cluster | Executor
) -> Iterator[tuple[int, R]]:
    """Yield the place of every item and ``compute(item)``, as they are ready.

    Parameters
    ----------
    compute
        Can be sent to other processes, like the items and what it returns.
    todo
        The items.
    workers
        Number of processes of this machine with one thread each; a cluster; or an executor, which stays open.

    Raises
    ------
    InvalidInput
        If this is called in a worker of another pool, or the cluster cannot be used.
    NotConverged
        If a worker ends early, or the last one of a cluster and no other comes.
    """
    if isinstance(workers, Cluster):
        with connected(workers) as cluster:
            yield from _shared(compute, todo, cluster.submit, cluster.threads, cluster.ready)
        return
    from winkler.study.batch.processes import guarded, processes, ready  # with what starts processes, unused by one

    if isinstance(workers, Executor):
        with guarded(workers) as submit:
            yield from _shared(compute, todo, submit, Machine().processors, ready)
        return
    with processes(min(workers, len(todo))) as submit:
        yield from _shared(compute, todo, submit, workers, ready)


def _shared(
    compute: Callable[[T], R],
    todo: Sequence[T],
    submit: Callable[..., Any],
    workers: int,
    ready: Callable[[Collection[Any]], list[tuple[Any, Any]]],
) -> Iterator[tuple[int, R]]:
    """Distribute items; `ready` waits for results of submitted batches."""
    waiting: dict[Any, int] = {}
    sent, size = 0, 1
    while sent < len(todo) or waiting:
        while sent < len(todo) and len(waiting) < BATCHES_PER_WORKER * workers:
            batch = list(todo[sent : sent + size])
            waiting[submit(_computed, compute, batch)] = sent
            sent += len(batch)
        for future, (computed, seconds) in ready(waiting):
            first = waiting.pop(future)
            yield from enumerate(computed, first)
            # the rest is distributed in ever smaller batches, so that all workers end together
            fair = max(1, (len(todo) - sent) // (2 * BATCHES_PER_WORKER * workers))
            size = max(1, min(MOST_ITEMS, fair, round(BATCH_SECONDS * len(computed) / max(seconds, 1e-9)), 8 * size))


def _computed(compute: Callable[[T], R], batch: list[T]) -> tuple[list[R], float]:
    started = time.perf_counter()
    return [compute(item) for item in batch], time.perf_counter() - started
