r"""What the layers below a surface add to the displacement of strips of pressure side by side.

A line load sinks the surface of layers by :math:`-\frac1\pi\ln|x|` of their uppermost layer's half-plane, and raises
it by :math:`T(x)` besides, pressures over E*/2 and counted from the load itself:

.. math:: T(x) = \frac1\pi\int_0^\infty\frac Mk(1-\cos kx)\,\mathrm dk , \qquad
          T'(x) = \frac1\pi\int_0^\infty M\sin kx\,\mathrm dk .

T' is smooth on the thickness of the uppermost layer: a rule on the Chebyshev nodes of each strip integrates it with the
pressure, of which walls cancel and corners count by the first terms of their sine series.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.fields.strip_potential import StripTerms
from winkler.numerics.panels.chebyshev import Panels
from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths, on_axis, sine_transform
from winkler.numerics.types import Array

FEWEST_LOADS, LOADS_PER_LENGTH = 16, 11.0
"""Line loads of one strip beyond the terms of its series: a few, and so many for each length of decay in half of it,
over which waves die out like exp(-2 * 21); twice as many between corners, whose series go on."""


class LineLoads(NamedTuple):
    """Line loads that stand for the pressure of a strip.

    Parameters
    ----------
    places : ndarray, (n,)
    loads : ndarray, (n,)
        Over E*/2.
    """

    places: Array
    loads: Array


def loads_of(strip: StripTerms, count: int) -> LineLoads:
    """Return the pressure of a strip as so many line loads: smooth functions of its places are integrated with it."""
    angle = math.pi * (np.arange(count) + 0.5) / count
    t, sine, order = np.cos(angle), np.sin(angle), np.arange(1, count)
    dense = np.sin(np.outer(angle, order[: strip.series.size])) @ strip.series[: count - 1]
    for place, jump, bend in strip.corners:
        at = min(max((place - strip.middle) / strip.half, -1.0), 1.0)
        log = 2.0 / math.pi * np.sin(np.outer(angle, order)) @ (np.sin(math.acos(at) * order) / order)
        bent = (t - at) * log - math.sin(math.acos(at)) / math.pi * sine * t
        dense = dense + jump * log + bend * strip.half * bent
    whole = dense * sine + strip.walls[0] + strip.walls[1] * t
    return LineLoads(strip.middle + strip.half * t, math.pi * strip.half / count * whole)


class Below(NamedTuple):
    """The layers, for strips in a unit of length of their own.

    Parameters
    ----------
    response
        Of the pair to pressures.
    unit
        Of the strips [m].
    """

    response: WaveResponse
    unit: float

    @property
    def scale(self) -> float:
        """The unit over that of the response."""
        return self.unit / in_own_lengths(self.response)[1]

    def count(self, strip: StripTerms) -> int:
        """Return how many line loads stand for a strip."""
        decays = strip.half * self.unit / self.response.length
        return (
            strip.series.size + FEWEST_LOADS + math.ceil((1.0 + (len(strip.corners) > 0)) * LOADS_PER_LENGTH * decays)
        )

    def loads(self, strip: StripTerms) -> LineLoads:
        """Return the pressure of a strip as line loads."""
        return loads_of(strip, self.count(strip))

    def _curve(self, farthest: float) -> Panels:
        """Return 2 T' of the response in its own unit, as far as this in the strips' one."""
        return sine_transform(in_own_lengths(self.response)[0], max(farthest * self.scale, 1e-300))

    def raised(self, x: Array, places: Array) -> Array:
        """Return T from line loads to places x ``(x, places)``."""
        away = np.abs(x[:, None] - places)
        return np.asarray(0.5 * self._curve(float(np.max(away))).integral(self.scale * away))

    def slope(self, x: Array, places: Array) -> Array:
        """Return T', by which the layers bend the surface besides."""
        away = x[:, None] - places
        bent = self._curve(float(np.max(np.abs(away))))(self.scale * np.abs(away))
        return np.asarray(0.5 * self.scale * np.sign(away) * bent)

    def curvature(self, x: Array, places: Array) -> Array:
        """Return T''."""
        away = np.abs(x[:, None] - places)
        return np.asarray(0.5 * self.scale**2 * self._curve(float(np.max(away))).derivative(self.scale * away))

    def of_elements(self, count: int, spacing: float, reference: float) -> Array:
        """Return what even pressures on elements add to the displacement 0, 1, ... elements away, a reference on."""
        ends = spacing * (np.arange(count + 1) - 0.5)
        once = self._curve(max(float(ends[-1]), reference)).integral
        twice = np.sign(ends) * once.integral(self.scale * np.abs(ends))
        return np.asarray(0.5 * (spacing * once(np.array([self.scale * reference])) - np.diff(twice) / self.scale))

    def whole(self, q: Array) -> Array:
        """Return 1 + M at wave numbers in the strips' unit."""
        own, length = in_own_lengths(self.response)
        return np.asarray(1.0 + on_axis(own, q * length / self.unit))
