r"""Pixels that are sheared on a layered surface: what they move it by beyond a homogeneous one of the same top layer.

To tractions along a wave and across it a layered body answers by two functions of the wave number.  Their mean and
half their difference, beyond those of short waves, are M_0 and M_2 times 1 / G*; at the distance r, in the direction
:math:`\varphi`, they add to Cerruti's displacements

.. math:: \frac{1}{G^*}\left[k_0(r)\begin{pmatrix}1&0\\0&1\end{pmatrix} + k_2(r)\begin{pmatrix}
          \cos2\varphi&\sin2\varphi\\ \sin2\varphi&-\cos2\varphi\end{pmatrix}\right]

with the kernels of J_0 and J_2 (`winkler.numerics.transforms.radial_kernel`).
"""

from __future__ import annotations

import math
from typing import NamedTuple, Protocol

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.pixels.integrals import over_pixels
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.radial_kernel import RadialKernel, radial_kernel, turning_kernel
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

ZONES = ((0.0, 8), (8.0, 4), (24.0, 2))
"""From how many pixels on how many places along a side of a part of the pixel are enough."""
PART_OVER_LENGTH, MOST_PARTS = 0.5, 16
"""Near pixels are divided into parts of this length of the layers, at most so many."""
MOST_PLACES = 2**20
"""Places for which the kernel is computed at once."""


class ShearResponse(WaveResponse, Protocol):
    """A response to shear, averaged over its angle with the wave."""

    @property
    def compressed(self) -> float:
        """The limit of (1 + M) / xi for long waves [m]; infinite on a half-space."""


class LayeredShear(NamedTuple):
    """A layered surface under shear, in some unit of length.

    Parameters
    ----------
    even : ShearResponse
        M_0, in its own unit of length.
    turning : WaveResponse
        M_2, in the same unit.
    unit : float
        That unit.
    share : float
        E* / G*: displacements are those of an E* of one.
    """

    even: ShearResponse
    turning: WaveResponse
    unit: float
    share: float

    def in_units_of(self, length: float) -> LayeredShear:
        """Return the same with lengths measured by this one."""
        return self._replace(unit=self.unit / length)

    @property
    def mean(self) -> float:
        """Displacement under a uniform traction of E*; zero where it is infinite, and the mean is left at rest."""
        compressed = 2.0 * self.share * self.unit * self.even.compressed
        return compressed if math.isfinite(compressed) else 0.0

    def waves(self, wave: Array) -> tuple[Array, Array]:
        """Return E*/G* times M_0 and M_2 at positive wave numbers of any shape."""
        different, place = np.unique(np.ravel(wave), return_inverse=True)
        even, turning = (
            self.share * np.real(response.excess(different * self.unit))[place].reshape(np.shape(wave))
            for response in (self.even, self.turning)
        )
        return even, turning

    def pixels(self, shape: tuple[int, int], pixel: tuple[float, float]) -> tuple[Array, Array, Array]:
        """Return displacements beyond Cerruti's at (i dx, j dy) under a unit traction on the pixel around (0, 0).

        Parameters
        ----------
        shape
            How many places.
        pixel
            (dx, dy).

        Returns
        -------
        tuple of ndarray, (nx, ny)
            xx, xy, yy of E*, in the unit of length.

        Raises
        ------
        NotConverged
            If the contrasts are too large.
        """
        dx, dy = pixel[0] / self.unit, pixel[1] / self.unit
        farthest = math.hypot(shape[0] * dx, shape[1] * dy)
        octave = max(0, math.ceil(math.log2(farthest / self.even.length)))
        try:
            even = over_pixels(radial_kernel(self.even, octave), shape, (dx, dy))
            turning = turning_kernel(self.turning, octave)
        except NotConverged:
            raise NotConverged(
                "the displacements of the layers under shear are not resolved, since their moduli differ by more than "
                "winkler can carry; give layers whose moduli differ by a factor of less than 1e8."
            ) from None
        cosine, sine = _turned(turning, shape, (dx, dy), self.even.length)
        factor = self.unit * self.share
        return factor * (even + cosine), factor * sine, factor * (even - cosine)


def _turned(kernel: RadialKernel, shape: tuple[int, int], pixel: tuple[float, float], length: float) -> list[Array]:
    """Return integrals of k cos(2 phi) and k sin(2 phi) over the pixel."""
    side = max(pixel)
    x, y = np.arange(shape[0]) * pixel[0], np.arange(shape[1]) * pixel[1]
    far = np.hypot(x[:, None], y[None, :]) / side
    found = [np.zeros(shape), np.zeros(shape)]
    for (start, count), stop in zip(ZONES, (*(zone[0] for zone in ZONES[1:]), math.inf), strict=True):
        parts = min(MOST_PARTS, math.ceil(side / (PART_OVER_LENGTH * length))) if start == 0.0 else 1
        node, weight = gauss_legendre(count)
        place = ((np.arange(parts)[:, None] + node) / parts).ravel() - 0.5
        share = np.tile(weight / parts, parts)
        rows, columns = np.nonzero((far >= start) & (far < stop))
        for part in chunks(rows.size, place.size**2, MOST_PLACES):
            i, j = rows[part], columns[part]
            a = (x[i][:, None] + place * pixel[0])[:, :, None]
            b = (y[j][:, None] + place * pixel[1])[:, None, :]
            square = a * a + b * b
            load = kernel.at(np.sqrt(square)) * share[:, None] * share / square * (pixel[0] * pixel[1])
            found[0][i, j] = np.sum(load * (a * a - b * b), axis=(1, 2))
            found[1][i, j] = np.sum(load * 2.0 * a * b, axis=(1, 2))
    return found
