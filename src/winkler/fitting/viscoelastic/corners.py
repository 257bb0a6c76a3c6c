"""Turns of a motion that lie between two measured points.

A machine that stops, or turns, does so between two samples.  Along straight lines from point to point the greatest
depth would be missed by up to a step, and the hold would begin too early.  Where the signal is straight on both sides,
the turn is where the two lines meet; where it is rounded, or its noise is as large as a step, nothing is added.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

FEWEST, LINE_DIVISOR = 6, 20
"""Least points of a line, and parts of a stretch of one direction that make one."""
NEIGHBOURS = (0, -1, 1)
"""Points by which a stretch may begin earlier or later than its direction says."""
MOST_SCATTER = 0.15
"""Greatest scatter about the lines in parts of the change of the step from point to point."""


class Corners(NamedTuple):
    """Turns between points: index of the point before, time [s] and signal, each ``(c,)``."""

    before: Array
    time: Array
    signal: Array


def corners_of(time: Array, signal: Array, direction: Array) -> Corners:
    """Return the turns between measured points.

    Parameters
    ----------
    time, signal : ndarray, (n,)
        [s], and what the machine drives: positions [m] or forces [N].
    direction : ndarray, (n,)
        +1 going in, -1 coming out, 0 held.
    """
    ends = np.flatnonzero(np.diff(direction)) + 1
    limits = [0, *ends.tolist(), time.size]
    found = []
    for start, end, stop in zip(limits[:-2], limits[1:-1], limits[2:], strict=True):
        for moved in NEIGHBOURS:
            met = _meeting(time, signal, (start, end + moved, stop))
            if met is not None:
                found.append(met)
                break
    columns = np.array(found, dtype=float).reshape(-1, 3).T
    return Corners(columns[0].astype(int), columns[1], columns[2])


def _meeting(time: Array, signal: Array, limits: tuple[int, int, int]) -> tuple[int, float, float] | None:
    """Return where the lines before and after the second of three limits meet between the points beside it."""
    start, end, stop = limits
    left = slice(max(start, end - max(FEWEST, (end - start) // LINE_DIVISOR)), end)
    right = slice(end, min(stop, end + max(FEWEST, (stop - end) // LINE_DIVISOR)))
    if min(left.stop - left.start, right.stop - right.start) < FEWEST:
        return None
    origin = float(time[end - 1])
    step = float(time[end]) - origin
    if not step > 0.0:
        return None
    rate, level, scatter = _line(time[left] - origin, signal[left])
    other, beyond, rest = _line(time[right] - origin, signal[right])
    change = abs(other - rate)
    if change == 0.0 or max(scatter, rest) > MOST_SCATTER * change * step:
        return None
    meeting = (level - beyond) / (other - rate)
    return (end - 1, origin + meeting, level + rate * meeting) if 0.0 < meeting < step else None


def _line(since: Array, signal: Array) -> tuple[float, float, float]:
    """Return slope, level at time zero, and scatter of a straight line through points."""
    middle, mean = float(since.mean()), float(signal.mean())
    away = since - middle
    square = float(away @ away)
    slope = float(away @ (signal - mean)) / square if square > 0.0 else 0.0
    left = signal - mean - slope * away
    return slope, mean - slope * middle, float(np.sqrt(left @ left / (since.size - 2)))


def with_corners(corners: Corners, time: Array, signal: Array, driven: Array) -> tuple[Array, Array, Array]:
    """Return times, the driven quantity, and whether a point was measured, with the corners among the points.

    Parameters
    ----------
    corners : Corners
        Of `signal`.
    time, signal : ndarray, (n,)
        As measured.
    driven : ndarray, (n,)
        The signal less what is subtracted from it, such as a contact point or a drift; between two points linear.
    """
    place = corners.before + 1
    share = (corners.time - time[corners.before]) / (time[place] - time[corners.before])
    offset = driven - signal
    between = (1.0 - share) * offset[corners.before] + share * offset[place]
    measured = np.insert(np.ones(time.size, dtype=bool), place, False)
    return np.insert(time, place, corners.time), np.insert(driven, place, corners.signal + between), measured
