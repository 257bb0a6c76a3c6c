"""The surface compliance of a stack of layers for tangential loads, as a function of the wave number."""

from __future__ import annotations

import numpy as np

from winkler.materials.elastic import RIGID, Elastic, Solid
from winkler.materials.layered import Layer
from winkler.media.layered.layers import LayeredResponse, rounded, through_layers
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["TangentialResponse"]


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
        along = -through_layers(self.layers, self.on, xi)[0].compliance[:, 0, 0]
        across = np.full(xi.shape, 1.0 / self.on.shear if isinstance(self.on, Elastic) else 0.0, dtype=xi.dtype)
        for layer in reversed(self.layers):
            fall = np.tanh(xi * layer.thickness)
            own = across * layer.solid.shear
            across = (own + fall) / ((1.0 + own * fall) * layer.solid.shear)
        top = self.layers[0].solid
        own_share = (2.0 - top.poisson) / (4.0 * top.shear)
        return np.asarray(self.modulus * (0.25 * (along + across) - own_share))
