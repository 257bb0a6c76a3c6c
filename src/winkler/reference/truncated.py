r"""Shapes with a flat end and a kink at r = b: truncated cone and truncated paraboloid [1]_ [2]_.

Their plane profiles are made of two functions that vanish for x < b,

.. math:: S(x) = x\sqrt{x^2-b^2},\qquad C(x) = x\arccos\frac bx ,

and so are forces, displacements and, where elliptic integrals close them, pressures; the pressure of a kinked
shape is logarithmically infinite at r = b.

The arguments are the contact radius ``radius`` a [m], the distance ``r`` from the axis [m], ``modulus`` E* [Pa],
``flat_radius`` b [m], of the cone ``half_angle`` from the axis [rad], and of the paraboloid ``curvature_radius`` R
[m].

References
----------
.. [1] G. Ejike, The stress on an elastic half-space due to sectionally smooth-ended punch, J. Elasticity 11 (1981)
   395-402.
.. [2] D. Maugis, M. Barquins, Adhesive contact of sectionally smooth-ended punches on elastic half-spaces: theory
   and experiment, J. Phys. D: Appl. Phys. 16 (1983) 1843-1863, doi:10.1088/0022-3727/16/10/010.
"""

from __future__ import annotations

import numpy as np
from scipy.special import ellipeinc, ellipkinc

from winkler.numerics.types import Array, ArrayLike


def leg(x: ArrayLike, b: float) -> Array:
    """Return sqrt(x^2 - b^2) beyond b, zero before."""
    far = np.maximum(np.asarray(x, dtype=float), b)
    return np.asarray(np.sqrt((far - b) * (far + b)))


def angle(x: ArrayLike, b: float) -> Array:
    """Return acos(b/x) beyond b, zero before, with its digits kept near b."""
    return np.asarray(np.arctan2(leg(x, b), b))


def outer_root(r: Array, a: Array, b: float) -> Array:
    """Return the integral of S(x)/sqrt(r^2 - x^2) from b to a [m^2], for r >= a >= b."""
    rise, rest = leg(a, b), np.sqrt(np.maximum((r - a) * (r + a), 0.0))
    return np.asarray(0.5 * ((r - b) * (r + b) * np.arctan2(rise, rest) - rise * rest))


def outer_arccos(r: Array, a: Array, b: float) -> Array:
    """Return the integral of C(x)/sqrt(r^2 - x^2) from b to a [m], for r >= a >= b."""
    rise, rest = leg(a, b), np.sqrt(np.maximum((r - a) * (r + a), 0.0))
    return np.asarray(r * np.arctan2(r * rise, b * rest) - b * np.arctan2(rise, rest) - rest * angle(a, b))


def truncated_cone_depth(radius: ArrayLike, *, half_angle: float, flat_radius: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a truncated cone, a acos(b/a)/tan(half_angle); zero up to the flat radius."""
    a = np.asarray(radius, dtype=float)
    return np.asarray(a * angle(a, flat_radius) / np.tan(half_angle))


def truncated_cone_force(radius: ArrayLike, *, half_angle: float, flat_radius: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a truncated cone."""
    a = np.asarray(radius, dtype=float)
    shape = a**2 * angle(a, flat_radius) + flat_radius * leg(a, flat_radius)
    return np.asarray(modulus / np.tan(half_angle) * shape)


def truncated_cone_displacement(r: ArrayLike, radius: ArrayLike, *, half_angle: float, flat_radius: float) -> Array:
    """Return the surface displacement u(r) [m] of a truncated cone, a > b."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    rise, beyond = 1.0 / np.tan(half_angle), np.maximum(r, a)
    depth = truncated_cone_depth(a, half_angle=half_angle, flat_radius=flat_radius)
    tail = rise * outer_arccos(beyond, a, flat_radius)
    outside = 2.0 / np.pi * (depth * np.arcsin(a / beyond) - tail)
    return np.asarray(np.where(r < a, depth - rise * np.maximum(r - flat_radius, 0.0), outside))


def truncated_paraboloid_depth(radius: ArrayLike, *, curvature_radius: float, flat_radius: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a truncated paraboloid, (a/R) sqrt(a^2 - b^2); zero up to the flat radius."""
    a = np.asarray(radius, dtype=float)
    return np.asarray(a * leg(a, flat_radius) / curvature_radius)


def truncated_paraboloid_force(
    radius: ArrayLike, *, curvature_radius: float, flat_radius: float, modulus: float
) -> Array:
    """Return the force F(a) [N] on a truncated paraboloid, (2E*/3R)(2a^2 + b^2) sqrt(a^2 - b^2)."""
    a = np.asarray(radius, dtype=float)
    shape = (2.0 * a**2 + flat_radius**2) * leg(a, flat_radius)
    return np.asarray(2.0 * modulus / (3.0 * curvature_radius) * shape)


def truncated_paraboloid_pressure(
    r: ArrayLike, radius: ArrayLike, *, curvature_radius: float, flat_radius: float, modulus: float
) -> Array:
    """Return the pressure p(r) [Pa] under a truncated paraboloid by incomplete elliptic integrals.

    With h = max(r, b), l = min(r, b), sin(phi)^2 = (a^2 - h^2)/(a^2 - l^2) and m = l^2/h^2, T4 gives
    p = (E*/(pi R)) [2 h (F - E) + 2 a sin(phi) - (b^2/h) F]; infinite at r = b, zero outside.
    """
    b = flat_radius
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    use = (r < a) & (a > b) & (r != b)
    high = np.where(use, np.maximum(r, b), 2.0 * a)
    low = np.where(use, np.minimum(r, b), a)
    outer = np.where(use, a, 2.0 * a)
    legs = np.sqrt((outer - high) * (outer + high)), np.sqrt((high - low) * (high + low))
    phi = np.arctan2(legs[0], legs[1])
    m = (low / high) ** 2
    first, second = ellipkinc(phi, m), ellipeinc(phi, m)
    shape = 2.0 * high * (first - second) + 2.0 * outer * np.sin(phi) - b**2 / high * first
    shape = np.where(use, shape, np.where((r == b) & (a > b), np.inf, 0.0))
    return np.asarray(modulus / (np.pi * curvature_radius) * shape)


def truncated_paraboloid_displacement(
    r: ArrayLike, radius: ArrayLike, *, curvature_radius: float, flat_radius: float
) -> Array:
    """Return the surface displacement u(r) [m] of a truncated paraboloid, a > b."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    depth = truncated_paraboloid_depth(a, curvature_radius=curvature_radius, flat_radius=flat_radius)
    beyond = np.maximum(r, a)
    tail = outer_root(beyond, a, flat_radius) / curvature_radius
    outside = 2.0 / np.pi * (depth * np.arcsin(a / beyond) - tail)
    return np.where(r < a, depth - leg(r, flat_radius) ** 2 / (2.0 * curvature_radius), outside)
