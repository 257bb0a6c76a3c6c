"""Height maps in the files of instruments, read by SurfaceTopography (extra ``topography``)."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.io.archive_file import is_archive, refuse_large_archive
from winkler.io.foreign import quiet, sentence_of
from winkler.io.hdf5_file import refuse_other_files
from winkler.io.height_matrix import MapContents, refuse_many
from winkler.io.memory import limited_memory
from winkler.io.text_file import refuse_large
from winkler.limits import FILE_BYTES
from winkler.numerics.types import Array

__all__ = ["instrument_map"]


def instrument_map(path: Path, channel: str) -> MapContents:
    """Return a height map of an instrument's file.

    Parameters
    ----------
    path : path
        The file.
    channel : str
        Name of one of several channels; the first if empty.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed or cannot read the file, or the file holds no such map.
    """
    try:
        from SurfaceTopography.IO import open_topography
    except ImportError:
        raise InvalidInput(
            f"{path}: files of instruments are read by SurfaceTopography; install it by "
            'pip install "winkler[topography]".'
        ) from None
    refuse_large(path, FILE_BYTES)
    wrong, remedy = "SurfaceTopography cannot read this file", "save it as an NPY file or as a text"
    with quiet(), sentence_of(path, wrong, remedy), limited_memory(path):
        if is_archive(path):
            refuse_large_archive(path, "save the map as an NPY file")
        refuse_other_files(path)
        reader = open_topography(str(path))
        # other signals than heights have a pair of units, or none
        maps = [
            signal
            for signal in reader.channels
            if signal.dim == 2 and signal.is_height_channel is not False and isinstance(signal.unit, str | None)
        ]
        names = [str(signal.name) for signal in maps]
        if not maps:
            raise InvalidInput(
                f"{path}: it holds no height map, but {_contents_text(reader.channels)}; give another file."
            )
        if channel and channel not in names:
            raise InvalidInput(
                f"{path}: there is no height channel {channel!r}{suggest(channel, names)}; give one of "
                f"{', '.join(names)}."
            )
        chosen = maps[names.index(channel) if channel else 0]
        refuse_many(math.prod(int(n) for n in chosen.nb_grid_pts or (0,)), path)
        surface = chosen.topography()
        heights: Array = np.ma.filled(np.ma.asarray(surface.heights(), dtype=float), np.nan)
        sizes = [np.nan if size is None else float(size) for size in surface.physical_sizes or (None, None)]
    return MapContents(heights, np.array(sizes), str(surface.unit or ""), bool(surface.is_periodic))


def _contents_text(channels: list[object]) -> str:
    lines = sum(getattr(signal, "dim", 0) == 1 for signal in channels)
    if not channels:
        return "nothing"
    return "line scans" if lines == len(channels) else "other signals"
