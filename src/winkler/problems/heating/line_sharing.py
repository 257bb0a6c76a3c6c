"""How two bodies share the heat of a strip, load by load and speed by speed."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.laws.heat import HeatPartition
from winkler.numerics.fields.band_source import FAST, BandSource
from winkler.numerics.types import Array
from winkler.problems.heating.band_flux import EvenBand, HeatedLine, band_sources
from winkler.problems.heating.estimates import first_share, idle_share, shared
from winkler.problems.heating.moved_body import HeatBody, diffusivities, moved_under_band, top
from winkler.problems.line.peak_pressure import rim_load
from winkler.values.errors import OutsideValidity

__all__ = ["fast_strip_temperature", "shared_strip_temperatures"]

SLOWEST = 1e-8
"""V a / kappa below which a band hardly moves."""
Bodies = tuple[HeatBody, HeatBody]


def shared_strip_temperatures(
    owner: str, heated: HeatedLine, bodies: Bodies, partition: HeatPartition, speeds: Sequence[Array]
) -> Array:
    """Return the share of the first body [-], and greatest and mean temperatures of both for 1 W per length [K m/W].

    Parameters
    ----------
    owner : str
        Name of the problem, for messages.
    heated : LineSolution or EvenBand
    bodies : tuple of ThermalConductor or Plated
    partition : EqualMaximum, EqualMean or FixedShare
    speeds : sequence of ndarray
        Those of both bodies [m/s], of one shape to which the loads or half-widths broadcast; zero only for a body that
        takes no heat.

    Returns
    -------
    ndarray, (5, ...)
        Share; greatest of the first, of the second; mean of the first, of the second.
    """
    shape = speeds[0].shape
    sources, which, table = band_sources(heated), _loads_over(heated, shape), np.zeros((5, *shape))
    for place in np.ndindex(shape):
        pair = [float(speed[place]) for speed in speeds]
        table[(slice(None), *place)] = _shares(owner, sources[which[place]], bodies, partition, pair)
    return table


def _shares(
    owner: str, source: BandSource | None, bodies: Bodies, partition: HeatPartition, speeds: Sequence[float]
) -> tuple[float, ...]:
    if source is None:
        return idle_share(partition, bodies), 0.0, 0.0, 0.0, 0.0
    peaks, means = [], []
    for speed, body in zip(speeds, bodies, strict=True):
        wave = speed / min(diffusivities(body))
        if 0.0 < abs(wave) * source.half_width < SLOWEST:
            raise OutsideValidity(
                f"{owner}: a Peclet number V a / (2 kappa) is {0.5 * abs(wave) * source.half_width:.3g}; a "
                "band of heat that hardly moves warms a body up without bound: give a higher speed."
            )
        moved = moved_under_band(source, body, abs(speed))
        peaks.append(moved.peak.height if speed else 0.0)
        means.append(moved.mean if speed else 0.0)
    share = first_share(partition, peaks, means)
    return share, share * peaks[0], (1.0 - share) * peaks[1], share * means[0], (1.0 - share) * means[1]


def fast_strip_temperature(
    heated: HeatedLine, bodies: Bodies, partition: HeatPartition, speeds: Sequence[Array]
) -> Array:
    """Return what the greatest temperature for 1 W per length tends to at high speed [K m/W]; parameters as above.

    Infinite at a rim, and on a body that rests; zero without contact.
    """
    shape = speeds[0].shape
    heights = np.array([_fast(heated, j, source) for j, source in enumerate(band_sources(heated))])
    height = heights[_loads_over(heated, shape)]
    known = (height > 0.0) & np.isfinite(height)
    alone = []
    for speed, body in zip(speeds, bodies, strict=True):
        surface = top(body)  # at high speed a plated body answers as its plating
        root = surface.conductivity * np.sqrt(np.abs(speed) / surface.diffusivity)
        with np.errstate(divide="ignore"):
            alone.append(np.where(known, height, 1.0) / root)
    with np.errstate(divide="ignore"):
        return np.where(known, shared(alone[0], alone[1], partition), height)


def _fast(heated: HeatedLine, which: int, source: BandSource | None) -> float:
    """Return the greatest lambda T of 1 W per length times the root of V / kappa [W/m^(3/2)]; infinite at a rim."""
    if source is None:
        return 0.0
    if not isinstance(heated, EvenBand):
        force, half_width = (float(np.ravel(each)[which]) for each in (heated.force_per_length, heated.half_width))
        if rim_load(heated.problem.bed, force, half_width) > 0.0:
            return math.inf
    return source.peak(FAST).height


def _loads_over(heated: HeatedLine, shape: tuple[int, ...]) -> Array:
    loads = np.shape(heated.half_width)
    return np.broadcast_to(np.arange(math.prod(loads)).reshape(loads), shape)
