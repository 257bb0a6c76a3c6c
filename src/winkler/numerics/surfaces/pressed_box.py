r"""The part of a surface around a contact: pressures, displacements and depth while they are being found.

Conjugate gradients on the pixels in contact, after Polonsky and Keer, preconditioned with the wave number: pixels leave
when their pressure would be negative or more than they bear, and enter when they overlap, or part.
"""

from __future__ import annotations

import logging
import math
from typing import Any, NamedTuple

from winkler.errors import NotConverged
from winkler.numerics.arrays import cast, dot, namespace_of
from winkler.numerics.surfaces.surface_grid import SurfaceGrid

__all__ = ["BoxContact", "ByDepth", "ByLoad", "box_around", "overlap_and_work", "shared"]

LOG = logging.getLogger(__name__)
REPORTED_PIXELS = 2**18
"""Pixels from which on every step is reported, to who listens to the log."""
MOST_ITERATIONS = 2000
"""Iterations after which a grid has not converged; ten to forty are usual."""
MARGIN_RATIO, LEAST_MARGIN = 16, 4
"""The box is wider than the contact by this part of it, and by this many pixels, on every side."""
STEPS_WITHOUT_GAIN, STEPS_OF_STIFF_FILMS = 30, 200
"""Steps without any gain after which they are made half as long: in single digits, and in double ones."""
SINGLE_DIGITS_RATIO = 1e-5
"""Steps that differ by no more than this part of them are the same in single digits;"""
SUSPECT_RATIO = 1e-4
"""mean squares are compared first."""
LOAD_RATIO = 0.5
"""Part of the tolerance by which the load may be off during the steps."""
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


def box_around(there: Any) -> tuple[slice, slice]:
    """Return the box around these pixels, and somewhat more."""
    import scipy.fft

    sides = []
    xp = namespace_of(there)
    for axis, most in enumerate(there.shape):
        places = xp.nonzero(xp.any(there, axis=1 - axis))[0]
        first, last = int(places[0]), int(places[-1]) + 1
        margin = max(LEAST_MARGIN, (last - first) // MARGIN_RATIO)
        long = min(scipy.fft.next_fast_len(last - first + 2 * margin, True), most)
        begin = min(max((first + last - long) // 2, 0), most - long)
        sides.append(slice(begin, begin + long))
    return sides[0], sides[1]


def overlap_and_work(p: Any, gap: Any, depth: float, ceiling: float) -> tuple[float, float]:
    """Return the overlap over the depth, and the work of pressures on gaps over that on the depth.

    Pixels that bear the ceiling may overlap, but not part.
    """
    xp = namespace_of(p)
    if math.isinf(ceiling):
        overlap, spent = max(0.0, -float(xp.min(gap))), dot(p, xp.abs(gap))
    else:
        soft = p < ceiling
        overlap = max(0.0, -float(xp.min(xp.where(soft, gap, 0.0))))
        spent = dot(p, xp.where(soft, xp.abs(gap), xp.maximum(gap, xp.zeros_like(gap))))
    return overlap / abs(depth), spent / abs(float(xp.sum(p)) * depth)


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


class BoxContact:
    """A contact while it is being solved: pressures p, gaps under them, and the depth.

    Gaps are changed by the displacements under changes of p, in the digits of the grid: the smaller the changes, the
    better they are.  Pressures and gaps may be in single digits as well; then it may end before it is solved.

    Parameters
    ----------
    grid
        The grid, whose digits are those of the steps.
    drive
        What is prescribed.
    ceiling
        Pressure that is not exceeded.
    start, gap
        Pressures, which bear the load, and gaps under them, which are overwritten.
    depth
        That belongs to the gaps.
    """

    def __init__(self, grid: SurfaceGrid, drive: ByDepth | ByLoad, ceiling: float, start: Any, gap: Any, depth: float):
        self.grid, self.ceiling = grid, ceiling
        self.load = drive.load if isinstance(drive, ByLoad) else math.nan
        self.p, self.gap, self.depth = start, gap, depth
        self.xp, self.digits = namespace_of(start), grid.response.dtype

    def solve(self, tolerance: float) -> int:
        """Solve it, and count the steps; in single digits end where nothing is gained any more.

        Raises
        ------
        NotConverged
            If it is not solved in double digits.
        """
        xp, loaded = self.xp, not math.isnan(self.load)
        single = self.p.dtype == xp.float32
        patience = STEPS_WITHOUT_GAIN if self.digits == xp.float32 else STEPS_OF_STIFF_FILMS
        along: Any = 0.0
        before: Any = None
        product, left, best, last, share = 0.0, (math.inf, math.inf), math.inf, 0, 1.0
        for count in range(MOST_ITERATIONS):
            inside = self._unsettled()
            if loaded and bool(xp.any(inside)):  # as deep as the mean of what may still change
                deeper = self._mean(xp.where(inside, self.gap, 0.0), inside)
                self.depth += deeper
                self.gap -= deeper
                inside = self._unsettled()
            wrong = xp.where(inside, self.gap, 0.0)
            # outside of what may change nothing overlaps and nothing presses
            left = overlap_and_work(self.p, wrong if math.isinf(self.ceiling) else self.gap, self.depth, self.ceiling)
            if math.prod(self.p.shape) >= REPORTED_PIXELS:
                LOG.info(
                    "%d x %d pixels, step %d: misfit %.1e, %.0e allowed", *self.p.shape, count, max(left), tolerance
                )
            if max(left) <= tolerance:
                return count
            if max(left) < best:
                best, last = max(left), count
            elif count - last > patience:  # going in circles
                if single:
                    return count
                last, share = count, 0.5 * share
            wrong, kept = cast(wrong, self.digits), cast(inside, self.digits)
            uphill = self.grid.roughly_pressing(wrong)
            uphill *= kept
            uphill = self._evened(uphill, kept)
            new = dot(wrong, uphill)
            held = max((new - dot(before, uphill)) / product, 0.0) if product > 0.0 else 0.0
            if held > 0.0:
                along *= kept
                along *= held
                along += uphill
                along = self._evened(along, kept)
            else:
                along = xp.asarray(uphill, copy=True)
            downhill = dot(wrong, along)
            if not downhill > 0.0:
                along, downhill = uphill, new
            before, product = wrong, new
            if not self._step(along, downhill, share, tolerance, RESTART_RATIO * float(xp.sum(kept))):
                product = 0.0
        shape = f"{self.p.shape[0]} x {self.p.shape[1]}"
        raise NotConverged(
            f"the contact of {shape} pixels still overlaps by {left[0]:.3g} of its depth, and pressures do "
            f"{left[1]:.3g} of the work on gaps, after {MOST_ITERATIONS} steps; allowed are {tolerance:.3g} of both. "
            "Allow a larger tolerance, or smooth the heights."
        )

    def _unsettled(self) -> Any:
        """Where pressures may change: not where they are zero and surfaces apart, nor hard and overlapping."""
        inside = (self.p > 0.0) | (self.gap < 0.0)
        return inside if math.isinf(self.ceiling) else inside & ((self.p < self.ceiling) | (self.gap > 0.0))

    def _mean(self, numbers: Any, where: Any) -> float:
        """Return the mean over these pixels of numbers that are zero in the others."""
        return float(self.xp.sum(numbers)) / int(self.xp.count_nonzero(where))

    def _evened(self, step: Any, kept: Any) -> Any:
        """Return a step of the pressures that leaves the load as it is; where all would go alike, with the load."""
        xp = self.xp
        pixels = int(xp.count_nonzero(kept))
        if math.isnan(self.load) or not pixels:
            return step
        mean = float(xp.sum(step)) / pixels
        even = kept * -mean
        even += step
        if dot(even, even) > SUSPECT_RATIO * pixels * mean * mean:
            return even
        return even if float(xp.max(xp.abs(even))) > SINGLE_DIGITS_RATIO * float(xp.max(xp.abs(step))) else step

    def _step(self, along: Any, downhill: float, share: float, tolerance: float, most_lost: float) -> bool:
        """Go down along a direction by a share of what it is worth; return whether most of the contact was kept."""
        xp, lost, scale = self.xp, 0, 1.0
        sunk = self.grid.displaced(along)
        length = share * downhill / dot(along, sunk)
        moved = cast(along, self.p.dtype) * -length
        moved += self.p
        beyond = (moved < 0.0) | (moved > self.ceiling) if math.isfinite(self.ceiling) else moved < 0.0
        if bool(xp.any(beyond)):
            lost = int(xp.count_nonzero(beyond & (along != 0.0)))
            moved = xp.clip(moved, 0.0, self.ceiling)
        if math.isinf(self.ceiling) and not math.isnan(self.load):
            scale = self.load / float(xp.sum(moved, dtype=xp.float64))
            scale = scale if abs(scale - 1.0) > LOAD_RATIO * tolerance else 1.0
        if lost or scale != 1.0:
            moved *= scale
            self._change(moved)
        else:
            sunk *= length
            self.p = moved
            self.gap -= sunk
        if math.isfinite(self.ceiling) and not math.isnan(self.load):
            self._carry()
        return lost <= most_lost

    def _change(self, pressure: Any) -> None:
        """Take other pressures."""
        self.gap += self.grid.displaced(cast(pressure - self.p, self.digits))
        self.p = pressure

    def _carry(self) -> None:
        """Bring pressures below a ceiling to where all together bear the load."""
        if abs(self.load / float(self.xp.sum(self.p)) - 1.0) > 1e-13:
            # what is settled changes when the others have to be raised, or lowered, by more than its own gap requires
            target = self.xp.where(self._unsettled(), self.p, self.p - self.gap)
            self._change(shared(target, self.ceiling, self.load))
