r"""Layers that slide on what lies below them, under a twist: a plate that floats.

No shear passes an interface without friction, so that a twist reaches the layers above the uppermost such interface
alone.  Their sheet is held far away: it turns by :math:`u_\theta\sim M_z/(4\pi r\sum G_id_i)`, which dies out, so that
the twist has a stiffness.  (A push has none: displacements grow like a logarithm.)  For long waves
:math:`M\to A/\xi`,  :math:`A=g_1/\sum_i g_id_i`, with the moduli :math:`g=\sqrt{C_{44}C_{66}}` and the lengths
:math:`d=h\sqrt{C_{66}/C_{44}}` of the layers.  Of the kernel of a twist only differences count, and so

.. math:: \frac2\pi\int_0^\infty\frac A\xi\,e^{-2\xi L}(\cos\xi x-1)\,\mathrm d\xi
          = -\frac A\pi\ln\Big(1+\frac{x^2}{4L^2}\Big)

is split off in closed form.
"""

from __future__ import annotations

import math
from typing import Self

import numpy as np

from winkler.materials.elastic import RIGID
from winkler.media.layered.climb import AnyLayer
from winkler.media.layered.wave_constants import Body, across_compliance, constants_of
from winkler.media.stacked.response import StackResponse, in_units_of_top
from winkler.numerics.types import Array, ComplexArray
from winkler.values import value

__all__ = ["FloatingAcross"]

SMALL_DEPTH = 0.05
"""Wave number times thickness below which 1 - tanh(x)/x is summed as a series."""


@value
class FloatingAcross(StackResponse):
    """The response to a twist of layers without shear below them.

    Parameters
    ----------
    layers : tuple of Layer or StackLayer
        From the top, down to the one that slides.
    second : Elastic, TransverselyIsotropic or Rigid
        The other body.
    """

    layers: tuple[AnyLayer, ...]
    second: Body = RIGID

    @staticmethod
    def of_body(body: Body) -> float:
        """1/m_T [1/Pa]."""
        return across_compliance(body)

    @property
    def own(self) -> tuple[Self, float]:
        """The same in units of thickness and modulus of its uppermost layer; and that thickness [m]."""
        layers, _, second, length = in_units_of_top(self.layers, RIGID, self.second, self.of_body)
        return type(self)(layers, second), length

    @property
    def length(self) -> float:
        """M tends to zero like exp(-2 xi length) [m]."""
        return self._plates[0][1]

    @property
    def span(self) -> float:
        """Length [m] beyond which the layers are one sheet."""
        moduli, depths = zip(*self._plates, strict=True)
        return float(sum(depths) * max(moduli) / min(moduli))

    @property
    def _plates(self) -> list[tuple[float, float]]:
        """Moduli [Pa] and lengths [m] of the layers."""
        solids = [(constants_of(layer.solid), layer.thickness) for layer in self.layers]
        return [(each.shear * math.sqrt(each.twist), h * math.sqrt(each.twist)) for each, h in solids]

    @property
    def _pole(self) -> float:
        """A [1/m]."""
        plates = self._plates
        return self._share * plates[0][0] / sum(g * d for g, d in plates)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) - A exp(-2 xi length) / xi [-] at real or complex wave numbers (m,) [1/m]."""
        # stiffness over xi, and what it is less than that of the sheet: without a difference of nearly equal numbers
        stiff, less, sheet = np.zeros_like(xi), np.zeros_like(xi), 0.0
        for g, d in reversed(self._plates):
            x = xi * d
            missing, left = _missing(x)
            bent = stiff * xi * x * left / g
            less = (less + g * d * missing + (sheet + g * d) * bent) / (1.0 + bent)
            stiff = (stiff + g * d * left) / (1.0 + bent)
            sheet += g * d
        pole, y = self._pole / self._share, -2.0 * xi * self.length
        short = np.divide(np.expm1(y), y, out=np.ones_like(y), where=y != 0.0)  # (1 - exp(y)) / -y
        bent = np.divide(less, xi * stiff, out=np.zeros_like(y), where=xi != 0.0)
        return np.asarray(self._share * (pole * bent - 1.0 + 2.0 * pole * self.length * short))

    def long_wave_kernel(self, x: Array) -> Array:
        """The cosine transform of what `excess` leaves out [1/m], but for a constant."""
        return np.asarray(-self._pole / math.pi * np.log1p((0.5 * x / self.length) ** 2))


def _missing(x: ComplexArray) -> tuple[ComplexArray, ComplexArray]:
    """Return 1 - tanh(x)/x, and tanh(x)/x."""
    square = x * x
    series = square * (1 / 3 - square * (2 / 15 - square * (17 / 315 - square * (62 / 2835 - square * 1382 / 155925))))
    safe = np.where(x == 0.0, 1.0, x)
    small, left = np.abs(x) < SMALL_DEPTH, np.tanh(safe) / safe
    return np.where(small, series, 1.0 - left), np.where(small, 1.0 - series, left)
