"""The autocorrelation of heights on a grid, and how far along every direction it falls to a level."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.numerics.types import Array

STEPS_PER_PIXEL = 4.0
"""Samples of a ray in a pixel."""


def autocorrelation(heights: Array, *, periodic: bool) -> Array:
    """Return the autocorrelation over shifts of up to half a map; one in the middle.

    Parameters
    ----------
    heights
        (nx, ny); nan where missing: pairs with a missing height do not count.
    periodic
        Whether shifts go round; otherwise only what overlaps counts.

    Returns
    -------
    ndarray, (2 (nx // 2) + 1, 2 (ny // 2) + 1)
    """
    import scipy.fft

    known = np.isfinite(heights)
    z = np.where(known, heights - np.mean(heights[known]), 0.0)
    halves = [n // 2 for n in z.shape]
    shape = z.shape
    if not periodic:
        shape = tuple(scipy.fft.next_fast_len(n + half, real=True) for n, half in zip(z.shape, halves, strict=True))

    def products(of: Array) -> Array:
        waves = np.abs(scipy.fft.rfft2(of, shape)) ** 2
        shifted: Array = scipy.fft.irfft2(waves, shape)
        for axis, half in enumerate(halves):
            shifted = np.take(shifted, np.arange(-half, half + 1), axis=axis, mode="wrap")
        return shifted

    sums = products(z)
    if periodic and known.all():
        pairs: Array = np.full_like(sums, float(z.size))
    else:
        pairs = np.round(products(known.astype(float)))
    middle = tuple(halves)
    mean = np.divide(sums, pairs, out=np.zeros_like(sums), where=pairs > 0.0)
    return np.asarray(mean / mean[middle])


def rays(correlation: Array, pixel: tuple[float, float], angles: Array) -> Iterator[tuple[Array, Array]]:
    """Yield distances from the middle [m], and the autocorrelation there, in every direction.

    Parameters
    ----------
    correlation
        As `autocorrelation` returns it.
    pixel
        Sides of a pixel [m].
    angles
        Directions [rad] from x towards y.
    """
    from scipy.ndimage import map_coordinates, spline_filter

    middle = np.array([(n - 1) / 2.0 for n in correlation.shape])
    smooth = spline_filter(correlation, order=3, mode="mirror")
    for angle in angles:
        along = np.array([np.cos(angle) / pixel[0], np.sin(angle) / pixel[1]])  # pixels in a metre
        with np.errstate(divide="ignore"):
            reach = float(np.min(middle / np.abs(along)))
        distance = np.linspace(0.0, reach, max(2, int(STEPS_PER_PIXEL * reach * np.max(np.abs(along))) + 1))
        places = middle[:, None] + along[:, None] * distance
        yield distance, map_coordinates(smooth, places, order=3, mode="mirror", prefilter=False)


def fall_distances(correlation: Array, pixel: tuple[float, float], level: float, angles: Array) -> Array:
    """Return how far from the middle the autocorrelation first falls to a level; infinite where it does not.

    Parameters
    ----------
    correlation, pixel, angles
        As for `rays`.
    level
        From 0 to 1.

    Returns
    -------
    ndarray, as `angles`
        [m]
    """
    found = np.full(angles.shape, np.inf)
    for place, (distance, ray) in enumerate(rays(correlation, pixel, angles)):
        below = np.flatnonzero(ray <= level)
        if below.size:
            i = int(below[0])
            share = (ray[i - 1] - level) / (ray[i - 1] - ray[i])
            found[place] = distance[i - 1] + share * (distance[i] - distance[i - 1])
    return found
