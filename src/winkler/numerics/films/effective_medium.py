r"""Bruggeman's effective medium of two dimensions: one conductance that stands for many at random places.

.. math:: \left\langle\frac{k-\sigma}{k+\sigma}\right\rangle = 0 .
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array


def effective_conductance(conductance: Array) -> float:
    """Return the conductance of the effective medium; zero if half of the places or more do not conduct.

    Parameters
    ----------
    conductance
        k at each place, not negative.

    References
    ----------
    D. A. G. Bruggeman, Ann. Phys. 416 (1935) 636-664, doi:10.1002/andp.19354160705
    """
    from scipy.optimize import brentq

    flat = np.ravel(conductance)
    conducting = flat[flat > 0.0]
    if 2 * conducting.size <= flat.size:
        return 0.0
    ratio = np.log(conducting)
    closed = flat.size - conducting.size

    def excess(level: float) -> float:
        return float(np.sum(np.tanh(0.5 * (ratio - level)))) - closed

    low, high = float(np.min(ratio)), float(np.max(ratio))
    while excess(low) <= 0.0:  # with closed places the medium may conduct less than the least open one
        if high == low and closed == 0:
            return math.exp(low)
        low -= 1.0 + high - low
    return math.exp(brentq(excess, low, high, xtol=1e-13)) if excess(high) < 0.0 else math.exp(high)
