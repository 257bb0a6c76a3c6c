r"""Force curves in text tables: position or depth, force or deflection, and the time where it is known.

Exports of nanoindenters (depth and load) are such tables as well, and those of indenters with a cantilever, whose
stiffness stands above the table as ``k (N/m)``.
"""

from __future__ import annotations

import math
import os
import re
from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.curve import ForceCurve
from winkler.io.foreign import in_file
from winkler.io.segments import directions
from winkler.io.tables.table import Column, names_columns, read_table
from winkler.io.text_file import head_of
from winkler.units import comma_hint

__all__ = ["is_curve_table", "read_curve_table"]

POSITION = Column("position", ("position", "piezo", "stage", "z", "displacement", "travel", "z-piezo"), "m", "nm")
DEPTH = Column("depth", ("depth", "indentation", "penetration", "d", "h"), "m", "nm")
FORCE = Column("force", ("force", "load", "f", "p", "normal force"), "N", "nN")
DEFLECTION = Column("deflection", ("deflection", "cantilever", "defl"), "m", "nm")
VOLTAGE = Column("deflection", ("deflection", "voltage", "vertical deflection", "defl"), "V")
TIME = Column("time", ("time", "t"), "s")
SEGMENT = Column("segment", ("segment",), "")
SPRING_CONSTANT_LINE = re.compile(
    r"\s*+(?:k|spring constant)\s*+[\[(]N/m[\])]\s*+(?:[:=]\s*+)?([0-9.,eE+-]{1,100}+)\s*+"
)


def is_curve_table(path: str | os.PathLike[str]) -> bool:
    """Return whether the header of a text names a position or depth and a force or deflection.

    Raises
    ------
    InvalidInput
        If the file cannot be read as text.
    """
    return any(
        names_columns(path, (place, load)) for place in (POSITION, DEPTH) for load in (FORCE, DEFLECTION, VOLTAGE)
    )


def read_curve_table(
    path: str | os.PathLike[str], *, spring_constant: float | None = None, sensitivity: float | None = None
) -> ForceCurve:
    """Read a force curve from a text table.

    Parameters
    ----------
    path : str or path
        The file; its header names columns and units, as in ``piezo [nm], force [nN], time [s]``.  A column ``segment``
        numbers the segments in which the tip approaches, is held, and retracts; without it the tip approaches up to the
        largest position, and then retracts.
    spring_constant : float, optional
        Of the cantilever [N/m].  With a column ``depth`` it is not needed: that is the travel of the tip itself.
    sensitivity : float, optional
        Deflection per volt [m/V], where the table holds the detector's voltage.

    Returns
    -------
    ForceCurve

    Raises
    ------
    InvalidInput
        If columns, units or numbers are missing; the message names the line.
    """
    place, load = _place(path, prefer_position=spring_constant is not None), _load(path)
    if place is None or load is None or not is_curve_table(path):
        raise InvalidInput(
            f"{path}: there is no table of a force curve in this text; it needs one line that names a {DEPTH.word} "
            f"({', '.join(DEPTH.names)}) or {POSITION.word} ({', '.join(POSITION.names)}) and a {FORCE.word} "
            f"({', '.join(FORCE.names)}) with units, as in '{DEPTH.example}, {FORCE.example}', and numbers below."
        )
    has_time = names_columns(path, (place, load, TIME))
    has_segments = names_columns(path, (place, load, SEGMENT))
    table = read_table(path, (place, load, *(TIME,) * has_time, *(SEGMENT,) * has_segments))
    stiffness = _stiffness(path, spring_constant)
    force = table.values[:, 1]
    if load is not FORCE:
        if stiffness is None:
            raise InvalidInput(
                f"{path}: the table holds a deflection but no force; give spring_constant in N/m, which makes it one."
            )
        if load is VOLTAGE and sensitivity is None:
            raise InvalidInput(f"{path}: the deflection is a voltage; give sensitivity, deflection per volt in m/V.")
        force = force * stiffness * (sensitivity if load is VOLTAGE and sensitivity is not None else 1.0)
    if place is POSITION and stiffness is None:
        raise InvalidInput(
            f"{path}: the table holds a position ({', '.join(POSITION.names[:3])} ...) and so the depth needs the "
            "bending of the cantilever; give spring_constant in N/m, infinite where the position is the travel of the "
            "tip itself."
        )
    machine = stiffness if place is POSITION and stiffness is not None else math.inf
    position = table.values[:, 0]
    time = table.values[:, 2] if has_time else np.zeros(0)
    segment = table.values[:, -1] if has_segments else np.zeros(0)
    with in_file(path):
        return ForceCurve(position, force, machine, time, directions(position, force, segment), Path(path).name)


def _place(path: str | os.PathLike[str], *, prefer_position: bool = False) -> Column | None:
    """Return the column of the tip's position; a piezo with a stated cantilever precedes the instrument's own depth."""
    position, depth = (names_columns(path, (column,)) for column in (POSITION, DEPTH))
    if position and (prefer_position or not depth or _stated_cantilever(path) is not None):
        return POSITION
    return DEPTH if depth else None


def _load(path: str | os.PathLike[str]) -> Column | None:
    if names_columns(path, (FORCE,)):
        return FORCE
    for column in (DEFLECTION, VOLTAGE):
        if names_columns(path, (column,)):
            try:
                read_table(path, (column,))
            except InvalidInput:
                continue
            return column
    return DEFLECTION if names_columns(path, (DEFLECTION,)) else None


def _stiffness(path: str | os.PathLike[str], given: float | None) -> float | None:
    if given is None:
        return _stated_cantilever(path)
    if isinstance(given, bool) or not isinstance(given, int | float) or not given > 0.0:
        raise InvalidInput(f"{path}: spring_constant is {given!r}; it must be positive, in N/m.")
    return float(given)


def _stated_cantilever(path: str | os.PathLike[str]) -> float | None:
    """Return the spring constant [N/m] that stands above the table, if one does."""
    stated_line = next(
        (match for line in head_of(path, "a table") if (match := SPRING_CONSTANT_LINE.fullmatch(line))), None
    )
    if stated_line is None:
        return None
    if "," in stated_line[1]:
        raise InvalidInput(f"{path}: the spring constant '{stated_line[1]}' has {comma_hint(stated_line[1])}.")
    try:
        stated = float(stated_line[1])
    except ValueError:
        stated = math.nan
    if not 0.0 < stated < math.inf:
        raise InvalidInput(
            f"{path}: the spring constant '{stated_line[1]}' is no positive number; correct it in the file."
        )
    return stated
