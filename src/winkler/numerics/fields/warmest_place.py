"""Where a surface that moves past a round source of heat is warmest."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.values.value import value

FIRST_POINTS = 9
"""Places along the centre line where the greatest temperature is searched for first."""
REFINEMENT_ROUNDS = 3
CUT_PARTS = np.array([1.0, 2.0]) / 3.0
"""Where the stretches on both sides of the warmest place are cut."""
CIRCLE_RADII = (0.3, 0.6, 0.8, 0.95, 1.0)
"""Circles on which a greater one beside the centre line is searched for, in contact radii."""
LEAST_TEMPERATURE_GAIN = 1e-8
"""Part by which a place beside the centre line must be warmer to count."""
Surface = Callable[[Array, Array], Array]
"""Temperature at places x and y of one shape."""


@value
class PeakTemperature:
    """The greatest temperature of a surface, and its place.

    Parameters
    ----------
    height : float
        Temperature [K], or conductivity times temperature [W/m].
    x, y : float
        Coordinates [m]; of two places on both sides of the centre line that with y > 0.
    """

    height: float
    x: float
    y: float

    def turned(self, angle: float) -> PeakTemperature:
        """Return the same of a body that moves at an angle [rad]."""
        if angle == 0.0:
            return self
        return PeakTemperature(self.height, *(float(place) for place in turned(self.x, self.y, angle)))

    def times(self, factor: float) -> PeakTemperature:
        """Return the same of a source that is so many times as strong, or of a body that conducts so much less."""
        return PeakTemperature(factor * self.height, self.x, self.y)


def turned(x: Quantity, y: Quantity, angle: float) -> tuple[Quantity, Quantity]:
    """Return places turned by an angle [rad]; the same numbers where it is zero."""
    if angle == 0.0:
        return x, y
    cosine, sine = math.cos(angle), math.sin(angle)
    return x * cosine - y * sine, x * sine + y * cosine


def warmest_place(surface: Surface, radius: float, fading: bool, rests: bool) -> PeakTemperature:
    """Return the greatest temperature within the contact, and its place.

    First along the centre line, by ever smaller steps about the greatest so far; then beside it, where a source
    that is stronger at its rim may heat more.

    Parameters
    ----------
    surface : Surface
        Temperature at places [m]; the body moves along x.
    radius : float
        a [m].
    fading : bool
        Whether the flux falls from the axis on.
    rests : bool
        Whether the body rests, so that its temperature is the same all around.
    """
    if rests and fading:
        return PeakTemperature(float(surface(np.zeros(1), np.zeros(1))[0]), 0.0, 0.0)
    on_line = _along_centre(surface, radius)
    if rests or fading:
        return on_line
    turn = np.linspace(0.0, np.pi, 9)[1:-1]
    x, y = (np.outer(CIRCLE_RADII, each(turn)).ravel() * radius for each in (np.cos, np.sin))
    beside = surface(x, y)
    best = int(np.argmax(beside))
    if beside[best] > on_line.height * (1.0 + LEAST_TEMPERATURE_GAIN):
        return _beside(surface, radius, PeakTemperature(float(beside[best]), float(x[best]), float(y[best])))
    return on_line


def warmest_within(surface: Surface, axes: tuple[float, float], rests: bool) -> PeakTemperature:
    """Return the greatest temperature within an ellipse, and its place, of a flux that falls from the middle on.

    Parameters
    ----------
    surface : Surface
        Temperature at places [m].
    axes : tuple of float
        Semi-axes along x and y [m].
    rests : bool
        Whether the body rests: the middle is the warmest then, as of every flux and body alike to both sides.
    """

    def stretched(x: Array, y: Array) -> Array:
        return surface(axes[0] * x, axes[1] * y)

    middle = PeakTemperature(float(stretched(np.zeros(1), np.zeros(1))[0]), 0.0, 0.0)
    if rests:
        return middle
    turn = np.linspace(0.0, 2.0 * np.pi, 17)[:-1]
    x, y = (np.outer(CIRCLE_RADII, along(turn)).ravel() for along in (np.cos, np.sin))
    heights = stretched(x, y)
    best = int(np.argmax(heights))
    warm = PeakTemperature(float(heights[best]), float(x[best]), float(y[best]))
    found = _beside(stretched, 1.0, max(middle, warm, key=_height), mirrored=False)
    return PeakTemperature(found.height, axes[0] * found.x, axes[1] * found.y)


def _along_centre(surface: Surface, radius: float) -> PeakTemperature:
    places = -radius * np.cos(np.linspace(0.0, np.pi, FIRST_POINTS))
    heights = surface(places, np.zeros(FIRST_POINTS))
    for _ in range(REFINEMENT_ROUNDS):
        best = int(np.argmax(heights))
        near = places[max(best - 1, 0) : best + 2]
        between = np.concatenate([low + (high - low) * CUT_PARTS for low, high in pairwise(near)])
        neighbours = np.isin(places, near)
        order = np.argsort(np.concatenate([places[neighbours], between]))
        temperatures = np.concatenate([heights[neighbours], surface(between, np.zeros(between.size))])
        places, heights = np.concatenate([places[neighbours], between])[order], temperatures[order]
    best = int(np.argmax(heights))
    where = _summit(places, heights, best)
    height = float(surface(np.array([where]), np.zeros(1))[0])
    return max(
        PeakTemperature(float(heights[best]), float(places[best]), 0.0),
        PeakTemperature(height, where, 0.0),
        key=_height,
    )


def _beside(surface: Surface, radius: float, start: PeakTemperature, mirrored: bool = True) -> PeakTemperature:
    """Return the warmest place near a first one; `mirrored` if both sides of the centre line are alike."""
    x, y, step, best = start.x, start.y, 0.2 * radius, start.height
    corners = np.array([(i, j) for i in (-1.0, 0.0, 1.0) for j in (-1.0, 0.0, 1.0) if i or j])
    while step > LEAST_TEMPERATURE_GAIN**0.5 * radius:
        near_x, near_y = x + step * corners[:, 0], y + step * corners[:, 1]
        near_y = np.abs(near_y) if mirrored else near_y
        off = np.maximum(np.hypot(near_x, near_y) / radius, 1.0)  # what lies outside is put onto the rim
        near_x, near_y = near_x / off, near_y / off
        heights = surface(near_x, near_y)
        which = int(np.argmax(heights))
        if heights[which] > best:
            x, y, best = float(near_x[which]), float(near_y[which]), float(heights[which])
        else:
            step *= 0.5
    return PeakTemperature(best, x, y)


def _height(peak: PeakTemperature) -> float:
    return peak.height


def _summit(places: Array, heights: Array, best: int) -> float:
    """Return where the parabola through the best place and its neighbours has its top."""
    middle = min(max(best, 1), places.size - 2)
    (x0, x1, x2), (y0, y1, y2) = places[middle - 1 : middle + 2], heights[middle - 1 : middle + 2]
    first, second = (y1 - y0) / (x1 - x0), (y2 - y1) / (x2 - x1)
    bend = second - first
    if bend >= 0.0:
        return float(places[best])
    return float(np.clip(0.5 * (x0 + x1 - first * (x2 - x0) / bend), places[0], places[-1]))
