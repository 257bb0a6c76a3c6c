r"""How a yielding half-plane under a cylinder departs from an elastic one, over the load :math:`x = p_{el}/Y`.

Between the mean pressure :math:`p_{el}` that an elastic body would bear at the same half-width, and that of a body of
the strength Y, lies :math:`p = p_{el}\,e^{-L(x)}`.  After unloading the middle of the surface stays
:math:`D(x)\,a^2/(2R)` deep.  What comes back has the shape of Hertz's pressure in the part :math:`\theta(x)` of the
force, and that of an even pressure in the rest.

The tables are fitted to finite elements in plane strain that were made for this package: small strains, von Mises'
condition with the associated flow rule, no hardening, no friction, 24 and 48 elements per half-width,
extrapolated; beyond three times the half-width of first yield by 24 and the shift found before.
Beyond the tables the pressure goes on to that of Prandtl, :math:`(2+\pi)Y/\sqrt3`.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.plastic.yielded_response import Departure, Yielded

__all__ = ["GREATEST_POISSON", "LEAST_POISSON", "beyond_line_tables", "yielded_line"]

LEAST_POISSON, GREATEST_POISSON = 0.2, 0.45
KNOTS = (0.0, 0.2231, 0.4055, 0.6931, 1.0986, 1.6094, 2.0794, 2.5649, 2.9957)
"""Logarithms of x over its value at the onset of yield."""
FALL = (0.0, 0.0616, 0.1577, 0.3480, 0.6714, 1.1004, 1.5021, 1.9236, 2.3041)
DENT = (0.0, 0.0982, 0.2073, 0.3672, 0.5249, 0.6564, 0.7333, 0.7803, 0.7960)
EVENING = (0.0, 0.1374, 0.2785, 0.4660, 0.5788, 0.7100, 0.8260, 0.9060, 0.9400)
TABLE_ONSET = 1.4087
"""x at the onset of yield for the Poisson's ratio of the tables, 0.3."""
GAIN = (0.0, 0.08, 0.20, 0.38, 0.58, 0.63, 0.70, 0.82, 0.92)
"""By how much L grows with the logarithm of the onset, from bodies of 0.45; a rigid, plastic one has one."""
PRANDTL = (2.0 + math.pi) / math.sqrt(3.0)
"""Mean pressure over strength of a rigid, perfectly plastic half-plane."""
FULL_DENT = 0.83
"""D there, an estimate."""


def yielded_line(load: Array, onset: float) -> Yielded:
    """Return the departure from an elastic body: L, D in the place of the sinking, and 1 - theta.

    Parameters
    ----------
    load : ndarray, (n,)
        x = p_el / Y [-], positive.
    onset : float
        x at which it begins to yield [-], which Poisson's ratio decides.
    """
    return Yielded(*_cylinder(onset)(np.log(np.maximum(load / onset, 1.0))).T)


def beyond_line_tables(load: float, onset: float) -> bool:
    """Return whether a load p_el / Y is beyond the finite elements to which the law is fitted."""
    return math.log(load / onset) > KNOTS[-1]


@functools.lru_cache(maxsize=64)
def _cylinder(onset: float) -> Departure:
    """Return the departure over ln(x / onset)."""
    fall = np.array(FALL) + math.log(onset / TABLE_ONSET) * np.array(GAIN)
    return Departure(KNOTS, np.stack([fall, DENT, EVENING], axis=1), math.log(onset), FULL_DENT, PRANDTL)
