"""Atomic writing: files are complete, or as they were before; several that belong together change together.

Each file is written under a hidden name of its own beside its place, ``.MARK.winkler-part``, locked while its writer
lives.  When all are complete and on the disk, they take their names, one directly after the other, while Ctrl-C and
SIGTERM wait.  What writers left that were killed is removed by the next one that writes into the folder.
"""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import IO

from winkler.io.foreign import path_text
from winkler.io.processes.locking import lock, open_locked
from winkler.io.processes.stopping import deferred_signals
from winkler.values.errors import InvalidInput

PART = ".winkler-part"
FULL = frozenset({errno.ENOSPC, getattr(errno, "EDQUOT", errno.ENOSPC)})
"""Errors of a disk that is full, or of a quota that is used up."""
BUFFER_BYTES = 1 << 20
MISPLACED = frozenset({errno.ENOENT, errno.ENOTDIR, errno.EISDIR})


def unwritable(path: Path, error: OSError, *, option: str = "") -> InvalidInput:
    """Return the error of a file or folder that cannot be written, with the way out that helps.

    Parameters
    ----------
    path
        The file, or the folder of several.
    error
        What the system says.
    option
        What the command calls it: "folder with --output".
    """
    number = error.errno
    why = (os.strerror(number) if number else str(error) or type(error).__name__).lower()  # libraries say more
    another = f"give another {option}" if option else "name a file elsewhere"
    if number in FULL:
        another = f"free some space, or {another}"
    elif number in MISPLACED and not option:
        another = "name a file in a folder that exists"
    return InvalidInput(f"{'output: ' if option else ''}'{path_text(path)}' cannot be written ({why}); {another}.")


@contextlib.contextmanager
def written_whole(path: Path) -> Iterator[IO[bytes]]:
    """Open a temporary file for writing, which replaces `path` when the block ends without an error.

    Parameters
    ----------
    path
        Final name; an existing file of this name stays as it is until then.  Of a link the target is replaced.

    Raises
    ------
    InvalidInput
        If it cannot be written.
    """
    try:
        with _replaced([path]) as (file,):
            yield file
    except OSError as error:
        raise unwritable(path, error) from None


def write_whole(files: Mapping[Path, bytes | memoryview]) -> None:
    """Write files that belong together: all of them, or none.

    Parameters
    ----------
    files
        Path -> content, in folders that exist.

    Raises
    ------
    InvalidInput
        If one cannot be written.
    """
    writing = next(iter(files), Path())
    try:
        with _replaced(list(files)) as parts:
            for part, (path, content) in zip(parts, files.items(), strict=True):
                writing = path
                part.write(content)
                part.flush()
    except OSError as error:
        raise unwritable(writing, error) from None


def write_new(path: Path, content: bytes) -> None:
    """Write a file into a folder that nobody else sees yet; the folder is made if it is missing.

    Raises
    ------
    OSError
        If it cannot be written; what was written of it stays.
    """
    path.parent.mkdir(exist_ok=True)
    number = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | getattr(os, "O_BINARY", 0), 0o666)
    with os.fdopen(number, "wb", buffering=0) as file:
        rest = memoryview(content)
        while rest:
            rest = rest[file.write(rest) :]


def write_whole_text(path: Path, text: str) -> None:
    """Write a text in UTF-8; see `write_whole`."""
    write_whole({path: text.encode("utf-8")})


@contextlib.contextmanager
def _replaced(paths: Sequence[Path]) -> Iterator[list[IO[bytes]]]:
    """Open a part for each path; they take their names when the block ends without an error."""
    if any("\0" in str(path) for path in paths):
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))
    targets = [Path(os.path.realpath(path)) for path in paths]
    if any(target.is_dir() for target in targets):  # seen before the first takes its name
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    for folder in dict.fromkeys(target.parent for target in targets):
        remove_left(folder)
    parts = [target.with_name(f".{os.urandom(8).hex()}{PART}") for target in targets]
    files: list[IO[bytes]] = []
    try:
        for part in parts:
            files.append(_opened(part))
        yield files
        for file in files:
            file.flush()
            os.fsync(file.fileno())
        if os.name == "nt":  # an open file cannot be renamed there
            _close(files)
        with deferred_signals():
            for part, target in zip(parts, targets, strict=True):
                os.replace(part, target)
    finally:
        with deferred_signals():
            _close(files)
            for part in parts:
                with contextlib.suppress(OSError):
                    part.unlink(missing_ok=True)


def _opened(part: Path) -> IO[bytes]:
    """Return a new file, locked, so that no other writer takes it for one that was left."""
    while True:
        with contextlib.suppress(BlockingIOError):  # another writer is removing it
            return os.fdopen(open_locked(part)[0], "wb", buffering=BUFFER_BYTES)


def _close(files: list[IO[bytes]]) -> None:
    for file in files:
        with contextlib.suppress(OSError):
            file.close()


def remove_left(folder: Path) -> None:
    """Remove the parts in a folder whose writers were killed; those of living writers are locked."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for name in [entry.name for entry in entries if entry.name.endswith(PART)]:
            with contextlib.suppress(OSError):
                _remove_dead(folder / name)


def _remove_dead(part: Path) -> None:
    if os.name == "nt":  # what a living process has open cannot be removed there
        part.unlink()
        return
    file = os.open(part, os.O_RDWR)
    try:
        if lock(file):
            part.unlink()
    finally:
        os.close(file)
