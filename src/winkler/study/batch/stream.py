"""A batch, points of a sweep or curves of a fit, as a stream of what comes of its tasks.

Tasks are computed one after the other, in a pool of processes or on a cluster; the numbers are the same whoever
computes them.  With a journal, what comes of a task is written as soon as it is known, and what an earlier run has
written is not computed again.
"""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, Generic, TypeVar

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.types import Array
from winkler.study.batch.cluster import Cluster
from winkler.study.batch.journal import Journal
from winkler.study.batch.pool import Machine, Workers, checked_workers, completed
from winkler.study.batch.stopping import INTERRUPTED, look

__all__ = ["Batch", "results"]

T = TypeVar("T")
R = TypeVar("R")


class Batch(ABC, Generic[T, R]):
    """What is computed, and what a journal keeps of it.

    Parameters
    ----------
    todo : sequence
        The tasks.
    compute
        Takes a task, and as `watch` what sees its progress in this process; can be sent to others.
    """

    kept = "points are kept"
    """What the tasks are called in a sentence."""
    none = "No point was solved."

    def __init__(self, todo: Sequence[T], compute: Callable[..., Any]) -> None:
        self.todo = todo
        self.compute = compute

    @abstractmethod
    def known(self, journal: Journal | None) -> Iterable[tuple[int, R]]:
        """Return what an earlier run found: places of tasks, and what came of them."""

    @abstractmethod
    def without(self, done: Array) -> Sequence[T]:
        """Return the tasks at all places but those where `done` is true."""

    @abstractmethod
    def written(self, computed: Any, journal: Journal | None) -> R:
        """Return what comes of a task from what was computed, and write it into the journal."""

    @abstractmethod
    def useful(self, result: R) -> bool:
        """Return whether anything was answered."""


def results(
    batch: Batch[T, R], *, workers: Workers = 1, watch: Any = None, journal: Journal | None = None
) -> Iterator[tuple[int, R]]:
    """Yield the place of every task and what comes of it, first what is known, then others as they are computed.

    Parameters
    ----------
    batch
        What to compute.
    workers
        Number of processes, a cluster, or the `Machine`; 1 computes in this one.
    watch
        Sees the progress of the tasks that this process computes.
    journal
        Where results are written; it is removed if there is no useful one, for then the study has to be changed.

    Raises
    ------
    InvalidInput
        If the journal does not fit the study.
    NotConverged
        If workers died: how many results are kept.
    """
    checked_workers(workers)
    done, useful = np.zeros(len(batch.todo), dtype=bool), False
    for place, result in batch.known(journal):
        done[place] = True
        useful = useful or batch.useful(result)
        yield place, result
    places = np.flatnonzero(~done)
    computed = _computed(batch.compute, batch.without(done), workers, watch)
    for nth, content in _counted(computed, batch, journal):
        look()  # a library may have made a failed one of it
        if _interrupted(content) and journal is not None and journal.count:  # the run goes on from what is kept
            raise KeyboardInterrupt
        result = batch.written(content, journal)
        useful = useful or batch.useful(result)
        yield int(places[nth]), result
    if journal is not None and not useful:
        journal.remove()


def _interrupted(content: Any) -> bool:
    return getattr(content, "code", 0) == INTERRUPTED


def _counted(
    computed: Iterator[tuple[int, Any]], batch: Batch[T, R], journal: Journal | None
) -> Iterator[tuple[int, Any]]:
    """Yield what is computed; if nobody is left to do it, say how much is kept."""
    try:
        yield from computed
    except NotConverged as error:
        if journal is None:
            raise
        count = f"{journal.count} of {len(batch.todo)} {batch.kept}"
        kept = f"{count} in '{journal.path}', and the same run goes on from there."
        raise NotConverged(f"{error} {kept if journal.count else batch.none}") from None


def _computed(
    compute: Callable[..., Any], todo: Sequence[T], workers: Workers, watch: Any
) -> Iterator[tuple[int, Any]]:
    """Yield places among the tasks and what was computed of them, as they are ready."""
    if isinstance(workers, Cluster) or (isinstance(workers, int) and workers > 1 < len(todo)):
        yield from completed(compute, todo, workers)
        return
    others, patience = (workers.processors, workers.patience) if isinstance(workers, Machine) else (1, 0.0)
    started = time.monotonic()
    for place, task in enumerate(todo):
        content = compute(task, watch=watch)
        yield place, content
        if _interrupted(content):
            return
        rest = place + 1
        if others > 1 < len(todo) - rest and time.monotonic() - started > patience:
            yield from ((rest + later, other) for later, other in completed(compute, todo[rest:], others))
            return
