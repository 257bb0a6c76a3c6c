"""Processes of this machine for a pool: one thread each, deaf to Ctrl-C, ended with the parent."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Collection, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import resource_tracker
from typing import Any

from winkler.io.processes.stopping import deferred_signals
from winkler.values.errors import InvalidInput, NotConverged

THREAD_VARIABLES = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "NUMBA_NUM_THREADS",
)
"""Environment variables that set the number of threads of libraries."""


@contextlib.contextmanager
def guarded(executor: Executor) -> Iterator[Callable[..., Future[Any]]]:
    """Provide a function that submits work to somebody's executor; what was not begun is withdrawn at the end."""
    sent: list[Future[Any]] = []

    def submit(*work: Any) -> Future[Any]:
        sent[:] = [future for future in sent if not future.done()]
        sent.append(executor.submit(*work))
        return sent[-1]

    try:
        yield submit
    except BrokenExecutor as error:
        why = " ".join(str(error).split()).rstrip(".")
        raise NotConverged(f"workers: the executor is broken ({why}); make a new one and run again.") from None
    finally:
        for future in sent:
            future.cancel()


@contextlib.contextmanager
def processes(count: int) -> Iterator[Callable[..., Future[Any]]]:
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


def ready(waiting: Collection[Future[Any]]) -> list[tuple[Future[Any], Any]]:
    """Wait for results, and return those that are there."""
    return [(future, future.result()) for future in wait(waiting, return_when=FIRST_COMPLETED).done]
