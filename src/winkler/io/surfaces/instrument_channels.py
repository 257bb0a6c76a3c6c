"""Height maps and line scans in files of instruments, opened by SurfaceTopography (extra ``topography``)."""

from __future__ import annotations

import contextlib
import math
import re
import tempfile
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.lib.format import MAGIC_PREFIX

from winkler.io.archive_file import archive, is_archive, member, refuse_large_archive
from winkler.io.foreign import quiet, sentence_of
from winkler.io.hdf5_file import refuse_other_files
from winkler.io.memory import limited_memory
from winkler.io.surfaces.surface_container import contained_surface, is_container
from winkler.io.text_file import UTF16_MARKS, content_of, of_other_program, refuse_large
from winkler.values.errors import InvalidInput, suggest
from winkler.values.limits import FILE_BYTES

T = TypeVar("T")

CONTENTS = {1: ("line scan", "height maps"), 2: ("height map", "line scans")}
"""What is looked for, and what else there may be."""
REMEDIES = {1: "save it as a table with the columns place and height", 2: "save it as an NPY file or as a text"}
"""How else scans and maps are read."""
LOG_CELLS, LOG_LINES, HEAD_BYTES = (3, 32), 1000, 20_000
"""Numbers in a row, and rows, of a table that is no map (points on a grid are read before), and the part of a text that
is looked at."""
PLAIN_NUMBER = re.compile(rb"[-+0-9.,eE]{1,40}|nan", re.IGNORECASE)
"""A cell of a log."""
SDF = b"aISO-"
"""How a text of ISO 25178-71 begins, which holds a map in rows of any length."""
UNMARKED = "HGTReader"
"""It takes any file of 2 n^2 bytes for a map of n x n heights."""


def channel_contents(
    path: Path, channel: str, directions: int, refuse: Callable[[int, Path], None], contents: Callable[[Any], T]
) -> T:
    """Return the contents of one channel of an instrument's file, or of one measurement of a published container.

    Parameters
    ----------
    path : path
        The file.
    channel : str
        Name of one of several channels or measurements; the first if empty.
    directions : int
        2 for height maps, 1 for line scans.
    refuse : callable
        Refuses a number of heights that is too large, before they are read.
    contents : callable
        Takes the object of SurfaceTopography, of which nothing is read yet.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed or cannot read the file, or there is no such channel.
    """
    refuse_large(path, FILE_BYTES)
    what, _ = CONTENTS[directions]
    wrong, remedy = "SurfaceTopography cannot read this file", REMEDIES[directions]
    if not is_archive(path) and not is_container(path) and _is_log(path):  # it loads for seconds
        raise InvalidInput(f"{path}: {wrong} (its rows are those of a log, no {what}); {remedy}.")
    try:
        with quiet():  # it warns where the library for many processes is not installed
            from SurfaceTopography.IO import CannotDetectFileFormat, open_topography
    except ImportError:
        raise InvalidInput(
            f"{path}: files of instruments are read by SurfaceTopography; install it by "
            'pip install "winkler[topography]".'
        ) from None
    with quiet(), sentence_of(path, wrong, remedy), limited_memory(path), readable_copy(path) as copy:
        if is_archive(path):
            refuse_large_archive(path, "save the map as an NPY file")
        if is_container(path):
            surface = contained_surface(path, channel, directions)
            refuse(math.prod(int(n) for n in surface.nb_grid_pts), path)
            return contents(surface)
        refuse_other_files(path)
        _refuse_cut_array(path)
        try:
            file = open_topography(str(copy))
            opened = file.channels
        except CannotDetectFileFormat:  # its message lists what each of its formats missed, in words of NumPy
            other = of_other_program(content_of(path, FILE_BYTES, start=HEAD_BYTES)) or _of_x3p(path)
            if other:
                raise InvalidInput(f"{path}: this is {other}.") from None
            raise InvalidInput(f"{path}: {wrong} (none of its formats fits); {remedy}.") from None
        along = [signal for signal in opened if signal.dim == directions]
        # other signals than heights have a pair of units, or none
        fitting = [
            signal for signal in along if signal.is_height_channel is not False and isinstance(signal.unit, str | None)
        ]
        names = [str(signal.name) for signal in fitting]
        if not fitting:
            raise InvalidInput(f"{path}: it holds no {what}, but {_others(opened, directions)}.")
        if channel and channel not in names:
            raise InvalidInput(
                f"{path}: there is no height channel {channel!r}{suggest(channel, names)}; give one of "
                f"{', '.join(names)}."
            )
        chosen = fitting[names.index(channel) if channel else 0]
        grid = [int(n) for n in chosen.nb_grid_pts or (0,)]
        refuse(math.prod(grid), path)
        if directions == 2 and min(grid) < 2:
            raise InvalidInput(
                f"{path}: it holds a row of {math.prod(grid)} numbers without their places, neither a map nor a scan; "
                f"{REMEDIES[1]}."
            )
        if chosen.physical_sizes is None:
            if directions == 1 or type(file).__name__ == UNMARKED:
                raise InvalidInput(f"{path}: the file does not state how long its {what} is; {remedy}.")
            return contents(chosen.topography(physical_sizes=(math.nan, math.nan)))  # the caller asks for them
        # without a unit nothing is converted; where it is missing, the caller asks for it
        return contents(chosen.topography())


def tip_radius_of(surface: Any) -> tuple[float, str]:
    """Return the radius of the tip that a file states, and its unit; zero if it states none."""
    try:
        stated = surface.info["instrument"]["parameters"]["tip_radius"]
        radius, unit = float(stated["value"]), str(stated["unit"])
    except (KeyError, TypeError, ValueError):
        return 0.0, ""
    return (radius, unit) if math.isfinite(radius) and radius > 0.0 else (0.0, "")


def _others(channels: list[Any], directions: int) -> str:
    _, others = CONTENTS[directions]
    same = sum(getattr(signal, "dim", 0) == 3 - directions for signal in channels)
    if not channels:
        return "nothing; give another file"
    if same < len(channels):
        return "other signals; give another file"
    return f"{others}; read them with {'read_scan' if directions == 2 else 'read_topography'}, or give another file"


def _is_log(path: Path) -> bool:
    """Return whether a text is a long table of some columns, or of two with other rows among them.

    SurfaceTopography would read such a text anew below each of its first lines.
    """
    with path.open("rb") as file:
        head = file.read(HEAD_BYTES)
    is_wide = head.startswith(UTF16_MARKS)
    if not head or (b"\x00" in head and not is_wide) or head.startswith(SDF):
        return False
    if head.count(b"\n") * path.stat().st_size < LOG_LINES * len(head):
        return False
    content = content_of(path, FILE_BYTES)
    content = content.decode("utf-16", "replace").encode() if is_wide else content
    lines = [line.rstrip() for line in content.splitlines()]
    marks = (b",", b";", b"\t", None)
    mark = max(marks, key=lambda one: sum(len(line.split(one)) for line in lines[LOG_LINES // 2 : LOG_LINES // 2 + 20]))
    row = lines[LOG_LINES // 2].split(mark)
    count = sum(PLAIN_NUMBER.fullmatch(cell.strip(b'" \t')) is not None for cell in row)
    low, high = LOG_CELLS
    if count != low - 1:
        return low <= count <= high
    return any(line and len(line.split(mark)) != len(row) for line in lines[LOG_LINES // 2 :])


def _of_x3p(path: Path) -> str:
    """Return why an X3P is not read, and what to do; nothing of other files."""
    if path.suffix.lower() != ".x3p" or not is_archive(path):
        return ""
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
    if X3P_HEAD in names and not any(name.endswith(".bin") for name in names):
        return f"an X3P whose heights stand in its {X3P_HEAD}; save it anew with binary data, or as text"
    return ""


def _refuse_cut_array(path: Path) -> None:
    """Refuse a file of NumPy whose header or numbers end early: SurfaceTopography would read on without end."""
    with path.open("rb") as file:
        if file.read(len(MAGIC_PREFIX)) != MAGIC_PREFIX:
            return
    np.load(path, mmap_mode="r", allow_pickle=False)


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
