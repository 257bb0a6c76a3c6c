"""Thermal drift of the depth, measured while the tip is held under a small force, with its standard error.

A hold measures it only in contact: in air the tip moves as the machine pleases, and a rate found there, multiplied by
the time of the test, can exceed the depth.  What a hold shows is not subtracted either where the correction would
exceed a bound, or where the hold is so short that its error, not its rate, would be subtracted.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import Segment, SegmentKind
from winkler.fitting.nanoindentation.touch import white_noise
from winkler.fitting.nanoindentation.zero_point import IN_CONTACT, ZeroPoint, found_zero_point
from winkler.fitting.noise.estimate import noise_of
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit
from winkler.values.value import value, words

LARGEST_SHARE = 0.25
"""Greatest force of the hold, in parts of the greatest of the curve: above it the sample creeps."""
AFTER = (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING)
"""What a hold follows that measures drift: after a loading the sample creeps."""
LEAST_POINTS = 20
LARGEST_TRAVEL = 0.1
"""Greatest travel during the hold, in parts of that of the curve: above it the tip is moved, not held."""
EVALUATED_SHARE = 0.6
"""Last part of the hold that is evaluated: at first the sample recovers."""
LARGEST_CORRECTION, LARGEST_DOUBT = 0.2, 0.05
"""Greatest correction of the depth from first touch to the peak, and of its standard error, in parts of that depth."""
SIGNIFICANT = 2.0
"""Least rate over its standard error of a hold whose error alone would be too large a correction."""


@value
class ThermalDrift:
    """Thermal drift: the rate of change of the depth.

    Parameters
    ----------
    rate : float
        [m/s]; zero if the curve has no hold period to measure it.
    error : float
        Its standard error [m/s].
    first, last : int
        Indices of the points that were evaluated; both -1 without a hold.
    doubt : str
        Reason why a hold period does not determine the drift; empty otherwise.
    """

    __words__ = words(
        rate=(r"\dot h_T", "m/s", "thermal drift of the depth"),
        error=(r"u(\dot h_T)", "m/s", "standard error of the drift"),
        first=("", None, "index of the first point"),
        last=("", None, "index of the last point"),
        doubt=("", None, "why a hold that was found measures no drift"),
    )

    rate: float
    error: float
    first: int = -1
    last: int = -1
    doubt: str = ""

    @property
    def measured(self) -> bool:
        """Whether a hold period determines the drift."""
        return self.last > 0


def found_drift(curve: ForceCurve, zero_point: ZeroPoint | tuple[()] = ()) -> ThermalDrift:
    """Return the drift during the longest hold period below a quarter of the maximum force with the tip in contact.

    Parameters
    ----------
    curve : ForceCurve
        A curve with times. Without times, or without such a hold, the rate is zero and its error is not stated.
    zero_point : ZeroPoint, optional
        Point of first touch; found by `found_zero_point` by default.
    """
    holds = _possible_holds(curve)
    if not holds:
        return ThermalDrift(0.0, 0.0)
    touch = zero_point if isinstance(zero_point, ZeroPoint) else _touch(curve)
    in_contact = [hold for hold in holds if _touches(curve, hold, touch)]
    if not in_contact:
        return ThermalDrift(0.0, 0.0, doubt=f"{_named(curve, _longest(curve, holds))} is out of contact")
    hold = _longest(curve, in_contact)
    chosen = _evaluated(hold)
    time, depth = curve.time[chosen], curve.depth(0.0)[chosen]
    centred = time - time.mean()
    length = float(np.ptp(centred))
    if not length > 0.0:
        return ThermalDrift(0.0, 0.0)
    rows = np.stack([np.ones_like(centred), centred / length], axis=1)
    numbers, *_ = np.linalg.lstsq(rows, depth, rcond=None)
    noise = noise_of(depth - rows @ numbers, rows, np.zeros((depth.size, 0)))
    rate, variance = float(numbers[1] + noise.step[1]) / length, float(noise.covariance[1, 1])
    error = math.sqrt(variance) / length if variance >= 0.0 else math.inf  # no variance is negative: it is unknown
    span, deepest = _until_peak(curve, touch)
    correction = f"{_named(curve, hold)} gives {rate:.2g} m/s, uncertain by {error:.1g} m/s"
    if abs(rate) * span > LARGEST_CORRECTION * deepest:
        moved, reached = with_unit(abs(rate) * span, "m", 2), with_unit(deepest, "m", 3)
        return ThermalDrift(0.0, 0.0, doubt=f"{correction}: {moved} during the loading, for a depth of {reached}")
    if abs(rate) < SIGNIFICANT * error and error * span > LARGEST_DOUBT * deepest:
        return ThermalDrift(0.0, 0.0, doubt=f"{correction}, too short to measure it")
    return ThermalDrift(rate, error, chosen.start, hold.last)


def _possible_holds(curve: ForceCurve) -> list[Segment]:
    """Return the holds at small forces that come first or after an unloading."""
    if not curve.timed:
        return []
    top = float(curve.force.max())
    return [
        part
        for before, part in zip((None, *curve.segments), curve.segments, strict=False)
        if part.kind is SegmentKind.HOLD
        and (before is None or before.kind in AFTER)
        and part.count >= LEAST_POINTS
        and float(np.ptp(curve.position[part.first : part.last + 1])) < LARGEST_TRAVEL * float(np.ptp(curve.position))
        and float(np.median(curve.force[part.first : part.last + 1])) < LARGEST_SHARE * top
    ]


def _longest(curve: ForceCurve, holds: list[Segment]) -> Segment:
    return max(holds, key=lambda part: float(curve.time[part.last] - curve.time[part.first]))


def _evaluated(hold: Segment) -> slice:
    return slice(hold.first + round((1.0 - EVALUATED_SHARE) * hold.count), hold.last + 1)


def _touch(curve: ForceCurve) -> ZeroPoint:
    """Return the touch without a correction for drift; the least depth where it cannot be found."""
    try:
        return found_zero_point(curve)
    except InvalidInput:
        return ZeroPoint(float(curve.depth(0.0).min()), 0.0, 0.0, extrapolated=True)


def _touches(curve: ForceCurve, hold: Segment, touch: ZeroPoint) -> bool:
    """Return whether the tip is in contact in the evaluated part of a hold."""
    chosen = _evaluated(hold)
    force, depth = float(np.median(curve.force[chosen])), float(np.median(curve.depth(0.0)[chosen]))
    noise = white_noise(curve.force[chosen])
    return force > touch.baseline + IN_CONTACT * noise and depth > touch.position - IN_CONTACT * touch.error


def _named(curve: ForceCurve, hold: Segment) -> str:
    begin, end = (with_unit(float(curve.time[place]), "s", 3) for place in (hold.first, hold.last))
    return f"the hold from {begin} to {end}"


def _until_peak(curve: ForceCurve, touch: ZeroPoint) -> tuple[float, float]:
    """Return the time [s] from first touch to the greatest force, and the depth [m] there."""
    depth, peak = curve.depth(touch.position), int(np.argmax(curve.force))
    before = np.flatnonzero(depth[: peak + 1] <= 0.0)
    start = int(before[-1]) if before.size else 0
    return float(curve.time[peak] - curve.time[start]), max(float(depth[peak]), 0.0)
