r"""The flat-ended cylindrical punch [1]_ [2]_, and contacts pinned at a rim.

.. math:: F = 2E^*a\,d,\qquad p = \frac{E^*d}{\pi\sqrt{a^2-r^2}},\qquad u(r>a) = \frac{2d}{\pi}\arcsin\frac ar .

Below the surface, with Z = z + i a and P = sqrt(r^2 + Z^2), the potentials of the constant line load q = E* d are
V = 2q Im ln(Z + P), V_z = 2q Im(1/P), V_zz = -2q Im(Z/P^3), V_rz = -2qr Im(1/P^3), V_r/r = 2q Im(1/(P(P + Z))),
psi_r/r = -2q Im(1/(P + Z)).

The arguments are the radius of the punch ``radius`` a [m], ``modulus`` E* [Pa], ``depth`` d [m], ``force`` F [N], the
distance ``r`` from the axis and the depth ``z`` >= 0 in the body [m], and of the body ``poisson`` nu [-] and
``shear`` G [Pa].

References
----------
.. [1] J. Boussinesq, Application des potentiels a l'etude de l'equilibre et du mouvement des solides elastiques,
   Gauthier-Villars, Paris (1885).
.. [2] J. W. Harding, I. N. Sneddon, The elastic stresses produced by the indentation of the plane surface of a
   semi-infinite elastic solid by a rigid punch, Proc. Camb. Phil. Soc. 41 (1945) 16-26.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.reference.interior import Interior, interior


def flat_punch_stiffness(radius: ArrayLike, *, modulus: float) -> Array:
    """Return the stiffness k = 2 E* a [N/m] of a flat punch."""
    return np.asarray(2.0 * modulus * np.asarray(radius, dtype=float))


def flat_punch_force(depth: ArrayLike, *, radius: float, modulus: float) -> Array:
    """Return the force F(d) [N] on a flat punch."""
    return np.asarray(flat_punch_stiffness(radius, modulus=modulus) * np.asarray(depth, dtype=float))


def flat_punch_depth(force: ArrayLike, *, radius: float, modulus: float) -> Array:
    """Return the depth d(F) [m] of a flat punch."""
    return np.asarray(np.asarray(force, dtype=float) / flat_punch_stiffness(radius, modulus=modulus))


def flat_punch_pressure(r: ArrayLike, radius: ArrayLike, *, depth: float, modulus: float) -> Array:
    """Return the pressure p(r) [Pa] under a flat punch: infinite at the edge, zero outside."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    inside = r < a
    root = np.sqrt(np.where(inside, (a - r) * (a + r), 1.0))
    return np.where(inside, modulus * depth / (np.pi * root), np.where(r == a, np.inf, 0.0))


def flat_punch_displacement(r: ArrayLike, radius: ArrayLike, *, depth: float) -> Array:
    """Return the surface displacement u(r) [m] of a flat punch, inside and outside."""
    r, a = np.asarray(r, dtype=float), np.asarray(radius, dtype=float)
    return np.asarray(2.0 / np.pi * depth * np.arcsin(a / np.maximum(r, a)))


def flat_punch_subsurface(
    r: ArrayLike, z: ArrayLike, radius: float, *, force: float, poisson: float, shear: float
) -> Interior:
    """Return stresses and displacements below a flat punch, in closed form; not on the edge itself."""
    r, z = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(z, dtype=float))
    load = force / (2.0 * radius)
    big_z = z + 1j * radius
    big_p = np.sqrt(r**2 + big_z**2)
    return interior(
        r,
        z,
        v=2.0 * load * np.log(big_z + big_p).imag,
        v_z=2.0 * load * (1.0 / big_p).imag,
        v_zz=-2.0 * load * (big_z / big_p**3).imag,
        v_rz=-2.0 * load * r * (1.0 / big_p**3).imag,
        v_r_over_r=2.0 * load * (1.0 / (big_p * (big_p + big_z))).imag,
        psi_r_over_r=-2.0 * load * (1.0 / (big_p + big_z)).imag,
        poisson=poisson,
        shear=shear,
    )


def pinned_force(depth: ArrayLike, *, rim: float, rim_depth: float, rim_force: float, modulus: float) -> Array:
    """Return the force [N] on a body of radius b whose contact has reached its rim: F(b) + 2 E* b (d - g(b)).

    The pressure is that at a = b plus that of a flat punch of radius b at the depth d - g(b).

    Parameters
    ----------
    depth : array_like
        d [m], at least `rim_depth`.
    rim : float
        b [m].
    rim_depth, rim_force : float
        g(b) [m] and F(b) [N], when the contact just reaches the rim.
    modulus : float
        E* [Pa].
    """
    more = np.asarray(depth, dtype=float) - rim_depth
    return np.asarray(rim_force + flat_punch_force(more, radius=rim, modulus=modulus))
