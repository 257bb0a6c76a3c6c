"""The greatest stress below a contact and its place: in the meridian plane, and in the body below a disc or ellipse."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.highest import MOST_ROUNDS, MOST_STARTS, Top, highest
from winkler.numerics.types import Array

FINER = 0.25
"""Step of the places on the surface over that of the grid."""
MIDDLE = np.linspace(-0.8, 0.8, 9)
"""Places along x and y of the search about the axis."""
RINGS = np.array([0.6, 0.75, 0.85, 0.92, 0.97, 1.0, 1.03, 1.1])
"""Distances from the axis of the search about the edge."""
DIRECTIONS = 24
DEPTHS = np.append(0.0, np.geomspace(1e-3, 3.0, 18))
BESIDE_AXIS, OUTERMOST, DEEPEST = 0.9, 1.3, 6.0
"""How far from the axis a place is followed in either search, and how deep."""


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
    starts: int = MOST_STARTS,
    rounds: int = MOST_ROUNDS,
) -> StressPlace:
    """Return the greatest value of `field` below a contact.

    Parameters
    ----------
    field
        Takes r and z of one shape [m], z >= 0 into the body; returns the quantity.  Values that are not finite do not
        count.
    radius
        Contact radius [m]; the search begins within 1.2 radii from the axis and 3 radii of depth.  In a layer that lies
        deeper than the contact is wide, these are depths of its upper face; the search goes deeper where values rise,
        as below a stiff layer that spreads a narrow contact.
    top, bottom
        Depths between which is searched [m].
    both_sides
        Whether r is a coordinate along a line through the axis, also negative, as below a contact that slides.
    starts, rounds
        As of `highest`, for fields that are costly.
    """
    radius = math.hypot(radius, top)  # over such a distance a load has spread in that depth
    r = np.concatenate([np.linspace(0.0, 0.9, 10), [0.95, 0.98, 1.0, 1.02, 1.05, 1.2]]) * radius
    if both_sides:
        r = np.concatenate([-r[:0:-1], r])
    z = np.concatenate([[0.0], np.geomspace(0.01, 3.0, 24)]) * radius
    if top > 0.0 or bottom < math.inf:
        z = _within(z, top, bottom, radius)

    def mirrored(r: Array, z: Array) -> Array:
        return field(r if both_sides else np.abs(r), z)

    ends = [(-math.inf, math.inf), (top, bottom)]
    found = highest(mirrored, [r, z], ends, starts=starts, rounds=rounds)
    if both_sides and top == 0.0:  # friction may make it narrower on the surface than the grid shows
        dense = np.interp(np.arange(0, r.size - 1 + 0.5 * FINER, FINER), np.arange(r.size), r)
        surface = highest(mirrored, [dense, z[:1]], ends, starts=starts, rounds=rounds, above=found.value)
        found = max(found, surface, key=lambda one: one.value)
    along, deep = found.place
    return StressPlace(found.value, along if both_sides else abs(along), deep)


def _within(z: Array, top: float, bottom: float, radius: float) -> Array:
    """Return depths between two faces of a layer, of which both count."""
    end = min(bottom, top + 3.0 * radius)
    return np.unique(np.concatenate([z[(z > top) & (z < end)][::2], np.linspace(top, end, 5)]))


def greatest_around(
    field: Callable[[Array, Array, Array], Array], *, ratio: float = 1.0, even: tuple[bool, bool] = (False, False)
) -> StressSpot:
    """Return the greatest value of a `field` below a disc or an ellipse, and its place.

    About the axis it is sought along x and y, about the edge by the distance over that of the edge and the angle: so
    both the edge, at which stresses on the surface have a cusp, and the axis are places like others on their grids.

    Parameters
    ----------
    field
        Takes x, y and z of one shape, z >= 0 into the body; returns the quantity.  The semi-axis along x is one.
    ratio
        Of the semi-axis along y to that along x; depths are those over the smaller one times it.
    even
        Whether the field is the same at x and -x, and at y and -y: then the place has x, y >= 0.
    """
    smaller = min(1.0, ratio)

    def about_axis(x: Array, y: Array, z: Array) -> Array:
        return field(x, ratio * y, smaller * z)

    def about_edge(ring: Array, angle: Array, z: Array) -> Array:
        return about_axis(ring * _cosine(angle), ring * _cosine(angle - 0.5 * math.pi), z)

    half = MIDDLE[MIDDLE.size // 2 :]
    anywhere, deep = (-math.inf, math.inf), (0.0, DEEPEST)
    middle = [half if same else MIDDLE for same in even]
    within = (-BESIDE_AXIS, BESIDE_AXIS)
    found = highest(about_axis, [*middle, DEPTHS], [within, within, deep])
    lowest, highest_angle = {
        (False, False): (-1, DIRECTIONS),
        (True, False): (-DIRECTIONS // 4, DIRECTIONS // 4),
        (False, True): (0, DIRECTIONS // 2),
        (True, True): (0, DIRECTIONS // 4),
    }[even]
    angles = np.arange(lowest, highest_angle + 1) * 2.0 * math.pi / DIRECTIONS
    ends = [(RINGS[0], OUTERMOST), anywhere, deep]
    edge = highest(about_edge, [RINGS, angles, DEPTHS], ends, above=found.value)
    if edge.value > found.value:
        ring, angle, z = edge.place
        found = Top(edge.value, (ring * float(_cosine(angle)), ring * float(_cosine(angle - 0.5 * math.pi)), z))
    x, y, z = found.place
    return StressSpot(found.value, abs(x) if even[0] else x, ratio * (abs(y) if even[1] else y), smaller * z)


def _cosine(angle: Array | float) -> Array:
    """Return the cosine, zero at right angles."""
    found = np.cos(angle)
    return np.asarray(np.where(np.abs(found) < 1e-15, 0.0, found))
