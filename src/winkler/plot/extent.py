"""How far a picture goes, and where its curves need care."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from winkler.errors import InvalidInput
from winkler.foundation.bed import PressedSprings
from winkler.numerics.types import Array

__all__ = [
    "Outline",
    "around",
    "checked_extent",
    "is_singular",
    "is_torn",
    "marks_of",
    "solid_until",
    "sunk",
    "typical",
]

WIDER = 1.8
"""A picture of a contact goes to so many contact radii."""


class Outline(Protocol):
    """What has an outline: a profile, or a bed under one."""

    @property
    def reach(self) -> float:
        """Up to where it is known [m]."""
        ...

    @property
    def rim(self) -> float:
        """Where its wall is [m]."""
        ...

    @property
    def size(self) -> float:
        """Radius of the body [m]."""
        ...

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Where it is not smooth."""
        ...

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        ...


def checked_extent(extent: float | None) -> float | None:
    """Refuse an extent that is no positive length."""
    if extent is not None and not (isinstance(extent, int | float) and math.isfinite(extent) and extent > 0.0):
        raise InvalidInput(f"draw: extent is {extent!r}; give a positive distance from the axis in m.")
    return extent


def typical(shape: Outline) -> float:
    """Return a distance from the axis [m] that shows what is special about a shape.

    Up to where it is known or its wall; else three times its outermost kink; else a tenth of the body's radius; for a
    shape without any length, such as a cone, 1 mm.
    """
    known = solid_until(shape)
    if math.isfinite(known) and known < shape.size:
        return known
    if shape.kinks:
        return min(3.0 * shape.kinks[-1][0], known)
    if math.isfinite(shape.size):
        return min(0.6 * shape.size, known)
    return min(1e-3, known)


def solid_until(shape: Outline) -> float:
    """Return where the outline of a shape ends [m]: at its wall, or where nothing is known of it any more."""
    return min(shape.reach, shape.rim)


def around(pressed: PressedSprings, extent: float | None) -> float:
    """Return how far the picture of a contact goes [m]."""
    if checked_extent(extent) is not None:
        assert extent is not None
        return float(extent)
    if pressed.radius > 0.0:
        return WIDER * pressed.radius
    r = typical(pressed.bed) * np.linspace(0.0, 1.0, 401)[1:]
    high = np.flatnonzero(pressed.bed.height(r) >= 4.0 * abs(pressed.depth))
    return float(r[high[0]] if high.size and pressed.depth < 0.0 else 0.5 * r[-1])


def marks_of(pressed: PressedSprings) -> tuple[float, ...]:
    """Return the places where the fields of a contact are not smooth [m]: its kinks and its edge."""
    return (*(b for b, _ in pressed.bed.kinks), *{pressed.touching, pressed.radius})


def is_singular(pressed: PressedSprings) -> bool:
    """Return whether the pressure is infinite anywhere: at an edge, at a kink, or under a pointed apex."""
    if pressed.radius == 0.0:
        return False
    if pressed.edge > 0.0 or is_torn(pressed):
        return True
    places = np.array([0.0, *(b for b, strength in pressed.kinks if strength != 0.0)])
    return not bool(np.isfinite(pressed.bed.medium.pressure(pressed, places)).all())


def is_torn(pressed: PressedSprings) -> bool:
    """Return whether the edge pulls with a tension that is infinite: attraction without range.

    Where a ring around the contact is pulled, the tension is finite.
    """
    return pressed.radius > 0.0 and pressed.edge < 0.0 and pressed.touching >= pressed.radius


def sunk(pressed: PressedSprings, r: Array) -> Array:
    """Return the displacement of the surface [m], inside and outside the contact."""
    if pressed.radius == 0.0:
        return np.zeros(r.shape)
    return np.asarray(pressed.bed.medium.displacement(pressed, r))
