r"""Below which length a tip has rounded a scanned map.

A ball of radius R cannot follow what is more sharply curved upwards than itself.  Second differences of measured
heights over a distance s therefore stay above -1/R; where they come near it, :math:`\min h''(s) < -1/(2R)`, the map is
that of the tip.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array
from winkler.profiles.rough.topography import Topography

__all__ = ["SANNER", "share_below", "tip_limit"]

SANNER = (
    "A. Sanner, W. G. Noehring, L. A. Thimons, T. D. B. Jacobs, L. Pastewka, Appl. Surf. Sci. Adv. 7 (2022) 100190, "
    "doi:10.1016/j.apsadv.2021.100190"
)
LEAST_PIXELS = 8
"""Second differences over two distances need so many."""


def tip_limit(surface: Topography) -> float:
    """Return the length [m] below which the tip has rounded a map; zero if its radius is not known, or it has not.

    It is computed by SurfaceTopography (extra ``topography``), along both directions; the greater one counts.  It is as
    long as the map if everything is rounded.

    Parameters
    ----------
    surface : Topography
        The height map, complete, with the radius of its tip.

    Raises
    ------
    InvalidInput
        If SurfaceTopography is not installed, or heights are missing.

    References
    ----------
    A. Sanner, W. G. Noehring, L. A. Thimons, T. D. B. Jacobs, L. Pastewka, Appl. Surf. Sci. Adv. 7 (2022) 100190,
    doi:10.1016/j.apsadv.2021.100190
    """
    if surface.tip_radius == 0.0 or min(surface.heights.shape) < LEAST_PIXELS:
        return 0.0
    if surface.missing:
        raise InvalidInput(f"tip_limit: {surface.missing} heights are missing; take surface.filled() first.")
    try:
        import SurfaceTopography
    except ImportError:
        raise InvalidInput(
            'tip_limit: it needs SurfaceTopography; install it by pip install "winkler[topography]".'
        ) from None
    unit = max(surface.pixel)  # of any unit of length
    limits = []
    for heights, lengths in (
        (surface.heights, surface.lengths),
        (surface.heights.T, surface.lengths[::-1]),
    ):
        stored = SurfaceTopography.Topography(heights / unit, tuple(lengths / unit), periodic=surface.periodic)
        found = stored.scanning_probe_reliability_cutoff(surface.tip_radius / unit)
        limits.append(0.0 if found is None else float(found))
    return unit * max(limits)


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
