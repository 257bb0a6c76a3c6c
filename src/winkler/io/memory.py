"""Limit of the memory that a library may use to read a file.

The address space of this process is limited while the library reads (setrlimit, RLIMIT_AS); allocations beyond the
limit fail, and the library raises `MemoryError`.  The limit is one of the process: while one thread reads,
all of them share it, and processes started meanwhile inherit it.  Only Linux states how much is in
use and enforces the limit; on other systems there is none.
"""

from __future__ import annotations

import contextlib
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

from winkler.io.foreign import path_text
from winkler.values.errors import InvalidInput
from winkler.values.limits import READING_BYTES

MEMORY_FILE = Path("/proc/self/statm")
"""Its first number is the size of the address space in pages (proc(5))."""


class _Limit:
    """The limit of this process, and how many readers share it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._readers, self._previous_limit, self._own_limit = 0, 0, 0

    def __enter__(self) -> None:
        with self._lock:
            if not self._readers:
                self._lower()
            self._readers += 1

    def __exit__(self, *_: object) -> None:
        with self._lock:
            self._readers -= 1
            if not self._readers:
                self._restore()

    def _lower(self) -> None:
        self._own_limit = 0
        if sys.platform != "linux":
            return
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        with contextlib.suppress(OSError, ValueError):
            address_limit = int(MEMORY_FILE.read_text().split()[0]) * resource.getpagesize() + READING_BYTES
            if soft == resource.RLIM_INFINITY or address_limit < soft:  # never above the limit in force
                resource.setrlimit(resource.RLIMIT_AS, (address_limit, hard))
                self._previous_limit, self._own_limit = soft, address_limit

    def _restore(self) -> None:
        if not self._own_limit:
            return
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        if soft == self._own_limit:  # else other code has set another limit
            resource.setrlimit(resource.RLIMIT_AS, (self._previous_limit, hard))


_LIMIT = _Limit()


@contextlib.contextmanager
def limited_memory(path: object) -> Iterator[None]:
    """Limit the memory allocated inside the block.

    Parameters
    ----------
    path : str or path
        The file that is read, for messages.

    Raises
    ------
    InvalidInput
        In place of `MemoryError`.
    """
    try:
        with _LIMIT:
            yield
    except MemoryError:
        raise InvalidInput(
            f"{path_text(path)}: to read it takes more memory than there is, or than the {READING_BYTES / 1e6:.0f} MB "
            "that a file may take; save a part of it."
        ) from None
