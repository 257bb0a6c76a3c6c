"""A file that belongs to one process: the system gives it back when the process ends, however it ends."""

from __future__ import annotations

import os

__all__ = ["lock"]


def lock(file: int) -> None:
    """Take an open file for this process alone.

    Parameters
    ----------
    file
        Its descriptor; the lock ends when it is closed.

    Raises
    ------
    OSError
        If another process has it.
    """
    if os.name == "nt":
        import msvcrt

        os.lseek(file, 2**40, os.SEEK_SET)
        msvcrt.locking(file, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
        os.lseek(file, 0, os.SEEK_SET)
    else:
        import fcntl

        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
