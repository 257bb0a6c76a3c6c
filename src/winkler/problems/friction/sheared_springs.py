"""From what springs remember to the fields: the springs of a sheared contact as a sum of ramps and steps.

Solvers that follow springs along the surface hold their displacement as straight pieces over the gap g(x); restoring
the traction needs the pile of earlier contacts that they amount to.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.sheared import ShearedSprings
from winkler.loading.loads import Depth
from winkler.numerics.types import Array, Quantity
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.stiffness_ratio import common_ratio

NARROWEST_PIECE = 1e-12
"""Pieces narrower than this, in parts of the depth, are none; steps smaller, in parts of the greatest displacement."""
ON_LAYERS = (
    "tractions are no sums of pressures there, and cannot be restored from springs: use the method rings, which "
    "restores them on bonded layers and on gradings in depth, or a homogeneous or power-law medium"
)


def sheared_by_pieces(
    bed: Bed, depth: float, shift: Quantity, edges: Array, left: Array, right: Array
) -> ShearedSprings:
    """Return the springs whose displacement along the surface is straight between gaps.

    Parameters
    ----------
    bed : Bed
    depth : float
        d [m]; no contact unless positive.
    shift : float or ndarray, (2,)
        u_x [m].
    edges : ndarray, (m + 1,)
        Gaps at which the pieces meet [m], from 0 to at most the depth.
    left, right : ndarray, (m,) or (m, 2)
        Displacement of the springs at both ends of every piece [m].

    Raises
    ------
    OutsideValidity
        If tangential and normal stiffness of the springs are not in proportion, as on layers: their tractions are then
        no sums of pressures.
    """
    edges, left, right = (np.asarray(part, dtype=float) for part in (edges, left, right))
    moved = np.asarray(shift, dtype=float)
    radius = float(Indentation(bed, Depth(depth)).solve().radius)
    pressed = PressedSprings(bed, depth, radius)
    if radius == 0.0 or left.shape[0] == 0:
        empty = np.zeros((0, *moved.shape))
        return ShearedSprings(pressed, 1.0, moved, np.zeros(0), np.zeros(0), empty, empty)
    wide = np.diff(edges) > NARROWEST_PIECE * depth
    low, high, left, right = edges[:-1][wide], edges[1:][wide], left[wide], right[wide]
    rise = (right - left) / (high - low).reshape(-1, *(1,) * moved.ndim)
    nothing = np.zeros((1, *moved.shape))
    slopes = np.concatenate([rise[1:], nothing]) - rise
    steps = right - np.concatenate([left[1:], nothing])
    steps[np.abs(steps) <= NARROWEST_PIECE * float(np.max(np.abs([left, right]), initial=0.0))] = 0.0
    ratio = common_ratio("Tangential", bed, radius, ON_LAYERS)
    radii = np.asarray(Indentation(bed, Depth(high)).solve().radius)
    return ShearedSprings(pressed, ratio, moved, high, np.minimum(radii, radius), slopes, steps)
