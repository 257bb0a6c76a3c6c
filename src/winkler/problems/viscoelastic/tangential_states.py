"""One moment of a viscoelastic contact that is dragged along the surface, with its springs."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["ViscoelasticTangentialState", "stick_radius"]


@value
class ViscoelasticTangentialState:
    """A dragged viscoelastic contact at one moment.

    Parameters
    ----------
    time : float
        [s].
    depth, force, radius : float
        d [m], F_N [N], a [m].
    shift, shear_force : float
        u_x [m] and F_x [N].
    stick_radius : float
        Up to which all springs stick [m]: a where all do, zero where that on the axis slides.
    work, stored_energy : float
        What was spent since the beginning, and what all springs store, in both directions [J].
    friction_loss, bulk_loss, dissipation : float
        Lost since the beginning to friction, in the dashpots of the bodies, and both together [J].
    position : ndarray, (n,)
        Places x of the springs [m].
    line_load, shear_load : ndarray, (n,)
        q_z and q_x [N/m].
    recess, displacement : ndarray, (n,)
        How far every spring is pressed in, and displaced along the surface [m], or has not yet recovered.
    sticking : ndarray, (n,)
        Which springs stick.
    """

    __words__ = words(
        work=("W", "J", "what the machine has spent since the beginning"),
        stored_energy=("U", "J", "energy stored in all springs, both directions"),
        displacement=("u_t", "m", "displacement of every spring along the surface"),
    )

    time: float
    depth: float
    force: float
    radius: float
    shift: float
    shear_force: float
    stick_radius: float
    work: float
    stored_energy: float
    friction_loss: float
    bulk_loss: float
    dissipation: float
    position: Array
    line_load: Array
    shear_load: Array
    recess: Array
    displacement: Array
    sticking: Array


def stick_radius(position: Array, stuck: Array, slack: Array, radius: float) -> float:
    """Return up to where all springs stick [m].

    Parameters
    ----------
    position : ndarray, (n,)
        Places of the springs [m].
    stuck : ndarray, (n,)
        Which of them stick.
    slack : ndarray, (n,)
        What they could bear more than they do; it vanishes in a straight line at the edge.
    radius : float
        a [m].
    """
    moving = np.flatnonzero(~stuck)
    first = int(moving[0]) if moving.size else position.size
    if first == 0 or position[first - 1] >= radius:
        return radius if first else 0.0
    edge = 0.5 * (position[first - 1] + position[min(first, position.size - 1)])
    if first > 1 and math.isfinite(slack[first - 2]) and slack[first - 2] > slack[first - 1]:
        fall = (slack[first - 2] - slack[first - 1]) / (position[first - 1] - position[first - 2])
        edge = min(position[first - 1] + slack[first - 1] / fall, position[min(first, position.size - 1)])
    return float(min(edge, radius))
