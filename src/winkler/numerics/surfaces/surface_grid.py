r"""The surface of a half-space on a grid: displacements under pressures that are constant in every pixel.

Where E* is one, pressures p sink the surface by

.. math:: u(x, y) = \frac{1}{\pi}\int\frac{p(x', y')}{\sqrt{(x-x')^2+(y-y')^2}}\,\mathrm dA' ,

a convolution, made by fast Fourier transforms: of a free surface on a grid of twice the size, with Love's exact
displacement at the centres of the pixels; of a periodic one by 2 / \|q\|, which leaves its mean at rest.  Layers add
the integral of their kernel over the pixel (`winkler.numerics.surfaces.layered_pixels`), or multiply waves by 1 + M.
"""

from __future__ import annotations

import functools
import os
from typing import NamedTuple

import numpy as np

from winkler.numerics.surfaces.layered_pixels import SurfaceBelow
from winkler.numerics.types import Array

__all__ = ["DOUBLE", "SINGLE", "SurfaceGrid", "bytes_needed"]

ARRAY_COPIES = 5
"""How many arrays of the size of the transform are alive at once."""
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
    """Return the memory [byte] that a grid of this shape takes while it works."""
    points = shape[0] * shape[1]
    return 8 * points * (12 + (2 if periodic else 4) * ARRAY_COPIES)


def _rectangle(shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
    """Return the displacements by Love at (i dx, j dy) under unit pressure on the pixel around (0, 0), times pi."""
    x = ((np.arange(shape[0] + 1) - 0.5) * pixel[0])[:, None]
    y = ((np.arange(shape[1] + 1) - 0.5) * pixel[1])[None, :]
    corner = x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))
    return np.asarray(corner[1:, 1:] - corner[:-1, 1:] - corner[1:, :-1] + corner[:-1, :-1])


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
            Whether the surface goes on for ever, repeated, or bears nothing outside.
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

    def waves(self, numbers: Array) -> Array:
        """Return the transform of numbers on the grid, (..., nx, ny), padded with zeros if it is not periodic."""
        import scipy.fft

        rows = scipy.fft.rfft(numbers, self.padded[1], axis=-1, workers=self.workers)
        return np.asarray(scipy.fft.fft(rows, self.padded[0], axis=-2, workers=self.workers, overwrite_x=True))

    def numbers(self, waves: Array) -> Array:
        """Return the numbers on the grid that have this transform, which is overwritten."""
        import scipy.fft

        back = scipy.fft.ifft(waves, axis=-2, overwrite_x=True, workers=self.workers)[..., : self.shape[0], :]
        return np.asarray(scipy.fft.irfft(back, self.padded[1], axis=-1, workers=self.workers)[..., : self.shape[1]])

    def displaced(self, pressure: Array) -> Array:
        """Return u [m] under p, over E*."""
        both = self.waves(pressure)
        both *= self.response
        return self.numbers(both)

    def roughly_pressing(self, displacement: Array) -> Array:
        """Return pressures, over E*, that would displace a periodic surface so: the preconditioner."""
        import scipy.fft

        waves = scipy.fft.rfft2(displacement, workers=self.workers)
        waves *= self.wave_numbers
        return np.asarray(scipy.fft.irfft2(waves, s=self.shape, workers=self.workers))


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
    workers = (os.cpu_count() or 1) if nx * ny > SINGLE_THREAD_PIXELS else 1
    qx = 2.0 * np.pi * scipy.fft.fftfreq(nx, pixel[0])[:, None]
    qy = 2.0 * np.pi * scipy.fft.rfftfreq(ny, pixel[1])[None, :]
    wave = np.hypot(qx, qy)
    wave[0, 0] = MEAN_WAVE_RATIO * 2.0 * np.pi / max(nx * pixel[0], ny * pixel[1])
    whole = layers.whole(wave) if layers else np.ones_like(wave)
    if periodic:
        response = 2.0 * whole / wave
        response[0, 0] = layers.mean if layers else 0.0
        padded = shape
    else:
        padded = scipy.fft.next_fast_len(2 * nx - 1, True), scipy.fft.next_fast_len(2 * ny - 1, True)
        quarter = _rectangle(shape, pixel) / np.pi
        quarter = quarter + layers.pixels(shape, pixel) if layers else quarter
        kernel = np.zeros(padded)
        kernel[:nx, :ny] = quarter
        kernel[padded[0] - nx + 1 :, :ny] = quarter[:0:-1]
        kernel[:, padded[1] - ny + 1 :] = kernel[:, ny - 1 : 0 : -1]
        response = np.ascontiguousarray(scipy.fft.rfft2(kernel, workers=workers).real)
    pressing = 0.5 * wave / np.where(whole > 1.0, whole**STIFF_FILM_POWER, whole)
    return SurfaceGrid(shape, pixel, padded, response.astype(digits), pressing.astype(digits), workers)


_cached_grid = functools.lru_cache(maxsize=12)(_made)
