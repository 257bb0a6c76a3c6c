r"""The cone, f = r / tan(half_angle), on a homogeneous half-space of modulus E* [1]_ [2]_.

.. math:: d = \frac\pi2\,\frac{a}{\tan\theta},\qquad F = \frac{\pi}{2}\frac{E^*a^2}{\tan\theta},\qquad
          p = \frac{E^*}{2\tan\theta}\,\mathrm{arcosh}\frac ar .

The arguments are the contact radius ``radius`` a [m], the distance ``r`` from the axis [m], ``half_angle`` from the
axis [rad], and ``modulus`` E* [Pa].

References
----------
.. [1] A. E. H. Love, Boussinesq's problem for a rigid cone, Quart. J. Math. 10 (1939) 161-175,
   doi:10.1093/qmath/os-10.1.161.
.. [2] I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57, doi:10.1016/0020-7225(65)90019-4.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike


def equal_area_angle(area_coefficient: float) -> float:
    """Return the half-angle [rad] of the cone with the cross-section A = area_coefficient * height^2.

    Examples
    --------
    A Vickers pyramid, 68 degrees from the axis to its faces:

    >>> import math
    >>> round(math.degrees(equal_area_angle(4.0 * math.tan(math.radians(68.0)) ** 2)), 4)
    70.2996
    """
    return float(np.arctan(np.sqrt(area_coefficient / np.pi)))


def cone_depth(radius: ArrayLike, *, half_angle: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a cone."""
    return np.asarray(0.5 * np.pi / np.tan(half_angle) * np.asarray(radius, dtype=float))


def cone_force(radius: ArrayLike, *, half_angle: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a cone."""
    return np.asarray(0.5 * np.pi * modulus / np.tan(half_angle) * np.asarray(radius, dtype=float) ** 2)


def cone_pressure(r: ArrayLike, radius: ArrayLike, *, half_angle: float, modulus: float) -> Array:
    """Return the pressure p(r) [Pa] under a cone: infinite (logarithmically) at the tip, zero outside."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    away = np.where(r > 0.0, np.minimum(r, a), a)
    # arcosh(a/r) = ln((a + w)/r) with w = sqrt(a^2 - r^2): written so that it keeps its digits at the edge
    w = np.sqrt((a - away) * (a + away))
    shape = np.where(r > 0.0, np.log1p((a - away + w) / away), np.inf)
    return np.asarray(0.5 * modulus / np.tan(half_angle) * shape)


def cone_displacement(r: ArrayLike, radius: ArrayLike, *, half_angle: float) -> Array:
    """Return the surface displacement u(r) [m] of a cone: d - f inside, the closed form of T3 outside.

    Outside, u = (a/tan) [asin(a/r) - (r - sqrt(r^2 - a^2))/a].
    """
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    beyond = np.maximum(r, a)
    root = np.sqrt((beyond - a) * (beyond + a))
    outside = np.arctan2(a, root) - a / (beyond + root)
    return np.asarray(np.where(r < a, 0.5 * np.pi * a - r, a * outside) / np.tan(half_angle))
