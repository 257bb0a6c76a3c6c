r"""A body pressed on a half-space on a slender grid: which elements bear, and what, by active sets.

On the elements that bear, the displacement closes the gap,

.. math:: S\,p = A\,(d + \vartheta x - h) ,

which is linear in the approach d and the tilt: a field for each of them gives the pressures, and the approach or tilt
that belongs to a stated force or moment.  Elements that would pull are left out, those that overlap are taken in, until
there are none of either.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.surfaces.slender_grid import SlenderGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_SETS, MOST_STEPS = 60, 200
"""Sets of elements tried, and steps of conjugate gradients for each of them; some ten and twenty are usual."""
RESIDUALS = (1e-5, 1e-12)
"""Residual of a linear system over its right side: while the set of elements changes much, and of the result."""
NEGLIGIBLE = (1e-3, 1e-7)
"""Tension over the greatest pressure, and overlap over the depth, at which a set counts as the contact."""


class Pose(NamedTuple):
    """What is stated: force over E* [m^2] or approach [m], moment over E* [m^3] or tilt [rad]; the others are nan."""

    force: float
    approach: float
    moment: float
    tilt: float


class PressedSlender(NamedTuple):
    """The pressed body.

    Parameters
    ----------
    pressure
        p / E* on the positive side, (n, rows).
    approach, tilt
        d [m], and the tilt [rad].
    force, moment
        Over E*, of both sides.
    stiffness
        Force over E* per approach at a fixed tilt or a fixed moment, as was stated [m].
    """

    pressure: Array
    approach: float
    tilt: float
    force: float
    moment: float
    stiffness: float


def press_slender(grid: SlenderGrid, gaps: Array, pose: Pose, start: Array) -> PressedSlender:
    """Solve the contact.

    Parameters
    ----------
    grid
        The grid.
    gaps
        h [m] before contact, (n, rows), growing from the middle outwards.
    pose
        What is stated.
    start
        Elements that bear to begin with, (n, rows), in each slice those up to some distance from the middle.

    Raises
    ------
    NotConverged
        If no set of elements is found.
    """
    areas, middle = grid.areas[:, None], 0.5 * float(grid.edges[0] + grid.edges[-1])
    x = grid.middles[:, None] - middle  # a short contact far from the middle of the body is as good as any
    free = math.isnan(pose.tilt)
    turned = np.zeros(gaps.shape) if free else pose.tilt * x
    loads = np.stack([areas * (turned - gaps), np.broadcast_to(areas, gaps.shape), areas * x + 0.0 * gaps][: 2 + free])
    bearing, fields, stage = start, np.zeros(loads.shape), 0
    for _ in range(MOST_SETS):
        fields = _fields(grid, loads, bearing, fields, RESIDUALS[stage])
        sums = 2.0 * np.sum(fields * areas, axis=(1, 2)), 2.0 * np.sum(fields * areas * x, axis=(1, 2))
        try:
            approach, tilt, stiffness = _posed(sums, pose, middle)
        except np.linalg.LinAlgError:  # a single slice has no tilt
            break
        weights = np.array([1.0, approach, tilt][: 2 + free])
        pressure = np.tensordot(weights, fields, axes=1)
        if not np.max(pressure) > 0.0:  # numbers too far from each other
            break
        depth = approach + tilt * x - gaps
        overlap = depth - grid.displaced(pressure[None])[0] / areas
        pulls = bearing & (pressure < -NEGLIGIBLE[stage] * np.max(pressure))
        meets = ~bearing & (overlap > NEGLIGIBLE[stage] * np.max(depth))
        if not (np.any(pulls) or np.any(meets)):
            if stage == 0:
                stage = 1
                continue
            force, moment = (float(one @ weights) for one in sums)
            approach, moment = approach - tilt * middle, moment + force * middle
            return PressedSlender(np.maximum(pressure, 0.0), approach, tilt, force, moment, stiffness)
        bearing = np.cumprod((bearing & ~pulls) | meets, axis=1).astype(bool)
    raise NotConverged(
        f"the contact on {gaps.shape[0]} x {gaps.shape[1]} elements was not found in {MOST_SETS} sets of elements; "
        "tilt it less, or change the number of elements."
    )


def _posed(sums: tuple[Array, Array], pose: Pose, middle: float) -> tuple[float, float, float]:
    """Return approach and tilt under which force and moment are as stated, and the stiffness.

    The sums and the approach that is returned are those about the middle of the grid, what is stated about zero.
    """
    forces, moments = sums
    if not math.isnan(pose.tilt):
        approach = pose.approach + pose.tilt * middle
        if math.isnan(approach):
            approach = (pose.force - forces[0]) / forces[1]
        return float(approach), pose.tilt, float(forces[1])
    about_zero = moments + middle * forces
    places = np.array([1.0, -middle])
    rise = np.linalg.solve(np.array([places, about_zero[1:]]), np.array([1.0, 0.0]))
    if math.isnan(pose.approach):
        rows = np.array([forces[1:], moments[1:]])
        right = np.array([pose.force - forces[0], pose.moment - middle * pose.force - moments[0]])
    else:
        rows, right = np.array([places, about_zero[1:]]), np.array([pose.approach, pose.moment - about_zero[0]])
    approach, tilt = np.linalg.solve(rows, right)
    return float(approach), float(tilt), float(forces[1:] @ rise)


def _fields(grid: SlenderGrid, loads: Array, bearing: Array, start: Array, residual: float) -> Array:
    """Return the pressures under each load on the elements that bear, by conjugate gradients."""
    right = np.where(bearing, loads, 0.0)
    fields = np.where(bearing, start, 0.0)
    left = right - np.where(bearing, grid.displaced(fields), 0.0)

    def dot(one: Array, other: Array) -> Array:
        return np.asarray(np.einsum("cij,cij->c", one, other))[:, None, None]

    pressed = grid.roughly_pressing(right, bearing)
    enough = residual**2 * dot(right, pressed)
    along = np.zeros(loads.shape)
    before = np.ones((loads.shape[0], 1, 1))
    for _ in range(MOST_STEPS):
        pressed = grid.roughly_pressing(left, bearing)
        now = dot(left, pressed)
        if np.all(now <= enough):
            break
        along = pressed + now / before * along
        moved = np.where(bearing, grid.displaced(along), 0.0)
        curvature = dot(along, moved)
        length = np.where(curvature > 0.0, now / np.where(curvature > 0.0, curvature, 1.0), 0.0)
        fields, left, before = fields + length * along, left - length * moved, np.where(now > 0.0, now, 1.0)
    return fields
