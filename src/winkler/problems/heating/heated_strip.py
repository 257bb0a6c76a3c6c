"""One of two bodies that rub in a line contact, with the temperature along its surface."""

from __future__ import annotations

import numpy as np

from winkler.checks.place_checks import finite_places
from winkler.materials.conductor import ThermalConductor
from winkler.numerics.fields.band_source import BandPeak
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.heating.band_flux import band_sources
from winkler.problems.line.indentation import LineSolution
from winkler.values import value

__all__ = ["HeatedStrip"]


@value
class HeatedStrip:
    """A body under a steady band of heat that its surface moves past.

    Parameters
    ----------
    conductor : ThermalConductor
        What it is made of.
    speed : float
        Velocity of its surface along x, past the contact [m/s].
    heat_per_length : float
        What flows into it [W/m].
    contact : LineSolution
        Of one load; the flux has the shape of its pressure.
    """

    conductor: ThermalConductor
    speed: float
    heat_per_length: float
    contact: LineSolution

    @property
    def peclet(self) -> float:
        """Pe = V a / (2 kappa) [-]."""
        return 0.5 * abs(self.speed) * float(self.contact.half_width) / self.conductor.diffusivity

    def temperature(self, x: ArrayLike) -> Array:
        """Return the temperature of the surface above that far away [K].

        Parameters
        ----------
        x : array_like
            Places [m]; x points to where a surface of positive speed moves, so that its wake lies at x > 0.

        Raises
        ------
        InvalidInput
            If a place is not finite.
        """
        places = finite_places("HeatedStrip", "x", x)
        (source,) = band_sources(self.contact)
        if source is None or self.heat_per_length == 0.0:
            return np.zeros(places.shape)
        found = source.surface(self.speed / self.conductor.diffusivity, places)
        return np.asarray(found * (self.heat_per_length / self.conductor.conductivity))

    @property
    def warmest(self) -> BandPeak:
        """The greatest temperature: `height` [K] and its place [m]."""
        (source,) = band_sources(self.contact)
        if source is None or self.heat_per_length == 0.0:
            return BandPeak(0.0, 0.0)
        peak = source.peak(self.speed / self.conductor.diffusivity)
        return BandPeak(peak.height * self.heat_per_length / self.conductor.conductivity, peak.x)
