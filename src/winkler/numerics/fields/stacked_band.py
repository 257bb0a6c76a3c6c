"""The temperature of a layered body under a band of heat that it moves past."""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.fields.band_source import BandPeak, BandSource, warmest_of_band
from winkler.numerics.fields.layer_echo import LayerEcho, Stack
from winkler.numerics.types import Array
from winkler.values.value import value

NODES = 81


@value
class StackedBand:
    """A band of heat, endless along y, on a layered body that moves past it along x.

    Parameters
    ----------
    source : BandSource
        The source.
    stack : Stack
        The body.
    speed : float
        V [m/s], not zero; negative if it moves backwards.
    """

    source: BandSource
    stack: Stack
    speed: float

    @property
    def _wave(self) -> float:
        return self.speed / self.stack.diffusivities[0]

    def _echo(self, reach: float) -> LayerEcho:
        return LayerEcho(self.stack, self.source.half_width, np.array([abs(self.speed)]), reach, round=False)

    @functools.cached_property
    def _inner(self) -> LayerEcho:
        return self._echo(2.0)

    def surface(self, x: Array) -> Array:
        """Return the temperature [K] at places x [m]."""
        places = math.copysign(1.0, self.speed) * np.ravel(x) / self.source.half_width
        farthest = float(np.max(np.abs(places), initial=0.0))
        echo = self._inner if farthest <= 1.0 else self._echo(1.0 + farthest)
        added = np.array([self._folded(echo, float(place)) for place in places]).reshape(np.shape(x))
        return np.asarray((self.source.surface(self._wave, x) + added) / self.stack.conductivities[0])

    def _folded(self, echo: LayerEcho, s: float) -> float:
        """Return the integral of the flux times the echo, s half-widths from the middle."""
        angle, share = self._angles([s + sign * mark for mark in echo.marks for sign in (1.0, -1.0)])
        return self._sum(angle, share, echo(s - np.sin(angle)))

    @property
    def peak(self) -> BandPeak:
        """The greatest temperature [K], and its place."""
        best = warmest_of_band(lambda x: self.surface(math.copysign(1.0, self.speed) * x), self.source.half_width)
        return BandPeak(best.height, math.copysign(best.x, self.speed * best.x))

    @property
    def mean(self) -> float:
        """Mean temperature over the strip [K]."""
        echo = self._inner
        behind, ahead = (side.integral for side in echo.sides(0))
        angle, share = self._angles([sign * (1.0 - mark) for mark in echo.marks for sign in (1.0, -1.0)])
        added = 0.5 * self._sum(angle, share, behind(1.0 - np.sin(angle)) + ahead(1.0 + np.sin(angle)))
        return (self.source.mean(self._wave) + added) / self.stack.conductivities[0]

    def _sum(self, angle: Array, share: Array, factor: Array) -> float:
        return float(np.sum(self.source.flux_at(angle) * factor * share))

    def _angles(self, places: list[float]) -> tuple[Array, Array]:
        """Return angles over the strip, in pieces between these places and the joints of the flux, and weights."""
        ends = [math.asin(place) for place in places if abs(place) < 1.0]
        return self.source.pieces(-0.5 * math.pi, math.nan, ends)[:2]
