"""Scans along a line in files of instruments, read by SurfaceTopography (extra ``topography``)."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from winkler.io.surfaces.instrument_channels import channel_contents
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS


class ScanContents(NamedTuple):
    """Line scan as a file holds it.

    Parameters
    ----------
    position, heights
        In the unit below; nan where heights are missing.
    unit
        Of both; empty where the file does not state it.
    """

    position: Array
    heights: Array
    unit: str


def instrument_scan(path: Path, channel: str) -> ScanContents:
    """Return a line scan of an instrument's file or of a published container.

    Parameters
    ----------
    path : path
        The file.
    channel : str
        Name of one of several channels or measurements; the first if empty.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed or cannot read the file, or the file holds no such scan.
    """
    return channel_contents(path, channel, 1, _refuse_many, _contents)


def _refuse_many(count: int, path: Path) -> None:
    if count > MOST_NUMBERS:
        raise InvalidInput(f"{path}: there are {count} heights; at most {MOST_NUMBERS} are read: save a part of them.")


def _contents(surface: Any) -> ScanContents:
    found: list[Array] = [
        np.ma.filled(np.ma.asarray(part, dtype=float), np.nan) for part in surface.positions_and_heights()
    ]
    place, height = np.asarray(found[0]), np.asarray(found[1])
    return ScanContents(place, height, str(surface.unit or ""))
