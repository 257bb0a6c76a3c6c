"""Onset of yield below an ellipse on layers: pressures of pixels, waves in all directions, and a root in the force."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.loading import Force
from winkler.media.interior.map_field import MapField
from winkler.media.interior.map_peak import greatest_below_map
from winkler.media.layered.map_interior import MapInLayers
from winkler.problems.normal.elliptic import pressed_ellipse
from winkler.problems.normal.onset.part_onset import EllipticPartOnset
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.pressed_shape.force_at_yield import force_at_yield
from winkler.problems.pressed_shape.pressed_map import PressedMap
from winkler.profiles.ellipse import CurvedBodies

__all__ = ["LayeredOnsets", "coarse_layers", "onsets_in_layers"]

PIXELS_PER_LAYER = 2.0
"""Pixels along the longer semi-axis, in one thickness of the uppermost layer;"""
FEWEST_PIXELS, MOST_PIXELS, PIXEL_STEP = 64, 128, 32
"""along each side of the map of pressures, not less and not more."""
MOST_SLENDER = 6.0
"""Ratio of the semi-axes of Hertz up to which stresses in layers are summed over directions in seconds."""
FIRST_PRESSURE = 1.6
"""Greatest pressure over the strength from which the force is sought: that of a ball."""
DEEPEST = 3.0
"""Greatest depth that is searched, over the width over which the load is spread there."""
DEPTHS = 8
NEAR = 1.25
"""Ratio of depths about the one found under another force, within which the greatest stress is sought first."""
DEPTH_TOLERANCE, MOST_DEPTHS = 5e-3, 6
OVERTAKEN = 2e-3
"""By how much of the strength the greatest stress of all depths may exceed the one that was followed."""
STRESS_ERROR = 5e-4
"""Of sums over waves, over the greatest stress, measured on equal layers and against the round engine;"""
PIXEL_SAFETY = 2.0
"""what pixels leave, over the change of the stress from half as many."""
OWNER = "EllipticYieldOnset"
HERTZ_POWER = 3.0
"""Power of the greatest stress by which the force rises."""


class LayeredOnsets(NamedTuple):
    """The onsets of all parts, and the relative error of their forces that pixels leave."""

    rows: tuple[EllipticPartOnset, ...]
    grid_error: float


class _Spot(NamedTuple):
    share: float
    x: float
    y: float
    z: float


def coarse_layers(thickness: float, semi_axis: float) -> bool:
    """Return whether the pixels of the finest map are wider than half an uppermost layer [m] under this ellipse."""
    return PIXELS_PER_LAYER * 2.0 * semi_axis > MOST_PIXELS * thickness


class _StressedParts:
    """The greatest stresses over the strength under any force."""

    def __init__(self, bodies: CurvedBodies, medium: object, traction: tuple[float, float]) -> None:
        self.bodies, self.medium, self.traction = bodies, medium, traction
        self.kept: dict[float, tuple[PressedMap, PressedMap]] = {}
        self.inside: dict[tuple[float, bool], MapInLayers] = {}

    def spot(self, force: float, part: StrongPart, near: float = 0.0, coarse: bool = False) -> _Spot:
        """Return the greatest stress in one part over its strength, and its place."""
        if force not in self.kept:
            self.kept = {force: self._pressed(force)}
            self.inside = {}
        pressed = self.kept[force][0 if coarse else 1]
        if not part.first:
            p = pressed.pressure
            loads = np.stack([p, self.traction[0] * p, self.traction[1] * p])
            found = greatest_below_map(MapField(loads, pressed.pixel, part.solid.poisson))
            middle = [0.5 * size * side for size, side in zip(p.shape, pressed.pixel, strict=True)]
            return _Spot(found.value / part.solid.strength, found.x - middle[0], found.y - middle[1], -found.z)
        if (force, coarse) not in self.inside:
            p = pressed.pressure
            even = 0.25 * (p + p[::-1] + p[:, ::-1] + p[::-1, ::-1])
            self.inside[force, coarse] = MapInLayers(self.medium, even, pressed.pixel)  # type: ignore[arg-type]
        return self._in_layer(self.inside[force, coarse], part, near)

    def _pressed(self, force: float) -> tuple[PressedMap, PressedMap]:
        medium, load = self.medium, Force(force)
        coarse, fine = pressed_ellipse(self.bodies, medium, load, FEWEST_PIXELS)  # type: ignore[arg-type]
        wide = 2.0 * max(float(fine.x[-1]), float(fine.y[-1]))
        wanted = PIXELS_PER_LAYER * wide / medium.layers[0].thickness  # type: ignore[attr-defined]
        pixels = min(PIXEL_STEP * math.ceil(wanted / PIXEL_STEP), MOST_PIXELS)
        if pixels <= FEWEST_PIXELS:
            return coarse, fine
        return pressed_ellipse(self.bodies, medium, load, pixels)  # type: ignore[arg-type]

    def _in_layer(self, inside: MapInLayers, part: StrongPart, near: float) -> _Spot:
        """Return the greatest stress between two depths, near one of them or on all of the span."""
        from scipy.optimize import minimize_scalar

        top = np.nextafter(part.top, math.inf) if part.top > 0.0 else 0.0
        found: dict[float, tuple[float, float, float]] = {}

        def level(z: float) -> float:
            if z not in found:
                found[z] = inside.greatest(z, self.traction)
            return found[z][0]

        wide = math.hypot(min(inside.sides), part.top)
        lower = min(part.bottom, part.top + DEEPEST * wide)
        if near > 0.0:
            depths = np.unique(np.clip([near / NEAR, near, near * NEAR], top, lower))
        else:
            deep = part.top + (lower - part.top) * np.geomspace(0.01, 1.0, DEPTHS)
            depths = np.unique(np.clip(np.concatenate([[top, part.top + 0.5 * (lower - part.top)], deep]), top, lower))
        levels = [level(float(z)) for z in depths]
        best = int(np.argmax(levels))
        inner = 0 < best < depths.size - 1
        if near > 0.0 and not inner and depths[best] not in (top, lower):
            return self._in_layer(inside, part, 0.0)
        ends = depths[max(best - 1, 0)], depths[min(best + 1, depths.size - 1)]
        minimize_scalar(
            lambda z: -level(float(z)), bounds=ends, method="bounded",
            options={"xatol": DEPTH_TOLERANCE * (ends[1] - part.top), "maxiter": MOST_DEPTHS},
        )  # fmt: skip
        z = max(found, key=lambda each: found[each][0])
        value, x, y = found[z]
        return _Spot(value / part.solid.strength, x, y, z)


def onsets_in_layers(bodies: CurvedBodies, medium: object, traction: tuple[float, float]) -> LayeredOnsets:
    """Return the force at which each part of layers and bodies yields, as if the others stayed elastic.

    Parameters
    ----------
    bodies : CurvedBodies
    medium : CoatedHalfSpace, SlidingFilm or StackedHalfSpace
        Of which a part has a strength.
    traction : tuple of float
        Along x and y over the pressure [-].

    Raises
    ------
    OutsideValidity, NotConverged
        If pressures, stresses or a force are not found.
    """
    search = _StressedParts(bodies, medium, traction)
    parts = strong_parts(medium)
    a, b = bodies.semi_axes(medium.modulus, 1.0)  # type: ignore[attr-defined]
    if max(a, b) > MOST_SLENDER * min(a, b):
        raise OutsideValidity(
            f"EllipticYieldOnset: an ellipse {max(a, b) / min(a, b):.3g} times as long as wide needs too many "
            f"waves in layers, {MOST_SLENDER:.0f} times are allowed; take LineYieldOnset for its middle."
        )
    pressure = FIRST_PRESSURE * min(part.solid.strength for part in parts)
    force, rows, error = (2.0 * math.pi * a * b * pressure / 3.0) ** 3, [], 0.0
    for number, part in enumerate(parts, 1):
        follow = _Follow(search, part)
        force = force_at_yield(follow.coarse, force, follow.coarse(force), OWNER)
        if search.spot(force, part, coarse=True).share > 1.0 + OVERTAKEN:  # by another place than the one followed
            follow = _Follow(search, part)
            force = force_at_yield(follow.coarse, force, follow.coarse(force), OWNER)
        force = force_at_yield(follow.fine, force, follow.fine(force), OWNER)
        spot, rough = search.spot(force, part, follow.near), search.spot(force, part, follow.near, coarse=True)
        change = abs(rough.share / spot.share - 1.0)
        error = max(error, HERTZ_POWER * (STRESS_ERROR + PIXEL_SAFETY * change))
        rows.append(EllipticPartOnset(number, part.name, force, spot.x, spot.y, spot.z))
    return LayeredOnsets(tuple(rows), error)


class _Follow:
    """The greatest stress of one part under one force after the other, each sought near the place of the one before."""

    def __init__(self, search: _StressedParts, part: StrongPart) -> None:
        self.search, self.part, self.near = search, part, 0.0

    def coarse(self, force: float) -> float:
        """Return the share on the coarse map."""
        return self._share(force, True)

    def fine(self, force: float) -> float:
        """Return the share on the fine map."""
        return self._share(force, False)

    def _share(self, force: float, coarse: bool) -> float:
        spot = self.search.spot(force, self.part, self.near, coarse)
        self.near = spot.z if self.part.first else 0.0
        return spot.share
