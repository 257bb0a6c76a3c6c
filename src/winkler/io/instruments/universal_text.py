"""Force curves in the unified text format (``.uff``) of laboratories of force microscopy.

Lines ``HE key: value`` state the settings; rows of each segment begin with its code, as in ``AP 0 2.9e-09 1.59``, and
hold the distance from the deepest point and the deflection.  The units of a segment may be those of the first.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.fitting.curves.directions import IN, OUT
from winkler.io.instruments.cantilever import force_factor
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest
from winkler.io.instruments.number_block import stated_number
from winkler.io.tables.given_units import GivenFacts
from winkler.values.errors import InvalidInput

FIRST = "HE UFF_code"
SETTING = re.compile(r"HE ([^:\s]{1,80}):\s*+(.*)")
ROW = re.compile(r"([A-Z]{2})\s++(\d{1,6})((?:\s++[-+.\deE]{1,30}){2,9})\s*+")
SPRING, SENSITIVITY = "Cantilever_springK_used(N/m)", "Recording_inv_optical_lever_sens_used(m/V)"
WAYS = {"AP": IN, "RE": OUT}
VOLTS = {"volt": "V", "volts": "V"}


def is_universal_text(head: Sequence[str]) -> bool:
    """Return whether the first line is that of the format."""
    return bool(head) and head[0].startswith(FIRST)


def tests_of_universal_text(
    lines: Sequence[str], name: str, path: object, given: GivenFacts
) -> Iterator[InstrumentTest]:
    """Yield the curve of a text: its approach, and its retraction.

    Raises
    ------
    InvalidInput
        If another segment or column stands in it, or nothing makes a force of the deflection.
    """
    settings = {match[1]: match[2].strip() for match in map(SETTING.fullmatch, lines) if match}
    rows = [match for match in map(ROW.fullmatch, lines) if match]
    codes = list(dict.fromkeys(match[1] for match in rows))
    if not codes or not set(codes) <= set(WAYS):
        raise InvalidInput(
            f"{path}: its segments are {', '.join(codes) or 'empty'}; approach (AP) and retraction (RE) are read."
        )
    place, bend = (settings.get(f"Recording_segment_0_col_{one}_title", "").lower() for one in (0, 1))
    if (place, bend) != ("displacement", "deflection"):
        raise InvalidInput(f"{path}: its columns are '{place}' and '{bend}'; a displacement and a deflection are read.")
    units = [settings.get(f"Recording_segment_0_col_{one}_unit", "") for one in (0, 1)]
    spring = given.spring_constant or stated_number(settings, SPRING)
    sensitivity = given.sensitivity or stated_number(settings, SENSITIVITY)
    origin = "given" if given.sensitivity else "from the file"
    factor, facts = force_factor(VOLTS.get(units[1], units[1]), spring, sensitivity, origin, path)
    position, force, direction = [], [], []
    for code in codes:
        numbers = np.array([match[3].split()[:2] for match in rows if match[1] == code], dtype=float)
        numbers = numbers[::-1] if code == "AP" else numbers  # both are written from the deepest point on
        position.append(-numbers[:, 0])
        force.append(factor * numbers[:, 1])
        direction.append(np.full(len(numbers), WAYS[code]))
    columns = (
        InstrumentColumn("position", units[0], np.concatenate(position)),
        InstrumentColumn("force", "N", np.concatenate(force)),
    )
    notes = ("distances from the deepest point, their sign changed", *facts)
    yield InstrumentTest(
        "unified text format (UFF)", name, columns, notes, direction=np.concatenate(direction), spring_constant=spring
    )
