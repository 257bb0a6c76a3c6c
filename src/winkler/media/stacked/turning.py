"""By how much a stack of transversely isotropic layers yields more to shear across a wave than along it."""

from __future__ import annotations

import numpy as np

from winkler.materials.elastic import RIGID
from winkler.media.layered.climb import AnyLayer
from winkler.media.layered.wave_constants import Body
from winkler.media.stacked.response import StackTangential
from winkler.numerics.types import ComplexArray
from winkler.values import value

__all__ = ["StackTurning"]


@value
class StackTurning(StackTangential):
    """G* xi / 4 (C_across - C_along), less its limit for short waves, as of `TurningResponse`; bonded layers."""

    layers: tuple[AnyLayer, ...]
    on: Body
    second: Body = RIGID

    def excess(self, xi: ComplexArray) -> ComplexArray:
        """M(xi) [-] at real or complex wave numbers (m,) [1/m]."""
        along, across = (each.excess(xi) / each.modulus for each in self._parts)
        return np.asarray(0.5 * self.modulus * (across - along))
