r"""A paraboloid of radius R with a parabolic cap of radius R1 up to r = b: a worn or blunted ball [1]_.

The profile is that of a paraboloid of radius R1 and, from b on, (1/R - 1/R1)(r^2 - b^2)/2 more: every result is
the sum of Hertz's and of (1 - R/R1) times that of a truncated paraboloid of radius R.

The arguments are the contact radius ``radius`` a [m], the distance ``r`` from the axis [m], ``modulus`` E* [Pa],
``curvature_radius`` R beyond the cap, ``cap_curvature_radius`` R1 of the cap and ``cap_radius`` b [m].

References
----------
.. [1] D. Maugis, M. Barquins, Adhesive contact of sectionally smooth-ended punches on elastic half-spaces: theory
   and experiment, J. Phys. D: Appl. Phys. 16 (1983) 1843-1863, doi:10.1088/0022-3727/16/10/010.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.reference.hertz import hertz_depth, hertz_displacement, hertz_force, hertz_pressure
from winkler.reference.truncated import (
    truncated_paraboloid_depth,
    truncated_paraboloid_displacement,
    truncated_paraboloid_force,
    truncated_paraboloid_pressure,
)


def capped_paraboloid_depth(
    radius: ArrayLike, *, curvature_radius: float, cap_curvature_radius: float, cap_radius: float
) -> Array:
    """Return the depth d(a) = g(a) [m] of a capped paraboloid."""
    more = truncated_paraboloid_depth(radius, curvature_radius=curvature_radius, flat_radius=cap_radius)
    share = 1.0 - curvature_radius / cap_curvature_radius
    return np.asarray(hertz_depth(radius, curvature_radius=cap_curvature_radius) + share * more)


def capped_paraboloid_force(
    radius: ArrayLike, *, curvature_radius: float, cap_curvature_radius: float, cap_radius: float, modulus: float
) -> Array:
    """Return the force F(a) [N] on a capped paraboloid."""
    more = truncated_paraboloid_force(
        radius, curvature_radius=curvature_radius, flat_radius=cap_radius, modulus=modulus
    )
    share = 1.0 - curvature_radius / cap_curvature_radius
    return np.asarray(hertz_force(radius, curvature_radius=cap_curvature_radius, modulus=modulus) + share * more)


def capped_paraboloid_pressure(
    r: ArrayLike,
    radius: ArrayLike,
    *,
    curvature_radius: float,
    cap_curvature_radius: float,
    cap_radius: float,
    modulus: float,
) -> Array:
    """Return the pressure p(r) [Pa] under a capped paraboloid; logarithmically infinite at r = b."""
    more = truncated_paraboloid_pressure(
        r, radius, curvature_radius=curvature_radius, flat_radius=cap_radius, modulus=modulus
    )
    share = 1.0 - curvature_radius / cap_curvature_radius
    return np.asarray(hertz_pressure(r, radius, curvature_radius=cap_curvature_radius, modulus=modulus) + share * more)


def capped_paraboloid_displacement(
    r: ArrayLike, radius: ArrayLike, *, curvature_radius: float, cap_curvature_radius: float, cap_radius: float
) -> Array:
    """Return the surface displacement u(r) [m] of a capped paraboloid, a > b."""
    more = truncated_paraboloid_displacement(r, radius, curvature_radius=curvature_radius, flat_radius=cap_radius)
    share = 1.0 - curvature_radius / cap_curvature_radius
    return np.asarray(hertz_displacement(r, radius, curvature_radius=cap_curvature_radius) + share * more)
