"""Files that SurfaceTopography reads once they are packed otherwise: compressed Digital Surf, X3P within a folder."""

from __future__ import annotations

import contextlib
import tempfile
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path

from winkler.io.archive_file import archive, is_archive, member
from winkler.io.text_file import content_of
from winkler.values.errors import InvalidInput
from winkler.values.limits import FILE_BYTES

__all__ = ["X3P_HEAD", "readable_copy"]

COMPRESSED, PLAIN = b"DSCOMPRESSED", b"DIGITAL SURF"
"""How the head of a file of MountainsMap begins, by what follows it."""
HEAD_SIZE, SIZES = 512, (334, 336)
"""Bytes of the head, and where it states those of a comment and of a private part behind it."""
MOST_STREAMS = 8
X3P_HEAD, X3P_ENDING = "main.xml", ".x3p"
REMEDY = "save the map as an NPY file"


@contextlib.contextmanager
def readable_copy(path: Path) -> Iterator[Path]:
    """Yield a file, or a copy of it, packed as SurfaceTopography reads it, which is deleted afterwards.

    Raises
    ------
    InvalidInput
        If it unpacks to more than can be read, or ends early.
    """
    with path.open("rb") as file:
        start = file.read(len(COMPRESSED))
    if start == COMPRESSED:
        content = _unpacked(content_of(path, FILE_BYTES), path)
        with _beside(path) as copy:
            copy.write_bytes(content)
            yield copy
    elif folder := _folder_of_x3p(path):
        with _beside(path) as copy:
            _without_folder(path, folder, copy)
            yield copy
    else:
        yield path


@contextlib.contextmanager
def _beside(path: Path) -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="winkler-") as folder:
        yield Path(folder, f"copy{path.suffix}")


def _unpacked(content: bytes, path: Path) -> bytes:
    """Return the file with its points as they were before they were compressed: streams, and their sizes above them."""
    begin = HEAD_SIZE + sum(int.from_bytes(content[place : place + 2], "little") for place in SIZES)
    words = [int.from_bytes(content[place : place + 4], "little") for place in range(begin, begin + 68, 4)]
    count = words[0]
    sizes = list(zip(words[1::2], words[2::2], strict=True))[:count]
    place = begin + 4 + 8 * count
    if not 0 < count <= MOST_STREAMS or len(content) < place + sum(packed for _, packed in sizes):
        raise InvalidInput(f"{path}: the file ends before its compressed points; copy it anew.")
    if sum(plain for plain, _ in sizes) > FILE_BYTES:
        raise InvalidInput(
            f"{path}: it unpacks to {sum(plain for plain, _ in sizes) / 1e6:.0f} MB, at most {FILE_BYTES / 1e6:.0f} MB "
            f"are read; {REMEDY}."
        )
    parts = [PLAIN, content[len(PLAIN) : begin]]
    for plain, packed in sizes:
        parts.append(zlib.decompressobj().decompress(content[place : place + packed], plain or 1))
        place += packed
    return b"".join(parts)


def _folder_of_x3p(path: Path) -> str:
    """Return the folder in which the contents of an X3P stand; nothing of others."""
    if path.suffix.lower() != X3P_ENDING or not is_archive(path):
        return ""
    with archive(path, path, remedy=REMEDY) as pack:
        names = pack.namelist()
    inside = [name for name in names if name.endswith(f"/{X3P_HEAD}")]
    return inside[0].removesuffix(X3P_HEAD) if len(inside) == 1 and X3P_HEAD not in names else ""


def _without_folder(path: Path, folder: str, copy: Path) -> None:
    with archive(path, path, remedy=REMEDY) as pack, zipfile.ZipFile(copy, "w") as anew:
        for one in pack.infolist():
            if one.filename.startswith(folder) and not one.is_dir():
                anew.writestr(one.filename.removeprefix(folder), member(pack, one))
