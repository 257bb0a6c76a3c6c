"""Force curves in Nanosurf's own files (``.nid``): a head of sections, and whole numbers behind ``#!``.

Each section ``[DataSet-G:C]`` states the size of one channel, and the least value and the range that its whole numbers
span.  The channels follow each other in the order of groups and channels; each line of a channel is one curve.  Lines
of a map have as many points as the longest; ``LineDim7Points`` states how many of the eighth were measured.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.io.instruments.cantilever import force_factor
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest, measures
from winkler.io.segments import directions, is_written_backwards, segment_fact
from winkler.io.tables.given_units import GivenFacts
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.limits import FILE_BYTES

BEGIN, END = b"[DataSet]", b"#!"
HEAD_BYTES = 1_000_000
"""Most bytes of the head."""
FRAMES = ("Spec forward", "Spec backward")
"""The two frames of a curve, against the sample and back."""
HEIGHTS, DEFLECTION = ("Z-Axis Sensor", "Z-Axis"), "Deflection"
"""Channels of heights, that which was measured before that which was demanded."""
LEVER = "DataSet\\Calibration\\Cantilever"
IN_UNIT = re.compile(r"D\[([-+0-9.eE]{1,40})\]\*\[N/m\]")
BITS = {8: "<i1", 16: "<i2", 32: "<i4"}
Sections = dict[str, dict[str, str]]


class _FrameChannel(NamedTuple):
    """Name, unit and numbers ``(lines, points)`` of a channel of one frame."""

    frame: str
    name: str
    unit: str
    numbers: Array


def is_nanosurf_nid(path: Path) -> bool:
    """Return whether a file is one of Nanosurf with curves, not with images alone."""
    with path.open("rb") as file:
        if file.read(len(BEGIN)) != BEGIN:
            return False
        head = file.read(HEAD_BYTES).partition(END)[0]
    return any(f"Frame={frame}".encode() in head for frame in FRAMES)


def tests_of_nanosurf_nid(path: Path, given: GivenFacts) -> Iterator[InstrumentTest]:
    """Yield the curves of a file, against the sample and back.

    Raises
    ------
    InvalidInput
        If the file is cut off or damaged, holds no height or deflection, or nothing makes a force of the deflection.
    """
    channels, sections = _channels(path)
    spring = given.spring_constant or _spring(sections)
    pairs = []
    for frame in FRAMES:
        own = {one.name: one for one in channels if one.frame == frame}
        height = next((own[name] for name in HEIGHTS if name in own), None)
        if own and (height is None or DEFLECTION not in own):
            raise InvalidInput(
                f"{path}: '{frame}' holds {', '.join(sorted(own))}; a curve needs {DEFLECTION} and one of "
                f"{', '.join(HEIGHTS)}: record them, or export the curve as text."
            )
        if height is not None:
            pairs.append((height, own[DEFLECTION]))
    count = min(height.numbers.shape[0] for height, _ in pairs)
    for number in range(count):
        name = path.name if count == 1 else f"{path.name}, curve {number}"
        yield _test(pairs, number, name, spring, given, path)


def _test(
    pairs: list[tuple[_FrameChannel, _FrameChannel]],
    number: int,
    name: str,
    spring: float | None,
    given: GivenFacts,
    path: Path,
) -> InstrumentTest:
    position: list[Array] = []
    force: list[Array] = []
    frame: list[Array] = []
    facts: tuple[str, ...] = ()
    for place, (height, bend) in enumerate(pairs):
        factor, facts = force_factor(bend.unit, spring, given.sensitivity, "given", path)
        if not measures(height.unit, "m"):
            raise InvalidInput(f"{path}: its height '{height.name}' is in {height.unit!r}; export the curve as text.")
        z, f = height.numbers[number], bend.numbers[number]
        size = min(z.size, f.size)
        measured = np.isfinite(z[:size]) & np.isfinite(f[:size])
        z, f = z[:size][measured], f[:size][measured]
        if position and is_written_backwards(position[-1], z):
            z, f = z[::-1], f[::-1]
        position.append(z)
        force.append(factor * f)
        frame.append(np.full(z.size, place))
    height, bend = pairs[0]
    at, load, numbers = np.concatenate(position), np.concatenate(force), np.concatenate(frame)
    notes = (
        f"position from '{height.name}', force from '{bend.name}'",
        *facts,
        segment_fact(at, load, numbers, "frame"),
    )
    columns = (InstrumentColumn("position", height.unit, at), InstrumentColumn("force", "N", load))
    turned = directions(at, load, numbers)
    return InstrumentTest("Nanosurf", name, columns, notes, direction=turned, spring_constant=spring)


def _channels(path: Path) -> tuple[list[_FrameChannel], Sections]:
    """Return the channels of both frames, and the sections of the head."""
    with path.open("rb") as file:
        content = file.read(FILE_BYTES)
    head, mark, numbers = content.partition(END)
    if not mark:
        raise InvalidInput(f"{path}: the file ends within its head; copy it anew from the microscope.")
    sections = _sections(head[:HEAD_BYTES].decode("latin-1"))
    groups = sections.get("DataSet", {})
    channels: list[_FrameChannel] = []
    begin = 0
    for group in range(_whole(groups, "GroupCount", path, 1000)):
        for place in range(_whole(groups, f"Gr{group}-Count", path, 1000)):
            section = sections.get(groups.get(f"Gr{group}-Ch{place}", ""))
            if section is None:
                continue
            points, lines = (_whole(section, key, path, 2**31) for key in ("Points", "Lines"))
            bits = _whole(section, "SaveBits", path, 32)
            if bits not in BITS or section.get("SaveMode") != "Binary" or section.get("SaveSign") != "Signed":
                raise InvalidInput(
                    f"{path}: its numbers are not stored as signed ones of 8 to 32 bits; export as text."
                )
            end = begin + points * lines * bits // 8
            if end > len(numbers):
                raise InvalidInput(f"{path}: the file ends within its numbers; copy it anew from the microscope.")
            if section.get("Frame") in FRAMES:
                raw = np.frombuffer(numbers[begin:end], dtype=BITS[bits]).reshape(lines, points)
                low, span = (_real(section, key, path) for key in ("Dim2Min", "Dim2Range"))
                scaled = low + span * (raw + 2.0 ** (bits - 1)) / 2.0**bits
                for line in range(lines):
                    measured = _whole(section, f"LineDim{line}Points", path, 2**31) or points
                    scaled[line, measured:] = np.nan
                name, unit = section.get("Dim2Name", ""), section.get("Dim2Unit", "")
                channels.append(_FrameChannel(section["Frame"], name, unit, scaled))
            begin = end
    if not any(one.numbers.size for one in channels):
        raise InvalidInput(f"{path}: its curves hold no numbers; record them anew.")
    return channels, sections


def _sections(text: str) -> Sections:
    sections: Sections = {}
    own: dict[str, str] = {}
    for line in text.splitlines():
        if line.startswith("[") and line.endswith("]"):
            own = sections.setdefault(line[1:-1], {})
        else:
            key, _, stated = line.partition("=")
            own[key] = stated
    return sections


def _whole(section: dict[str, str], key: str, path: Path, most: int) -> int:
    text = section.get(key, "0")
    if not (text.isascii() and text.isdecimal() and len(text) < 11 and int(text) <= most):
        raise InvalidInput(f"{path}: its head states {key}={text[:40]}, no whole number up to {most}; copy it anew.")
    return int(text)


def _real(section: dict[str, str], key: str, path: Path) -> float:
    text = section.get(key, "")
    try:
        number = float(text)
    except ValueError:
        number = np.nan
    if not np.isfinite(number):
        raise InvalidInput(f"{path}: its head states {key}={text[:40]}, which is no number; copy it anew.")
    return number


def _spring(sections: Sections) -> float | None:
    """Return the spring constant [N/m] of the lever; None where none is stated."""
    found = next(filter(None, map(IN_UNIT.fullmatch, sections.get(LEVER, {}).values())), None)
    try:
        number = float(found[1]) if found else 0.0
    except ValueError:
        return None
    return number if number > 0.0 else None
