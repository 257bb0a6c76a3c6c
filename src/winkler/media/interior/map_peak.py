"""The greatest stress of a kind below a map of loads, and its place.

Depths are searched from half a pixel down, each on means over pixels that are small against it.  Of a map that stands
alone the greatest is climbed to from the best places; of a periodic one, and in layers, depths are tried and a parabola
leads from pixel to pixel.  Stresses on the surface are those in the middles of the pixels.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from winkler.media.interior.map_field import MapField
from winkler.media.interior.peak import StressSpot
from winkler.media.interior.periodic_map_field import PeriodicMapField
from winkler.media.interior.tensor import Measure, Tensor, von_mises
from winkler.numerics.types import Array

__all__ = [
    "DeepStresses",
    "greatest_below_map",
    "greatest_by_depths",
    "greatest_of_levels",
    "greatest_over_depth",
    "loaded_span",
]

SHALLOWEST = 0.5
"""Smallest depth below the surface that is searched, in pixels; nearer to it the steps between pixels show."""
DEPTH_STEP = 1.4
"""Ratio of neighbouring depths of the search."""
DEEPEST = 0.6
"""Greatest depth of the search over the longer side of the loaded part."""
MEANS_PER_DEPTH = 2.0
"""Depth over the side of the means that stand for the pixels in the search."""
MEANS_PER_CLIMB = 8.0
"""The same of the first climb; the last one is on the pixels themselves."""
MOST_CLIMBS = 2
"""Best places of the search from which the greatest is climbed to."""
NEAR_BEST = 0.97
"""Stress over the greatest of the search above which a place is climbed from."""
FIRST_STEP, LAST_STEP = 0.3, 0.02
"""Sides of the simplexes with which climbs begin, over the depth."""
DEPTH_TOLERANCE, MOST_DEPTHS = 5e-3, 6
"""Of the depth of a greatest stress below the upper face, and how many depths are tried for it."""
PLACE_TOLERANCE, VALUE_TOLERANCE = 1e-4, 1e-9
"""To which part of the depth the place is found, and to which part of itself the stress."""


def greatest_below_map(field: MapField | PeriodicMapField, measure: Measure = von_mises) -> StressSpot:
    """Return the greatest stress of a kind and its place, z >= 0.

    Parameters
    ----------
    field
        With some load.
    measure
        Of which kind; von Mises' unless given.
    """
    if isinstance(field, PeriodicMapField):
        levels = np.array([0.0, *_depths(field)])
        return greatest_of_levels(lambda z: (field.at_depth(z)[:6], field.pixel), levels, 0.0, measure)
    depths, least = _depths(field), SHALLOWEST * max(field.pixel)
    surface = _best_at(field, 0.0, measure)
    found = sorted(
        (_best_at(_on_means(field, z, MEANS_PER_DEPTH), z, measure) for z in depths), key=lambda spot: -spot.value
    )
    starts: list[StressSpot] = []
    for spot in found:
        apart = all(np.hypot(spot.x - other.x, spot.y - other.y) > spot.z for other in starts)
        if len(starts) < MOST_CLIMBS and spot.value >= NEAR_BEST * found[0].value and (not starts or apart):
            starts.append(spot)
    if surface.value * NEAR_BEST > found[0].value:
        return surface
    tops = [_climbed(_on_means(field, spot.z, MEANS_PER_CLIMB), spot, least, FIRST_STEP, measure) for spot in starts]
    best = max(tops, key=lambda spot: spot.value)
    return max(surface, _climbed(field, best, least, LAST_STEP, measure), key=lambda spot: spot.value)


def loaded_span(loads: Array, pixel: tuple[float, float]) -> float:
    """Return the longer side of the loaded part of a map, loads (3, nx, ny)."""
    loaded = np.any(loads != 0.0, axis=0)
    sides = [np.flatnonzero(loaded.any(axis=axis)) for axis in (1, 0)]
    return max(float(part[-1] - part[0] + 1) * size for part, size in zip(sides, pixel, strict=True))


def greatest_of_levels(
    stresses: Callable[[float], tuple[Array, tuple[float, float]]], depths: Array, top: float, measure: Measure
) -> StressSpot:
    """Return the greatest stress of a kind and its place, from stresses in the middles of all pixels at some depths.

    Parameters
    ----------
    stresses : Callable
        Depth to stresses (6, nx, ny), and the size of a pixel.
    depths : ndarray, (n,)
        First ones, ascending.
    top : float
        Depth of the upper face of what is searched.
    measure
        Of which kind.
    """
    found: dict[float, StressSpot] = {}

    def level(z: float) -> float:
        if z not in found:
            rows, (dx, dy) = stresses(z)
            stress = measure(Tensor(*rows))
            i, j = (int(part) for part in np.unravel_index(int(np.argmax(stress)), stress.shape))
            value, moved = float(stress[i, j]), [0.0, 0.0]
            if z >= SHALLOWEST * max(dx, dy):  # nearer to the surface the steps between pixels show
                beside = np.arange(-1, 2)
                for axis, row in enumerate(
                    (stress[:, j].take(i + beside, mode="wrap"), stress[i].take(j + beside, mode="wrap"))
                ):
                    bent = row[0] - 2.0 * row[1] + row[2]
                    if bent < 0.0:
                        moved[axis] = float(0.5 * (row[0] - row[2]) / bent)
                        value -= float((row[0] - row[2]) ** 2 / (8.0 * bent))
            found[z] = StressSpot(value, (i + 0.5 + moved[0]) * dx, (j + 0.5 + moved[1]) * dy, z)
        return found[z].value

    greatest_over_depth(level, depths, top)
    return max(found.values(), key=lambda spot: spot.value)


def greatest_over_depth(level: Callable[[float], float], depths: Array, top: float) -> None:
    """Ask a stress at some depths, and at others between the neighbours of the best of them.

    Parameters
    ----------
    level : Callable
        Depth to stress; it keeps what it has found.
    depths : ndarray, (n,)
        Ascending.
    top : float
        Depth of the upper face of what is searched.
    """
    from scipy.optimize import minimize_scalar

    best = int(np.argmax([level(float(z)) for z in depths]))
    ends = float(depths[max(best - 1, 0)]), float(depths[min(best + 1, depths.size - 1)])
    minimize_scalar(
        lambda z: -level(float(z)), bounds=ends, method="bounded",
        options={"xatol": DEPTH_TOLERANCE * (ends[1] - top), "maxiter": MOST_DEPTHS},
    )  # fmt: skip


class DeepStresses(NamedTuple):
    """Stresses of several kinds below a map.

    Parameters
    ----------
    depths : ndarray, (n,)
        From the surface on [m].
    values : ndarray, (kinds, n)
        The greatest of each kind at each depth [Pa].
    greatest
        The greatest of each kind, and its place.
    """

    depths: Array
    values: Array
    greatest: tuple[StressSpot, ...]


def greatest_by_depths(field: MapField | PeriodicMapField, measures: Sequence[Measure]) -> DeepStresses:
    """Return the greatest stresses of several kinds in the middles of pixels, which costs transforms alone.

    Parameters
    ----------
    field
        With some load.
    measures
        Of which kinds.
    """

    def bests(z: float, per_depth: float = MEANS_PER_DEPTH) -> list[StressSpot]:
        pixels = _on_means(field, z, per_depth)
        stress = Tensor(*pixels.at_depth(z)[:6])
        return [_best_of(pixels, measure(stress), z) for measure in measures]

    depths = [0.0, *_depths(field)]
    columns = list(zip(*(bests(z) for z in depths), strict=True))
    found = []
    for place, spots in enumerate(columns):
        top = max(range(1, len(depths)), key=lambda row: spots[row].value)
        if 1 < top < len(depths) - 1:  # a parabola over the logarithm of the depth
            low, middle, high = (spots[row].value for row in (top - 1, top, top + 1))
            bend = low - 2.0 * middle + high
            z = depths[top] * DEPTH_STEP ** (0.5 * (low - high) / bend if bend < 0.0 else 0.0)
            spots = (*spots, bests(float(z), MEANS_PER_CLIMB)[place])
        found.append(max(spots, key=lambda spot: spot.value))
    return DeepStresses(np.array(depths), np.array([[spot.value for spot in spots] for spots in columns]), tuple(found))


def _depths(field: MapField | PeriodicMapField) -> list[float]:
    """Return the depths of the search [m]."""
    depths, deepest = [SHALLOWEST * max(field.pixel)], DEEPEST * loaded_span(field.loads, field.pixel)
    while depths[-1] < deepest:
        depths.append(DEPTH_STEP * depths[-1])
    return depths


def _on_means(field: MapField | PeriodicMapField, z: float, per_depth: float) -> MapField | PeriodicMapField:
    """Return the map on pixels as large as the depth allows; a periodic one as it is."""
    times = int(z / (per_depth * max(field.pixel)))
    return field.coarsened(times) if isinstance(field, MapField) and times > 1 else field


def _best_at(field: MapField | PeriodicMapField, z: float, measure: Measure) -> StressSpot:
    return _best_of(field, measure(Tensor(*field.at_depth(z)[:6])), z)


def _best_of(field: MapField | PeriodicMapField, stress: Array, z: float) -> StressSpot:
    i, j = np.unravel_index(int(np.argmax(stress)), stress.shape)
    return StressSpot(float(stress[i, j]), (float(i) + 0.5) * field.pixel[0], (float(j) + 0.5) * field.pixel[1], z)


def _climbed(
    field: MapField | PeriodicMapField, start: StressSpot, shallowest: float, side: float, measure: Measure
) -> StressSpot:
    """Return the greatest stress near a place, by the simplex of Nelder and Mead in units of its depth."""
    from scipy.optimize import minimize

    middle = np.array([start.x, start.y, start.z])

    def place(step: Array) -> Array:
        moved = middle + start.z * step
        moved[2] = max(moved[2], shallowest)
        return np.asarray(moved)

    def stress(step: Array) -> float:
        return float(measure(Tensor(*field.at_places(place(step)[None, :])[:6]))[0])

    unit = stress(np.zeros(3))
    corners = np.vstack([np.zeros(3), side * np.eye(3)])
    found = minimize(
        lambda step: -stress(step) / unit,
        np.zeros(3),
        method="Nelder-Mead",
        options={"initial_simplex": corners, "xatol": PLACE_TOLERANCE, "fatol": VALUE_TOLERANCE},
    )
    x, y, z = place(found.x).tolist()
    return StressSpot(float(-found.fun) * unit, x, y, z)
