r"""Numbers by which surfaces are compared: heights, slopes, bearing curve and autocorrelation of a height map.

Heights and slopes follow ISO 25178-2, without its filters: nothing is taken off but the mean.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.profiles.rough.correlation import CORRELATION_LEVEL, correlation_lengths
from winkler.profiles.rough.tip_limit import tip_limit
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class MapStatistics:
    """Surface texture parameters of a height map (ISO 25178-2).

    Parameters
    ----------
    arithmetic_height : float
        Mean distance of the heights from their mean [m], Sa.
    rms_height : float
        Root mean square of the heights about their mean [m], Sq.
    skewness, kurtosis : float
        Ssk and Sku [-]; zero and three of Gaussian heights.
    peak_height, valley_depth : float
        Highest peak above and deepest valley below the mean [m], Sp and Sv.
    rms_slope : float
        Root mean square of the gradient [-], Sdq.
    developed_share : float
        Relative increase of the surface area over the area of the map [-], Sdr.
    rms_curvature : float
        Root mean square of the mean curvature [1/m], from second differences of neighbours; nan if there are none.
    correlation_length, texture_aspect, texture_direction : float
        Sal [m], Str [-] and the direction of the lay [rad] from x towards y, as in `CorrelationLengths`.
    tip_limit : float
        Length below which the map is rounded by the tip [m]; zero if it is not rounded, or the tip radius is not
        known.
    topography : Topography
        The map, which `winkler.plot.draw` shows with its curves.
    """

    __words__ = words(
        arithmetic_height=("Sa", "m", "mean distance of the heights from their mean"),
        rms_height=("Sq", "m", "root mean square of the heights about their mean"),
        skewness=("Ssk", "", "mean cube of the heights over that of their root mean square"),
        kurtosis=("Sku", "", "mean fourth power of the heights over that of their root mean square"),
        peak_height=("Sp", "m", "highest peak above the mean"),
        valley_depth=("Sv", "m", "deepest valley below the mean"),
        rms_slope=("Sdq", "", "root mean square of the gradient"),
        developed_share=("Sdr", "", "area along the surface over that of the map, less one"),
        rms_curvature=(r"\kappa_\mathrm{rms}", "1/m", "root mean square of the mean curvature"),
        correlation_length=("Sal", "m", "distance of the fastest fall of the autocorrelation to 0.2"),
        texture_aspect=("Str", "", "fastest over slowest of these distances: 1 of isotropic, 0 of ground surfaces"),
        texture_direction=(r"\varphi", "rad", "direction of the slowest fall of the autocorrelation, from x towards y"),
        tip_limit=(r"\lambda_t", "m", "length below which the tip has rounded a map"),
    )

    arithmetic_height: float
    rms_height: float
    skewness: float
    kurtosis: float
    peak_height: float
    valley_depth: float
    rms_slope: float
    developed_share: float
    rms_curvature: float
    correlation_length: float
    texture_aspect: float
    texture_direction: float
    tip_limit: float
    topography: Topography


def map_statistics(surface: Topography) -> MapStatistics:
    """Return heights and slopes of a map by the names of ISO 25178-2; missing heights are omitted.

    The gradient is that of the two triangles of each square of four neighbours; squares with a missing height do not
    count.  Remove spikes and trend first: ``surface.without_spikes().detrended(1)``.

    Parameters
    ----------
    surface : Topography
        The height map.

    Raises
    ------
    InvalidInput
        If the map is flat, or no square of four neighbours is complete.

    Examples
    --------
    >>> x = np.arange(256) / 256 * 1e-3
    >>> wave = Topography(1e-6 * np.cos(2.0 * np.pi * x[:, None] / 1e-3) + 0.0 * x, [1e-3, 1e-3], periodic=True)
    >>> found = map_statistics(wave)
    >>> round(found.arithmetic_height * 1e6, 3), round(found.kurtosis, 3)
    (0.637, 1.5)
    """
    from_mean = surface.heights - np.nanmean(surface.heights)
    skewness, kurtosis = surface.skewness, surface.kurtosis  # refuse flat maps
    texture = correlation_lengths(surface)
    squares = _squared_slopes(surface)
    if not squares.size:
        raise InvalidInput("map_statistics: no four neighbouring heights are there; use surface.filled() first.")
    return MapStatistics(
        float(np.nanmean(np.abs(from_mean))),
        surface.rms_height,
        skewness,
        kurtosis,
        float(np.nanmax(from_mean)),
        -float(np.nanmin(from_mean)),
        float(np.sqrt(np.mean(squares))),
        float(np.mean(squares / (1.0 + np.sqrt(1.0 + squares)))),  # sqrt(1 + s) - 1 without cancellation
        _rms_curvature(surface),
        *(texture.shortest, texture.aspect, texture.direction),
        tip_limit(surface),
        surface,
    )


def _rms_curvature(surface: Topography) -> float:
    """Return the root mean square of half the Laplacian, from five neighbouring points."""
    heights, total = surface.heights, np.zeros(1)
    for axis, step in enumerate(surface.pixel):
        if surface.periodic:
            total = total + (np.roll(heights, 1, axis) - 2.0 * heights + np.roll(heights, -1, axis)) / step**2
        elif min(heights.shape) > 2:
            total = total + np.diff(heights, 2, axis)[(slice(None), slice(1, -1))[:: 1 - 2 * axis]] / step**2
    known = np.ravel(total)[np.isfinite(np.ravel(total))]
    return 0.5 * float(np.sqrt(np.mean(known**2))) if known.size and min(heights.shape) > 2 else math.nan


def _squared_slopes(surface: Topography) -> Array:
    """Return the squared gradients of all triangles, whose corners are three of four neighbours."""
    heights = surface.heights
    if surface.periodic:
        heights = np.pad(heights, ((0, 1), (0, 1)), mode="wrap")
    a, b, c, d = heights[:-1, :-1], heights[1:, :-1], heights[:-1, 1:], heights[1:, 1:]
    dx, dy = surface.pixel
    both = np.stack([((b - a) / dx) ** 2 + ((c - a) / dy) ** 2, ((d - c) / dx) ** 2 + ((d - b) / dy) ** 2])
    return np.asarray(both[:, np.isfinite(both).all(axis=0)])


def bearing_heights(surface: Topography, shares: ArrayLike) -> Array:
    """Return heights of the Abbott-Firestone curve: a given share of the map lies above each height [m].

    Parameters
    ----------
    surface : Topography
        The height map; missing heights are omitted.
    shares : array_like
        From 0 to 1.

    Raises
    ------
    InvalidInput
        If a share is not from 0 to 1.
    """
    wanted = np.asarray(shares, dtype=float)
    if not np.all((wanted >= 0.0) & (wanted <= 1.0)):
        raise InvalidInput("bearing_heights: a share is not from 0 to 1; give parts of the map.")
    from_mean = surface.heights - np.nanmean(surface.heights)
    return np.asarray(np.nanquantile(from_mean, 1.0 - wanted))


def correlation_length(surface: Topography) -> float:
    """Return the distance [m] at which the autocorrelation, mean over all directions, has fallen to 0.2.

    It is computed by SurfaceTopography (extra ``topography``).  ISO 25178-2 uses the direction of the fastest decrease
    instead (Sal); for isotropic surfaces both agree.

    Parameters
    ----------
    surface : Topography
        The height map, complete.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed, heights are missing, the map is flat, or the autocorrelation does not
        fall to 0.2 within the map.
    """
    if surface.missing:
        raise InvalidInput(f"correlation_length: {surface.missing} heights are missing; use surface.filled() first.")
    if surface.rms_height == 0.0:
        raise InvalidInput("correlation_length: a flat map has no correlation; its heights do not differ.")
    try:
        import SurfaceTopography
    except ImportError:
        raise InvalidInput(
            'correlation_length: it needs SurfaceTopography; install it by pip install "winkler[topography]".'
        ) from None
    lengths = float(surface.lengths[0]), float(surface.lengths[1])
    unit = surface.rms_height  # of any unit of length
    heights = (surface.heights - float(np.mean(surface.heights))) / unit
    stored = SurfaceTopography.Topography(heights, lengths, periodic=surface.periodic)
    found = stored.autocorrelation_from_area(collocation="linear", nb_points=max(heights.shape) // 2, reliable=False)
    distance: Array = np.ma.filled(np.ma.asarray(found[0], dtype=float), np.nan)
    half_square: Array = np.ma.filled(np.ma.asarray(found[1], dtype=float), np.nan)
    correlation = 1.0 - half_square  # it is half of the mean square of differences, of unit variance
    good = np.isfinite(correlation) & (distance > 0.0)
    distance, correlation = np.append(0.0, distance[good]), np.append(1.0, correlation[good])
    below = np.flatnonzero(correlation <= CORRELATION_LEVEL)
    if not below.size:
        raise InvalidInput(
            "correlation_length: the heights are correlated over all of the map; subtract its trend by "
            "surface.detrended(1), or give a larger map."
        )
    i = int(below[0])
    share = (correlation[i - 1] - CORRELATION_LEVEL) / (correlation[i - 1] - correlation[i])
    return float(distance[i - 1] + share * (distance[i] - distance[i - 1]))
