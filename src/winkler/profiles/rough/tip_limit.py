r"""Below which length a tip has rounded a scanned map.

A ball of radius R cannot follow what is more sharply curved upwards than itself.  Second differences of measured
heights over a distance s therefore stay above -1/R; where they come near it, :math:`\min h''(s) < -1/(2R)`, the map is
that of the tip.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.rough.topography import Topography

SANNER = (
    "A. Sanner, W. G. Noehring, L. A. Thimons, T. D. B. Jacobs, L. Pastewka, Appl. Surf. Sci. Adv. 7 (2022) 100190, "
    "doi:10.1016/j.apsadv.2021.100190"
)
SAFETY = 0.5
"""Part of the curvature of the tip at which its rounding begins to show (Sanner and others)."""
DISTANCES = 48
"""At which the limit is looked for, from two pixels to half a map."""


class CurvatureOverDistance(NamedTuple):
    """Second differences of heights over many distances.

    Parameters
    ----------
    distance : ndarray, (n,)
        From the first to the last of three places [m].
    rms : ndarray, (n,)
        Root mean square along both directions [1/m].
    sharpest : ndarray, (n,)
        Of the sharpest summit [1/m], positive upwards; at most 1/R of what a tip of radius R has scanned.
    """

    distance: Array
    rms: Array
    sharpest: Array


def curvature_over_distance(surface: Topography, count: int = 24) -> CurvatureOverDistance:
    """Return second differences of the heights along both directions, over distances up to half a map.

    Parameters
    ----------
    surface : Topography
        The height map; missing heights are left out.
    count : int, optional
        Of distances, equally far apart on a logarithmic axis.
    """
    rows = np.array(list(_curvatures(surface, count))).reshape(-1, 3)
    return CurvatureOverDistance(*(np.asarray(part) for part in rows.T))


def _curvatures(surface: Topography, count: int) -> Iterator[tuple[float, float, float]]:
    """Yield distance, root mean square and greatest curvature, from two pixels on."""
    step = max(surface.pixel)
    most = max(1, int(np.min(surface.lengths) / (4.0 * step)))
    for half in np.unique(np.round(np.geomspace(1, most, count)).astype(int)).tolist():
        squares, number, sharpest = 0.0, 0, -math.inf
        for axis, pixel in enumerate(surface.pixel):
            heights: Array = np.moveaxis(surface.heights, axis, 0)
            apart = max(1, round(half * step / pixel))
            if surface.periodic:
                bent = np.roll(heights, apart, 0) - 2.0 * heights + np.roll(heights, -apart, 0)
            else:
                bent = heights[2 * apart :] - 2.0 * heights[apart:-apart] + heights[: -2 * apart]
            bent = bent[np.isfinite(bent)] / (apart * pixel) ** 2
            squares, number = squares + float(np.sum(bent**2)), number + bent.size
            sharpest = max(sharpest, float(-np.min(bent, initial=math.inf)))
        if number:
            yield 2.0 * half * step, math.sqrt(squares / number), sharpest


def tip_limit(surface: Topography) -> float:
    """Return the length [m] below which a map is rounded by the tip; zero if it is not, or the tip is unknown.

    Parameters
    ----------
    surface : Topography
        The height map, with the radius of its tip; missing heights are omitted.

    References
    ----------
    A. Sanner, W. G. Noehring, L. A. Thimons, T. D. B. Jacobs, L. Pastewka, Appl. Surf. Sci. Adv. 7 (2022) 100190,
    doi:10.1016/j.apsadv.2021.100190
    """
    if surface.tip_radius == 0.0:
        return 0.0
    allowed = SAFETY / surface.tip_radius
    before: tuple[float, float] | None = None
    for distance, _, sharpest in _curvatures(surface, DISTANCES):
        if sharpest <= allowed:
            if before is None:
                return 0.0
            last, sharper = before  # curvatures are a power of the distance between two
            if sharpest <= 0.0:
                return distance
            return last * math.pow(distance / last, math.log(sharper / allowed) / math.log(sharper / sharpest))
        before = distance, sharpest
    return float(np.min(surface.lengths)) if before else 0.0


def share_below(surface: Topography, length: float) -> float:
    """Return the part of the mean square slope that lies below a length: what slopes over this length lack.

    Parameters
    ----------
    surface : Topography
        The height map; missing heights are left out.
    length : float
        [m]
    """
    return 1.0 - _mean_square_slope(surface, length) / _mean_square_slope(surface, 0.0)


def _mean_square_slope(surface: Topography, length: float) -> float:
    total = 0.0
    for axis, step in enumerate(surface.pixel):
        heights: Array = np.moveaxis(surface.heights, axis, 0)
        apart = min(max(1, round(length / step)), heights.shape[0] - 1)
        later = np.roll(heights, -apart, 0) if surface.periodic else heights[apart:]
        total += float(np.nanmean(((later - heights[: later.shape[0]]) / (apart * step)) ** 2))
    return total
