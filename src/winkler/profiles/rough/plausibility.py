"""What a measured surface can hardly be: numbers that mark missing heights, slopes and sizes of mistaken units."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.values.readable import with_unit

MARKS = np.array([25400.0, 9999.0, 99999.0, 999999.0, 9999999.0, 32767.0, 32768.0, 65535.0, 2147483647.0, 2147483648.0,
                  1e10, 1e20, 1e30, 1e37, 1e38, 3.4028234663852886e38])  # fmt: skip
"""Absolute values that instruments write for a missing height, in the unit of the file."""
UNITS = np.array([1.0, 1e-3, 25.4e-6, 1e-6, 1e-9, 1e-10])
MOST_DIFFERENT = 1e-6
FAR = 10.0
"""Least distance of a mark from the other heights, in parts of their range."""
STEEPEST, LONGEST = 3.0, 1.0
"""Root mean square slope [-], and length [m], above which units are doubted."""
FLATTEST, SHORTEST = 1e-11, 1e-9
"""Range of heights [m], a tenth of the size of an atom, and length [m], below which they are doubted."""


def without_marks(heights: Array) -> tuple[Array, Array]:
    """Return heights with nan in place of marks of missing points, and the marks that were found.

    Parameters
    ----------
    heights : ndarray
        [m], nan where they are missing.

    Examples
    --------
    >>> without_marks(np.array([1e-6, 1.2e-6, -0.0254, 0.9e-6]))[1].tolist()
    [-0.0254]
    """
    found, left = [], np.array(heights, dtype=float)
    for _ in range(2):  # of either sign
        there = left[np.isfinite(left)]
        for mark in {float(end) for end in (there.min(), there.max())} if there.size else ():
            rest = there[there != mark]
            if not rest.size or not np.ptp(rest) < np.abs(rest - mark).min() / FAR:
                continue
            if np.any(np.abs(abs(mark) / np.outer(MARKS, UNITS) - 1.0) < MOST_DIFFERENT):
                found.append(mark)
                left[left == mark] = np.nan
                break
    return left, np.array(found)


def doubts_of_surface(heights: Array, slope: float, lengths: tuple[float, ...]) -> tuple[str, ...]:
    """Return sentences on what a map or a scan can hardly be; empty if nothing is doubtful.

    Parameters
    ----------
    heights : ndarray
        [m], nan where they are missing.
    slope : float
        Root mean square slope [-].
    lengths : tuple of float
        Of the map or the scan [m].
    """
    doubts = []
    if slope > STEEPEST:
        doubts.append(
            f"Doubtful: the root mean square slope is {slope:.3g}. Heights and lengths may have different units, "
            "or the map contains spikes or marks of missing points."
        )
    if max(lengths) > LONGEST:
        doubts.append(
            f"Doubtful: the surface is {with_unit(max(lengths), 'm', 3)} long, with heights over "
            f"{with_unit(float(np.nanmax(heights) - np.nanmin(heights)), 'm', 2)}. The unit of the lengths may be "
            "smaller."
        )
    there = heights[np.isfinite(heights)]
    if 0.0 < (whole := float(np.ptp(there))) < FLATTEST:
        doubts.append(
            f"Doubtful: the heights range over {with_unit(whole, 'm', 2)}, less than the size of an atom. Their "
            "unit may be larger."
        )
    if max(lengths) < SHORTEST:
        doubts.append(
            f"Doubtful: the surface is {with_unit(max(lengths), 'm', 3)} long, a few atoms. The unit of the "
            "lengths may be larger."
        )
    for end in (float(there.min()), float(there.max())):
        rest = there[there != end]
        count = there.size - rest.size
        if count > 1 and rest.size and 0.0 < np.ptp(rest) < np.abs(rest - end).min() / FAR:
            doubts.append(
                f"Doubtful: {count} heights are {with_unit(end, 'm', 4)}, away from the others by ten times their "
                "range or more. If they mark missing points, write nan there."
            )
    return tuple(doubts)
