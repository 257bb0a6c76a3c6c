r"""How a yielding half-plane under a cylinder departs from an elastic one, over the load :math:`x = p_{el}/Y`.

Between the mean pressure :math:`p_{el}` that an elastic body would bear at the same half-width, and that of a body of
the strength Y, lies :math:`p = p_{el}\,e^{-L(x)}`.  After unloading the middle of the surface stays
:math:`D(x)\,a^2/(2R)` deep.  What comes back has the shape of Hertz's pressure in the part :math:`\theta(x)` of the
force, and that of an even pressure in the rest.

The tables are fitted to finite elements in plane strain that were made for this package: small strains, von Mises'
condition with the associated flow rule, no hardening, no friction, 24 and 48 elements per half-width, extrapolated.
Beyond the tables the pressure goes on to that of Prandtl, :math:`(2+\pi)Y/\sqrt3`.

A metal that hardens has the flow stress :math:`\sigma` at the representative strain of a ball.  Its dent is deeper, as
fitted to elements that harden linearly by 0.05 E and 0.2 E,

.. math:: D = D(p_{el}/\sigma) + 0.335\left(\frac\sigma Y-1\right)\left(1-\frac{(2.44\,a_Y)^2}{a^2}\right) ,

where the last factor is positive; a_Y is the half-width of first yield.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.plastic.yielded_response import Departure, Yielded
from winkler.problems.plastic.yielding_half import YieldingHalf

LEAST_POISSON, GREATEST_POISSON = 0.2, 0.45
KNOTS = (0.0, 0.2231, 0.4055, 0.6931, 1.0986, 1.6094, 2.0794, 2.5649, 2.9957)
"""Logarithms of x over its value at the onset of yield."""
FALL = (0.0, 0.0585, 0.1537, 0.3450, 0.6697, 1.0975, 1.5000, 1.9225, 2.3019)
DENT = (0.0, 0.0945, 0.2027, 0.3638, 0.5234, 0.6525, 0.7275, 0.7740, 0.7956)
EVENING = (0.0, 0.1374, 0.2785, 0.4660, 0.5788, 0.7100, 0.8260, 0.9060, 0.9400)
TABLE_ONSET = 1.4087
"""x at the onset of yield for the Poisson's ratio of the tables, 0.3."""
GAIN = (0.0, 0.08, 0.20, 0.38, 0.58, 0.63, 0.70, 0.82, 0.92)
"""By how much L grows with the logarithm of the onset, from bodies of 0.45; a rigid, plastic one has one."""
PRANDTL = (2.0 + math.pi) / math.sqrt(3.0)
"""Mean pressure over strength of a rigid, perfectly plastic half-plane."""
FULL_DENT = 0.83
"""D there, an estimate."""
HARDENED_DENT, HARDENED_FROM = 0.335, 2.44
"""How D grows as the flow stress rises over the strength, and from how many times the half-width of first yield on."""


class LineHalf(YieldingHalf):
    """A half-plane that may yield under a cylinder."""

    __slots__ = ()

    def beyond_start(self, load: Array, exponent: Array) -> Yielded:
        """Return the departure, with D in the place of the sinking; the local exponent is that of a parabola."""
        return Yielded(*_cylinder(self.start)(np.log(np.maximum(load / self.start, 1.0))).T)

    def shaped(self, elastic: Array, load: Array, missing: Array, exponent: Array) -> Yielded:
        """Return the departure with D of a metal that hardens; as `YieldingHalf.shaped`."""
        departure = self.beyond_start(load, exponent)
        onset = self.start * self.strength / elastic
        room = np.maximum(1.0 - (HARDENED_FROM * onset) ** 2, 0.0)
        deeper = HARDENED_DENT * (elastic / (load * self.strength) - 1.0) * room
        return departure._replace(sinking=departure.sinking + deeper)


@functools.lru_cache(maxsize=64)
def line_onset(poisson: float) -> float:
    """Return p_el / Y [-] where the contact of Hertz first yields, by von Mises' condition on its axis.

    At the depth a sinh t the stress is Y where p0 exp(-t) ((1 - 2 nu)^2 + 3 tanh^2 t)^(1/2) is; its greatest is a root.
    """
    square = (1.0 - 2.0 * poisson) ** 2
    deep = float(np.max(np.roots([1.0, 1.0, -1.0, square / 3.0]).real))
    return 0.25 * math.pi * math.exp(math.atanh(deep)) / math.sqrt(square + 3.0 * deep * deep)


def beyond_line_tables(load: float, onset: float) -> bool:
    """Return whether a load p_el / Y is beyond the finite elements to which the law is fitted."""
    return math.log(load / onset) > KNOTS[-1]


@functools.lru_cache(maxsize=64)
def _cylinder(onset: float) -> Departure:
    """Return the departure over ln(x / onset)."""
    fall = np.array(FALL) + math.log(onset / TABLE_ONSET) * np.array(GAIN)
    return Departure(KNOTS, np.stack([fall, DENT, EVENING], axis=1), math.log(onset), FULL_DENT, PRANDTL)
