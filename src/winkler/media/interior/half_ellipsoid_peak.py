"""The greatest stress below a half-ellipsoid of pressure and traction, and its place."""

from __future__ import annotations

import functools

from winkler.media.interior.half_ellipsoid import half_ellipsoid_stresses
from winkler.media.interior.peak import StressSpot, greatest_around
from winkler.media.interior.tensor import Measure
from winkler.numerics.types import Array

__all__ = ["greatest_in_half_ellipsoid"]


@functools.lru_cache(maxsize=512)
def greatest_in_half_ellipsoid(
    measure: Measure, ratio: float, poisson: float, traction: tuple[float, float] = (0.0, 0.0)
) -> StressSpot:
    """Return the greatest of a stress over the greatest pressure, and its place over a, b, and the smaller of both.

    Parameters
    ----------
    measure
        Takes the tensor, returns what is compared.
    ratio : float
        b / a, of the semi-axes along y and x.
    poisson : float
    traction : tuple of float
        What drags the surface along x and y, over the pressure [-].
    """

    def values(x: Array, y: Array, z: Array) -> Array:
        return measure(half_ellipsoid_stresses(x, y, z, (1.0, ratio), poisson, traction))

    even = (traction[0] == 0.0, traction[1] == 0.0)
    spot = greatest_around(values, ratio=ratio, even=even)
    return StressSpot(spot.value, spot.x, spot.y / ratio, spot.z / min(1.0, ratio))
