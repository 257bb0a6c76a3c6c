r"""A contact on layers of high contrast: Newton's steps on the pixels that press, each of which takes energy away.

A stiff layer spreads what one pixel bears over many others, so that pixels which enter together push each other out
again: to let in all that overlap goes in circles from contrasts of some hundred on.  Here pixels enter where the
overlap is greatest of those around, and together once those that press touch.  What would then be pulled is let go, and
the others are brought to touch again before anything is compared: pressures that are only cut off bend the plate.  A
step counts if the energy p G p / 2 + p (h - d) falls, so that no set of pixels comes back; where it does not, the step
before anything was let go is halved until it does.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.plates.face import step_on
from winkler.numerics.plates.pressed_sums import left_over, shared, unsettled
from winkler.numerics.plates.responding_grid import RespondingGrid
from winkler.numerics.plates.screened_inverse import kernel_of
from winkler.numerics.types import Array

MOST_STEPS = 400
"""Steps after which a contact has not converged; ten to a hundred are usual."""
MOST_HALVINGS = 30
"""Of a step, after which less than rounding is left of it."""
MOST_RELEASES = 30
"""How often in a row what would be pulled is let go; three to eight times are usual."""
AROUND = 5
"""Pixels across, of which the one that overlaps most enters."""
ENTERING_RATIO = 0.3
"""Part of the tolerance below which an overlap lets no pixel enter."""
TOUCHING_RATIO, TOGETHER_RATIO = 0.5, 0.1
"""Gaps under what presses, over the greatest overlap, below which all enter that overlap by more than a part of it."""
STEP_TOLERANCE = 0.01
"""Of a step, over what is wrong."""


class PlateContact:
    """A contact while it is being solved, in double digits.

    Parameters
    ----------
    grid : RespondingGrid
        The grid.
    load : float
        Sum of p / E* that is prescribed; nan where the depth is.
    ceiling : float
        Pressure that is not exceeded.
    start, gap : ndarray, (nx, ny)
        Pressures, which bear the load, and gaps under them.
    depth : float
        That belongs to the gaps.
    """

    def __init__(
        self, grid: RespondingGrid, load: float, ceiling: float, start: Array, gap: Array, depth: float
    ) -> None:
        self.grid, self.ceiling, self.p, self.gap, self.depth = grid, ceiling, start, gap, depth
        self.load, self.balanced = load, not math.isnan(load)
        self.kernel, self.periodic = kernel_of(grid), grid.padded == grid.shape
        self.first = np.zeros_like(start)

    def solve(self, tolerance: float) -> int:
        """Solve it, and count the iterations.

        Raises
        ------
        NotConverged
            If it is not solved.
        """
        total, left = 0, (math.inf, math.inf)
        for _ in range(MOST_STEPS):
            soft = (self.p > 0.0) & (self.p < self.ceiling)
            if self.balanced and np.any(soft):
                deeper = float(np.mean(self.gap[soft]))
                self.gap, self.depth = self.gap - deeper, self.depth + deeper
            overlap, work, load = left_over(self.p, self.gap, self.ceiling)
            left = overlap / abs(self.depth), work / abs(load * self.depth)
            if max(left) <= tolerance:
                return total
            free = soft | self._entering(soft, tolerance * abs(self.depth))
            if not np.any(free):
                return total
            settled, count = self._settled(free, 0.1 * tolerance * abs(self.depth))
            total += count
            if not self._moved(settled) and not self._moved(self.first):
                return total  # rounding: the whole surface is looked at again
        raise unsettled(self.p.shape, left, f"{MOST_STEPS} steps", tolerance)

    def _entering(self, soft: Array, least: float) -> Array:
        """Return which of the pixels that bear nothing, or the ceiling, enter."""
        from scipy.ndimage import maximum_filter

        wrong = np.where(self.p <= 0.0, -self.gap, 0.0)
        if math.isfinite(self.ceiling):
            wrong = np.where(self.p >= self.ceiling, self.gap, wrong)
        worst = float(np.max(wrong, initial=0.0))
        apart = float(np.max(np.abs(self.gap[soft]), initial=0.0))
        around = maximum_filter(wrong, AROUND, mode="wrap" if self.periodic else "nearest")
        enters = wrong >= around
        if apart <= TOUCHING_RATIO * worst:
            enters |= wrong >= TOGETHER_RATIO * worst
        return np.asarray(enters & (wrong > ENTERING_RATIO * least))

    def _settled(self, free: Array, least: float) -> tuple[Array, int]:
        """Return changes of pressures after which all that press touch, and the number of iterations.

        What would be pulled, or bear too much, is let go until nothing is.
        """
        p, gap, total = self.p, self.gap, 0
        for attempt in range(MOST_RELEASES):
            wrong = float(np.max(np.abs(gap[free])))
            step, count = step_on(
                self.grid, self.kernel, free, -gap, max(STEP_TOLERANCE * wrong, least), balanced=self.balanced
            )
            total += count + 1
            if attempt == 0:
                self.first = step
            trial = p + step
            p = self._allowed(trial)
            beyond = free & ((trial < 0.0) | (trial > self.ceiling))
            if not np.any(beyond):
                break
            free = free & ~beyond
            if not np.any(free):
                break
            gap = self.gap + self.grid.displaced(p - self.p)
        return p - self.p, total

    def _moved(self, step: Array) -> bool:
        """Go along a step as far as the energy falls; return whether it did."""
        for _ in range(MOST_HALVINGS):
            pressed = self._allowed(self.p + step)
            change = pressed - self.p
            sunk = self.grid.displaced(change)
            if np.vdot(change, self.gap + 0.5 * sunk) < 0.0:
                self.p, self.gap = pressed, self.gap + sunk
                return True
            step = 0.5 * step
        return False

    def _allowed(self, pressed: Array) -> Array:
        """Return the pressures nearest to these that are allowed, and bear the load."""
        clipped = np.clip(pressed, 0.0, self.ceiling)
        if not self.balanced:
            return clipped
        if math.isinf(self.ceiling):
            return clipped * (self.load / float(np.sum(clipped)))
        # what is settled moves only when nothing else is left to
        beyond = np.where(clipped <= 0.0, -self.ceiling, np.where(clipped < self.ceiling, clipped, 2.0 * self.ceiling))
        return np.asarray(shared(beyond, self.ceiling, self.load))
