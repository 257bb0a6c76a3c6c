r"""The surface of a half-space on a grid: displacements under pressures that are constant in every pixel.

Where E* is one, pressures p sink the surface by

.. math:: u(x, y) = \frac{1}{\pi}\int\frac{p(x', y')}{\sqrt{(x-x')^2+(y-y')^2}}\,\mathrm dA' ,

a convolution, made by fast Fourier transforms: of a free surface on a grid of twice the size, with Love's exact
displacement at the centres of the pixels; of a periodic one by 2 / \|q\|, which leaves its mean at rest.  Layers add
the integral of their kernel over the pixel (`winkler.numerics.pixels.layered`), or multiply waves by 1 + M.
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.arrays import cast, dot, namespace_of, real_waves, waves_back
from winkler.numerics.pixels.integrals import from_corners, love, transformed
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.row_blocks import RowBlocks
from winkler.numerics.threads import cores
from winkler.numerics.types import Array

PERIODIC_COPIES, FREE_COPIES = 18, 26
"""Arrays of double digits of the size of the map that are alive at once, transforms included: of a map and its result
16 and 25 at most, layered or not."""
MEAN_WAVE_RATIO = 0.5
"""What the preconditioner uses as the wave number of the mean, over the smallest other one."""
STIFF_FILM_POWER = 0.7
"""Of 1 + M in the preconditioner where it is more than one: stiff films bend beyond the contact."""
LARGEST_CACHED_PIXELS = 2**20
"""Pixels up to which grids are kept for the next contact; larger ones would hold too much memory."""
SINGLE_THREAD_PIXELS = 2**14
"""Pixels below which a second thread costs more than it brings."""
DOUBLE = np.dtype(np.float64)
SINGLE = np.dtype(np.float32)


def bytes_needed(shape: tuple[int, int], periodic: bool) -> int:
    """Return the memory [byte] that a contact on a grid of this shape takes at most while it is solved."""
    return 8 * shape[0] * shape[1] * (PERIODIC_COPIES if periodic else FREE_COPIES)


class SurfaceGrid(NamedTuple):
    """A grid, and its response to pressures.

    Parameters
    ----------
    shape
        (nx, ny), pixels.
    pixel
        (dx, dy) [m].
    padded
        Size of the transform: that of the grid if it is periodic.
    response
        Transform of the displacement under a unit pressure on one pixel [m].
    wave_numbers
        |q| / 2 [1/m] of the grid itself, over 1 + M or less: about the inverse of `response`.
    workers
        Threads.
    """

    shape: tuple[int, int]
    pixel: tuple[float, float]
    padded: tuple[int, int]
    response: Array
    wave_numbers: Array
    workers: int

    @classmethod
    def of(
        cls,
        shape: tuple[int, int],
        pixel: tuple[float, float],
        *,
        periodic: bool,
        digits: np.dtype[np.floating] = DOUBLE,
        layers: SurfaceBelow | None = None,
    ) -> SurfaceGrid:
        """Return the grid; small ones are made once.

        Parameters
        ----------
        shape
            (nx, ny), pixels.
        pixel
            (dx, dy), the size of one of them [m].
        periodic
            Whether the surface goes on without end, repeated, or bears nothing outside.
        digits
            Of all transforms: single ones are three times as fast, and good enough for small changes.
        layers
            What differs from a homogeneous half-space, in the unit of length of the pixels; nothing unless given.

        Raises
        ------
        NotConverged
            If the contrasts of the layers are too large.
        OutsideValidity
            If the pixels are too coarse for the layers.
        """
        made = _cached_grid if shape[0] * shape[1] <= LARGEST_CACHED_PIXELS else _made
        return made(shape, pixel, periodic, digits, layers)

    def in_digits(self, digits: np.dtype[np.floating]) -> SurfaceGrid:
        """Return the grid with its transforms in these digits."""
        response, wave_numbers = (cast(each, digits) for each in (self.response, self.wave_numbers))
        return self._replace(response=response, wave_numbers=wave_numbers)

    def beside(self, numbers: Any) -> SurfaceGrid:
        """Return the grid with its transforms where these numbers are: in numpy, or on a card."""
        if isinstance(numbers, np.ndarray):
            return self
        xp = namespace_of(numbers)
        moved = (xp.asarray(each, device=numbers.device) for each in (self.response, self.wave_numbers))
        return self._replace(**dict(zip(("response", "wave_numbers"), moved, strict=True)))

    def filmed(self, compliance: float) -> SurfaceGrid:
        """Return the grid under a film that yields where it is pressed, and nowhere else.

        Parameters
        ----------
        compliance
            Displacement under a pressure of E*, in the unit of length of the pixels; none if zero.
        """
        if compliance == 0.0:
            return self
        digits = self.response.dtype.type
        return self._replace(
            response=self.response + digits(compliance),
            wave_numbers=self.wave_numbers / (digits(1.0) + digits(compliance) * self.wave_numbers),
        )

    def waves(self, numbers: Any) -> Any:
        """Return the transform of numbers on the grid, (..., nx, ny), padded with zeros if it is not periodic."""
        return real_waves(numbers, self.padded, self.workers)

    def numbers(self, waves: Any) -> Any:
        """Return the numbers on the grid that have this transform, which is overwritten."""
        return waves_back(waves, self.padded, self.shape, self.workers)

    def displaced(self, pressure: Any) -> Any:
        """Return u [m] under p, over E*."""
        both = self.waves(pressure)
        both *= self.response
        return self.numbers(both)

    def displacing(self, pressure: Any) -> tuple[Any, float]:
        """Return the waves of u under p, over E*, and the sum of p u: that of the waves, half of which are stored."""
        waves = self.waves(pressure)
        once = (self.padded[1] + 1) // 2  # the first wave along y, and the last of an even number, stand for themselves

        def worked(part: Any) -> tuple[float]:
            before, after = waves[part], waves[part] * self.response[part]
            twice = 2.0 * dot(before, after) - dot(before[:, ::once], after[:, ::once])
            waves[part] = after
            return (twice,)

        (work,) = RowBlocks(waves, self.workers).total(worked)
        return waves, work / math.prod(self.padded)

    def roughly_pressing(self, displacement: Any) -> Any:
        """Return pressures, over E*, that would displace a periodic surface so: the preconditioner."""
        waves = real_waves(displacement, self.shape, self.workers)
        waves *= self.wave_numbers
        return waves_back(waves, self.shape, self.shape, self.workers)


def _made(
    shape: tuple[int, int],
    pixel: tuple[float, float],
    periodic: bool,
    digits: np.dtype[np.floating],
    layers: SurfaceBelow | None,
) -> SurfaceGrid:
    """Return a grid."""
    import scipy.fft

    nx, ny = shape
    workers = cores() if nx * ny > SINGLE_THREAD_PIXELS else 1
    qx = 2.0 * np.pi * scipy.fft.fftfreq(nx, pixel[0])[:, None]
    qy = 2.0 * np.pi * scipy.fft.rfftfreq(ny, pixel[1])[None, :]
    wave = np.hypot(qx, qy)
    wave[0, 0] = MEAN_WAVE_RATIO * 2.0 * np.pi / max(nx * pixel[0], ny * pixel[1])
    whole = layers.whole(wave) if layers else np.ones((1, 1))
    if periodic:
        response = 2.0 * (whole / wave)
        response[0, 0] = layers.mean if layers else 0.0
        padded = shape
    else:
        padded = scipy.fft.next_fast_len(2 * nx - 1, True), scipy.fft.next_fast_len(2 * ny - 1, True)
        quarter = from_corners(love, shape, pixel) / np.pi
        quarter = quarter + layers.pixels(shape, pixel) if layers else quarter
        response = transformed(quarter, padded, workers=workers)
    pressing = 0.5 * wave / np.where(whole > 1.0, whole**STIFF_FILM_POWER, whole)
    return SurfaceGrid(shape, pixel, padded, response.astype(digits), pressing.astype(digits), workers)


_cached_grid = functools.lru_cache(maxsize=12)(_made)
