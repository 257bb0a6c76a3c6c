"""The springs of a worn round contact that are pushed along the surface, on a grid of radii."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.media.offers import PressedWaves, offers
from winkler.numerics.transforms.grid_transforms import Cuts, GridTransforms
from winkler.numerics.types import Array

__all__ = ["ShearedGrid", "sheared_grid"]


class ShearedGrid:
    """Springs that are as stiff along the surface as across it, but for one ratio.

    Parameters
    ----------
    grid : RoundGrid
        Of the pressed contact.
    """

    def __init__(self, grid: Any) -> None:
        self._surface = grid.surface
        self.rings: GridTransforms = grid.rings
        """Between the springs and what they bear along the surface."""
        medium = grid.bed.medium
        self.ratio = float(medium.modulus / medium.shear_modulus)
        """E*/G* [-]."""

    def bounds(self, stretch: Array) -> Array:
        """Return how far springs move along the surface [m] before they slide, over mu E*/G*.

        Negative where nothing is pressed.

        Parameters
        ----------
        stretch : ndarray, (n,)
            Of the pressed springs [m].
        """
        return stretch

    def slip(self, lag: Array, cut: Cuts) -> Array:
        """Return how far the surface lags behind [m], where springs do so by what is positive of a lag [m]."""
        return np.asarray(self._surface(lag, cut))


class LayeredShearGrid(ShearedGrid):
    """Springs of layers, which answer to shear otherwise than to pressure; parameters as of `ShearedGrid`."""

    def __init__(self, grid: Any) -> None:
        # numerics of layers are loaded with layers
        from winkler.numerics.transforms.rubbed_rings import RubbedRings

        medium = grid.bed.medium
        self._rubbed = RubbedRings(grid.rings, medium.tangential_response)
        self.rings = self._rubbed.shear
        self.ratio = float(medium.modulus / medium.shear_modulus)

    def bounds(self, stretch: Array) -> Array:
        """As `ShearedGrid.bounds`."""
        return self._rubbed.bounds(stretch)

    def slip(self, lag: Array, cut: Cuts) -> Array:
        """As `ShearedGrid.slip`."""
        return self._rubbed.slip(lag)


def sheared_grid(grid: Any) -> ShearedGrid:
    """Return the springs of a RoundGrid that are pushed along the surface."""
    return (LayeredShearGrid if offers(grid.bed.medium, PressedWaves) else ShearedGrid)(grid)
