"""The greatest stresses of each kind below an ellipse on layers: pressures of pixels, and waves in all directions."""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np

from winkler.loading.loads import Force
from winkler.media.interior.map_peak import greatest_below
from winkler.media.interior.peak import StressSpot
from winkler.media.interior.rectangle import STRESSES
from winkler.media.interior.tensor import Measure, Tensor, von_mises
from winkler.numerics.types import Array
from winkler.problems.normal.elliptic import pressed_ellipse
from winkler.problems.normal.map_yield import field_below
from winkler.problems.normal.strong_parts import StrongPart
from winkler.problems.pressed_shape.pressed_map import PressedMap
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.profiles.ellipse import CurvedBodies
from winkler.values.errors import OutsideValidity

PIXELS_PER_LAYER = 2.0
"""Pixels along the longer semi-axis, in one thickness of the uppermost layer;"""
FEWEST_PIXELS, MOST_PIXELS, PIXEL_STEP = 64, 128, 32
"""along each side of the map of pressures, not less and not more."""
MOST_SLENDER = 6.0
"""Ratio of the semi-axes of Hertz up to which stresses in layers are summed over directions in seconds."""
STRESS_ERROR = 5e-4
"""Of sums over waves, over the greatest stress, measured on equal layers and against the round engine;"""
PIXEL_SAFETY = 2.0
"""what pixels leave, over the change of the stress from half as many."""


def coarse_layers(thickness: float, semi_axis: float) -> bool:
    """Return whether the pixels of the finest map are wider than half an uppermost layer [m] under this ellipse."""
    return PIXELS_PER_LAYER * 2.0 * semi_axis > MOST_PIXELS * thickness


def sum_error(coarse: float, fine: float) -> float:
    """Return the relative error of a greatest stress [Pa], of which the coarser map gave another number."""
    return STRESS_ERROR + PIXEL_SAFETY * abs(coarse / fine - 1.0)


def refuse_slender(owner: str, advice: str, semi_axes: tuple[float, float]) -> None:
    """Refuse an ellipse whose stresses in layers would take too many waves.

    Raises
    ------
    OutsideValidity
        If its semi-axes [m] are.
    """
    slenderness = max(semi_axes) / min(semi_axes)
    if slenderness > MOST_SLENDER:
        raise OutsideValidity(
            f"{owner}: an ellipse {slenderness:.3g} times as long as wide needs too many waves in layers, "
            f"{MOST_SLENDER:.0f} times are allowed; {advice}."
        )


class EllipseInLayers:
    """The greatest stresses of each part under any force.

    Parameters
    ----------
    bodies : CurvedBodies
    medium : CoatedHalfSpace, SlidingFilm or StackedHalfSpace
    traction : tuple of float
        Along x and y over the pressure [-].
    """

    def __init__(self, bodies: CurvedBodies, medium: object, traction: tuple[float, float]) -> None:
        self.bodies, self.medium, self.traction = bodies, medium, traction
        self.kept: dict[float, list[SurfaceLoad]] = {}
        self.inside: dict[bool, Any] = {}
        self.levels: dict[tuple[bool, float], Array] = {}

    def greatest(
        self,
        force: float,
        part: StrongPart,
        measure: Measure = von_mises,
        *,
        near: float = 0.0,
        coarse: bool = False,
    ) -> StressSpot:
        """Return the greatest stress of a kind [Pa] in one part, and its place [m]; z < 0 in the second body.

        Parameters
        ----------
        force : float
            [N].
        part : StrongPart
        measure
            Of which kind; von Mises' unless given.
        near : float, optional
            A depth [m] near which it is sought first.
        coarse : bool, optional
            On the map of half as many pixels along a side.
        """
        load = self._load(force, coarse)
        if part.first:
            below = functools.partial(self._stresses, coarse)
            found = greatest_below(self._below(coarse), [measure], part.top, part.bottom, near=near, at_depth=below)
        else:
            found = greatest_below(load.field(part.solid.poisson), [measure], climbed=True)
        value, x, y, z = found.greatest[0]
        return StressSpot(value, x + load.corner[0], y + load.corner[1], z if part.first else -z)

    def at_depth(self, force: float, z: float, measure: Measure) -> float:
        """Return the greatest stress of a kind [Pa] at a depth z >= 0 [m] in the first body, on the coarse map."""
        self._load(force, True)
        return float(np.max(measure(Tensor(*self._stresses(True, z)))))

    def _load(self, force: float, coarse: bool) -> SurfaceLoad:
        """Return what acts under a force, and keep it with the stresses below it until another is given."""
        if force not in self.kept:
            self.kept = {force: [each.load(self.traction) for each in self._pressed(force)]}
            self.inside, self.levels = {}, {}
        return self.kept[force][0 if coarse else 1]

    def _below(self, coarse: bool) -> Any:
        """Return the layers below the pressures that are kept."""
        if coarse not in self.inside:
            ((rough, fine),) = self.kept.values()
            self.inside[coarse], _ = field_below(rough if coarse else fine, self.medium)  # type: ignore[arg-type]
        return self.inside[coarse]

    def _stresses(self, coarse: bool, z: float) -> Array:
        if (coarse, z) not in self.levels:  # each kind of stress is one number of the same six
            self.levels[coarse, z] = self._below(coarse).at_depth(z, STRESSES)
        return self.levels[coarse, z]

    def _pressed(self, force: float) -> tuple[PressedMap, PressedMap]:
        medium, load = self.medium, Force(force)
        coarse, fine = pressed_ellipse(self.bodies, medium, load, FEWEST_PIXELS)  # type: ignore[arg-type]
        wide = 2.0 * max(float(fine.x[-1]), float(fine.y[-1]))
        wanted = PIXELS_PER_LAYER * wide / medium.layers[0].thickness  # type: ignore[attr-defined]
        pixels = min(PIXEL_STEP * math.ceil(wanted / PIXEL_STEP), MOST_PIXELS)
        if pixels <= FEWEST_PIXELS:
            return coarse, fine
        return pressed_ellipse(self.bodies, medium, load, pixels)  # type: ignore[arg-type]
