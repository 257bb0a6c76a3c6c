"""A thick body of one conductor that moves past a source of heat: its temperature."""

from __future__ import annotations

import functools

from winkler.numerics.fields.band_source import BandPeak, BandSource
from winkler.numerics.fields.line_source import LineSource
from winkler.numerics.fields.warmest_place import PeakTemperature
from winkler.numerics.types import Array
from winkler.values.value import value

__all__ = ["ThickBand", "ThickBody"]


@value
class ThickBody:
    """A thick body under a round source.

    Parameters
    ----------
    source : LineSource
    conductivity : float
        [W/(m K)].
    diffusivity : float
        [m^2/s].
    speed : float
        [m/s].
    """

    source: LineSource
    conductivity: float
    diffusivity: float
    speed: float

    @property
    def _wave(self) -> float:
        return self.speed / self.diffusivity

    def surface(self, x: Array, y: Array) -> Array:
        """Return the temperature [K] at places [m]."""
        return self.source.surface(self._wave, x, y) / self.conductivity

    @functools.cached_property
    def peak(self) -> PeakTemperature:
        """The greatest temperature [K], and its place."""
        peak = self.source.peak(self._wave)
        return PeakTemperature(peak.height / self.conductivity, peak.x, peak.y)

    @functools.cached_property
    def mean(self) -> float:
        """Mean temperature over the contact [K]."""
        return self.source.mean(self._wave) / self.conductivity


@value
class ThickBand:
    """A thick body under a band; parameters as of `ThickBody`."""

    source: BandSource
    conductivity: float
    diffusivity: float
    speed: float

    @property
    def _wave(self) -> float:
        return self.speed / self.diffusivity

    def surface(self, x: Array) -> Array:
        """Return the temperature [K] at places [m]."""
        return self.source.surface(self._wave, x) / self.conductivity

    @property
    def peak(self) -> BandPeak:
        """The greatest temperature [K], and its place."""
        peak = self.source.peak(self._wave)
        return BandPeak(peak.height / self.conductivity, peak.x)

    @property
    def mean(self) -> float:
        """Mean temperature over the strip [K]."""
        return self.source.mean(self._wave) / self.conductivity
