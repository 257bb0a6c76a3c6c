"""A pool of processes of this machine, or a cluster: items are computed in parallel, results return as they are ready.

Items are sent in batches that last a fraction of a second each, so that short ones cost little communication and the
results of long ones return at once.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable, Collection, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import resource_tracker
from typing import Annotated, Any, TypeVar

from winkler.checks.number_checks import Number
from winkler.errors import InvalidInput, NotConverged
from winkler.study.batch.cluster import Cluster, connected
from winkler.study.batch.stopping import deferred_signals
from winkler.values import value

__all__ = ["Machine", "Workers", "checked_workers", "completed"]

T = TypeVar("T")
R = TypeVar("R")


@value
class Machine:
    """All processors of this machine, as soon as a task has lasted for a while.

    Parameters
    ----------
    patience : float, optional
        Time after which further processes are started [s]; starting them takes about as long.
    """

    patience: Annotated[float, Number("it must be zero or a positive time in s", 0.0)] = 1.0

    @property
    def processors(self) -> int:
        """Number of processors."""
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


Workers = int | Cluster | Machine
"""A number of processes of this machine, a cluster, or as many processors of this machine as are worth it."""

BATCH_SECONDS = 0.25
"""Intended duration of a batch [s]."""
BATCHES_PER_WORKER = 3
"""Batches in progress for every worker."""
MOST_ITEMS = 1024

THREAD_VARIABLES = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "NUMBA_NUM_THREADS",
)
"""Environment variables that set the number of threads of libraries."""


def checked_workers(workers: Workers) -> Workers:
    """Return `workers`, or refuse what is no whole number from 1 on, no cluster and not the machine."""
    if isinstance(workers, Cluster | Machine):
        return workers
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise InvalidInput(f"workers is {workers!r}; give a whole number from 1 on.")
    return workers


def completed(compute: Callable[[T], R], todo: Sequence[T], workers: int | Cluster) -> Iterator[tuple[int, R]]:
    """Yield the place of every item and ``compute(item)``, as they are ready.

    Parameters
    ----------
    compute
        Can be sent to other processes, like the items and what it returns.
    todo
        The items.
    workers
        Number of processes of this machine with one thread each; or a cluster.

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
    with _processes(min(workers, len(todo))) as submit:
        yield from _shared(compute, todo, submit, workers, _ready)


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


def _ready(waiting: Collection[Future[Any]]) -> list[tuple[Future[Any], Any]]:
    return [(future, future.result()) for future in wait(waiting, return_when=FIRST_COMPLETED).done]


def _computed(compute: Callable[[T], R], batch: list[T]) -> tuple[list[R], float]:
    started = time.perf_counter()
    return [compute(item) for item in batch], time.perf_counter() - started


# --------------------------------------------------------------------------------------------------- processes


@contextlib.contextmanager
def _processes(count: int) -> Iterator[Callable[..., Future[Any]]]:
    """Provide a function that submits work to processes of this machine; they end with the block."""
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        raise InvalidInput("workers: put the call of run(...) under `if __name__ == '__main__':`, as pools need it.")
    before = set(multiprocessing.active_children())
    mine = set(before)
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("spawn"), initializer=_ignore_interrupts)

    def submit(*work: Any) -> Future[Any]:
        if len(mine - before) == count:
            return pool.submit(*work)
        with _quiet_start():
            future: Future[Any] = pool.submit(*work)
            mine.update(multiprocessing.active_children())
        return future

    try:
        yield submit
        pool.shutdown()
    except BrokenProcessPool:
        raise NotConverged(
            "workers: a worker process ended before its time (out of memory, stopped from outside, or started by a "
            "script that does not call run under `if __name__ == '__main__':`); run again with one worker."
        ) from None
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in mine - before:
            process.terminate()


def _ignore_interrupts() -> None:
    """Ignore Ctrl-C, which the parent process handles, and end when the parent ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


@contextlib.contextmanager
def _quiet_start() -> Iterator[None]:
    """Start processes with one thread each that ignore Ctrl-C from the beginning; here it is received afterwards."""
    blocks = hasattr(signal, "pthread_sigmask")
    if blocks:
        resource_tracker.ensure_running()  # its start would reset the mask that the others are to inherit
    with deferred_signals():
        previous = {name: os.environ.get(name) for name in THREAD_VARIABLES}
        os.environ.update(dict.fromkeys(THREAD_VARIABLES, "1"))
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}) if blocks else set()
        try:
            yield
        finally:
            for name, content in previous.items():
                if content is None:
                    del os.environ[name]
                else:
                    os.environ[name] = content
            if blocks:
                signal.pthread_sigmask(signal.SIG_SETMASK, mask)
