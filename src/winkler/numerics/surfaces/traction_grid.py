r"""Tractions along and across the surface of a half-space on a grid, and the displacements under both.

With E* one and r the vector between two places, pressures p and tractions q on the lower body displace the surfaces of
both bodies against each other by

.. math:: u = \frac1\pi\int\Big[\frac{a}{r} + b\,\frac{\mathbf r\,\mathbf r^T}{r^3}\Big]\mathbf q\,\mathrm dA'
    - \frac\beta\pi\int\frac{\mathbf r}{r^2}\,p\,\mathrm dA' , \qquad
    u_z = \frac1\pi\int\frac pr\,\mathrm dA' + \frac\beta\pi\int\frac{\mathbf r\cdot\mathbf q}{r^2}\,\mathrm dA'

(Cerruti, Boussinesq); of moduli that follow a power k of the depth c_0, 1/r becomes
:math:`\cos\tfrac{\pi k}2\,c_0^k/r^{1+k}`, a becomes (a - k (a + b)) / (1 - k) and b becomes b (1 + k) / (1 - k).  On
waves these are four functions of the wave number, across and along the wave in the plane, out of the plane, and the
coupling of both; a layered body has others.  Of a free surface the displacements at the centres of the pixels are in
closed form, of a periodic one

.. math:: \hat u = \frac 2q\,\Big[a + b\,\Big(1-\frac{\mathbf q\,\mathbf q^T}{q^2}\Big)\Big]\hat{\mathbf q}
    + \frac{2 i\beta\,\mathbf q}{q^2}\,\hat p .
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.integrals import from_corners, transformed
from winkler.numerics.pixels.layered_shear import LayeredShear
from winkler.numerics.pixels.power_law import PowerLawSurface, straightened
from winkler.numerics.surfaces.surface_grid import LARGEST_CACHED_PIXELS, MEAN_WAVE_RATIO, SINGLE, SurfaceGrid
from winkler.numerics.types import Array


class Compliance(NamedTuple):
    """Compliances of two bodies along their surfaces, over those across it.

    Parameters
    ----------
    even
        a: of all directions; one of isotropic bodies.
    along
        b: more in the direction of the traction; nu / (1 - nu) of two alike.
    coupling
        beta, the second constant of Dundurs.
    layers
        What differs from homogeneous bodies, in the unit of length of the pixels; nothing unless given.
    power
        Power of the depth that the moduli follow, in the same unit; none unless given.
    """

    even: float
    along: float
    coupling: float = 0.0
    layers: LayeredShear | None = None
    power: PowerLawSurface | None = None

    def in_units_of(self, length: float) -> Compliance:
        """Return the same with lengths measured by this one."""
        layers = self.layers.in_units_of(length) if self.layers else None
        return self._replace(layers=layers, power=self.power.in_units_of(length) if self.power else None)


class TractionGrid(NamedTuple):
    """A grid, and its response to tractions.

    Parameters
    ----------
    grid
        The grid and its response to pressures.
    compliance
        Of the bodies.
    along
        Transforms of the displacements along the surface under unit tractions along it: xx, xy, yy [m].
    across
        Transforms of the displacement across the surface under unit tractions along it, over i: x, y [m]; empty
        without coupling.
    inverse
        Transforms that roughly undo those of `along` on the grid itself: xx, xy, yy [1/m].
    """

    grid: SurfaceGrid
    compliance: Compliance
    along: Array
    across: Array
    inverse: Array

    @classmethod
    def of(
        cls, shape: tuple[int, int], pixel: tuple[float, float], compliance: Compliance, *, periodic: bool
    ) -> TractionGrid:
        """Return the grid; small ones are made once.

        Parameters
        ----------
        shape, pixel, periodic
            As for `SurfaceGrid.of`.
        compliance
            Of the bodies.
        """
        make = _cached_grid if shape[0] * shape[1] <= LARGEST_CACHED_PIXELS else _made
        return make(shape, pixel, compliance, periodic)

    def in_single_digits(self) -> TractionGrid:
        """Return the grid for tractions of single digits: twice as fast, and good enough for small changes."""
        return self._replace(along=self.along.astype(SINGLE), inverse=self.inverse.astype(SINGLE))

    def sheared(self, traction: Array) -> Array:
        """Return the displacements along the surface [m], (2, nx, ny), under tractions along it over E*."""
        return np.asarray(self.grid.numbers(_turned(self.along, self.grid.waves(traction))))

    def drawn(self, pressure: Array) -> Array:
        """Return the displacements along the surface [m], (2, nx, ny), under pressures over E*."""
        if not self.across.size:
            return np.zeros((2, *self.grid.shape))
        return np.asarray(self.grid.numbers(-1j * self.across * self.grid.waves(pressure)))

    def sunk(self, traction: Array) -> Array:
        """Return the displacements across the surface [m], (nx, ny), under tractions along it over E*."""
        if not self.across.size:
            return np.zeros(self.grid.shape)
        both = self.grid.waves(traction)
        return np.asarray(self.grid.numbers(1j * (self.across[0] * both[0] + self.across[1] * both[1])))

    def roughly_shearing(self, displacement: Array) -> Array:
        """Return tractions that would displace a periodic surface so: the preconditioner."""
        import scipy.fft

        waves = scipy.fft.rfft2(displacement, workers=self.grid.workers)
        return np.asarray(scipy.fft.irfft2(_turned(self.inverse, waves), s=self.grid.shape, workers=self.grid.workers))


def _turned(matrix: Array, waves: Array) -> Array:
    """Return a symmetric matrix times vectors, (3, ...) and (2, ...)."""
    turned = np.empty_like(waves)
    np.multiply(matrix[0], waves[0], out=turned[0])
    turned[0] += matrix[1] * waves[1]
    np.multiply(matrix[2], waves[1], out=turned[1])
    turned[1] += matrix[1] * waves[0]
    return turned


def _made(shape: tuple[int, int], pixel: tuple[float, float], compliance: Compliance, periodic: bool) -> TractionGrid:
    """Return a grid."""
    import scipy.fft

    grid = SurfaceGrid.of(shape, pixel, periodic=periodic)
    a, b, beta, layers, power = compliance
    k, strength = (power.exponent, power.strength) if power else (0.0, 1.0 / np.pi)
    qx = 2.0 * np.pi * scipy.fft.fftfreq(shape[0], pixel[0])[:, None]
    qy = 2.0 * np.pi * scipy.fft.rfftfreq(shape[1], pixel[1])[None, :]
    q = np.hypot(qx, qy)
    q[0, 0] = 1.0
    xx, xy, yy = (qx / q) ** 2, qx * qy / q**2, (qy / q) ** 2
    # a change of the sign of the highest wave alone is no wave that this grid holds
    odd = np.ones(q.shape)
    odd[shape[0] // 2 if shape[0] % 2 == 0 else slice(0, 0)] = 0.0
    odd[:, -1 if shape[1] % 2 == 0 else slice(0, 0)] = 0.0
    xy = xy * odd
    inverse = grid.wave_numbers / (a + b) * np.stack((1.0 + b / a * xx, b / a * xy, 1.0 + b / a * yy))
    lengthwise, crosswise = np.full(q.shape, a), np.full(q.shape, a + b)
    if layers:
        even, turning = layers.waves(q)
        lengthwise, crosswise = lengthwise + even - turning, crosswise + even + turning
        bent = 1.0 / lengthwise - 1.0 / crosswise
        inverse = grid.wave_numbers * np.stack((1.0 / crosswise + bent * xx, bent * xy, 1.0 / crosswise + bent * yy))
    if power:
        share = power.whole(q)
        lengthwise, crosswise, inverse = share * lengthwise, share * crosswise, inverse / share
    inverse[:, 0, 0] = MEAN_WAVE_RATIO * np.pi / max(shape[0] * pixel[0], shape[1] * pixel[1]) * np.array([1, 0, 1]) / a
    if periodic:
        more = crosswise - lengthwise
        along = grid.response * np.stack((lengthwise + more * yy, -more * xy, lengthwise + more * xx))
        along[:, 0, 0] = layers.mean * np.array([1.0, 0.0, 1.0]) if layers else 0.0
        across = -2.0 * beta * odd * np.stack((qx + 0.0 * q, qy + 0.0 * q)) / q**2
    else:

        def kernel(corner: Callable[[Array, Array], Array], *parity: int) -> Array:
            return transformed(from_corners(corner, shape, pixel), grid.padded, (parity[0], parity[1]))

        first = kernel(lambda x, y: straightened(x, y, k), 1, 1) * (strength / (1.0 - k))
        second = kernel(lambda x, y: straightened(y, x, k), 1, 1) * (strength / (1.0 - k))
        crossed = kernel(lambda x, y: -(np.hypot(x, y) ** (1.0 - k)), -1, -1)
        crossed *= strength / (1.0 - k) ** 2
        both = a * (first + second)
        along = np.stack((both + b * second, b * crossed, both + b * first))
        if layers:
            beyond = zip(layers.pixels(shape, pixel), ((1, 1), (-1, -1), (1, 1)), strict=True)
            along = along + np.stack([transformed(quarter, grid.padded, parity) for quarter, parity in beyond])
        parts = (
            kernel(lambda x, y: y * np.log(np.hypot(x, y)) + x * np.arctan(y / x), -1, 1),
            kernel(lambda x, y: x * np.log(np.hypot(x, y)) + y * np.arctan(x / y), 1, -1),
        )
        across = beta / np.pi * np.stack(parts)
    return TractionGrid(grid, compliance, along, across if beta else np.empty(0), inverse)


_cached_grid = functools.lru_cache(maxsize=12)(_made)
