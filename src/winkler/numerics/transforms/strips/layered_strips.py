"""The transforms of line contacts on layers, on a grid of distances (`winkler.numerics.transforms.layered_grid`)."""

from __future__ import annotations

import numpy as np

from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.layered_grid import LayeredGrid
from winkler.numerics.transforms.strips import strip_punches
from winkler.numerics.transforms.strips.strip_transforms import StripTransforms
from winkler.numerics.types import Array


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
        super().__init__(StripTransforms(nodes), response)

    def edges(self, response: WaveResponse, x: Array) -> Array:
        """As `LayeredGrid.edges`."""
        return strip_punches.edge(response, x)

    def held(self, response: WaveResponse, inner: Array, x: Array) -> Array:
        """As `LayeredGrid.held`: x psi(t; x) / t."""
        return np.asarray(strip_punches.kernel(response, inner, x) / inner)

    def spread(self, response: WaveResponse, x: Array, outer: Array) -> Array:
        """As `LayeredGrid.spread`: psi(x; t)."""
        return np.asarray(strip_punches.kernel(response, x, outer).T / outer[None, :])
