"""The unloading of a force curve in parts of its peak: measured at the end of a hold, or where the path turns."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array

__all__ = ["FEWEST", "UnloadingFromPeak", "unloading_from_peak"]

FEWEST = 10
"""Points of an unloading below which none is evaluated."""
HOLD_END_SHARE = 0.1
"""Last part of a hold that defines the peak."""


class UnloadingFromPeak(NamedTuple):
    """An unloading: indices in the curve, depths and forces in parts of the peak, and the peak [m, N]."""

    points: Array
    depth: Array
    force: Array
    deepest: float
    highest: float
    held: bool


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
        points, depth[points] / deepest, force[points] / highest, deepest, highest, bool(hold.size)
    )
