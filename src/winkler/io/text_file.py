"""Text files: check that they exist, and read them within limits of size.

Devices, pipes and sockets are refused, since some of them never end; the limits stand in `winkler.values.limits`.
"""

from __future__ import annotations

import codecs
import contextlib
import functools
import itertools
import os
import re
from pathlib import Path

from winkler.io.foreign import path_text, sentence_of
from winkler.values.checks.physical_size import as_text
from winkler.values.errors import InvalidInput, suggest
from winkler.values.limits import HEADER_LETTERS, HEADER_LINES, LINE_LETTERS, TEXT_BYTES, TEXT_LINES

SPREADSHEET = "this is a spreadsheet or an archive; save the table as text (CSV)"
SIGNATURES = (
    (b"\xff\xfe\x00\x00", "the file is written in UTF-32; save it as UTF-8"),
    (b"PK\x03\x04", SPREADSHEET),
    (b"\xd0\xcf\x11", SPREADSHEET),
)
UTF16_MARKS = codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE
"""First bytes of a text in UTF-16."""
UNMARKED_UTF16 = re.compile(rb"(?:[\t\n\r -~]\x00){4}|(?:\x00[\t\n\r -~]){4}")
"""Four letters of a text in UTF-16 without these bytes."""
OTHER_PROGRAMS = (
    (b":NANONIS_VERSION:", "an image of Nanonis; save its heights from there, or from Gwyddion, as text or .gwy"),
    (b"[Paramco32]", "an image of Createc; save its heights from there, or from Gwyddion, as text or .gwy"),
    (b"MATLAB 5.0 MAT-file", "a workspace of MATLAB without a map of heights; save its columns as text (CSV)"),
)
"""How files of programs begin that nothing here reads, and what to do with them."""
SETTINGS, SETTINGS_LINES = ("\\", '"\\'), 4 * HEADER_LINES
"""How the settings begin that NanoScope writes above the numbers of its texts, and most lines of them."""
OTHER_ENDS = re.compile(rb"[\x0b\x0c]")
"""Where a text is cut into lines, and bytes are not."""
HIGH_RUN = re.compile(rb"[\x80-\xff]++")
"""Letters beyond ASCII that follow each other."""
CHINESE_PAIRS = re.compile(rb"(?:[\xb0-\xf7][\xa1-\xfe]|[\xa1-\xa9][\xa1-\xfe])++")
"""Chinese letters and signs in GB 2312, two bytes each; in other languages such letters stand alone."""
FEWEST_CHINESE = 4
"""Bytes of a word by which it is told,"""
SAMPLE_BYTES = 100_000
"""in the first bytes of a text."""
NO_TEXT = bytes([*range(9), *range(14, 32), 127])
"""Bytes that no text has."""
UNREADABLE = "the file cannot be read", "check it"
MOST_NAMES_COMPARED = 1000
"""Files of a folder among which a similar name is searched."""


def path_of(given: str | os.PathLike[str]) -> Path:
    """Return a path that was given; refuse what is none.

    Raises
    ------
    InvalidInput
    """
    if not isinstance(given, str | os.PathLike) or not isinstance(os.fspath(given), str):
        raise InvalidInput(f"{as_text(given)} is no path of a file; give one such as 'tip.csv'.")
    return Path(given)


def existing(given: str | os.PathLike[str], what: str) -> Path:
    """Return the path of an existing regular file.

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
    path = path_of(given)
    try:
        if path.is_dir():
            raise InvalidInput(f"{path_text(path)}: this is a folder; give a file in it.")
        if not path.exists():
            raise InvalidInput(f"{path_text(path)}: {_not_there(path)}; give the path of {what}.")
        if not path.is_file():
            raise InvalidInput(f"{path_text(path)}: this is not a file with contents; give the path of {what}.")
    except OSError as error:
        raise InvalidInput(f"{path_text(path)}: the file cannot be read ({error.strerror}).") from None
    return path


def content_of(path: Path, most_bytes: int, *, start: int | None = None) -> bytes:
    """Return the bytes of an existing file.

    Parameters
    ----------
    path : path
        As `existing` returns it.
    most_bytes : int
        Largest size; a larger file is refused, whatever size it states.
    start : int, optional
        Number of bytes to read from the beginning; all if None.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or is too large.
    """
    refuse_large(path, most_bytes)
    with sentence_of(path, *UNREADABLE), path.open("rb") as file:
        content = file.read(start if start is not None else most_bytes + 1)
    if len(content) > most_bytes:  # it states less, as files of the system do
        raise InvalidInput(f"{path_text(path)}: its contents are too much; at most {most_bytes / 1e6:.0f} MB are read.")
    return content


def refuse_large(path: Path, most_bytes: int) -> None:
    """Refuse a file of more than so many bytes.

    Raises
    ------
    InvalidInput
    """
    with sentence_of(path, *UNREADABLE):
        size = path.stat().st_size
    if size > most_bytes:
        raise InvalidInput(
            f"{path_text(path)}: {size / 1e6:.0f} MB are too much; at most {most_bytes / 1e6:.0f} MB are read."
        )


def lines_of(given: str | os.PathLike[str], needs: str) -> list[str]:
    """Return the lines of a text in UTF-8, UTF-16 with a byte order mark, GB 2312 or Latin-1.

    Parameters
    ----------
    given : str or path
        The file.
    needs : str
        What it should hold, for an empty one.

    Raises
    ------
    InvalidInput
        If it cannot be read, is no text, or is too large.
    """
    path = existing(given, "a text file")
    content = content_of(path, TEXT_BYTES)
    count = content.count(b"\n") + content.count(b"\r")
    if count > TEXT_LINES and count - content.count(b"\r\n") > TEXT_LINES:
        raise InvalidInput(f"{path_text(path)}: the file has more than {TEXT_LINES} lines; thin it out.")
    return lines_of_bytes(content, path_text(path), needs)


def head_of(given: str | os.PathLike[str], needs: str) -> list[str]:
    """Return the lines among which the header of a table stands; parameters as for `lines_of`.

    Raises
    ------
    InvalidInput
        As `lines_of`; also if a line is too long for a header.
    """
    path = existing(given, "a text file")
    return list(_head(content_of(path, TEXT_BYTES, start=HEADER_LETTERS), path_text(path), needs))


@functools.lru_cache(maxsize=4)  # each reader that is tried asks for it
def _head(content: bytes, where: str, needs: str) -> tuple[str, ...]:
    return tuple(headed(lines_of_bytes(content, where, needs, is_cut=len(content) == HEADER_LETTERS), where))


def headed(lines: list[str], where: str) -> list[str]:
    """Return those of all lines of a text among which the header of a table stands.

    Raises
    ------
    InvalidInput
        If one of them is too long for a header.
    """
    first = lines[: SETTINGS_LINES if lines and lines[0].startswith(SETTINGS) else HEADER_LINES]
    sizes = list(map(len, first))
    if sizes and max(sizes) <= LINE_LETTERS and sum(sizes) + len(sizes) <= HEADER_LETTERS:
        return first
    head: list[str] = []
    size = 0
    for number, line in enumerate(first, 1):
        size += len(line) + 1
        if len(line) > LINE_LETTERS and line.lstrip()[:1] in ("#", "%"):
            line = ""
        if len(line) > LINE_LETTERS:
            raise InvalidInput(
                f"{where}, line {number}: the line has {len(line)} characters, and a table at most {LINE_LETTERS}; "
                "give one row of numbers in a line."
            )
        if size > HEADER_LETTERS:
            break
        head.append(line)
    return head


def of_other_program(content: bytes) -> str:
    """Return which program wrote a file that nothing here reads, and what to do, by its first bytes; else nothing."""
    return next((what for start, what in OTHER_PROGRAMS if content.startswith(start)), "")


def _in_utf8(where: str, content: bytes, *, is_cut: bool = False) -> bytes:
    """Return a text in UTF-16 as UTF-8, and any other as it is; what is no text is refused by its first bytes."""
    for start, what in SIGNATURES:
        if content.startswith(start):
            raise InvalidInput(f"{where}: {what}.")
    if other := of_other_program(content):
        raise InvalidInput(f"{where}: this is {other}.")
    if not content.startswith(UTF16_MARKS):
        return content
    if not is_cut and len(content) % 2 and content[-1:] in b"\r\n":  # programs that end lines anew leave half a letter
        content = content[:-1]
    try:
        return codecs.getincrementaldecoder("utf-16")().decode(content, final=not is_cut).encode()
    except UnicodeDecodeError:
        raise InvalidInput(f"{where}: the file is damaged UTF-16; save it anew as UTF-8.") from None


def lines_of_bytes(content: bytes, where: str, needs: str, *, is_cut: bool = False) -> list[str]:
    """Return the lines of a text that was read already; every line by itself, so that no second copy of all is needed.

    Parameters
    ----------
    content : bytes
        In UTF-8, UTF-16 with a byte order mark, GB 2312, or Latin-1.
    where : str
        Its name, for messages.
    needs : str
        What it should hold, for an empty one.
    is_cut : bool
        Whether it is the beginning of a longer text, cut somewhere, perhaps within a letter.

    Raises
    ------
    InvalidInput
        If it is no text, or empty.
    """
    content = _in_utf8(where, content, is_cut=is_cut)
    if is_cut:
        content = content[: max(content.rfind(b"\n"), content.rfind(b"\r")) + 1] or content
    if UNMARKED_UTF16.match(content):
        raise InvalidInput(f"{where}: the file looks like UTF-16 without a byte order mark; save it as UTF-8.")
    if len(content.translate(None, NO_TEXT)) < len(content):
        raise InvalidInput(f"{where}: the file is not a text; save the table as text (CSV) in UTF-8.")
    content = content.removeprefix(codecs.BOM_UTF8)
    if content.isascii() and not OTHER_ENDS.search(content):
        lines = content.decode("ascii").splitlines()
    else:
        lines = _decoded(content.splitlines(), content)
    if not any(line.strip() for line in lines):
        raise InvalidInput(f"{where}: the file is empty; it needs {needs}.")
    return lines


def _decoded(raw: list[bytes], content: bytes) -> list[str]:
    """Return lines in UTF-8, else in GB 2312 where their letters are Chinese, else in Latin-1."""
    for encoding in ("utf-8", *(["gb18030"] if _is_chinese(content[:SAMPLE_BYTES]) else [])):
        with contextlib.suppress(UnicodeDecodeError):
            return [line.decode(encoding) for line in raw]
    return [line.decode("latin-1") for line in raw]


def _is_chinese(content: bytes) -> bool:
    """Return whether all letters beyond ASCII come in pairs of GB 2312, and one word has two of them."""
    longest = 0
    for run in HIGH_RUN.finditer(content):
        cut = run.end() == len(content) and len(run[0]) % 2  # a letter may be cut at the end
        letters = run[0][:-1] if cut else run[0]
        if letters and not CHINESE_PAIRS.fullmatch(letters):
            return False
        longest = max(longest, len(letters))
    return longest >= FEWEST_CHINESE


def _not_there(path: Path) -> str:
    if not path.parent.is_dir():
        return f"there is no folder '{path_text(path.parent)}'"
    near = [item.name for item in itertools.islice(path.parent.iterdir(), MOST_NAMES_COMPARED)]
    return f"there is no such file in '{path_text(path.parent)}'{suggest(path.name, near)}"
