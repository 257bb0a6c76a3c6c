"""The transforms of round contacts on layers, on a grid of radii (`winkler.numerics.transforms.layered_grid`)."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.transforms import fredholm
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.layered_grid import LayeredGrid
from winkler.numerics.transforms.ring_transforms import RingTransforms
from winkler.numerics.types import Array


class LayeredRings(LayeredGrid):
    """Matrices of the transforms on one grid of radii.

    Parameters
    ----------
    nodes : ndarray, (n,)
        Radii [m], rising from zero.
    response : WaveResponse
        Of the medium to a pressure.
    """

    def __init__(self, nodes: Array, response: WaveResponse) -> None:
        super().__init__(RingTransforms(nodes, 0.0), response)
        self._mean = fredholm.mean(response, nodes)

    def edges(self, response: WaveResponse, x: Array) -> Array:
        """As `LayeredGrid.edges`."""
        return fredholm.edge(response, x)

    def held(self, response: WaveResponse, inner: Array, x: Array) -> Array:
        """As `LayeredGrid.held`: rho(t; x)."""
        found = fredholm.moments(response, inner, x)
        found[1:] /= x[1:, None]
        return found

    def spread(self, response: WaveResponse, x: Array, outer: Array) -> Array:
        """As `LayeredGrid.spread`."""
        return np.asarray(fredholm.moments(response, x, outer).T / outer)

    def springs_within(self, squares: Any) -> Any:
        """Return the integral of phi(x; x)^2 from 0 to places in y, straight between nodes."""
        return np.sqrt(squares) * np.interp(squares, self.squares, self._mean)
