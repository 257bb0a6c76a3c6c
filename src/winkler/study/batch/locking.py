"""A file for one process alone: the system gives it back when the process ends, however it ends."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from winkler.study.batch.stopping import deferred_signals

__all__ = ["lock", "locked"]


def lock(file: int) -> bool:
    """Take an open file for this process alone.

    Parameters
    ----------
    file
        Its descriptor.

    Returns
    -------
    bool
        Whether it was taken; False where the system, or the disk, knows no locks.

    Raises
    ------
    BlockingIOError
        If another process has it.
    """
    try:
        import fcntl
    except ImportError:
        return _lock_on_windows(file)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise
    except OSError:  # a disk of another machine that offers none
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
    """Hold a lock by the name of a file, which exists no longer than the lock or the next run that asks for it.

    Parameters
    ----------
    path
        The file, in an existing folder.

    Yields
    ------
    bool
        Whether the lock is held; False where the system knows no locks.

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
            file, able = _opened(path)
        yield able
    finally:
        if file >= 0:
            with deferred_signals():
                _removed(path, file)


def _removed(path: Path, file: int) -> None:
    if os.name == "nt":  # an open file cannot be removed there
        os.close(file)
    with contextlib.suppress(OSError):
        path.unlink()
    if os.name != "nt":
        os.close(file)


def _opened(path: Path) -> tuple[int, bool]:
    while True:
        file = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        try:
            able = lock(file)
            if not able or os.path.samestat(os.fstat(file), os.stat(path)):
                return file, able
        except FileNotFoundError:  # its holder removed it in between
            pass
        except BaseException:
            os.close(file)
            raise
        os.close(file)
