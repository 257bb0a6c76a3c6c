r"""The surface compliance of an elastic layer that slides on its base without friction, in closed form.

Neither face of the layer bears shear.  Pressures of one wave number on the two faces are a part that is even about the
middle of the layer and one that is odd; with :math:`x=\xi h` and the compliance :math:`2/(E^*\xi)` of a half-space of
the same solid, a face sinks by the parts

.. math:: A = \frac{\cosh x-1}{\sinh x+x} ,\qquad B = \frac{\cosh x+1}{\sinh x-x}

of it.  The lower face presses on a base that is :math:`\gamma=E^*/E^*_b` times as compliant as the layer (nothing, of
a rigid one) and stays in touch with it.  Without the pressure between them

.. math:: 1+M = \frac{AB+\tfrac{\gamma}{2}(A+B)}{\gamma+\tfrac12(A+B)} =
   \frac{\sinh^2x+\gamma\,(\sinh x\cosh x+x)}{\sinh x\cosh x+x+\gamma\,(\sinh^2x-x^2)} .

The solid appears by :math:`E^*` alone: Poisson's ratio has no other effect, an incompressible layer can yield sideways.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.media.layered.layers import NormalResponse
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["SlidingResponse"]

SERIES_LIMIT = 0.5
"""Below this |x|, sinh^2 x - x^2 is summed as a series: its terms cancel otherwise."""
SERIES_DIVISORS = (240.0, 182.0, 132.0, 90.0, 56.0, 30.0)
"""Ratios of neighbouring terms of x^4/3 (1 + 4 x^2/30 (1 + 4 x^2/56 (...))), from the last."""

LEAST_WAVE = 1e-300
"""Stands for x = 0, where the fraction is 0 / 0."""


@value
class SlidingResponse(NormalResponse):
    """The response to a pressure of one layer on a base without friction; parameters as of `NormalResponse`."""

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite if one of the bodies is a half-space."""
        if isinstance(self.on, Elastic) or isinstance(self.second, Elastic):
            return math.inf
        return 0.5 * self.length

    def _relative(self, xi: ComplexArray) -> ComplexArray:
        """Return the compliance over that of a half-space of the layer's solid."""
        top, base = self.layers[0].solid, self.on
        x = np.where(xi == 0.0, LEAST_WAVE, xi * self.length)
        # both sides of the fraction times 4 e^(-2x): no exponential grows
        fade, falls = np.exp(-2.0 * x), -np.expm1(-2.0 * x)
        stretched = falls * (1.0 + fade) + 4.0 * x * fade
        if not isinstance(base, Elastic):
            return np.asarray(falls**2 / stretched)
        softer = top.young / (1.0 - top.poisson**2) * (1.0 - base.poisson**2) / base.young
        bent = _bent(x, fade, falls)
        return np.asarray((falls**2 + softer * stretched) / (stretched + softer * bent))


def _bent(x: ComplexArray, fade: ComplexArray, falls: ComplexArray) -> ComplexArray:
    """Return 4 e^(-2x) (sinh^2 x - x^2)."""
    thin = np.abs(x) < SERIES_LIMIT
    inner = np.where(thin, x, 0.0)
    series: ComplexArray = np.ones_like(x)
    for divisor in SERIES_DIVISORS:
        series = 1.0 + 4.0 * inner**2 / divisor * series
    return np.where(thin, 4.0 / 3.0 * inner**4 * series * fade, falls**2 - 4.0 * x**2 * fade)
