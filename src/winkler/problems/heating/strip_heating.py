"""What problems of two bodies that move past a strip of heat have in common, and what their solutions do."""

from __future__ import annotations

import functools
import math
from typing import Any, ClassVar

import numpy as np

from winkler.laws.heat import FixedShare, HeatPartition
from winkler.numerics.fields.band_source import BandSource
from winkler.numerics.types import Array, PerLoad, Q, Quantity, shaped
from winkler.problems.heating.band_flux import HeatedLine, band_sources
from winkler.problems.heating.heated_strip import HeatedStrip
from winkler.problems.heating.input_checks import RubbingPlatedBodies, peclet_numbers
from winkler.problems.heating.moved_body import HeatBody, diffusivities, moved_under_band, top
from winkler.problems.heating.sharing import SharedHeat
from winkler.problems.heating.validity import RUBBED, moving_notes
from winkler.problems.one_load import single
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Note
from winkler.values.value import words

SLOWEST = 1e-8
"""V a / kappa below which a band hardly moves."""


class StripHeating(RubbingPlatedBodies, PerLoad[Q]):
    """A problem of two bodies that move past a strip of heat: what it refuses, and how warm they get."""

    first_speed: Q | float
    second_speed: Q | float
    partition: HeatPartition

    def _check_speeds(self, **given: Quantity) -> None:
        """Refuse speeds that do not broadcast with what else is `given`, and a body at rest that takes heat."""
        sizes = {**given, "first_speed": self.first_speed, "second_speed": self.second_speed}
        shapes, owner = [np.shape(each) for each in sizes.values()], type(self).__name__
        try:
            np.broadcast_shapes(*shapes)
        except ValueError:
            names, found = (", ".join(row[:-1]) + f" and {row[-1]}" for row in (list(sizes), [*map(str, shapes)]))
            raise InvalidInput(
                f"{owner}: {names} have the shapes {found}, which do not broadcast; give arrays of one shape, or "
                "single numbers."
            ) from None
        alone = self.partition.first_share if isinstance(self.partition, FixedShare) else math.nan
        for word, speed, share in (("first", self.first_speed, 0.0), ("second", self.second_speed, 1.0)):
            if alone != share and np.any(np.asarray(speed) == 0.0):
                raise InvalidInput(
                    f"{owner}: {word}_speed is zero, but a body that rests against an endless band of heat has no "
                    f"steady temperature; give a speed, or FixedShare({share}) if no heat flows into it."
                )

    def _shared(self, heated: HeatedLine, speeds: list[Array]) -> SharedHeat:
        return SharedHeat(band_sources(heated), np.shape(heated.half_width), self._bodies, self.partition, speeds)

    @property
    def _speeds(self) -> tuple[Array, Array]:
        return np.asarray(self.first_speed, dtype=float), np.asarray(self.second_speed, dtype=float)

    def _columns(self, heated: HeatedLine, heat_per_length: Array) -> list[Q]:
        """Return heat, share, Peclet numbers, greatest and mean temperatures; the heat is of their common shape."""
        owner, rates = type(self).__name__, [np.broadcast_to(each, heat_per_length.shape) for each in self._speeds]
        peclets = peclet_numbers(owner, [heated.half_width] * 2, rates, self._bodies)
        table = self._shared(heated, rates).temperatures(functools.partial(_warmed, owner))
        return [shaped(each) for each in (heat_per_length, table[0], *peclets, *(table[1:] * heat_per_length))]


def _warmed(owner: str, source: BandSource, body: HeatBody, speed: float, direction: float) -> tuple[float, float]:
    """Return the greatest and the mean temperature of a body under 1 W per length [K m/W]; of one that rests, zero."""
    wave = abs(speed) / min(diffusivities(body))
    if 0.0 < wave * source.half_width < SLOWEST:
        raise OutsideValidity(
            f"{owner}: a Peclet number V a / (2 kappa) is {0.5 * wave * source.half_width:.3g}; a band of heat that "
            "hardly moves warms a body up without bound: give a higher speed."
        )
    moved = moved_under_band(source, body, abs(speed))
    return (moved.peak.height, moved.mean) if speed else (0.0, 0.0)


def _fast(source: BandSource, body: HeatBody, speed: float, direction: float) -> float:
    """Return what the greatest temperature for 1 W per length tends to at high speed [K m/W]; infinite at rest."""
    surface = top(body)  # at high speed a plated body answers as its plating
    root = surface.conductivity * math.sqrt(abs(speed) / surface.diffusivity)
    return source.fast() / root if root > 0.0 else math.inf


class StripTemperatures(PerLoad[Q]):
    """A solution of two bodies that move past a strip of heat."""

    __words__ = words(
        first=("1", None, "the first body with its temperature"),
        second=("2", None, "the second body with its temperature"),
    )

    problem: Any
    heat_per_length: Q
    first_share: Q
    first_peclet: Q
    second_peclet: Q
    first_max_temperature: Q
    second_max_temperature: Q
    first_mean_temperature: Q
    second_mean_temperature: Q

    per_load: ClassVar[str] = "heat_per_length"

    @property
    def _heated(self) -> HeatedLine:
        """Where heat enters."""
        raise NotImplementedError

    @property
    def flash_temperature(self) -> Q:
        """The greatest temperature of the strip, that of the warmer body [K]."""
        return shaped(np.maximum(self.first_max_temperature, self.second_max_temperature))

    @property
    def fast_temperature(self) -> Q:
        """What the flash temperature tends to when both surfaces move fast [K]: Blok's formula under Hertz' pressure,
        Jaeger's under an even flux.

        Infinite at a rim, and for a body at rest that takes heat.
        """
        speeds = [np.broadcast_to(each, np.shape(self.heat_per_length)) for each in self.problem._speeds]
        found = self.problem._shared(self._heated, speeds).estimated(_fast)
        return shaped(np.where(found > 0.0, found * self.heat_per_length, 0.0))

    @property
    def first(self) -> HeatedStrip:
        """The first body with the temperature along its surface; of one load and speed, not of an array."""
        return self._body(0)

    @property
    def second(self) -> HeatedStrip:
        """The second body with the temperature along its surface; of one load and speed, not of an array."""
        return self._body(1)

    def _body(self, which: int) -> HeatedStrip:
        heat = single(self.heat_per_length, "temperature")
        share = (self.first_share, 1.0 - self.first_share)[which]
        speed = self.problem._speeds[which]
        return HeatedStrip(self.problem._bodies[which], float(speed), float(share) * heat, self._heated)

    def _notes(self, flux: str = RUBBED) -> tuple[Note, ...]:
        """Return how far the temperatures can be trusted; the `flux` in words."""
        peclets = (np.asarray(self.first_peclet), np.asarray(self.second_peclet))
        greatest = (np.asarray(self.first_max_temperature), np.asarray(self.second_max_temperature))
        means = (np.asarray(self.first_mean_temperature), np.asarray(self.second_mean_temperature))
        return moving_notes(peclets, greatest, means, self.problem.partition, self.problem._plated, flux)
