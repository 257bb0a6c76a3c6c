"""The point of first touch with a known tip: by its area function and the elastic rim that an unloading shows."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.nanoindentation.readings import area_of
from winkler.fitting.nanoindentation.zero_point import ZeroPoint, found_zero_point
from winkler.numerics.types import Array

__all__ = ["touched"]

INTERCEPT = 0.75
SECANT = (0.75, 0.95)
"""Parts of the peak between which an unloading is taken as straight: its compliance is needed to a few per cent."""
MOST_DOUBT = 3.0
"""Greatest contribution of the difference of the two laws, in standard errors of the better one."""


def touched(curve: ForceCurve, area: Sequence[float] | Array) -> ZeroPoint:
    """Return the touch by a power of the depth or, where it is known, by the area function of the tip.

    The two laws fail differently, the power where the exponent changes, the area function where the hardness
    does: their difference is taken as the half-width of a uniform distribution, and added to the error.
    """
    plain = found_zero_point(curve)
    rim = _rim(curve, plain, np.asarray(area, dtype=float)) if len(area) else 0.0
    if not rim > 0.0:
        return plain
    known = found_zero_point(curve, area, rim)
    doubt = min(abs(known.position - plain.position), MOST_DOUBT * known.error) / math.sqrt(3.0)
    return dataclasses.replace(known, error=math.hypot(known.error, doubt))


def _rim(curve: ForceCurve, touch: ZeroPoint, area: Array) -> float:
    """Return epsilon F/(S sqrt(A)) at the peak of the deepest unloading; zero if it cannot be read."""
    unloadings = [
        part for part in curve.segments if part.kind in (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING)
    ]
    if not unloadings:
        return 0.0
    part = max(unloadings, key=lambda one: float(curve.force[one.first : one.last + 1].max()))
    depth, force = (x[part.first : part.last + 1] for x in (curve.depth(touch.position), curve.force - touch.baseline))
    peak = float(force.max())
    chosen = (force > SECANT[0] * peak) & (force < SECANT[1] * peak)
    if np.count_nonzero(chosen) < 3:
        return 0.0
    elastic = INTERCEPT * peak * float(np.polyfit(force[chosen], depth[chosen], 1)[0])
    size = float(area_of(area, np.asarray(float(depth.max()) - elastic)))
    return elastic / math.sqrt(size) if size > 0.0 else 0.0
