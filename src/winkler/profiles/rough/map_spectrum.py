r"""The power spectrum of a height map, which keeps the mean squares of its heights and of its gradients.

A map bears waves on a lattice of wave numbers, each with a power P.  They are gathered in rings of the plane of wave
numbers, and in each ring the density is a power law, so that

.. math:: 2\pi\int C\,q\,\mathrm dq = \sum P , \qquad 2\pi\int C\,q^3\,\mathrm dq = \sum P\,q^2

are the sums over all waves (Parseval), the first one in each ring.  A ring whose power lies close to its border
is narrowed around it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.rough.spectrum import POINTS_PER_DECADE, PowerSpectrum
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput

FEWEST_WAVE_NUMBERS = 4
"""Different wave numbers in a ring, unless the map has fewer."""
LEAST_RING_WIDTH, LARGEST_RING_WIDTH = 0.7, 1.3
"""Where a ring may end, in widths of a ring."""
END_MARGIN = 0.15
"""Power so close to the end of a ring, in widths of a ring, prevents its end there."""
LARGEST_LOG_CHANGE = 5.0
"""A density that changes within a ring by more than exp(LARGEST_LOG_CHANGE) gives way to a narrower ring."""
ROUNDING_RATIO = 1e-26
"""Part of the sums that is rounding: rings with less at either end of the spectrum are left out."""
LEAST_DENSITY_RATIO = 1e-40
"""Density between rings, over the greatest one."""
JUMP_WIDTH = 1e-13
"""Relative distance of two wave numbers between which the density jumps."""
MOST_HALVINGS = 60
LARGEST_SLOPE_SHIFT = 0.5
"""More than this much steeper rings may not become together."""
LARGEST_LATTICE_STEPS, MANY_WAVES = 3.0, 4096
"""In steps of the lattice; the exponent of a ring beyond, with fewer waves than so many, is that of its waves."""


class _MapWaves(NamedTuple):
    """Waves by rising wave number: q [rad/m], how many have it, and their mean square [m^2]."""

    q: Array
    members: Array
    power: Array


def spectrum_of(topography: Topography) -> PowerSpectrum:
    """Return the isotropic spectrum of a map: the mean over all directions, in rings of 1/20 decade.

    For a periodic map the spectrum has the root mean square height and gradient of the map, also for a turned or
    ground surface. Wave numbers beyond pi over the pixel size exist in some directions only; their power is averaged
    over all directions.  A non-periodic map is detrended by a plane, multiplied by Hann's window, and divided by the
    root mean square of the window. Height and gradient then agree with those of the maps in the mean over many maps,
    not for each one. The component at wave number zero is dropped.

    Parameters
    ----------
    topography : Topography

    Returns
    -------
    PowerSpectrum

    Raises
    ------
    InvalidInput
        If heights are missing, or the map is flat.

    Examples
    --------
    >>> x = np.arange(64) / 64
    >>> wave = Topography(np.sin(2.0 * np.pi * 5.0 * x)[:, None] + np.zeros(64), [1.0, 1.0], periodic=True)
    >>> round(spectrum_of(wave).rms_height, 9), round(spectrum_of(wave).rms_slope / (10.0 * np.pi), 9)
    (0.707106781, 0.707106781)
    """
    if topography.missing:
        raise InvalidInput(
            f"spectrum_of: {topography.missing} heights are missing; fill them with topography.filled() before."
        )
    waves = _waves(topography)
    if waves.q.size == 0:
        raise InvalidInput("spectrum_of: the map is flat; give a rough one.")
    cell = float(np.prod(2.0 * np.pi / topography.lengths))
    ends = _ends(waves, cell, math.pi / max(topography.pixel))
    return _spectrum(waves, ends, _borders(waves, ends, cell), cell)


def _waves(topography: Topography) -> _MapWaves:
    """Return the waves of a map that are more than rounding; those of equal wave number as one."""
    heights = (topography if topography.periodic else topography.detrended(1)).heights
    heights = heights - np.mean(heights)
    nx, ny = heights.shape
    if not topography.periodic:
        window = np.hanning(nx + 1)[:-1, None] * np.hanning(ny + 1)[None, :-1]
        heights = heights * window / math.sqrt(float(np.mean(window**2)))
    scale = float(np.max(np.abs(heights)))
    unit = scale if scale > 1e-14 * float(np.max(np.abs(topography.heights))) else math.inf
    power = _folded(_folded(np.abs(np.fft.fft2(heights / unit)) ** 2 / float(nx * ny) ** 2, 0), 1)
    count = np.multiply.outer(*(_folded(np.ones(n), 0) for n in (nx, ny)))
    steps = 2.0 * np.pi / topography.lengths
    q = np.hypot(*np.meshgrid(*(s * np.arange(n) for s, n in zip(steps, power.shape, strict=True)), indexing="ij"))
    order = np.argsort(q, axis=None, kind="stable")[1:]
    q, count, power = (np.ravel(part)[order] for part in (q, count, power))
    new = np.concatenate(([0], np.flatnonzero(np.diff(q) > 1e-9 * q[1:]) + 1))
    count, power = np.add.reduceat(count, new), np.add.reduceat(power, new)
    q = q[new]
    total, steep = float(np.sum(power)), float(np.sum(power * q**2))
    significant = np.flatnonzero((power > ROUNDING_RATIO * total) | (power * q**2 > ROUNDING_RATIO * steep))
    last = int(significant[-1]) + 1 if total > 0.0 else 0
    return _MapWaves(q[:last], count[:last], power[:last] * unit**2)


def _folded(numbers: Array, axis: int) -> Array:
    """Return the sums over waves of both signs along an axis."""
    whole = np.moveaxis(numbers, axis, 0)
    half = (whole.shape[0] - 1) // 2
    folded = whole[: whole.shape[0] // 2 + 1].copy()
    folded[1 : half + 1] += whole[: whole.shape[0] - half - 1 : -1]
    return np.moveaxis(folded, 0, axis)


def _ends(waves: _MapWaves, cell: float, nyquist: float) -> list[int]:
    """Return behind which wave each ring ends: where little power is near, and the lattice fills the plane evenly."""
    ends: list[int] = []
    start, last = 0, waves.q.size
    whole = int(np.searchsorted(waves.q, nyquist * (1.0 - 1e-9)))  # where directions begin to lack
    filled = np.sqrt(cell * (1.0 + np.cumsum(waves.members)) / math.pi)
    summed = np.concatenate(([0.0], np.cumsum(waves.power)))
    while start < last:
        wide = waves.q[start] * 10.0 ** (
            np.array([LEAST_RING_WIDTH, LARGEST_RING_WIDTH, LARGEST_RING_WIDTH + END_MARGIN]) / POINTS_PER_DECADE
        )
        first, final, beyond = np.searchsorted(waves.q, wide, side="right").tolist()
        first, final = max(first, start + FEWEST_WAVE_NUMBERS), max(final, start + FEWEST_WAVE_NUMBERS)
        stop = whole if start < whole else last
        if final >= stop:
            end = stop
        else:
            places = np.arange(first, final + 1)
            low, high = waves.q[places - 1], waves.q[places]
            uneven = np.abs(np.log(np.clip(filled[places - 1], low, high) / filled[places - 1])) * POINTS_PER_DECADE
            reach = 10.0 ** (END_MARGIN / POINTS_PER_DECADE)
            near = summed[np.searchsorted(waves.q, high * reach)] - summed[np.searchsorted(waves.q, low / reach)]
            most = max(float(summed[min(beyond, last)] - summed[start]), np.finfo(float).tiny)
            end = int(places[np.argmin(uneven + near / most)])
        ends.append(end)
        start = end
    return ends


def _borders(waves: _MapWaves, ends: list[int], cell: float) -> Array:
    """Return the squares of the radii of the rings: where the lattice fills the plane, or else between two waves."""
    q, inner = waves.q, np.array(ends[:-1], dtype=int)
    low, high = q[inner - 1] ** 2, q[inner] ** 2
    gap = 0.1 * (high - low)
    filled = cell * (1.0 + np.cumsum(waves.members)[inner - 1]) / math.pi
    first = min(cell, q[0] ** 2) / math.pi  # the cell of the mean, which has no power
    last = (q[-1] + 0.25 * min(q[0], math.sqrt(cell))) ** 2
    return np.concatenate(([first], np.clip(filled, low + gap, high - gap), [last]))


def _spectrum(waves: _MapWaves, ends: list[int], borders: Array, cell: float) -> PowerSpectrum:
    starts = [0, *ends[:-1]]
    power, square = (np.add.reduceat(waves.power * waves.q**n, starts) for n in (0, 2))
    there = power > ROUNDING_RATIO * float(np.sum(power))
    rings, total = _rings(waves, ends, borders, there, LARGEST_LATTICE_STEPS**2 * cell), float(np.sum(square[there]))
    more = _shift(rings, total)
    if abs(more) > LARGEST_SLOPE_SHIFT:  # a line among waves that are faint beside it
        rings = _rings(waves, ends, borders, there, math.inf)
        more = _shift(rings, total)
    places, heights = [], []
    for ring in rings:
        low, high = math.sqrt(ring.inner) * (1.0 + JUMP_WIDTH), math.sqrt(ring.outer) * (1.0 - JUMP_WIDTH)
        shape = PowerSpectrum(np.array([low, high]), np.array([1.0, (high / low) ** (2.0 * ring.steeper(more) - 2.0)]))
        places.append((low, high))
        heights.append(ring.power / shape.rms_height**2 * shape.densities)
    faint = LEAST_DENSITY_RATIO * float(np.max(heights))
    q, density = list(places[0]), list(heights[0])
    for (low, high), (begin, end) in zip(places[1:], heights[1:], strict=True):
        if low > q[-1] * (1.0 + 10.0 * JUMP_WIDTH):  # nothing between two rings
            q += [q[-1] * (1.0 + JUMP_WIDTH), low * (1.0 - JUMP_WIDTH)]
            density += [faint, faint]
        q += [low, high]
        density += [max(begin, faint), max(end, faint)]
    return PowerSpectrum(np.array(q), np.array(density))


def _rings(waves: _MapWaves, ends: list[int], borders: Array, there: Array, least: float) -> list[_SpectrumRing]:
    """Return the rings that are there; beyond the square `least` of wave numbers as steep as their waves."""
    rings = []
    for start, end, inner, outer in zip([0, *ends[:-1]], ends, borders[:-1], borders[1:], strict=True):
        u, power, members = (part[start:end] for part in (waves.q**2, waves.power, waves.members))
        whole = float(np.sum(power))
        has_exponent = inner > least and end - start <= MANY_WAVES
        rings.append(
            _ring(whole, float(np.sum(power * u)), (inner, outer), u, members if has_exponent else np.empty(0))
        )
    return [ring for ring, significant in zip(rings, there, strict=True) if significant]


class _SpectrumRing(NamedTuple):
    """A density u^(steep - 1) between squares u of wave numbers; `free` is 1 where it may become steeper, else 0."""

    power: float
    inner: float
    outer: float
    steep: float
    free: float

    def square(self, more: float) -> float:
        """Return the mean of u = q^2 if it is steeper by so much between its borders."""
        return _mean(self.steeper(more), self.inner, self.outer)

    def steeper(self, more: float) -> float:
        """Return the exponent k with which the density u^(k - 1) changes by exp(more) more than it does."""
        return self.steep + self.free * more / math.log(self.outer / self.inner)


def _ring(power: float, moment: float, borders: tuple[float, float], u: Array, members: Array) -> _SpectrumRing:
    """Return the ring with these sums of P and P u; `members` is empty where the waves do not determine its exponent.

    A ring whose density would be too steep is narrowed instead.
    """
    inner, outer = borders
    square = moment / power if power > 0.0 else outer
    most = LARGEST_LOG_CHANGE / math.log(outer / inner)

    def even(steep: float) -> float:
        return _mean(steep, inner, outer)

    def uneven(steep: float) -> float:
        weight = members * (u / inner) ** (steep - 1.0)
        return float(np.sum(weight * u) / np.sum(weight))

    if not even(-most) < square < even(most):
        half = min(square - inner, outer - square)
        return _SpectrumRing(power, square - half, square + half, 1.0, 0.0)
    determined = members.size > 0 and uneven(-most) < square < uneven(most)
    return _SpectrumRing(power, inner, outer, _rooted(uneven if determined else even, square, most), 1.0)


def _shift(rings: list[_SpectrumRing], square: float) -> float:
    """Return how much steeper rings must be for the sum of P q^2: the lattice does not fill them quite evenly."""

    def mean(more: float) -> float:
        return sum(ring.power * ring.square(more) for ring in rings)

    return _rooted(mean, square, LARGEST_LOG_CHANGE)


def _mean(steep: float, inner: float, outer: float) -> float:
    """Return the mean of u between the borders, weighted by u^(steep - 1)."""
    width = math.log(outer / inner)
    above, below = ((math.expm1(k * width) / k if k != 0.0 else width) for k in (steep + 1.0, steep))
    return inner * above / below


def _rooted(rising: Callable[[float], float], target: float, most: float) -> float:
    """Return where a rising function equals a number, between -most and most."""
    low, high = -most, most
    for _ in range(MOST_HALVINGS):
        half = 0.5 * (low + high)
        low, high = (half, high) if rising(half) < target else (low, half)
    return 0.5 * (low + high)
