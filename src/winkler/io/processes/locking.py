"""Locks of files: held by one process, and released by the system when the process ends, however it ends."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from winkler.io.processes.stopping import deferred_signals


def lock(file: int) -> bool:
    """Lock an open file for this process.

    Parameters
    ----------
    file
        Its descriptor.

    Returns
    -------
    bool
        Whether it was locked; False where the system, or the disk, has no locks.

    Raises
    ------
    BlockingIOError
        If another process holds the lock.
    """
    try:
        import fcntl
    except ImportError:
        return _lock_on_windows(file)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise
    except OSError:  # a network disk without locks
        return False
    return True


def _lock_on_windows(file: int) -> bool:
    try:
        import msvcrt
    except ImportError:  # in a browser
        return False
    os.lseek(file, 2**40, os.SEEK_SET)
    try:
        msvcrt.locking(file, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
    except OSError:
        raise BlockingIOError from None
    finally:
        os.lseek(file, 0, os.SEEK_SET)
    return True


@contextlib.contextmanager
def locked(path: Path) -> Iterator[bool]:
    """Hold the lock of a file, which is removed with the lock.

    Parameters
    ----------
    path
        The file, in an existing folder.

    Yields
    ------
    bool
        Whether the lock is held; False where the system has no locks.

    Raises
    ------
    BlockingIOError
        If another process holds it.
    OSError
        If the file cannot be made.
    """
    file = -1
    try:
        with deferred_signals():
            file, has_lock = open_locked(path)
        yield has_lock
    finally:
        if file >= 0:
            with deferred_signals():
                _remove(path, file)


def _remove(path: Path, file: int) -> None:
    if os.name == "nt":  # an open file cannot be removed there
        os.close(file)
    with contextlib.suppress(OSError):
        path.unlink()
    if os.name != "nt":
        os.close(file)


def open_locked(path: Path) -> tuple[int, bool]:
    """Open a file, made if it is missing, and lock it; return its descriptor, and whether it is locked.

    Raises
    ------
    BlockingIOError
        If another process holds its lock.
    OSError
        If it cannot be made.
    """
    while True:
        file = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_BINARY", 0), 0o666)
        try:
            has_lock = lock(file)
            if not has_lock or os.path.samestat(os.fstat(file), os.stat(path)):
                return file, has_lock
        except FileNotFoundError:  # the process that held it removed it in between
            pass
        except BaseException:
            os.close(file)
            raise
        os.close(file)
