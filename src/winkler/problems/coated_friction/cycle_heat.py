r"""Where a contact on layers releases heat that is pushed to and fro: traction times slip, ring by ring.

Under a steady load a ring slides only at its bound, and to one side between two turning points of the motion, so that a
cycle releases :math:`\mu\,p(r)\sum|\Delta s(r)|` over these points, without error of the steps.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.numerics.types import Array
from winkler.problems.coated_friction.tangential import CoatedTangentialSolution

__all__ = ["losses_on_layers"]

STEADY = 1e-12
"""Part of the depth by which it may vary and count as steady."""


def losses_on_layers(march: CoatedTangentialSolution, begin: int, r: Array) -> Array:
    """Return the heat per area of a cycle [J/m^2].

    Parameters
    ----------
    march : CoatedTangentialSolution
        It ends with the cycle.
    begin : int
        The state with which the cycle begins.
    r : ndarray
        Distances from the axis [m].
    """
    states, depth = march.states[begin:], march.depth[begin:]
    if np.ptp(depth) > STEADY * np.max(depth):
        return _trapezoids(march, begin, r)
    moves = np.diff(march.shift[begin:])
    moving = np.flatnonzero(moves) + 1
    turns = moving[:-1][np.diff(np.sign(moves[moving - 1])) != 0.0]
    slips = np.stack([states[index].slip(r) for index in (0, *turns.tolist(), len(states) - 1)])
    bed = march.problem.bed
    pressure = bed.medium.pressure(PressedSprings(bed, float(depth[0]), states[0].radius), r)
    return np.asarray(march.problem.law.coefficient * pressure * np.sum(np.abs(np.diff(slips, axis=0)), axis=0))


def _trapezoids(march: CoatedTangentialSolution, begin: int, r: Array) -> Array:
    """Return the same under a load that varies, by the trapezoidal rule over the points of the cycle."""
    states = march.states[begin:]
    tractions, slips = (np.stack([getattr(state, word)(r) for state in states]) for word in ("traction", "slip"))
    released = np.sum(0.5 * (tractions[1:] + tractions[:-1]) * np.diff(slips, axis=0), axis=0)
    return np.asarray(np.maximum(released, 0.0))
