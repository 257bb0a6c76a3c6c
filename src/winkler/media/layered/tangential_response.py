"""The surface compliance of a stack of layers for tangential loads, as a function of the wave number."""

from __future__ import annotations

import math

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Solid
from winkler.materials.layered import Layer
from winkler.media.layered.across import climbed_across
from winkler.media.layered.climb import climbed
from winkler.media.layered.layers import LayeredResponse, rounded
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["TangentialResponse", "TurningResponse"]


@value
class TangentialResponse(LayeredResponse):
    """The response to a tangential load, averaged over its angle with the wave: 1 + M(xi) = C_T(xi) G* xi / 2."""

    layers: tuple[Layer, ...]
    on: Solid
    second: Solid = RIGID

    @property
    def own(self) -> tuple[TangentialResponse, float]:
        """The same in units of its uppermost layer, as that of `NormalResponse`."""
        second = self.second
        if isinstance(second, Elastic):
            second = Elastic(rounded(4.0 * second.shear / (2.0 - second.poisson) / self.layers[0].solid.young), 0.0)
        return self._with_layer_of_one(second), self.length

    @property
    def modulus(self) -> float:
        """G* [Pa] of the uppermost layer and the second body."""
        bodies = [self.layers[0].solid, *([self.second] if isinstance(self.second, Elastic) else [])]
        return 1.0 / sum((2.0 - body.poisson) / (4.0 * body.shear) for body in bodies)

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        along, across = self._waves(xi)
        top = self.layers[0].solid
        own_share = (2.0 - top.poisson) / (4.0 * top.shear)
        return np.asarray(self.modulus * (0.25 * (along + across) - own_share))

    def _waves(self, xi: ComplexArray) -> tuple[ComplexArray, ComplexArray]:
        """Return the compliances [1/Pa] to loads along the wave and across it, times xi."""
        along = -climbed(self.layers, self.on, xi)[0][1][0]
        return along, climbed_across(self.layers, self.on, xi)[0]

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite if one of the bodies is a half-space."""
        if isinstance(self.on, Elastic) or isinstance(self.second, Elastic):
            return math.inf
        return 0.5 * self.modulus * sum(layer.thickness / layer.solid.shear for layer in self.layers)


@value
class TurningResponse(TangentialResponse):
    """By how much compliances across the wave are more than along it: G* xi / 4 (C_across - C_along), less its limit.

    The limit is that of short waves, which feel the uppermost layer alone.
    """

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        along, across = self._waves(xi)
        top = self.layers[0].solid
        return np.asarray(0.25 * self.modulus * (across - along - top.poisson / top.shear))
