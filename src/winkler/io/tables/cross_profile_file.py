"""Profiles of wheels, rails and other bodies in files: tables, Simpack's .prr and .prw, and MiniProf's texts."""

from __future__ import annotations

import math
import os
import re
from pathlib import Path

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.tables.table import Column, read_table
from winkler.io.tables.table_cells import number_in
from winkler.io.text_file import existing, lines_of
from winkler.numerics.types import Array
from winkler.profiles.sections.cross_profile import CrossProfile
from winkler.values.errors import InvalidInput

ACROSS = Column("place across", ("y", "x", "lateral"), "m", "mm")
UP = Column("height", ("z", "height", "vertical"), "m", "mm")
KEY = re.compile(r"\s*+([A-Za-z][\w.]*+)\s*+=\s*+(.*)")
MILLIMETRE = 1e-3


@reader("a profile across")
def read_cross_profile(
    path: str | os.PathLike[str], *, down: bool = False, mirrored: bool = False, smoothing: float = 0.0, unit: str = ""
) -> CrossProfile:
    """Read a profile across the direction of rolling.

    Parameters
    ----------
    path : str or path
        A table with the columns y (x, lateral) and z (height, vertical), whose header names the units, points in order
        along the profile; a profile of Simpack (.prr, .prw), with its shifts, mirrors, bounds and unit; or a text of
        MiniProf (.ban, .whl), whose columns X and Y are in mm.
    down : bool, optional
        Whether z counts downwards in the file, as usual for rails and wheels.
    mirrored : bool, optional
        Whether to change the sign of y.
    smoothing : float, optional
        As in `CrossProfile` [m].
    unit : str, optional
        Unit of both columns, such as mm, for files with y and z in the first two columns and no header.

    Returns
    -------
    CrossProfile

    Raises
    ------
    InvalidInput
        If the file cannot be read, its unit is not stated, or it is rotated.
    """
    file = existing(path, "a profile across")
    lines = lines_of(file, "columns y and z")
    low = [line.strip().lower() for line in lines]
    if any(line.startswith("point.begin") for line in low):
        points = _simpack(file, lines)
    elif any(line.startswith(("columndef=", "xypoints=")) for line in low):
        points = _miniprof(file, lines)
    else:
        points = _table(file, unit)
        unit = ""
    if unit:
        raise InvalidInput(f"{file}: such a file states its unit; leave unit {unit!r} out.")
    with in_file(file):
        return CrossProfile(
            -points[:, 0] if mirrored else points[:, 0], -points[:, 1] if down else points[:, 1], smoothing
        )


def _table(file: Path, unit: str) -> Array:
    """Return the columns of a table with a header, or the first two of one without."""
    try:
        table = read_table(file, (ACROSS, UP))
    except InvalidInput as reason:
        if unit:
            return read_table(file, (ACROSS, UP), stated=f"y [{unit}], z [{unit}]").values
        hint = "; where its first columns are y and z without names, give unit, such as unit = 'mm'."
        raise reason.reworded(lambda one: one.rstrip(".") + hint) from None
    if unit:
        raise InvalidInput(f"{file}: a table states its columns and their units; leave unit {unit!r} out.")
    return table.values


def _numbers(file: Path, rows: list[tuple[int, str]], places: tuple[int, int]) -> Array:
    """Return two columns of numbered lines."""
    found = []
    for number, line in rows:
        cells = line.replace('"', " ").replace(",", " ").split()
        if len(cells) <= max(places):
            raise InvalidInput(f"{file}, line {number}: there are {len(cells)} numbers; give y and z.")
        where = f"{file}, line {number}"
        found.append([number_in(cells[place], where, "is not a number") for place in places])
    points = np.array(found, dtype=float).reshape(-1, 2)
    if not np.all(np.isfinite(points)):
        raise InvalidInput(f"{file}: a number of the profile is not finite; complete or delete its line.")
    return points


def _simpack(file: Path, lines: list[str]) -> Array:
    keys: dict[str, str] = {}
    rows: list[tuple[int, str]] = []
    inside = False
    for number, raw in enumerate(lines, 1):
        line = raw.partition("!")[0].strip()
        if line.lower() == "point.begin":
            inside = True
        elif line.lower() == "point.end":
            inside = False
        elif inside and line:
            rows.append((number, line))
        elif match := KEY.match(line):
            keys[match[1].lower()] = match[2].strip()

    def stated(name: str, default: float) -> float:
        return number_in(keys[name], str(file), f"at {name} is not a number") if name in keys else default

    per_metre = stated("units.len.f", math.nan)
    if not per_metre > 0.0:
        raise InvalidInput(f"{file}: the unit is not stated; add units.len.f = 1000 for mm, or 1 for m.")
    if stated("rotate", 0.0) != 0.0:
        raise InvalidInput(f"{file}: the profile is to be rotated, which is not done here; save the rotated points.")
    points = _numbers(file, rows, (0, 1)) + np.array([stated("shift.y", 0.0), stated("shift.z", 0.0)])
    for axis, name in enumerate("yz"):
        least, most = stated(f"bound.{name}.min", 1.0), stated(f"bound.{name}.max", 0.0)
        if least < most:
            points = points[(points[:, axis] >= least) & (points[:, axis] <= most)]
        if stated(f"mirror.{name}", 0.0) == 1.0:
            points[:, axis] *= -1.0
    return np.asarray(points / per_metre)


def _miniprof(file: Path, lines: list[str]) -> Array:
    columns = ["X", "Y"]
    rows = []
    for number, line in enumerate(lines, 1):
        if match := KEY.match(line):
            if match[1].lower() == "columndef":
                columns = [name.strip().upper() for name in match[2].split(",")]
        elif line.strip() and not line.lstrip().startswith(("!", "#")):
            rows.append((number, line))
    if not {"X", "Y"} <= set(columns):
        raise InvalidInput(f"{file}: ColumnDef names {', '.join(columns)}; columns X and Y are needed.")
    return np.asarray(MILLIMETRE * _numbers(file, rows, (columns.index("X"), columns.index("Y"))))
