r"""Force curves and force volumes of Bruker's NanoScope (.spm, .000 and numbered endings): a text head, then integers.

The head has sections with lines ``\key: value``.  Each section ``Ciao force image list`` is a channel: where its
integers stand, how many belong to approach and to retraction, the volts of the least bit, and the name of the
sensitivity that makes lengths of volts.  Both are stored from the deepest point outwards.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.directions import IN, OUT
from winkler.io.instruments.instrument_test import InstrumentColumn, InstrumentTest, measures
from winkler.io.instruments.number_block import stated_number
from winkler.io.tables.given_units import GivenFacts
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.units import scale

FORCES, IMAGES = b"\\*Force file list", b"\\*File list"
HEAD_BYTES = 2_000_000
HEAD_END = b"\\*File list end"
CHANNEL, MAP = "Ciao force image list", "Ciao image list"
VOLTS = re.compile(r"V \[(?P<soft>[^\]]{1,60})\] \((?P<least>[-+.\deE]{1,30}) V/LSB\) +(?P<hard>[-+.\deE]{1,30}) V.*")
SENSITIVITY = re.compile(r"V +(?P<number>[-+.\deE]{1,30}) *(?P<unit>[^\s/]{0,8})(?:/V)?.*")
NAME = re.compile(r'[^"]*"(?P<name>[^"]{1,60})".*')
POINT_BYTES = (2, 4)
LARGEST_COUNT = 65536
"""The least bit is that of a converter of 16 bits, also where four bytes are stored."""
PARTS = 256
"""Parts of the least bit in which some volumes of version 9 store four bytes; no key of the head says so."""
TRIGGER, SAME_TRIGGER, FAR = "@4:Trig Threshold Deflection", 0.1, 0.1
"""Volts at which the extension ends, how well it must be met, and the far part of the extension."""
MOST_CURVES = 1_000_000


class _Channel(NamedTuple):
    """Settings of a channel, its name, and the sections of the file."""

    name: str
    settings: dict[str, str]


class _Head(NamedTuple):
    """Settings outside of channels and maps, the first of each name; channels; curves per line and lines."""

    settings: dict[str, str]
    channels: tuple[_Channel, ...]
    grid: tuple[int, int]


def is_nanoscope(path: Path, *, images: bool = True) -> bool:
    """Return whether a file begins as NanoScope writes force curves, or images, which may hold curves too."""
    with path.open("rb") as file:
        start = file.read(len(FORCES))
    return start == FORCES or (images and start.startswith(IMAGES))


def tests_of_nanoscope(path: Path, given: GivenFacts) -> Iterator[InstrumentTest]:
    """Yield the curves of a file, those of a volume line by line.

    Raises
    ------
    InvalidInput
        If it is an image, its head or its numbers are incomplete, or nothing makes a force of the deflection.
    """
    with path.open("rb") as file:
        content = file.read()
    head = _head(content, path)
    deflection = next((one for one in head.channels if one.name.lower().startswith("deflection")), None)
    if deflection is None:
        there = ", ".join(f"'{one.name}'" for one in head.channels) or "none"
        raise InvalidInput(f"{path}: its channels are {there}; a force curve needs the deflection.")
    spring = given.spring_constant or stated_number(deflection.settings, "Spring Constant")
    if not spring:
        raise InvalidInput(f"{path}: it states no spring constant; give spring_constant in N/m.")
    sensor = next((one for one in head.channels if one.name.lower() == "height sensor"), None)
    sensitivity, of_sensitivity = _sensitivity(deflection, head, given, path)
    force, parts = _numbers(deflection, head, content, path)
    passes = _counts_of(deflection, path)
    ramp, speed = _ramp(deflection, head, path)
    place = (
        (_numbers(sensor, head, content, path)[0], _least(sensor, path) * _sensor_sensitivity(sensor, head, path))
        if sensor is not None and _counts_of(sensor, path) == passes
        else None
    )
    whole = _whole_ramp(passes, head)
    steps = [ramp * (1.0 - np.arange(count - 1, -1, -1) / full) for count, full in zip(passes, whole, strict=True)]
    driven = np.concatenate([steps[0], steps[1][::-1]])
    time = _time(passes, whole, ramp, speed, head)
    facts = (
        f"deflection from '{deflection.name}', position from "
        + ("'Height Sensor'" if place is not None else "the ramp, its size and number of points"),
        of_sensitivity,
        *(["no sensor measured the height: a creep of the piezo is not seen"] if place is None else []),
        *([f"its numbers are {PARTS}ths of the least bit: the stated trigger is met by them"] if parts != 1 else []),
    )
    direction = np.repeat([IN, OUT], passes)
    missing = np.iinfo(force.dtype).min
    columns, lines = head.grid
    size, origin = _scan(head)
    for number, counts in enumerate(force):
        valid = counts != missing
        volts = _turned(counts, passes[0]) * _least(deflection, path) / parts
        load = np.where(_turned(valid, passes[0]), volts * sensitivity * spring, np.nan)
        position = driven if place is None else _turned(place[0][number], passes[0]) * place[1]
        line, column = divmod(number, columns)
        name = path.name if len(force) == 1 else f"{path.name}, curve {number}"
        x, y = origin
        if len(force) > 1:
            x, y = x + size * (column + 0.5) / columns, y + size * (line + 0.5) / lines
        yield InstrumentTest(
            f"NanoScope {head.settings.get('Version', '')}".strip(),
            name,
            (
                InstrumentColumn("position", "m", position),
                InstrumentColumn("force", "N", load),
                *([InstrumentColumn("time", "s", time)] if time.size else []),
            ),
            facts,
            x,
            y,
            direction,
            spring_constant=spring,
        )


def _head(content: bytes, path: Path) -> _Head:
    text, end, _ = content[:HEAD_BYTES].partition(HEAD_END)
    if not end:
        raise InvalidInput(f"{path}: its head has no end; the file is cut, copy it anew.")
    sections: list[tuple[str, dict[str, str]]] = []
    for line in text.decode("latin-1").splitlines():
        if line.startswith("\\*"):
            sections.append((line[2:].strip(), {}))
        elif line.startswith("\\") and sections:
            key, _, value = line[1:].partition(": ")
            sections[-1][1].setdefault(key.strip(), value.strip())
    channels = tuple(
        _Channel(match["name"], settings)
        for name, settings in sections
        if name == CHANNEL and (match := NAME.fullmatch(settings.get("@4:Image Data", "")))
    )
    if not channels:
        raise InvalidInput(f"{path}: it is an image of NanoScope and holds no force curve; read_topography reads it.")
    settings: dict[str, str] = {}
    for name, own in sections:
        if name not in (CHANNEL, MAP):
            for key, value in own.items():
                settings.setdefault(key, value)
    if settings.get("PeakForce Capture") == "Allow" and content.startswith(IMAGES):
        raise InvalidInput(
            f"{path}: captures of PeakForce, whose piezo moves as a sine, are not read; export its curves as text."
        )
    per_line = settings.get("force/line", "").split()[:1]  # the picture beside a volume may have other pixels
    images = [own for name, own in sections if name == MAP]
    image = next((own for own in images if own.get("Samps/line", "").split()[:1] == per_line), next(iter(images), None))
    volume = settings.get("Operating mode", "Force") != "Force" and image is not None
    grid = tuple(_whole(image, key, path) for key in ("Samps/line", "Number of lines")) if volume and image else (1, 1)
    return _Head(settings, channels, (grid[0], grid[1]))


def _counts_of(channel: _Channel, path: Path) -> tuple[int, int]:
    """Return the numbers of points of extension and retraction; the file states retraction first."""
    counts = [int(word) for word in channel.settings.get("Samps/line", "").split() if word.isdecimal()]
    if not counts or not all(0 < count <= MOST_CURVES for count in counts):
        raise InvalidInput(f"{path}: '{channel.name}' states no number of points; save the file anew.")
    return counts[-1], counts[0]


def _numbers(channel: _Channel, head: _Head, content: bytes, path: Path) -> tuple[Array, int]:
    """Return the integers of all curves ``(curves, points)``, and of how many parts of the least bit they are."""
    offset, length = (_whole(channel.settings, key, path) for key in ("Data offset", "Data length"))
    passes = _counts_of(channel, path)
    curves, points = head.grid[0] * head.grid[1], sum(passes)
    size, rest = divmod(length, curves * points) if 0 < curves <= MOST_CURVES else (0, 1)
    padded = bool(rest) and length in (curves * 2 * max(passes) * one for one in POINT_BYTES)
    if padded:  # older versions keep room for the longer pass in both
        size, rest = length // (curves * 2 * max(passes)), 0
    if rest or size not in POINT_BYTES:
        raise InvalidInput(
            f"{path}: '{channel.name}' has {length} bytes for {curves} curves of {points} points; 2 or 4 bytes a "
            "point are read, without the points of a hold: export its curves as text."
        )
    block = content[offset : offset + length]
    if len(block) != length:
        raise InvalidInput(f"{path}: the file ends before the numbers of '{channel.name}'; copy it anew.")
    counts = np.frombuffer(block, dtype=f"<i{size}").reshape(curves, -1)
    if padded:
        counts = np.delete(counts, np.r_[passes[0] : max(passes), max(passes) + passes[1] : 2 * max(passes)], axis=1)
    largest = float(np.abs(counts[0].astype(float)).max())
    if largest > LARGEST_COUNT and _meets_trigger(counts / PARTS, channel, head, path):
        return counts, PARTS
    if largest > LARGEST_COUNT:
        raise InvalidInput(
            f"{path}: numbers of '{channel.name}' are up to {largest:.3g}, and those of its converter up to "
            f"{LARGEST_COUNT}: they do not stand where the head says; copy the file anew, unedited."
        )
    return counts, 1


def _meets_trigger(counts: Array, channel: _Channel, head: _Head, path: Path) -> bool:
    """Return whether the extension of most curves ends at the deflection of the relative trigger that is stated."""
    there, _ = _counts_of(channel, path)
    stated = VOLTS.fullmatch(head.settings.get(TRIGGER, ""))
    if head.settings.get("Trigger mode") != "Relative" or stated is None:
        return False
    rise = counts[:, 0] - np.median(counts[:, there - max(round(FAR * there), 1) : there], axis=1)
    volts, wanted = float(np.median(rise)) * _least(channel, path), float(stated["hard"])
    return abs(volts - wanted) <= SAME_TRIGGER * abs(wanted)


def _turned(values: Array, first: int) -> Array:
    """Return points in the order of time: extension is stored backwards."""
    return np.concatenate([values[:first][::-1], values[first:]])


def _volts(text: str, what: str, path: Path) -> re.Match[str]:
    match = VOLTS.fullmatch(text)
    if match is None:
        raise InvalidInput(f"{path}: {what} is '{text[:60]}'; it must state volts for the least bit.")
    return match


def _least(channel: _Channel, path: Path) -> float:
    """Return the volts of the least bit."""
    return float(_volts(channel.settings.get("@4:Z scale", ""), f"the scale of '{channel.name}'", path)["least"])


def _sensitivity(channel: _Channel, head: _Head, given: GivenFacts, path: Path) -> tuple[float, str]:
    """Return deflection per volt [m/V], and where it comes from."""
    if given.sensitivity is not None:
        return given.sensitivity, f"sensitivity {given.sensitivity:g} m/V given"
    soft = _volts(channel.settings.get("@4:Z scale", ""), f"the scale of '{channel.name}'", path)["soft"]
    match = SENSITIVITY.fullmatch(head.settings.get(f"@{soft}", ""))
    if match is None or (not match["unit"] and float(match["number"]) == 1.0):
        raise InvalidInput(
            f"{path}: its deflection is in volts, and '{soft}' is not calibrated; give sensitivity in m/V."
        )
    number = float(match["number"])
    if not match["unit"]:  # some versions leave it out
        return number * 1e-9, f"sensitivity {number:g} from the file, whose unit it leaves out, taken as nm/V"
    if not measures(match["unit"], "m"):
        raise InvalidInput(f"{path}: '{soft}' is in {match['unit']}/V; give sensitivity in m/V.")
    return number * scale(match["unit"], "m"), f"sensitivity {number:g} {match['unit']}/V from the file"


def _sensor_sensitivity(channel: _Channel, head: _Head, path: Path) -> float:
    soft = _volts(channel.settings.get("@4:Z scale", ""), f"the scale of '{channel.name}'", path)["soft"]
    match = SENSITIVITY.fullmatch(head.settings.get(f"@{soft}", ""))
    if match is None or not measures(match["unit"], "m"):
        raise InvalidInput(f"{path}: '{soft}', which makes lengths of the height sensor, is not stated; save it anew.")
    return float(match["number"]) * scale(match["unit"], "m")


def _ramp(channel: _Channel, head: _Head, path: Path) -> tuple[float, float]:
    """Return the size of the ramp [m] and the speed [m/s], zero where it is not stated."""
    stated = {key.lower(): text for key, text in channel.settings.items()}
    match = _volts(stated.get("@4:ramp size", ""), "the size of the ramp", path)
    piezo = SENSITIVITY.fullmatch(head.settings.get(f"@{match['soft']}", ""))
    if piezo is None or not measures(piezo["unit"], "m"):
        raise InvalidInput(f"{path}: '{match['soft']}', which makes lengths of the ramp, is not stated; save it anew.")
    per_volt = float(piezo["number"]) * scale(piezo["unit"], "m")
    return float(match["hard"]) * per_volt, (stated_number(head.settings, "Forward vel.") or 0.0) * per_volt


def _whole_ramp(passes: tuple[int, int], head: _Head) -> tuple[float, float]:
    """Return how many points extension and retraction would have over the whole ramp.

    A trigger ends the extension early, at a point from which the whole ramp is retracted.  Both have one number of
    points over the ramp, or one in a second.
    """
    there, back = passes
    there_speed, back_speed = stated_number(head.settings, "Forward vel."), stated_number(head.settings, "Reverse vel.")
    in_time = back * back_speed / there_speed if there_speed and back_speed else back
    return min((full for full in (float(back), in_time) if full >= there), default=float(there)), float(back)


def _time(passes: tuple[int, int], whole: tuple[float, float], ramp: float, speed: float, head: _Head) -> Array:
    """Return the times of all points [s]; none where a speed is missing."""
    per_volt_free = stated_number(head.settings, "Reverse vel."), stated_number(head.settings, "Forward vel.")
    if not speed > 0.0 or not per_volt_free[0] or not per_volt_free[1]:
        return np.zeros(0)
    back = speed * per_volt_free[0] / per_volt_free[1]
    there, retracts = (
        ramp / rate * np.arange(1, count + 1) / full
        for rate, count, full in zip((speed, back), passes, whole, strict=True)
    )
    return np.concatenate([there, there[-1] + (stated_number(head.settings, "Ramp delay") or 0.0) + retracts])


def _scan(head: _Head) -> tuple[float, tuple[float, float]]:
    """Return the length of a volume and the place of a curve, or of the corner of the volume [m]."""
    size = _length(head.settings.get("Scan Size", "").split())
    x, y = (_length(head.settings.get(f"{axis} Offset", "").split()) for axis in "XY")
    return size, (x, y)


def _length(words: Sequence[str]) -> float:
    try:
        return float(words[0]) * scale(words[-1].replace("~m", "um"), "m")
    except (InvalidInput, ValueError, IndexError):
        return float("nan")


def _whole(settings: dict[str, str], key: str, path: Path) -> int:
    word = (settings.get(key, "").split() or [""])[0]
    if not word.isdecimal() or len(word) > 15:
        raise InvalidInput(f"{path}: its head states '{key}: {settings.get(key, '')[:40]}'; it must be a whole number.")
    return int(word)
