"""Extent of a picture, and the points at which its curves are not smooth."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

RADII_DRAWN = 1.8
"""Extent of the picture of a contact in contact radii."""


class BodyOutline(Protocol):
    """A body with an outline: a profile, or a bed under one."""

    @property
    def reach(self) -> float:
        """Greatest radius at which the profile is defined [m]."""

    @property
    def rim(self) -> float:
        """Radius of its wall [m]."""

    @property
    def size(self) -> float:
        """Radius of the body [m]."""

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Radii at which it is not smooth."""

    def height(self, r: Array) -> Array:
        """f(r) [m]."""


def checked_extent(extent: float | None) -> float | None:
    """Return the extent; raise InvalidInput unless it is a positive length."""
    if extent is not None and not (isinstance(extent, int | float) and math.isfinite(extent) and extent > 0.0):
        raise InvalidInput(f"draw: extent is {extent!r}; give a positive distance from the axis in m.")
    return extent


def typical(shape: BodyOutline) -> float:
    """Return a characteristic distance from the axis [m] for the picture of a shape.

    The end of its outline; else three times its outermost kink; else a tenth of the body's radius; for a
    shape without any length, such as a cone, 1 mm.
    """
    end = outline_end(shape)
    if math.isfinite(end) and end < shape.size:
        return end
    if shape.kinks:
        return min(3.0 * shape.kinks[-1][0], end)
    if math.isfinite(shape.size):
        return min(0.6 * shape.size, end)
    return min(1e-3, end)


def outline_end(shape: BodyOutline) -> float:
    """Return the radius at which the outline of a shape ends [m]: its wall, or the end of its definition."""
    return min(shape.reach, shape.rim)


def around(pressed: PressedSprings, extent: float | None) -> float:
    """Return the extent of the picture of a contact [m]."""
    if checked_extent(extent) is not None:
        assert extent is not None
        return float(extent)
    if pressed.radius > 0.0:
        return RADII_DRAWN * pressed.radius
    r = typical(pressed.bed) * np.linspace(0.0, 1.0, 401)[1:]
    high = np.flatnonzero(pressed.bed.height(r) >= 4.0 * abs(pressed.depth))
    return float(r[high[0]] if high.size and pressed.depth < 0.0 else 0.5 * r[-1])


def marks_of(pressed: PressedSprings) -> tuple[float, ...]:
    """Return the radii at which the fields of a contact are not smooth [m]: its kinks and its edge."""
    return (*(b for b, _ in pressed.bed.kinks), *{pressed.touching, pressed.radius})


def is_singular(pressed: PressedSprings) -> bool:
    """Return whether the pressure is infinite anywhere: at an edge, at a kink, or under a pointed apex."""
    if pressed.radius == 0.0:
        return False
    if pressed.edge > 0.0 or has_tensile_singularity(pressed):
        return True
    places = np.array([0.0, *(b for b, strength in pressed.kinks if strength != 0.0)])
    return not bool(np.isfinite(pressed.bed.medium.pressure(pressed, places)).all())


def has_tensile_singularity(pressed: PressedSprings) -> bool:
    """Return whether the tension at the edge is infinite: adhesion of vanishing range.

    With a cohesive zone around the contact, the tension is finite.
    """
    return pressed.radius > 0.0 and pressed.edge < 0.0 and pressed.touching >= pressed.radius


def sunk(pressed: PressedSprings, r: Array) -> Array:
    """Return the displacement of the surface [m], inside and outside the contact."""
    if pressed.radius == 0.0:
        return np.zeros(r.shape)
    return np.asarray(pressed.bed.medium.displacement(pressed, r))
