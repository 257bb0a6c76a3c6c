"""The greatest value of a curve from the middle to the edge of a contact, on a grid that narrows down."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Curve

__all__ = ["highest"]

SAMPLES = 65
REFINEMENTS = 9
NARROW = 1e-7
"""Range of angles that is as good as one place: there the curve differs from its greatest value by rounding."""


def highest(curve: Curve, end: float) -> float:
    """Return the greatest of the values between zero and the edge, places dense towards the edge.

    Parameters
    ----------
    curve : callable
        Finite values at places x >= 0 [m].
    end : float
        Where the edge is [m].
    """
    low, high = 0.0, 0.5 * np.pi
    for _ in range(REFINEMENTS):
        angle = np.linspace(low, high, SAMPLES)
        levels = curve(end * np.sin(angle))
        best = int(np.argmax(levels))
        low, high = angle[max(best - 1, 0)], angle[min(best + 1, SAMPLES - 1)]
        if best == 0 or high - low < NARROW:
            break
    return float(levels[best])
