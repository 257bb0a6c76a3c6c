"""The place of the greatest stress below a contact: a coarse search over the meridian or the body, then finer ones."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

__all__ = ["StressPlace", "StressSpot", "greatest", "greatest_around"]

REFINEMENTS = 14
"""Rounds of refinement; each narrows the box to about a third, so the place is good to 1e-6 of the radius."""


COARSE_DIRECTIONS = 24
"""Directions about the axis of the coarse search."""


class StressPlace(NamedTuple):
    """A greatest value and where it stands, r and z in the units they were searched in."""

    value: float
    r: float
    z: float


class StressSpot(NamedTuple):
    """A greatest value and where it stands in the body."""

    value: float
    x: float
    y: float
    z: float


def greatest(
    field: Callable[[Array, Array], Array],
    radius: float,
    *,
    top: float = 0.0,
    bottom: float = math.inf,
    both_sides: bool = False,
    zooms: int = REFINEMENTS,
) -> StressPlace:
    """Return the greatest value of `field` below a contact.

    Parameters
    ----------
    field
        Takes r and z of one shape [m], z >= 0 into the body; returns the quantity.  Values that are not finite do not
        count.
    radius
        Contact radius [m]; the search goes to 1.2 radii from the axis and 3 radii deep.
    top, bottom
        Depths between which is searched [m].
    both_sides
        Whether r is a coordinate along a line through the axis, also negative.
    zooms
        Rounds of refinement; each narrows the box to about a third.
    """
    r = np.concatenate([np.linspace(0.0, 0.9, 10), [0.95, 0.98, 1.0, 1.02, 1.05, 1.2]]) * radius
    if both_sides:
        r = np.concatenate([-r[:0:-1], r])
    z = np.concatenate([[0.0], np.geomspace(0.01, 3.0, 24)]) * radius
    if top > 0.0 or bottom < math.inf:
        z = _within(z, top, bottom, radius)
    least = -math.inf if both_sides else 0.0
    dr, dz = 0.1 * radius, 0.25
    best = _best(field, r, z)
    depth_step = max(dz * best.z, 0.01 * radius)
    for _ in range(zooms):
        around_r = np.unique(np.clip(best.r + dr * np.linspace(-1.0, 1.0, 7), least, None))
        around_z = np.unique(np.clip(best.z + depth_step * np.linspace(-1.0, 1.0, 7), top, bottom))
        best_place = _best(field, around_r, around_z)
        best = best_place if best_place.value >= best.value else best
        dr, depth_step = 0.36 * dr, 0.36 * depth_step
    return best


def _within(z: Array, top: float, bottom: float, radius: float) -> Array:
    """Return depths between two faces of a layer, of which both count."""
    end = min(bottom, top + 3.0 * radius)
    return np.unique(np.concatenate([z[(z > top) & (z < end)][::2], np.linspace(top, end, 5)]))


def _best(field: Callable[[Array, Array], Array], r: Array, z: Array) -> StressPlace:
    rr, zz = (grid.ravel() for grid in np.meshgrid(r, z, indexing="ij"))
    values = field(rr, zz)
    place = int(np.argmax(np.where(np.isfinite(values), values, -np.inf)))
    return StressPlace(float(values[place]), float(rr[place]), float(zz[place]))


def greatest_around(field: Callable[[Array, Array, Array], Array], radius: float) -> StressSpot:
    """Return the greatest value of a `field` without symmetry below a contact.

    Parameters
    ----------
    field
        Takes x, y and z of one shape [m], z >= 0 into the body; returns the quantity.
    radius
        Contact radius [m]; the search goes to 1.2 radii from the axis and 3 radii deep, and follows the greatest value
        on the surface as well as the one below it.
    """
    r = np.concatenate([np.linspace(0.0, 0.9, 10), [0.95, 1.0, 1.05, 1.2]]) * radius
    turn = np.arange(COARSE_DIRECTIONS) / COARSE_DIRECTIONS
    c, s = np.cos(2.0 * np.pi * turn), np.sin(2.0 * np.pi * turn)
    c[np.abs(s) < 1e-12] = np.sign(c[np.abs(s) < 1e-12])
    s[np.abs(s) < 1e-12] = 0.0
    x, y = np.outer(r, c).ravel(), np.outer(r, s).ravel()
    on = _spot(field, x, y, np.zeros(1))
    below = _spot(field, x, y, np.geomspace(0.02, 3.0, 18) * radius)
    return max(_zoomed(field, on, radius), _zoomed(field, below, radius))


def _zoomed(field: Callable[[Array, Array, Array], Array], best: StressSpot, radius: float) -> StressSpot:
    wide, high = 0.15 * radius, max(0.3 * best.z, 0.02 * radius)
    for _ in range(REFINEMENTS):
        line = np.linspace(-1.0, 1.0, 5)
        x, y = (part.ravel() for part in np.meshgrid(best.x + wide * line, best.y + wide * line))
        best_place = _spot(field, x, y, np.unique(np.clip(best.z + high * line, 0.0, None)))
        best = best_place if best_place.value >= best.value else best
        wide, high = 0.5 * wide, 0.5 * high
    return best


def _spot(field: Callable[[Array, Array, Array], Array], x: Array, y: Array, z: Array) -> StressSpot:
    across, along, deep = np.repeat(x, z.size), np.repeat(y, z.size), np.tile(z, x.size)
    values = field(across, along, deep)
    place = int(np.nanargmax(values))
    return StressSpot(*(float(part[place]) for part in (values, across, along, deep)))
