"""The springs of a worn contact that are pushed along the surface, on a grid."""

from __future__ import annotations

from typing import Any

from winkler.media.offers import PressedWaves, offers
from winkler.numerics.transforms.grid_transforms import CutCell, GridTransforms, SurfaceTransform
from winkler.numerics.types import Array


class ShearedGrid:
    """Springs that are as stiff along the surface as across it, but for one ratio.

    Parameters
    ----------
    transforms : GridTransforms
        Between the springs and what they bear along the surface.
    surface : SurfaceTransform
        What restores the displacement of the surface.
    ratio : float
        E*/G*, or of strips E*/m_L [-].
    """

    def __init__(self, transforms: GridTransforms, surface: SurfaceTransform | None, ratio: float) -> None:
        self.rings, self.ratio = transforms, ratio
        self._surface = surface

    def bounds(self, stretch: Array) -> Array:
        """Return how far springs move along the surface [m] before they slide, over mu times the ratio.

        Negative where nothing is pressed.

        Parameters
        ----------
        stretch : ndarray, (n,)
            Of the pressed springs [m].
        """
        return stretch

    def slip(self, lag: Array, cuts: list[CutCell]) -> Array:
        """Return how far the surface lags behind [m], where springs do so by what is positive of a lag [m]."""
        assert self._surface is not None
        return self._surface(lag, cuts)


class LayeredShearGrid(ShearedGrid):
    """Springs of layers, which answer to shear otherwise than to pressure; parameters as of `RubbedRings`."""

    def __init__(self, normal: Any, shear: Any, ratio: float) -> None:
        # numerics of layers are loaded with layers
        from winkler.numerics.transforms.rubbed_rings import RubbedRings

        super().__init__(shear, None, ratio)
        self._rubbed = RubbedRings(normal, shear)

    def bounds(self, stretch: Array) -> Array:
        """As `ShearedGrid.bounds`."""
        return self._rubbed.bounds(stretch)

    def slip(self, lag: Array, cuts: list[CutCell]) -> Array:
        """As `ShearedGrid.slip`."""
        return self._rubbed.slip(lag)


def sheared_grid(grid: Any) -> ShearedGrid:
    """Return the springs of a RoundGrid that are pushed along the surface."""
    medium, transforms = grid.bed.medium, grid.rings
    ratio = float(medium.modulus / medium.shear_modulus)
    if offers(medium, PressedWaves):
        shear = type(transforms)(grid.nodes, grid.bed.medium.tangential_response)
        return LayeredShearGrid(transforms, shear, ratio)
    return ShearedGrid(transforms, grid.surface, ratio)


def sheared_strips(grid: Any) -> ShearedGrid:
    """Return the springs of a StripGrid that are pushed along the surface."""
    bed, ratio = grid.bed, float(grid.bed.along_share)
    if bed.sheared_as_pressed:
        return ShearedGrid(grid.transforms, grid.surface, ratio)
    return LayeredShearGrid(grid.transforms, bed.shear_transforms(grid.nodes), ratio)
