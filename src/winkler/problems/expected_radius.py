"""Of what order the radius of an adhesive contact is, told by the shape of the body alone.

A search that began anywhere would ask layered media for contacts a thousand times too wide, which takes them seconds,
and cohesive zones for rings too narrow for floating point.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.problems.edge_states import EdgeStates, end_of

__all__ = ["expected_radius"]

DECADES = np.arange(-12.0, 3.0, 0.25)
TINY = 1e-12
SHARE = 0.05


def expected_radius(states: EdgeStates) -> float:
    """Return a radius [m], not beyond half of the body, where its slope first matters against the attraction."""
    bed, end = states.bed, end_of(states.bed)
    widest = 0.5 * min([end, *(b for b, _ in bed.kinks if b > 0.0)])
    guess = min(1e-3, 0.04 * widest) if math.isfinite(widest) else 1e-3
    if not isinstance(bed, Foundation):
        return guess
    places = 10.0**DECADES
    places = places[places < widest]
    if not places.size:
        return guess
    with np.errstate(all="ignore"):
        pulled = float(states.scale(np.array([TINY]))[0])
        # without a range the stretch goes with the root of the radius, with one it stays
        falling = 1.0 if states.from_nothing() else np.sqrt(TINY / places)
        felt = np.abs(bed.slope(places)) >= SHARE * pulled * falling
    return float(places[np.argmax(felt)]) if felt.any() else min(float(places[-1]), guess)
