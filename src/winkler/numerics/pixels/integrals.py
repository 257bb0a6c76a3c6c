r"""Integrals of a kernel k(r) over rectangular pixels, at all places of a grid.

Near the pixel the integral is a sum over its four corners,

.. math:: I(x,y) = \int_0^{\mathrm{arsinh}(y/x)}\frac{Q(x\cosh s)}{\cosh s}\,\mathrm ds
                 + \int_0^{\mathrm{arsinh}(x/y)}\frac{Q(y\cosh s)}{\cosh s}\,\mathrm ds , \qquad
          Q(r) = \int_0^r k\,r'\,\mathrm dr' ,

whatever the kernel and however long the pixel; far away k varies over the distance, and Gauss' rule of a few places
in the pixel is as good.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Protocol

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

CORNER_NODES = 64
FAR_ZONES = ((8.0, 4), (24.0, 3), (128.0, 2))
"""From how many pixels on how many places along a side of the pixel are enough for ten digits."""
SPLINE_STEP = 2e-3
"""Of log r: the cubic spline errs by less than a part 1e-11."""
SLICE_STEP = 0.04
"""Of log x, between places at which strips end: a cubic spline errs by less than a part 1e-8 of the integral."""
FAR_MARGIN = 0.75
"""How much nearer than the first far zone places in its pixels may lie, as a part."""


class RadialPart(Protocol):
    """What a unit force moves at a distance, and its integral over a disc."""

    def at(self, r: Array) -> Array:
        """Return k(r), r > 0."""

    def within(self, r: Array) -> Array:
        """Return Q(r), the integral of k r from 0 to r."""


def over_pixels(kernel: RadialPart, shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
    """Return the integrals of k over the pixel around (0, 0), seen from (i dx, j dy); (nx, ny).

    Parameters
    ----------
    kernel
        k, smooth in log r beyond a few pixels.
    shape
        How many places.
    pixel
        (dx, dy), in the unit of length of the kernel.
    """
    dx, dy = pixel
    farthest, side = math.hypot(shape[0] * dx, shape[1] * dy), max(dx, dy)
    nx, ny = (min(n, math.ceil(FAR_ZONES[0][0] * side / d) + 1) for n, d in zip(shape, pixel, strict=True))
    x, y = np.arange(shape[0]) * dx, np.arange(shape[1]) * dy
    result = np.empty(shape)
    far = np.hypot(x[:, None], y[None, :]) / side
    starts, stops = FAR_ZONES, (*(start for start, _ in FAR_ZONES[1:]), math.inf)
    for (start, count), stop in zip(starts, stops, strict=True):
        rows, columns = np.nonzero((far >= start) & (far < stop))
        if rows.size:
            spline = _far_spline(kernel, start * side, farthest)
            result[rows, columns] = _gauss(spline, x[rows], y[columns], (dx, dy), count)
    close = from_corners(functools.partial(_corners, kernel), (nx, ny), pixel)
    result[:nx, :ny] = np.where(far[:nx, :ny] < FAR_ZONES[0][0], close, result[:nx, :ny])
    return result


def over_slices(kernel: RadialPart, edges: Array, across: float, rows: int) -> Array:
    """Return the integrals of k over elements of several lengths and one width; (rows, n, n).

    Parameters
    ----------
    kernel
        k, smooth in log r.
    edges
        Ends of the elements along x, ascending, (n + 1,), in the unit of length of the kernel.
    across
        Their width.
    rows
        How many places there are across: in the element's own row, and in those beside it.

    Returns
    -------
    ndarray, (rows, n, n)
        Seen from the middle of an element, first index along x, over the element of the second one, so many rows apart.
    """
    from scipy.interpolate import CubicSpline

    x = edges[:, None] - 0.5 * (edges[1:] + edges[:-1])
    reach = np.log(np.abs(x))
    low, high = float(np.min(reach)), float(np.max(reach))
    places = np.linspace(low, high, max(16, math.ceil((high - low) / SLICE_STEP)))
    corner = _corners(kernel, np.exp(places)[:, None], (np.arange(rows + 1) - 0.5) * across)
    strips = CubicSpline(places, np.diff(corner, axis=1))(reach)  # up to x, odd in it
    return np.asarray(np.diff(np.sign(x)[..., None] * strips, axis=0).transpose(2, 1, 0))


def from_corners(corner: Callable[[Array, Array], Array], shape: tuple[int, int], pixel: tuple[float, float]) -> Array:
    """Return the integral over the pixel around (0, 0), seen from (i dx, j dy), of what `corner` integrates from zero.

    Parameters
    ----------
    corner
        The integral over the rectangle from (0, 0) to (x, y), of places x ``(n, 1)`` and y ``(m,)``.
    shape
        How many places.
    pixel
        (dx, dy).
    """
    x, y = ((np.arange(count + 1) - 0.5) * side for count, side in zip(shape, pixel, strict=True))
    corners = corner(x[:, None], y)
    return np.asarray(corners[1:, 1:] - corners[:-1, 1:] - corners[1:, :-1] + corners[:-1, :-1])


def love(x: Array, y: Array) -> Array:
    """Return pi times the displacement by Love of E* at the corner of a rectangle under a unit pressure."""
    return np.asarray(x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y)))


def transformed(quarter: Array, padded: tuple[int, int], parity: tuple[int, int] = (1, 1), workers: int = 1) -> Array:
    """Return the transform of a kernel that is known at positive places; over i if it is odd in one direction.

    Parameters
    ----------
    quarter : ndarray, (nx, ny)
    padded
        Number of places around which it is wrapped.
    parity
        One for each direction in which it is even, minus one for each in which it is odd.
    workers
        Threads.
    """
    import scipy.fft

    (nx, ny), (mx, my) = quarter.shape, padded
    if parity[0] < 0:
        quarter[0] = 0.0
    if parity[1] < 0:
        quarter[:, 0] = 0.0
    whole = np.zeros(padded)
    whole[:nx, :ny] = quarter
    whole[mx - nx + 1 :, :ny] = parity[0] * quarter[:0:-1]
    whole[:, my - ny + 1 :] = parity[1] * whole[:, ny - 1 : 0 : -1]
    transform = scipy.fft.rfft2(whole, workers=workers)
    return np.ascontiguousarray(transform.real if parity[0] == parity[1] else transform.imag)


def _gauss(spline: object, x: Array, y: Array, pixel: tuple[float, float], count: int) -> Array:
    """Return integrals over the pixels around these places."""
    node, weight = gauss_legendre(count)
    total = np.zeros(x.shape)
    for a, wa in zip(node - 0.5, weight, strict=True):
        for b, wb in zip(node - 0.5, weight, strict=True):
            square = (x + a * pixel[0]) ** 2 + (y + b * pixel[1]) ** 2
            total += wa * wb * spline(np.log(square))  # type: ignore[operator]
    return np.asarray(pixel[0] * pixel[1] * total)


def _far_spline(kernel: RadialPart, nearest: float, farthest: float) -> object:
    """Return k as a function of log r^2, between these distances and a little farther."""
    from scipy.interpolate import CubicSpline

    low, high = 2.0 * math.log(FAR_MARGIN * nearest), 2.0 * math.log(1.1 * farthest)
    places = np.linspace(low, high, max(16, math.ceil((high - low) / (2.0 * SPLINE_STEP))))
    return CubicSpline(places, kernel.at(np.exp(0.5 * places)))


def _corners(kernel: RadialPart, x: Array, y: Array) -> Array:
    """Return I(x, y), odd in both, on a grid of x ``(n, 1)`` and y ``(m,)``."""
    wide, high = np.abs(x), np.abs(y)[None, :]
    return np.asarray(np.sign(x) * np.sign(y) * (_sector(kernel, wide, high) + _sector(kernel, high, wide)))


def _sector(kernel: RadialPart, x: Array, y: Array) -> Array:
    """Return the integral of k over the triangle below the diagonal of a rectangle."""
    node, weight = gauss_legendre(CORNER_NODES)
    reach = np.arcsinh(y / x)
    stretch = np.cosh(reach[..., None] * node)
    return np.asarray(reach * ((kernel.within(x[..., None] * stretch) / stretch) @ weight))
