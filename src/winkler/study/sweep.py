"""The points of a study, solved one after the other or in a pool of processes, as a stream.

The points come out in the order of the sweep, and with the same numbers, however many workers solve them.
"""

from __future__ import annotations

import contextlib
import functools
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import Any, TypeVar

import numpy as np

from winkler.errors import InvalidInput, NotConverged, WinklerError
from winkler.fields import restore
from winkler.study import keys
from winkler.study.keeping import Keep
from winkler.study.marching import ANEW, INTERRUPTED, MARCHES, March, Watch, marched, unwatched
from winkler.study.outcome import Failed, Solved, answers_of
from winkler.study.study import Fields, Study
from winkler.values import value

__all__ = ["Task", "pooled", "solve_points", "tasks"]

T = TypeVar("T")
R = TypeVar("R")

ONE_THREAD = (
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
    "NUMEXPR_NUM_THREADS",
    "NUMBA_NUM_THREADS",
)
"""What libraries read how many threads they may start from."""


@value
class Task:
    """One point of a sweep, ready to be solved."""

    index: tuple[int, ...]
    settings: tuple[Any, ...]
    problem: Any
    fields: Fields


def tasks(study: Study) -> list[Task]:
    """Return every point of a study, in the order of its sweep.

    Raises
    ------
    InvalidInput
        If a point cannot be asked: the key, the value, and why.
    """
    points = []
    for index, settings in study.settings():
        problem = study.problem
        for axis, content in zip(study.sweep, settings, strict=True):
            try:
                problem = keys.replaced(problem, axis.key.partition(".")[2], content)
            except WinklerError as error:
                raise type(error)(f"sweep: at {axis.key} = {keys.label(content)}: {error}") from None
        points.append(Task(index, settings, problem, study.fields))
    return points


def solved(task: Task, watch: Watch = unwatched, keep: Keep = ANEW) -> Solved | Failed:
    """Solve one point; an error of the physics becomes a `Failed`, any other one is a mistake of ours and is raised."""
    index, settings, problem, fields = task.index, task.settings, task.problem, task.fields
    try:
        march = marched(problem, watch, keep) if type(problem) in MARCHES else March(problem.solve())
        solution = march.solution
        found = tuple(answers_of(solution).items())
        point = Solved(index, settings, problem, solution, found)
        surface, below = [], []
        for contact in point.each if fields.r.values.size else ():
            if not hasattr(contact, "pressed"):
                raise InvalidInput(
                    f"fields: the answer to {type(problem).__name__} has no fields to restore; remove [fields]."
                )
            radius = float(contact.radius)
            r, z = fields.r.within(radius), fields.z.within(radius)
            surface.append(restore(contact, r))
            if z.size:
                below.append(restore(contact, r[:, np.newaxis], z[np.newaxis, :]))
        return Solved(
            index, settings, problem, solution, found, tuple(surface), tuple(below), march.stopped, march.code
        )
    except WinklerError as error:
        return Failed(index, settings, problem, str(error), error.exit_code)


def solve_points(
    study: Study, *, workers: int = 1, watch: Watch = unwatched, keep: Keep = ANEW
) -> Iterator[Solved | Failed]:
    """Yield the points of a study as they are solved, in the order of its sweep.

    Parameters
    ----------
    study
        What to solve.
    workers
        Number of processes; 1 solves in this one.
    watch
        Sees the states of a march along a path, if this process solves it; what was reached when it is interrupted is
        the last point.
    keep
        Where long marches keep what they have reached, to go on from there if they are killed.

    Raises
    ------
    InvalidInput
        Before the first point, if one of them cannot be asked.
    """
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise InvalidInput(f"workers is {workers!r}; give a whole number from 1 on.")
    todo = tasks(study)
    if workers == 1 or len(todo) == 1:
        for task in todo:
            point = solved(task, watch, keep)
            yield point
            if point.code == INTERRUPTED:
                return
        return
    yield from pooled(functools.partial(solved, keep=keep), todo, min(workers, len(todo)))


def pooled(answer: Callable[[T], R], todo: list[T], workers: int) -> Iterator[R]:
    """Yield ``answer(item)`` of every item, in their order, from so many processes with one thread each.

    Raises
    ------
    InvalidInput
        If a worker of another pool asks.
    NotConverged
        If a worker ends before its time.
    """
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        raise InvalidInput("workers: put the call of run(...) under `if __name__ == '__main__':`, as pools need it.")
    before = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(workers, multiprocessing.get_context("spawn"), initializer=_left_alone)
    chunk = max(1, min(32, len(todo) // (8 * workers)))
    mine = set(before)
    try:
        with _quiet_start():
            answers = pool.map(answer, todo, chunksize=chunk)
            mine = set(multiprocessing.active_children()) - before
        yield from answers
        pool.shutdown()
    except BrokenProcessPool:
        raise NotConverged(
            "workers: a worker process ended before its time (out of memory, stopped from outside, or started by a "
            "script that does not call run under `if __name__ == '__main__':`); run again with workers=1."
        ) from None
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in mine - before:
            process.terminate()


def _left_alone() -> None:
    """Leave Ctrl-C to the process that started the workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextlib.contextmanager
def _quiet_start() -> Iterator[None]:
    """Start processes with one thread each, and deaf to Ctrl-C from their first moment on."""
    kept = {name: os.environ.get(name) for name in ONE_THREAD}
    os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
    main = threading.current_thread() is threading.main_thread()
    handler = signal.signal(signal.SIGINT, signal.SIG_IGN) if main else None
    try:
        yield
    finally:
        if main:
            signal.signal(signal.SIGINT, handler)
        for name, content in kept.items():
            if content is None:
                del os.environ[name]
            else:
                os.environ[name] = content
