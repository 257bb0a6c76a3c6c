"""The folder of one running app: the folders of its pages lie in it, and a later start removes folders of killed apps.

The app locks a file in its folder.  The system takes the lock back when the process ends, also when it is killed: a
folder whose lock can be taken belongs to nobody.  Between making a folder and locking its file another start may remove
it; then the locked file is no longer the one that lies there, and another folder is made.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from pathlib import Path

from winkler.io.processes.locking import lock
from winkler.io.processes.stopping import deferred_signals
from winkler.values.errors import InvalidInput

PREFIX = "winkler-uploads-"
LOCK = "lock"
ATTEMPTS = 5
"""Most attempts to make a folder."""


@contextlib.contextmanager
def uploads(place: Path | None = None) -> Iterator[Path]:
    """Make a folder for uploads, removed in the end; folders of killed apps of this user are removed first.

    Parameters
    ----------
    place
        Parent of the folder; by default the folder for temporary files.

    Raises
    ------
    InvalidInput
        If none can be made, or the file in it cannot be locked.
    """
    folder, file = Path(), -1
    try:
        with deferred_signals():
            folder, file = _made(place)
        yield folder
    finally:
        if file >= 0:
            with deferred_signals():
                _remove(folder, file)


def _made(place: Path | None) -> tuple[Path, int]:
    """Return a new folder, and the locked file in it."""
    try:
        place = place or Path(tempfile.gettempdir())
        for left in sorted(place.glob(f"{PREFIX}*")):
            _remove_if_dead(left)
        for _ in range(ATTEMPTS):
            folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=place))
            file = _locked(folder)
            if file is not None:
                return folder, file
            shutil.rmtree(folder, ignore_errors=True)
        why = "its file cannot be locked"
    except OSError as error:
        why = (error.strerror or type(error).__name__).lower()
    raise InvalidInput(f"no folder for uploads can be made ({why}); let TMPDIR name one on a local disk.")


def _remove_if_dead(folder: Path) -> None:
    """Remove a folder of this user whose app has ended."""
    with contextlib.suppress(OSError):
        about = folder.lstat()
        if not stat.S_ISDIR(about.st_mode) or (hasattr(os, "getuid") and about.st_uid != os.getuid()):
            return
        file = _locked(folder)
        if file is not None:
            _remove(folder, file)


def _remove(folder: Path, file: int) -> None:
    """Remove a folder, then give its lock back; where an open file cannot be removed, in the other order."""
    if os.name == "nt":
        os.close(file)
    shutil.rmtree(folder, ignore_errors=True)
    if os.name != "nt":
        os.close(file)


def _locked(folder: Path) -> int | None:
    """Return the locked file of a folder; None if another process has it or removed it, or the disk knows no locks."""
    path = folder / LOCK
    try:
        file = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o600)
    except OSError:
        return None
    try:
        if lock(file) and os.path.samestat(os.fstat(file), path.lstat()):
            return file
    except OSError:
        pass
    os.close(file)
    return None
