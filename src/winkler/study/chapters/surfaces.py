"""Height maps of files in a study: read, and prepared for a contact by the options of the study."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from winkler.io.topography_file import read_topography
from winkler.numerics.types import Array
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, suggest

TREND_DEGREES = {"mean": 0, "plane": 1, "paraboloid": 2}
UNSTATED_LENGTHS = np.full(2, np.nan)


def read_surface(
    path: Path,
    *,
    lengths: Array = UNSTATED_LENGTHS,
    unit: str = "",
    periodic: bool = False,
    channel: str = "",
    tip_radius: float = 0.0,
    without_spikes: bool = False,
    levelled: str = "none",
    scan_lines_along: str = "x",
    detrend: str = "none",
    filled: bool = False,
    coarsened: int = 1,
) -> Topography:
    """Read a height map, and prepare it for a contact.

    Parameters
    ----------
    path
        As for `read_topography`.
    lengths : array_like, (2,)
        Lengths [m] of the map, where the file does not state them.
    unit
        Of heights in a plain matrix: m, mm, um, nm, pm or A.
    periodic
        Whether the map is periodic.
    channel
        Name of one of several height channels of an instrument's file, or of one measurement of a container.
    tip_radius
        Radius [m] of the tip that has scanned the map; the limit that it sets is among the notes.
    without_spikes
        Whether outliers, such as dust or the scar of a scan, count as missing; the notes say what was taken out.
    levelled
        What is taken off each scan line: none, its median, the median of its differences from the line before
        (differences), a straight line (line) or a parabola; the notes say so.
    scan_lines_along
        Direction in which a line was scanned: x or y.
    detrend
        Trend that is subtracted, fitted by least squares: none, mean, plane or paraboloid.
    filled
        Whether missing heights are bridged by the smoothest surface through their border.
    coarsened
        Number of pixels along a side that become one, with their mean height.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or an option is not allowed.
    """
    rough = read_topography(
        path,
        lengths=(float(lengths[0]), float(lengths[1])),
        unit=unit,
        periodic=periodic,
        channel=channel,
        tip_radius=tip_radius,
    )
    if detrend not in ("none", *TREND_DEGREES):
        choices = ("none", *TREND_DEGREES)
        raise InvalidInput(f"detrend is {detrend!r}{suggest(detrend, choices)}; give one of {', '.join(choices)}.")
    if without_spikes:
        rough = rough.without_spikes()
    if levelled != "none":
        rough = rough.levelled(levelled, scan_lines_along)
    if detrend != "none":
        rough = rough.detrended(TREND_DEGREES[detrend])
    if filled:
        rough = rough.filled()
    return rough if coarsened == 1 else rough.coarsened(coarsened)
