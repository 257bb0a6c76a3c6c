"""A height map pressed to roll: the part of it around the contact, in pixels and over E*."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad, box_around
from winkler.numerics.surfaces.pressed_grid import PressedSurface, press
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.surface_friction.by_turns import Found, by_turns, press_from
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import affordable
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import MOST_NUMBERS


class RollingPatch(NamedTuple):
    """A pressed map.

    Parameters
    ----------
    gaps : ndarray
        Of the whole map [m].
    drive : ByDepth or ByLoad
        How it is pressed.
    pressed : PressedSurface
        The whole map.
    box : tuple of slice
        Around the contact; of dissimilar bodies, whose contact changes with the tractions, all of the map.
    grid : TractionGrid
        Of the box.
    pressure : ndarray
        p / E* in the box.
    x, y : ndarray
        Places of the middles of its pixels [m].
    arms : ndarray
        Distances of these from the middle of the map [m].
    pixel : tuple of float
        Its sides [m].
    unit : float
        E* times the area of a pixel [N]: a sum of pressures over E* becomes a force.
    coupled : bool
        Whether pressures draw the surface along.
    """

    gaps: Array
    drive: ByDepth | ByLoad
    pressed: PressedSurface
    box: tuple[slice, slice]
    grid: TractionGrid
    pressure: Array
    x: Array
    y: Array
    arms: Array
    pixel: tuple[float, float]
    unit: float
    coupled: bool

    def spread(self, part: Array) -> Array:
        """Return numbers in the box on the whole map, zero outside."""
        whole = np.zeros((*part.shape[:-2], *self.pressed.pressure.shape), dtype=part.dtype)
        whole[(..., *self.box)] = part
        return whole

    def rubbed(
        self, under: Callable[[Array, Array], Found], start: Array, tolerance: float
    ) -> tuple[RollingPatch, Found]:
        """Return the map with tractions on it, and of dissimilar bodies with the pressures that agree with them.

        Parameters
        ----------
        under
            Finds tractions under pressures over E* in the box, from tractions to begin with.
        start
            Tractions to begin with, over E*.
        tolerance
            As of `winkler.problems.surface_friction.by_turns.by_turns`.

        Raises
        ------
        OutsideValidity
            If the contact reaches the border of the map.
        NotConverged
            If pressures and tractions do not agree.
        """
        if not self.coupled:
            return self, under(self.pressure, start)

        def pressed_on(gaps: Array) -> PressedSurface:
            return press_from(gaps, self.pixel, self.drive, periodic=False, start=self.pressed.pressure)

        pressed, found = by_turns(
            self.grid, self.gaps, self.pixel[0], pressed_on, under, start, tolerance,
            by_load=isinstance(self.drive, ByLoad),
        )  # fmt: skip
        _refuse_border(pressed.pressure > 0.0)
        return self._replace(pressed=pressed, pressure=pressed.pressure), found


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
            f"{who}: a periodic map has no leading edge, where material comes in; give a map that is not periodic."
        )


def rolling_patch(who: str, rough: Topography, medium: MappedMedium, load: Force | Depth) -> RollingPatch:
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
    drive = ByDepth(number) if isinstance(load, Depth) else ByLoad(number / unit)
    pressed = press(rough.gaps, pixel, drive, periodic=False, layers=layers_of(medium))
    touching = pressed.pressure > 0.0
    try:
        _refuse_border(touching)
    except OutsideValidity as error:
        raise OutsideValidity(f"{who}: {error}.") from None
    compliance = compliance_of(medium).in_units_of(pixel[0])
    coupled = compliance.coupling != 0.0
    box = (slice(None), slice(None)) if coupled else box_around(touching)
    p, (nx, ny) = pressed.pressure[box], touching.shape
    grid = TractionGrid.of((p.shape[0], p.shape[1]), (1.0, pixel[1] / pixel[0]), compliance, periodic=False)
    x = np.broadcast_to(((np.arange(nx) - 0.5 * (nx - 1)) * pixel[0])[box[0], None], p.shape)
    y = np.broadcast_to(((np.arange(ny) - 0.5 * (ny - 1)) * pixel[1])[None, box[1]], p.shape)
    return RollingPatch(rough.gaps, drive, pressed, box, grid, p, x, y, np.hypot(x, y), pixel, unit, coupled)


def _refuse_border(touching: Array) -> None:
    if any(np.any(side) for side in (touching[0], touching[-1], touching[:, 0], touching[:, -1])):
        raise OutsideValidity(
            "the contact reaches the border of the map, and what rolls in there is not known; give a larger map"
        )
