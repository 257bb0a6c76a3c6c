r"""Measured profiles in tables: a radius and a height in every row.

A scan across the apex, with negative radii, is folded onto one flank: the apex x0 is the vertex of the parabola fitted
to a window that is symmetric about x0, and :math:`r=|x-x_0|`.
"""

from __future__ import annotations

import math
import os
import warnings

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.tables.table import Column, read_table
from winkler.numerics.types import Array
from winkler.profiles.measured import Measured
from winkler.profiles.sections.measured_section import MeasuredSection
from winkler.values.errors import InvalidInput

LARGEST_FLANK_DIFFERENCE = 0.05
"""Largest difference (root mean square) between the flanks of a scan, against its height."""
RADIUS = Column("radius", ("radius", "r", "x"), "m", "um")
HEIGHT = Column("height", ("height", "h", "z", "f"), "m", "nm")
PLACE = Column("place", ("place", "x", "position"), "m", "um")


@reader("a profile")
def read_profile(path: str | os.PathLike[str], *, peak: bool = False) -> Measured:
    """Read a measured profile from a table with the columns radius (r, x) and height (h, z, f).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``radius [um], height [nm]``; columns with other names are ignored.
        Negative radii make it a scan across the apex, which is folded onto one flank; flanks that differ by more than
        5 % of the height are refused.
    peak : bool, optional
        Whether heights are largest at the apex, as in a topography of a tip that points upwards; their sign is then
        changed.  By default they rise away from the apex.

    Returns
    -------
    Measured

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it does not contain a profile.
    """
    table = read_table(path, (RADIUS, HEIGHT))
    x, f = table.values[:, 0], table.values[:, 1] * (-1.0 if peak else 1.0)
    with in_file(table.path):
        return Measured(np.abs(x - _apex(x, f)) if np.any(x < 0.0) else x, f)


@reader("a section")
def read_section(
    path: str | os.PathLike[str], *, peak: bool = False, cut_off: bool = False, curved: bool = False
) -> MeasuredSection:
    """Read a measured section from a table with the columns place (x, position) and height (h, z, f).

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``place [um], height [nm]``; columns with other names are ignored.
        Rows may stand in any order.
    peak : bool, optional
        Whether heights are largest at what touches first, as in a trace of a profilometer; their sign is then changed.
    cut_off : bool, optional
        Whether the body ends vertically at the first and at the last place.
    curved : bool, optional
        Whether a cubic spline joins the points instead of straight lines.

    Returns
    -------
    MeasuredSection

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it does not contain a section.
    """
    table = read_table(path, (PLACE, HEIGHT))
    order = np.argsort(table.values[:, 0], kind="stable")
    x, f = table.values[order, 0], table.values[order, 1] * (-1.0 if peak else 1.0)
    with in_file(table.path):
        return MeasuredSection(x, f, cut_off, curved)


def _parabola(x: Array, f: Array, degree: int) -> Array:
    """Return the coefficients of the parabola fitted to points, highest power first."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", np.exceptions.RankWarning)
        try:
            return np.asarray(np.polyfit(x, f, degree))
        except np.exceptions.RankWarning:
            raise InvalidInput(
                "all points of the scan but a few lie at one place; remove those that are far away."
            ) from None


def _apex(x: Array, f: Array) -> float:
    """Return where the apex of a scan lies."""
    first, last = float(np.min(x)), float(np.max(x))
    if np.unique(x).size > 2 and _parabola((x - first) / (last - first), f, 2)[0] < 0.0:
        raise InvalidInput(
            "the heights of the scan fall away from the apex; change their sign, or call read_profile(path, peak=True)."
        )
    centre = lowest = float(x[np.argmin(f)])
    low, high = first, last
    while high - low > 1e-9 * (last - first):
        half = min(centre - first, last - centre)
        near = np.abs(x - centre) <= half
        sides = np.count_nonzero(x[near] < centre), np.count_nonzero(x[near] > centre)
        if min(sides) < 2 or np.unique(x[near]).size < 5:
            break
        bend, tilt, _ = _parabola((x[near] - centre) / half, f[near], 2)
        step = -0.5 * tilt / bend if bend > 0.0 else math.inf
        if abs(step) < 1e-9:
            low = high = centre
        elif not abs(step) <= 1.0:
            break
        else:  # towards the vertex, but never back over a place that it left on the other side
            low, high = (centre, high) if step > 0.0 else (low, centre)
            vertex = centre + half * step
            centre = vertex if low < vertex < high else 0.5 * (low + high)
    else:
        _compare_flanks(x - centre, f)
        return centre
    raise InvalidInput(
        f"no apex was found near x = {lowest:.6g} m, where the scan is lowest; a scan needs both flanks and five "
        "points around the apex, or give one flank with distances from the axis."
    )


def _compare_flanks(x: Array, f: Array) -> None:
    """Refuse a scan whose flanks differ, as those of a tilted one do: by more than their scatter, in a parabola."""
    order = np.argsort(x)
    x, f = x[order], f[order]
    left, common = x < 0.0, np.abs(x) <= min(-x[0], x[-1])
    span = float(np.ptp(f[common]))
    f = f / span if span > 0.0 else f  # squares of large heights have no number
    r, end = x[common & ~left], f[common & ~left]
    difference = _parabola(r / r[-1], end - np.interp(r, -x[left][::-1], f[left][::-1]), min(2, r.size - 1))
    flank_difference = float(np.sqrt(np.mean(np.polyval(difference, r / r[-1]) ** 2)))
    if flank_difference > LARGEST_FLANK_DIFFERENCE:
        raise InvalidInput(
            f"the two flanks of the scan differ by {flank_difference:.0%} of its height; level the scan, or give one "
            "flank with distances from the axis."
        )
