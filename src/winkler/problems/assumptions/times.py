"""Whether a viscoelastic solid is known at the times of a problem."""

from __future__ import annotations

import numpy as np

from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.values.validity import Assumption, Note, Standing

SERIES = "sum of exponentials over a span of time"


def times_notes(medium: object, shortest: float, longest: float) -> tuple[Note, ...]:
    """Return whether the series of the solid stand for it at these times; nothing if they do at all times.

    Parameters
    ----------
    medium : object
        Of the problem; nothing is said of one that does not relax.
    shortest, longest : float
        The shortest time between two moments of the problem, and the longest memory that is needed [s].
    """
    if not offers(medium, RelaxingMedium):
        return ()
    first, last = medium.span
    if first == 0.0:
        return ()
    span = f"The solid is known between {first:.3g} s and {last:.3g} s"
    if longest > last or longest < first:
        standing = Standing.OUTSIDE
        verdict = f"{longest:.3g} s are needed, where its series is not the solid: give it for such times"
    elif shortest < first:
        standing = Standing.APPROXIMATE
        verdict = f"the steps of {shortest:.3g} s are computed from its series, as if nothing relaxed faster"
    else:
        standing = Standing.ASYMPTOTIC
        verdict = f"the times needed, {shortest:.3g} s to {longest:.3g} s, are within"
    return (Note(Assumption.KNOWN_TIMES, standing, f"{span}; {verdict}.", SERIES),)


def path_notes(medium: object, times: Array) -> tuple[Note, ...]:
    """Return the same of a path through moments [s]; nothing of one that ends where it begins."""
    steps = np.diff(times)
    return times_notes(medium, float(np.min(steps)), float(np.ptp(times))) if steps.size else ()
