r"""Sphere, ellipsoid and hyperboloid with their exact shapes, on a homogeneous half-space of modulus E* [1]_ [2]_.

Sphere f = R - sqrt(R^2 - r^2):

.. math:: d = a\,\mathrm{artanh}\frac aR,\qquad
          F = E^*\Bigl[\tfrac12(R^2+a^2)\ln\frac{R+a}{R-a} - aR\Bigr].

An ellipsoid of revolution (semi-axes A in the plane, B along the axis) is the sphere of radius A times B/A; the
hyperboloid c (sqrt(1 + r^2/A^2) - 1) has d = (c/A) a atan(a/A).  For small a/R the brackets cancel; there the
power series is summed.

The arguments are the contact radius ``radius`` a [m], the distance ``r`` from the axis [m], ``modulus`` E* [Pa], of
the sphere ``curvature_radius`` R [m], of the ellipsoid ``radial_semi_axis`` A and ``axial_semi_axis`` B [m], and of
the hyperboloid ``curvature_radius`` R = A^2/c at the apex [m] and ``half_angle`` of the asymptotic cone, from the
axis [rad]: c/A = 1/tan(half_angle).

References
----------
.. [1] C. M. Segedin, The relation between load and penetration for a spherical punch, Mathematika 4 (1957) 156-161,
   doi:10.1112/S002557930000120X.
.. [2] I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57, doi:10.1016/0020-7225(65)90019-4.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike

SERIES_LIMIT = 0.25
"""Below this a/R the series is summed: its terms fall by 1/16, the closed forms lose a factor of 1/SMALL^2."""
SERIES_POWERS = np.arange(16)


def _force_series(ratio: Array, sign: float) -> Array:
    """Return sum over k of sign^k 2 (2k+2)/((2k+1)(2k+3)) ratio^(2k+3)."""
    weights = (
        sign**SERIES_POWERS
        * 2.0
        * (2.0 * SERIES_POWERS + 2.0)
        / ((2.0 * SERIES_POWERS + 1.0) * (2.0 * SERIES_POWERS + 3.0))
    )
    return np.asarray(ratio[..., None] ** (2 * SERIES_POWERS + 3) @ weights)


def sphere_depth(radius: ArrayLike, *, curvature_radius: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a sphere, a < R.

    Examples
    --------
    >>> round(float(sphere_depth(0.5, curvature_radius=1.0)), 15)
    0.274653072167027
    """
    a = np.asarray(radius, dtype=float)
    return np.asarray(a * np.arctanh(a / curvature_radius))


def sphere_force(radius: ArrayLike, *, curvature_radius: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a sphere, a < R."""
    t = np.asarray(radius, dtype=float) / curvature_radius
    small = t < SERIES_LIMIT
    closed = (1.0 + t**2) * np.arctanh(t) - t
    shape = np.where(small, _force_series(np.where(small, t, 0.0), 1.0), closed)
    return np.asarray(modulus * curvature_radius**2 * shape)


def sphere_displacement(r: ArrayLike, radius: ArrayLike, *, curvature_radius: float) -> Array:
    """Return the surface displacement u(r) [m] of a sphere: d - f inside, the closed form of T3 outside.

    With w = sqrt(r^2 - a^2) and S = sqrt(R^2 - r^2) (imaginary beyond r = R, where atan turns into artanh),
    u = (2/pi) [(d - R) asin(a/r) + w artanh(a/R) + S atan(S a/(R w))].  The terms are of order a, their sum
    is of order a^2/R.
    """
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    big = curvature_radius
    beyond = np.maximum(r, a)
    w = np.sqrt((beyond - a) * (beyond + a))
    real = np.sqrt(np.maximum((big - beyond) * (big + beyond), 0.0))
    imaginary = np.sqrt(np.maximum((beyond - big) * (beyond + big), 0.0))
    far = imaginary > 0.0
    last = np.where(
        far,
        -imaginary * np.arctanh(np.where(far, imaginary * a, 0.0) / np.where(far, big * w, 1.0)),
        real * np.arctan2(real * a, big * w),
    )
    rise = np.arctanh(a / big)
    outside = 2.0 / np.pi * ((a * rise - big) * np.arctan2(a, w) + w * rise + last)
    near = np.minimum(r, a)
    inside = a * rise - near**2 / (big + np.sqrt((big - near) * (big + near)))
    return np.asarray(np.where(r < a, inside, outside))


def ellipsoid_depth(radius: ArrayLike, *, radial_semi_axis: float, axial_semi_axis: float) -> Array:
    """Return the depth d(a) = g(a) [m] of an ellipsoid of revolution, a < A."""
    stretched = axial_semi_axis / radial_semi_axis
    return np.asarray(stretched * sphere_depth(radius, curvature_radius=radial_semi_axis))


def ellipsoid_force(radius: ArrayLike, *, radial_semi_axis: float, axial_semi_axis: float, modulus: float) -> Array:
    """Return the force F(a) [N] on an ellipsoid of revolution, a < A."""
    stretched = axial_semi_axis / radial_semi_axis
    return np.asarray(stretched * sphere_force(radius, curvature_radius=radial_semi_axis, modulus=modulus))


def ellipsoid_displacement(
    r: ArrayLike, radius: ArrayLike, *, radial_semi_axis: float, axial_semi_axis: float
) -> Array:
    """Return the surface displacement u(r) [m] of an ellipsoid of revolution."""
    stretched = axial_semi_axis / radial_semi_axis
    return np.asarray(stretched * sphere_displacement(r, radius, curvature_radius=radial_semi_axis))


def hyperboloid_depth(radius: ArrayLike, *, curvature_radius: float, half_angle: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a hyperboloid of revolution."""
    a = np.asarray(radius, dtype=float)
    rise = 1.0 / np.tan(half_angle)
    return np.asarray(rise * a * np.arctan(a / (curvature_radius * rise)))


def hyperboloid_force(radius: ArrayLike, *, curvature_radius: float, half_angle: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a hyperboloid: (E* c/A) [(a^2 - A^2) atan(a/A) + a A]."""
    rise = 1.0 / np.tan(half_angle)
    scale = curvature_radius * rise
    t = np.asarray(radius, dtype=float) / scale
    small = t < SERIES_LIMIT
    closed = (t - 1.0) * (t + 1.0) * np.arctan(t) + t
    shape = np.where(small, _force_series(np.where(small, t, 0.0), -1.0), closed)
    return np.asarray(modulus * rise * scale**2 * shape)


def hyperboloid_displacement(r: ArrayLike, radius: ArrayLike, *, curvature_radius: float, half_angle: float) -> Array:
    """Return the surface displacement u(r) [m] of a hyperboloid: d - f inside, the closed form of T3 outside.

    With w = sqrt(r^2 - a^2) and S = sqrt(r^2 + A^2),
    u = (2/pi) (c/A) [a atan(a/A) asin(a/r) + w atan(a/A) - S atan(S a/(A w)) + A asin(a/r)].
    """
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    rise = 1.0 / np.tan(half_angle)
    scale, beyond = curvature_radius * rise, np.maximum(r, a)
    w, slant = np.sqrt((beyond - a) * (beyond + a)), np.hypot(beyond, scale)
    turn, view_angle = np.arctan(a / scale), np.arctan2(a, w)
    outside = 2.0 / np.pi * ((a * turn + scale) * view_angle + w * turn - slant * np.arctan2(slant * a, scale * w))
    inside = a * turn - r**2 / (scale + np.hypot(r, scale))
    return np.asarray(rise * np.where(r < a, inside, outside))
