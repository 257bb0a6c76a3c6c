"""Folders of compiled kernels and of the list of fonts between runs, also for users whose own folders are read-only.

numba keeps kernels beside the package or in the home of the user, matplotlib its list of fonts there.  In a container
often neither can be written, or there is no home at all; then numba refuses to work, and matplotlib warns.  There they
get a folder among the temporary files: new, with a name that nobody can guess, open to this user alone, since what
numba reads from it is run.  It is removed when the process ends; one that a killed process left, by the next process
that needs one.  Where there is no such place either, kernels are compiled anew and kept nowhere.
"""

from __future__ import annotations

import atexit
import contextlib
import functools
import os
import shutil
import stat
import tempfile
from pathlib import Path

from winkler.values.errors import InvalidInput

FOLDER_PREFIX = "winkler-cache-"


def with_kernels(source: Path) -> bool:
    """See to it that numba has a place for compiled kernels; return whether there is one.

    Parameters
    ----------
    source
        The file in which the kernels are written.
    """
    stated = os.environ.get("NUMBA_CACHE_DIR", "")
    if _writable(Path(stated)) or _writable(source.parent / "__pycache__") or _writable(_xdg_folder("CACHE") / "numba"):
        return True
    folder = private_folder()
    if folder is not None:
        os.environ["NUMBA_CACHE_DIR"] = str(folder / "kernels")  # processes that this one starts share it
    return folder is not None


def with_fonts() -> None:
    """See to it that matplotlib has a place for what it keeps; call before it is imported.

    Raises
    ------
    InvalidInput
        If there is none, not even for temporary files.
    """
    if os.environ.get("MPLCONFIGDIR") or all(
        _writable(_xdg_folder(name) / "matplotlib") for name in ("CACHE", "CONFIG")
    ):
        return
    folder = private_folder()
    if folder is not None:
        os.environ["MPLCONFIGDIR"] = str(folder / "matplotlib")
        os.environ["XDG_CACHE_HOME"] = str(folder)  # fontconfig, which lists the fonts, warns without
        return
    try:
        tempfile.gettempdir()
    except OSError:
        raise InvalidInput(
            "figures: matplotlib needs a folder that can be written, and there is none; set TMPDIR to one."
        ) from None


def _xdg_folder(name: str) -> Path:
    """Return where programs keep what they cache, or how they are set up; not absolute if the user has no home."""
    return Path(os.environ.get(f"XDG_{name}_HOME") or os.path.expanduser(f"~/.{name.lower()}"))


def _writable(folder: Path) -> bool:
    """Return whether a folder can be written, or made if it is missing."""
    if not folder.is_absolute():
        return False
    existing = next((path for path in (folder, *folder.parents) if os.path.lexists(path)), folder)
    return existing.is_dir() and os.access(existing, os.W_OK | os.X_OK)


@functools.cache
def private_folder() -> Path | None:
    """Return a new folder that only this user can enter, removed when this process ends; None if there is no place."""
    try:
        parent = Path(tempfile.gettempdir())
        if not _protected(parent):
            return None
        _clear(parent)
        folder = Path(tempfile.mkdtemp(prefix=FOLDER_PREFIX, dir=parent))
        if _locked(folder) is None or not folder.is_dir():  # another process took it for one that was left
            return None
    except OSError:
        return None
    atexit.register(_remove, folder, os.getpid())
    return folder


def _remove(folder: Path, owner: int) -> None:
    if os.getpid() == owner:  # not when a process ends that was forked from this one
        shutil.rmtree(folder, ignore_errors=True)


def _protected(parent: Path) -> bool:
    """Return whether no other user can put a folder of theirs in the place of one of ours."""
    if os.name == "nt":
        return True
    status = parent.stat()
    shared = status.st_mode & (stat.S_IWGRP | stat.S_IWOTH) and not status.st_mode & stat.S_ISVTX
    return not shared and status.st_uid in (0, os.geteuid())


def _locked(folder: Path) -> int | None:
    """Lock a folder until this process ends, however it ends; None if another process holds it."""
    if os.name == "nt":
        return -1
    import fcntl

    number = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(number)
        return None
    return number


def _clear(parent: Path) -> None:
    """Remove the folders of this user that processes left which were killed."""
    for path in parent.glob(f"{FOLDER_PREFIX}*") if os.name != "nt" else ():
        with contextlib.suppress(OSError):
            lock = _locked(path) if path.lstat().st_uid == os.geteuid() else None
            if lock is not None:
                shutil.rmtree(path, ignore_errors=True)
                os.close(lock)
