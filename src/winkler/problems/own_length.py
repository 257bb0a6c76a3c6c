"""A length of the order of a problem's own, where the search for a contact radius begins.

Shape, layers and load bring it; where none of them has a length of its own, everything is a power of the radius, which
a few places tell, whatever the unit.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.foundation.bed import Bed
from winkler.media.coated import LayeredMedium
from winkler.media.medium import Medium
from winkler.media.relaxing import RelaxingMedium
from winkler.numerics.types import Array

__all__ = ["own_length", "power_radius", "thickness_of"]

SHARE = 0.02
"""Of the radius of a body, a contact of ordinary width."""
WIDE = 0.25
"""The same on layers, where narrow contacts are as quickly asked for."""
STRIDE = 20.0
"""Octaves of one step of a search, at most."""
SLOW = 0.25
"""Least power of the radius that is believed: waves come back to where they were."""
FARTHEST = 100.0
"""Octaves from the first place: farther than 1e30 m, or nearer than 1e-30 m, there is no contact."""
TRIES = 50


def thickness_of(medium: Medium) -> float:
    """Return how thick the layers of a medium are [m]; infinite if it has none."""
    if isinstance(medium, RelaxingMedium):
        return thickness_of(medium.elastic)
    return medium.thickness if isinstance(medium, LayeredMedium) else math.inf


def own_length(bed: Bed) -> float:
    """Return the least length of body and layers [m], of a contact of ordinary width; infinite if there is none."""
    layers, end = thickness_of(bed.medium), min(bed.reach, bed.rim, bed.size)
    if math.isfinite(layers):
        return min(layers, WIDE * end)
    return min([SHARE * end, *(b for b, _ in bed.kinks if b > 0.0)])


def power_radius(value: Callable[[Array], Array], asked: float) -> float:
    """Return where a power of the radius reaches a value; only of that order where it is no power.

    Parameters
    ----------
    value
        Takes radii [m] ``(m,)``, rises from zero.
    asked
        Positive, of the kind of `value`.
    """
    octaves = 0.0
    for _ in range(TRIES):
        place = math.exp2(octaves)
        with np.errstate(all="ignore"):
            near, far = value(np.array([place, 2.0 * place])).tolist()
            if near == far == 0.0:
                step = STRIDE
            elif 0.0 < near < far < math.inf:
                step = (math.log2(asked) - math.log2(near)) / max(math.log2(far / near), SLOW)
            else:
                step = -0.5 * STRIDE  # towards the apex, where every shape rises
        if abs(step) <= 1.0 or abs(octaves) >= FARTHEST:
            break
        octaves += min(max(step, -STRIDE), STRIDE)
    return place
