"""The place of the greatest stress below a contact: a coarse search over the meridian or the body, then finer ones."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

__all__ = ["StressPlace", "StressSpot", "greatest", "greatest_around"]

REFINEMENTS = 14
"""Most rounds of refinement; each narrows the box to about a third, so the place is good to 1e-6 of the radius."""
LINE = np.linspace(-1.0, 1.0, 7)
"""Places of a round along one side of its box."""
NARROWED, FITTED, WIDENED = 0.36, 0.04, 6.0
"""Size of the next box over that of this one: around the best point, around the top of a fitted paraboloid, and after
one of these on whose face the best point lies."""
MISFIT = 0.02
"""Largest root mean square of the misfit of a paraboloid that counts as one, over the range of the values."""
DEEPER = np.geomspace(1.0, 4.0, 6)[1:]
"""How much deeper the coarse search goes on where the greatest value is the lowest one."""
MOST_DEEPENINGS = 12
ROUNDING = 1e-13
"""Range of the values of a box, over the greatest, below which they differ by rounding alone."""

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
    smooth: bool = False,
) -> StressPlace:
    """Return the greatest value of `field` below a contact.

    Parameters
    ----------
    field
        Takes r and z of one shape [m], z >= 0 into the body; returns the quantity.  Values that are not finite do not
        count.
    radius
        Contact radius [m]; the search begins within 1.2 radii from the axis and 3 radii of depth.  In a layer that lies
        deeper than the contact is wide, these are depths of its upper face; it goes deeper as long as values rise
        there, as below a stiff layer that spreads a narrow contact.
    top, bottom
        Depths between which is searched [m].
    both_sides
        Whether r is a coordinate along a line through the axis, also negative; then the greatest of both sides, and of
        the surface, are followed.
    zooms
        Rounds of refinement; each narrows the box to about a third.
    smooth
        Whether the field has no sharp places; the top of a paraboloid through the values of a box is then the middle
        of the next one, and fewer rounds are needed.
    """
    radius = math.hypot(radius, top)  # over such a distance a load has spread in that depth
    r = np.concatenate([np.linspace(0.0, 0.9, 10), [0.95, 0.98, 1.0, 1.02, 1.05, 1.2]]) * radius
    if both_sides:
        r = np.concatenate([-r[:0:-1], r])
    z = np.concatenate([[0.0], np.geomspace(0.01, 3.0, 24)]) * radius
    if top > 0.0 or bottom < math.inf:
        z = _within(z, top, bottom, radius)
    values = _values(field, r, z)
    for _ in range(MOST_DEEPENINGS):
        if _highest(r, z, values).z < z[-1] or z[-1] >= bottom:
            break
        deeper = np.unique(np.minimum(top + (z[-1] - top) * DEEPER, bottom))
        z, values = np.append(z, deeper), np.hstack([values, _values(field, r, deeper)])
    if not both_sides:
        return _followed(field, _highest(r, z, values), radius, (top, bottom), False, zooms, smooth)
    found = []
    for side in (r < 0.0, r >= 0.0):  # coarse values do not tell which side has more, or whether the surface has
        found.append(_followed(field, _highest(r[side], z, values[side]), radius, (top, bottom), True, zooms, smooth))
        if top == 0.0:
            on = _highest(r[side], z[:1], values[side, :1])
            found.append(_followed(field, on, radius, (0.0, 0.0), True, zooms, False))
    return max(found, key=lambda place: place.value)


def _followed(
    field: Callable[[Array, Array], Array],
    best: StressPlace,
    radius: float,
    depths: tuple[float, float],
    both_sides: bool,
    zooms: int,
    smooth: bool,
) -> StressPlace:
    """Return the greatest value about a place, in smaller and smaller boxes; the rest as of `greatest`."""
    (top, bottom), least = depths, -math.inf if both_sides else 0.0
    dr, depth_step = 0.1 * radius, max(0.25 * best.z, 0.01 * radius)
    centre, fitted, least_step = best, False, NARROWED**zooms * 0.1 * radius
    for _ in range(zooms):
        around_r = np.unique(np.clip(centre.r + dr * LINE, least, None))
        around_z = np.unique(np.clip(centre.z + depth_step * LINE, top, bottom))
        values = _values(field, around_r, around_z)
        found = _highest(around_r, around_z, values)
        best, size = (found if found.value >= best.value else best), NARROWED
        centre = best
        if smooth:
            finite = values[np.isfinite(values)]
            if max(dr, depth_step) < least_step or (finite.size and np.ptp(finite) <= ROUNDING * abs(best.value)):
                break
            place = None
            if best is found:
                held = found.z == bottom or found.z == top > 0.0
                fit = _fitted_row if held else _fitted_top
                place = fit(around_r, around_z, values, on_axis=around_r[0] == least)
            if _on_face(found, around_r, around_z, (least, top, bottom)):
                size, fitted = WIDENED if fitted else 1.0, False
            elif fitted := place is not None:
                centre, size = StressPlace(best.value, *place), FITTED
        dr, depth_step = size * dr, size * depth_step
    return best if both_sides else _on_axis(field, best, radius)


def _on_axis(field: Callable[[Array, Array], Array], best: StressPlace, radius: float) -> StressPlace:
    """Return the point of the axis beside a place that lies off it by no more than the rounding of values allows."""
    if 0.0 < best.r <= math.sqrt(ROUNDING) * radius:
        value = float(field(np.zeros(1), np.array([best.z]))[0])
        if value >= (1.0 - ROUNDING) * best.value:
            return StressPlace(value, 0.0, best.z)
    return best


def _fitted_top(r: Array, z: Array, values: Array, *, on_axis: bool) -> tuple[float, float] | None:
    """Return where a paraboloid through the values of a box has its top; None if they are none, or it lies outside.

    The box may touch the axis, about which the values are even.
    """
    if r.size < 3 or z.size < LINE.size or not np.all(np.isfinite(values)):
        return None
    half_r, half_z, middle_r, middle_z = 0.5 * np.ptp(r), 0.5 * np.ptp(z), r[0], 0.5 * (z[0] + z[-1])
    if not on_axis:
        middle_r = 0.5 * (r[0] + r[-1])
    x, y = (part.ravel() for part in np.meshgrid((r - middle_r) / half_r, (z - middle_z) / half_z, indexing="ij"))
    columns = [np.ones(x.size), y, y * y, x * x] + ([] if on_axis else [x, x * y])
    matrix, flat = np.stack(columns, axis=1), values.ravel()
    solution = np.linalg.lstsq(matrix, flat, rcond=None)[0]
    if np.sqrt(np.mean((matrix @ solution - flat) ** 2)) > MISFIT * np.ptp(flat):
        return None
    _, by_y, by_yy, by_xx, by_x, by_xy = np.append(solution, np.zeros(6 - len(columns)))
    determinant = 4.0 * by_xx * by_yy - by_xy**2
    if not (by_xx < 0.0 and by_yy < 0.0 < determinant):
        return None
    across = (by_xy * by_y - 2.0 * by_yy * by_x) / determinant
    down = (by_xy * by_x - 2.0 * by_xx * by_y) / determinant
    if max(abs(across), abs(down)) > 1.0:
        return None
    return float(middle_r + half_r * across), float(middle_z + half_z * down)


def _fitted_row(r: Array, z: Array, values: Array, *, on_axis: bool) -> tuple[float, float] | None:
    """Return the top of a parabola along the face of a layer on which the greatest value lies; None as of the other."""
    row = values[:, int(np.argmax(np.max(values, axis=0)))]
    face = float(z[int(np.argmax(np.max(values, axis=0)))])
    if r.size < LINE.size - 3 or not np.all(np.isfinite(row)):
        return None
    if on_axis and np.argmax(row) == 0:
        return float(r[0]), face
    half, middle = 0.5 * np.ptp(r), 0.5 * (r[0] + r[-1])
    x = (r - middle) / half
    bend, rise, level = np.polyfit(x, row, 2)
    misfit = np.sqrt(np.mean((np.polyval((bend, rise, level), x) - row) ** 2))
    if misfit > MISFIT * np.ptp(row) or bend >= 0.0 or abs(rise) > -2.0 * bend:
        return None
    return float(middle - 0.5 * half * rise / bend), face


def _on_face(found: StressPlace, r: Array, z: Array, ends: tuple[float, float, float]) -> bool:
    """Return whether the best point lies on a face of its box behind which the body goes on."""
    least, top, bottom = ends
    return bool(found.r == r[-1] or z[-1] == found.z < bottom or found.r == r[0] > least or found.z == z[0] > top)


def _within(z: Array, top: float, bottom: float, radius: float) -> Array:
    """Return depths between two faces of a layer, of which both count."""
    end = min(bottom, top + 3.0 * radius)
    return np.unique(np.concatenate([z[(z > top) & (z < end)][::2], np.linspace(top, end, 5)]))


def _values(field: Callable[[Array, Array], Array], r: Array, z: Array) -> Array:
    """Return the values in all places of a grid."""
    rr, zz = (grid.ravel() for grid in np.meshgrid(r, z, indexing="ij"))
    return field(rr, zz).reshape(r.size, z.size)


def _highest(r: Array, z: Array, values: Array) -> StressPlace:
    i, j = np.unravel_index(int(np.argmax(np.where(np.isfinite(values), values, -np.inf))), values.shape)
    return StressPlace(float(values[i, j]), float(r[i]), float(z[j]))


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
