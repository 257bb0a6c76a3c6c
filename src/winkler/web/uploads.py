"""The folder of one running app: the folders of its pages lie in it, and a later start removes what a kill left there.

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
from pathlib import Path

from winkler.errors import InvalidInput
from winkler.study.lock import lock

__all__ = ["Uploads"]

PREFIX = "winkler-uploads-"
LOCK = "lock"
ATTEMPTS = 5
"""So many folders are made in vain before the place is given up."""


class Uploads:
    """A folder for uploads, gone when it is left; what killed apps of this user left behind is removed first.

    Parameters
    ----------
    place
        Where it is made; by default the folder for temporary files.
    """

    def __init__(self, place: Path | None = None) -> None:
        self.place = place

    def __enter__(self) -> Path:
        """Return the folder.

        Raises
        ------
        InvalidInput
            If none can be made, or its file cannot be locked.
        """
        try:
            place = self.place or Path(tempfile.gettempdir())
            for left in sorted(place.glob(f"{PREFIX}*")):
                _remove_if_dead(left)
            for _ in range(ATTEMPTS):
                self.folder = Path(tempfile.mkdtemp(prefix=PREFIX, dir=place))
                file = _locked(self.folder)
                if file is not None:
                    self._file = file
                    return self.folder
                shutil.rmtree(self.folder, ignore_errors=True)
            why = "its file cannot be locked"
        except OSError as error:
            why = (error.strerror or type(error).__name__).lower()
        raise InvalidInput(f"no folder for uploads can be made ({why}); let TMPDIR name one on a local disk.")

    def __exit__(self, *_: object) -> None:
        """Remove the folder."""
        _remove(self.folder, self._file)


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
    """Remove a folder, then give its lock back; where an open file cannot be removed, the other way round."""
    if os.name == "nt":
        os.close(file)
    shutil.rmtree(folder, ignore_errors=True)
    if os.name != "nt":
        os.close(file)


def _locked(folder: Path) -> int | None:
    """Return the locked file of a folder; None if another process has it, or has removed it."""
    path = folder / LOCK
    try:
        file = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o600)
    except OSError:
        return None
    try:
        lock(file)
        if os.path.samestat(os.fstat(file), path.lstat()):
            return file
    except OSError:
        pass
    os.close(file)
    return None
