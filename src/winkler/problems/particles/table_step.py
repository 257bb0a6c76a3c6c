r"""A contact without friction as a table: the kernel that interpolates it for other programs.

Up to the first row the force is a power of the depth, as that of every profile that is a power,

.. math:: F = F_1 (d/d_1)^{k_1 d_1/F_1} ,

where the contact begins with no stiffness; from there on the cubic through forces and stiffnesses of two rows.  The
energy is the integral of just this force, so that no cycle creates any.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array


@compiled
def cubic_energy(force: float, first: float, mean: float, last: float, width: float, t: float) -> float:
    """Return the integral over the beginning t of an interval, from the slopes at its ends and its mean slope."""
    second = 3.0 * mean - 2.0 * first - last
    third = first + last - 2.0 * mean
    return width * t * (force + width * t * (0.5 * first + t * (second / 3.0 + 0.25 * third * t)))


@compiled
def all_finite(motion: Array) -> bool:
    """Return whether a motion can be followed: numbers that are not finite would spoil the contact's memory."""
    finite = True
    for k in range(motion.size):
        finite = finite and math.isfinite(motion[k])
    return finite


@compiled
def follow_table(depth: Array, force: Array, stiffness: Array, energy: Array, d: float) -> tuple[float, float, float]:
    """Return force, stiffness and energy at a depth; not-a-number beyond the last row."""
    if d <= 0.0:
        return 0.0, 0.0, 0.0
    last = depth.size - 1
    if not d <= depth[last]:  # nor not-a-number
        return math.nan, math.nan, math.nan
    j = max(int(np.searchsorted(depth, d)) - 1, 0)
    width = depth[j + 1] - depth[j]
    if j == 0 and stiffness[0] == 0.0:
        power = stiffness[1] * depth[1] / force[1]
        f = force[1] * math.pow(d / depth[1], power)
        return f, power * f / d, f * d / (power + 1.0)
    t = (d - depth[j]) / width
    k0 = stiffness[j]
    k1 = stiffness[j + 1]
    mean = (force[j + 1] - force[j]) / width
    second = 3.0 * mean - 2.0 * k0 - k1
    third = k0 + k1 - 2.0 * mean
    f = force[j] + width * t * (k0 + t * (second + third * t))
    k = k0 + t * (2.0 * second + 3.0 * third * t)
    return f, k, energy[j] + cubic_energy(force[j], k0, mean, k1, width, t)


@compiled
def step_table(
    depth: Array, force: Array, stiffness: Array, energy: Array, shear: Array, motion: Array, answer: Array
) -> None:
    """Write force, stiffness and energy of a contact at a depth (1,); and its stiffness against shear where known.

    `shear` (1,) or (0,) is that stiffness over the one against pressing.
    """
    f, k, e = follow_table(depth, force, stiffness, energy, motion[0])
    answer[0] = f
    answer[1] = k
    answer[2] = e
    if shear.size > 0:
        answer[3] = shear[0] * k


@compiled
def step_attracted(
    depth: Array, force: Array, stiffness: Array, energy: Array, pull: Array, motion: Array, answer: Array
) -> None:
    """Write force, stiffness and energy of a contact that a constant force [N], (1,), pulls together while it lasts."""
    f, k, e = follow_table(depth, force, stiffness, energy, motion[0])
    if motion[0] > 0.0:
        f -= pull[0]
        e -= pull[0] * motion[0]
    answer[0] = f
    answer[1] = k
    answer[2] = e


def monotone_intervals(depth: Array, force: Array, stiffness: Array) -> Array:
    """Return in which intervals the stiffness of the interpolation never falls, ``(intervals,)``."""
    mean = np.diff(force) / np.diff(depth)
    second = 3.0 * mean - 2.0 * stiffness[:-1] - stiffness[1:]
    third = stiffness[:-1] + stiffness[1:] - 2.0 * mean
    # the slope of the stiffness is straight: not negative at both ends
    rounding = -1e-12 * stiffness[-1]
    grows = np.asarray((second >= rounding) & (second + 3.0 * third >= rounding))
    if stiffness[0] == 0.0:
        grows[0] = stiffness[1] * depth[1] >= force[1]
    return grows
