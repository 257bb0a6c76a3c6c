"""Whether a model explains a curve: its residuals in contact against the noise out of contact.

A part of a few points is a misfit of its own where most residuals in a row far exceed the usual noise out of contact.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.events.record import MAD_TO_SIGMA
from winkler.fitting.curves.medians import median
from winkler.fitting.noise.estimate import noise_of
from winkler.numerics.types import Array

MISFIT_LIMIT = 2.0
"""Squared misfit over the noise, per degree of freedom, from which on a model does not explain a curve."""
MISFIT_CONFIDENCE = 0.999
"""Part of correct models whose misfit in contact stays below its limit."""
FEWEST_FREE_POINTS = 20
"""Fewest free points for an estimate of the noise."""
ROW = 9
"""Points in a row, of which the median residual counts."""
LEVELS = 0.9, 0.6
"""Parts of the residuals below the levels by which the rows are found whose median may be the greatest."""
LEAST_USUAL = 0.1
"""Least usual noise, relative to the standard deviation: of digits whose median is none."""
LOCAL_LIMIT = 8.0
"""Median residual of a row over the noise, from which on the model does not explain this part of the curve."""


class Misfit(NamedTuple):
    """Squared misfits over the noise, on the whole and in contact, and the limit in contact.

    Where the misfits are within the limits of white noise, `limit` and `local` are those of white noise.  `local` is
    the greatest median residual in a row of points over the usual noise, and `place` the middle of the row.
    """

    whole: float
    contact: float
    limit: float
    local: float
    place: int

    @property
    def on_the_whole(self) -> bool:
        """Whether the model explains the curve, but perhaps for a part of few points."""
        return self.whole <= MISFIT_LIMIT and self.contact <= self.limit

    @property
    def explained(self) -> bool:
        """Whether the model explains the curve."""
        return self.on_the_whole and self.local <= LOCAL_LIMIT


def misfit_of(residuals: Array, touched: Array, counted: Array, freedoms: tuple[float, float], noise: float) -> Misfit:
    """Return the misfit of a model.

    The noise out of contact states how far residuals in contact vary: slow noise has fewer independent points, and
    grows with their number.

    Parameters
    ----------
    residuals : ndarray, (n,)
        Weighted, without drift, tilt and drag.
    touched, counted : ndarray of bool, (n,)
        Points in contact, and points that were fitted.
    freedoms : tuple of float
        Degrees of freedom on the whole, and in contact.
    noise : float
        Standard deviation, in the residuals' unit; that out of contact, where it is less.
    """
    free = ~touched & counted
    count, own = int(np.count_nonzero(free)), residuals[free]
    has_free = count >= FEWEST_FREE_POINTS
    if has_free:
        own = own - own.mean()
        noise = min(noise, float(np.sqrt(np.mean(own**2)))) or noise
    level = max(noise, 1e-12 * float(np.abs(residuals).max()), np.finfo(float).tiny)
    whole, contact = (float(np.sum((r / level) ** 2)) for r in (residuals[counted], residuals[touched & counted]))
    local, place = 0.0, 0
    if has_free:
        usual = MAD_TO_SIGMA * median(np.abs(own - median(own))) or level
        local, place = _greatest_row(residuals[counted])
        local, place = local / max(usual, level * LEAST_USUAL), int(np.flatnonzero(counted)[place])
    found = Misfit(whole / freedoms[0], contact / freedoms[1], MISFIT_LIMIT, local, place)
    if found.explained:  # slow noise only raises the limits
        return found
    inside = int(np.count_nonzero(touched & counted))
    limit, growth = _slow_limit(own if has_free else own[:0], inside, freedoms[1])
    return found._replace(limit=limit, local=local / float(np.sqrt(growth)))


def _slow_limit(own: Array, inside: int, freedom: float) -> tuple[float, float]:
    """Return the limit of the misfit of points in contact, and how slow noise grows with their number.

    Parameters
    ----------
    own : ndarray, (m,)
        Residuals out of contact without their mean; none: the noise is taken for white.
    inside : int
        Number of points in contact.
    freedom : float
        Their degrees of freedom.
    """
    from scipy.special import gammaincinv

    share, growth, count = 1.0, 1.0, own.size
    if count:
        spectrum = noise_of(own, np.ones((count, 1)), np.zeros((count, 0))).spectrum[1:]
        inside = max(inside, 2)
        along = np.interp(np.arange(1, inside) / inside, np.arange(1, count) / count, spectrum)
        share = float(along.sum() ** 2 / (along @ along)) / along.size
        growth = max(float(along.mean() / spectrum.mean()), 1.0)
    half = 0.5 * max(freedom * share, 1.0)
    return growth * max(MISFIT_LIMIT, float(gammaincinv(half, MISFIT_CONFIDENCE)) / half), growth


def _greatest_row(residuals: Array) -> tuple[float, int]:
    """Return the greatest median residual of points in a row, as a standard deviation, and the middle of the row."""
    if residuals.size < ROW:
        return 0.0, 0
    sizes, rows = np.abs(residuals), np.arange(residuals.size - ROW + 1)
    for share in LEVELS:  # the median of a row is above a level where most of its points are
        place = int(share * sizes.size)
        above = np.cumsum(np.concatenate([[0], sizes > np.partition(sizes, place)[place]]))
        high = np.flatnonzero(above[ROW:] - above[:-ROW] > ROW // 2)
        if high.size:
            rows = high
            break
    medians = np.median(np.lib.stride_tricks.sliding_window_view(sizes, ROW)[rows], axis=1)
    greatest = int(np.argmax(medians))
    return MAD_TO_SIGMA * float(medians[greatest]), int(rows[greatest]) + ROW // 2
