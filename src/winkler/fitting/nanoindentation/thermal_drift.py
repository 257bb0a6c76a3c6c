"""Thermal drift of the depth, measured while the tip is held under a small force, with its standard error."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.noise.estimate import noise_of
from winkler.values import value, words

__all__ = ["ThermalDrift", "found_drift"]

LARGEST_SHARE = 0.25
"""Greatest force of the hold, in parts of the greatest of the curve: above it the sample creeps."""
AFTER = (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING)
"""What a hold follows that measures drift: after a loading the sample creeps."""
LEAST_POINTS = 20
LARGEST_TRAVEL = 0.1
"""Greatest travel during the hold, in parts of that of the curve: above it the tip is moved, not held."""
EVALUATED_SHARE = 0.6
"""Last part of the hold that is evaluated: at first the sample recovers."""


@value
class ThermalDrift:
    """Rate at which the depth drifts.

    Parameters
    ----------
    rate : float
        [m/s]; zero where no hold measures it.
    error : float
        Its standard error [m/s].
    first, last : int
        Indices of the points that were evaluated; both -1 without a hold.
    """

    __words__ = words(
        rate=(r"\dot h_T", "m/s", "thermal drift of the depth"),
        error=(r"u(\dot h_T)", "m/s", "standard error of the drift"),
        first=("", None, "index of the first point"),
        last=("", None, "index of the last point"),
    )

    rate: float
    error: float
    first: int = -1
    last: int = -1

    @property
    def measured(self) -> bool:
        """Whether a hold measures it."""
        return self.last > 0


def found_drift(curve: ForceCurve) -> ThermalDrift:
    """Return the drift during the longest hold at less than a quarter of the greatest force, after an unloading or
    first.

    Parameters
    ----------
    curve : ForceCurve
        With times; without them, or without such a hold, the rate is zero and nothing is said of its error.
    """
    if not curve.timed:
        return ThermalDrift(0.0, 0.0)
    top = float(curve.force.max())
    holds = [
        part
        for before, part in zip((None, *curve.segments), curve.segments, strict=False)
        if part.kind is SegmentKind.HOLD
        and (before is None or before.kind in AFTER)
        and part.count >= LEAST_POINTS
        and float(np.ptp(curve.position[part.first : part.last + 1])) < LARGEST_TRAVEL * float(np.ptp(curve.position))
        and float(np.median(curve.force[part.first : part.last + 1])) < LARGEST_SHARE * top
    ]
    if not holds:
        return ThermalDrift(0.0, 0.0)
    hold = max(holds, key=lambda part: float(curve.time[part.last] - curve.time[part.first]))
    first = hold.first + round((1.0 - EVALUATED_SHARE) * hold.count)
    chosen = slice(first, hold.last + 1)
    time, depth = curve.time[chosen], curve.depth(0.0)[chosen]
    centred = time - time.mean()
    length = float(np.ptp(centred))
    if not length > 0.0:
        return ThermalDrift(0.0, 0.0)
    rows = np.stack([np.ones_like(centred), centred / length], axis=1)
    numbers, *_ = np.linalg.lstsq(rows, depth, rcond=None)
    noise = noise_of(depth - rows @ numbers, rows, np.zeros((depth.size, 0)))
    rate = float(numbers[1] + noise.step[1]) / length
    return ThermalDrift(rate, math.sqrt(max(float(noise.covariance[1, 1]), 0.0)) / length, first, hold.last)
