r"""Points of a jump-in or a pull-off that takes time: they lie on neither state, and leave the fit.

Between contact and no contact the force of a viscous sample or a slow machine fades over several points.  Next to the
last point in contact, points whose residual exceeds the noise of the far half of the free points belong to the jump,
and half as many beyond, where the rest of it fades below the noise.  Points in contact next to a jump of three points
or more, whose residuals stand out in the same way of those in contact, belong to it, too.

Where the model misses the contact by more than the noise, points in contact count less by that, so that the baseline
is that of the free points.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.events.record import MAD_TO_SIGMA
from winkler.fitting.curves.medians import median
from winkler.fitting.elastic.contact import DirectionRun
from winkler.fitting.misfit import FEWEST_FREE_POINTS
from winkler.numerics.types import Array

LEAST_RATIO = 4.0
"""Least residual of a point of a jump over the typical one of its state."""
FADING_SHARE = 0.5
"""Points beyond a jump, in parts of it, in which its rest fades."""
FEWEST_OF_A_SLOW_JUMP = 3
LEAST_SHARE = 1e-9
"""Noise of clean curves, relative to their greatest residual."""


def beside_jumps(residuals: Array, touched: Array, runs: tuple[DirectionRun, ...]) -> Array:
    """Return the points that belong to no jump ``(n,)``.

    Parameters
    ----------
    residuals : ndarray, (n,)
        Weighted.
    touched : ndarray of bool, (n,)
        Points in contact.
    runs : tuple of DirectionRun
        The parts of one direction.
    """
    kept = np.ones(residuals.shape, dtype=bool)
    for run in runs:
        along = np.arange(run.start, run.stop)[:: -1 if run.inward else 1]  # from contact outward
        inside = int(np.count_nonzero(touched[along]))
        first, last = _jump(residuals[along], inside)
        kept[along[first:last]] = False
    return kept


def missed_in_contact(residuals: Array, touched: Array) -> float:
    """Return the root mean square of the residuals in contact relative to the free ones; 1 without free points."""
    free = residuals[~touched]
    if free.size < FEWEST_FREE_POINTS or not touched.any():
        return 1.0
    noise = max(float(np.std(free)), LEAST_SHARE * float(np.abs(residuals).max()), np.finfo(float).tiny)
    return float(np.sqrt(np.mean(residuals[touched] ** 2))) / noise


def _jump(residuals: Array, inside: int) -> tuple[int, int]:
    """Return the first point of the jump of one run, and the first behind it; both are `inside` without a jump."""
    free = residuals[inside:]
    far = free[free.size // 2 :]
    if inside == 0 or far.size < FEWEST_FREE_POINTS:
        return inside, inside
    level, floor = median(far), LEAST_SHARE * float(np.abs(residuals).max())
    noise = max(MAD_TO_SIGMA * median(np.abs(far - level)), floor)
    outward = _leading(np.abs(free - level) > LEAST_RATIO * noise)
    outward += int(FADING_SHARE * outward)
    if not 0 < outward < free.size // 2:
        return inside, inside
    if outward < FEWEST_OF_A_SLOW_JUMP:
        return inside, inside + outward
    contact = np.abs(residuals[:inside][::-1])
    inward = _leading(contact > LEAST_RATIO * max(median(contact), noise))
    return inside - min(inward, outward), inside + outward


def _leading(chosen: Array) -> int:
    """Return the number of points before the first that is not chosen."""
    return int(np.argmin(np.concatenate([chosen, [False]])))


def of_slow_jumps(count: int) -> Iterator[Flag]:
    """Yield `jump` where several points were left out of a fit, as they belong to jumps that take time."""
    if count >= FEWEST_OF_A_SLOW_JUMP:
        yield Flag(
            "jump",
            f"The jump-in or the pull-off takes time: {count} points between contact and no contact were left out, and "
            "the work of adhesion is one of a process that may depend on the speed.",
        )
