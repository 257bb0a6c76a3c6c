r"""Creepages of two rolling bodies at a place of contact, from their motion as rigid bodies.

The contact stands still; the lower body passes through it along -x, and the upper one turns about its axis once per
distance :math:`2\pi R_0`, R0 the rolled radius.  With their velocities v at the place, their mean V, the direction t
across in the tangent plane and the distance s along it

.. math:: \xi = \frac{(v_2-v_1)_x}{V} , \qquad \eta = \frac{(v_2-v_1)_t}{V} , \qquad
          \varphi = -\frac1V\frac{\partial(v_2-v_1)_x}{\partial s} .
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.profile_pair.placing import PlacedBody
from winkler.problems.rolling.creepage import Creepage

__all__ = ["creepage_at"]


def creepage_at(lower: PlacedBody, upper: PlacedBody, place: Array, gap: float, rolled_radius: float) -> Creepage:
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
    """
    slope = float(lower.profile.slope(np.asarray(place[1])))
    length = math.hypot(1.0, slope)
    across = np.array([0.0, 1.0, slope]) / length
    normal = np.array([0.0, -slope, 1.0]) / length
    first, first_change = _motion(lower, place, across, lower.radius)
    second, second_change = _motion(upper, place + gap * normal, across, rolled_radius)
    speed = 0.5 * (float(np.linalg.norm(first)) + float(np.linalg.norm(second)))
    slip = (second - first) / speed
    return Creepage(float(slip[0]), float(slip @ across), -float((second_change - first_change)[0]) / speed)


def _motion(body: PlacedBody, place: Array, across: Array, rolled_radius: float) -> tuple[Array, Array]:
    """Return the velocity of a body at a place, over V, and how it changes across [1/m]."""
    forward, up = body.axes[0], body.axes[2]
    if math.isinf(body.radius):
        return -forward, np.zeros(3)
    a, _, c = body.own(place)
    turning = 1.0 / rolled_radius
    about = c + body.up * body.radius  # from the axis
    velocity = -body.up * turning * (about * forward - a * up)
    change = -body.up * turning * (float(up @ across) * forward - float(forward @ across) * up)
    return velocity, change
