"""A batch, points of a sweep or curves of a fit, as a stream of what comes of its tasks.

Tasks are computed one after the other, in a pool of processes or on a cluster; the numbers are the same whoever
computes them.  With a journal, what comes of a task is written as soon as it is known, and what an earlier run has
written is not computed again.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, TypeVar

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.types import Array
from winkler.study.batch.cluster import Cluster
from winkler.study.batch.journal import Journal
from winkler.study.batch.pool import Machine, Workers, checked_workers, completed
from winkler.study.batch.stopping import INTERRUPTED, raise_pending

__all__ = ["results"]

T = TypeVar("T")
R = TypeVar("R")


def results(
    todo: Sequence[T],
    compute: Callable[..., Any],
    *,
    known: Iterable[tuple[int, R]],
    left: Callable[[Array], Sequence[T]],
    result: Callable[[Any], R],
    useful: Callable[[R], bool],
    journal: Journal | None,
    names: tuple[str, str],
    workers: Workers,
    watch: Any,
) -> Iterator[tuple[int, R]]:
    """Yield the place of every task and its result, first what is known, then others as they are computed.

    Parameters
    ----------
    todo
        The tasks.
    compute
        Takes a task, and as `watch` what sees its progress in this process; can be sent to others.
    known
        What an earlier run found.
    left
        Takes what is known of every place, and gives the other tasks.
    result
        Makes the result of what was computed, and writes it into the journal.
    useful
        Tells whether a result answers anything; if none does, the journal is removed, for the study has to be changed.
    journal
        Where results are written.
    names
        What many tasks are called, and what is done with one.
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
    done, answered = np.zeros(len(todo), dtype=bool), False
    for place, found in known:
        done[place] = True
        answered = answered or useful(found)
        yield place, found
    places = np.flatnonzero(~done)
    try:
        for nth, computed in _computed(compute, left(done), workers, watch):
            raise_pending()  # a library may have made a failed one of it
            if _interrupted(computed) and journal is not None and journal.count:  # the run goes on from what is kept
                raise KeyboardInterrupt
            found = result(computed)
            answered = answered or useful(found)
            yield int(places[nth]), found
    except NotConverged as error:
        if journal is None:
            raise
        kept = f"{journal.count} of {len(todo)} {names[0]} are kept in '{journal.path}', and the same run goes on"
        kept = f"{kept} from there." if journal.count else f"No {names[0].removesuffix('s')} was {names[1]}."
        raise NotConverged(f"{error} {kept}") from None
    if journal is not None and not answered:
        journal.remove()


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
