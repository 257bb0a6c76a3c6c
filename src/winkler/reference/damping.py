r"""Losses of contacts under friction in closed form: a ball pushed to and fro, small amplitudes, relaxation damping.

With :math:`y = Q/(\mu F)` a ball loses, per cycle of the shear force :math:`\pm Q` [1]_,

.. math:: W = \frac{18\mu^2F^2}{5aG^*}\Bigl[1-(1-y)^{5/3}-\tfrac{5y}{6}\bigl(1+(1-y)^{2/3}\bigr)\Bigr] ,

every profile, of small amplitudes, :math:`W = \frac43 G^{*2}U^3/(\mu E^*g'(a))`.  Without sliding [2]_ a contact with
:math:`d=d_0+A_z\cos\omega t,\ U=A_x\cos(\omega t+\varphi)` loses

.. math:: W = \frac{16}{3}\,\frac{G^*A_x^2|A_z|\sin^2\varphi}{g'(a)}

and slow motion under fast oscillation of the depth encounters :math:`F_x/v = \frac{2(\pi^2-4)}{\pi}\,G^*A_z/(\omega
g'(a))`.

References
----------
.. [1] R. D. Mindlin, H. Deresiewicz, Elastic spheres in contact under varying oblique forces, J. Appl. Mech. 20 (1953)
   327-344, doi:10.1115/1.4010702; in terms of E* and G* within Cattaneo-Mindlin.
.. [2] M. Popov, V. L. Popov, R. Pohrt, Relaxation damping in oscillating contacts, Sci. Rep. 5 (2015) 16189,
   doi:10.1038/srep16189.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike


def ball_loss(
    shear_force: ArrayLike, *, force: float, coefficient: float, radius: float, shear_modulus: float
) -> Array:
    """Return the loss of a ball per cycle of a shear force, at a steady normal force [J].

    The brackets cancel for small amplitudes: about y^3 in the last digit.

    Parameters
    ----------
    shear_force : array_like
        Amplitude Q [N], from 0 to mu F.
    force, coefficient, radius, shear_modulus : float
        F [N], mu [-], a [m], G* [Pa].
    """
    y = np.asarray(shear_force, dtype=float) / (coefficient * force)
    bracket = 1.0 - (1.0 - y) ** (5.0 / 3.0) - 5.0 * y / 6.0 * (1.0 + (1.0 - y) ** (2.0 / 3.0))
    return np.asarray(18.0 * (coefficient * force) ** 2 / (5.0 * radius * shear_modulus) * bracket)


def small_loss(
    shift: ArrayLike, *, coefficient: float, gap_slope: float, modulus: float, shear_modulus: float
) -> Array:
    """Return the loss per cycle of a small shift, for every profile that is smooth at the edge of the contact [J].

    Parameters
    ----------
    shift : array_like
        Amplitude U [m].
    coefficient, gap_slope, modulus, shear_modulus : float
        mu [-], g'(a) [-], E* [Pa], G* [Pa].
    """
    return np.asarray(
        4.0 / 3.0 * shear_modulus**2 * np.asarray(shift, dtype=float) ** 3 / (coefficient * modulus * gap_slope)
    )


def relaxation_loss(
    phase: ArrayLike, *, depth_amplitude: float, shift_amplitude: float, gap_slope: float, shear_modulus: float
) -> Array:
    """Return the loss per cycle without sliding, of a small oscillation of the depth [J]; of cones, of any.

    Parameters
    ----------
    phase : array_like
        Between shift and depth [rad].
    depth_amplitude, shift_amplitude : float
        A_z, A_x [m].
    gap_slope, shear_modulus : float
        g'(a) [-], G* [Pa].
    """
    whole = 16.0 / 3.0 * shear_modulus * shift_amplitude**2 * depth_amplitude / gap_slope
    return np.asarray(whole * np.sin(np.asarray(phase, dtype=float)) ** 2)


def relaxation_viscosity(
    depth_amplitude: ArrayLike, *, frequency: float, gap_slope: float, shear_modulus: float
) -> Array:
    """Return shear force over speed under a small, fast oscillation of the depth [N s/m]; of cones, of any.

    Parameters
    ----------
    depth_amplitude : array_like
        A_z [m].
    frequency, gap_slope, shear_modulus : float
        [Hz], g'(a) [-], G* [Pa].
    """
    factor = 2.0 * (np.pi**2 - 4.0) / np.pi * shear_modulus / (2.0 * np.pi * frequency * gap_slope)
    return np.asarray(factor * np.asarray(depth_amplitude, dtype=float))
