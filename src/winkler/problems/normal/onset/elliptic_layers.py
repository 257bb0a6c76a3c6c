"""Onset of yield below an ellipse on layers: pressures of pixels, waves in all directions, and a root in the force."""

from __future__ import annotations

import math
from typing import NamedTuple

from winkler.problems.normal.onset.ellipse_in_layers import EllipseInLayers, refuse_slender, sum_error
from winkler.problems.normal.onset.part_onset import EllipticPartOnset
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.pressed_shape.force_at_yield import force_at_yield
from winkler.profiles.ellipse import CurvedBodies

FIRST_PRESSURE = 1.6
"""Greatest pressure over the strength from which the force is sought: that of a ball."""
OVERTAKEN = 2e-3
"""By how much of the strength the greatest stress of all depths may exceed the one that was followed."""
OWNER = "EllipticYieldOnset"
HERTZ_POWER = 3.0
"""Power of the greatest stress by which the force rises."""


class LayeredOnsets(NamedTuple):
    """The onsets of all parts, and the relative error of their forces that pixels leave."""

    rows: tuple[EllipticPartOnset, ...]
    grid_error: float


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
    search = EllipseInLayers(bodies, medium, traction)
    parts = strong_parts(medium)
    a, b = bodies.semi_axes(medium.modulus, 1.0)  # type: ignore[attr-defined]
    refuse_slender(OWNER, "take LineYieldOnset for its middle", (a, b))
    pressure = FIRST_PRESSURE * min(part.solid.strength for part in parts)
    force, rows, error = (2.0 * math.pi * a * b * pressure / 3.0) ** 3, [], 0.0
    for number, part in enumerate(parts, 1):
        follow = _PartSearch(search, part)
        force = force_at_yield(follow.coarse, force, follow.coarse(force), OWNER)
        overall = search.greatest(force, part, coarse=True)
        if overall.value > (1.0 + OVERTAKEN) * part.solid.strength:  # by another place than the one followed
            follow = _PartSearch(search, part)
            force = force_at_yield(follow.coarse, force, follow.coarse(force), OWNER)
        force = force_at_yield(follow.fine, force, follow.fine(force), OWNER)
        spot, rough = (search.greatest(force, part, near=follow.near, coarse=coarse) for coarse in (False, True))
        error = max(error, HERTZ_POWER * sum_error(rough.value, spot.value))
        rows.append(EllipticPartOnset(number, part.name, force, spot.x, spot.y, spot.z))
    return LayeredOnsets(tuple(rows), error)


class _PartSearch:
    """The greatest stress of one part under one force after the other, each sought near the place of the one before."""

    def __init__(self, search: EllipseInLayers, part: StrongPart) -> None:
        self.search, self.part, self.near = search, part, 0.0

    def coarse(self, force: float) -> float:
        """Return the share on the coarse map."""
        return self._share(force, True)

    def fine(self, force: float) -> float:
        """Return the share on the fine map."""
        return self._share(force, False)

    def _share(self, force: float, coarse: bool) -> float:
        spot = self.search.greatest(force, self.part, near=self.near, coarse=coarse)
        self.near = spot.z if self.part.first else 0.0
        return float(spot.value / self.part.solid.strength)
