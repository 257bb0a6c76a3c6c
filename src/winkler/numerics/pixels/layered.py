r"""Pixels that press on a layered surface: what they move it by beyond a homogeneous one of the same topmost layer.

Under a unit pressure on a rectangle the displacement over that of E* is Love's and the integral of k
(`winkler.numerics.transforms.radial_kernel`) over the rectangle (`winkler.numerics.pixels.integrals`).
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple, Protocol, TypeAlias

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.pixels.integrals import over_pixels, over_slices
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.radial_kernel import RadialKernel, radial_kernel
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

TESTED_WAVE = 16.0
"""Wave, in pixels, that the pixels must follow."""
MOST_LOST = 0.1
"""Part of the displacement under it that may be wrong."""
TESTED_OVERTONES = 64
KEPT_PIXELS = 2**18
"""Pixels up to which the displacements of the parts of a sum are kept."""


class GridResponse(WaveResponse, Protocol):
    """A response to a pressure whose compliance is known without cancellation."""

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite on a half-space."""
        ...

    def whole(self, xi: Array) -> Array:
        """1 + M(xi) [-] at wave numbers (m,) [1/m], also where it is small."""
        ...


class LayeredSurface(NamedTuple):
    """A layered surface in some unit of length.

    Parameters
    ----------
    response : GridResponse
        In its own unit of length.
    unit : float
        That unit.
    """

    response: GridResponse
    unit: float

    def in_units_of(self, length: float) -> LayeredSurface:
        """Return the same with lengths measured by this one."""
        return LayeredSurface(self.response, self.unit / length)

    @property
    def mean(self) -> float:
        """Displacement under a uniform pressure of E*; zero where it is infinite, and the mean is left at rest."""
        compressed = 2.0 * self.unit * self.response.compressed
        return compressed if math.isfinite(compressed) else 0.0

    def whole(self, wave: Array) -> Array:
        """Return 1 + M at positive wave numbers of any shape."""
        different, place = np.unique(np.ravel(wave), return_inverse=True)
        return np.asarray(np.real(self.response.whole(different * self.unit))[place].reshape(np.shape(wave)))

    def pixels(self, shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
        """Return the displacements beyond Love's at (i dx, j dy), of E* under unit pressure on the pixel around (0, 0).

        Parameters
        ----------
        shape
            How many places.
        pixel
            (dx, dy).

        Returns
        -------
        ndarray, (nx, ny)
            In the unit of length, to ten digits of the greatest displacement.

        Raises
        ------
        NotConverged
            If the contrasts are too large.
        OutsideValidity
            If the pixels are too coarse for the layers.
        """
        self._refuse_coarse(pixel)
        dx, dy = pixel[0] / self.unit, pixel[1] / self.unit
        kernel = self._kernel(math.hypot(shape[0] * dx, shape[1] * dy))
        return self.unit * over_pixels(kernel, shape, (dx, dy))

    def slices(self, edges: Array, across: float, rows: int) -> Array:
        """Return the displacements beyond Love's of E* under unit pressure on elements of several lengths.

        Parameters
        ----------
        edges, across, rows
            As of `winkler.numerics.pixels.integrals.over_slices`, which says what is returned.

        Raises
        ------
        NotConverged, OutsideValidity
            As of `pixels`; of coarseness the width counts, across which the pressure changes most.
        """
        self._refuse_coarse((across, across))
        ends, width = edges / self.unit, across / self.unit
        kernel = self._kernel(math.hypot(ends[-1] - ends[0], rows * width))
        return self.unit * over_slices(kernel, ends, width, rows)

    def _kernel(self, farthest: float) -> RadialKernel:
        """Return k up to a distance, both in the unit of the response."""
        try:
            return radial_kernel(self.response, max(0, math.ceil(math.log2(farthest / self.response.length))))
        except NotConverged:
            raise NotConverged(
                "the displacements of the layers are not resolved, since their moduli, or resistivities, differ by "
                "more than winkler can carry; give layers that differ by a factor of less than 1e8."
            ) from None

    def lost(self, pixel: tuple[float, float]) -> float:
        """Return by which part displacements under a wave of sixteen pixels of this size are wrong."""
        return max(_lost(self.response, side / self.unit) for side in pixel)

    def _refuse_coarse(self, pixel: tuple[float, float]) -> None:
        lost = self.lost(pixel)
        if lost > MOST_LOST:
            raise OutsideValidity(
                f"pixels of {max(pixel) / self.unit / self.response.length:.3g} times the thickness of the uppermost "
                f"layer are too coarse. Under a wave of {TESTED_WAVE:.0f} of them the displacement would be wrong by "
                f"{lost:.0%}, since a nearly incompressible film only yields between pixels: use pixels as small as "
                "the film is thick, or a periodic map."
            )


class MixedSurface(NamedTuple):
    """A layered surface whose compliance is a sum of those of others; units as of `LayeredSurface`.

    Parameters
    ----------
    parts : tuple of LayeredSurface
    weights : tuple of float
        Of the compliances of the parts, each over its own modulus, in that of the sum; they add up to one.
    """

    parts: tuple[LayeredSurface, ...]
    weights: tuple[float, ...]

    def in_units_of(self, length: float) -> MixedSurface:
        """Return the same with lengths measured by this one."""
        return self._replace(parts=tuple(part.in_units_of(length) for part in self.parts))

    @property
    def mean(self) -> float:
        """As of `LayeredSurface`."""
        return float(self._sum(lambda part: np.array(part.mean)))

    def whole(self, wave: Array) -> Array:
        """As of `LayeredSurface`."""
        return self._sum(lambda part: part.whole(wave))

    def pixels(self, shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
        """As of `LayeredSurface`; those of parts are kept for the next sum."""
        found = _kept_pixels if shape[0] * shape[1] <= KEPT_PIXELS else LayeredSurface.pixels
        return self._sum(lambda part: found(part, shape, pixel))

    def slices(self, edges: Array, across: float, rows: int) -> Array:
        """As of `LayeredSurface`."""
        return self._sum(lambda part: part.slices(edges, across, rows))

    def lost(self, pixel: tuple[float, float]) -> float:
        """As of `LayeredSurface`, the greatest of all parts."""
        return max(part.lost(pixel) for part in self.parts)

    def _sum(self, answer: Callable[[LayeredSurface], Array]) -> Array:
        return np.asarray(sum(weight * answer(part) for part, weight in zip(self.parts, self.weights, strict=True)))


@functools.lru_cache(maxsize=128)
def _kept_pixels(part: LayeredSurface, shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
    return part.pixels(shape, pixel)


SurfaceBelow: TypeAlias = LayeredSurface | MixedSurface | PowerLawSurface
"""What lies below a surface that is not a homogeneous half-space."""


@cached_by_value(256)
def _lost(response: GridResponse, side: float) -> float:
    """Return by which part the middles of pixels miss the displacement under a wave across them.

    Pixels of constant pressure bear the wave and its overtones, q + 2 pi k / dx, whose signs alternate at the middles.
    """
    k = np.arange(-TESTED_OVERTONES, TESTED_OVERTONES + 1)
    half = math.pi / TESTED_WAVE + math.pi * k  # of the phase across a pixel
    wave = 2.0 * np.abs(half) / side
    fade = np.cos(0.5 * math.pi * k / (TESTED_OVERTONES + 1)) ** 2  # alternating sums converge without their ends
    answer = response.whole(wave) / wave
    seen = float(np.sum(fade * answer * np.sin(half) / half))
    return abs(seen / float(answer[TESTED_OVERTONES]) - 1.0)
