r"""Axisymmetric waves, :math:`f = h(1-\cos kr)`: to be added to a smooth shape.

:math:`g = \tfrac\pi2 h k x\,\mathbf H_0(kx)` with Struve's function; g rises and falls, so that a wavy body is
solved only while its contact is one disc (Guduru's profile is a paraboloid plus a wave).
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.panels.struve import struve
from winkler.numerics.types import Array
from winkler.profiles.profile import Shape
from winkler.values.checks.number_checks import Positive
from winkler.values.value import value


@value
class Wavy(Shape):
    """Concentric waves, f = h (1 - cos(2 pi r / wavelength)).

    Parameters
    ----------
    amplitude : float
        h [m], positive; the waves reach 2 h above the apex.
    wavelength : float
        [m], positive.

    References
    ----------
    P. R. Guduru, J. Mech. Phys. Solids 55 (2007) 445-472, doi:10.1016/j.jmps.2006.09.007
    """

    amplitude: Positive
    wavelength: Positive

    @property
    def _number(self) -> float:
        return 2.0 * math.pi / self.wavelength

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return 2.0 * self.amplitude * np.sin(0.5 * self._number * np.asarray(r)) ** 2

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self.amplitude * self._number * np.sin(self._number * np.asarray(r))

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        return self.amplitude * self._number**2 * np.cos(self._number * np.asarray(r))

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        t = self._number * np.asarray(x)
        result: Array = np.multiply(0.5 * math.pi * self.amplitude * t, struve(0, t))
        return result

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        t = self._number * np.asarray(x)
        steep = struve(0, t) + t * (2.0 / math.pi - struve(1, t))
        result: Array = np.multiply(0.5 * math.pi * self.amplitude * self._number, steep)
        return result

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        x = np.asarray(x)
        result: Array = np.multiply(0.5 * math.pi * self.amplitude * x, struve(1, self._number * x))
        return result
