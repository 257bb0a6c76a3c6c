r"""A stack of bonded elastic layers, and its surface compliance as a function of the wave number.

A load :math:`\hat p\,J_0(\xi r)` moves the surface by :math:`C(\xi)\,\hat p\,J_0(\xi r)`.  Inside a layer
displacements and tractions, :math:`u_r = U J_1`, :math:`u_z = W J_0`, :math:`\tau = 2G\xi\,T J_1`,
:math:`\sigma_z = 2G\xi\,S J_0`, follow in :math:`x = \xi z`

.. math:: U' = W + 2T,\quad W' = -nU + mS,\quad T' = \frac{U}{1-\nu} + nS,\quad S' = -T,\qquad
          n = \frac{\nu}{1-\nu},\quad m = \frac{1-2\nu}{1-\nu},

without a singularity at :math:`\nu=1/2`.  What lies below an interface is known by its compliance Y, displacements = Y
tractions; `through_layer` carries Y to the upper face of a layer.  A thin layer (:math:`|\xi h|\le 1`) is crossed by
its propagator :math:`e^{-xA}`, closed because :math:`(A^2-1)^2 = 0`; a thick one by splitting its field into a part
that decays downward and one that decays upward.  No exponential ever grows, nothing cancels in thin layers, and the
decay of the tractions with depth comes along, from which the field inside is built.
"""

from __future__ import annotations

import math
from typing import NamedTuple, Self

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Rigid, Solid
from winkler.materials.layered import Layer
from winkler.media.layered.blocks import Four, add, four, invert, matrix, scaled, stacked, times
from winkler.media.layered.climb import climbed
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = [
    "LayerCompliance",
    "LayeredResponse",
    "NormalResponse",
    "half_space",
    "rounded",
    "through_layer",
]

THIN_LAYER_LIMIT = 1.0
"""Up to this |xi h| a layer is crossed by its propagator."""


class LayerCompliance(NamedTuple):
    """Compliance at the upper face, and the tractions at the lower face per traction at the upper face."""

    compliance: ComplexArray
    decay: ComplexArray


def half_space(poisson: float) -> ComplexArray:
    """Return 2 G Y of a homogeneous half-space."""
    lateral, normal = 1.0 - 2.0 * poisson, -2.0 * (1.0 - poisson)
    return np.array([[normal, lateral], [lateral, normal]])


def decaying(x: ComplexArray | float, poisson: float) -> tuple[ComplexArray, ComplexArray]:
    """Return displacements and tractions of both fields that decay downward, at x below their origin, times e^x."""
    kappa = 3.0 - 4.0 * poisson
    return (
        matrix([[1.0, x], [1.0, x + kappa]]),
        matrix([[-1.0, -(1.0 - 2.0 * poisson) - x], [-1.0, -2.0 * (1.0 - poisson) - x]]),
    )


def _growing(x: ComplexArray | float, poisson: float) -> tuple[ComplexArray, ComplexArray]:
    """Return the same of the fields that decay upward, at x below their origin (x <= 0), times e^-x."""
    kappa = 3.0 - 4.0 * poisson
    return (
        matrix([[1.0, -x], [-1.0, x - kappa]]),
        matrix([[1.0, (1.0 - 2.0 * poisson) - x], [-1.0, -2.0 * (1.0 - poisson) + x]]),
    )


def through_layer(below: ComplexArray, x: ComplexArray, poisson: float) -> LayerCompliance:
    """Return what a layer makes of the compliance below it.

    Parameters
    ----------
    below : ndarray, (m, 2, 2)
        2 G Y at its lower face, G of the layer.
    x : ndarray, (m,)
        xi times the thickness; real part not negative.
    poisson
        Of the layer.

    Returns
    -------
    Climb
        2 G Y at its upper face and the decay, ``(m, 2, 2)`` both.
    """
    thin = np.abs(x) <= THIN_LAYER_LIMIT
    upper, decay = np.empty_like(below), np.empty_like(below)
    for chosen, crossed in ((thin, _propagated), (~thin, _split)):
        if chosen.any():
            upper[chosen], decay[chosen] = crossed(below[chosen], x[chosen], poisson)
    return LayerCompliance(upper, decay)


def _propagated(below: ComplexArray, x: ComplexArray, poisson: float) -> tuple[ComplexArray, ComplexArray]:
    n, m = poisson / (1.0 - poisson), (1.0 - 2.0 * poisson) / (1.0 - poisson)
    a = np.array([[0.0, 1.0, 2.0, 0.0], [-n, 0.0, 0.0, m], [1.0 / (1.0 - poisson), 0.0, 0.0, n], [0.0, 0.0, -1.0, 0.0]])
    square = a @ a - np.eye(4)  # nilpotent
    even, odd = np.cosh(x), np.sinh(x)
    series: ComplexArray = np.ones_like(x)
    for divisor in (180.0, 130.0, 88.0, 54.0, 28.0, 10.0):
        series = 1.0 + x**2 / divisor * series
    cubic = np.where(np.abs(x) < 0.4, x**3 / 3.0 * series, x * even - odd)
    parts = ((even, np.eye(4)), (0.5 * x * odd, square), (-odd, a), (-0.5 * cubic, a @ square))

    def block(row: int, column: int) -> Four:
        entries = []
        for i, j in ((row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1)):
            terms = [factor * float(matrix[i, j]) for factor, matrix in parts if matrix[i, j] != 0.0]
            entries.append(sum(terms, np.zeros_like(x)))
        return entries[0], entries[1], entries[2], entries[3]

    compliance = four(below)
    displaced = add(times(block(0, 0), compliance), block(0, 2))
    decay = invert(add(times(block(2, 0), compliance), block(2, 2)))
    return stacked(times(displaced, decay)), stacked(decay)


def _split(below: ComplexArray, x: ComplexArray, poisson: float) -> tuple[ComplexArray, ComplexArray]:
    fade, compliance = np.exp(-x), four(below)
    down, down_load = (four(part) for part in decaying(x, poisson))
    rise_, rise_load = (four(part) for part in _growing(np.zeros_like(x), poisson))
    top, top_load = (four(part) for part in decaying(np.zeros_like(x), poisson))
    back, back_load = (four(part) for part in _growing(-x, poisson))
    left = add(rise_, scaled(-1.0, times(compliance, rise_load)))
    right = add(down, scaled(-1.0, times(compliance, down_load)))
    reflected = scaled(-fade, times(invert(left), right))
    amplitude = invert(add(top_load, scaled(fade, times(back_load, reflected))))
    upper = times(add(top, scaled(fade, times(back, reflected))), amplitude)
    decay = times(add(scaled(fade, down_load), times(rise_load, reflected)), amplitude)
    return stacked(upper), stacked(decay)


# 2x2 matrices entry by entry: much faster than a product of stacks of small matrices


def rounded(ratio: float) -> float:
    """Return a ratio to 14 digits, so that the same stack in other units is the same value."""
    return float(f"{ratio:.13e}")


class LayeredResponse:
    """What all responses of a stack share: the lengths over which it differs from its uppermost layer."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid

    def _with_layer_of_one(self, second: Elastic | Rigid) -> Self:
        """Return the same stack in units of thickness and Young's modulus of its uppermost layer."""
        unit, top = self.length, self.layers[0].solid

        def scaled(solid: Elastic) -> Elastic:
            return Elastic(rounded(solid.young / top.young), solid.poisson)

        layers = tuple(Layer(scaled(layer.solid), rounded(layer.thickness / unit)) for layer in self.layers)
        return type(self)(layers, scaled(self.on) if isinstance(self.on, Elastic) else self.on, second)  # type: ignore[call-arg]

    @property
    def length(self) -> float:
        """Thickness of the uppermost layer [m]: 1 + M tends to 1 like exp(-2 xi length)."""
        return self.layers[0].thickness

    @property
    def smooth(self) -> float:
        """The same: the kernel has no logarithm [m]."""
        return self.length

    precision = 3e-14
    """Rounding of M, relative to its largest value."""

    @property
    def span(self) -> float:
        """Length [m] beyond which the stack is only its base."""
        shears = [layer.solid.shear for layer in self.layers]
        if isinstance(self.on, Elastic):
            shears.append(self.on.shear)
        return sum(layer.thickness for layer in self.layers) * max(shears) / min(shears)


@value
class NormalResponse(LayeredResponse):
    """The response of a coated body and its counterpart to a pressure: 1 + M(xi) = C(xi) E* xi / 2.

    Parameters
    ----------
    layers : tuple of Layer
        From the top.
    on : Elastic or Rigid
        What carries them.
    second : Elastic or Rigid
        The other body, a homogeneous half-space.
    """

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    @property
    def own(self) -> tuple[NormalResponse, float]:
        """The same in units of its uppermost layer, contrasts and Poisson's ratios alone; and that layer's thickness.

        Of the second body only its additional compliance matters: it becomes one without Poisson's ratio.
        """
        second = self.second
        if isinstance(second, Elastic):
            second = Elastic(rounded(second.young / (1.0 - second.poisson**2) / self.layers[0].solid.young), 0.0)
        return self._with_layer_of_one(second), self.length

    @property
    def modulus(self) -> float:
        """E* [Pa] of the uppermost layer and the second body."""
        bodies = [self.layers[0].solid, *([self.second] if isinstance(self.second, Elastic) else [])]
        return 1.0 / sum((1.0 - body.poisson**2) / body.young for body in bodies)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        return np.asarray((self._relative(xi) - 1.0) * self._share)

    def whole(self, xi: ComplexArray) -> ComplexArray:
        """1 + M(xi) [-], to all digits where it is small, too."""
        return np.asarray(self._relative(xi) * self._share + (1.0 - self._share))

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite if one of the bodies is a half-space."""
        if isinstance(self.on, Elastic) or isinstance(self.second, Elastic):
            return math.inf
        compressed = 0.0
        for layer in self.layers:
            solid = layer.solid
            compressed += layer.thickness * (1.0 - 2.0 * solid.poisson) / (solid.shear * (1.0 - solid.poisson))
        return 0.25 * self.modulus * compressed

    @property
    def _share(self) -> float:
        """Compliance of the uppermost layer in that of the pair."""
        if not isinstance(self.second, Elastic):
            return 1.0
        top = self.layers[0].solid
        return self.modulus * (1.0 - top.poisson**2) / top.young

    def _relative(self, xi: ComplexArray) -> ComplexArray:
        """Return the compliance of the stack over that of a half-space of its uppermost layer."""
        top = self.layers[0].solid
        compliance = climbed(self.layers, self.on, xi)[0][1][3]
        return np.asarray(-compliance * top.shear / (1.0 - top.poisson))
