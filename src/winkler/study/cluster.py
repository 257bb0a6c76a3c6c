"""A cluster of many machines, through dask.distributed: the points of a sweep are solved by its workers.

It needs the extra ``cluster`` (``pip install winkler[cluster]``) here, and the same version of winkler on the workers.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from concurrent.futures import Executor
from importlib.metadata import version
from typing import Any

from winkler.errors import InvalidInput
from winkler.values import value

__all__ = ["Cluster", "connected"]

PATIENCE = 10.0
"""How long a scheduler is waited for [s]."""


@value
class Cluster:
    """Where the scheduler of a cluster listens.

    Parameters
    ----------
    address
        As ``tcp://host:8786``; what ``dask scheduler`` says when it starts, or ``client.scheduler.address``.
    """

    address: str

    def __post_init__(self) -> None:
        if not isinstance(self.address, str) or not self.address.strip():
            raise InvalidInput(
                f"cluster: the address is {self.address!r}; give that of a scheduler, such as 'tcp://host:8786'."
            )


@contextlib.contextmanager
def connected(cluster: Cluster) -> Iterator[tuple[Executor, int]]:
    """Give what sends work to the cluster, and how many threads its workers have.

    Raises
    ------
    InvalidInput
        If dask.distributed is missing, nobody answers at the address, or the workers are of no use.
    """
    try:
        from distributed import Client
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
        executor = client.get_executor(pure=False)
        try:
            yield executor, threads
        finally:
            executor.shutdown(wait=False)  # what is still under way is given up


def _same_version(client: Any) -> None:
    here = version("winkler")
    for place, told in client.run(_version, on_error="return").items():
        if told != here:
            has = f"winkler {told}" if isinstance(told, str) else "no winkler"
            raise InvalidInput(f"cluster: the worker {place} has {has}, here is {here}; install this version there.")


def _version() -> str:
    return version("winkler")
