"""Atomic writing: a file is written under a hidden temporary name and then renamed to its own."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from winkler.errors import InvalidInput

__all__ = ["write_whole_text", "written_whole"]


@contextlib.contextmanager
def written_whole(path: Path) -> Iterator[IO[bytes]]:
    """Open a temporary file for writing, renamed to `path` when the block ends without an error.

    Parameters
    ----------
    path
        Final name; an existing file of this name stays as it is until then.

    Raises
    ------
    InvalidInput
        If it cannot be written.
    """
    target = Path(os.path.realpath(path))  # the target of a link
    partial = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        try:
            with partial.open("wb") as file:
                yield file
                file.flush()
                os.fsync(file.fileno())
            partial.replace(target)
        finally:
            with contextlib.suppress(OSError):
                partial.unlink(missing_ok=True)
    except OSError as error:
        raise InvalidInput(
            f"{path}: cannot be written ({error.strerror}); name a file in a folder that exists."
        ) from None


def write_whole_text(path: Path, text: str) -> None:
    """Write a text in UTF-8; see `written_whole`."""
    with written_whole(path) as file:
        file.write(text.encode("utf-8"))
