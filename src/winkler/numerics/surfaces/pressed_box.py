r"""The part of a surface around a contact: pressures, displacements and depth while they are being found.

Conjugate gradients on the pixels in contact, after Polonsky and Keer, preconditioned with the wave number: pixels leave
when their pressure would be negative or more than they bear, and enter when they overlap, or part.
"""

from __future__ import annotations

import logging
import math
from typing import Any, NamedTuple

from winkler.numerics.arrays import cast, dot, namespace_of
from winkler.numerics.plates.pressed_sums import left_over, shared, unsettled
from winkler.numerics.row_blocks import RowBlocks
from winkler.numerics.surfaces.surface_grid import SurfaceGrid

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
        self.rows, self.elastic = RowBlocks(start, grid.workers), math.isinf(ceiling)
        # wrong gaps of the pixels that may change, one in those pixels, the direction, and changes of pressures
        self.wrong, self.kept, self.along, self.more = (self._empty() for _ in range(4))

    def solve(self, tolerance: float, most: int | None = None) -> int:
        """Solve it in so many steps, and count them; in single digits end where nothing is gained any more.

        Raises
        ------
        NotConverged
            If it is not solved in double digits.
        """
        xp, rows = self.xp, self.rows
        single = self.p.dtype == xp.float32
        patience = STEPS_WITHOUT_GAIN if self.digits == xp.float32 else STEPS_OF_STIFF_FILMS
        before = self._empty()
        product, left, best, last, share = 0.0, (math.inf, math.inf), math.inf, 0, 1.0
        most = MOST_ITERATIONS if most is None else most
        for count in range(most):
            pixels, left = self._gaps()
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
            uphill = self.grid.roughly_pressing(self.wrong)
            self._even(uphill, pixels)
            new = rows.dot(self.wrong, uphill)
            held = max((new - rows.dot(before, uphill)) / product, 0.0) if product > 0.0 else 0.0
            self._turn(uphill, held)
            if held > 0.0:
                self._even(self.along, pixels)
            downhill = rows.dot(self.wrong, self.along)
            if not downhill > 0.0:
                self._turn(uphill, 0.0)
                downhill = new
            product = new if self._step(downhill, share, tolerance, RESTART_RATIO * pixels) else 0.0
            before, self.wrong = self.wrong, before
        if single:
            return most
        raise unsettled(self.p.shape, left, f"{most} steps", tolerance)

    def _empty(self) -> Any:
        return cast(self.xp.zeros_like(self.p), self.digits)

    def _unsettled(self, part: Any) -> Any:
        """Where pressures may change: not where they are zero and surfaces apart, nor hard and overlapping."""
        p, gap = self.p[part], self.gap[part]
        inside = (p > 0.0) | (gap < 0.0)
        return inside if self.elastic else inside & ((p < self.ceiling) | (gap > 0.0))

    def _gaps(self) -> tuple[int, tuple[float, float]]:
        """Find what is wrong: return how many pixels may change, and what overlaps and works on gaps."""
        xp, deeper = self.xp, 0.0

        def mean(part: Any) -> tuple[float, float]:
            inside = self._unsettled(part)
            return float(xp.sum(xp.where(inside, self.gap[part], 0.0))), int(xp.count_nonzero(inside))

        def wrong(part: Any) -> tuple[float, float, float, float]:
            self.gap[part] -= deeper
            inside = self._unsettled(part)
            wrong = xp.where(inside, self.gap[part], 0.0)
            self.wrong[part], self.kept[part] = cast(wrong, self.digits), cast(inside, self.digits)
            # outside of what may change nothing overlaps and nothing presses
            return int(xp.count_nonzero(inside)), *left_over(
                self.p[part], wrong if self.elastic else self.gap[part], self.ceiling
            )

        if not math.isnan(self.load):
            gaps, count = self.rows.total(mean)
            if count:  # as deep as the mean of what may still change
                deeper = gaps / count
                self.depth += deeper
        counts, overlaps, works, loads = zip(*self.rows.each(wrong), strict=True)
        return sum(counts), (max(overlaps) / abs(self.depth), sum(works) / abs(sum(loads) * self.depth))

    def _even(self, step: Any, pixels: int) -> None:
        """Keep a step to where pressures may change, and the load as it is; where all would go alike, with the load."""
        xp, mean = self.xp, 0.0

        def kept(part: Any) -> tuple[float]:
            step[part] *= self.kept[part]
            return (float(xp.sum(step[part])),)

        def moved(part: Any) -> tuple[float]:
            step[part] -= mean * self.kept[part]
            return (dot(step[part], step[part]),)

        def greatest(part: Any) -> float:
            return float(xp.max(xp.abs(step[part])))

        (total,) = self.rows.total(kept)
        if math.isnan(self.load) or not pixels:
            return
        mean = total / pixels
        (squares,) = self.rows.total(moved)
        if squares > SUSPECT_RATIO * pixels * mean * mean:
            return
        if max(self.rows.each(greatest)) <= SINGLE_DIGITS_RATIO * abs(mean):
            mean = -mean
            self.rows.total(moved)

    def _turn(self, uphill: Any, held: float) -> None:
        """Go uphill, and by a part of the direction of before."""

        def turned(part: Any) -> None:
            self.along[part] = uphill[part] + held * self.along[part]

        self.rows.each(turned)

    def _step(self, downhill: float, share: float, tolerance: float, most_lost: float) -> bool:
        """Go down along the direction by a share of what it is worth; return whether most of the contact was kept."""
        xp, scale = self.xp, 1.0
        waves, work = self.grid.displacing(self.along)
        length = share * downhill / work

        def moved(part: Any) -> Any:
            pressed = cast(self.along[part], self.p.dtype) * -length
            pressed += self.p[part]
            return pressed

        def tried(part: Any) -> tuple[float, float]:
            pressed = moved(part)
            beyond = pressed < 0.0 if self.elastic else (pressed < 0.0) | (pressed > self.ceiling)
            lost = int(xp.count_nonzero(beyond & (self.along[part] != 0.0)))
            return lost, float(xp.sum(xp.clip(pressed, 0.0, self.ceiling), dtype=xp.float64))

        def changed(part: Any) -> None:
            pressed = xp.clip(moved(part), 0.0, self.ceiling) * scale
            self.more[part] = cast(pressed - self.p[part], self.digits)
            self.p[part] = pressed

        def gone(part: Any) -> None:
            self.p[part] = moved(part)
            self.gap[part] -= length * sunk[part]

        lost, load = self.rows.total(tried)
        if self.elastic and not math.isnan(self.load):
            scale = self.load / load
            scale = scale if abs(scale - 1.0) > LOAD_RATIO * tolerance else 1.0
        if lost or scale != 1.0:
            del waves
            self.rows.each(changed)
            self._sink()
        else:
            sunk = self.grid.numbers(waves)
            self.rows.each(gone)
        if not self.elastic and not math.isnan(self.load):
            self._carry()
        return lost <= most_lost

    def _sink(self) -> None:
        """Change the gaps by the displacements under the changes of the pressures."""
        sunk = self.grid.displaced(self.more)

        def sink(part: Any) -> None:
            self.gap[part] += sunk[part]

        self.rows.each(sink)

    def _carry(self) -> None:
        """Bring pressures below a ceiling to where all together bear the load."""
        if abs(self.load / float(self.xp.sum(self.p)) - 1.0) > 1e-13:
            # what is settled changes when the others have to be raised, or lowered, by more than its own gap requires
            target = self.xp.where(self._unsettled(...), self.p, self.p - self.gap)
            pressed = shared(target, self.ceiling, self.load)
            self.more[...] = cast(pressed - self.p, self.digits)
            self.p[...] = pressed
            self._sink()
