"""The greatest pressure under a line contact, and the load that a rim bears."""

from __future__ import annotations

import numpy as np

from winkler.foundation.line import LineFoundation

__all__ = ["peak_pressure", "rim_load"]

PRESSURE_SAMPLES = 65
REFINEMENTS = 9


def rim_load(bed: LineFoundation, force: float, half_width: float) -> float:
    """Return the load per length over E* that a rim bears beyond w(a) [m].

    Parameters
    ----------
    bed : LineFoundation
    force : float
        P [N/m].
    half_width : float
        a [m].
    """
    if half_width < bed.rim:
        return 0.0
    return max(force / bed.medium.modulus - float(bed.load_profile(np.array([half_width]))[0]), 0.0)


def peak_pressure(bed: LineFoundation, force: float, half_width: float) -> float:
    """Return the greatest pressure [Pa]: infinite at a sharp tip, kink or rim, zero without contact.

    Parameters
    ----------
    bed : LineFoundation
    force : float
        P [N/m].
    half_width : float
        a [m].
    """
    if half_width == 0.0:
        return 0.0
    on_rim = rim_load(bed, force, half_width)
    sharp = float(bed.slope(np.zeros(1))[0]) != 0.0 or any(s > 0.0 and b < half_width for b, s in bed.kinks)
    if sharp or on_rim > 0.0:
        return np.inf
    low, high = 0.0, 0.5 * np.pi
    for _ in range(REFINEMENTS):
        angle = np.linspace(low, high, PRESSURE_SAMPLES)
        levels = bed.pressure(half_width * np.sin(angle), half_width, on_rim)
        best = int(np.argmax(levels))
        low, high = angle[max(best - 1, 0)], angle[min(best + 1, PRESSURE_SAMPLES - 1)]
        if best == 0 or high - low < 1e-9:
            break
    return float(levels[best])
