"""One of two bodies that rub in an elliptic contact, with the temperature of its surface."""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.materials.conductor import ThermalConductor
from winkler.numerics.fields.elliptic_source import EllipticSource, PeakPlace
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.heating.pressed_source import PressedSource
from winkler.values.checks.number_checks import Number
from winkler.values.checks.place_checks import common_places
from winkler.values.value import value, words

__all__ = ["HeatedEllipse", "Turn", "half_length", "sliding_line"]

Turn: TypeAlias = Annotated[float, Number("give an angle of at most one turn{unit}", -2.0 * math.pi, 2.0 * math.pi)]


@value
class HeatedEllipse:
    """A body under a steady elliptic source of heat that its surface moves past.

    Parameters
    ----------
    conductor : ThermalConductor
        What it is made of.
    speed : float
        Velocity of its surface past the contact [m/s].
    direction : float
        Angle of the velocity to x [rad].
    heat_rate : float
        What flows into it [W].
    longitudinal_semi_axis, lateral_semi_axis : float
        a along x and b along y [m]; zero without contact.
    source : EllipticSource or PressedSource
        Where 1 W would enter, as Hertz' pressure or that of pixels; none without contact.
    """

    __words__ = words(
        source=("", None, "where the heat enters: as Hertz' pressure, or as that of pixels"),
        direction=(r"\psi", "rad", "angle of the velocity to x"),
        half_length=("l", "m", "half the length of the contact along the motion"),
        longitudinal_semi_axis=("a", "m", "semi-axis of the contact along x"),
        lateral_semi_axis=("b", "m", "semi-axis of the contact along y"),
    )

    conductor: ThermalConductor
    speed: float
    direction: float
    heat_rate: float
    longitudinal_semi_axis: float
    lateral_semi_axis: float
    source: EllipticSource | PressedSource | None

    @property
    def half_length(self) -> float:
        """Half the length of the contact along the motion [m], through its middle."""
        a, b = self.longitudinal_semi_axis, self.lateral_semi_axis
        return float(half_length(a, b, self.direction)) if a > 0.0 else 0.0

    @property
    def peclet(self) -> float:
        """Pe = V l / (2 kappa) with the half length l [-]."""
        return 0.5 * abs(self.speed) * self.half_length / self.conductor.diffusivity

    def temperature(self, x: ArrayLike, y: ArrayLike = 0.0) -> Array:
        """Return the temperature of the surface above that far away [K].

        Parameters
        ----------
        x, y : array_like
            Places [m], broadcast against each other; the wake lies where the velocity points.

        Raises
        ------
        InvalidInput
            If a place is not finite, or the shapes do not broadcast.
        OutsideValidity
            On layers and gradings, if a place is four times as far away as the contact reaches.
        """
        along, across = common_places("HeatedEllipse", x=x, y=y)
        if self.source is None or self.heat_rate == 0.0:
            return np.zeros(along.shape)
        found = self.source.surface(self.speed / self.conductor.diffusivity, self.direction, along, across)
        return np.asarray(found * (self.heat_rate / self.conductor.conductivity))

    @property
    def warmest(self) -> PeakPlace:
        """The greatest temperature: `height` [K] and its place [m]."""
        if self.source is None or self.heat_rate == 0.0:
            return PeakPlace(0.0, 0.0, 0.0)
        peak = self.source.peak(self.speed / self.conductor.diffusivity, self.direction)
        return PeakPlace(peak.height * self.heat_rate / self.conductor.conductivity, peak.x, peak.y)


def half_length(along: Array | float, across: Array | float, direction: float) -> Array:
    """Return half the length of an ellipse through its middle [m], in a direction [rad] from its first semi-axis."""
    return np.asarray(along * across / np.hypot(across * math.cos(direction), along * math.sin(direction)))


def sliding_line(speeds: tuple[Array | float, Array | float], directions: tuple[float, float]) -> float | None:
    """Return the angle to x [rad] of the line along which bodies slide, none if it is not the same for all speeds."""
    first, second = np.broadcast_arrays(*(np.asarray(speed, dtype=float) for speed in speeds))
    along, across = (first * turn(directions[0]) - second * turn(directions[1]) for turn in (math.cos, math.sin))
    sliding = np.hypot(along, across)
    moves = sliding > 1e-12 * np.maximum(np.abs(first), np.abs(second))
    angles = 2.0 * np.arctan2(across[moves], along[moves])
    if angles.size == 0 or np.any(np.cos(angles - angles.flat[0]) < 1.0 - 1e-12):
        return None
    return 0.5 * float(angles.flat[0])
