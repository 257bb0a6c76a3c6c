"""The columns of a curve in which events are sought, and robust measures of their noise."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.directions import IN, OUT
from winkler.fitting.curves.medians import median
from winkler.fitting.curves.segments import Segment, segments_of
from winkler.numerics.types import Array

MAD_TO_SIGMA = 1.4826
"""Standard deviation of Gaussian noise over its median absolute deviation."""


class Record(NamedTuple):
    """Columns of a curve in the order of measurement.

    Parameters
    ----------
    position, force, time, direction : ndarray, (n,)
        [m], [N], [s] and +1, 0, -1; `time` is empty where it is unknown.
    marks : ndarray, (n,) or (0,)
        What is stated of each point, see `winkler.fitting.curves.events.stated`; empty: events are found.
    compliance : float
        [m/N] of the machine.
    """

    position: Array
    force: Array
    time: Array
    direction: Array
    marks: Array
    compliance: float

    @property
    def length(self) -> int:
        """Number of points."""
        return int(self.position.size)

    @property
    def timed(self) -> bool:
        """Whether the times are known, and grow."""
        return bool(self.time.size) and float(np.ptp(self.time)) > 0.0

    @property
    def segments(self) -> tuple[Segment, ...]:
        """The segments by their directions."""
        return segments_of(self.direction, self.force)

    @property
    def incoming(self) -> slice:
        """The points of the first motion towards the sample; empty if there is none."""
        inward = np.flatnonzero(self.direction == IN)
        if not inward.size:
            return slice(0, 0)
        first = int(inward[0])
        turns = np.flatnonzero(self.direction[first:] != IN)
        return slice(first, first + int(turns[0]) if turns.size else self.length)

    @property
    def outgoing(self) -> slice:
        """The points of the last motion away from the sample; empty if there is none."""
        outward = np.flatnonzero(self.direction == OUT)
        if not outward.size:
            return slice(0, 0)
        last = int(outward[-1])
        turns = np.flatnonzero(self.direction[:last] != OUT)
        return slice(int(turns[-1]) + 1 if turns.size else 0, last + 1)


def deviation(samples: Array) -> float:
    """Return the standard deviation of samples by their median absolute deviation; zero of none."""
    if not samples.size:
        return 0.0
    return MAD_TO_SIGMA * median(np.abs(samples - median(samples)))


def moving_mean(samples: Array, width: int) -> Array:
    """Return the means of `width` neighbours ``(n - width + 1,)``."""
    sums = np.concatenate([[0.0], np.cumsum(samples - samples[:1])])
    return np.asarray((sums[width:] - sums[:-width]) / width + samples[0])
