"""Trends of a height map: a surface fitted to all of it, and the level of each line of a scan."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest

__all__ = ["LINE_LEVELS", "along_x", "line_levels", "trend_of"]

LINE_LEVELS = {
    "median": "its median",
    "differences": "the median of its differences from the line before",
    "line": "a straight line",
    "parabola": "a parabola",
}
"""What may be taken off each line of a scan, in words."""
DEGREES = {"line": 1, "parabola": 2}


def trend_of(heights: Array, order: int, *, periodic: bool) -> Array:
    """Return the mean (0), plane (1) or paraboloid (2) that is fitted to the heights by least squares.

    Raises
    ------
    InvalidInput
        If the order is another one, or a periodic map would not be so without it.
    """
    if order not in (0, 1, 2):
        raise InvalidInput(
            f"Topography: cannot detrend to the order {order!r}; give 0 for the mean, 1 for a plane, "
            "2 for a paraboloid."
        )
    if periodic and order:
        raise InvalidInput(
            "Topography: without a plane or paraboloid a periodic map would not fit its neighbours any more; give "
            "order 0, or a map that is not periodic."
        )
    x, y = (np.linspace(-1.0, 1.0, n) for n in heights.shape)
    terms = [
        (x[:, None] ** i) * (y[None, :] ** j) for i in range(order + 1) for j in range(order + 1) if i + j <= order
    ]
    measured = ~np.isnan(heights)
    rows = np.stack([term[measured] for term in np.broadcast_arrays(*terms, heights)[:-1]], axis=1)
    strengths, *_ = np.linalg.lstsq(rows, heights[measured], rcond=None)
    trend = np.zeros(heights.shape)
    for strength, term in zip(strengths, terms, strict=True):
        trend += strength * term
    return trend


def along_x(along: str) -> bool:
    """Return whether scan lines run along x, and not along y.

    Raises
    ------
    InvalidInput
        If it is neither.
    """
    if along not in ("x", "y"):
        raise InvalidInput(f"Topography: scan lines run along {along!r}; give x or y.")
    return along == "x"


def line_levels(lines: Array, by: str, *, periodic: bool) -> Array:
    """Return what is to be taken off each line of a scan, (lines, points); zero of lines without any height.

    The mean over all measured heights is kept.

    Raises
    ------
    InvalidInput
        If `by` is another word, or a periodic map would not be so without it; by differences, if a line has no point
        in common with any line before it.
    """
    if by not in LINE_LEVELS:
        raise InvalidInput(
            f"Topography: scan lines cannot be levelled by {by!r}{suggest(by, LINE_LEVELS)}; "
            f"give {', '.join(LINE_LEVELS)}."
        )
    if periodic and by != "median":
        raise InvalidInput(
            "Topography: levelled by other than the medians of its lines, a periodic map would not fit its neighbours "
            "any more; give median, or a map that is not periodic."
        )
    measured: Array = ~np.isnan(lines)
    levels = np.zeros(lines.shape)
    some = np.asarray(np.any(measured, axis=1))
    if by == "median":
        levels[some] = np.nanmedian(lines[some], axis=1)[:, None]
    elif by == "differences":
        there = np.flatnonzero(some).tolist()
        for place, line in enumerate(there[1:], 1):
            shared = (before for before in reversed(there[:place]) if np.any(measured[line] & measured[before]))
            if (before := next(shared, None)) is None:
                raise InvalidInput(
                    f"Topography: scan line {line} has no measured point beside one of a line before it, so their "
                    "difference is not known; level by median, or give a part of the map."
                )
            both = measured[line] & measured[before]
            levels[line] = levels[before] + float(np.median(lines[line, both] - lines[before, both]))
    else:
        x = np.linspace(-1.0, 1.0, lines.shape[1])
        powers = np.stack([x**degree for degree in range(DEGREES[by] + 1)], axis=1)
        for line in np.flatnonzero(some).tolist():
            kept = measured[line]
            strengths, *_ = np.linalg.lstsq(powers[kept], lines[line, kept], rcond=None)
            levels[line] = powers @ strengths
    return np.where(some[:, None], levels - float(np.mean(levels[measured])), 0.0)
