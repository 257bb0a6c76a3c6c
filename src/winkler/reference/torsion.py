r"""Torsion with friction under a steady normal load, on homogeneous half-spaces [1]_ [2]_.

A ball pressed with F into a contact of radius a and twisted until only the disc of radius c sticks:

.. math:: \varphi = \frac{3\mu F}{4\pi G_ta^2}\,\big[K(m)-E(m)\big],\quad m = 1-\frac{c^2}{a^2},\qquad
          M_\text{max} = \frac{3\pi}{16}\,\mu Fa ;

of a flat punch :math:`\varphi = \mu F K(m)/(4\pi G_ta^2)`, so that nothing slides below :math:`\mu F/(8G_ta^2)`.

References
----------
.. [1] J. L. Lubkin, The torsion of elastic spheres in contact, J. Appl. Mech. 18 (1951) 183-187.
.. [2] H. Deresiewicz, Contact of elastic spheres under an oscillating torsional couple, J. Appl. Mech. 21 (1954) 52-56.
"""

from __future__ import annotations

import numpy as np
from scipy.special import ellipe, ellipkm1

from winkler.numerics.types import Array, ArrayLike


def ball_twist(stick_ratio: ArrayLike) -> Array:
    """Return G_t a^2 phi / (mu F) of a ball whose disc of radius c = stick_ratio a sticks (Lubkin).

    Examples
    --------
    >>> round(float(ball_twist(0.5)), 10)
    0.225711858
    """
    share = np.asarray(stick_ratio, dtype=float) ** 2
    return np.asarray(0.75 / np.pi * (ellipkm1(share) - ellipe(1.0 - share)))


def ball_twist_limit(*, friction: float, force: float, radius: float) -> float:
    """Return the torque [N m] that makes a ball spin, (3 pi / 16) mu F a."""
    return 3.0 * np.pi / 16.0 * friction * force * radius


def small_ball_twist(torque_ratio: ArrayLike) -> Array:
    """Return Deresiewicz' G_t a^2 phi / (mu F) for M = torque_ratio mu F a, good for small torques."""
    root = np.sqrt(1.0 - 1.5 * np.asarray(torque_ratio, dtype=float))
    return np.asarray((1.0 - root) * (3.0 - root) / 8.0)


def punch_twist(stick_ratio: ArrayLike) -> Array:
    """Return G_t a^2 phi / (mu F) of a flat punch whose disc of radius c = stick_ratio a sticks."""
    return np.asarray(ellipkm1(np.asarray(stick_ratio, dtype=float) ** 2) / (4.0 * np.pi))


def rigid_twist_torque(radius: float, angle: ArrayLike, *, shear_modulus: float) -> Array:
    """Return the torque [N m] on a disc that sticks everywhere, (16/3) G_t a^3 phi."""
    return np.asarray(16.0 / 3.0 * shear_modulus * radius**3 * np.asarray(angle, dtype=float))
