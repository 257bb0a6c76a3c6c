"""The unloading of a force curve in parts of its peak: measured at the end of a hold, or where the path turns."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.noise.estimate import noise_of
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

FEWEST = 10
"""Points of an unloading below which none is evaluated."""
HOLD_END_SHARE = 0.1
"""Last part of a hold that defines the peak."""
ERROR_SHARE, MEDIAN_OF_NORMAL = 0.3, 0.6745
"""Last part of a hold whose noise is that of the peak, and median of the size of a normal variable."""


class UnloadingFromPeak(NamedTuple):
    """An unloading: indices in the curve, depths and forces in parts of the peak, and the peak [m, N].

    Last are whether it follows a hold, and the standard error of the depth at the peak by noise [m].
    """

    points: Array
    depth: Array
    force: Array
    deepest: float
    highest: float
    held: bool
    depth_error: float


def unloading_from_peak(curve: ForceCurve, points: Array, hold: Array, contact_point: float) -> UnloadingFromPeak:
    """Return an unloading in parts of its peak.

    Parameters
    ----------
    curve : ForceCurve
    points, hold : ndarray
        Indices of the unloading, and of the hold just before it, empty without one.
    contact_point : float
        Position of first touch [m].

    Raises
    ------
    InvalidInput
        If there are too few points, or depth or force of the peak are not positive.
    """
    if points.size < FEWEST:
        raise InvalidInput(
            f"OliverPharr: curve '{curve.name}' has no unloading of at least {FEWEST} points; check its "
            "segments, and state them by with_segments if they are wrong."
        )
    depth, force = curve.depth(contact_point), curve.force
    end = hold[-max(1, int(HOLD_END_SHARE * hold.size)) :] if hold.size else np.array([max(points[0] - 1, 0)])
    if not hold.size:
        points = np.union1d(end, points)
    deepest, highest = float(np.median(depth[end])), float(np.median(force[end]))
    if not highest > 0.0 or not deepest > 0.0:
        raise InvalidInput(
            f"OliverPharr: at the peak, {deepest:.3g} m deep, the force is {highest:.3g} N; both must be positive: "
            "check signs and contact_point."
        )
    return UnloadingFromPeak(
        points,
        depth[points] / deepest,
        force[points] / highest,
        deepest,
        highest,
        bool(hold.size),
        _error(depth, points, hold),
    )


def _error(depth: Array, points: Array, hold: Array) -> float:
    """Return the standard error of the depth at the end of a hold, or of that of a single point, by noise."""
    if hold.size < FEWEST:
        third = np.diff(depth[points], 3)
        return float(np.median(np.abs(third))) / (MEDIAN_OF_NORMAL * math.sqrt(20.0)) if third.size else 0.0
    end = hold[-max(FEWEST, int(ERROR_SHARE * hold.size)) :]
    rows = np.stack([np.ones(end.size), np.linspace(-1.0, 0.0, end.size)], axis=1)
    residuals = depth[end] - rows @ np.linalg.lstsq(rows, depth[end], rcond=None)[0]
    if not float(np.ptp(residuals)) > 0.0:
        return 0.0
    return math.sqrt(max(float(noise_of(residuals, rows, np.zeros((end.size, 0))).covariance[0, 0]), 0.0))
