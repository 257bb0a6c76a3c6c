"""A thick body of one conductor that moves past a source of heat: its temperature."""

from __future__ import annotations

import functools
from collections.abc import Hashable
from typing import Protocol

from winkler.numerics.fields.band_source import BandPeak, BandSource
from winkler.numerics.fields.warmest_place import PeakTemperature
from winkler.numerics.types import Array
from winkler.values.value import value


class Source(Hashable, Protocol):
    """Where 1 W enters the surface of a body that moves past it at an angle: lambda T of a thick one."""

    def half_length(self, angle: float) -> float:
        """Return how far the source reaches at an angle [rad] from its middle [m]."""

    def surface(self, wave: float, x: Array, y: Array, angle: float = 0.0) -> Array:
        """Return lambda T [W/m] at places [m]; `wave` is V / kappa [1/m]."""

    def peak(self, wave: float, angle: float = 0.0) -> PeakTemperature:
        """Return the greatest lambda T and its place."""

    def mean(self, wave: float, angle: float = 0.0) -> float:
        """Return the mean of lambda T over the contact [W/m]."""

    def fast(self, angle: float = 0.0) -> float:
        """Return what the greatest lambda T times the root of V / kappa tends to in fast motion [W m^-3/2]."""


@value
class ThickBody:
    """A thick body under a source.

    Parameters
    ----------
    source : Source
    conductivity : float
        [W/(m K)].
    diffusivity : float
        [m^2/s].
    speed : float
        [m/s].
    direction : float
        Angle of the velocity to x [rad].
    """

    source: Source
    conductivity: float
    diffusivity: float
    speed: float
    direction: float = 0.0

    @property
    def _wave(self) -> float:
        return self.speed / self.diffusivity

    def surface(self, x: Array, y: Array) -> Array:
        """Return the temperature [K] at places [m]."""
        return self.source.surface(self._wave, x, y, self.direction) / self.conductivity

    @functools.cached_property
    def peak(self) -> PeakTemperature:
        """The greatest temperature [K], and its place."""
        peak = self.source.peak(self._wave, self.direction)
        return PeakTemperature(peak.height / self.conductivity, peak.x, peak.y)

    @functools.cached_property
    def mean(self) -> float:
        """Mean temperature over the contact [K]."""
        return self.source.mean(self._wave, self.direction) / self.conductivity


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
