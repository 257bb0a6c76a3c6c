"""One of two bodies under a strip of heat, with the temperature along its surface."""

from __future__ import annotations

import numpy as np

from winkler.numerics.fields.band_source import BandPeak
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.heating.band_flux import HeatedLine, band_sources
from winkler.problems.heating.moved_body import HeatBody, diffusivities, moved_under_band
from winkler.values.checks.place_checks import finite_places
from winkler.values.value import value, words


@value
class HeatedStrip:
    """A body under a steady band of heat that its surface moves past.

    Parameters
    ----------
    conductor : ThermalConductor or Plated
        What it is made of.
    speed : float
        Velocity of its surface along x, past the contact [m/s].
    heat_per_length : float
        What flows into it [W/m].
    heated : LineSolution or EvenBand
        Of one load or half-width: where heat enters.
    """

    __words__ = words(heated=("", None, "where heat enters"))

    conductor: HeatBody
    speed: float
    heat_per_length: float
    heated: HeatedLine

    @property
    def peclet(self) -> float:
        """Pe = V a / (2 kappa) [-]; of a plated body with the least diffusivity."""
        return 0.5 * abs(self.speed) * float(self.heated.half_width) / min(diffusivities(self.conductor))

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
        (source,) = band_sources(self.heated)
        if source is None or self.heat_per_length == 0.0:
            return np.zeros(places.shape)
        return np.asarray(moved_under_band(source, self.conductor, self.speed).surface(places) * self.heat_per_length)

    @property
    def warmest(self) -> BandPeak:
        """The greatest temperature: `height` [K] and its place [m]."""
        (source,) = band_sources(self.heated)
        if source is None or self.heat_per_length == 0.0:
            return BandPeak(0.0, 0.0)
        peak = moved_under_band(source, self.conductor, self.speed).peak
        return BandPeak(peak.height * self.heat_per_length, peak.x)
