r"""What a yielding half-space answers to a rigid round body, relative to an elastic one of the same contact radius.

With :math:`x = p_{el}/Y`, the mean pressure of the elastic contact over the strength, three functions are enough:

.. math:: p = p_{el}\,e^{-L(x)}, \qquad d = g(a)/\Gamma(x), \qquad \theta(x),

the pressure, the depth, and the part of the elastic recovery whose shape is still that of the elastic contact
(`winkler.problems.plastic.dent`).  Below the onset of yield L = 0, Gamma = 1 and theta = 1.  For a paraboloid they
depend on x over its value at the onset and, weakly, on Poisson's ratio; for a cone, which yields at the first touch, on
x alone.  Between the two they are mixed by the local exponent k of g(a), d ln g / d ln a: one for a cone and two for a
paraboloid.

The tables are fitted to finite elements that were made for this package: small strains and displacements, von Mises'
condition with the associated flow rule, no hardening, no friction, 30 to 60 elements per contact radius.  The fits err
by at most 0.4 per cent, the meshes by about as much.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.roots import between
from winkler.numerics.types import Array

__all__ = ["GREATEST_POISSON", "LEAST_POISSON", "Yielded", "ball_onset", "yielded"]

BALL_POISSON = (0.0, 0.3, 0.45)
BALL_KNOTS = (0.0, 0.1500, 0.3000, 0.5000, 0.7500, 1.0500, 1.4000, 1.8000, 2.3000, 2.8600)
"""Logarithms of x over its value at the onset of yield."""
BALL_FALL = (
    (0.0, 0.0118, 0.0470, 0.1227, 0.2488, 0.4385, 0.6781, 0.9634, 1.3233, 1.7536),
    (0.0, 0.0104, 0.0428, 0.1156, 0.2436, 0.4417, 0.6949, 1.0018, 1.4010, 1.8849),
    (0.0, 0.0129, 0.0509, 0.1315, 0.2641, 0.4651, 0.7281, 1.0525, 1.4517, 1.9356),
)
BALL_SINKING = (
    (0.0, 0.0067, 0.0248, 0.0611, 0.1189, 0.2094, 0.3249, 0.4579, 0.5929, 0.7422),
    (0.0, 0.0052, 0.0203, 0.0537, 0.1144, 0.2140, 0.3410, 0.4923, 0.6667, 0.8736),
    (0.0, 0.0070, 0.0260, 0.0650, 0.1289, 0.2313, 0.3681, 0.5367, 0.7111, 0.9180),
)
BALL_EVENING = (
    (0.0, 0.0761, 0.1998, 0.3255, 0.5057, 0.6682, 0.8284, 0.9780, 1.1119, 1.1677),
    (0.0, 0.0864, 0.2328, 0.3875, 0.5755, 0.7300, 0.8994, 1.0563, 1.1368, 1.0780),
    (0.0, 0.0786, 0.2098, 0.3532, 0.5650, 0.7636, 0.9389, 1.0587, 1.1391, 1.0804),
)
CONE_KNOTS = (-0.6931, -0.2877, 0.4055, 0.9163, 1.3863, 1.7918, 2.3026)
"""Logarithms of x."""
CONE_FALL = (0.0, 0.0010, 0.0981, 0.3219, 0.6207, 0.9209, 1.3281)
CONE_SINKING = (0.0, 0.0022, 0.0347, 0.1074, 0.2026, 0.2930, 0.4009)
CONE_EVENING = (0.0, 0.0685, 0.4765, 0.7798, 0.9762, 1.0596, 1.0760)

LEAST_POISSON, GREATEST_POISSON = 0.0, 0.5


class Yielded(NamedTuple):
    """How far a yielding body departs from an elastic one; all are zero before it yields.

    Parameters
    ----------
    fall : ndarray, (n,)
        L = ln(p_el / p).
    sinking : ndarray, (n,)
        Gamma - 1, by which the same radius needs less depth.
    evening : ndarray, (n,)
        1 - theta, the part of the recovery that has the shape under an even pressure.
    """

    fall: Array
    sinking: Array
    evening: Array

    def less(self, start: Yielded) -> Yielded:
        """Return what is above the departure at the onset of yield."""
        return Yielded(*(np.maximum(now - then, 0.0) for now, then in zip(self, start, strict=True)))


def yielded(load: Array, poisson: float, exponent: Array) -> Yielded:
    """Return the departure from an elastic body.

    Parameters
    ----------
    load : ndarray, (n,)
        x = p_el / Y [-], positive.
    poisson : float
        nu [-], from 0 to 0.5.
    exponent : ndarray, (n,)
        k = d ln g / d ln a [-] at the contact radius; as 1 below one and as 2 above two.
    """
    round_part = np.clip(exponent - 1.0, 0.0, 1.0)[:, None]
    mixed = np.zeros((load.size, 3))
    if np.any(round_part > 0.0):
        mixed += round_part * _ball(poisson)(np.log(load / ball_onset(poisson)))
    if np.any(round_part < 1.0):
        mixed += (1.0 - round_part) * _cone()(np.log(load))
    return Yielded(*mixed.T)


@functools.lru_cache(maxsize=64)
def ball_onset(poisson: float) -> float:
    """Return p_el / Y [-] where Hertz's contact first yields, by von Mises' condition on its axis."""

    def bend(z: float) -> float:
        square = 1.0 + z * z
        return (1.0 + poisson) * (z / square - math.atan(1.0 / z)) + 3.0 * z / (square * square)

    z = between(bend, 0.2, 1.0)
    stress = 1.5 / (1.0 + z * z) - (1.0 + poisson) * (1.0 - z * math.atan(1.0 / z))
    return 2.0 / (3.0 * stress)


class _Departure:
    """Cubic splines of the three numbers, zero and flat at their beginning; beyond their end straight lines."""

    def __init__(self, knots: tuple[float, ...], values: Array) -> None:
        from scipy.interpolate import CubicSpline

        self.first, self.last = knots[0], knots[-1]
        self.inner = CubicSpline(knots, values, bc_type=((1, np.zeros(3)), (2, np.zeros(3))))
        self.rise = self.inner(self.last, 1)

    def __call__(self, place: Array) -> Array:
        """Return the three numbers at places `(n,)`, as `(n, 3)`."""
        inside = np.clip(place, self.first, self.last)
        return np.asarray(self.inner(inside) + np.maximum(place - self.last, 0.0)[:, None] * self.rise)


@functools.lru_cache(maxsize=64)
def _ball(poisson: float) -> _Departure:
    """Return the departure of a paraboloid over ln(x / x_onset), interpolated between the Poisson's ratios."""
    weights = [
        math.prod((poisson - other) / (one - other) for other in BALL_POISSON if other != one) for one in BALL_POISSON
    ]
    rows = [np.tensordot(weights, rows, 1) for rows in (BALL_FALL, BALL_SINKING, BALL_EVENING)]
    return _Departure(BALL_KNOTS, np.stack(rows, axis=1))


@functools.cache
def _cone() -> _Departure:
    """Return the departure of a cone over ln x."""
    return _Departure(CONE_KNOTS, np.stack([CONE_FALL, CONE_SINKING, CONE_EVENING], axis=1))
