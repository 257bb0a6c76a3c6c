"""The greatest stresses of some kinds below a map of loads, and their places.

Depths are searched from half a pixel down, each in the middles of pixels on means that are small against it; a parabola
leads from pixel to pixel.  Of a map that stands alone on a half-space the greatest is climbed to from the best places.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.media.interior.peak import StressSpot
from winkler.media.interior.rectangle import STRESSES
from winkler.media.interior.tensor import Measure, Tensor, von_mises
from winkler.numerics.equations.highest import FEW_PLACES, highest_near
from winkler.numerics.types import Array

SHALLOWEST = 0.5
"""Smallest depth below the surface that is searched, in pixels; nearer to it the steps between pixels show."""
BETWEEN = 2.0
"""Depth, in pixels, from which on a parabola leads from pixel to pixel; above it errs upwards by up to 1.6 %."""
DEPTH_STEP = 1.4
"""Ratio of neighbouring depths of the search."""
DEEPEST = 0.6
"""Greatest depth of the search over the longer side of the loaded part."""
NEAR = 0.7
"""Part of a step by which the search about a given depth begins."""
MEANS_PER_DEPTH = 2.0
"""Depth over the side of the means that stand for the pixels in the search."""
MEANS_PER_CLIMB = 6.0
"""The same of the first climb; the last one is on the pixels themselves."""
MOST_CLIMBS = 2
"""Best places of the search from which the greatest is climbed to."""
NEAR_BEST = 0.97
"""Stress over the greatest of the search above which a place is climbed from."""
FIRST_STEP, LAST_STEP = 0.3, 0.02
"""Half-widths of the boxes with which climbs begin, over the depth."""
ROUNDS = 3
"""Boxes about a depth or a place."""


class DeepStresses(NamedTuple):
    """Stresses of several kinds below a map.

    Parameters
    ----------
    depths : ndarray, (n,)
        From the upper face on [m].
    values : ndarray, (kinds, n)
        The greatest of each kind at each depth, in the middles of pixels [Pa].
    greatest
        The greatest of each kind, and its place.
    """

    depths: Array
    values: Array
    greatest: tuple[StressSpot, ...]


def greatest_below(
    field: Any,
    measures: Sequence[Measure] = (von_mises,),
    top: float = 0.0,
    bottom: float = math.inf,
    *,
    near: float = 0.0,
    at_depth: Callable[[float], Array] | None = None,
    climbed: bool = False,
    rounds: int = ROUNDS,
) -> DeepStresses:
    """Return the greatest stresses of several kinds between two depths.

    Parameters
    ----------
    field : MapField, PeriodicMapField or MapInLayers
        With some load.
    measures : optional
        Of which kinds; von Mises' unless given.
    top, bottom : float, optional
        Faces of a layer [m]; infinite of a base.
    near : float, optional
        A depth [m] near which they are sought first.
    at_depth : callable, optional
        Stresses in the middles of all pixels at one depth, instead of those of means.
    climbed : bool, optional
        Whether they are sought between the pixels, of a `MapField`.
    rounds : int, optional
        Boxes about the best depth: two of them are one parabola through the depths of the search.
    """
    means, seen = {1: field}, dict[tuple[float, float], list[tuple[float, StressSpot]]]()

    def spots(z: float, per_depth: float = MEANS_PER_CLIMB) -> list[tuple[float, StressSpot]]:
        """Return the greatest of each kind at a depth in the middles of pixels, and between them with its place."""
        times = 1 if at_depth else max(1, int(z / (per_depth * max(field.pixel))))
        if times not in means:
            means[times] = field.coarsened(times)
        part = means[times]
        if (z, part.pixel[0]) not in seen:
            stress = Tensor(*(at_depth(z) if at_depth else part.at_depth(z, STRESSES)))
            seen[z, part.pixel[0]] = [_best_of(measure(stress), part.pixel, z) for measure in measures]
        return seen[z, part.pixel[0]]

    face, least = float(np.nextafter(top, math.inf)) if top > 0.0 else 0.0, SHALLOWEST * max(field.pixel)
    lower = min(bottom, top + DEEPEST * math.hypot(_loaded_span(field), top))
    step = min(max(least, 0.5 * (DEPTH_STEP - 1.0) * top), 0.5 * (lower - top))
    count = math.ceil(math.log((lower - top) / step, DEPTH_STEP))

    first = -1.0 if top > 0.0 else 0.0

    def depth(line: float) -> float:
        return face if line == -1.0 else min(top + step * (DEPTH_STEP**line if line > 0.0 else 1.0 + line), lower)

    def refined(kind: int, line: float) -> StressSpot:
        last: list[StressSpot] = []

        def level(rows: Array) -> Array:
            per_depth = MEANS_PER_DEPTH if rows.size > 1 and rounds < ROUNDS else MEANS_PER_CLIMB
            last[:] = [spots(depth(row), per_depth)[kind][1] for row in rows.tolist()]
            return np.array([spot.value for spot in last])

        side = np.array([NEAR if near else 1.0])
        highest_near(level, np.array([line]), side, [(first, count)], rounds=rounds, places=FEW_PLACES)
        return max(*last, spots(depth(line))[kind][1], key=lambda spot: spot.value)

    lines = np.arange(first, count + 1.0).tolist()
    if near > 0.0:
        lines = [min(max(math.log(max(near - top, step) / step, DEPTH_STEP), first), float(count))]
    depths = [face, *map(depth, lines)]
    columns = list(zip(*(spots(z, MEANS_PER_CLIMB if z == face else MEANS_PER_DEPTH) for z in depths), strict=True))
    greatest = []
    for kind, measure in enumerate(measures):
        on_face, *below = (spot for _, spot in columns[kind])
        found = [on_face]
        starts = _starts(lines, below, NEAR_BEST * on_face.value)
        if climbed:
            found += [_climbed(field, start, least, measure) for _, start in starts]
        else:
            found += [refined(kind, line) for line, _ in starts[:1]]
        greatest.append(max(found, key=lambda spot: spot.value))
    return DeepStresses(np.array(depths), np.array([[value for value, _ in each] for each in columns]), tuple(greatest))


def _starts(lines: Sequence[float], spots: Sequence[StressSpot], above: float) -> list[tuple[float, StressSpot]]:
    """Return the best depths, at places that stand apart, from which the greatest is sought."""
    starts: list[tuple[float, StressSpot]] = []
    best = max(spot.value for spot in spots)
    for line, spot in sorted(zip(lines, spots, strict=True), key=lambda each: -each[1].value):
        apart = all(math.hypot(spot.x - other.x, spot.y - other.y) > spot.z for _, other in starts)
        if len(starts) < MOST_CLIMBS and spot.value >= max(NEAR_BEST * best, above) and apart:
            starts.append((line, spot))
    return starts


def _loaded_span(field: Any) -> float:
    """Return the longer side of the loaded part of a map."""
    loaded = np.any(field.loads != 0.0, axis=0)
    sides = [np.flatnonzero(loaded.any(axis=axis)) for axis in (1, 0)]
    return max(float((part[-1] - part[0] + 1) * size) for part, size in zip(sides, field.pixel, strict=True))


def _best_of(stress: Array, pixel: tuple[float, float], z: float) -> tuple[float, StressSpot]:
    """Return the greatest value in the middle of a pixel, and that of parabolas through it with its place."""
    i, j = (int(part) for part in np.unravel_index(int(np.argmax(stress)), stress.shape))
    value, moved, beside = float(stress[i, j]), [0.0, 0.0], np.arange(-1, 2)
    if z >= BETWEEN * max(pixel):
        for axis, row in enumerate(
            (stress[:, j].take(i + beside, mode="wrap"), stress[i].take(j + beside, mode="wrap"))
        ):
            bent = row[0] - 2.0 * row[1] + row[2]
            if bent < 0.0:
                moved[axis] = float(0.5 * (row[0] - row[2]) / bent)
                value -= float((row[0] - row[2]) ** 2 / (8.0 * bent))
    x, y = ((at + 0.5 + by) * side for at, by, side in zip((i, j), moved, pixel, strict=True))
    return float(stress[i, j]), StressSpot(value, x, y, z)


def _climbed(field: Any, start: StressSpot, shallowest: float, measure: Measure) -> StressSpot:
    """Return the greatest stress near a place: on means, then from there on the pixels themselves."""
    for times, step in ((max(1, int(start.z / (MEANS_PER_CLIMB * max(field.pixel)))), FIRST_STEP), (1, LAST_STEP)):
        part = field.coarsened(times) if times > 1 else field

        def stress(*places: Array, part: Any = part) -> Array:
            return measure(Tensor(*part.at_places(np.stack(places, axis=1))[:STRESSES]))

        ends = [(-math.inf, math.inf), (-math.inf, math.inf), (shallowest, math.inf)]
        top = highest_near(
            stress, np.array(start[1:]), np.full(3, step * start.z), ends, rounds=ROUNDS, places=FEW_PLACES
        )
        start = StressSpot(top.value, *top.place)
    return start
