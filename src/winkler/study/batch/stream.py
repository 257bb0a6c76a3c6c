"""A batch, points of a sweep or curves of a fit, as a stream of the results of its tasks.

Tasks are computed one after the other, in a pool of processes or on a cluster; the numbers do not
depend on which.  With a journal, each result is recorded at once, and what an earlier run has recorded is not computed
again.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from typing import Any, TypeVar

import numpy as np

from winkler.io.processes.stopping import INTERRUPTED, raise_pending
from winkler.numerics.types import Array
from winkler.study.batch.cluster import Cluster
from winkler.study.batch.journal import Journal
from winkler.study.batch.pool import Machine, Workers, checked_workers, completed
from winkler.values.errors import NotConverged

T = TypeVar("T")
R = TypeVar("R")


def results(
    todo: Sequence[T],
    compute: Callable[..., Any],
    *,
    earlier: Iterable[tuple[int, R]],
    left: Callable[[Array], Sequence[T]],
    result: Callable[[Any], R],
    useful: Callable[[R], bool],
    journal: Journal | None,
    names: tuple[str, str],
    workers: Workers,
    watch: Any,
    others: Array | None = None,
) -> Iterator[tuple[int, R]]:
    """Yield the place of every task and its result, first those of an earlier run, then others as they are computed.

    Parameters
    ----------
    todo
        The tasks.
    compute
        Function of a task, and of `watch`, which passes on its progress in this process; can be sent to others.
    known
        Results of an earlier run.
    left
        Function of a mask of the tasks that are done; returns the others.
    result
        Function that returns the result of what was computed, and writes it into the journal.
    useful
        Function that returns whether a result has numbers; if none has, the journal is removed.
    journal
        Journal of the results.
    names
        Plural name of the tasks, and the participle of what is done with one.
    workers
        Number of processes, a cluster, an executor, or the `Machine`; 1 computes in this one.
    watch
        Passes on the progress of the tasks that this process computes.
    others : ndarray of bool, (n,), optional
        Which tasks are left to others.

    Raises
    ------
    NotConverged
        If workers died: how many results are kept.
    """
    checked_workers(workers)
    done, any_useful = np.zeros(len(todo), dtype=bool) if others is None else others.copy(), False
    for place, recorded in earlier:
        done[place] = True
        any_useful = any_useful or useful(recorded)
        yield place, recorded
    places = np.flatnonzero(~done)
    try:
        for nth, computed in _computed(compute, left(done), workers, watch):
            raise_pending()  # a library may have turned a signal into a failed one
            if _interrupted(computed) and journal is not None and journal.count:  # the run can be continued
                raise KeyboardInterrupt
            computed_result = result(computed)
            any_useful = any_useful or useful(computed_result)
            yield int(places[nth]), computed_result
    except NotConverged as error:
        if journal is None:
            raise
        kept_text = f"{journal.count} of {len(todo)} {names[0]} are kept in '{journal.path}', and the same run goes on"
        kept_text = f"{kept_text} from there." if journal.count else f"No {names[0].removesuffix('s')} was {names[1]}."
        raise NotConverged(f"{error} {kept_text}") from None
    if journal is not None and not any_useful:
        journal.remove()


def _interrupted(computed: Any) -> bool:
    return getattr(computed, "code", 0) == INTERRUPTED


def _computed(
    compute: Callable[..., Any], todo: Sequence[T], workers: Workers, watch: Any
) -> Iterator[tuple[int, Any]]:
    """Yield places among the tasks and what was computed of them, as they are ready."""
    if isinstance(workers, Cluster | Executor) or (isinstance(workers, int) and workers > 1 < len(todo)):
        yield from completed(compute, todo, workers)
        return
    others, patience = (workers.processors, workers.patience) if isinstance(workers, Machine) else (1, 0.0)
    spent = 0.0
    for place, task in enumerate(todo):
        began, used = time.monotonic(), time.process_time()
        content = compute(task, watch=watch)
        # neither what other programs take of a busy machine, nor what several threads take at once
        spent += min(time.monotonic() - began, time.process_time() - used)
        yield place, content
        if _interrupted(content):
            return
        rest = place + 1
        left = len(todo) - rest
        if others > 1 < left and left * (spent - patience) > patience * rest:  # first seconds are spent on loading
            yield from ((rest + later, other) for later, other in completed(compute, todo[rest:], others))
            return
