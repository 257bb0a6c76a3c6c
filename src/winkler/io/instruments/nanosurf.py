"""Force curves that Nanosurf's programs export as text: ``#Key=value`` above the numbers of each phase.

The sensor of the height counts towards the sample.  The deflection stands in V, m or N, and the head states spring
constant and sensitivity.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.io.instruments.cantilever import force_factor
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest
from winkler.io.instruments.number_block import rows_of, split_unit
from winkler.io.segments import directions, is_written_backwards, segment_fact
from winkler.io.tables.given_units import GivenFacts
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.units import scale

SETTING = re.compile(r"#([A-Za-z][A-Za-z-]{0,40})=(.*)")
COLUMNS, PHASE, POINT = "Spec-Data", "Spec-Name", "SpecMap-CurIndex"
SPRING, SENSITIVITY = "Spring-Constant", "Deflection-Sensitivity"
HEIGHTS, DEFLECTION = ("z-axis sensor", "z-axis-out", "z-axis"), "deflection"
"""Columns of heights, that which was measured before that which was demanded."""
MOST_BENDING = 1000.0
"""Greatest bending of the cantilever over the travel of the piezo; only numbers in another unit exceed it."""
LEADING_NUMBER = re.compile(r"[-+0-9.eE]{1,30}")


def is_nanosurf_text(head: Sequence[str]) -> bool:
    """Return whether a setting names columns, and a deflection among them."""
    settings = {match[1]: match[2].lower() for match in map(SETTING.match, head) if match}
    return DEFLECTION in settings.get(COLUMNS, "")


def tests_of_nanosurf_text(
    lines: Sequence[str], name: str, path: object, given: GivenFacts
) -> Iterator[InstrumentTest]:
    """Yield the curve of a text, from all of its phases.

    Raises
    ------
    InvalidInput
        If phases differ in their columns, there is no height, or nothing makes a force of the deflection.
    """
    settings, phases = _phases(lines, path)
    cells = [split_unit(cell) for cell in settings[COLUMNS].split(";")]
    words = [word.lower() for word, _ in cells]
    height = next((word for word in HEIGHTS if word in words), "")
    if not height:
        raise InvalidInput(f"{path}: none of its columns {settings[COLUMNS]} is a height; export one, too.")
    place, bend = words.index(height), words.index(DEFLECTION)
    spring = given.spring_constant or _number(settings, SPRING)
    stated = given.sensitivity or _number(settings, SENSITIVITY)
    factor, facts = force_factor(
        cells[bend][1], spring, stated, "given" if given.sensitivity else "from the file", path
    )
    blocks: list[Array] = []
    turned = 0
    for _, block in phases:
        backwards = bool(blocks) and is_written_backwards(blocks[-1][:, place], block[:, place])
        blocks.append(block[::-1] if backwards else block)
        turned += backwards
    rows = np.concatenate(blocks)
    position, force = rows[:, place], rows[:, bend] * factor
    if np.ptp(force) > MOST_BENDING * float(spring or 0.0) * np.ptp(position) * scale(cells[place][1], "m"):
        if given.sensitivity is None:
            raise InvalidInput(
                f"{path}: its deflection of {np.ptp(force):.4g} N would bend the cantilever by "
                f"{np.ptp(force) / float(spring or math.nan):.3g} m; if the numbers are volts, give sensitivity in m/V."
            )
        factor, facts = force_factor("V", spring, stated, "given", path)
        facts = (*facts, f"the numbers of '{cells[bend][0]}', stated in {cells[bend][1]}, are taken as V")
        force = rows[:, bend] * factor
    numbers = np.repeat(np.arange(len(phases)), [len(one) for _, one in phases])
    notes = (
        f"position from '{cells[place][0]}', force from '{cells[bend][0]}'",
        *facts,
        f"phases {', '.join(phase for phase, _ in phases)}; {segment_fact(position, force, numbers, 'phase')}",
        *([f"{turned} of {len(phases)} phases, written backwards, are turned round"] if turned else []),
        *([f"point {settings[POINT]} of a map"] if POINT in settings else []),
    )
    yield InstrumentTest(
        "Nanosurf, text export",
        name,
        (InstrumentColumn("position", cells[place][1], position), InstrumentColumn("force", "N", force)),
        notes,
        direction=directions(position, force, numbers),
        spring_constant=spring,
    )


def _phases(lines: Sequence[str], path: object) -> tuple[dict[str, str], list[tuple[str, Array]]]:
    """Return the settings, and name and rows of each phase that has some."""
    settings: dict[str, str] = {}
    phases: list[tuple[str, Array]] = []
    above, columns = True, ""
    for index, line in enumerate(lines):
        if match := SETTING.match(line):
            settings[match[1]] = match[2].strip()
            above = True
        elif above and line.strip() and not line.startswith("#") and COLUMNS in settings:
            above = False
            if columns and settings[COLUMNS] != columns:
                raise InvalidInput(f"{path}: its phases differ in their columns; export each to a file of its own.")
            columns = settings[COLUMNS]
            rows = rows_of(lines, index, len(columns.split(";")), path, separator=";")
            if rows.size:
                phases.append((settings.get(PHASE, f"{len(phases) + 1}"), rows))
    if not phases:
        raise InvalidInput(f"{path}: there are no numbers below the names of the columns; export the curve again.")
    return settings, phases


def _number(settings: dict[str, str], key: str) -> float | None:
    """Return the number of a setting such as ``0.12N/m``: in N/m or m/V."""
    try:
        found = LEADING_NUMBER.match(settings.get(key, ""))
        return float(found[0]) if found else None
    except ValueError:
        return None
