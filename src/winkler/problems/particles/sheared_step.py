"""One step of a contact of any shape that is pressed and moved along the surface: the kernel for other programs."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.types import Array
from winkler.problems.particles.table_step import all_finite, follow_table


@compiled
def own_depth(gap: Array, corners: Array, slopes: Array, force: float, depth: float) -> float:
    """Return the depth [m] at which the springs bear a force [N], so that friction sums to mu times it.

    `corners` (n,) are their forces when each just touches, `slopes` (n,) their stiffness from there on.
    """
    if force <= 0.0:
        return depth
    j = int(np.searchsorted(corners, force)) - 1
    own: float = gap[j] + (force - corners[j]) / slopes[j]
    return own


@compiled
def step_sheared(
    depth: Array, force: Array, stiffness: Array, energy: Array, gap: Array, shear: Array, slope: Array, hold: Array,
    corners: Array, slopes: Array, displaced: Array, slips: Array, past: Array, bound: Array, ends: Array, shift: Array,
    borne: Array, stored: Array, lost: Array, motion: Array, answer: Array,
) -> None:  # fmt: skip
    """Move one contact by one step; within it depth and motion change in proportion.

    Parameters
    ----------
    depth, force, stiffness, energy
        The table of `follow_table`.
    gap, shear, slope : ndarray, (n,)
        Of the springs: g [m], tangential stiffness [N/m], and how far one that slips is displaced over its
        compression.
    hold : ndarray, (1,)
        Static over kinetic friction.
    corners, slopes : ndarray, (n,)
        As in `own_depth`.
    displaced, slips : ndarray, (2, n) and (n,)
        Of the springs: what the contact remembers.
    past : ndarray, (2,)
        Their own depth before the step [m], heat so far [J].
    bound, ends, shift, borne, stored, lost
        Work space, (2, n), (2,), (2, 2), (1, 2), (1,), (1,).
    motion : ndarray, (3,)
        Depth at the end of the step, by which the bodies move in it (2).
    answer : ndarray, (7,)
        Normal force, stiffness, shear force (2), elastic energy of pressing, that of shear, heat so far.
    """
    f, k, e = follow_table(depth, force, stiffness, energy, motion[0])
    if math.isnan(f) or not all_finite(motion):
        for i in range(answer.size):
            answer[i] = math.nan
        return
    own = own_depth(gap, corners, slopes, f, motion[0])
    ends[0] = past[0]
    ends[1] = own
    for i in range(gap.size):
        bound[0, i] = slope[i] * max(past[0] - gap[i], 0.0)
        bound[1, i] = slope[i] * max(own - gap[i], 0.0)
    shift[0, 0] = 0.0
    shift[0, 1] = 0.0
    shift[1, 0] = motion[1]
    shift[1, 1] = motion[2]
    march_plane(displaced, slips, gap, shear, bound, hold[0], ends, shift, borne, stored, lost)
    past[0] = own
    past[1] += lost[0]
    answer[0] = f
    answer[1] = k
    answer[2] = borne[0, 0]
    answer[3] = borne[0, 1]
    answer[4] = e
    answer[5] = stored[0]
    answer[6] = past[1]
