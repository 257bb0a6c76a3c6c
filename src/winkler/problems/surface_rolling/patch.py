"""A height map pressed to roll: the part of it around the contact, in pixels and over E*."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.checks.number_checks import affordable
from winkler.errors import InvalidInput, OutsideValidity
from winkler.limits import MOST_NUMBERS
from winkler.loading import Depth, Force
from winkler.media.halfspace import HalfSpace
from winkler.numerics.surfaces.pressed_box import box_around
from winkler.numerics.surfaces.pressed_grid import ByDepth, ByLoad, PressedSurface, press
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.path import numbers_of
from winkler.problems.rough.compliance import compliance_of
from winkler.profiles.rough.topography import Topography

__all__ = ["RollingPatch", "refuse_map", "rolling_patch"]


class RollingPatch(NamedTuple):
    """A pressed map.

    Parameters
    ----------
    pressed : PressedSurface
        The whole map.
    box : tuple of slice
        Around the contact.
    grid : TractionGrid
        Of the box.
    pressure : ndarray
        p / E* in the box.
    x, y : ndarray
        Places of the middles of its pixels [m].
    unit : float
        E* times the area of a pixel [N]: a sum of pressures over E* becomes a force.
    """

    pressed: PressedSurface
    box: tuple[slice, slice]
    grid: TractionGrid
    pressure: Array
    x: Array
    y: Array
    unit: float

    def spread(self, part: Array) -> Array:
        """Return numbers in the box on the whole map, zero outside."""
        whole = np.zeros((*part.shape[:-2], *self.pressed.pressure.shape), dtype=part.dtype)
        whole[(..., *self.box)] = part
        return whole


def refuse_map(who: str, rough: Topography) -> None:
    """Refuse maps that cannot roll.

    Raises
    ------
    InvalidInput
        If the map is too large, has missing heights, or is periodic.
    """
    affordable(who, "pixels of two directions with their surroundings", 8 * rough.heights.size, MOST_NUMBERS)
    if rough.missing:
        raise InvalidInput(
            f"{who}: {rough.missing} of {rough.heights.size} heights are missing; fill them with topography.filled(), "
            "or cut a complete part out with topography.cropped(...)."
        )
    if rough.periodic:
        raise InvalidInput(
            f"{who}: a periodic map has no leading edge, where material comes in; give a map that stands alone."
        )


def rolling_patch(who: str, rough: Topography, medium: HalfSpace, load: Force | Depth) -> RollingPatch:
    """Press a map.

    Raises
    ------
    OutsideValidity
        If the contact reaches the border of the map.
    NotConverged
        If the pressures are not found.
    """
    pixel = rough.pixel
    unit = medium.modulus * pixel[0] * pixel[1]
    number = float(numbers_of(load))
    pressed = press(
        rough.gaps, pixel, ByDepth(number) if isinstance(load, Depth) else ByLoad(number / unit), periodic=False
    )
    touching = pressed.pressure > 0.0
    if any(np.any(side) for side in (touching[0], touching[-1], touching[:, 0], touching[:, -1])):
        raise OutsideValidity(
            f"{who}: the contact reaches the border of the map, and what rolls in there is not known; give a larger "
            "map."
        )
    box = box_around(touching)
    p, (nx, ny) = pressed.pressure[box], touching.shape
    compliance = compliance_of(medium)._replace(coupling=0.0)
    grid = TractionGrid.of((p.shape[0], p.shape[1]), (1.0, pixel[1] / pixel[0]), compliance, periodic=False)
    x = np.broadcast_to(((np.arange(nx) - 0.5 * (nx - 1)) * pixel[0])[box[0], None], p.shape)
    y = np.broadcast_to(((np.arange(ny) - 0.5 * (ny - 1)) * pixel[1])[None, box[1]], p.shape)
    return RollingPatch(pressed, box, grid, p, x, y, unit)
