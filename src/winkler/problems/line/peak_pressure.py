"""The greatest pressure under a line contact, and the load that a rim bears."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.equations.highest import highest_of_curve
from winkler.numerics.types import Curve
from winkler.problems.line.stress import Strip


def rim_load(bed: LineBed, force: float, half_width: float) -> float:
    """Return the load per length over E* that a rim bears beyond w(a) [m].

    Parameters
    ----------
    bed : LineBed
    force : float
        P [N/m].
    half_width : float
        a [m].
    """
    if half_width < bed.rim:
        return 0.0
    return max(force / bed.medium.modulus - float(bed.load_profile(np.array([half_width]))[0]), 0.0)


def is_sharp(bed: LineBed, half_width: float, rim_load: float) -> bool:
    """Return whether the pressure is infinite at a sharp tip, a kink or a rim, or the tension at an edge.

    Parameters
    ----------
    bed : LineBed
    half_width : float
        a [m].
    rim_load : float
        Load per length over E* that a rim bears [m], or negative where adhesion pulls.
    """
    kinked = any(strength > 0.0 and place < half_width for place, strength in bed.kinks)
    return (rim_load != 0.0 and bed.edges_bear) or kinked or float(bed.slope(np.zeros(1))[0]) != 0.0


def peak_pressure(bed: Any, strip: Strip, pressure: Curve | None = None) -> float:
    """Return the greatest pressure [Pa]: infinite at a sharp tip, kink or rim, zero without contact.

    Parameters
    ----------
    bed : LineBed or PeriodicBed
    strip : Strip
    pressure
        Over places that are not negative [m]; that of the bed unless given.
    """
    a, edge_load = strip
    if a == 0.0:
        return 0.0
    if is_sharp(bed, a, edge_load):
        return np.inf
    return highest_of_curve(pressure or (lambda x: bed.pressure(x, a, edge_load)), a)
