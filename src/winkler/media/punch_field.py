r"""The field below a flat punch: the element of which every axisymmetric contact stress is superposed.

A rigid flat punch of radius t on an isotropic half-space presses, in the picture of springs, with a uniform line
load q on :math:`|x| < t`.  For q = 1 the potential of the body and its derivatives are closed [1]_: with
:math:`Z = z + it` and :math:`P = \sqrt{r^2 + Z^2}` (real and imaginary part both positive)

.. math::

    V = 2\,\mathrm{Im}\ln(Z + P), \quad V_z = 2\,\mathrm{Im}\frac1P, \quad V_{zz} = -2\,\mathrm{Im}\frac{Z}{P^3}, \quad
    V_{rz} = -2r\,\mathrm{Im}\frac1{P^3}, \quad V_r = 2r\,\mathrm{Im}\frac{1}{P(P+Z)}, \quad
    \psi_r = \frac2r(t - \mathrm{Im} P),

where :math:`\psi_z = V`.  Written in the real and imaginary parts of P, with
:math:`P - Z = r^2/(P + Z)`, none of them loses digits: not on the axis, not far away, not inside a wide punch.  Next
to the edge of the punch the only cancellation is in :math:`r - t`, which may be handed in exactly.

`combine` turns the potentials into stresses and displacements,

.. math::

    2\pi\sigma_z &= V_z - zV_{zz}, \qquad 2\pi\tau_{rz} = -zV_{rz}, \\
    2\pi\sigma_r &= V_z + zV_{zz} + zV_r/r + (1-2\nu)\psi_r/r, \qquad
    2\pi\sigma_\theta = 2\nu V_z - zV_r/r - (1-2\nu)\psi_r/r, \\
    4\pi G\,u_z &= 2(1-\nu)V - zV_z, \qquad 4\pi G\,u_r = -(1-2\nu)\psi_r - zV_r .

References
----------
.. [1] J. W. Harding, I. N. Sneddon, The elastic stresses produced by the indentation of the plane surface of a
   semi-infinite elastic solid by a rigid punch, Proc. Camb. Phil. Soc. 41 (1945) 16-26.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class Potentials(NamedTuple):
    """The potential V of an axisymmetric normal load and the derivatives that stresses and displacements need.

    For a line load of 1: `v` is a pure number, `v_z`, `z_v_zz`, `z_v_rz`, `z_v_r_by_r` (z V_r / r) and `psi_r_by_r`
    are in [1/m].  All are finite where the field is, on the axis too.
    """

    v: Array
    v_z: Array
    z_v_zz: Array
    z_v_rz: Array
    z_v_r_by_r: Array
    psi_r_by_r: Array


class BodyField(NamedTuple):
    """Stress [Pa] and displacement [m] in a body, cylindrical coordinates r, z with z into the body.

    Tension is positive (the surface below a contact has ``axial_stress = -pressure``); `shear_stress` is tau_rz;
    `axial_displacement` is positive into the body.  The remaining shear stresses are zero.
    """

    radial_stress: Array
    hoop_stress: Array
    axial_stress: Array
    shear_stress: Array
    radial_displacement: Array
    axial_displacement: Array


def punch_below(r: Array, z: Array, t: Array, excess: Array | None = None) -> Potentials:
    """Return the potentials of a flat punch below the surface.

    Parameters
    ----------
    r, z, t : ndarray
        Distance from the axis, depth and radius of the punch [m], of shapes that broadcast; ``r >= 0``, ``z > 0``,
        ``t > 0``.
    excess : ndarray, optional
        ``t - r`` [m], where it is known better than by subtraction.

    Returns
    -------
    Potentials
        For a line load of 1 N/m on ``|x| < t``.

    Examples
    --------
    >>> field = punch_below(np.array(0.6), np.array(0.5), np.array(1.0))
    >>> round(float(field.v_z - field.z_v_zz) / (2 * np.pi), 12)
    -0.409245048135
    """
    beyond = t - r if excess is None else excess
    square = z * z - beyond * (r + t)  # Re P^2; Im P^2 = 2 z t
    modulus = np.hypot(square, 2.0 * z * t)  # |P|^2
    large = np.sqrt(0.5 * (modulus + np.abs(square)))
    small = z * t / large
    real, imaginary = np.where(square >= 0.0, large, small), np.where(square >= 0.0, small, large)
    real_sum, imaginary_sum = real + z, imaginary + t  # P + Z
    inverse = 1.0 / modulus
    inverse_sum = 1.0 / (real_sum * real_sum + imaginary_sum * imaginary_sum)  # |P + Z|^-2
    real_square, imaginary_square = real * real, imaginary * imaginary
    cubed_imaginary = imaginary * (3.0 * real_square - imaginary_square)  # Im P^3
    cubed_real = real * (real_square - 3.0 * imaginary_square)
    twice = 2.0 * z * (inverse * inverse * inverse)
    return Potentials(
        v=2.0 * np.arctan2(imaginary_sum, real_sum),
        v_z=-2.0 * imaginary * inverse,
        z_v_zz=twice * (z * cubed_imaginary - t * cubed_real),
        z_v_rz=twice * r * cubed_imaginary,
        z_v_r_by_r=-2.0 * z * (real * imaginary_sum + imaginary * real_sum) * inverse * inverse_sum,
        psi_r_by_r=2.0 * imaginary_sum * inverse_sum,
    )


def punch_surface(r: Array, t: Array) -> Potentials:
    """Return the potentials of a flat punch on the surface, the limit ``z -> 0`` at fixed ``r``.

    Below the punch ``V = pi`` and ``V_z = -2 / sqrt(t^2 - r^2)``; beside it ``V_z = 0``; exactly at its edge V_z is
    taken from inside, minus infinity.  The terms with a factor z vanish everywhere (at the edge: along the surface).

    Parameters
    ----------
    r, t : ndarray
        Distance from the axis and radius of the punch [m], of shapes that broadcast; ``r >= 0``, ``t > 0``.

    Returns
    -------
    Potentials
        For a line load of 1 N/m on ``|x| < t``.
    """
    inside = t >= r
    root = np.sqrt(np.abs(t - r) * (r + t))
    with np.errstate(divide="ignore"):
        v_z = np.where(inside, -2.0 / root, 0.0)
    outside = np.where(inside, 1.0, r)  # never zero, also where it is not used
    nothing = np.zeros_like(v_z)
    return Potentials(
        v=2.0 * np.arctan2(t, np.where(inside, 0.0, root)),
        v_z=v_z,
        z_v_zz=nothing,
        z_v_rz=nothing,
        z_v_r_by_r=nothing,
        psi_r_by_r=np.where(inside, 2.0 / (t + root), 2.0 * t / (outside * outside)),
    )


def combine(potentials: Potentials, r: Array, z: Array, *, modulus: float, poisson: float, shear: float) -> BodyField:
    """Return the stresses and displacements of potentials that belong to a line load ``modulus * u``.

    Parameters
    ----------
    potentials : Potentials
        Superposed with the springs' displacement as weight: `v` in [m], all others pure numbers.
    r, z : ndarray
        Distance from the axis and depth [m].
    modulus : float
        Line load per displacement of the springs, E* [Pa].
    poisson, shear : float
        Poisson's ratio [-] and shear modulus [Pa] of the body.

    Returns
    -------
    BodyField
        On the axis radial and hoop stress are equal.  Where V_z is infinite, at singular points of the surface, the
        stresses are infinite with the signs that they have along the surface below the contact.
    """
    v, v_z, z_v_zz, z_v_rz, z_v_r_by_r, psi_r_by_r = potentials
    stress, length = modulus / (2.0 * np.pi), modulus / (4.0 * np.pi * shear)
    lateral = z_v_r_by_r + (1.0 - 2.0 * poisson) * psi_r_by_r
    with np.errstate(invalid="ignore"):  # infinities of both signs meet only on the axis
        radial, hoop = v_z + z_v_zz + lateral, times(2.0 * poisson, v_z) - lateral
        outward = r * lateral
    axis = 0.5 * (times(1.0 + 2.0 * poisson, v_z) + z_v_zz)
    return BodyField(
        radial_stress=stress * np.where(r > 0.0, radial, axis),
        hoop_stress=stress * np.where(r > 0.0, hoop, axis),
        axial_stress=stress * (v_z - z_v_zz),
        shear_stress=-stress * z_v_rz,
        radial_displacement=np.where(r > 0.0, -length * outward, 0.0),
        axial_displacement=length * (2.0 * (1.0 - poisson) * v - times(z, v_z)),
    )


def times(factor: float | Array, array: Array) -> Array:
    """Return the product, zero where the factor is zero, even times infinity."""
    there = np.not_equal(factor, 0.0)
    return np.multiply(factor, np.where(there, array, 0.0))
