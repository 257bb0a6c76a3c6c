"""A cluster of many machines, through dask.distributed: its workers solve the points of a sweep, or fit curves.

It needs the extra ``cluster`` (``pip install winkler[cluster]``) here, and the same software on the workers. The
points of a worker that dies are solved by the others, or by new ones.  When no worker is left, and none comes for a
while, the sweep is given up; dask would wait without end.
"""

from __future__ import annotations

import contextlib
import functools
import math
import time
from collections.abc import Callable, Collection, Iterator
from typing import Annotated, Any, NamedTuple

from winkler.io.software import differences, software
from winkler.values.checks.number_checks import Advice
from winkler.values.errors import InvalidInput, NotConverged
from winkler.values.value import value

SCHEDULER_TIMEOUT = 10.0
"""Time for which a scheduler is waited for [s]."""
POLL_INTERVAL = 1.0
"""Longest wait for results before the workers are counted [s]."""


ADDRESS_ADVICE = Advice("give that of a scheduler, such as 'tcp://host:8786'")


@value
class Cluster:
    """Address of the scheduler of a cluster.

    Parameters
    ----------
    address
        As ``tcp://host:8786``; ``dask scheduler`` prints it when it starts, or ``client.scheduler.address``.
    patience : float, optional
        Time without any worker after which a sweep is given up [s].
    """

    address: Annotated[str, ADDRESS_ADVICE]
    patience: float = 60.0

    def __post_init__(self) -> None:
        if not self.address.strip():
            raise InvalidInput(
                f"cluster: the address is {self.address!r}; give that of a scheduler, such as 'tcp://host:8786'."
            )
        if not 0.0 < self.patience < math.inf:
            raise InvalidInput(f"cluster: patience is {self.patience!r}; it must be a positive time in s.")


class Connection(NamedTuple):
    """Functions to work with a cluster.

    Parameters
    ----------
    submit
        Sends a task.
    threads
        Number of threads of all workers.
    ready
        Waits until some tasks are done, and returns them with their results.
    """

    submit: Callable[..., Any]
    threads: int
    ready: Callable[[Collection[Any]], list[tuple[Any, Any]]]


@contextlib.contextmanager
def connected(cluster: Cluster) -> Iterator[Connection]:
    """Connect to a cluster.

    Raises
    ------
    InvalidInput
        If dask.distributed is missing, there is no scheduler at the address, or its workers cannot be used.
    NotConverged
        If all workers or the scheduler die during the run.
    """
    from concurrent.futures import CancelledError

    try:
        from distributed import Client, KilledWorker
    except ImportError:
        raise InvalidInput(
            "cluster: this needs dask.distributed; install it with `pip install winkler[cluster]`."
        ) from None
    try:
        client = Client(cluster.address, timeout=SCHEDULER_TIMEOUT, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        why = " ".join(str(error).split()).rstrip(".")
        raise InvalidInput(
            f"cluster: nobody answers at '{cluster.address}' ({why}); give the address of a scheduler."
        ) from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise InvalidInput(
                f"cluster: '{cluster.address}' has no workers; start some with `dask worker {cluster.address}`."
            )
        _same_software(client)
        try:
            submit = functools.partial(client.submit, pure=False)
            yield Connection(submit, threads, functools.partial(_ready, client, cluster))
        except KilledWorker as error:
            raise NotConverged(
                f"cluster: workers of '{cluster.address}' died whenever they solved certain points (out of memory, or "
                f"stopped from outside: {' '.join(str(error).split())[:200]}); give them more memory and run again."
            ) from None
        except (CancelledError, OSError):
            raise NotConverged(
                f"cluster: the scheduler at '{cluster.address}' is gone; start it and its workers, and run again."
            ) from None


def _ready(client: Any, cluster: Cluster, waiting: Collection[Any]) -> list[tuple[Any, Any]]:
    """Return finished tasks and their results; give up when the cluster has been without a worker for too long."""
    from distributed import wait

    interval, without_worker_since = min(POLL_INTERVAL, 0.25 * cluster.patience), math.inf
    while True:
        finished = []
        with contextlib.suppress(TimeoutError), client.as_current():
            for future in wait(list(waiting), interval, return_when="FIRST_COMPLETED").done:
                finished.append((future, future.result(interval)))  # no result any more, if its worker has died
        if finished:
            return finished
        now = time.monotonic()
        without_worker_since = math.inf if client.nthreads() else min(without_worker_since, now)
        if now - without_worker_since >= cluster.patience:
            raise NotConverged(
                f"cluster: '{cluster.address}' has had no worker for {cluster.patience:g} s; start some with "
                f"`dask worker {cluster.address}` and run again."
            )


def _same_software(client: Any) -> None:
    for place, theirs in client.run(software, on_error="return").items():
        other = "no winkler, or an older one" if isinstance(theirs, Exception) else differences(theirs)
        if other:
            raise InvalidInput(f"cluster: the worker {place} has {other}; install there what is here.")
