r"""Over which distance the heights of a map are correlated, in the direction of the fastest and of the slowest fall.

It is :math:`\langle z(\mathbf r)\,z(\mathbf r+\mathbf s)\rangle/\langle z^2\rangle` over what overlaps.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.transforms.autocorrelation import autocorrelation, fall_distances
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

CORRELATION_LEVEL = 0.2
"""Autocorrelation at which lengths are read (ISO 25178-2)."""
DIRECTIONS = 180
"""Over half a turn."""


@value
class CorrelationLengths:
    """Autocorrelation lengths of a height map (ISO 25178-2).

    Parameters
    ----------
    shortest : float
        Distance at which the autocorrelation has fallen to 0.2 in the direction of the fastest decrease [m], Sal.
    longest : float
        The same distance in the direction of the slowest decrease [m]; infinite if 0.2 is not reached within half a
        map.
    direction : float
        Direction of the slowest decrease (the lay) [rad], from x towards y, 0 to pi.
    """

    __words__ = words(
        shortest=("Sal", "m", "distance of the fastest fall of the autocorrelation to 0.2"),
        longest=("s_{max}", "m", "distance of the slowest fall of the autocorrelation to 0.2"),
        direction=(r"\varphi", "rad", "direction of the slowest fall of the autocorrelation, from x towards y"),
        aspect=("Str", "", "fastest over slowest distance: 1 of isotropic, 0 of ground surfaces"),
    )

    shortest: float
    longest: float
    direction: float

    @property
    def aspect(self) -> float:
        """Shortest over longest correlation length [-], Str: near 1 for isotropic surfaces, 0 for grooves; nan if no
        correlation decays.
        """
        return self.shortest / self.longest if math.isfinite(self.shortest) else math.nan


def correlation_lengths(surface: Topography) -> CorrelationLengths:
    """Return the autocorrelation lengths of a map, evaluated in 180 directions.

    Remove the trend first: ``surface.detrended(1)``.  Missing heights are omitted.  On a map with few hills the
    lengths describe these hills and are not representative of the surface.

    Parameters
    ----------
    surface : Topography
        The height map.

    Raises
    ------
    InvalidInput
        If the map is flat.

    Examples
    --------
    >>> x = np.arange(64) / 64
    >>> grooves = Topography(np.cos(16.0 * np.pi * x)[:, None] + 0.0 * x, [1.0, 1.0], periodic=True)
    >>> found = correlation_lengths(grooves)  # cos(16 pi s) = 0.2
    >>> round(found.shortest, 4), found.longest, found.aspect, round(found.direction / np.pi, 3)
    (0.0272, inf, 0.0, 0.5)
    """
    if surface.rms_height == 0.0:
        raise InvalidInput("correlation_lengths: a flat map has no correlation; its heights do not differ.")
    angles = np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    scaled = surface.heights / surface.rms_height  # of any unit of length
    distances = fall_distances(
        autocorrelation(scaled, periodic=surface.periodic), surface.pixel, CORRELATION_LEVEL, angles
    )
    slowest = distances == np.max(distances)
    mean = 0.5 * float(np.angle(np.sum(np.exp(2j * angles[slowest]))))  # a direction and its opposite are one
    return CorrelationLengths(float(np.min(distances)), float(np.max(distances)), mean % math.pi)
