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

import numpy as np

from winkler.media.layered.across import climbed_across, less_than_one
from winkler.media.layered.pair_response import PairResponse
from winkler.media.layered.wave_constants import constants_of
from winkler.numerics.types import Array, ComplexArray
from winkler.values.value import value


@value
class FloatingAcross(PairResponse):
    """The response to a twist of layers without shear below them; the lowest of the stack slides."""

    @property
    def span(self) -> float:
        """Length [m] beyond which the layers are one sheet."""
        moduli, depths = zip(*self._plates, strict=True)
        return float(sum(depths) * max(moduli) / min(moduli))

    @property
    def _plates(self) -> list[tuple[float, float]]:
        """Moduli [Pa] and lengths [m] of the layers."""
        solids = [(*constants_of(layer.solid).impedance, layer.thickness) for layer in self.first.layers]
        return [(stiff, h * steep) for stiff, steep, h in solids]

    @property
    def _pole(self) -> float:
        """A [1/m]."""
        plates = self._plates
        return self._share * plates[0][0] / sum(g * d for g, d in plates)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) - A exp(-2 xi length) / xi [-] at real or complex wave numbers (m,) [1/m]."""
        # by how much the stiffness over xi is less than that of the sheet: no difference of nearly equal numbers
        less, sheet, stack = np.zeros_like(xi), 0.0, self.first
        surface, *below = climbed_across(stack.layers, stack.on, xi)
        for (g, d), layer, face in reversed(list(zip(self._plates, stack.layers, below, strict=True))):
            x = xi * d
            bent = np.tanh(x) / (g * face) if layer.bonded else 0.0
            less = (less + g * d * less_than_one(x) + (sheet + g * d) * bent) / (1.0 + bent)
            sheet += g * d
        pole, y = self._pole / self._share, -2.0 * xi * self.length
        short = np.divide(np.expm1(y), y, out=np.ones_like(y), where=y != 0.0)  # (1 - exp(y)) / -y
        bent = np.multiply(less, surface, out=np.zeros_like(y), where=xi != 0.0)
        return np.asarray(self._share * (pole * bent - 1.0 + 2.0 * pole * self.length * short))

    def long_wave_kernel(self, x: Array) -> Array:
        """The cosine transform of what `excess` leaves out [1/m], but for a constant."""
        return np.asarray(-self._pole / math.pi * np.log1p((0.5 * x / self.length) ** 2))
