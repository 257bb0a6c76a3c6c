r"""The part of a surface around a contact: pressures, displacements and depth while they are being found.

Conjugate gradients on the pixels in contact, after Polonsky and Keer, preconditioned with the wave number: pixels leave
when their pressure would be negative or more than they bear, and enter when they overlap, or part.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.types import Array

__all__ = ["BoxContact", "ByDepth", "ByLoad", "box_around", "overlap_and_work", "shared"]

MOST_ITERATIONS = 2000
"""Iterations after which a grid has not converged; ten to forty are usual."""
MARGIN_RATIO, LEAST_MARGIN = 16, 4
"""The box is wider than the contact by this part of it, and by this many pixels, on every side."""
STEPS_WITHOUT_GAIN, STEPS_OF_STIFF_FILMS = 30, 200
"""Steps without any gain after which they are made half as long: in single digits, and in double ones."""
SINGLE_DIGITS_RATIO = 1e-5
"""Steps that differ by no more than this part of them are the same in single digits."""
MOST_SHARING_STEPS = 200
"""Steps to share a load out among pixels that bear no more than the ceiling; five are usual."""
RESTART_RATIO = 0.02
"""When a larger part than this of the contact has been lost in one step, the directions of before are forgotten."""


class ByDepth(NamedTuple):
    """The body is held at this depth [m] below its highest point's first touch."""

    depth: float


class ByLoad(NamedTuple):
    """The body is pressed with this sum of p / E* over all pixels."""

    load: float


def box_around(there: Array) -> tuple[slice, slice]:
    """Return the box around these pixels, and somewhat more."""
    import scipy.fft

    sides = []
    for axis, most in enumerate(there.shape):
        places = np.flatnonzero(there.any(axis=1 - axis))
        first, last = int(places[0]), int(places[-1]) + 1
        margin = max(LEAST_MARGIN, (last - first) // MARGIN_RATIO)
        long = min(scipy.fft.next_fast_len(last - first + 2 * margin, True), most)
        begin = min(max((first + last - long) // 2, 0), most - long)
        sides.append(slice(begin, begin + long))
    return sides[0], sides[1]


def overlap_and_work(p: Array, gap: Array, depth: float, ceiling: float) -> tuple[float, float]:
    """Return the overlap over the depth, and the work of pressures on gaps over that on the depth.

    Pixels that bear the ceiling may overlap, but not part.
    """
    soft = p < ceiling
    overlap = max(0.0, -float(np.min(gap, where=soft, initial=0.0)))
    spent = float(np.sum(p * np.where(soft, np.abs(gap), np.maximum(gap, 0.0))))
    borne = abs(float(np.sum(p)) * depth)
    return overlap / abs(depth), spent / borne if borne > 0.0 else 0.0


def shared(target: Array, ceiling: float, load: float) -> Array:
    """Return pressures between zero and the ceiling that bear the load: those wanted, raised evenly."""
    low, high = -float(np.max(target)), ceiling - float(np.min(target))
    raised, p = 0.0, np.clip(target, 0.0, ceiling)
    for _ in range(MOST_SHARING_STEPS):
        lacking = load - float(np.sum(p))
        if abs(lacking) <= 1e-14 * load:
            break
        low, high = (raised, high) if lacking > 0.0 else (low, raised)
        between = int(np.count_nonzero((p > 0.0) & (p < ceiling)))
        raised += lacking / between if between else math.inf
        raised = raised if low < raised < high else 0.5 * (low + high)
        p = np.clip(target + raised, 0.0, ceiling)
    return p


class BoxContact:
    """A contact while it is being solved: pressures p, displacements u under them, and the depth.

    Displacements are changed by those of changes of p, in single digits: the smaller the changes, the better they are.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        heights: Array,
        drive: ByDepth | ByLoad,
        ceiling: float,
        start: Array,
        under: Array,
        depth: float,
    ):
        self.grid, self.heights, self.ceiling = grid, heights, ceiling
        self.load = drive.load if isinstance(drive, ByLoad) else math.nan
        self.p, self.u, self.depth = start, under, depth

    def solve(self, tolerance: float) -> int:
        """Solve it, and count the steps."""
        digits = self.grid.response.dtype.type
        patience = STEPS_WITHOUT_GAIN if digits is np.float32 else STEPS_OF_STIFF_FILMS
        along = before = np.zeros(self.p.shape, dtype=digits)
        product, left, best, last, share = 0.0, (math.inf, math.inf), math.inf, 0, 1.0
        self._carry()
        for count in range(MOST_ITERATIONS):
            gap = self.u + self.heights - self.depth
            inside = self._unsettled(gap)
            if not math.isnan(self.load) and np.any(inside):  # as deep as the mean of what may still change
                deeper = float(np.mean(gap, where=inside))
                self.depth += deeper
                gap -= deeper
                inside = self._unsettled(gap)
            left = overlap_and_work(self.p, gap, self.depth, self.ceiling)
            if max(left) <= tolerance:
                return count
            if max(left) < best:
                best, last = max(left), count
            elif count - last > patience:  # going in circles
                last, share = count, 0.5 * share
            wrong = np.where(inside, gap, 0.0).astype(digits)
            uphill = self._evened(np.where(inside, self.grid.roughly_pressing(wrong), digits(0.0)), inside)
            new = float(np.sum(wrong * uphill))
            held = max((new - float(np.sum(before * uphill))) / product, 0.0) if product > 0.0 else 0.0
            along = np.where(inside, uphill + digits(held) * along, digits(0.0))
            along = self._evened(along, inside)
            along = along if float(np.sum(wrong * along)) > 0.0 else uphill
            before, product = wrong, new if self._step(wrong, along, share, int(np.sum(inside))) else 0.0
        shape = f"{self.heights.shape[0]} x {self.heights.shape[1]}"
        raise NotConverged(
            f"the contact of {shape} pixels still overlaps by {left[0]:.3g} of its depth, and pressures do "
            f"{left[1]:.3g} of the work on gaps, after {MOST_ITERATIONS} steps; allowed are {tolerance:.3g} of both. "
            "Allow a larger tolerance, or smooth the heights."
        )

    def _unsettled(self, gap: Array) -> Array:
        """Where pressures may change: not where they are zero and surfaces apart, nor hard and overlapping."""
        inside = (self.p > 0.0) | (gap < 0.0)
        return inside if math.isinf(self.ceiling) else inside & ((self.p < self.ceiling) | (gap > 0.0))

    def _evened(self, step: Array, inside: Array) -> Array:
        """Return a step of the pressures that leaves the load as it is; where all would go alike, with the load."""
        if math.isnan(self.load) or not np.any(inside):
            return step
        even = step - np.where(inside, np.mean(step, where=inside), step.dtype.type(0.0))
        return even if float(np.max(np.abs(even))) > SINGLE_DIGITS_RATIO * float(np.max(np.abs(step))) else step

    def _step(self, wrong: Array, along: Array, share: float, count: int) -> bool:
        """Go down along a direction by a share of what it is worth; return whether most of the contact was kept."""
        sunk = self.grid.displaced(along)
        length = share * float(np.sum(wrong * along) / np.sum(along * sunk))
        moved = self.p - length * along
        beyond = (moved < 0.0) | (moved > self.ceiling)
        lost = int(np.sum(beyond & (along != 0.0)))
        if np.any(beyond):
            self._change(np.clip(moved, 0.0, self.ceiling))
        else:
            self.p = moved
            self.u = self.u - length * sunk
        self._carry()
        return lost <= RESTART_RATIO * count

    def _change(self, pressure: Array) -> None:
        """Take other pressures."""
        more = (pressure - self.p).astype(self.grid.response.dtype)
        self.u = self.u + self.grid.displaced(more)
        self.p = pressure

    def _carry(self) -> None:
        """Bring the pressures to where all together bear the load."""
        if math.isnan(self.load):
            return
        scale = self.load / float(np.sum(self.p))
        if math.isinf(self.ceiling):
            self.p, self.u = scale * self.p, scale * self.u
        elif abs(scale - 1.0) > 1e-13:
            gap = self.u + self.heights - self.depth
            # what is settled changes when the others have to be raised, or lowered, by more than its own gap requires
            target = np.where(self._unsettled(gap), self.p, self.p - gap)
            self._change(shared(target, self.ceiling, self.load))
