r"""Pixels that press on a layered surface: what they move it by beyond a homogeneous one of the same topmost layer.

Under a unit pressure on a rectangle the displacement over that of E* is Love's and the integral of k
(`winkler.numerics.transforms.radial_kernel`) over the rectangle.  Near the pixel the integral is a sum over its four
corners,

.. math:: I(x,y) = \int_0^{\mathrm{arsinh}(y/x)}\frac{Q(x\cosh s)}{\cosh s}\,\mathrm ds
                 + \int_0^{\mathrm{arsinh}(x/y)}\frac{Q(y\cosh s)}{\cosh s}\,\mathrm ds ,

whatever the layers; far away k varies over the distance, and Gauss' rule of a few places in the pixel is as good.
"""

from __future__ import annotations

import math
from typing import NamedTuple, Protocol

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.radial_kernel import RadialKernel, radial_kernel
from winkler.numerics.types import Array

__all__ = ["GridResponse", "LayeredSurface"]

CORNER_NODES = 64
FAR_ZONES = ((8.0, 4), (24.0, 3), (128.0, 2))
"""From how many pixels on how many places along a side of the pixel are enough for ten digits."""
SPLINE_STEP = 2e-3
"""Of log r: the cubic spline errs by less than a part 1e-11."""
FAR_MARGIN = 0.75
"""How much nearer than the first far zone places in its pixels may lie, as a part."""
TESTED_WAVE = 16.0
"""Wave, in pixels, that the pixels must follow."""
MOST_LOST = 0.1
"""Part of the displacement under it that may be wrong."""
TESTED_OVERTONES = 64


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
        farthest = math.hypot(shape[0] * dx, shape[1] * dy)
        try:
            kernel = radial_kernel(self.response, max(0, math.ceil(math.log2(farthest / self.response.length))))
        except NotConverged:
            raise NotConverged(
                "the displacements of the layers are not resolved, since their moduli differ by more than winkler can "
                "carry; give layers whose moduli differ by a factor of less than 1e8."
            ) from None
        side = max(dx, dy)
        near = tuple(min(n, math.ceil(FAR_ZONES[0][0] * side / d) + 1) for n, d in zip(shape, (dx, dy), strict=True))
        x, y = np.arange(shape[0]) * dx, np.arange(shape[1]) * dy
        result = np.empty(shape)
        far = np.hypot(x[:, None], y[None, :]) / side
        starts, stops = FAR_ZONES, (*(start for start, _ in FAR_ZONES[1:]), math.inf)
        for (start, count), stop in zip(starts, stops, strict=True):
            rows, columns = np.nonzero((far >= start) & (far < stop))
            if rows.size:
                result[rows, columns] = _gauss(_far_spline(kernel, start * side, farthest), x[rows], y[columns],
                                               (dx, dy), count)  # fmt: skip
        corner = _corners(kernel, (np.arange(near[0] + 1) - 0.5) * dx, (np.arange(near[1] + 1) - 0.5) * dy)
        close = corner[1:, 1:] - corner[:-1, 1:] - corner[1:, :-1] + corner[:-1, :-1]
        result[: near[0], : near[1]] = np.where(
            far[: near[0], : near[1]] < FAR_ZONES[0][0], close, result[: near[0], : near[1]]
        )
        return self.unit * result

    def lost(self, pixel: tuple[float, float]) -> float:
        """Return by which part displacements under a wave of sixteen pixels of this size are wrong."""
        return max(_lost(self.response, side / self.unit) for side in pixel)

    def _refuse_coarse(self, pixel: tuple[float, float]) -> None:
        lost = self.lost(pixel)
        if lost > MOST_LOST:
            raise OutsideValidity(
                f"pixels of {max(pixel) / self.unit / self.response.length:.3g} times the thickness of the uppermost "
                f"layer are too coarse: under a wave of {TESTED_WAVE:.0f} of them the displacement would be wrong by "
                f"{lost:.0%}, since a nearly incompressible film only yields between pixels; take pixels as small as "
                "the film is thick, or a periodic map."
            )


def _gauss(spline: object, x: Array, y: Array, pixel: tuple[float, float], count: int) -> Array:
    """Return integrals over the pixels around these places."""
    node, weight = gauss_legendre(count)
    total = np.zeros(x.shape)
    for a, wa in zip(node - 0.5, weight, strict=True):
        for b, wb in zip(node - 0.5, weight, strict=True):
            square = (x + a * pixel[0]) ** 2 + (y + b * pixel[1]) ** 2
            total += wa * wb * spline(np.log(square))  # type: ignore[operator]
    return np.asarray(pixel[0] * pixel[1] * total)


def _far_spline(kernel: RadialKernel, nearest: float, farthest: float) -> object:
    """Return k as a function of log r^2, between these distances and a little farther."""
    from scipy.interpolate import CubicSpline

    low, high = 2.0 * math.log(FAR_MARGIN * nearest), 2.0 * math.log(1.1 * farthest)
    places = np.linspace(low, high, max(16, math.ceil((high - low) / (2.0 * SPLINE_STEP))))
    return CubicSpline(places, kernel.at(np.exp(0.5 * places)))


def _corners(kernel: RadialKernel, x: Array, y: Array) -> Array:
    """Return I(x, y), odd in both, on a grid."""
    wide, high = np.abs(x)[:, None], np.abs(y)[None, :]
    return np.asarray(np.sign(x)[:, None] * np.sign(y) * (_sector(kernel, wide, high) + _sector(kernel, high, wide)))


def _sector(kernel: RadialKernel, x: Array, y: Array) -> Array:
    """Return the integral of k over the triangle below the diagonal of a rectangle."""
    node, weight = gauss_legendre(CORNER_NODES)
    reach = np.arcsinh(y / x)
    stretch = np.cosh(reach[..., None] * node)
    return np.asarray(reach * ((kernel.within(x[..., None] * stretch) / stretch) @ weight))


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
