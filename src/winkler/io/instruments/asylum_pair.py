"""Curves of microscopes of Asylum Research: waves of Igor with columns, or one for deflections and one for positions.

``Line0000Point0000Defl.ibw`` lies beside ``Line0000Point0000ZSnsr.ibw`` (or ``LVDT``, ``Raw``), each with one number
for each point of time; or one file has columns of these names.  The sensor's position grows towards the sample.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from winkler.io.foreign import quiet, sentence_of, without_stale_sizes
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest, measures
from winkler.io.memory import limited_memory
from winkler.io.tables.given_units import GivenFacts
from winkler.values.errors import InvalidInput
from winkler.values.units import scale

ENDING, DEFLECTION, POSITIONS = ".ibw", "Defl", ("ZSnsr", "LVDT", "Raw")
OTHER_DEFLECTIONS, OTHER_POSITIONS = ("Deflection",), ("ZSensor", "Height")
NOTE = re.compile(r"(?:\A|[\r\n])\s*(SpringConstant|InvOLS|XLVDT|YLVDT)\s*:\s*([-+0-9.eE]{1,40})\s*(?=[\r\n]|\Z)")
"""Lines of the note of a wave."""


def is_asylum_half(path: Path) -> bool:
    """Return whether a file is named as one of the two waves of a curve."""
    return path.suffix.lower() == ENDING and path.stem.endswith((DEFLECTION, *POSITIONS))


def tests_of_asylum_pair(path: Path, given: GivenFacts) -> Iterator[InstrumentTest]:
    """Yield the curve of a wave of deflections and of the wave of positions beside it.

    Raises
    ------
    InvalidInput
        If the other wave is missing or of another length, a unit is missing, or the spring constant is.
    """
    for word in POSITIONS:
        if path.stem.endswith(word):
            other = path.with_name(f"{path.stem.removesuffix(word)}{DEFLECTION}{path.suffix}")
            raise InvalidInput(f"{path}: these are the positions of a curve; give its deflections, '{other.name}'.")
    start = path.stem.removesuffix(DEFLECTION)
    beside = [path.with_name(f"{start}{word}{path.suffix}") for word in POSITIONS]
    other = next((one for one in beside if one.is_file()), beside[0])
    if not other.is_file():
        raise InvalidInput(
            f"{path}: these are deflections, and the positions of the curve are missing; put '{other.name}' beside it."
        )
    load, place = _wave(path), _wave(other)
    deflection, position = (_numbers(wave, one) for wave, one in ((load, path), (place, other)))
    if deflection.shape != position.shape:
        raise InvalidInput(
            f"{path}: it has {deflection.size} deflections, and '{other.name}' {position.size} positions; give "
            "waves of one curve."
        )
    column = InstrumentColumn("position", _unit(place, other, given, "position"), position)
    fact = f"deflection from '{path.name}', position from '{other.name}'"
    yield _test("Asylum Research, a pair of waves", path, load, deflection, column, fact, given)


def tests_of_asylum_columns(path: Path, given: GivenFacts) -> Iterator[InstrumentTest] | None:
    """Return the curve of a wave with columns for deflection and position; None of other waves.

    Raises
    ------
    InvalidInput
        If the wave cannot be read, a unit is missing, or the spring constant is.
    """
    wave = _wave(path)
    names = [_text(name) for name in wave.get("labels", [[], []])[1]]
    names = names[1:] if names[:1] == [""] else names
    place = next((names.index(word) for word in (*POSITIONS, *OTHER_POSITIONS) if word in names), -1)
    load = next((names.index(word) for word in (DEFLECTION, *OTHER_DEFLECTIONS) if word in names), -1)
    numbers = np.asarray(wave["wData"])
    if place < 0 or load < 0 or numbers.ndim != 2 or numbers.shape[1] != len(names) or numbers.dtype.kind not in "fiu":
        return None
    deflection, position = numbers[:, load].astype(float), numbers[:, place].astype(float)
    column = InstrumentColumn("position", _unit(wave, path, given, "position"), position)
    fact = f"deflection from '{names[load]}', position from '{names[place]}'"
    return iter([_test("Asylum Research, a wave with columns", path, wave, deflection, column, fact, given)])


def _test(
    maker: str, path: Path, wave: Any, deflection: np.ndarray, position: InstrumentColumn, fact: str, given: GivenFacts
) -> InstrumentTest:
    """Return a curve from its deflections and positions, and what the wave of the deflections states."""
    note = dict(NOTE.findall(wave["note"].decode("latin-1", "replace")))
    stated = _number(note.get("SpringConstant", ""))
    spring = given.spring_constant or (stated if stated > 0.0 else None)
    if spring is None:
        raise InvalidInput(f"{path}: the file does not state the spring constant; give spring_constant in N/m.")
    factor = spring * scale(_unit(wave, path, given, "deflection"), "m")
    facts: tuple[str, ...] = (fact,)
    if given.sensitivity:
        made_by = _number(note.get("InvOLS", ""))
        if not made_by > 0.0:
            raise InvalidInput(
                f"{path}: the file states no sensitivity by which its force could be turned into another; leave "
                "sensitivity out."
            )
        factor *= given.sensitivity / made_by
        facts = (fact, f"sensitivity {given.sensitivity:g} m/V given, in place of {made_by:g} m/V")
    step = float(wave["wave_header"]["sfA"][0])
    timed = measures(_text(wave["wave_header"]["dimUnits"][0]), "s") and step > 0.0
    return InstrumentTest(
        maker,
        path.name,
        (
            position,
            InstrumentColumn("force", "N", deflection * factor),
            *([InstrumentColumn("time", "s", step * np.arange(deflection.size))] if timed else []),
        ),
        facts,
        _number(note.get("XLVDT", "")),
        _number(note.get("YLVDT", "")),
        spring_constant=spring,
    )


def _wave(path: Path) -> Any:
    remedy = "export the curve as text"
    try:
        from igor2 import binarywave
    except ImportError:
        raise InvalidInput(
            f"{path}: waves of Igor need the extra afm; install it with pip install 'winkler[afm]'."
        ) from None
    with sentence_of(path, "the wave cannot be read", remedy), quiet(), limited_memory(path), without_stale_sizes():
        _expect_sizes_in_file(path)
        return binarywave.load(str(path))["wave"]


def _expect_sizes_in_file(path: Path) -> None:
    """Refuse a wave of version 5 whose head states parts longer than the file: igor2 would make room for them first."""
    with path.open("rb") as file:
        head, size = file.read(60), path.stat().st_size
    if head[:2] in (b"\5\0", b"\0\5") and len(head) == 60:
        stated = np.frombuffer(head[4:], "<i4" if head[0] else ">i4")
        if np.max(stated) > size:
            raise ValueError(f"its head states {np.max(stated)} bytes, and the file has {size}")


def _numbers(wave: Any, path: Path) -> np.ndarray:
    numbers = np.asarray(wave["wData"])
    if numbers.ndim != 1 or numbers.dtype.kind not in "fiu":
        raise InvalidInput(f"{path}: the wave has the shape {numbers.shape}; a curve is a row of numbers.")
    return numbers.astype(float)


def _unit(wave: Any, path: Path, given: GivenFacts, word: str) -> str:
    """Return the unit of a wave, as it states it or as it is given."""
    stated = _text(wave["wave_header"]["dataUnits"])
    unit = stated or given.units.get(word, "")
    if not measures(unit, "m"):
        raise InvalidInput(
            f"{path}: the wave has the unit '{stated}', no length; "
            'give units = { position = "m", deflection = "m" }.'
        )
    return unit


def _text(content: Any) -> str:
    return b"".join(np.atleast_1d(content).tolist()).split(b"\0")[0].decode("latin-1").strip()


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return math.nan
