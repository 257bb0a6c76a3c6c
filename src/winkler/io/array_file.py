"""Arrays in NumPy files, ``.npy`` and ``.npz``: read within limits, written atomically with what wrote them."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import IO, Any

import numpy as np

from winkler.io.archive_file import archive, is_archive
from winkler.io.foreign import sentence_of
from winkler.io.software import software
from winkler.io.text_file import existing
from winkler.io.whole_file import write_whole
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS

MOST_ARRAYS = 1000
"""Arrays in a file."""
HEADER_BYTES = 20_000
"""Bytes of the header of an array; numpy refuses more than 10,000, but only after it has read them."""
TEXT_ITEM_BYTES = 1000
"""Bytes of a text in an array."""
MOST_NAMES_LISTED = 20
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

    Shapes and types, which stand in the headers, are checked first; objects and tables of records are refused.

    Parameters
    ----------
    path : str or path
        The file; its first bytes state its kind.
    words : iterable of str
        Names of the arrays to read, where the file has them.
    needed : iterable of str, optional
        Names that the file must have.
    missing : str, optional
        Error text if one of them is missing.
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
        with archive(path, path, wrong=wrong, remedy=remedy, members=MOST_ARRAYS) as pack:
            names = {one.filename.removesuffix(".npy"): one for one in pack.infolist()}
            absent = [word for word in needed if word not in names]
            if absent:
                listed = ", ".join(list(names)[:MOST_NAMES_LISTED]) or "nothing"
                raise InvalidInput(f"{path}: it holds {listed}; {missing or f'{wrong} without {absent[0]}; {remedy}'}.")
            contents, left = {}, MOST_NUMBERS
            for word in words:
                if word in names:
                    with pack.open(names[word]) as stored:
                        contents[word] = _array(stored, names[word].file_size, path, f"'{word}'", left)
                    left -= contents[word].size
            return contents


def _array(file: IO[bytes], size: int, path: Path, name: str, left: int = MOST_NUMBERS) -> Array:
    """Return one array, if its stated shape and type fit the size of the file [bytes] and the numbers still allowed."""
    form = np.lib.format
    if not size:
        raise ValueError("No data left in file")
    start = io.BytesIO(file.read(HEADER_BYTES))
    form_version = form.read_magic(start)
    if form_version not in ((1, 0), (2, 0)):
        raise ValueError(f"the version {form_version[0]}.{form_version[1]} of the format is for tables of records")
    shape, _, kind = (form.read_array_header_1_0 if form_version == (1, 0) else form.read_array_header_2_0)(start)
    count = math.prod(shape)
    if kind.hasobject:
        raise ValueError("Object arrays cannot be loaded")
    if (
        count > left
        or count * kind.itemsize > 8 * MOST_NUMBERS
        or (kind.kind in "SU" and kind.itemsize > TEXT_ITEM_BYTES)
    ):
        raise InvalidInput(
            f"{path}: {name} has the shape {shape} and the type {kind}; at most {MOST_NUMBERS} numbers are read from "
            "a file: save a part of it."
        )
    if count * kind.itemsize > size:
        raise ValueError(f"the shape {shape} needs more bytes than the file has")
    file.seek(0)
    return np.asarray(form.read_array(file, allow_pickle=False))


def software_of(path: Path) -> dict[str, str]:
    """Return the software that wrote a file, as `winkler.io.software.software`; empty if the file does not state it."""
    try:
        contents = read_arrays(path, ("software",), wrong="its origin cannot be read", remedy="give another file")
        return dict(contents["software"].tolist())
    except (InvalidInput, KeyError, TypeError, ValueError):
        return {}


def write_arrays(path: Path, arrays: Mapping[str, Array]) -> None:
    """Write arrays to a temporary file, which then replaces the file.

    Raises
    ------
    InvalidInput
        If there is no such folder, or its file cannot be written.
    """
    store = io.BytesIO()  # on a full disk NumPy's archive would report errors by itself
    np.savez(store, allow_pickle=False, software=np.array(list(software().items())), **arrays)
    write_whole({path: store.getbuffer()})


def write_state(path: str | os.PathLike[str], form: str, arrays: Mapping[str, Any]) -> Path:
    """Write arrays with the name of their format; return the path.

    Raises
    ------
    InvalidInput
        If there is no such folder, or its file cannot be written.
    """
    write_arrays(Path(path), {"format": np.array(form), **arrays})
    return Path(path)


def read_state(
    path: str | os.PathLike[str], form: str, words: Iterable[str], *, needed: Iterable[str], what: str
) -> dict[str, Array]:
    """Return the arrays that `write_state` wrote.

    Parameters
    ----------
    path : str or path
        The file.
    form : str
        The name of its format.
    words, needed : iterable of str
        As for `read_arrays`.
    what : str
        What the file holds: "contacts", as ``write_contacts`` writes them.

    Raises
    ------
    InvalidInput
        If the file is missing, broken, or of another format.
    """
    wrong, remedy = f"no {what} can be read from it", f"give a file of write_{what}"
    arrays = read_arrays(path, ("format", *words), needed=("format", *needed), wrong=wrong, remedy=remedy)
    if str(arrays.pop("format")) != form:
        raise InvalidInput(f"{path}: it does not hold '{form}'; give one that this version wrote.")
    return arrays
