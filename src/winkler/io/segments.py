"""Directions of the segments of a measurement: the tip approaches, is held, or retracts."""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.directions import HELD, IN, OUT, found_directions
from winkler.numerics.types import Array

LEAST_POINTS = 10
"""Of a segment with fewer points only its ends are compared."""
LARGEST_HOLD_TRAVEL = 0.5
"""Largest travel during a hold, relative to the whole travel."""
LEAST_TRAVEL = 0.1
"""Least travel between the ends of a short segment in which the tip is not held, relative to the whole travel."""
STEADY_FORCE_CHANGE = 0.02
"""Relative change of force below which the force is held."""
LEAST_FORCE_CHANGE = 0.2
"""Least change of force with the position, relative to the whole, of a stiff contact that hardly travels."""
LEAST_STIFF_TRAVEL, TRAVEL_TO_NOISE = 1e-3, 3.0
"""Least travel of a stiff contact, relative to the whole travel and to the noise of its ends."""
END_SHARE = 20
"""The ends of a segment are means of this part of its points."""
LARGEST_EXCURSION, LARGEST_FORCE_EXCURSION = 0.1, 0.25
"""Greatest distance of a position within a segment from its ends, and of a force above them, relative to the whole."""
EXTREMES = (0.02, 0.98)
"""Quantiles that are taken for the extremes of a segment."""
LEAST_JUMP = 0.5
"""Least part of the whole travel by which a segment that is written backwards begins farther off than it ends."""


def directions(position: Array, force: Array, segment: Array) -> Array:
    """Return +1 where the tip approaches, 0 where it is held and -1 where it retracts ``(n,)``.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N].
    segment : ndarray, (n,) or (0,)
        The segment number of each point; the direction of most points of a segment holds for all of them, unless the
        tip turns within it.  Without segments, or with one number throughout, the tip is held if the force or the
        position is constant, else an empty array is returned.
    """
    numbers = np.unique(segment)
    if numbers.size < 2:
        steady = np.ptp(force) < STEADY_FORCE_CHANGE * np.abs(force).max(initial=0.0) or np.ptp(position) == 0.0
        return np.full(position.size, HELD) if steady else np.zeros(0)
    point_directions, direction, span = np.zeros(0), np.empty(position.size), np.ptp(position)
    turning = turning_segments(position, force, segment)
    for part in numbers:
        (inside,) = np.nonzero(segment == part)
        if part in turning:
            point_directions = point_directions if point_directions.size else found_directions(position, force)
            direction[inside] = point_directions[inside]
            continue
        travel = position[inside[-1]] - position[inside[0]]
        if stiff := _stiff_direction(position, force, inside):
            direction[inside] = stiff
            continue
        if inside.size < LEAST_POINTS or abs(travel) > LARGEST_HOLD_TRAVEL * span:
            direction[inside] = np.sign(travel) if abs(travel) > LEAST_TRAVEL * span else HELD
            continue
        point_directions = point_directions if point_directions.size else found_directions(position, force)
        counts = [np.count_nonzero(point_directions[inside] == sign) for sign in (IN, OUT, HELD)]
        direction[inside] = (IN, OUT, HELD)[int(np.argmax(counts))]
    return direction


def is_written_backwards(before: Array, positions: Array) -> bool:
    """Return whether a segment ends where the one before it does: it was written from its end, as of a way back.

    Parameters
    ----------
    before, positions : ndarray, (n,) and (m,)
        Of the segment before it, in the order of time, and of the segment as it is written.
    """
    start, end = abs(float(positions[0] - before[-1])), abs(float(positions[-1] - before[-1]))
    return start - end > LEAST_JUMP * max(float(np.ptp(before)), float(np.ptp(positions)))


def segment_fact(position: Array, force: Array, segment: Array, name: str) -> str:
    """Return whether the segments of a column were believed, as a phrase for the reading; empty without a column."""
    if not segment.size:
        return ""
    if np.unique(segment).size < 2:
        return f"'{name}' has one number throughout and says nothing: turns are those of position and force"
    turning = turning_segments(position, force, segment)
    listed = ", ".join(f"{part:g}" for part in turning[:5])
    doubt = f", but the tip turns within {listed}, whose turns are those of position and force"
    return f"segments from '{name}'{doubt * bool(turning)}"


def turning_segments(position: Array, force: Array, segment: Array) -> tuple[float, ...]:
    """Return the numbers of segments in which the tip turns: what the file calls one segment is several.

    Parameters
    ----------
    position, force, segment : ndarray, (n,)
        As for `directions`.
    """
    spans = float(np.ptp(position)), float(np.ptp(force))
    found = []
    for part in np.unique(segment):
        (inside,) = np.nonzero(segment == part)
        if inside.size < 2 * LEAST_POINTS:
            continue
        count = 1 + inside.size // END_SHARE
        ends = np.array([[column[ends].mean() for ends in (inside[:count], inside[-count:])]
                         for column in (position, force)])  # fmt: skip
        low, high = np.quantile(position[inside], EXTREMES)
        beyond = max(ends[0].min() - low, high - ends[0].max())
        above = float(np.quantile(force[inside], EXTREMES[1])) - float(ends[1].max())
        if beyond > LARGEST_EXCURSION * spans[0] or above > LARGEST_FORCE_EXCURSION * spans[1]:
            found.append(float(part))
    return tuple(found)


def _stiff_direction(position: Array, force: Array, inside: Array) -> float:
    """Return the direction of a segment whose force changes with its position, however little it travels; 0 if not.

    A hold either keeps its position, or its force, or they change against each other as the contact relaxes.
    """
    count = 1 + inside.size // END_SHARE
    begin, end = inside[:count], inside[-count:]
    travel, change = (float(column[end].mean() - column[begin].mean()) for column in (position, force))
    bends = np.abs(np.diff(position[inside], 2))
    noise = float(np.median(bends)) / (0.6745 * np.sqrt(6.0)) * np.sqrt(2.0 / count) if bends.size else 0.0
    least = max(LEAST_STIFF_TRAVEL * float(np.ptp(position)), TRAVEL_TO_NOISE * noise)
    if abs(travel) <= least or abs(change) <= LEAST_FORCE_CHANGE * float(np.ptp(force)) or travel * change <= 0.0:
        return 0.0
    return float(np.sign(travel))
