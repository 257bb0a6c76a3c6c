"""Sums over a contact on a grid: what it leaves unsolved, and the load that its pressures share."""

from __future__ import annotations

import math
from typing import Any

from winkler.numerics.arrays import dot, namespace_of
from winkler.values.errors import NotConverged

MOST_SHARING_STEPS = 200
"""Steps to share a load out among pixels that bear no more than the ceiling; five are usual."""


def overlap_and_work(p: Any, gap: Any, depth: float, ceiling: float) -> tuple[float, float]:
    """Return the overlap over the depth, and the work of pressures on gaps over that on the depth.

    Pixels that bear the ceiling may overlap, but not part.
    """
    overlap, spent, load = left_over(p, gap, ceiling)
    borne = abs(load * depth)
    if not math.isfinite(overlap + spent + borne):
        return math.inf, math.inf
    return overlap / abs(depth), spent / borne if borne > 0.0 else 0.0


def unsettled(shape: tuple[int, ...], left: tuple[float, float], done: str, tolerance: float) -> NotConverged:
    """Return the refusal of a contact in which overlap and work, as of `overlap_and_work`, are left after `done`."""
    return NotConverged(
        f"the contact of {shape[0]} x {shape[1]} pixels still overlaps by {left[0]:.3g} of its depth, and pressures do "
        f"{left[1]:.3g} of the work on gaps, after {done}; allowed are {tolerance:.3g} of both. "
        "Allow a larger tolerance, or smooth the heights."
    )


def left_over(p: Any, gap: Any, ceiling: float) -> tuple[float, float, float]:
    """Return the overlap, the work of pressures on gaps, and the sum of pressures."""
    xp = namespace_of(p)
    if math.isinf(ceiling):
        lowest, spent = float(xp.min(gap)), dot(p, xp.abs(gap))
    else:
        soft = p < ceiling
        lowest = float(xp.min(xp.where(soft, gap, 0.0)))
        spent = dot(p, xp.where(soft, xp.abs(gap), xp.clip(gap, 0.0, math.inf)))
    return 0.0 if lowest >= 0.0 else -lowest, spent, float(xp.sum(p, dtype=xp.float64))


def shared(target: Any, ceiling: float, load: float) -> Any:
    """Return pressures between zero and the ceiling that bear the load: those wanted, raised evenly."""
    xp = namespace_of(target)
    low, high = -float(xp.max(target)), ceiling - float(xp.min(target))
    raised, p = 0.0, xp.clip(target, 0.0, ceiling)
    for _ in range(MOST_SHARING_STEPS):
        lacking = load - float(xp.sum(p))
        if abs(lacking) <= 1e-14 * load:
            break
        low, high = (raised, high) if lacking > 0.0 else (low, raised)
        between = int(xp.count_nonzero((p > 0.0) & (p < ceiling)))
        raised += lacking / between if between else math.inf
        raised = raised if low < raised < high else 0.5 * (low + high)
        p = xp.clip(target + raised, 0.0, ceiling)
    return p
