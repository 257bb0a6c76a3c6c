r"""A first guess of a slender contact: slices that press in proportion to their overlap, each for itself.

Under an even force per length q a cylinder approaches by about :math:`\Lambda q/(\pi E^*)`, with
:math:`\Lambda = 2\ln(2L/a)+1` near ten.  Of slices that bear :math:`q = \pi E^*\delta_+/\Lambda` on their overlap
:math:`\delta = d+\vartheta x-z`, approach and tilt under a stated force and moment make

.. math:: \frac{\pi}{2\Lambda}\int\delta_+^2\,\mathrm dx - Fd - M\vartheta

least: a convex function of two numbers, found by Newton's steps that are halved until they go down.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.surfaces.pressed_slender import Pose
from winkler.numerics.types import Array

__all__ = ["first_overlap"]

USUAL = 10.0
MOST_STEPS, MOST_HALVINGS = 100, 40
CLOSE = 1e-3
"""Change of the overlap over the greatest one at which the guess is good enough."""


def first_overlap(x: Array, drop: Array, pose: Pose) -> Array:
    """Return the overlap of each slice, positive where it bears.

    Parameters
    ----------
    x
        Places, evenly.
    drop
        Drop of the generator there, infinite where there is none.
    pose
        What is stated, over E*.
    """
    finite = np.where(np.isfinite(drop), drop, 0.0)
    weights = np.where(np.isfinite(drop), math.pi / USUAL * (x[1] - x[0]), 0.0)
    free = np.array([math.isnan(pose.approach), math.isnan(pose.tilt)])
    middle = 0.5 * float(x[0] + x[-1]) if np.all(free) else 0.0
    loads = np.nan_to_num(np.array([pose.force, pose.moment - middle * pose.force]))
    start = np.nan_to_num(np.array([pose.approach, pose.tilt]))
    if free[0]:
        start[0] = loads[0] / float(np.sum(weights)) + float(np.max(finite - start[1] * x))
    basis = np.stack([np.ones(x.size), x - middle])

    def energy(at: Array) -> float:
        return 0.5 * float(np.sum(weights * np.maximum(at @ basis - finite, 0.0) ** 2)) - float(loads[free] @ at[free])

    level = energy(start)
    for _ in range(MOST_STEPS if np.any(free) else 0):
        overlap = np.maximum(start @ basis - finite, 0.0)
        slope = (basis @ (weights * overlap) - loads)[free]
        bend = ((basis * (weights * (overlap > 0.0))) @ basis.T)[np.ix_(free, free)]
        step = np.zeros(2)
        step[free] = -np.linalg.lstsq(bend, slope, rcond=None)[0]
        for _ in range(MOST_HALVINGS):
            if energy(start + step) <= level:
                break
            step *= 0.5
        start, level = start + step, energy(start + step)
        if np.max(np.abs(step @ basis)) <= CLOSE * float(np.max(overlap)):
            break
    return np.where(np.isfinite(drop), start @ basis - finite, -np.inf)
