r"""Kernels: springs one by one over a whole history, and what a solution states of each of its steps.

A step is that of `winkler.numerics.springs.slip_kernels`, of `winkler.numerics.springs.slip_pull` or of
`winkler.numerics.springs.slip_plane`; the work of the bodies is that of `winkler.numerics.springs.spring_work`.

Arrays of a history: depth and shift have one point more than there are steps; `sums` (4, steps) takes the energy stored
at the end of a step, what is lost in it, the work done in it, and up to where nothing slips.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane
from winkler.numerics.springs.slip_pull import pull_line
from winkler.numerics.springs.spring_work import work_in_plane, work_on_line
from winkler.numerics.types import Array

BOUND_TOLERANCE = 1e-9
"""A spring this close to its bound, in parts of it, slips."""


@compiled
def _stick_radius(u: Array, slips: Array, bound: Array, hold: float, gap: Array, position: Array) -> float:
    """Return the place from which on springs slip: where what is left to the bound, drawn on, ends; else infinity."""
    touching = 0
    for i in range(gap.size):
        touching += 1 if bound[i] > 0.0 else 0
    first = touching
    for i in range(touching):
        most = (1.0 - BOUND_TOLERANCE) * bound[i]
        if slips[i] if hold > 1.0 else u[0, i] * u[0, i] + u[1, i] * u[1, i] >= most * most:
            first = i
            break
    if first == touching:
        return math.inf
    if first < 2 or hold > 1.0:
        return float(position[first]) if first > 0 else 0.0
    near, far = first - 1, first - 2
    left = bound[near] - math.sqrt(u[0, near] * u[0, near] + u[1, near] * u[1, near])
    fall = bound[far] - math.sqrt(u[0, far] * u[0, far] + u[1, far] * u[1, far]) - left
    part = 1.0
    if fall > 0.0:
        part = min(left * (gap[near] - gap[far]) / (fall * (gap[first] - gap[near])), 1.0)
    return float(position[near] + part * (position[first] - position[near]))


@compiled
def follow_line(
    u: Array,
    slips: Array,
    gap: Array,
    stiffness: Array,
    slope: Array,
    position: Array,
    depth: Array,
    target: Array,
    shift: Array,
    force: Array,
    sums: Array,
) -> int:
    """Move springs along a line, of u (2, n), to shifts or, where `target` (steps,) is not empty, to these forces.

    Returns the number of steps that could be done, as `pull_line` does.
    """
    at, bound = np.empty(gap.size), np.empty(gap.size)
    for t in range(force.size):
        at[:] = u[0]
        end, load, stored, lost = t + 2, force[t : t + 1], sums[0, t : t + 1], sums[1, t : t + 1]
        if target.size == 0:
            march_line(u[0], gap, stiffness, slope, depth[t:end], shift[t:end], load, stored, lost)
        elif (
            pull_line(u[0], gap, stiffness, slope, depth[t:end], target[t : t + 1], shift[t:end], load, stored, lost)
            < 1
        ):
            return t
        for i in range(gap.size):
            bound[i] = slope[i] * max(depth[t + 1] - gap[i], 0.0)
        sums[2, t] = work_on_line(at, gap, stiffness, slope, depth[t], depth[t + 1], shift[t + 1] - shift[t])
        sums[3, t] = _stick_radius(u, slips, bound, 1.0, gap, position)
    return int(force.size)


@compiled
def follow_plane(
    u: Array,
    slips: Array,
    gap: Array,
    stiffness: Array,
    bound: Array,
    hold: float,
    position: Array,
    depth: Array,
    shift: Array,
    force: Array,
    sums: Array,
) -> None:
    """Move springs in the plane, as `march_plane` does."""
    at, slid = np.empty(u.shape), np.empty(slips.size, dtype=np.bool_)
    for t in range(sums.shape[1]):
        at[:, :], slid[:] = u, slips
        one, two = slice(t, t + 1), slice(t, t + 2)
        march_plane(
            u, slips, gap, stiffness, bound[two], hold, depth[two], shift[two], force[one], sums[0, one], sums[1, one]
        )
        mx, my = shift[t + 1, 0] - shift[t, 0], shift[t + 1, 1] - shift[t, 1]
        sums[2, t] = work_in_plane(
            at, slid, gap, stiffness, bound[t], bound[t + 1], hold, depth[t], depth[t + 1], mx, my
        )
        sums[3, t] = _stick_radius(u, slips, bound[t + 1], hold, gap, position)
