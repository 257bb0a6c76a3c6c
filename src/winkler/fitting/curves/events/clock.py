"""Clock offset: the force is recorded later or earlier than the position.

Where the machine turns, stops or starts in contact, position and force have a kink at the same time, whatever the body
is made of.  Each kink is located between the points, in both signals, by two parabolas that meet there.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.events.record import Record, deviation
from winkler.numerics.types import Array

FEWEST_POINTS, MOST_POINTS = 8, 40
"""Points on each side of a kink."""
MOST_LATE = 150
"""Greatest offset that is sought, in points."""
LEAST_KINK_RATIO = 8.0
"""Least change of slope over its standard error."""
LEAST_RATIO, LEAST_POINTS = 6.0, 0.5
"""Least offset over its standard error, and in points."""
MOST_CHI_SQUARE = 9.0
"""Greatest squared difference between the offsets of two edges, over its variance."""
LEAST_FORCE_SHARE = 0.2
"""Least force at an edge above the least force, in parts of the range: at first contact the force has no kink."""
MOST_LEFT_RATIO, MOST_LEFT_SHARE = 2.0, 1e-3
"""Greatest scatter about two parabolas over the noise between neighbours, or else over the range of the signal."""
SYSTEMATIC_POINTS = 0.05
"""Error of a kink between points that two parabolas leave, in points."""


class ClockOffset(NamedTuple):
    """Time by which the force is late [s], its standard error, and the points next to the kinks."""

    offset: float
    error: float
    edges: tuple[int, ...]

    @property
    def ratio(self) -> float:
        """Offset over error."""
        return abs(self.offset) / self.error if self.error > 0.0 else math.inf


class _Kink(NamedTuple):
    time: float
    error: float
    ratio: float


def clock_offset_of(record: Record, contact: Array) -> ClockOffset | None:
    """Return the offset if the edges of the motion determine it, also if it is zero within its error; None if not.

    Parameters
    ----------
    record : Record
        With times.
    contact : ndarray, (n,)
        Truth values of the points in contact.
    """
    if not record.timed:
        return None
    loaded = contact & (record.force > record.force.min() + LEAST_FORCE_SHARE * float(np.ptp(record.force)))
    turns = (np.flatnonzero(np.diff(record.direction)) + 1).tolist()
    bounds = [0, *turns, record.length]
    found: list[tuple[int, float, float]] = []
    for place, turn in enumerate(turns, start=1):
        space = min(turn - bounds[place - 1], bounds[place + 1] - turn)
        if space < 2 * FEWEST_POINTS or not loaded[turn]:
            continue
        reach = min(space // 2, MOST_LATE)
        kinks = [_kink(record.time, signal, turn, reach) for signal in (record.position, record.force)]
        if all(kink is not None and kink.ratio > LEAST_KINK_RATIO for kink in kinks):
            of_position, of_force = (kink for kink in kinks if kink is not None)
            found.append((turn, of_force.time - of_position.time, math.hypot(of_position.error, of_force.error)))
    if not found:
        return None
    offsets, errors = np.array([each[1] for each in found]), np.array([each[2] for each in found])
    weights = errors**-2.0
    offset, error = float(weights @ offsets / weights.sum()), float(weights.sum() ** -0.5)
    if np.any((offsets - offset) ** 2 > MOST_CHI_SQUARE * errors**2):
        return None
    return ClockOffset(offset, error, tuple(each[0] for each in found))


def is_certain(offset: ClockOffset, record: Record) -> bool:
    """Return whether an offset differs from zero, by more than its error and by a part of the sampling."""
    sampling = float(np.median(np.diff(record.time)))
    return offset.ratio > LEAST_RATIO and abs(offset.offset) > LEAST_POINTS * sampling


def _kink(time: Array, signal: Array, turn: int, reach: int) -> _Kink | None:
    """Return the sharpest kink within `reach` of a point."""
    size = int(np.clip(reach // 2, FEWEST_POINTS // 2, MOST_POINTS))
    first, last = max(turn - reach, size), min(turn + reach, signal.size - size)
    if last - first < 3:
        return None
    along = np.arange(size) - 0.5 * (size - 1)
    slopes = np.correlate(signal - signal[0], along, mode="valid")  # of the points from each one on
    centres = np.arange(first, last)
    centre = int(centres[np.argmax(np.abs(slopes[centres] - slopes[centres - size]))])
    size = int(np.clip(2 * size, FEWEST_POINTS, MOST_POINTS))
    located = []
    for reached in (size, size // 2):
        own = np.arange(max(centre - reached, 0), min(centre + reached + 1, signal.size))
        located.append(_located(time[own] - time[centre], signal[own], time[centre]))
    wide, narrow = located
    if wide is None or narrow is None:
        return None
    # where a parabola does not describe one side, the kink moves with the window
    error = math.hypot(max(wide.error, narrow.error), wide.time - narrow.time)
    return _Kink(narrow.time, error, min(wide.ratio, narrow.ratio))


def _located(time: Array, signal: Array, origin: float) -> _Kink | None:
    sampling = float(np.ptp(time)) / max(time.size - 1, 1)
    if not sampling > 0.0:
        return None
    span = float(np.ptp(signal))
    if not span > 0.0:
        return None
    x, y = time / sampling, (signal - signal.mean()) / span
    widest = 0.4 * min(-x[0], x[-1])
    trials = np.arange(-widest, widest + 0.25, 0.25)
    if trials.size < 5:
        return None
    left = np.array([_squares(x, y, at) for at in trials])
    best = int(np.clip(np.argmin(left), 1, trials.size - 2))
    low, middle, high = left[best - 1 : best + 2]
    bend = low - 2.0 * middle + high
    at = float(trials[best] + 0.25 * 0.5 * (low - high) / bend) if bend > 0.0 else float(trials[best])
    columns = _columns(x, at)
    numbers = np.linalg.lstsq(columns, y, rcond=None)[0]
    rest = y - columns @ numbers
    freedom = max(x.size - 6, 1)
    variance = float(rest @ rest) / freedom
    noise = deviation(np.diff(y, 2)) / math.sqrt(6.0)
    if math.sqrt(variance) > max(MOST_LEFT_RATIO * noise, MOST_LEFT_SHARE):
        return None
    # the derivative with respect to the place of the kink joins the columns
    moved = (_columns(x, at + 0.01)[:, 3:] - columns[:, 3:]) @ numbers[3:] / 0.01
    design = np.column_stack([columns, moved])
    sizes = np.linalg.norm(design, axis=0)
    if not np.all(sizes > 0.0):  # no bend: its place moves nothing
        return None
    spread = np.linalg.pinv((design / sizes).T @ (design / sizes)) / np.outer(sizes, sizes)
    error = math.sqrt(variance * float(spread[5, 5]) + SYSTEMATIC_POINTS**2)
    if float(spread[3, 3]) < 0.0 or float(spread[5, 5]) < 0.0:  # a variance that is not positive is unknown
        return None
    kink_error = math.sqrt(variance * float(spread[3, 3]))
    ratio = abs(float(numbers[3])) / kink_error if kink_error > 0.0 else math.inf
    return _Kink(origin + at * sampling, error * sampling, ratio)


def _columns(x: Array, at: float) -> Array:
    behind = np.maximum(x - at, 0.0)
    return np.stack([np.ones(x.size), x, x**2, behind, behind**2], axis=1)


def _squares(x: Array, y: Array, at: float) -> float:
    columns = _columns(x, at)
    rest = y - columns @ np.linalg.lstsq(columns, y, rcond=None)[0]
    return float(rest @ rest)
