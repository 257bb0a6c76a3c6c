r"""The field of a flat punch that is dragged along the surface: the element of every stress under friction.

A line load q of tangential springs, uniform on :math:`|x|<t`, is a traction along x of
:math:`q/(\pi\sqrt{t^2-r^2})`.  With :math:`\zeta=z+i\tau,\ \rho=\sqrt{r^2+\zeta^2}` the potentials of Cerruti are [1]_

.. math:: V = \int\frac q\rho\,\mathrm d\tau, \qquad \psi = \int q\ln(\rho+\zeta)\,\mathrm d\tau, \qquad
          \chi = \int q\,(\zeta\ln(\rho+\zeta)-\rho)\,\mathrm d\tau ,

each the derivative along z of the next.  For q = 1 all of their derivatives along the surface are closed: with
:math:`Z=z+it,\ P=\sqrt{r^2+Z^2},\ w=P+Z` and :math:`D=\frac1r\frac{\partial}{\partial r}`

.. math::

    DV = 2\,\mathrm{Im}\frac1{Pw}, \quad D^2V = -2\,\mathrm{Im}\frac{P+w}{P^3w^2}, \quad
    D\psi = -2\,\mathrm{Im}\frac1w, \quad D^2\psi = 2\,\mathrm{Im}\frac1{Pw^2}, \quad
    D^3\psi = -2\,\mathrm{Im}\frac{2P+w}{P^3w^3},

    D\chi = -\tfrac12V - \tfrac12r^2D^2\chi, \quad D^2\chi = -\mathrm{Im}\frac1{w^2}, \quad
    D^3\chi = 2\,\mathrm{Im}\frac1{Pw^3}.

`combine_shear` turns them into stresses and displacements,

.. math::

    4\pi G\,u_x &= 2V + 2\nu\chi_{xx} - z\psi_{xx}, \quad 4\pi G\,u_y = 2\nu\chi_{xy} - z\psi_{xy}, \quad
    4\pi G\,u_z = (1-2\nu)\psi_x - zV_x, \\
    2\pi\sigma_x &= (2+2\nu)V_x + 2\nu\chi_{xxx} - z\psi_{xxx}, \quad
    2\pi\sigma_y = 2\nu V_x + 2\nu\chi_{xyy} - z\psi_{xyy}, \quad 2\pi\sigma_z = -zV_{xz}, \\
    2\pi\tau_{xy} &= V_y + 2\nu\chi_{xxy} - z\psi_{xxy}, \quad 2\pi\tau_{xz} = V_z - zV_{xx}, \quad
    2\pi\tau_{yz} = -zV_{xy}.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), sections 3.2 and 3.6,
   doi:10.1017/CBO9781139171731; G. M. Hamilton, L. E. Goodman, J. Appl. Mech. 33 (1966) 371-376,
   doi:10.1115/1.3625051.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class ShearPotentials(NamedTuple):
    """Derivatives of the potentials, with the powers of r and z that keep them finite on the axis.

    In the order of the fields: V; V_z; DV; z V_rz; z r^2 D^2 V; D psi; z r D^2 psi; z r^3 D^3 psi; r D^2 chi;
    r^3 D^3 chi.  For a line load of 1, V is a pure number, DV and D psi / r go with [1/m^2], the others with [1/m].
    """

    v: Array
    v_z: Array
    v_r_by_r: Array
    z_v_rz: Array
    z_v_bent: Array
    psi_r_by_r: Array
    z_psi_second: Array
    z_psi_third: Array
    chi_second: Array
    chi_third: Array


class ShearField(NamedTuple):
    """Stress [Pa], tension positive, and displacement [m] in a body, z into the body."""

    xx_stress: Array
    yy_stress: Array
    zz_stress: Array
    xy_stress: Array
    xz_stress: Array
    yz_stress: Array
    x_displacement: Array
    y_displacement: Array
    z_displacement: Array


def shear_punch_below(r: Array, z: Array, t: Array, excess: Array | None = None) -> ShearPotentials:
    """Return the potentials of a dragged flat punch below the surface.

    Parameters
    ----------
    r, z, t : ndarray
        Distance from the axis, depth and radius of the punch [m], of shapes that broadcast; ``r >= 0``, ``z > 0``,
        ``t > 0``.
    excess : ndarray, optional
        ``t - r`` [m], where it is known better than by subtraction.

    Returns
    -------
    ShearPotentials
        For a line load of 1 N/m on ``|x| < t``.
    """
    beyond = t - r if excess is None else excess
    square = z * z - beyond * (r + t)  # Re P^2; Im P^2 = 2 z t
    large = np.sqrt(0.5 * (np.hypot(square, 2.0 * z * t) + np.abs(square)))
    small = z * t / large
    p = np.where(square >= 0.0, large + 1j * small, small + 1j * large)
    w = p + (z + 1j * t)
    a, b = 1.0 / p, 1.0 / w
    ab, bb = a * b, b * b
    aab, abb = a * ab, a * bb
    zr = z * r
    return ShearPotentials(
        v=2.0 * np.arctan2(w.imag, w.real),
        v_z=2.0 * a.imag,
        v_r_by_r=2.0 * ab.imag,
        z_v_rz=-2.0 * zr * (a * a * a).imag,
        z_v_bent=-2.0 * zr * r * (a * aab + ab * ab).imag,
        psi_r_by_r=-2.0 * b.imag,
        z_psi_second=2.0 * zr * abb.imag,
        z_psi_third=-2.0 * zr * r * r * (2.0 * ab * abb + aab * ab).imag,
        chi_second=-r * bb.imag,
        chi_third=2.0 * r * r * r * (abb * b).imag,
    )


def shear_punch_on(r: Array, t: Array) -> tuple[Array, Array]:
    """Return DV and r D^2 chi of a dragged flat punch on the surface, the limit ``z -> 0`` at fixed ``r``.

    The others are those of `winkler.media.punch_field.punch_surface`, zero, or
    ``r^3 D^3 chi = -r DV - 4 r D^2 chi``.  Below the punch, and exactly at its edge, both vanish: it does not deform
    the surface there.

    Parameters
    ----------
    r, t : ndarray
        Distance from the axis and radius of the punch [m], of shapes that broadcast; ``r >= 0``, ``t > 0``.
    """
    outside = r > t
    root = np.sqrt(np.where(outside, (r - t) * (r + t), 1.0))
    far = np.where(outside, r, 1.0)
    return (
        np.where(outside, -2.0 * t / (root * far * far), 0.0),
        np.where(outside, 2.0 * t * root / (far * far * far), 0.0),
    )


def combine_shear(
    potentials: ShearPotentials, x: Array, y: Array, z: Array, *, modulus: float, poisson: float, shear: float
) -> ShearField:
    """Return stresses and displacements of potentials that belong to a line load ``modulus * u`` along x.

    Parameters
    ----------
    potentials : ShearPotentials
        Superposed with the tangential displacement of the springs as weight.
    x, y, z : ndarray
        Places in the body [m], z downwards.
    modulus : float
        Line load per tangential displacement of the springs, G* [Pa].
    poisson, shear : float
        Poisson's ratio [-] and shear modulus [Pa] of the body.

    Returns
    -------
    ShearField
        The traction acts on the body along +x: ``xz_stress = -traction`` on its surface.
    """
    v, v_z, v_r_by_r, z_v_rz, z_v_bent, psi_r_by_r, z_psi_second, z_psi_third, chi_second, chi_third = potentials
    r = np.hypot(x, y)
    axis = r == 0.0
    safe = np.where(axis, 1.0, r)
    c, s = np.where(axis, 1.0, x / safe), np.where(axis, 0.0, y / safe)
    stress, length = modulus / (2.0 * np.pi), modulus / (4.0 * np.pi * shear)
    v_r = r * v_r_by_r
    second, third = 2.0 * poisson * chi_second - z_psi_second, 2.0 * poisson * chi_third - z_psi_third
    bent = r * second
    return ShearField(
        xx_stress=stress * c * ((2.0 + 2.0 * poisson) * v_r + 3.0 * second + c * c * third),
        yy_stress=stress * c * (2.0 * poisson * v_r + second + s * s * third),
        zz_stress=-stress * c * z_v_rz,
        xy_stress=stress * s * (v_r + second + c * c * third),
        xz_stress=stress * (v_z - z * v_r_by_r - c * c * z_v_bent),
        yz_stress=-stress * c * s * z_v_bent,
        x_displacement=length * ((2.0 - poisson) * v - poisson * r * chi_second - z * psi_r_by_r + c * c * bent),
        y_displacement=length * c * s * bent,
        z_displacement=length * c * r * ((1.0 - 2.0 * poisson) * psi_r_by_r - z * v_r_by_r),
    )
