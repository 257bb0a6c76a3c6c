"""Height maps in the files of instruments, read by SurfaceTopography (extra ``topography``)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from winkler.io.height_matrix import MapContents, refuse_many
from winkler.io.surfaces.instrument_channels import channel_contents, tip_radius_of
from winkler.numerics.types import Array

__all__ = ["instrument_map"]


def instrument_map(path: Path, channel: str) -> MapContents:
    """Return a height map of an instrument's file, or of a container of contact.engineering.

    Parameters
    ----------
    path : path
        The file.
    channel : str
        Name of one of several channels or measurements; the first if empty.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed or cannot read the file, or the file holds no such map.
    """
    return channel_contents(path, channel, 2, refuse_many, _contents)


def _contents(surface: Any) -> MapContents:
    heights: Array = np.ma.filled(np.ma.asarray(surface.heights(), dtype=float), np.nan)
    sizes = [np.nan if size is None else float(size) for size in surface.physical_sizes or (None, None)]
    return MapContents(
        heights, np.array(sizes), str(surface.unit or ""), bool(surface.is_periodic), *tip_radius_of(surface)
    )
