"""The transforms of line contacts on layers, on a grid of distances (`winkler.numerics.transforms.layered_grid`)."""

from __future__ import annotations

import numpy as np

from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.layered_grid import LayeredGrid
from winkler.numerics.transforms.strips import strip_punches
from winkler.numerics.transforms.strips.strip_equation import has_tail
from winkler.numerics.transforms.strips.strip_transforms import StripTransforms
from winkler.numerics.types import Array

__all__ = ["LayeredStrips"]

BESIDE_LOGARITHM = 12
"""Points of a cell at whose ends the kernel may have a logarithm."""


class LayeredStrips(LayeredGrid):
    """Matrices of the transforms on one grid of distances from the middle.

    Parameters
    ----------
    nodes : ndarray, (n,)
        Distances [m], rising from zero.
    response : WaveResponse
        Of the medium to a pressure, or to shear along the wave.
    """

    def __init__(self, nodes: Array, response: WaveResponse) -> None:
        if has_tail(response):
            self.fewest = BESIDE_LOGARITHM
        super().__init__(StripTransforms(nodes), response)

    def rule(self, response: WaveResponse, count: int) -> tuple[Array, Array]:
        """As `LayeredGrid.rule`; dense at a logarithm, whose error no sum has at the middle."""
        s, weights = LayeredGrid.rule(self, response, count)
        if not has_tail(response):
            return s, weights
        return s**3 * (10.0 - 15.0 * s + 6.0 * s * s), 30.0 * weights * (s * (1.0 - s)) ** 2

    def edges(self, response: WaveResponse, x: Array) -> Array:
        """As `LayeredGrid.edges`."""
        return strip_punches.edge(response, x)

    def held(self, response: WaveResponse, inner: Array, x: Array) -> Array:
        """As `LayeredGrid.held`: x psi(t; x) / t."""
        return np.asarray(strip_punches.kernel(response, inner, x) / inner)

    def spread(self, response: WaveResponse, x: Array, outer: Array) -> Array:
        """As `LayeredGrid.spread`: psi(x; t)."""
        return np.asarray(strip_punches.kernel(response, x, outer).T / outer[None, :])
