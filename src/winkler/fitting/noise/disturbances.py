"""Courses of disturbances that are no part of a model: drift, tilt, and a difference between the directions."""

from __future__ import annotations

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array

LEAST_OWN_SHARE = 0.05
"""Least part of a course that the courses before do not contain."""


def disturbances_of(curve: ForceCurve, *, of_force: bool = True) -> Array:
    """Return independent courses ``(n, q)`` of unit root mean square and without a mean.

    Parameters
    ----------
    curve : ForceCurve
    of_force : bool, optional
        Whether the force is disturbed (unless given): by a drift in time, or in the
        order of the points where times are unknown, a tilt and a drag; else the position, by a drift.
    """
    drift = curve.time if curve.time.size and np.ptp(curve.time) > 0.0 else np.arange(curve.count, dtype=float)
    courses = [drift, curve.position, curve.direction] if of_force else [drift]
    found: list[Array] = []
    for course in courses:
        centred = course - course.mean()
        whole = float(np.linalg.norm(centred))
        for other in found:
            centred = centred - other * float(other @ centred) / curve.count
        own = float(np.linalg.norm(centred))
        if own > LEAST_OWN_SHARE * whole:
            found.append(centred * np.sqrt(curve.count) / own)
    return np.array(found).T if found else np.zeros((curve.count, 0))
