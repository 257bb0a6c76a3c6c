r"""Creepages of two rolling bodies at places of contact, from their motion as rigid bodies.

The contact stands still; the lower body passes through it along -x, and the upper one turns about its axis once per
distance :math:`2\pi R_0`, R0 the rolled radius, and may drift meanwhile.  With their velocities v at the place, their
mean V, their rotations omega, the direction t across in the tangent plane and the normal n out of the lower body

.. math:: \xi = \frac{(v_2-v_1)_x}{V} , \qquad \eta = \frac{(v_2-v_1)_t}{V} , \qquad
          \varphi = \frac{(\omega_2-\omega_1)\cdot n}{V} .
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.profile_pair.placing import PlacedBody
from winkler.problems.rolling.creepage import Creepage


class Drift(NamedTuple):
    """How the upper body moves while the pair rolls, beside its own turning.

    Parameters
    ----------
    lateral
        Towards +y per distance rolled [-].
    yaw
        Turn about the vertical through the zero of the upper profile, its front towards +y, per distance [rad/m].
    roll
        Turn about the direction along through the same place, the side at +y downwards, per distance [rad/m].
    """

    lateral: float = 0.0
    yaw: float = 0.0
    roll: float = 0.0


NO_DRIFT = Drift()


def creepage_at(
    lower: PlacedBody, upper: PlacedBody, place: Array, gap: float, rolled_radius: float, drift: Drift = NO_DRIFT
) -> Creepage:
    """Return the creepages of a pair at a place of the lower surface.

    Parameters
    ----------
    lower, upper : PlacedBody
        In their places.
    place : ndarray, (3,)
        Along, across and up [m].
    gap : float
        From there to the undeformed upper surface along the normal [m].
    rolled_radius : float
        How far the pair rolls while the upper body turns by one radian [m].
    drift : Drift, optional
        Of the upper body.
    """
    found = creepages_along(lower, upper, place[:, None], np.array([gap]), rolled_radius, drift)
    return Creepage(*found[:, 0].tolist())


def creepages_along(
    lower: PlacedBody, upper: PlacedBody, places: Array, gap: Array, rolled_radius: float, drift: Drift = NO_DRIFT
) -> Array:
    """Return xi, eta and phi, ``(3, m)``, at places ``(3, m)`` of the lower surface; see `creepage_at`."""
    slope = lower.profile.slope(places[1])
    length = np.hypot(1.0, slope)
    across = np.stack([np.zeros(slope.shape), np.ones(slope.shape), slope]) / length
    normal = np.stack([np.zeros(slope.shape), -slope, np.ones(slope.shape)]) / length
    opposite = places + gap * normal
    first, first_turn = _motion(lower, places, lower.radius)
    second, second_turn = _motion(upper, opposite, rolled_radius)
    turning = np.array([-drift.roll, 0.0, drift.yaw])
    away = opposite - upper.place[:, None]
    second = second + np.cross(turning, away, axisb=0).T + np.array([0.0, drift.lateral, 0.0])[:, None]
    speed = 0.5 * (np.sqrt(np.sum(first**2, axis=0)) + np.sqrt(np.sum(second**2, axis=0)))
    slip = (second - first) / speed
    spin = (second_turn + turning - first_turn) @ normal / speed
    return np.stack([slip[0], np.sum(slip * across, axis=0), spin])


def _motion(body: PlacedBody, places: Array, rolled_radius: float) -> tuple[Array, Array]:
    """Return the velocities of a body at places, over the speed of rolling, and its rotation [rad/m]."""
    forward, sideways, up = body.axes
    if math.isinf(body.radius):
        return np.repeat(-forward[:, None], places.shape[1], axis=1), np.zeros(3)
    a, _, c = body.own(places)
    turning = -body.up / rolled_radius
    about = c + body.up * body.radius  # from the axis
    return turning * (np.outer(forward, about) - np.outer(up, a)), turning * sideways
