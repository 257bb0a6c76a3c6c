"""One of two bodies that rub, with the temperature of its surface."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.numerics.fields.stacked_source import StackedSource
from winkler.numerics.fields.thick_body import ThickBody
from winkler.numerics.fields.warmest_place import PeakTemperature
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.heating.heat_source import heat_source
from winkler.problems.heating.moved_body import HeatBody, diffusivities, moved_body
from winkler.values.value import value

__all__ = ["HeatedBody"]


@value
class HeatedBody:
    """A body under a steady source of heat that its surface moves past.

    Parameters
    ----------
    conductor : ThermalConductor or Plated
        What it is made of.
    speed : float
        Velocity of its surface along x, past the contact [m/s].
    heat_rate : float
        What flows into it [W].
    pressed : PressedSprings
        The springs; the flux has the shape of their pressure.
    """

    conductor: HeatBody
    speed: float
    heat_rate: float
    pressed: PressedSprings

    @property
    def peclet(self) -> float:
        """Pe = V a / (2 kappa) [-]; of a plated body with the least diffusivity."""
        return 0.5 * abs(self.speed) * self.pressed.radius / min(diffusivities(self.conductor))

    @property
    def _moved(self) -> ThickBody | StackedSource:
        return moved_body(heat_source(self.pressed).source, self.conductor, self.speed)

    def temperature(self, x: ArrayLike, y: ArrayLike = 0.0) -> Array:
        """Return the temperature of the surface above that far away.

        Parameters
        ----------
        x, y : array_like
            Places [m], broadcast against each other; x points to where the surface moves, so that the wake lies at
            x > 0 of a body with positive speed.

        Returns
        -------
        ndarray
            [K].
        """
        along, across = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(y, dtype=float))
        if self.pressed.radius == 0.0 or self.heat_rate == 0.0:
            return np.zeros(along.shape)
        return self._moved.surface(along, across) * self.heat_rate

    @property
    def warmest(self) -> PeakTemperature:
        """The greatest temperature within the contact: `height` [K] and its place [m]."""
        if self.pressed.radius == 0.0 or self.heat_rate == 0.0:
            return PeakTemperature(0.0, 0.0, 0.0)
        peak = self._moved.peak
        return PeakTemperature(peak.height * self.heat_rate, peak.x, peak.y)
