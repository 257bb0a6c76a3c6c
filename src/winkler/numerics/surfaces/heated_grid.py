r"""The surface of a half-space on a grid, heated by fluxes that are constant in every pixel while it moves along x.

A point of the surface that takes 1 W warms the surface, whose material moves with the velocity V, by

.. math:: T = \frac{1}{2\pi\lambda r}\,e^{-k(r-x)}, \qquad k = \frac{V}{2\kappa}

with x and r the distances from it (Rosenthal).  With u = r - x, dx/r = -du/u, so that along x the integral over a
pixel is a difference of exponential integrals E1(k u) at its edges.  Along y, by parts,

.. math:: H(x, y) = \int_0^y E_1(k u)\,\mathrm dy' = y\,E_1(k u) + \int_0^y\Big(1+\frac xr\Big)e^{-k u}\,\mathrm dy' ,

and the last integral is smooth in one of two variables: for c = 2 k x not small in the root z of k u,

.. math:: 2\sqrt{\frac{2x}{k}}\int_0^{\sqrt{ku}} e^{-z^2}\sqrt{1+\frac{z^2}{c}}\,\mathrm dz ,

which is that of conduction into the depth alone where c is large; else in the t of y = x sinh t.  At rest the kernel is
Love's, that of the displacement under pressures.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.pixels.integrals import love
from winkler.numerics.types import Array

NODES = 32
SLOW = 1.0
"""c = 2 k x below which the integral is taken over t."""
FARTHEST = 6.2
"""Root of k u beyond which nothing is added."""
RESTS = 1e-9
"""k times the length of the grid below which a body counts as at rest."""
CHUNK = 100_000
"""Nodes that are computed at once."""


class HeatedGrid(NamedTuple):
    """A grid, and its temperature under fluxes.

    Parameters
    ----------
    shape
        (nx, ny), pixels.
    padded
        Size of the transform.
    response
        Transform of the temperature under a unit flux on one pixel [K m^2/W].
    inverse
        Transform that roughly undoes it on the grid itself.
    """

    shape: tuple[int, int]
    padded: tuple[int, int]
    response: Array
    inverse: Array

    @classmethod
    def of(cls, shape: tuple[int, int], pixel: tuple[float, float], conductivity: float, wave: float) -> HeatedGrid:
        """Return the grid of a body.

        Parameters
        ----------
        shape, pixel
            As for `winkler.numerics.surfaces.surface_grid.SurfaceGrid.of`.
        conductivity
            lambda [W/(m K)].
        wave
            V / kappa [1/m] with the velocity V along x at which the surface passes, of either sign.
        """
        import scipy.fft

        nx, ny = shape
        padded = scipy.fft.next_fast_len(2 * nx - 1, True), scipy.fft.next_fast_len(2 * ny - 1, True)
        quarter = pixel_temperatures(shape, pixel, wave) / conductivity
        kernel = np.zeros(padded)
        kernel[:nx, :ny] = quarter[nx - 1 :]
        kernel[padded[0] - nx + 1 :, :ny] = quarter[: nx - 1]
        kernel[:, padded[1] - ny + 1 :] = kernel[:, ny - 1 : 0 : -1]
        across = 2.0 * np.pi * scipy.fft.fftfreq(nx, pixel[0])[:, None]
        along = 2.0 * np.pi * scipy.fft.rfftfreq(ny, pixel[1])[None, :]
        square = across**2 + along**2 + 1j * wave * across
        square[0, 0] = (math.pi / max(nx * pixel[0], ny * pixel[1])) ** 2
        if nx % 2 == 0:  # the highest wave has no direction
            square[nx // 2] = np.abs(square[nx // 2])
        return cls(shape, padded, scipy.fft.rfft2(kernel), conductivity * np.sqrt(square))

    def warmed(self, flux: Array) -> Array:
        """Return the temperatures of the middles of the pixels [K], (nx, ny), under fluxes [W/m^2]."""
        import scipy.fft

        waves = scipy.fft.rfft2(flux, s=self.padded)
        waves *= self.response
        return np.asarray(scipy.fft.irfft2(waves, s=self.padded)[: self.shape[0], : self.shape[1]])


def pixel_temperatures(shape: tuple[int, int], pixel: tuple[float, float], wave: float) -> Array:
    """Return lambda T under a unit flux on the pixel around (0, 0) [m].

    Parameters
    ----------
    shape, pixel
        As for `winkler.numerics.surfaces.surface_grid.SurfaceGrid.of`.
    wave
        V / kappa [1/m].

    Returns
    -------
    ndarray, (2 nx - 1, ny)
        At x = (i - nx + 1) dx and y = j dy.
    """
    (nx, ny), (dx, dy) = shape, pixel
    k = 0.5 * abs(wave)
    y = (np.arange(ny) + 0.5) * dy
    if k * math.hypot(nx * dx, ny * dy) < RESTS:
        x = (np.arange(-nx, nx) + 0.5) * dx
        corner = love(x[:, None], y)
    else:
        rows = max(1, CHUNK // (NODES * ny))
        x = (np.arange(-nx, nx) + 0.5) * dx
        corner = np.concatenate([_summed(x[start : start + rows, None], y, k) for start in range(0, 2 * nx, rows)])
        corner = corner if wave > 0.0 else -corner[::-1]
    along = np.diff(corner, axis=0)
    along[:, 1:] -= along[:, :-1].copy()
    along[:, 0] *= 2.0
    return np.asarray(along / (2.0 * math.pi))


def _summed(x: Array, y: Array, k: float) -> Array:
    """Return H, of x of either sign, (m, 1), and positive y, (n,)."""
    from scipy.special import exp1

    r = np.hypot(x, y)
    u = np.where(x > 0.0, y**2 / (r + np.abs(x)), r + np.abs(x))
    slow = 2.0 * k * np.abs(x[:, 0]) < SLOW
    result = y * exp1(k * u)
    for rows, rest in ((slow, _over_t), (~slow, _over_z)):
        if rows.any():
            result[rows] += rest(x[rows], y, k)
    return np.asarray(result)


def _over_t(x: Array, y: Array, k: float) -> Array:
    """Return the integral of (1 + x/r) e^(-k u) where c is small."""
    node, weight = gauss_legendre(NODES)
    far, sign = np.abs(x), np.where(x > 0.0, 1.0, -1.0)
    reach = np.minimum(np.arcsinh(y / far), np.arccosh(1.0 + FARTHEST**2 / (k * far)))
    half = 2.0 * np.sinh(0.5 * reach[..., None] * node) ** 2  # cosh t - 1
    kx, plus = (k * far)[..., None], (1.0 + sign)[..., None]
    return np.asarray((plus + half) * np.exp(-kx * (half + 1.0 - sign[..., None])) @ weight * reach * far)


def _over_z(x: Array, y: Array, k: float) -> Array:
    """Return the same integral where c is not small."""
    node, weight = gauss_legendre(NODES)
    far, ahead = np.abs(x), x[:, 0] < 0.0
    c = 2.0 * k * far
    reach = np.minimum(y * np.sqrt(k / (np.hypot(far, y) + far)), FARTHEST)
    square = (reach[..., None] * node) ** 2
    bent = 1.0 + square / c[..., None]
    result = np.empty(reach.shape)
    behind = ~ahead
    result[behind] = 4.0 * (np.exp(-square[behind]) * np.sqrt(bent[behind])) @ weight
    upstream = np.exp(-square[ahead] - c[ahead][..., None]) * square[ahead] / np.sqrt(bent[ahead])
    result[ahead] = 4.0 * upstream @ weight / c[ahead]
    return np.asarray(result * reach * far / np.sqrt(c))
