"""Atomic writing: a file is written under a hidden temporary name and then renamed to its own."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from winkler.errors import InvalidInput

__all__ = ["replaced", "write_whole_text", "written_whole"]


@contextlib.contextmanager
def replaced(path: Path, mark: object) -> Iterator[IO[bytes]]:
    """Open the temporary file ``.NAME.MARK`` for writing, which replaces `path` when the block ends without an error.

    Parameters
    ----------
    path
        Final name; an existing file of this name stays as it is until then.  Of a link the target is replaced.
    mark
        End of the temporary name.  What a killed process has left under it is overwritten.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    target = Path(os.path.realpath(path))
    partial = target.with_name(f".{target.name}.{mark}")
    try:
        with partial.open("wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        partial.replace(target)
    finally:
        with contextlib.suppress(OSError):
            partial.unlink(missing_ok=True)


@contextlib.contextmanager
def written_whole(path: Path) -> Iterator[IO[bytes]]:
    """Open a file for writing as `replaced` does, under a temporary name of this process.

    Raises
    ------
    InvalidInput
        If it cannot be written.
    """
    try:
        with replaced(path, f"{os.getpid()}.part") as file:
            yield file
    except OSError as error:
        raise InvalidInput(
            f"{path}: cannot be written ({error.strerror}); name a file in a folder that exists."
        ) from None


def write_whole_text(path: Path, text: str) -> None:
    """Write a text in UTF-8; see `written_whole`."""
    with written_whole(path) as file:
        file.write(text.encode("utf-8"))
