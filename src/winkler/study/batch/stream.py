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

__all__ = ["Batch"]

T = TypeVar("T")
R = TypeVar("R")


class Batch(ABC, Generic[T, R]):
    """What is computed, and the journal that keeps it.

    Parameters
    ----------
    todo : sequence
        The tasks.
    compute
        Takes a task, and as `watch` what sees its progress in this process; can be sent to others.
    journal
        Where results are written, and those of an earlier run are found.
    """

    tasks, done = "points", "solved"
    """What tasks are called in a sentence, and what is done with them."""

    def __init__(self, todo: Sequence[T], compute: Callable[..., Any], journal: Journal | None) -> None:
        self.todo, self.compute, self.journal = todo, compute, journal

    @abstractmethod
    def recalled(self) -> Iterable[tuple[int, R]]:
        """Return places of tasks whose result is known, and these."""

    @abstractmethod
    def without(self, done: Array) -> Sequence[T]:
        """Return the tasks at all places but those where `done` is true."""

    @abstractmethod
    def result(self, computed: Any) -> R:
        """Return the result of what was computed, which is written into the journal."""

    @abstractmethod
    def useful(self, result: R) -> bool:
        """Return whether anything was answered."""

    def results(self, *, workers: Workers = 1, watch: Any = None) -> Iterator[tuple[int, R]]:
        """Yield the place of every task and its result, first what is known, then others as they are computed.

        Parameters
        ----------
        workers
            Number of processes, a cluster, or the `Machine`; 1 computes in this one.
        watch
            Sees the progress of the tasks that this process computes.

        Raises
        ------
        NotConverged
            If workers died: how many results are kept.
        """
        checked_workers(workers)
        done, useful, journal = np.zeros(len(self.todo), dtype=bool), False, self.journal
        for place, result in self.recalled():
            done[place] = True
            useful = useful or self.useful(result)
            yield place, result
        places = np.flatnonzero(~done)
        for nth, computed in self._counted(_computed(self.compute, self.without(done), workers, watch)):
            look()  # a library may have made a failed one of it
            if _interrupted(computed) and journal is not None and journal.count:  # the run goes on from what is kept
                raise KeyboardInterrupt
            result = self.result(computed)
            useful = useful or self.useful(result)
            yield int(places[nth]), result
        if journal is not None and not useful:  # the study has to be changed
            journal.remove()

    def _counted(self, computed: Iterator[tuple[int, Any]]) -> Iterator[tuple[int, Any]]:
        """Yield what is computed; if nobody is left to do it, say how much is kept."""
        try:
            yield from computed
        except NotConverged as error:
            if self.journal is None:
                raise
            count = f"{self.journal.count} of {len(self.todo)} {self.tasks} are kept in '{self.journal.path}'"
            kept = f"{count}, and the same run goes on from there."
            nothing = f"No {self.tasks.removesuffix('s')} was {self.done}."
            raise NotConverged(f"{error} {kept if self.journal.count else nothing}") from None


def _interrupted(computed: Any) -> bool:
    return getattr(computed, "code", 0) == INTERRUPTED


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
