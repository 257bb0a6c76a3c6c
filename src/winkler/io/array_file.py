"""Arrays in files of NumPy's kinds ``.npy`` and ``.npz``: read within limits; replaced once the new file is whole.

The version of winkler stands beside them.
"""

from __future__ import annotations

import io
import math
import os
from collections.abc import Iterable, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import IO

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.archive_file import archive, is_archive
from winkler.io.foreign import sentence_of
from winkler.io.text_file import existing
from winkler.io.whole_file import written_whole
from winkler.limits import MOST_NUMBERS
from winkler.numerics.types import Array

__all__ = ["read_arrays", "version_of", "write_arrays"]

MEMBERS = 1000
"""Arrays in a file."""
HEADER = 20_000
"""Bytes of what an array states of itself; numpy refuses more than 10,000, once it has read them."""
TEXTS = 1000
"""Bytes of a text in an array."""
LISTED = 20
"""Names of arrays in a sentence."""


def read_arrays(
    path: str | os.PathLike[str],
    words: Iterable[str],
    *,
    needed: Iterable[str] = (),
    missing: str = "",
    wrong: str,
    remedy: str,
) -> dict[str, Array]:
    """Return the arrays of a file by their names; that of an ``.npy`` file has the name "".

    Their shapes and types stand before them, and are looked at first; objects and tables of records are not read.

    Parameters
    ----------
    path : str or path
        The file, whose beginning tells its kind.
    words : iterable of str
        Those that are wanted, where the file has them.
    needed : iterable of str, optional
        Those that it must have.
    missing : str, optional
        What to say if it has not.
    wrong, remedy : str
        As for `winkler.io.foreign.sentence_of`.

    Returns
    -------
    dict of str to ndarray

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds more than is read.
    """
    path = existing(path, "a file of numpy's arrays")
    with sentence_of(path, wrong, remedy):
        if not is_archive(path):
            with path.open("rb") as file:
                return {"": _array(file, path.stat().st_size, path, "it")}
        with archive(path, path, wrong=wrong, remedy=remedy, members=MEMBERS) as pack:
            names = {one.filename.removesuffix(".npy"): one for one in pack.infolist()}
            absent = [word for word in needed if word not in names]
            if absent:
                listed = ", ".join(list(names)[:LISTED]) or "nothing"
                raise InvalidInput(f"{path}: it holds {listed}; {missing or f'{wrong} without {absent[0]}; {remedy}'}.")
            found, left = {}, MOST_NUMBERS
            for word in words:
                if word in names:
                    with pack.open(names[word]) as stored:
                        found[word] = _array(stored, names[word].file_size, path, f"'{word}'", left)
                    left -= found[word].size
            return found


def _array(file: IO[bytes], size: int, path: Path, name: str, left: int = MOST_NUMBERS) -> Array:
    """Return one array, if what it states of itself fits the size of the file [bytes] and the numbers left."""
    form = np.lib.format
    if not size:
        raise ValueError("No data left in file")
    start = io.BytesIO(file.read(HEADER))
    form_version = form.read_magic(start)
    if form_version not in ((1, 0), (2, 0)):
        raise ValueError(f"the version {form_version[0]}.{form_version[1]} of the format is for tables of records")
    shape, _, kind = (form.read_array_header_1_0 if form_version == (1, 0) else form.read_array_header_2_0)(start)
    count = math.prod(shape)
    if kind.hasobject:
        raise ValueError("Object arrays cannot be loaded")
    if count > left or count * kind.itemsize > 8 * MOST_NUMBERS or (kind.kind in "SU" and kind.itemsize > TEXTS):
        raise InvalidInput(
            f"{path}: {name} has the shape {shape} and the type {kind}; at most {MOST_NUMBERS} numbers are read from "
            "a file: save a part of it."
        )
    if count * kind.itemsize > size:
        raise ValueError(f"the shape {shape} needs more bytes than the file has")
    file.seek(0)
    return np.asarray(form.read_array(file, allow_pickle=False))


def version_of(path: Path) -> str:
    """Return the version of winkler that wrote a file; empty if the file does not tell."""
    try:
        found = read_arrays(path, ("version",), wrong="no version can be read from it", remedy="give another file")
    except InvalidInput:
        return ""
    return str(found.get("version", ""))


def write_arrays(path: Path, arrays: Mapping[str, Array]) -> None:
    """Write arrays beside the file, and then put them in its place.

    Raises
    ------
    InvalidInput
        If there is no such folder, or its file cannot be written.
    """
    with written_whole(path) as file:
        np.savez(file, allow_pickle=False, version=np.array(version("winkler")), **arrays)
