"""Archives (zip): what they state of their contents is compared with limits before anything is unpacked."""

from __future__ import annotations

import contextlib
import io
import os
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from winkler.io.foreign import sentence_of
from winkler.values.errors import InvalidInput
from winkler.values.limits import FILE_BYTES, LIST_BYTES

END, LOCATOR, END64 = b"PK\x05\x06", b"PK\x06\x07", b"PK\x06\x06"
"""Marks of the records at the end of an archive (APPNOTE.TXT 6.3.10, sections 4.3.14 to 4.3.16),"""
END_SIZE, LOCATOR_SIZE, END64_SIZE = 22, 20, 56
"""their sizes in bytes,"""
LIST_SIZE, LIST_SIZE64 = slice(12, 16), slice(40, 48)
"""and where they state the size of the list of contents."""
COMMENT_BYTES = 2**16
TRUSTED_PACKED_BYTES = 1_000_000
"""Members packed in more bytes are unpacked piece by piece, to count their true size."""
PIECE_BYTES = 2**20
COMPRESSIONS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""How members may be packed; `zipfile` unpacks those of other methods at once, whatever size they state."""


def is_archive(path: Path) -> bool:
    """Return whether a file begins as an archive does."""
    with path.open("rb") as file:
        return file.read(4) in (b"PK\x03\x04", b"PK\x05\x06")


@contextlib.contextmanager
def archive(
    source: Path | bytes,
    name: object,
    *,
    wrong: str = "the archive cannot be read",
    remedy: str,
    members: int = 10**9,
    size: int = FILE_BYTES,
) -> Iterator[zipfile.ZipFile]:
    """Open an archive whose contents are of a size that can be unpacked; errors become one sentence.

    Parameters
    ----------
    source : path or bytes
        The file, or its contents.
    name : str or path
        What it is called in a sentence.
    wrong, remedy : str
        As for `winkler.io.foreign.sentence_of`.
    members, size : int, optional
        Most files in it, and bytes of all of them.

    Raises
    ------
    InvalidInput
        If it is none, or states more.
    """
    with sentence_of(name, wrong, remedy), contextlib.ExitStack() as closed:
        file: BinaryIO = io.BytesIO(source) if isinstance(source, bytes) else closed.enter_context(source.open("rb"))
        listed = _list_size(file)
        if listed > min(LIST_BYTES, 1000 * members + COMMENT_BYTES):
            raise InvalidInput(f"{name}: the archive has a list of contents of {listed / 1e6:.1f} MB; {remedy}.")
        pack = closed.enter_context(zipfile.ZipFile(file))
        inside = pack.infolist()
        if any(one.compress_type not in COMPRESSIONS for one in inside):
            raise zipfile.BadZipFile("it is packed by another method than deflating")
        total = sum(one.file_size for one in inside)
        if len(inside) > members or total > size:
            raise InvalidInput(
                f"{name}: the archive holds {len(inside)} files of {total / 1e6:.0f} MB, at most {members} of "
                f"{size / 1e6:.0f} MB are unpacked; {remedy}."
            )
        yield pack


def _list_size(file: BinaryIO) -> int:
    """Return the size of the list of contents [bytes] as the end of the archive states it; it is read at once."""
    end = file.seek(0, os.SEEK_END)
    file.seek(max(0, end - COMMENT_BYTES - END_SIZE - LOCATOR_SIZE - END64_SIZE))
    tail = file.read()
    file.seek(0)
    plain = len(tail) - END_SIZE  # without a comment
    place = plain if plain >= 0 and tail[plain:].startswith(END) and tail.endswith(b"\0\0") else tail.rfind(END)
    if place < 0:
        raise zipfile.BadZipFile("it has no end")
    sizes = [int.from_bytes(tail[place:][LIST_SIZE], "little")]
    before = tail[max(0, place - LOCATOR_SIZE - END64_SIZE) : place]
    if before[-LOCATOR_SIZE:].startswith(LOCATOR):
        if not before.startswith(END64):
            raise zipfile.BadZipFile("its end is damaged")
        sizes.append(int.from_bytes(before[LIST_SIZE64], "little"))
    return max(size for size in sizes if size != 2**32 - 1 or len(sizes) == 1)


def member(pack: zipfile.ZipFile, name: str | zipfile.ZipInfo) -> bytes:
    """Return the contents of one file, of which no more is unpacked than the archive states."""
    stated = name if isinstance(name, zipfile.ZipInfo) else pack.getinfo(name)
    with pack.open(stated) as file:
        return file.read(stated.file_size)


def refuse_large_archive(path: Path, remedy: str) -> None:
    """Refuse an archive that a library is to read, if it is or unpacks to more than can be read.

    Raises
    ------
    InvalidInput
    """
    with archive(path, path, remedy=remedy) as pack:
        for stated in pack.infolist():
            if stated.compress_size > TRUSTED_PACKED_BYTES:
                with pack.open(stated) as file:
                    while file.read(PIECE_BYTES):
                        pass
