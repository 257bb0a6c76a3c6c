r"""Rolling with creepage: closed forms for a ball, for a cylinder (Carter), and for springs over a disc.

A ball, its first slope by Kalker's theory, follows the cubic law of Vermeulen and Johnson in
:math:`\tau=c_{11}Ga^2\xi/(\mu F_N)`; a cylinder, in plane strain, is solved exactly: with the load P per length, the
creep force Q per length and :math:`a^2=4PR/(\pi E^*)`

.. math:: \xi = \frac{\mu a}{R}\Bigl(1-\sqrt{1-\tfrac{Q}{\mu P}}\Bigr),\qquad \frac ca=\sqrt{1-\tfrac{Q}{\mu P}} .

References
----------
.. [1] F. W. Carter, On the action of a locomotive driving wheel, Proc. R. Soc. A 112 (1926) 151-157.
.. [2] P. J. Vermeulen, K. L. Johnson, Contact of nonspherical elastic bodies transmitting tangential forces, J. Appl.
   Mech. 31 (1964) 338-340.
.. [3] J. J. Kalker, A fast algorithm for the simplified theory of rolling contact, Vehicle System Dynamics 11 (1982)
   1-13, doi:10.1080/00423118208968684.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array, ArrayLike


def cubic_creep_force(drive: ArrayLike) -> Array:
    """Return F_x / (mu F_N) at tau, the linear creep force over mu F_N; odd, and one from tau = 3 on."""
    tau = np.asarray(drive, dtype=float)
    share = np.minimum(np.abs(tau) / 3.0, 1.0)
    return np.asarray(np.sign(tau) * (1.0 - (1.0 - share) ** 3))


def simplified_creep_force(drive: ArrayLike) -> Array:
    """Return F_x / (mu F_N) of springs over a disc with a parabolic bound, at tau; one from tau = 32 / (3 pi) on.

    A strip of half length l that gains w per length slides after 2 l - w; its force is summed over the strips.
    """
    tau = np.asarray(drive, dtype=float)
    w = np.minimum(3.0 * math.pi / 16.0 * np.abs(tau), 2.0)
    edge = 0.5 * w
    y = np.sqrt(1.0 - edge**2)
    sticking = 2.0 * w * (y - y**3 / 3.0) - 0.5 * w**2 * (y * edge + np.arcsin(y)) + w**3 / 6.0 * y
    sliding = 4.0 / 3.0 * (3.0 * math.pi / 16.0 - (y * (5.0 - 2.0 * y**2) * edge + 3.0 * np.arcsin(y)) / 8.0)
    return np.asarray(np.sign(tau) * (sticking + sliding) * 4.0 / math.pi)


def first_rolling_force(stiffness: float, radius: float, creepage: float, distance: ArrayLike) -> Array:
    """Return F_x [N] after so much rolling [m] from rest, without slip; `stiffness` kappa [Pa], `radius` a [m]."""
    far = np.minimum(np.asarray(distance, dtype=float), 2.0 * radius)
    return np.asarray(stiffness * creepage * (2.0 * radius * far - 0.5 * far**2))


def rocking_limit(share: ArrayLike) -> Array:
    """Return F_lim / (mu F_N) of a ball that rolls to and fro by the `share` w of its contact radius to each side."""
    w = np.minimum(np.asarray(share, dtype=float), 1.0)
    return np.asarray(1.0 - 1.5 * w + 0.5 * w**3)


def carter_creepage(coefficient: float, half_width: float, curvature_radius: float, ratio: ArrayLike) -> Array:
    """Return xi [-] of a cylinder at a ratio Q / (mu P) from 0 to 1; `half_width` a [m], `curvature_radius` R [m]."""
    return np.asarray(
        coefficient * half_width / curvature_radius * (1.0 - np.sqrt(1.0 - np.asarray(ratio, dtype=float)))
    )


def carter_force(coefficient: float, half_width: float, curvature_radius: float, creepage: ArrayLike) -> Array:
    """Return Q / (mu P) of a cylinder at a creepage; one from mu a / R on."""
    xi = np.asarray(creepage, dtype=float)
    used = np.minimum(np.abs(xi) * curvature_radius / (coefficient * half_width), 1.0)
    return np.asarray(np.sign(xi) * (1.0 - (1.0 - used) ** 2))


def carter_stick_half_width(half_width: float, ratio: ArrayLike) -> Array:
    """Return c [m]: the zone of stick reaches from the leading edge a back to a - 2 c."""
    return np.asarray(half_width * np.sqrt(1.0 - np.asarray(ratio, dtype=float)))


def carter_traction(peak: float, half_width: float, stick_half_width: float, x: ArrayLike) -> Array:
    """Return the traction [Pa] at places x [m], the leading edge at +a; `peak` is mu p_0 [Pa]."""
    x = np.asarray(x, dtype=float)
    a, c = half_width, stick_half_width
    whole = np.sqrt(np.maximum(1.0 - (x / a) ** 2, 0.0))
    core = np.sqrt(np.maximum(1.0 - ((x - (a - c)) / c) ** 2, 0.0)) if c > 0.0 else np.zeros_like(x)
    return np.asarray(peak * (whole - c / a * core))
