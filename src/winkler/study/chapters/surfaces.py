"""Height maps that a study names by their file: read, and made ready for a contact, as the study says."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.io.topography_file import read_topography
from winkler.numerics.types import Array
from winkler.profiles.rough.topography import Topography

__all__ = ["read_surface"]

TRENDS = {"mean": 0, "plane": 1, "paraboloid": 2}
LENGTHS = np.full(2, np.nan)


def read_surface(
    path: Path,
    *,
    lengths: Array = LENGTHS,
    unit: str = "",
    periodic: bool = False,
    channel: str = "",
    without_spikes: bool = False,
    detrend: str = "none",
    filled: bool = False,
    coarsened: int = 1,
) -> Topography:
    """Read a height map, and make it ready.

    Parameters
    ----------
    path
        As for `read_topography`.
    lengths : array_like, (2,)
        Lengths [m] of the map, where the file does not tell them.
    unit
        Of heights in a plain matrix: m, mm, um, nm, pm or A.
    periodic
        Whether the map is repeated for ever.
    channel
        Which one of several height channels of an instrument's file.
    without_spikes
        Whether what stands far out of its surroundings, such as dust or the scar of a scan, counts as missing.
    detrend
        What is taken off the heights, fitted by least squares: none, mean, plane or paraboloid.
    filled
        Whether missing heights are bridged by the smoothest surface through their border.
    coarsened
        How many pixels along a side become one, with their mean height.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or what is to be done with it is not known.
    """
    rough = read_topography(
        path, lengths=(float(lengths[0]), float(lengths[1])), unit=unit, periodic=periodic, channel=channel
    )
    if detrend not in ("none", *TRENDS):
        known = ("none", *TRENDS)
        raise InvalidInput(f"detrend is {detrend!r}{suggest(detrend, known)}; give one of {', '.join(known)}.")
    if without_spikes:
        rough = rough.without_spikes()
    if detrend != "none":
        rough = rough.detrended(TRENDS[detrend])
    if filled:
        rough = rough.filled()
    return rough if coarsened == 1 else rough.coarsened(coarsened)
