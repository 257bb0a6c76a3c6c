"""One of two bodies that rub, with the temperature of its surface."""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.numerics.fields.warmest_place import PeakTemperature
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.heating.heat_source import PointSource
from winkler.problems.heating.moved_body import HeatBody, diffusivities, moved_body
from winkler.values.checks.number_checks import Number
from winkler.values.checks.place_checks import common_places
from winkler.values.value import value, words

Turn: TypeAlias = Annotated[float, Number("give an angle of at most one turn{unit}", -2.0 * math.pi, 2.0 * math.pi)]


@value
class HeatedBody:
    """A body under a steady source of heat that its surface moves past.

    Parameters
    ----------
    conductor : ThermalConductor or Plated
        What it is made of.
    speed : float
        Velocity of its surface past the contact [m/s].
    direction : float
        Angle of the velocity to x [rad].
    heat_rate : float
        What flows into it [W].
    source : LineSource, EllipticSource or PressedSource
        Where 1 W would enter; none without contact.
    """

    __words__ = words(
        source=("", None, "where the heat enters: in the shape of the pressure"),
        direction=(r"\psi", "rad", "angle of the velocity to x"),
        half_length=("l", "m", "half the length of the contact along the motion"),
    )

    conductor: HeatBody
    speed: float
    direction: float
    heat_rate: float
    source: PointSource | None

    @property
    def half_length(self) -> float:
        """Half the length of the contact along the motion [m], through its middle."""
        return self.source.half_length(self.direction) if self.source is not None else 0.0

    @property
    def peclet(self) -> float:
        """Pe = V l / (2 kappa) with the half length l [-]; of a plated body with the least diffusivity."""
        return 0.5 * abs(self.speed) * self.half_length / min(diffusivities(self.conductor))

    def temperature(self, x: ArrayLike, y: ArrayLike = 0.0) -> Array:
        """Return the temperature of the surface above that far away.

        Parameters
        ----------
        x, y : array_like
            Places [m], broadcast against each other; the wake lies where the velocity points.

        Returns
        -------
        ndarray
            [K].

        Raises
        ------
        InvalidInput
            If a place is not finite, or the shapes do not broadcast.
        OutsideValidity
            Of ellipses on layers and gradings, if a place is four times as far away as the contact reaches.
        """
        along, across = common_places("HeatedBody", x=x, y=y)
        if self.source is None or self.heat_rate == 0.0:
            return np.zeros(along.shape)
        moved = moved_body(self.source, self.conductor, self.speed, self.direction)
        return np.asarray(moved.surface(along, across) * self.heat_rate)

    @property
    def warmest(self) -> PeakTemperature:
        """The greatest temperature within the contact: `height` [K] and its place [m]."""
        if self.source is None or self.heat_rate == 0.0:
            return PeakTemperature(0.0, 0.0, 0.0)
        return moved_body(self.source, self.conductor, self.speed, self.direction).peak.times(self.heat_rate)


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
