r"""The field inside a homogeneous body whose surface is sheared: dragged flat punches of all radii, superposed.

As for pressures (`winkler.media.interior.subsurface`) the springs' displacement u(x), now along the surface, is a
pile of flat punches; each carries the traction of the normal punch, directed along x (Ciavarella, Jaeger).  The field
of given traction is exact; that the surfaces then slide where and as the springs predict is exact for nu = 0, and
otherwise neglects the displacement across the direction of load.
"""

from __future__ import annotations

import numpy as np

from winkler.media.interior.shear_field_punch import (
    ShearField,
    ShearPotentials,
    combine_shear,
    shear_punch_below,
    shear_punch_on,
)
from winkler.media.interior.subsurface import superposed_below
from winkler.media.interior.surface_limit import superposed_on
from winkler.media.medium import Displacement
from winkler.media.punch_superposition import punch_superposition
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

NODES = 48
"""Nodes of the one rule that is used on the surface, where points are few."""


def field(
    displacement: Displacement, x: Array, y: Array, z: Array, *, modulus: float, poisson: float, shear: float
) -> ShearField:
    """Return stresses and displacements in one body whose surface is dragged along +x.

    Parameters
    ----------
    displacement : Displacement
        Tangential displacement u(x) of the springs, whose line load is ``modulus * u(x)``; hashable.
    x, y, z : ndarray
        Places [m] of one shape, z >= 0 the depth below the surface.
    modulus : float
        Effective tangential modulus G* of the pair [Pa].
    poisson, shear : float
        Poisson's ratio [-] and shear modulus [Pa] of the body in which the field is wanted.

    Returns
    -------
    ShearField
        Stresses [Pa], tension positive, and displacements [m], z into the body, in the shape of x.  At ``z = 0`` they
        are the limits from inside the body.  Infinite only on the surface, where u jumps or is pointed.

    Raises
    ------
    NotConverged
        If u'(x) is not smooth between the kinks.
    """
    r, depth = np.hypot(x, y).ravel(), np.asarray(z, dtype=float).ravel()
    total = np.zeros((len(ShearPotentials._fields), r.size))
    if displacement.radius > 0.0:
        below, surface = depth > 0.0, depth == 0.0
        total[:, below] = superposed_below(displacement, r[below], depth[below], shear_punch_below)
        total[:, surface] = _surface(displacement, r[surface])
    potentials = ShearPotentials(*(part.reshape(np.shape(x)) for part in total))
    return combine_shear(potentials, x, y, z, modulus=modulus, poisson=poisson, shear=shear)


def angular_shift(displacement: Displacement, r: Array, *, modulus: float, poisson: float, shear: float) -> Array:
    r"""Return the part of the shift of a surface that varies with the angle.

    It is B in :math:`u_x=\bar u+B\cos2\theta,\ u_y=B\sin2\theta`, of one body.

    Parameters
    ----------
    displacement : Displacement
        Tangential displacement u(x) of the springs.
    r : ndarray
        Distances from the axis [m].
    modulus, poisson, shear : float
        As in `field`.

    Returns
    -------
    ndarray of the shape of r
        [m]; zero where all springs nearer to the axis carry the same load, as in a zone of stick.
    """
    flat = np.ravel(r)
    if displacement.radius == 0.0:
        return np.zeros(np.shape(r))
    _, second = _narrower(displacement, flat)
    return np.asarray(modulus * poisson / (4.0 * np.pi * shear) * flat * second).reshape(np.shape(r))


def _surface(displacement: Displacement, r: Array) -> Array:
    """Superpose the punches at points of the surface; the rows are the fields of `ShearPotentials`."""
    v, v_z, psi_r_by_r = superposed_on(displacement, r)
    v_r_by_r, second = _narrower(displacement, r)
    nothing = np.zeros(r.size)
    third = -r * v_r_by_r - 4.0 * second
    return np.array([v, v_z, v_r_by_r, nothing, nothing, psi_r_by_r, nothing, nothing, second, third])


def _narrower(displacement: Displacement, r: Array) -> tuple[Array, Array]:
    """Superpose DV and r D^2 chi on the surface: only punches narrower than r contribute."""
    nodes, weights = gauss_legendre(NODES)
    first, second = (displacement.edge * part for part in shear_punch_on(r, np.asarray(displacement.radius)))
    for panel in punch_superposition(displacement).panels:
        (wide,) = np.nonzero(r > np.hypot(panel.base, panel.lower))
        own = r[wide]
        p = np.sqrt((own - panel.base) * (own + panel.base))
        start, stop = (np.arcsin(np.minimum(end / p, 1.0))[:, None] for end in (panel.lower, panel.upper))
        angle = start + (stop - start) * nodes
        y, root = p[:, None] * np.sin(angle), p[:, None] * np.cos(angle)  # root = sqrt(r^2 - t^2) = dy/dv
        weight = 2.0 * np.hypot(panel.base, y) * panel.weight(y) * (stop - start) * weights
        first[wide] -= np.sum(weight, axis=1) / own**2
        second[wide] += np.sum(weight * root * root, axis=1) / own**3
    return first, second
