"""Scans along a line in tables: a place and a height in every row, as a stylus instrument writes them."""

from __future__ import annotations

import dataclasses
import math
import os
from pathlib import Path

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.surfaces.instrument_scan import instrument_scan
from winkler.io.tables.header import bare_columns, names_columns
from winkler.io.tables.table import Column, read_table
from winkler.io.text_file import existing
from winkler.profiles.rough.line_scan import LineScan
from winkler.values.errors import InvalidInput
from winkler.values.units import scale

PLACE_COLUMN = Column(
    "place", ("place", "position", "x", "lateral", "distance", "scan", "abstand", "distancia"), "m", "um"
)
HEIGHT_COLUMN = Column(
    "height",
    ("height", "heights", "z", "h", "raw", "profile", "level", "y", "y1", "höhe", "hauteur", "altura", "altezza"),
    "m",
    "nm",
)

TEXT_ENDINGS = {"", ".csv", ".txt", ".asc", ".dat", ".tsv", ".xy", ".xyz"}
"""Files that are tables, unless two columns without a header; their errors are those of tables."""
PAIR = 2
"""Columns of places and heights without names."""
SPREADSHEETS = {".xls", ".xlsx", ".ods"}


def is_scan(path: str | os.PathLike[str]) -> bool:
    """Return whether a file is no table, or the header of a table names places and heights.

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    try:
        return names_columns(path, (PLACE_COLUMN, HEIGHT_COLUMN))
    except InvalidInput:
        if existing(path, "a scan").suffix.lower() in (TEXT_ENDINGS | SPREADSHEETS):
            raise
        return True  # no text: a file of an instrument


@reader("a scan")
def read_scan(path: str | os.PathLike[str], *, unit: str = "", channel: str = "", length: float = 0.0) -> LineScan:
    """Read a scan along a line from a table, a file of an instrument, or a published container.

    Parameters
    ----------
    path : str or path
        A table with the columns place (x, lateral, ...) and height (z, raw, ...): its header contains units, as in ``x
        [um], z [nm]`` or ``Lateral um,Raw Micrometer``. Text of instruments above the header is skipped; other columns
        are ignored.  Or a file with a line scan that SurfaceTopography reads (extra ``topography``): OPDx, Mitutoyo
        and others, two columns of numbers without a header; or a container (zip) of contact.engineering.
    unit : str, optional
        Unit of positions and heights, such as um, for an instrument's file or two plain columns without units. Give
        two units, such as "mm, um", if they differ.
    channel : str, optional
        Name of one of several scans in a file, or of a measurement in a container; the first by default. With
        `length`: name of the column of heights.
    length : float, optional
        Distance from the first to the last height [m], for a table of evenly spaced heights without positions.

    Returns
    -------
    LineScan

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it does not contain a scan.
    """
    file = existing(path, "a scan")
    if length:
        return _evenly(file, unit, channel, length)
    try:
        table = read_table(file, (PLACE_COLUMN, HEIGHT_COLUMN))
    except InvalidInput as reason:
        return _measured(file, unit, channel) if unit or channel else _no_table(file, reason)
    if unit or channel:
        wrong = f"unit {unit!r}" if unit else f"channel {channel!r}"
        raise InvalidInput(f"{file}: a table states its columns and their units; leave {wrong} out.")
    with in_file(table.path):
        return LineScan.measured(*table.values.T)


def _evenly(path: Path, unit: str, channel: str, length: float) -> LineScan:
    """Return the scan of a column of heights at equal steps."""
    if not 0.0 < length < math.inf:
        raise InvalidInput(f"{path}: the length of its scan is {length:g} m; give a positive one.")
    names = (channel.lower(),) if channel else HEIGHT_COLUMN.names
    column = dataclasses.replace(HEIGHT_COLUMN, names=names)
    try:
        table = read_table(path, (column,), units={column.word: unit} if unit else {})
    except InvalidInput as error:
        hint = "" if channel else "; or give channel, the name of another column of heights"
        raise error.reworded(lambda one: f"{one.rstrip('.')}{hint}.") from None
    heights = table.values[:, 0]
    with in_file(table.path):
        return LineScan.measured(np.linspace(0.0, length, heights.size), heights)


def _no_table(path: Path, reason: InvalidInput) -> LineScan:
    """Return the scan of another file than a table; instruments write texts too: raise why such a text is no table."""
    suffix = path.suffix.lower()
    if suffix in TEXT_ENDINGS and bare_columns(path) == PAIR:
        raise InvalidInput(f"{str(reason).rstrip('.')}, or give its unit, such as unit = 'um'.") from None
    try:
        return _measured(path, "", "")
    except InvalidInput as error:
        if suffix in SPREADSHEETS and "does not state the unit" not in str(error):
            raise reason from None
        raise (reason if suffix in TEXT_ENDINGS else error) from None


def _measured(path: Path, unit: str, channel: str) -> LineScan:
    places, _, heights = (part.strip() for part in unit.partition(","))
    if unit and not channel and path.suffix.lower() in TEXT_ENDINGS and bare_columns(path) == PAIR:
        columns = (PLACE_COLUMN, HEIGHT_COLUMN)
        stated = dict(zip((one.word for one in columns), (places, heights or places), strict=True))
        numbers = {one.word: place for place, one in enumerate(columns, start=1)}
        table = read_table(path, columns, units=stated, numbers=numbers)
        with in_file(path):
            return LineScan.measured(*table.values.T)
    contents = instrument_scan(path, channel)
    if contents.unit and unit:
        raise InvalidInput(f"{path}: the file states its unit, {contents.unit}, and {unit} was given; leave it out.")
    if not (contents.unit or unit):
        raise InvalidInput(f"{path}: the file does not state the unit of its scan; give unit, such as 'um'.")
    along, up = (scale(contents.unit or one, "m", what=f"{path}, unit") for one in (places, heights or places))
    with in_file(path):
        return LineScan.measured(contents.position * along, contents.heights * up)
