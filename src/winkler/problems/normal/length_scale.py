"""A length of the order of a problem's own, where the search for a contact radius begins: of its shape or layers."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.media.body_of import thickness_of
from winkler.numerics.equations.roots import rough_root

RADIUS_SHARE = 0.02
"""Of the radius of a body, a contact of ordinary width."""
LAYERED_SHARE = 0.25
"""The same on layers, where narrow contacts take no longer to compute."""
GENTLE_SLOPE = 0.1
"""A slope up to which a body without ends is taken for its apex."""


def own_length(bed: Bed) -> float:
    """Return the least length of body and layers [m], of a contact of ordinary width; infinite if there is none."""
    layers, end = thickness_of(bed.medium), min(bed.reach, bed.rim, bed.size)
    if math.isfinite(layers):
        return min(layers, LAYERED_SHARE * end)
    return min([RADIUS_SHARE * end, *(b for b, _ in bed.kinks if b > 0.0)])


def shape_length(bed: Bed) -> float:
    """Return the least length of the body [m]; of one without ends, where its slope is no longer small."""
    length = min([bed.reach, bed.rim, bed.size, *(b for b, _ in bed.kinks if b > 0.0)])
    return length if math.isfinite(length) else rough_root(bed.slope, GENTLE_SLOPE)
