"""How much memory a library may take to read a file, which it unpacks on its own and without end.

The space of addresses of this process is limited while the library reads (setrlimit, RLIMIT_AS); beyond it, what is
asked for is refused, and the library raises `MemoryError`.  The limit is one of the process: while one thread reads,
all of them share it, and processes that are started meanwhile inherit it.  Linux alone says how much is in use and
holds the limit; elsewhere there is none.
"""

from __future__ import annotations

import contextlib
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

from winkler.errors import InvalidInput
from winkler.io.foreign import shown
from winkler.limits import READING_BYTES

__all__ = ["limited_memory"]

IN_USE = Path("/proc/self/statm")
"""Begins with the pages of the space of addresses (proc(5))."""


class _Limit:
    """The limit of this process, and how many readers share it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._readers, self._before, self._set = 0, 0, 0

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
        self._set = 0
        if sys.platform != "linux":
            return
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        with contextlib.suppress(OSError, ValueError):
            most = int(IN_USE.read_text().split()[0]) * resource.getpagesize() + READING_BYTES
            if soft == resource.RLIM_INFINITY or most < soft:  # never above what is given
                resource.setrlimit(resource.RLIMIT_AS, (most, hard))
                self._before, self._set = soft, most

    def _restore(self) -> None:
        if not self._set:
            return
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        if soft == self._set:  # else somebody else has set another one
            resource.setrlimit(resource.RLIMIT_AS, (self._before, hard))


_LIMIT = _Limit()


@contextlib.contextmanager
def limited_memory(path: object) -> Iterator[None]:
    """Limit what is allocated inside.

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
            f"{shown(path)}: to read it takes more memory than there is, or than the {READING_BYTES / 1e6:.0f} MB that "
            "a file may take; save a part of it."
        ) from None
