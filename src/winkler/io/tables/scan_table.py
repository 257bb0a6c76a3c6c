"""Scans along a line in tables: a place and a height in every row, as a stylus instrument writes them."""

from __future__ import annotations

import os

from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, read_table
from winkler.profiles.rough.line_scan import LineScan

__all__ = ["is_scan", "read_scan"]

PLACE_COLUMN = Column("place", ("place", "position", "x", "lateral", "distance", "scan"), "m", "um")
HEIGHT_COLUMN = Column("height", ("height", "heights", "z", "h", "raw", "profile", "level"), "m", "nm")


def is_scan(path: str | os.PathLike[str]) -> bool:
    """Return whether the header of a table names places and heights.

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    return names_columns(path, (PLACE_COLUMN, HEIGHT_COLUMN))


@reader("a scan")
def read_scan(path: str | os.PathLike[str]) -> LineScan:
    """Read a scan along a line from a table with the columns place (x, lateral, ...) and height (z, raw, ...).

    Parameters
    ----------
    path : str or path
        The file.  Units stand in its header, as in ``x [um], z [nm]`` or ``Lateral um,Raw Micrometer``; what
        instruments write above it is skipped, and other columns are ignored.

    Returns
    -------
    LineScan

    Raises
    ------
    InvalidInput
        If the file cannot be read, or what it holds is no scan.
    """
    table = read_table(path, (PLACE_COLUMN, HEIGHT_COLUMN))
    with in_file(table.path):
        return LineScan(*table.values.T)
