"""Tests that follow each other in one table: where each begins.

Within a test the force starts low, passes a peak and ends low.  A new test begins where rows are left blank or the
header is repeated, where the time falls, or where the position jumps back, if both sides are such tests.  Specimens
that break do not end low: where below each repeated header the time begins again, and the position where it began, each
header begins a test.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from winkler.numerics.types import Array

LOW = 0.3
"""Greatest force at both ends of a test, in parts of its peak."""
LEAST_PEAK = 0.01
"""Least peak of a test, in parts of the greatest force of all."""
LEAST_POINTS = 10
SAME_BEGIN = 0.05
"""Greatest distance of the first positions and times below two headers, in parts of the whole travel and time."""
LEAST_JUMP, JUMP_TO_STEP = 0.25, 30.0
"""Least jump back between two tests without blank rows or times, in parts of the travel of the first and of the usual
step."""


def parts_of_tests(position: Array, force: Array, time: Array, rows: Array) -> list[slice]:
    """Return the rows of each test, one slice if the table holds one.

    Parameters
    ----------
    position, force : ndarray, (n,)
        [m] and [N].
    time : ndarray, (n,) or (0,)
        [s].
    rows : ndarray, (n,)
        Numbers of the rows in the file: they jump where rows are blank.
    """
    if position.size < 2 * LEAST_POINTS:
        return [slice(0, position.size)]
    step, gap = np.diff(position), np.diff(rows)
    usual = float(np.median(np.abs(step)))
    back = step < -JUMP_TO_STEP * usual
    falls = np.diff(time) < 0.0 if time.size else np.zeros(step.size, dtype=bool)
    parted = (gap > np.median(gap)) | falls
    greatest = float(force.max())
    low = (force[1:] < LOW * greatest) & (force[:-1] < LOW * greatest)
    begins = np.append(0, np.flatnonzero((parted | back) & low) + 1)
    tops = np.maximum.reduceat(force, begins)
    rest = np.maximum.accumulate(tops[::-1])[::-1]
    starts, top = [0], float(tops[0])
    ends = [*begins[1:].tolist(), position.size]
    for place, begin in enumerate(begins.tolist()):
        if not place:
            continue
        before = starts[-1]
        behind = any(
            _is_test(force, begin, end, peak, greatest)
            for end, peak in ((ends[place], float(tops[place])), (position.size, float(rest[place])))
        )
        is_new = parted[begin - 1] or -step[begin - 1] > LEAST_JUMP * float(np.ptp(position[before:begin]))
        if behind and is_new and _is_test(force, before, begin, top, greatest):
            starts.append(begin)
            top = float(tops[place])
        else:
            top = max(top, float(tops[place]))
    return [slice(first, last) for first, last in zip(starts, [*starts[1:], position.size], strict=True)]


def parts_by_headers(position: Array, time: Array, rows: Array, repeats: Sequence[int]) -> list[slice]:
    """Return the rows below each header, if time and position begin anew at each; none else.

    Parameters
    ----------
    position, time : ndarray, (n,) or (0,)
        [m] and [s].
    rows : ndarray, (n,)
        Numbers of the rows in the file.
    repeats : sequence of int
        Lines of repeated headers.
    """
    begins = sorted({0, *np.searchsorted(rows, repeats).tolist()})
    ends = [*begins[1:], position.size]
    if (
        len(begins) < 2
        or not time.size
        or min(end - begin for begin, end in zip(begins, ends, strict=True)) < LEAST_POINTS
    ):
        return []
    anew = all(
        float(np.ptp(values[begins])) <= SAME_BEGIN * float(np.ptp(values)) for values in (position, time)
    ) and all(time[begin] < time[begin - 1] for begin in begins[1:])
    return [slice(begin, end) for begin, end in zip(begins, ends, strict=True)] if anew else []


def _is_test(force: Array, first: int, end: int, top: float, greatest: float) -> bool:
    """Return whether a part with the peak `top` starts low, and ends low."""
    ends = max(float(force[first]), float(force[end - 1]))
    return end - first >= LEAST_POINTS and top > LEAST_PEAK * greatest and ends < LOW * top
