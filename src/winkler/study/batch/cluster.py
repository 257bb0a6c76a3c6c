"""A cluster of many machines, through dask.distributed: the points of a sweep are solved by its workers.

It needs the extra ``cluster`` (``pip install winkler[cluster]``) here, and the same version of winkler on the workers.
A worker that dies costs nothing: its points are solved by the others, or by those that come.  When none is left, and
none comes for a while, the sweep is given up; dask would wait for ever.
"""

from __future__ import annotations

import contextlib
import functools
import math
import time
from collections.abc import Callable, Collection, Iterator
from concurrent.futures import CancelledError
from importlib.metadata import version
from typing import Annotated, Any, NamedTuple

from winkler.checks.number_checks import Advice
from winkler.errors import InvalidInput, NotConverged
from winkler.values import value

__all__ = ["Cluster", "Connection", "connected"]

PATIENCE = 10.0
"""How long a scheduler is waited for [s]."""
BEAT = 1.0
"""How long answers are waited for before the workers are counted [s], at most."""


SCHEDULER = Advice("give that of a scheduler, such as 'tcp://host:8786'")


@value
class Cluster:
    """Where the scheduler of a cluster listens.

    Parameters
    ----------
    address
        As ``tcp://host:8786``; what ``dask scheduler`` says when it starts, or ``client.scheduler.address``.
    patience : float, optional
        How long it may be without any worker before a sweep is given up [s].
    """

    address: Annotated[str, SCHEDULER]
    patience: float = 60.0

    def __post_init__(self) -> None:
        if not self.address.strip():
            raise InvalidInput(
                f"cluster: the address is {self.address!r}; give that of a scheduler, such as 'tcp://host:8786'."
            )
        if not 0.0 < self.patience < math.inf:
            raise InvalidInput(f"cluster: patience is {self.patience!r}; it must be a positive time in s.")


class Connection(NamedTuple):
    """What a cluster is worked with.

    Parameters
    ----------
    submit
        Sends work.
    threads
        How many the workers have.
    ready
        Waits until there are answers to some of what was sent, and returns these with them.
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
        If dask.distributed is missing, nobody answers at the address, or the workers are of no use.
    NotConverged
        If all workers or the scheduler die during the run.
    """
    try:
        from distributed import Client, KilledWorker
    except ImportError:
        raise InvalidInput(
            "cluster: this needs dask.distributed; install it with `pip install winkler[cluster]`."
        ) from None
    try:
        client = Client(cluster.address, timeout=PATIENCE, set_as_default=False)
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
        _same_version(client)
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
    """Return what has an answer, and the answers; give up when the cluster has been without a worker for too long."""
    from distributed import wait

    beat, alone = min(BEAT, 0.25 * cluster.patience), math.inf
    while True:
        found = []
        with contextlib.suppress(TimeoutError), client.as_current():
            for future in wait(list(waiting), beat, return_when="FIRST_COMPLETED").done:
                found.append((future, future.result(beat)))  # no answer any more, if its worker died with it
        if found:
            return found
        now = time.monotonic()
        alone = math.inf if client.nthreads() else min(alone, now)
        if now - alone >= cluster.patience:
            raise NotConverged(
                f"cluster: '{cluster.address}' has had no worker for {cluster.patience:g} s; start some with "
                f"`dask worker {cluster.address}` and run again."
            )


def _same_version(client: Any) -> None:
    here = version("winkler")
    for place, told in client.run(_version, on_error="return").items():
        if told != here:
            has = f"winkler {told}" if isinstance(told, str) else "no winkler"
            raise InvalidInput(f"cluster: the worker {place} has {has}, here is {here}; install this version there.")


def _version() -> str:
    return version("winkler")
