"""Text files: whether they are there, and what is written in them, or one sentence that says why not."""

from __future__ import annotations

import os
import re
from pathlib import Path

from winkler.errors import InvalidInput, suggest

__all__ = ["existing", "lines_of"]

LARGEST = 200_000_000
"""Most bytes of a text."""
SPREADSHEET = "this is a spreadsheet or an archive; save the table as text (CSV)"
SIGNATURES = (
    (b"\xff\xfe", "the file is written in UTF-16; save it as UTF-8"),
    (b"\xfe\xff", "the file is written in UTF-16; save it as UTF-8"),
    (b"PK\x03\x04", SPREADSHEET),
    (b"\xd0\xcf\x11", SPREADSHEET),
)


def existing(given: str | os.PathLike[str], what: str) -> Path:
    """Return the path of a file that is there, with contents.

    Parameters
    ----------
    given : str or path
        The path.
    what : str
        What it should be, for messages: "a text file".

    Raises
    ------
    InvalidInput
        If it is none.
    """
    if not isinstance(given, str | os.PathLike):
        raise InvalidInput(f"{given!r} is no path of a file; give one such as 'tip.csv'.")
    path = Path(given)
    try:
        if path.is_dir():
            raise InvalidInput(f"{path}: this is a folder; give a file in it.")
        if not path.exists():
            raise InvalidInput(f"{path}: {_not_there(path)}; give the path of {what}.")
        if not path.is_file():
            raise InvalidInput(f"{path}: this is not a file with contents; give the path of {what}.")
    except OSError as error:
        raise InvalidInput(f"{path}: the file cannot be read ({error.strerror}).") from None
    return path


def lines_of(given: str | os.PathLike[str], needs: str) -> list[str]:
    """Return the lines of a text in UTF-8, or Latin-1 as older instruments write it.

    Parameters
    ----------
    given : str or path
        The file.
    needs : str
        What it should hold, for an empty one.

    Raises
    ------
    InvalidInput
        If it cannot be read, or is no text.
    """
    path = existing(given, "a text file")
    try:
        size = path.stat().st_size
        if size > LARGEST:
            raise InvalidInput(f"{path}: {size / 1e6:.0f} MB are too much; at most {LARGEST / 1e6:.0f} MB are read.")
        content = path.read_bytes()
    except OSError as error:
        raise InvalidInput(f"{path}: the file cannot be read ({error.strerror}).") from None
    for start, what in SIGNATURES:
        if content.startswith(start):
            raise InvalidInput(f"{path}: {what}.")
    if re.search(rb"[\x00-\x08\x0e-\x1f\x7f]", content):
        raise InvalidInput(f"{path}: the file is not a text; save the table as text (CSV) in UTF-8.")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    if not text.strip():
        raise InvalidInput(f"{path}: the file is empty; it needs {needs}.")
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _not_there(path: Path) -> str:
    if not path.parent.is_dir():
        return f"there is no folder '{path.parent}'"
    return (
        f"there is no such file in '{path.parent}'{suggest(path.name, [item.name for item in path.parent.iterdir()])}"
    )
