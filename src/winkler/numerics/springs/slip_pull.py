r"""Kernels: the displacement along a line at which springs that stick and slip bear a given force."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.jit import compiled
from winkler.numerics.springs.slip_kernels import FORCE_TOLERANCE, MOST_STEPS, march_line
from winkler.numerics.types import Array


@compiled
def _pull(
    u: Array, gap: Array, stiffness: Array, slope: Array, first: float, depth: float, moved: float
) -> tuple[float, float]:
    """Return the force if the bodies moved, and how fast it would still rise."""
    before, after = np.searchsorted(gap, first), np.searchsorted(gap, depth)
    pull = 0.0
    rise = 0.0
    for i in range(after):
        share = 1.0 if i < before else (depth - gap[i]) / (depth - first)
        bound = slope[i] * (depth - gap[i])
        trial = (u[i] if i < before else 0.0) + share * moved
        if trial > bound:
            pull += stiffness[i] * bound
        elif trial < -bound:
            pull -= stiffness[i] * bound
        else:
            pull += stiffness[i] * trial
            rise += stiffness[i] * share
    return pull, rise


@compiled
def _target_motion(
    u: Array, gap: Array, stiffness: Array, slope: Array, first: float, depth: float, target: float, close: float
) -> float:
    """Return by how much the bodies move until the force is `target`; not a number if it never is."""
    if gap.size == 0 or depth <= gap[0]:
        return 0.0 if target == 0.0 else math.nan
    most = slope.max() * ((depth - gap[0]) + max(first - gap[0], 0.0))
    low = -most
    high = most
    moved = 0.0
    for _ in range(MOST_STEPS):
        pull, rise = _pull(u, gap, stiffness, slope, first, depth, moved)
        short = target - pull
        if abs(short) <= close:
            return moved
        if short > 0.0:
            low = moved
        else:
            high = moved
        guess = moved + short / rise if rise > 0.0 else math.inf
        if not (low < guess < high):
            guess = 0.5 * (low + high)
            if guess in (low, high):
                break
        moved = guess
    # the force is a rising line with corners: what is left is what the last digits of the distance decide
    pull, rise = _pull(u, gap, stiffness, slope, first, depth, moved)
    return moved if abs(target - pull) <= 1e3 * close else math.nan


@compiled
def pull_line(
    u: Array,
    gap: Array,
    stiffness: Array,
    slope: Array,
    depth: Array,
    target: Array,
    shift: Array,
    force: Array,
    stored: Array,
    lost: Array,
) -> int:
    """Do what `march_line` does for prescribed forces `target` (steps,); shift (steps + 1,) is filled after its first.

    Returns the number of steps that could be done; one less than requested where the springs bear no such force.
    """
    for t in range(target.size):
        scale = abs(target[t])
        for i in range(gap.size):
            scale += stiffness[i] * abs(u[i])
        moved = _target_motion(u, gap, stiffness, slope, depth[t], depth[t + 1], target[t], FORCE_TOLERANCE * scale)
        if math.isnan(moved):
            return t
        shift[t + 1] = shift[t] + moved
        march_line(
            u,
            gap,
            stiffness,
            slope,
            depth[t : t + 2],
            shift[t : t + 2],
            force[t : t + 1],
            stored[t : t + 1],
            lost[t : t + 1],
        )
    return int(target.size)
