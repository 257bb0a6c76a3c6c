"""Stresses and displacements in a half-space under a map of pressures and tractions, each constant in its pixel.

At a few places the corners of all pixels are summed (`winkler.media.interior.rectangle`); at the middles of the pixels
of a plane along or across the surface the sums are convolutions, made by fast Fourier transforms depth by depth.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.media.interior.rectangle import COMPONENTS, EXCHANGED, corners_at, sum_corners
from winkler.numerics.threads import run_in_threads
from winkler.numerics.types import Array

LEAST_SQUARE = 1e-18
"""Square of the distance, in pixels, from the edge of a pixel on the surface within which stresses do not grow."""


class MapField(NamedTuple):
    """A map of loads on the surface of a half-space that bears nothing outside of it.

    Parameters
    ----------
    loads
        Pressure, and tractions along x and y that act on the body, (3, nx, ny).
    pixel
        (dx, dy); places are counted in the same unit, from the corner of the map.
    poisson
        Of the body.
    """

    loads: Array
    pixel: tuple[float, float]
    poisson: float

    @property
    def dragged(self) -> bool:
        """Whether there are tractions."""
        return bool(np.any(self.loads[1:]))

    def at_places(self, places: Array) -> Array:
        """Return stresses xx, yy, zz, xy, xz, yz and displacements, times 2 G, at places (m, 3), as (9, m)."""
        jumps = np.diff(np.diff(np.pad(self.loads, ((0, 0), (1, 1), (1, 1))), axis=1), axis=2)
        i, j = np.nonzero(np.any(jumps != 0.0, axis=0))
        unit = self.pixel[0]
        corners = np.stack([i * 1.0, j * (self.pixel[1] / unit)], axis=1)
        strengths = np.ascontiguousarray(jumps[:, i, j].T)
        scaled = np.ascontiguousarray(places / unit)
        out = np.zeros((len(places), COMPONENTS))

        def work(part: slice) -> None:
            sum_corners(scaled[part], corners, strengths, self.dragged, self.poisson, LEAST_SQUARE, out[part])

        run_in_threads(work, len(places))
        out[:, 6:] *= unit
        return out.T

    def _kernels(self, x: Array, y: Array, z: float) -> list[Array]:
        """Return what unit loads on pixels give that stand at all distances between neighbours of x and y.

        One array (9, nx - 1, ny - 1) for each load that there is.
        """
        unit = self.pixel[0]
        along, across = x / unit, y / unit
        found = [self._kernel(along, across, z / unit, load > 0) for load in range(2 if self.dragged else 1)]
        if self.dragged:
            found.append(self._kernel(across, along, z / unit, True).transpose(0, 2, 1)[list(EXCHANGED)])
        for kernel in found:
            kernel[6:] *= unit
        return found

    def _kernel(self, x: Array, y: Array, z: float, dragged: bool) -> Array:
        corners = np.empty((COMPONENTS, x.size, y.size))

        def work(part: slice) -> None:
            corners_at(x[part], y, z, self.poisson, LEAST_SQUARE, dragged, corners[:, part])

        run_in_threads(work, x.size)
        return np.diff(np.diff(corners, axis=1), axis=2)

    @property
    def _box(self) -> tuple[slice, slice]:
        """The smallest part of the map outside of which there are no loads."""
        there = np.any(self.loads != 0.0, axis=0)
        spans = []
        for axis in (1, 0):
            found = np.flatnonzero(there.any(axis=axis))
            spans.append(slice(int(found[0]), int(found[-1]) + 1) if found.size else slice(0, 1))
        return spans[0], spans[1]

    def at_depth(self, z: float, count: int = COMPONENTS) -> Array:
        """Return the first components of `at_places` below the middles of all pixels at one depth, (count, nx, ny)."""
        import scipy.fft

        nx, ny = self.loads.shape[1:]
        (left, right), (low, high) = ((span.start, span.stop) for span in self._box)
        x = (np.arange(1 - right, nx - left + 1) - 0.5) * self.pixel[0]
        y = (np.arange(1 - high, ny - low + 1) - 0.5) * self.pixel[1]
        shape = tuple(scipy.fft.next_fast_len(part.size - 1, True) for part in (x, y))
        kernels = self._kernels(x, y, z)
        sources = scipy.fft.rfft2(self.loads[: len(kernels), self._box[0], self._box[1]], shape, workers=-1)
        out = np.empty((count, nx, ny))
        for k in range(count):
            total = sum(
                source * scipy.fft.rfft2(kernel[k], shape, workers=-1)
                for source, kernel in zip(sources, kernels, strict=True)
            )
            back = scipy.fft.irfft2(total, shape, workers=-1)
            out[k] = back[right - left - 1 :, high - low - 1 :][:nx, :ny]
        return out

    def across(self, y: float, z: float) -> Array:
        """Return the components on the line at y and depth z, below the middles of the pixels along x, (9, nx)."""
        import scipy.fft

        nx = self.loads.shape[1]
        (left, right), (low, high) = ((span.start, span.stop) for span in self._box)
        x = (np.arange(1 - right, nx - left + 1) - 0.5) * self.pixel[0]
        rows = y - np.arange(high, low - 1, -1) * self.pixel[1]
        size = scipy.fft.next_fast_len(x.size - 1, True)
        kernels = self._kernels(x, rows, z)
        sources = scipy.fft.rfft(self.loads[: len(kernels), self._box[0], self._box[1]], size, axis=1)[:, :, ::-1]
        total = sum(
            np.einsum("kxy,xy->kx", scipy.fft.rfft(kernel, size, axis=1), source)
            for source, kernel in zip(sources, kernels, strict=True)
        )
        return np.asarray(scipy.fft.irfft(total, size, axis=1)[:, right - left - 1 :][:, :nx])

    def exchanged(self) -> MapField:
        """Return the same map with x and y exchanged."""
        return MapField(self.loads.transpose(0, 2, 1)[[0, 2, 1]], self.pixel[::-1], self.poisson)

    def coarsened(self, times: int) -> MapField:
        """Return the map of the means over `times` by `times` pixels, beginning at the same corner."""
        nx, ny = (-(-n // times) * times for n in self.loads.shape[1:])
        padded = np.zeros((3, nx, ny))
        padded[:, : self.loads.shape[1], : self.loads.shape[2]] = self.loads
        means = padded.reshape(3, nx // times, times, ny // times, times).mean(axis=(2, 4))
        return MapField(means, (times * self.pixel[0], times * self.pixel[1]), self.poisson)
