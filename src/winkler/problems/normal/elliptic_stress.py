r"""The greatest von Mises stress under Hertz's ellipse without friction.

On the axis below the middle, with :math:`A=a^2+z^2,\ B=b^2+z^2`, :math:`T=\sqrt{B/A}` and Carlson's :math:`R_D`,

.. math::

    \frac{\sigma_z}{p_0} &= -\frac{ab}{\sqrt{AB}} , \\
    \frac{\sigma_x}{p_0} &= \frac{ab}2\Big[zD_a - 2\nu zD_z - (1-2\nu)\Big(\frac2{A(1+T)} - zD_a\Big)\Big] , \\
    D_a &= \tfrac23R_D(B,z^2,A) , \qquad D_z = \tfrac23R_D(A,B,z^2) ,

and the same for y with the axes exchanged: Love's integrals of the potential of a half-ellipsoid of pressure.  At the
ends of the axes of the ellipse the surface is sheared by a pair of equal and opposite stresses.

References
----------
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 3.2 and 4.2, doi:10.1017/CBO9781139171731; H. R. Thomas,
V. A. Hoersch, Univ. Illinois Eng. Exp. Station Bulletin 212 (1930)
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.highest import highest
from winkler.numerics.types import Array

DEPTHS = np.geomspace(1e-4, 4.0, 49)


class EllipticPeak(NamedTuple):
    """Greatest von Mises stress over the greatest pressure, and its depth over the smaller semi-axis."""

    value: float
    depth: float


def axis_stresses(a: float, b: float, poisson: float, z: Array) -> tuple[Array, Array, Array]:
    """Return the stresses along x, y and z on the axis, over the greatest pressure, tension positive.

    Parameters
    ----------
    a, b : float
        Semi-axes along x and y [m].
    poisson : float
    z : ndarray
        Depths [m], positive.
    """
    from scipy.special import elliprd

    first, second, third = a * a + z * z, b * b + z * z, z * z
    ratio = np.sqrt(second / first)
    along = z * elliprd(second, third, first) / 1.5
    across = z * elliprd(third, first, second) / 1.5
    deep = z * elliprd(first, second, third) / 1.5
    twice, free = 2.0 * poisson, 1.0 - 2.0 * poisson
    stress_x = 0.5 * a * b * (along - twice * deep - free * (2.0 / (first * (1.0 + ratio)) - along))
    stress_y = 0.5 * a * b * (across - twice * deep - free * (2.0 / (second * (1.0 + 1.0 / ratio)) - across))
    return stress_x, stress_y, -a * b / np.sqrt(first * second)


@functools.lru_cache(maxsize=1024)
def greatest_under_ellipse(slenderness: float, poisson: float) -> EllipticPeak:
    """Return the greatest von Mises stress, sought on the axis and at the ends of the axes of the ellipse.

    Parameters
    ----------
    slenderness : float
        Smaller over larger semi-axis, above zero and at most one.
    poisson : float
    """
    a, b = 1.0 / slenderness, 1.0

    top = highest(lambda z: _von_mises(*axis_stresses(a, b, poisson, z)), [DEPTHS])
    below = EllipticPeak(top.value, *top.place)
    twice, free = 2.0 * poisson, 1.0 - 2.0 * poisson
    in_middle = _von_mises(-twice - free * b / (a + b), -twice - free * a / (a + b), -1.0)
    at_ends = _ends(slenderness) * abs(1.0 - 2.0 * poisson) * math.sqrt(3.0)
    return max(below, EllipticPeak(max(at_ends, float(in_middle)), 0.0))


def _von_mises(x: Array | float, y: Array | float, z: Array | float) -> Array:
    return np.asarray(np.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2)))


def _ends(slenderness: float) -> float:
    """Return the greater of the two stresses at the ends of the axes, over (1 - 2 nu) times the greatest pressure."""
    square = (1.0 - slenderness) * (1.0 + slenderness)
    if square < 1e-6:
        return 1.0 / 3.0
    e = math.sqrt(square)
    longer = slenderness / square * (math.atanh(e) / e - 1.0)
    shorter = slenderness / square * (1.0 - slenderness / e * math.atan(e / slenderness))
    return max(longer, shorter)
