r"""Shapes without a kink: flat punch with a rounded edge [1]_, cone with a parabolic [2]_ or spherical [3]_ tip.

Rounded edge and parabolic tip are made of the functions S and C of the truncated shapes; the tip joins the cone
with a common tangent at r = b.  The spherical tip, f' = r / sqrt(R^2 - r^2) up to b = R cos(half_angle) and
1/tan(half_angle) beyond, was integrated here: with m = sqrt(R^2 - b^2), n = sqrt(x^2 - b^2), for x > b

.. math:: g = x\ln\frac{R+x}{m+n} + \frac{x}{\tan\theta}\arccos\frac bx ,\qquad
          F = E^*\Bigl[(R^2+a^2)\ln\frac{R+a}{m+n} + mn - aR\Bigr]
              + \frac{E^*}{\tan\theta}\Bigl[a^2\arccos\frac ba + bn\Bigr]_{x=a}.

The arguments are the contact radius ``radius`` a [m], the distance ``r`` from the axis [m], ``modulus`` E* [Pa], of
the punch ``flat_radius`` b and ``edge_radius`` R [m], and of the cones ``curvature_radius`` R of the tip [m] and
``half_angle`` from the axis [rad].

References
----------
.. [1] M. Ciavarella, Indentation by nominally flat or conical indenters with rounded corners, Int. J. Solids
   Struct. 36 (1999) 4149-4181, doi:10.1016/S0020-7683(98)00188-7.
.. [2] D. Maugis, M. Barquins, J. Phys. D: Appl. Phys. 16 (1983) 1843-1863, doi:10.1088/0022-3727/16/10/010.
.. [3] B. J. Briscoe, K. S. Sebastian, M. J. Adams, The effect of indenter geometry on the elastic response to
   indentation, J. Phys. D: Appl. Phys. 27 (1994) 1156-1162, doi:10.1088/0022-3727/27/6/013.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.reference.sphere import sphere_depth, sphere_force
from winkler.reference.truncated import angle, leg, outer_arccos, outer_root, truncated_cone_depth, truncated_cone_force


def rounded_punch_depth(radius: ArrayLike, *, flat_radius: float, edge_radius: float) -> Array:
    """Return the depth d(a) = g(a) [m] of f = (r - b)^2/(2 R) beyond b, (a/R)[sqrt(a^2 - b^2) - b acos(b/a)].

    Zero up to the flat radius, near which the bracket cancels.
    """
    a, b = np.asarray(radius, dtype=float), flat_radius
    return np.asarray(a * (leg(a, b) - b * angle(a, b)) / edge_radius)


def rounded_punch_force(radius: ArrayLike, *, flat_radius: float, edge_radius: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a rounded punch, (E*/3R)[sqrt(a^2-b^2)(4a^2-b^2) - 3 a^2 b acos(b/a)].

    Beyond the flat radius.
    """
    a, b = np.asarray(radius, dtype=float), flat_radius
    shape = leg(a, b) * (4.0 * a**2 - b**2) - 3.0 * a**2 * b * angle(a, b)
    return np.asarray(modulus / (3.0 * edge_radius) * shape)


def rounded_punch_displacement(r: ArrayLike, radius: ArrayLike, *, flat_radius: float, edge_radius: float) -> Array:
    """Return the surface displacement u(r) [m] of a rounded punch, a > b."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    b, beyond = flat_radius, np.maximum(r, a)
    depth = rounded_punch_depth(a, flat_radius=b, edge_radius=edge_radius)
    tail = (outer_root(beyond, a, b) - b * outer_arccos(beyond, a, b)) / edge_radius
    outside = 2.0 / np.pi * (depth * np.arcsin(a / beyond) - tail)
    return np.where(r < a, depth - np.maximum(r - b, 0.0) ** 2 / (2.0 * edge_radius), outside)


def rounded_cone_depth(radius: ArrayLike, *, curvature_radius: float, half_angle: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a cone with a tangent parabolic tip, which ends at b = R/tan."""
    a, rise = np.asarray(radius, dtype=float), 1.0 / math.tan(half_angle)
    b = curvature_radius * rise
    # a/b - sqrt(a^2/b^2 - 1) = b/(a + sqrt(a^2 - b^2)); before b it is a/b
    tip = np.where(a > b, b / (np.maximum(a, b) + leg(a, b)), a / b)
    return np.asarray(rise * a * (tip + angle(a, b)))


def rounded_cone_force(radius: ArrayLike, *, curvature_radius: float, half_angle: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a cone with a tangent parabolic tip; Hertz's up to a = b."""
    a, rise = np.asarray(radius, dtype=float), 1.0 / math.tan(half_angle)
    b = curvature_radius * rise
    inner, rest = np.minimum(b / np.maximum(a, b), 1.0), leg(a, b)
    cut = np.where(inner < 1.0, -np.expm1(1.5 * np.log1p(-(np.where(inner < 1.0, inner, 0.0) ** 2))), 1.0)
    shape = angle(a, b) + 4.0 * a / (3.0 * b) * cut - inner * rest / np.maximum(a, b)
    return np.asarray(modulus * rise * a**2 * shape)


def rounded_cone_displacement(r: ArrayLike, radius: ArrayLike, *, curvature_radius: float, half_angle: float) -> Array:
    """Return the surface displacement u(r) [m] of a cone with a tangent parabolic tip, a > b."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    rise = 1.0 / math.tan(half_angle)
    b, beyond = curvature_radius * rise, np.maximum(r, a)
    depth = rounded_cone_depth(a, curvature_radius=curvature_radius, half_angle=half_angle)
    whole = outer_root(beyond, a, 0.0) - outer_root(beyond, a, b)
    tail = rise * (whole / b + outer_arccos(beyond, a, b))
    outside = 2.0 / np.pi * (depth * np.arcsin(a / beyond) - tail)
    height = np.where(r < b, r**2 / (2.0 * curvature_radius), rise * (r - 0.5 * b))
    return np.where(r < a, depth - height, outside)


def sphero_conical_depth(radius: ArrayLike, *, curvature_radius: float, half_angle: float) -> Array:
    """Return the depth d(a) = g(a) [m] of a cone with a tangent spherical tip, which ends at b = R cos.

    The contact radius may exceed R.
    """
    a, big = np.asarray(radius, dtype=float), curvature_radius
    b, m = big * math.cos(half_angle), big * math.sin(half_angle)
    ball = sphere_depth(np.minimum(a, b), curvature_radius=big)
    beyond = np.maximum(a, b)
    tip = beyond * np.log((big + beyond) / (m + leg(beyond, b)))
    return np.where(a > b, tip + truncated_cone_depth(a, half_angle=half_angle, flat_radius=b), ball)


def sphero_conical_force(radius: ArrayLike, *, curvature_radius: float, half_angle: float, modulus: float) -> Array:
    """Return the force F(a) [N] on a cone with a tangent spherical tip; the sphere's up to a = b; a may exceed R."""
    a, big = np.asarray(radius, dtype=float), curvature_radius
    b, m = big * math.cos(half_angle), big * math.sin(half_angle)
    ball = sphere_force(np.minimum(a, b), curvature_radius=big, modulus=modulus)
    beyond = np.maximum(a, b)
    rest = leg(beyond, b)
    tip = (big**2 + beyond**2) * np.log((big + beyond) / (m + rest)) + m * rest - big * beyond
    cone = truncated_cone_force(a, half_angle=half_angle, flat_radius=b, modulus=modulus)
    return np.where(a > b, modulus * tip + cone, ball)
