r"""What a yielding half-space answers to a rigid round body, relative to an elastic one of the same contact radius.

With :math:`x = p_{el}/Y`, the mean pressure of the elastic contact over the strength, three functions are enough:

.. math:: p = p_{el}\,e^{-L(x)}, \qquad d = g(a)/\Gamma(x), \qquad \theta(x),

the pressure, the depth, and the part of the elastic recovery whose shape is still that of the elastic contact
(`winkler.problems.plastic.dent`).  Below the onset of yield L = 0, Gamma = 1 and theta = 1.  For a paraboloid they
depend on x over its value at the onset and, weakly, on Poisson's ratio; for a cone, which yields at the first touch, on
x and, by 11 per cent of the pressure at most, on Poisson's ratio.  Between the two they are mixed by the local exponent
k of g(a), d ln g / d ln a: one for a cone and two for a paraboloid.

The tables are fitted to finite elements that were made for this package: small strains and displacements, von Mises'
condition with the associated flow rule, no hardening, no friction, 30 to 60 elements per contact radius.  The fits err
by at most 0.5 per cent, the meshes by about as much.  Beyond the tables the pressure goes on to three times the
strength.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.roots import between
from winkler.numerics.types import Array

BALL_POISSON = (0.0, 0.3, 0.45)
BALL_KNOTS = (0.0, 0.1500, 0.3000, 0.5000, 0.7500, 1.0500, 1.4000, 1.8000, 2.3000, 2.8600)
"""Logarithms of x over its value at the onset of yield."""
BALL_FALL = (
    (0.0, 0.0098, 0.0410, 0.1123, 0.2401, 0.4361, 0.6790, 0.9629, 1.3235, 1.7533),
    (0.0, 0.0104, 0.0428, 0.1155, 0.2437, 0.4417, 0.6951, 1.0015, 1.4015, 1.8835),
    (0.0, 0.0124, 0.0495, 0.1291, 0.2622, 0.4649, 0.7288, 1.0522, 1.4522, 1.9774),
)
BALL_SINKING = (
    (0.0, 0.0052, 0.0201, 0.0530, 0.1122, 0.2076, 0.3256, 0.4572, 0.5932, 0.7418),
    (0.0, 0.0052, 0.0203, 0.0536, 0.1145, 0.2139, 0.3411, 0.4919, 0.6673, 0.8720),
    (0.0, 0.0066, 0.0249, 0.0629, 0.1274, 0.2311, 0.3687, 0.5363, 0.7117, 0.9501),
)
BALL_EVENING = (
    (0.0, 0.0889, 0.2392, 0.3921, 0.5559, 0.6710, 0.8144, 0.9798, 1.1162, 1.1634),
    (0.0, 0.0864, 0.2328, 0.3876, 0.5754, 0.7302, 0.8991, 1.0572, 1.1355, 1.0817),
    (0.0, 0.0820, 0.2201, 0.3708, 0.5787, 0.7653, 0.9346, 1.0590, 1.1372, 1.0834),
)
CONE_KNOTS = (-0.6931, -0.2877, 0.4055, 0.9163, 1.3863, 1.7918, 2.3026)
"""Logarithms of x."""
CONE_FALL = (0.0, 0.0010, 0.0981, 0.3219, 0.6207, 0.9209, 1.3281)
CONE_SINKING = (0.0, 0.0022, 0.0347, 0.1074, 0.2026, 0.2930, 0.4009)
CONE_EVENING = (0.0, 0.0685, 0.4765, 0.7798, 0.9762, 1.0596, 1.0760)
CONE_POISSON, CONE_GAIN = 0.3, (0.309, -0.203)
"""Poisson's ratio of these tables, and by how much the logarithm of the pressure changes with it and with its square,
from cones of 0 and 0.45."""
GAINED_OVER = 0.15
"""Fall over which this comes in: an elastic body knows nothing of it."""

LEAST_POISSON, GREATEST_POISSON = BALL_POISSON[0], BALL_POISSON[-1]
FULL_PRESSURE = 3.0
"""Mean pressure over strength of a rigid, perfectly plastic body, towards which the pressure goes beyond the tables
(S. Dj. Mesarovic, N. A. Fleck, Proc. R. Soc. Lond. A 455 (1999) 2707-2728, doi:10.1098/rspa.1999.0423)."""
FULL_BALL_SINKING, FULL_CONE_SINKING = 1.86, 0.8
"""Gamma - 1 there, estimates: of a ball near the similarity solutions of the same source."""


GREATEST_STRAIN_SHARE = 0.95
PRESSURE_STRAIN = (1.277, -0.346)
SHAPE_STRAIN = (0.571, 0.278)
"""Factors and powers of x of the representative strains of a metal that hardens, over the elastic strain that is
missing; fitted to finite elements of balls that harden linearly, by 0.1 E, and by a power of 0.2, and tested on others:
by 0.005 E and 0.02 E, by powers of 0.1 and 0.4, with a Poisson's ratio of 0.45, and a cone."""
LAST_HARDENED = 10.0
"""Load x up to which these were made.  Beyond, the strain is in proportion to the contact radius: Meyer's law."""
EXPONENT_ROUNDING = 1e-13
"""By which local exponents of paraboloids and cones may miss two and one."""


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
        nu [-], from 0 to 0.45.
    exponent : ndarray, (n,)
        k = d ln g / d ln a [-] at the contact radius; as 1 below one and as 2 above two.
    """
    part = round_part(exponent)[:, None]
    mixed = np.zeros((load.size, 3))
    if np.any(part > 0.0):
        mixed += part * _ball(poisson)(np.log(load / ball_onset(poisson)))
    if np.any(part < 1.0):
        mixed += (1.0 - part) * _of_cone(np.log(load), poisson)
    return Yielded(*mixed.T)


def strain_of_pressure(load: Array, missing: Array) -> Array:
    """Return the plastic strains [-] whose flow stress decides how much a metal bears that hardens.

    Parameters
    ----------
    load : ndarray, (n,)
        x, the elastic pressure over that flow stress [-].
    missing : ndarray, (n,)
        (p_el - p) / E* [-].  Under a deep dent of a ball the strain is about 0.2 a/R, under one of a cone 0.2 times its
        slope, as Tabor and Johnson state.
    """
    factor, power = PRESSURE_STRAIN
    return np.asarray(np.minimum(factor * np.minimum(load, LAST_HARDENED) ** power, GREATEST_STRAIN_SHARE) * missing)


def strain_of_shape(load: Array, missing: Array) -> Array:
    """Return the strains [-] whose flow stress decides how a metal sinks in that hardens; as `strain_of_pressure`."""
    factor, power = SHAPE_STRAIN
    return np.asarray(factor * np.clip(load, 1.0, LAST_HARDENED) ** power * missing)


def round_part(exponent: Array) -> Array:
    """Return the part of a paraboloid in the law of profiles of local exponents; the rest is that of a cone."""
    part = np.clip(exponent - 1.0, 0.0, 1.0)
    return np.where(part > 1.0 - EXPONENT_ROUNDING, 1.0, np.where(part < EXPONENT_ROUNDING, 0.0, part))


def beyond_tables(load: Array, poisson: float, exponent: Array) -> Array:
    """Return whether loads p_el / Y are beyond the finite elements to which the law is fitted; as `yielded`."""
    part = round_part(exponent)
    ball = np.log(load / ball_onset(poisson)) > BALL_KNOTS[-1]
    return ((part > 0.0) & ball) | ((part < 1.0) & (np.log(load) > CONE_KNOTS[-1]))


@functools.lru_cache(maxsize=64)
def ball_onset(poisson: float) -> float:
    """Return p_el / Y [-] where Hertz's contact first yields, by von Mises' condition on its axis."""

    def bend(z: float) -> float:
        square = 1.0 + z * z
        return (1.0 + poisson) * (z / square - math.atan(1.0 / z)) + 3.0 * z / (square * square)

    z = between(bend, 0.2, 1.0)
    stress = 1.5 / (1.0 + z * z) - (1.0 + poisson) * (1.0 - z * math.atan(1.0 / z))
    return 2.0 / (3.0 * stress)


class Departure:
    """Cubic splines of the three numbers, zero and flat at their beginning, full plasticity beyond their end.

    Parameters
    ----------
    knots : tuple of float
        Logarithms of x over that at the beginning.
    values : ndarray, (n, 3)
    start : float
        Logarithm of x where the knots begin to count.
    sinking : float
        Greatest Gamma - 1, of a rigid, fully plastic body.
    pressure : float
        Mean pressure of that body over its strength [-].
    """

    def __init__(
        self, knots: tuple[float, ...], values: Array, start: float, sinking: float, pressure: float = FULL_PRESSURE
    ) -> None:
        from scipy.interpolate import CubicSpline

        self.first, self.last = knots[0], knots[-1]
        self.inner = CubicSpline(knots, values, bc_type=((1, np.zeros(3)), (2, np.zeros(3))))
        rise = self.inner(self.last, 1)
        end = self.inner(self.last)
        self.pressure_room = math.log(pressure) - (start + self.last - float(end[0]))
        self.pressure_rise = 1.0 - float(rise[0])
        self.sinking_room, self.sinking_rise = sinking - float(end[1]), float(rise[1])

    def __call__(self, place: Array) -> Array:
        """Return the three numbers at places `(n,)`, as `(n, 3)`."""
        result = np.array(self.inner(np.clip(place, self.first, self.last)))
        beyond = np.maximum(place - self.last, 0.0)
        if np.any(beyond > 0.0):
            result[:, 0] += beyond - _saturating(beyond, self.pressure_rise, self.pressure_room)
            result[:, 1] += _saturating(beyond, self.sinking_rise, self.sinking_room)
        return result


def _saturating(beyond: Array, rise: float, room: float) -> Array:
    """Return what begins with a slope and never fills more than the room."""
    return np.asarray(-room * np.expm1(-rise * beyond / room))


@functools.lru_cache(maxsize=64)
def _ball(poisson: float) -> Departure:
    """Return the departure of a paraboloid over ln(x / x_onset), interpolated between the Poisson's ratios."""
    weights = [
        math.prod((poisson - other) / (one - other) for other in BALL_POISSON if other != one) for one in BALL_POISSON
    ]
    rows = [np.tensordot(weights, rows, 1) for rows in (BALL_FALL, BALL_SINKING, BALL_EVENING)]
    return Departure(BALL_KNOTS, np.stack(rows, axis=1), math.log(ball_onset(poisson)), FULL_BALL_SINKING)


def _of_cone(place: Array, poisson: float) -> Array:
    """Return the departure of a cone at ln x `(n,)`, as `(n, 3)`."""
    departure = _cone()(place)
    away = poisson - CONE_POISSON
    gain = CONE_GAIN[0] * away + CONE_GAIN[1] * away * away
    left = np.exp(np.minimum(CONE_KNOTS[-1] - place, 0.0))  # a rigid, plastic body does not know of its elasticity
    departure[:, 0] += gain * np.expm1(-departure[:, 0] / GAINED_OVER) * left
    return departure


@functools.cache
def _cone() -> Departure:
    """Return the departure of a cone over ln x for the Poisson's ratio of the tables."""
    return Departure(CONE_KNOTS, np.stack([CONE_FALL, CONE_SINKING, CONE_EVENING], axis=1), 0.0, FULL_CONE_SINKING)
