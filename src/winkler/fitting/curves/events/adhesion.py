"""Tension next to the free part of a branch: snap-in on approach, pull-off on retraction."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.events.free import FreeBranch
from winkler.fitting.curves.events.record import deviation, moving_mean
from winkler.fitting.curves.events.steps import found_steps
from winkler.numerics.types import Array

__all__ = ["Tension", "tension"]

LEAST_RATIO = 6.0
"""Least tension over the noise of its measurement."""
LEAST_SHARE = 2e-3
"""Least tension relative to the range of the force."""
BASE_LENGTH = 8
"""Length of the free part next to the tension, in averaged neighbours, from which it counts."""
COMPRESSION_RATIO = 5.0
SHARP_WIDTH, SHARP_RATIO = 3, 20.0
"""Neighbours whose mean is the tension where it is clearly above the noise, and its least ratio to their noise."""


class Tension(NamedTuple):
    """Points from the far end on, tension [N] with its standard error, and whether it begins with a step."""

    first: int
    last: int
    size: float
    error: float
    sudden: bool


def tension(force: Array, branch: FreeBranch) -> Tension | None:
    """Return the tension between the free part of a branch and compression; None if there is none.

    Parameters
    ----------
    force : ndarray, (n,)
        From the far end on [N].
    branch : FreeBranch
    """
    width, free = branch.averaged, branch.points
    if not free or free + 2 * width > force.size:
        return None
    above = force - branch.line(force.size)
    base_length = min(BASE_LENGTH * width, free)
    means = moving_mean(above, width)
    compressed = means > max(COMPRESSION_RATIO * branch.mean_noise, LEAST_SHARE * float(np.ptp(force)))
    behind = np.flatnonzero(compressed[free:])
    end = free + int(behind[0]) if behind.size else means.size
    begin = max(free - base_length, 0)
    if end <= begin:
        return None
    lowest = begin + int(np.argmin(means[begin:end]))
    base = float(above[max(free - base_length, 0) : free].mean())
    size = base - float(means[lowest])
    changes = means[base_length : max(free - width, base_length)]
    bases = moving_mean(above[:free], base_length)[: changes.size]
    error = max(deviation(changes - bases), branch.noise * np.sqrt(1.0 / width + 1.0 / base_length))
    if not size > max(LEAST_RATIO * error, LEAST_SHARE * float(np.ptp(force))):
        return None
    half = np.flatnonzero(means[begin : lowest + 1] < base - 0.5 * size)
    first = begin + int(half[0]) + width // 2
    span = slice(max(first - 60, 0), min(first + 60, force.size))
    sudden = any(abs(step.place + span.start - first) <= 2 * width for step in found_steps(force[span], -1.0))
    sharp_error = branch.noise / np.sqrt(SHARP_WIDTH)
    if size > SHARP_RATIO * sharp_error and width > SHARP_WIDTH:  # a long mean would smooth the tip of it
        sharp = moving_mean(above, SHARP_WIDTH)[begin : end + width - SHARP_WIDTH]
        size, error, lowest = base - float(sharp.min()), max(sharp_error, error), begin + int(np.argmin(sharp))
        return Tension(min(first, lowest), lowest + 1, size, error, sudden)
    return Tension(first, lowest + width // 2, size, error, sudden)
