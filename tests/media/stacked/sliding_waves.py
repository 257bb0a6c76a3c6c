"""The compliance of one sliding layer over that of a half-space of it, in closed form with many digits."""

from __future__ import annotations

import mpmath
import numpy as np


def sliding_film_response(xi: np.ndarray, softer: float) -> np.ndarray:
    """(sinh^2 x + g (sinh x cosh x + x)) / (sinh x cosh x + x + g (sinh^2 x - x^2)), g of layer over base."""
    found = []
    with mpmath.workdps(60):
        for x in map(mpmath.mpf, xi.tolist()):
            s, c = mpmath.sinh(x), mpmath.cosh(x)
            stretched = s * c + x
            found.append(float((s**2 + softer * stretched) / (stretched + softer * (s**2 - x**2))))
    return np.array(found)
