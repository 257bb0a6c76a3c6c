r"""Pixels that press on a half-space whose modulus follows a power of the depth.

Where the springs of the medium have the stiffness :math:`E^*(x/c_0)^k`, a unit force displaces the surface at the
distance r by

.. math:: u(r) = \frac{\cos(\pi k/2)}{\pi E^*}\,\frac{c_0^k}{r^{1+k}} , \qquad
          \hat u(q) = \frac{2}{E^*q}\,(1+M)\,\hat p , \qquad
          1+M = \Big(\frac{c_0 q}2\Big)^k\cos\frac{\pi k}2\,
                \frac{\Gamma(\frac{1-k}2)}{\Gamma(\frac{1+k}2)} ,

which is Boussinesq's solution for k = 0.  Its integral over a pixel is that of
`winkler.numerics.pixels.integrals`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.pixels.integrals import over_pixels, over_slices
from winkler.numerics.transforms.graded_abel import right_cosine
from winkler.numerics.types import Array

NODES = 32
"""Of the integral in `straightened`: to 1e-12 for places up to 1e4 pixels away."""


class PowerLawKernel(NamedTuple):
    """strength / r^(1 + k)."""

    strength: float
    exponent: float

    def at(self, r: Array) -> Array:
        """Return k(r)."""
        return np.asarray(self.strength * r ** (-1.0 - self.exponent))

    def within(self, r: Array) -> Array:
        """Return the integral of k r from 0 to r."""
        rest = 1.0 - self.exponent
        return np.asarray(self.strength / rest * r**rest)


class PowerLawSurface(NamedTuple):
    """The surface of such a half-space in some unit of length.

    Parameters
    ----------
    exponent : float
        k, between -1 and 1.
    depth : float
        c_0, to which E* refers.
    """

    exponent: float
    depth: float

    def in_units_of(self, length: float) -> PowerLawSurface:
        """Return the same with lengths measured by this one."""
        return PowerLawSurface(self.exponent, self.depth / length)

    @property
    def mean(self) -> float:
        """Zero: the displacement under a uniform pressure is infinite, and the mean is left at rest."""
        return 0.0

    def whole(self, wave: Array) -> Array:
        """Return 1 + M at positive wave numbers of any shape."""
        k = self.exponent
        share = right_cosine(k) * math.gamma(0.5 * (1.0 - k)) / math.gamma(0.5 * (1.0 + k))
        return np.asarray(share * (0.5 * self.depth * wave) ** k)

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
            In the unit of length.
        """
        graded, love = self._kernels
        return over_pixels(graded, shape, pixel) - over_pixels(love, shape, pixel)

    def slices(self, edges: Array, across: float, rows: int) -> Array:
        """Return the displacements beyond Love's of E* under unit pressure on elements of several lengths.

        Parameters
        ----------
        edges, across, rows
            As of `winkler.numerics.pixels.integrals.over_slices`, which says what is returned.
        """
        graded, love = self._kernels
        return over_slices(graded, edges, across, rows) - over_slices(love, edges, across, rows)

    @property
    def strength(self) -> float:
        """u(r) r^(1 + k) of E* under a unit force [m^k]."""
        return float(right_cosine(self.exponent) * self.depth**self.exponent / math.pi)

    @property
    def _kernels(self) -> tuple[PowerLawKernel, PowerLawKernel]:
        """What a unit force moves, and what it moves after Boussinesq."""
        return PowerLawKernel(self.strength, self.exponent), PowerLawKernel(1.0 / math.pi, 0.0)

    def lost(self, pixel: tuple[float, float]) -> float:
        """Return zero: a power law has no length that pixels could be too coarse for."""
        return 0.0


def straightened(x: Array, y: Array, exponent: float) -> Array:
    r"""Return the integral of :math:`x\,(x^2+t^2)^{-(1+k)/2}` over t from 0 to y: x arsinh(y / |x|) for k = 0.

    Parameters
    ----------
    x, y : ndarray
        Not zero, of shapes that fit each other.
    exponent : float
        k.
    """
    far = np.arcsinh(y / np.abs(x))
    if exponent == 0.0:
        return np.asarray(x * far)
    whole = np.zeros(far.shape)
    for node, weight in zip(*gauss_legendre(NODES), strict=True):
        whole += weight * np.cosh(node * far) ** -exponent
    return np.asarray(x * np.abs(x) ** -exponent * far * whole)
