r"""Force curves in text tables: position or depth, force or deflection, and the time where it is known.

Exports of nanoindenters (depth and load) are such tables as well, and those of indenters with a cantilever, whose
stiffness stands above the table as ``k (N/m)``. Lines ``x [um]: 3.5`` and ``y [um]: 2`` there state the place on the
sample.
"""

from __future__ import annotations

import dataclasses
import math
import os
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.io.continuous_loading import (
    HARDNESS_NAMES,
    YOUNG_NAMES,
    StatedResults,
    loading_stiffness,
    stated_results,
    stiffness_fact,
)
from winkler.io.curve_columns import (
    CROSSHEAD_NAMES,
    DEPTH_NAMES,
    FORCE_NAMES,
    POSITION_NAMES,
    STIFFNESS_NAMES,
    TIME_NAMES,
    by_preference,
)
from winkler.io.foreign import in_file
from winkler.io.placed_curves import PlacedCurve, name_of_test, reading_of
from winkler.io.segments import directions, segment_fact
from winkler.io.swapped_columns import is_reversed, refuse_list, signs
from winkler.io.tables.given_units import GivenFacts
from winkler.io.tables.header import SEPARATORS_TRIED, header_lines, names_columns, names_seen
from winkler.io.tables.several_tests import parts_by_headers, parts_of_tests
from winkler.io.tables.table import Column, Table, read_table
from winkler.io.tables.table_cells import cells_of, named
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.units import comma_hint, scale

POSITION = Column("position", POSITION_NAMES, "m", "nm")
DEPTH = Column("depth", DEPTH_NAMES, "m", "nm")
GAP = Column(
    "gap", ("gap", "spalt", "tool separation", "werkzeugabstand", "ecartement entre outils", "écartement entre outils"),
    "m", "mm",
)  # fmt: skip
"""Distance of the plates of a rheometer: it falls as they approach."""
FORCE = Column("force", FORCE_NAMES, "N", "nN")
DEFLECTION = Column("deflection", ("deflection", "cantilever", "defl"), "m", "nm")
VOLTAGE = Column("deflection", ("deflection", "voltage", "vertical deflection", "defl"), "V")
ANY_PLACE = Column(DEPTH.word, (*DEPTH.names, *POSITION.names, *GAP.names), DEPTH.unit, DEPTH.usual)
ANY_LOAD = Column(FORCE.word, (*FORCE.names, *DEFLECTION.names, *VOLTAGE.names), FORCE.unit, FORCE.usual)
"""By which the sheet of a workbook is chosen."""
TIME = Column("time", TIME_NAMES, "s")
STIFFNESS = Column("stiffness", STIFFNESS_NAMES, "N/m")
SEGMENT = Column("segment", ("segment",), "")
GAPS = (STIFFNESS.word,)
"""Measured in parts of a test alone."""
MAKERS = {
    "Number of Points =": "Hysitron, text export",
    "Anton Paar": "Anton Paar, text export",
    "CSM Instruments": "CSM Instruments, text export",
    "NanoTest": "Micro Materials, text export",
    "Piuma": "Optics11, text export",
    "Chiaro": "Optics11, text export",
    "iMicro": "KLA, text export",
}
"""What stands above a table that its header makes readable, and who writes it."""
HEAD_LINES = 60
NOTHING = GivenFacts()
GAP_OR_DEPTH = re.compile(r"h(?![^\W_])", re.IGNORECASE)
"""A name that is the gap of a rheometer, or the depth of an indenter."""
SPRING_CONSTANT_LINE = re.compile(
    r"\s*+(?:k|spring constant)\s*+[\[(]N/m[\])]\s*+(?:[:=]\s*+)?([0-9.,eE+-]{1,100}+)\s*+"
)
RESULTS = (Column("modulus", YOUNG_NAMES, "Pa", "GPa"), Column("hardness", HARDNESS_NAMES, "Pa", "GPa"))


def is_curve_table(path: str | os.PathLike[str]) -> bool:
    """Return whether the header of a text names a position or depth and a force or deflection.

    Raises
    ------
    InvalidInput
        If the file cannot be read as text.
    """
    return _is_curve(path, header_lines(path, (ANY_PLACE, ANY_LOAD)))


def _is_curve(path: str | os.PathLike[str], head: Sequence[str]) -> bool:
    pairs = ((place, load) for place in (POSITION, DEPTH, GAP) for load in (FORCE, DEFLECTION, VOLTAGE))
    return any(names_columns(path, pair, head=head) for pair in pairs)


def read_curve_tables(path: str | os.PathLike[str], given: GivenFacts = NOTHING) -> list[PlacedCurve]:
    """Read the force curves of a text table: one, or those of several tests below each other.

    Parameters
    ----------
    path : str or path
        The file; its header names columns and units, as in ``piezo [nm], force [nN], time [s]``.  A column ``segment``
        numbers the segments in which the tip approaches, is held, and retracts; one number throughout says nothing, and
        a segment in which the tip turns is not believed: turns then follow from position and force.
    given : GivenFacts, optional
        What the table does not state.  With a column ``depth`` no spring constant is needed: that is the travel of the
        tip itself.

    Returns
    -------
    list of PlacedCurve
        Each curve, and the stiffness measured during the loading if there is such a column.

    Raises
    ------
    InvalidInput
        If columns, units or numbers are missing; the message names the line.
    """
    spring_constant, sensitivity, units = given.spring_constant, given.sensitivity, given.units
    stated = header_lines(path, (ANY_PLACE, ANY_LOAD))
    head = ["\t".join(given.columns)] if given.columns else stated
    place, load = _place(path, head, prefer_position=spring_constant is not None), _load(path, head, given)
    if place is None or load is None or not _is_curve(path, head):
        raise InvalidInput(
            f"{path}: there is no table of a force curve in this text{names_seen(path, (DEPTH, FORCE))}; it needs one "
            f"line that names a {DEPTH.word} ({', '.join(DEPTH.names[:5])} ...) or {POSITION.word} "
            f"({', '.join(POSITION.names[:5])} ...) and a {FORCE.word} ({', '.join(FORCE.names[:5])} ...) with units, "
            f"as in '{DEPTH.example}, {FORCE.example}', and numbers; or give columns = {{ depth = 1, force = 2 }}."
        )
    further = tuple(
        column for column in (TIME, STIFFNESS, SEGMENT) if names_columns(path, (place, load, column), head=head)
    )
    wanted = [_narrowed(path, head, column) for column in (place, _beside(head, place, load), *further)]
    table = read_table(path, wanted, units=units, repeated=True, numbers=given.columns, gaps=GAPS)
    found = {column.word: table.values[:, 2 + index] for index, column in enumerate(further)}
    stiffness = _stiffness(path, stated, spring_constant)
    position, force = table.values[:, 0] * (-1.0 if place is GAP else 1.0), table.values[:, 1]
    _refuse_other_tables(path, table, position, force, timed="time" in found)
    if load is not FORCE:
        if stiffness is None:
            raise InvalidInput(
                f"{path}: the table holds a deflection but no force; give spring_constant in N/m, which makes it one."
            )
        if load is VOLTAGE and sensitivity is None:
            raise InvalidInput(f"{path}: the deflection is a voltage; give sensitivity, deflection per volt in m/V.")
        force = force * stiffness * (sensitivity if load is VOLTAGE and sensitivity is not None else 1.0)
    of_place, of_load, turned = signs(position, force)
    position, force = of_place * position, of_load * force
    travels = place in (POSITION, GAP)
    needs_spring = travels or load is not FORCE
    crosshead = place is POSITION and named(table.read_as[0], CROSSHEAD_NAMES)[0]
    rigid = travels and stiffness is None and (given.rigid or crosshead)
    stiffness = math.inf if rigid else stiffness
    if travels and stiffness is None:
        raise InvalidInput(
            f"{path}: the table holds a {place.word} ({', '.join(place.names[:3])} ...) and so the depth needs the "
            "bending of the cantilever; give spring_constant in N/m, infinite where the position is the travel of the "
            "tip itself."
        )
    machine = stiffness if travels and stiffness is not None else math.inf
    none = np.zeros(0)
    read_as = dict(zip(("place", "load", *found), table.read_as, strict=True))
    measured = "stiffness" in found and place is DEPTH
    time_of_all = found.get("time", none)
    parts = parts_by_headers(position, time_of_all, table.lines, table.repeats)
    parts = parts or parts_of_tests(position, force, time_of_all, table.lines)
    _refuse_unparted(path, table, parts, place)
    where = place_in(stated, path)
    results = _results(path, place, head, given) if measured and len(parts) == 1 else None
    curves = []
    for number, part in enumerate(parts, start=1):
        name = name_of_test(Path(path).name, number, len(parts))
        at, load_at = position[part], force[part]
        time, segment = (found[word][part] if word in found else none for word in ("time", "segment"))
        with in_file(path):
            continuous = loading_stiffness(at, load_at, found["stiffness"][part], time, name) if measured else None
            facts = (
                f"{'position' if place is GAP else place.word} from '{read_as['place']}'"
                + ", its sign changed" * (place is GAP)
                + f", {load.word} from '{read_as['load']}'"
                + (f", time from '{read_as['time']}'" if "time" in found else ""),
                turned,
                stiffness_fact(f"'{read_as['stiffness']}'", continuous) if measured else "",
                segment_fact(at, load_at, segment, read_as.get("segment", "")),
                _origin_of_spring(stiffness, spring_constant) if needs_spring and not rigid else "",
                f"the {place.word} is taken as that of the tip, for no spring constant is stated" if rigid else "",
                f"sensitivity {sensitivity:g} m/V given" if load is VOLTAGE else "",
                f"given units: {', '.join(f'{key} {unit}' for key, unit in units.items())}" if units else "",
            )
            reading = reading_of(_maker(stated), facts, number, len(parts), at, load_at)
            directed = directions(at, load_at, segment)
            curve = ForceCurve(at, load_at, machine, time, directed, name, reading=reading)
            curves.append(PlacedCurve(curve, *where, continuous, results))
    return curves


def _refuse_other_tables(
    path: str | os.PathLike[str], table: Table, position: Array, force: Array, *, timed: bool
) -> None:
    """Refuse a list of results with a depth and a force for each test, and a gap that is called h."""
    if not timed:
        results = any(names_columns(path, (one,)) for one in RESULTS)
        refuse_list(path, table.read_as, position, force, results=results)
    name = table.read_as[0]
    if GAP_OR_DEPTH.match(name) and is_reversed(position, force):
        raise InvalidInput(
            f"{path}: the force rises as '{name}' falls, as over the gap of a rheometer; if it is one, give columns = "
            f"{{ gap = {table.numbers[0]}, force = {table.numbers[1]} }}; if it is a depth, correct its sign."
        )


def _refuse_unparted(path: str | os.PathLike[str], table: Table, parts: Sequence[slice], place: Column) -> None:
    """Refuse a header that stands again where no test ends and another begins."""
    ends = [float(table.lines[part.stop - 1]) for part in parts]
    begins = [float(table.lines[part.start]) for part in parts]
    between = list(zip(ends, begins[1:], strict=False))
    for line in table.repeats:
        if not any(end < line < begin for end, begin in between):
            raise InvalidInput(
                f"{path}, line {line}: the header with the {place.word} stands again, but the force does not end low "
                "before it and pass a peak on both sides, as of two tests; give each test a file, or delete the line."
            )


def _maker(head: Sequence[str]) -> str:
    """Return who has written a text table, by a word in the lines above it; "text table" if none is known."""
    above = "\n".join(head[:HEAD_LINES])
    return next((maker for word, maker in MAKERS.items() if word in above), "text table")


def _origin_of_spring(stiffness: float | None, given: float | None) -> str:
    return f"spring constant {stiffness:g} N/m {'given' if given is not None else 'from the file'}"


def _narrowed(path: str | os.PathLike[str], head: Sequence[str], column: Column) -> Column:
    """Return the column under the instrument's own name for it, such as "Load On Sample", where the header has one."""
    for name in by_preference(column.names):
        if " " in name and names_columns(path, (one := dataclasses.replace(column, names=(name,)),), head=head):
            return one
    return column


def _beside(head: Sequence[str], place: Column, load: Column) -> Column:
    """Return the column of the load that stands beside the place, where each other one stands beside another place.

    Instruments write what they have measured before what they have made of it: ``Displacement, Force, Depth, Load``.
    """
    others = {*POSITION.names, *DEPTH.names} - set(place.names)
    for line in head:
        for separator in SEPARATORS_TRIED:
            cells = cells_of(line.strip(), separator)
            loads = [number for number, cell in enumerate(cells) if named(cell, load.names)[0]]
            near = {number: [*cells[max(number - 1, 0) : number], *cells[number + 1 : number + 2]] for number in loads}
            chosen = [number for number in loads if any(named(cell, place.names)[0] for cell in near[number])]
            if (
                len(loads) > 1
                and len(chosen) == 1
                and all(
                    any(named(cell, tuple(others))[0] for cell in near[number])
                    for number in loads
                    if number != chosen[0]
                )
            ):
                return dataclasses.replace(load, names=(cells[chosen[0]].lower(),))
    return load


def _place(path: str | os.PathLike[str], head: Sequence[str], *, prefer_position: bool = False) -> Column | None:
    """Return the column of the tip's position; a piezo with a stated cantilever precedes the instrument's own depth."""
    position, depth = (names_columns(path, (column,), head=head) for column in (POSITION, DEPTH))
    if position and (prefer_position or not depth or _stated_cantilever(path, head) is not None):
        return POSITION
    if depth:
        return DEPTH
    return GAP if names_columns(path, (GAP,), head=head) else None


def _load(path: str | os.PathLike[str], head: Sequence[str], given: GivenFacts) -> Column | None:
    if names_columns(path, (FORCE,), head=head):
        return FORCE
    for column in (DEFLECTION, VOLTAGE):
        if names_columns(path, (column,), head=head):
            try:
                read_table(path, (column,), units=given.units, numbers=given.columns)
            except InvalidInput:
                continue
            return column
    return DEFLECTION if names_columns(path, (DEFLECTION,), head=head) else None


def _stiffness(path: str | os.PathLike[str], head: Sequence[str], given: float | None) -> float | None:
    if given is None:
        return _stated_cantilever(path, head)
    if isinstance(given, bool) or not isinstance(given, int | float) or not given > 0.0:
        raise InvalidInput(f"{path}: spring_constant is {given!r}; it must be positive, in N/m.")
    return float(given)


def _stated_cantilever(path: str | os.PathLike[str], head: Sequence[str]) -> float | None:
    """Return the spring constant [N/m] that stands above the table, if one does."""
    stated_line = next((match for line in head if (match := SPRING_CONSTANT_LINE.fullmatch(line))), None)
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


def _results(
    path: str | os.PathLike[str], place: Column, head: Sequence[str], given: GivenFacts
) -> StatedResults | None:
    """Return the results in a text table whose depth is read from the column `place`; None where it has none."""
    columns = [one for one in RESULTS if names_columns(path, (place, one), head=head)]
    if not columns:
        return None
    try:
        units = {key: unit for key, unit in given.units.items() if key == "position"}
        table = read_table(path, [place, *columns], units=units, repeated=True)
    except InvalidInput:  # blank cells, or no unit: they are no part of the curve
        return None
    found = {one.word: table.values[:, 1 + index] for index, one in enumerate(columns)}
    nothing = np.full(table.values.shape[0], math.nan)
    return stated_results(table.values[:, 0], found.get("modulus", nothing), found.get("hardness", nothing))


PLACE_LINE = re.compile(
    r"[#%\s]*+(?P<axis>[xy])\s*+[\[(](?P<unit>[nuµm]?m)[\])]\s*+[:=]\s*+(?P<number>[0-9.,eE+-]{1,100}+)\s*+"
)


def place_in(head: Sequence[str], where: object) -> tuple[float, float]:
    """Return the place [m] that lines above a table state, NaN for what they do not.

    Parameters
    ----------
    head : sequence of str
        Lines above the table.
    where
        The file, for messages.

    Raises
    ------
    InvalidInput
        If a place is no finite number.

    Examples
    --------
    >>> place_in(["# x [um]: 3.5", "# y [um]: 2", "depth [nm], force [nN]"], "gel.csv")
    (3.5e-06, 2e-06)
    """
    found = {"x": math.nan, "y": math.nan}
    for match in filter(None, map(PLACE_LINE.fullmatch, head)):
        try:
            number = float(match["number"])
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise InvalidInput(
                f"{where}: the place {match['axis']} is '{match['number']}', which is no number; write it with a "
                "decimal point, as in 'x [um]: 3.5', or leave the line out."
            )
        found[match["axis"]] = number * scale(match["unit"], "m")
    return found["x"], found["y"]
