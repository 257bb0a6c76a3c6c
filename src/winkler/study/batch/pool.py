"""Many questions shared by processes of this machine, or by a cluster: answers come back as they are ready.

Questions go out in batches that last a fraction of a second each, whatever one of them takes, so that short ones cost
little on the way and long ones are known as soon as they are answered.
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
        For how long one process is at it alone [s]; starting others takes about as long.
    """

    patience: Annotated[float, Number("it must be zero or a positive time in s", 0.0)] = 1.0

    @property
    def processors(self) -> int:
        """How many there are."""
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


Workers = int | Cluster | Machine
"""Who answers: so many processes of this machine, a cluster, or as much of this machine as is worth it."""

SPELL = 0.25
"""How long a batch is to last [s]."""
AHEAD = 3
"""Batches that are under way for every worker."""
LARGEST = 1024

ONE_THREAD = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "NUMBA_NUM_THREADS",
)
"""What libraries read how many threads they may start from."""


def checked_workers(workers: Workers) -> Workers:
    """Return `workers`, or refuse what is no whole number from 1 on, no cluster and not the machine."""
    if isinstance(workers, Cluster | Machine):
        return workers
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise InvalidInput(f"workers is {workers!r}; give a whole number from 1 on.")
    return workers


def completed(answer: Callable[[T], R], todo: Sequence[T], workers: int | Cluster) -> Iterator[tuple[int, R]]:
    """Yield the place of every item and ``answer(item)``, as they are ready.

    Parameters
    ----------
    answer
        Can be sent to other processes, like the items and what it returns.
    todo
        The items.
    workers
        So many processes of this machine with one thread each; or a cluster.

    Raises
    ------
    InvalidInput
        If a worker of another pool asks, or the cluster cannot be used.
    NotConverged
        If a worker ends before its time, or the last one of a cluster and no other comes.
    """
    if isinstance(workers, Cluster):
        with connected(workers) as cluster:
            yield from _shared(answer, todo, cluster.submit, cluster.threads, cluster.ready)
        return
    with _processes(min(workers, len(todo))) as submit:
        yield from _shared(answer, todo, submit, workers, _ready)


def _shared(
    answer: Callable[[T], R],
    todo: Sequence[T],
    submit: Callable[..., Any],
    workers: int,
    ready: Callable[[Collection[Any]], list[tuple[Any, Any]]],
) -> Iterator[tuple[int, R]]:
    """Share items out; `ready` waits for answers to what was submitted."""
    waiting: dict[Any, int] = {}
    sent, size = 0, 1
    while sent < len(todo) or waiting:
        while sent < len(todo) and len(waiting) < AHEAD * workers:
            batch = list(todo[sent : sent + size])
            waiting[submit(_answered, answer, batch)] = sent
            sent += len(batch)
        for future, (found, seconds) in ready(waiting):
            first = waiting.pop(future)
            yield from enumerate(found, first)
            # what is left is shared out in ever smaller batches, so that all workers end together
            fair = max(1, (len(todo) - sent) // (2 * AHEAD * workers))
            size = max(1, min(LARGEST, fair, round(SPELL * len(found) / max(seconds, 1e-9)), 8 * size))


def _ready(waiting: Collection[Future[Any]]) -> list[tuple[Future[Any], Any]]:
    return [(future, future.result()) for future in wait(waiting, return_when=FIRST_COMPLETED).done]


def _answered(answer: Callable[[T], R], batch: list[T]) -> tuple[list[R], float]:
    started = time.perf_counter()
    return [answer(item) for item in batch], time.perf_counter() - started


# --------------------------------------------------------------------------------------------------- processes


@contextlib.contextmanager
def _processes(count: int) -> Iterator[Callable[..., Future[Any]]]:
    """Give what sends work to processes of this machine; they end with the block."""
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        raise InvalidInput("workers: put the call of run(...) under `if __name__ == '__main__':`, as pools need it.")
    before = set(multiprocessing.active_children())
    mine = set(before)
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("spawn"), initializer=_left_alone)

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


def _left_alone() -> None:
    """Leave Ctrl-C to the process that started the workers, and end when it ends, however that happens."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


@contextlib.contextmanager
def _quiet_start() -> Iterator[None]:
    """Start processes with one thread each, and deaf to Ctrl-C from their first moment on; here it comes afterwards."""
    blocks = hasattr(signal, "pthread_sigmask")
    if blocks:
        resource_tracker.ensure_running()  # as it starts, it would open the mask that the others are to inherit
    with deferred_signals():
        kept = {name: os.environ.get(name) for name in ONE_THREAD}
        os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}) if blocks else set()
        try:
            yield
        finally:
            for name, content in kept.items():
                if content is None:
                    del os.environ[name]
                else:
                    os.environ[name] = content
            if blocks:
                signal.pthread_sigmask(signal.SIG_SETMASK, mask)
