r"""Stresses and displacements below the surface from the potentials of the line load q(t).

With zeta = z + i t and rho = sqrt(r^2 + zeta^2) the potential of any axisymmetric pressure is

.. math:: V = \int_{-a}^{a}\frac{q(t)}{\rho}\,\mathrm dt,\qquad \frac{\partial\psi}{\partial z} = V ,

and stresses (tension positive) and displacements of the body z > 0 follow by differentiation [1]_:

.. math:: 2\pi\sigma_z = V_{,z}-zV_{,zz},\quad 2\pi\tau_{rz} = -zV_{,rz},\quad
          2\pi\sigma_r = 2\nu V_{,z}-zV_{,rr}-(1-2\nu)\psi_{,rr},

.. math:: 2\pi\sigma_\theta = 2\nu V_{,z}-zV_{,r}/r-(1-2\nu)\psi_{,r}/r,\quad
          4\pi G u_z = 2(1-\nu)V-zV_{,z},\quad 4\pi G u_r = -(1-2\nu)\psi_{,r}-zV_{,r},

with V_rr = -V_zz - V_r/r and psi_rr = -V_z - psi_r/r.

References
----------
.. [1] A. E. Green, W. Zerna, Theoretical Elasticity, 2nd ed., Oxford University Press (1968), section 5.8.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array


class Interior(NamedTuple):
    """Stresses [Pa], tension positive, and displacements [m], outward and into the body positive."""

    radial_stress: Array
    hoop_stress: Array
    axial_stress: Array
    shear_stress: Array
    radial_displacement: Array
    axial_displacement: Array


def interior(
    r: Array,
    z: Array,
    *,
    v: Array,
    v_z: Array,
    v_zz: Array,
    v_rz: Array,
    v_r_over_r: Array,
    psi_r_over_r: Array,
    poisson: float,
    shear: float,
) -> Interior:
    """Return stresses and displacements from the potentials.

    Parameters
    ----------
    r, z : ndarray
        Places [m]; z >= 0.  At z = 0 the second derivatives of V are not computed.
    v, v_z, v_zz, v_rz, v_r_over_r, psi_r_over_r : ndarray
        V [N/m] and its derivatives, V_r/r and psi_r/r.
    poisson : float
        nu [-] of the body.
    shear : float
        G [Pa] of the body.
    """
    deep = z > 0.0
    z_zz, z_rz, z_r = (z * np.where(deep, part, 0.0) for part in (v_zz, v_rz, v_r_over_r))
    soft = 1.0 - 2.0 * poisson
    return Interior(
        radial_stress=(2.0 * poisson * v_z + z_zz + z_r + soft * (v_z + psi_r_over_r)) / (2.0 * np.pi),
        hoop_stress=(2.0 * poisson * v_z - z_r - soft * psi_r_over_r) / (2.0 * np.pi),
        axial_stress=(v_z - z_zz) / (2.0 * np.pi),
        shear_stress=-z_rz / (2.0 * np.pi),
        radial_displacement=-r * (soft * psi_r_over_r + z_r) / (4.0 * np.pi * shear),
        axial_displacement=(2.0 * (1.0 - poisson) * v - z * v_z) / (4.0 * np.pi * shear),
    )
