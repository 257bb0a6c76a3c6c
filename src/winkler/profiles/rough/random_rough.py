r"""Rough surfaces and lines made at random from a spectrum: amplitudes from the spectrum, random phases.

A periodic map or line bears waves at a lattice of wave numbers.  Each gets the power of its own cell of the lattice,
the integral of the spectrum over it, and not that of one point: so heights have the root mean square of the spectrum,
also where it is steep and only few waves fit.

A surface that is to bear forces like one of the spectrum C(q) is replaced, in the method, by a line with

.. math:: C_\mathrm{1D}(q) = \pi\,q\,C(q) ,

which has the same root mean square of heights and of gradients.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.profiles.rough.spectrum import Spectrum
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import MADE_PIXELS

LONGEST_WAVES = 8
"""Up to this multiple of the lattice a spectrum may change much within one cell."""
MAP_CELL_POINTS, LINE_CELL_POINTS, OTHER_CELL_POINTS = 24, 192, 3
"""Points on a side of such a cell of maps and of lines, and of all other cells."""
BYTES_PER_PIXEL = 70
"""Of memory for a pixel, while a map is made."""


def random_topography(spectrum: Spectrum, shape: tuple[int, int], lengths: ArrayLike, seed: int) -> Topography:
    """Return a periodic map with this spectrum.

    Parameters
    ----------
    spectrum : Spectrum
        C(q). Waves longer than the map or shorter than two pixels are omitted.
    shape : tuple of int
        (nx, ny), pixels.
    lengths : array_like, (2,)
        Lengths of the map [m].
    seed : int
        Seed of the random phases; equal seeds give equal surfaces.

    Returns
    -------
    Topography

    Raises
    ------
    InvalidInput
        If the spectrum contains no wave that fits into the map, or the map does not fit the memory.
    """
    lx, ly = _checked(shape, lengths, seed)
    try:
        return _made(spectrum, shape, (lx, ly), seed)
    except MemoryError:
        size = shape[0] * shape[1] * BYTES_PER_PIXEL / 1e9
        raise InvalidInput(
            f"random_topography: {shape[0]} x {shape[1]} pixels need {size:.3g} GB of memory, which this machine does "
            "not have; request fewer."
        ) from None


def _made(spectrum: Spectrum, shape: tuple[int, int], lengths: tuple[float, float], seed: int) -> Topography:
    lx, ly = lengths
    # waves come in pairs of one sign: a quarter of the plane is enough; those at Nyquist's wave number have no phase
    quarter = _cells(spectrum, ((shape[0] + 1) // 2, (shape[1] + 1) // 2), (2.0 * np.pi / lx, 2.0 * np.pi / ly))
    i, j = (np.abs(np.rint(np.fft.fftfreq(n, 1.0 / n))).astype(int) for n in shape)
    power = np.pad(quarter, [(0, 1), (0, 1)])[np.ix_(i, j)]
    if not np.any(power > 0.0):
        raise InvalidInput(
            f"random_topography: no wave between {2 * math.pi / spectrum.greatest:.3g} m and "
            f"{2 * math.pi / spectrum.smallest:.3g} m fits a map of {lx:.3g} m with {shape[0]} x {shape[1]} pixels; "
            "make it larger, or give it more pixels."
        )
    noise = np.fft.fft2(np.random.default_rng(seed).standard_normal(shape))
    size = np.abs(noise)
    noise *= np.sqrt(power) / np.where(size > 0.0, size, 1.0)
    heights = np.real(np.fft.ifft2(noise)) * (shape[0] * shape[1])
    return Topography(heights, np.array([lx, ly]), periodic=True)


def _checked(shape: tuple[int, int], lengths: ArrayLike, seed: int) -> tuple[float, float]:
    """Return both lengths, or refuse the numbers."""
    if len(shape) != 2 or any(isinstance(n, bool) or not isinstance(n, int) or n < 4 for n in shape):
        raise InvalidInput(f"random_topography: shape is {shape!r}; give two whole numbers of pixels, at least 4.")
    affordable("random_topography", "pixels", math.prod(shape), MADE_PIXELS)
    try:
        numbers = np.array(lengths, dtype=float)
    except (TypeError, ValueError):
        numbers = np.array([])
    if numbers.shape != (2,) or not (np.all(np.isfinite(numbers)) and np.all(numbers > 0.0)):
        raise InvalidInput(f"random_topography: lengths are {lengths!r}; give two positive lengths in m.")
    if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
        raise InvalidInput(f"random_topography: seed is {seed!r}; give a whole number, zero or positive.")
    return float(numbers[0]), float(numbers[1])


def _cells(spectrum: Spectrum, count: tuple[int, int], step: tuple[float, float]) -> Array:
    """Return the integral of C over the cells (i, j) of a quarter of the plane [m^2]; none of (0, 0)."""

    def summed(first: int, last: int, points: int) -> Array:
        places = (np.arange(points) + 0.5) / points - 0.5
        ranges = [np.arange(first, min(last, n)) for n in count]
        power = np.zeros((ranges[0].size, ranges[1].size))
        for a in places:
            for b in places:
                qx, qy = ((ranges[0] + a) * step[0])[:, None], ((ranges[1] + b) * step[1])[None, :]
                power += spectrum.at(np.hypot(qx, qy))
        return power * (step[0] * step[1] / points**2)

    power = summed(0, max(count), OTHER_CELL_POINTS)
    near = summed(0, LONGEST_WAVES, MAP_CELL_POINTS)
    power[: near.shape[0], : near.shape[1]] = near
    power[0, 0] = 0.0
    return power


def random_line(spectrum: Spectrum, count: int, length: float, seed: int) -> Array:
    """Return heights [m] of the line that bears forces like a surface with this spectrum, C_1D = pi q C.

    Parameters
    ----------
    spectrum : Spectrum
        C(q) of the surface; what is longer than the line, or shorter than two points, is left out.
    count : int
        How many points.
    length : float
        Length of the profiles [m].
    seed : int
        Of the phases.

    Returns
    -------
    ndarray, (count,)

    Raises
    ------
    InvalidInput
        If the spectrum contains no wave that fits into the profile.
    """
    return next(random_lines(spectrum, count, length, (seed,)))


def random_lines(spectrum: Spectrum, count: int, length: float, seeds: Iterable[int]) -> Iterator[Array]:
    """Yield the heights of `random_line` for many seeds.

    Parameters
    ----------
    spectrum, count, length
        As for `random_line`.
    seeds : iterable of int
        Of the phases, one for each line.

    Raises
    ------
    InvalidInput
        If the spectrum contains no wave that fits into the profile.
    """
    step = 2.0 * np.pi / length
    power = np.zeros(count // 2 + 1)
    for first, last, points in ((1, LONGEST_WAVES, LINE_CELL_POINTS), (LONGEST_WAVES, power.size, OTHER_CELL_POINTS)):
        for place in (np.arange(points) + 0.5) / points - 0.5:
            q = (np.arange(first, min(last, power.size)) + place) * step
            power[first:last] += np.pi * q * spectrum.at(q) * (step / points)
    if count % 2 == 0:
        power[-1] = 0.0  # a wave at Nyquist's wave number has no phase
    if not np.any(power > 0.0):
        raise InvalidInput(
            f"random_line: no wave between {2 * math.pi / spectrum.greatest:.3g} m and "
            f"{2 * math.pi / spectrum.smallest:.3g} m fits a line of {length:.3g} m with {count} points; make it "
            "longer, or give it more points."
        )
    amplitude = np.sqrt(power)
    for seed in seeds:
        phase = np.exp(2j * np.pi * np.random.default_rng(seed).random(power.size))
        yield np.asarray(np.fft.irfft(amplitude * phase, count) * count)
