"""The file of a `ContactArray`: one line of JSON, the arrays as they are in memory, and a checksum.

Files of NumPy are read within limits that ten million contacts exceed; here the line and the size of the file state
what is read before it is.
"""

from __future__ import annotations

import json
import math
import os
import struct
import sys
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np

from winkler.io.text_file import existing
from winkler.io.whole_file import written_whole
from winkler.values.errors import InvalidInput

__all__ = ["ArrayFile", "write_array_file"]

FORMAT = "winkler contact array 1"
HEADER_BYTES = 1_000_000
CHECKSUM = struct.Struct("<I")
PIECE_BYTES = 1 << 24
"""How much the checksum takes at once."""

Any_ = np.ndarray[Any, Any]


def write_array_file(path: str | os.PathLike[str], header: dict[str, Any], arrays: Sequence[Any_]) -> Path:
    """Write a header and arrays under a temporary name, which then replaces the file.

    Raises
    ------
    InvalidInput
        If it cannot be written.
    """
    line = {"format": FORMAT, "order": sys.byteorder, **header}
    with written_whole(Path(path)) as file:
        text = json.dumps(line).encode() + b"\n"
        file.write(text)
        total = zlib.crc32(text)
        for piece in _pieces(arrays):
            file.write(piece)
            total = zlib.crc32(piece, total)
        file.write(CHECKSUM.pack(total))
    return Path(path)


class ArrayFile:
    """A file that `write_array_file` wrote, opened: its header is checked, its arrays are not read yet.

    Parameters
    ----------
    path : str or path

    Raises
    ------
    InvalidInput
        If it is missing, or not such a file.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = existing(path, "a file of ContactArray.save")
        with self.path.open("rb") as file:
            self.line = file.readline(HEADER_BYTES)
        try:
            header = json.loads(self.line)
        except (ValueError, RecursionError):
            header = None
        if not isinstance(header, dict) or header.get("format") != FORMAT or header.get("order") != sys.byteorder:
            raise InvalidInput(f"{self.path}: it does not hold '{FORMAT}'; give a file of ContactArray.save.")
        self.header: dict[str, Any] = header

    def refuse(self, why: str) -> InvalidInput:
        """Return the sentence that refuses the file."""
        return InvalidInput(f"{self.path}: no contacts can be read from it ({why}); give a file of ContactArray.save.")

    def expect(self, byte_count: int) -> None:
        """Refuse the file if its arrays do not have so many bytes."""
        found = self.path.stat().st_size - len(self.line) - CHECKSUM.size
        if found != byte_count:
            raise self.refuse(f"its arrays have {max(found, 0)} bytes in place of {byte_count}")

    def read_into(self, arrays: Sequence[Any_]) -> None:
        """Fill arrays with those of the file; refuse it if the checksum does not agree."""
        self.expect(sum(array.nbytes for array in arrays))
        total = zlib.crc32(self.line)
        with self.path.open("rb") as file:
            file.seek(len(self.line))
            for piece in _pieces(arrays):
                _fill(file, piece)
                total = zlib.crc32(piece, total)
            if file.read(CHECKSUM.size) != CHECKSUM.pack(total):
                raise self.refuse("its checksum does not agree: it was changed or spoilt")


def _pieces(arrays: Iterable[Any_]) -> Iterable[memoryview]:
    """Return the bytes of arrays in memory, piece by piece."""
    for array in arrays:
        if math.prod(array.shape) == 0:
            continue
        whole = array.reshape(-1).view(np.uint8).data
        for start in range(0, len(whole), PIECE_BYTES):
            yield whole[start : start + PIECE_BYTES]


def _fill(file: IO[bytes], piece: memoryview) -> None:
    file.readinto(piece)  # type: ignore[attr-defined]
