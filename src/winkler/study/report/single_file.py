"""Atomic writing of one file by a command: the file is complete, or as it was before.

It is written under a hidden name beside it, ``.NAME.part``, which takes its name when it is complete.  What a killed
command has left under the hidden name is overwritten by the next one, which holds the lock of the file meanwhile.
"""

from __future__ import annotations

import os
from pathlib import Path

from winkler.errors import InvalidInput
from winkler.io.foreign import path_text
from winkler.io.whole_file import replaced
from winkler.study.batch.locking import locked

__all__ = ["write_whole"]


def write_whole(path: Path, content: bytes) -> None:
    """Write a file whole or not at all.

    Parameters
    ----------
    path
        The file; one that is there is replaced.
    content
        Its bytes.

    Raises
    ------
    InvalidInput
        If it cannot be written, or another command is writing it.
    """
    target = Path(os.path.realpath(path))  # the target of a link
    try:
        with locked(target.with_name(f".{target.name}.lock")), replaced(target, "part") as file:
            file.write(content)
    except BlockingIOError:
        raise InvalidInput(
            f"output: another command is writing '{path_text(path)}'; wait for its end, or give another file with "
            "--output."
        ) from None
    except (OSError, ValueError) as error:
        why = (getattr(error, "strerror", None) or str(error)).lower()
        raise InvalidInput(
            f"output: '{path_text(path)}' cannot be written ({why}); give another file with --output."
        ) from None
