"""What to know of a measured map before its contact is believed: tip, what was taken out, a border that leaps."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.rough.tip_limit import SANNER, share_below, tip_limit
from winkler.profiles.rough.topography import Topography
from winkler.values.validity import Assumption, Note, Standing, standing_of

SMALL_SHARE, LARGE_SHARE = 0.05, 0.5
"""Of the mean square slope below the limit of the tip."""
LARGEST_LEAP = 3.0
"""Step at the border over the greatest one inside, root mean squares of lines of pixels; that of one line scatters."""


def border_leap(surface: Topography) -> float:
    """Return the step between opposite borders over the greatest step of neighbouring lines inside.

    Both are root mean squares over a line of pixels; the worse direction counts.  It is about one or
    less of a map that is repeated.
    """
    ratios = []
    for axis in (0, 1):
        heights: Array = np.moveaxis(surface.heights, axis, 0)
        squares = (np.roll(heights, -1, 0) - heights) ** 2
        known = np.isfinite(squares).any(axis=1)
        lines = np.sqrt(np.nanmean(squares[known], axis=1))
        if known[-1] and lines.size > 1 and np.max(lines[:-1]) > 0.0:
            ratios.append(float(lines[-1] / np.max(lines[:-1])))
    return max(ratios, default=0.0)


def map_notes(surface: Topography) -> tuple[Note, ...]:
    """Return the limit of the tip of a map, what was taken out of it, and whether it can be periodic."""
    notes: list[Note] = []
    if surface.tip_radius > 0.0:
        notes.append(_tip_note(surface))
    if surface.reading:
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE,
                f"Read as {surface.reading}.",
                "linear interpolation on Delaunay triangles",
            )
        )
    if surface.removed:
        bridged = ", and bridged" if "stand out" in surface.removed else ""
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE,
                f"Removed from the measured heights{bridged}: {surface.removed}.",
                "J. W. Tukey, Exploratory Data Analysis, Addison-Wesley 1977",
            )
        )
    leap = border_leap(surface) if surface.periodic else 0.0
    if leap > LARGEST_LEAP:
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.OUTSIDE,
                f"The map is declared periodic, but heights at its border jump by {leap:.2g} times the largest "
                "step between two of its lines. The periodic continuation has a cliff there: leave periodic out.",
                "comparison of steps inside and at the border",
            )
        )
    return tuple(notes)


def _tip_note(surface: Topography) -> Note:
    radius = f"a tip of {surface.tip_radius:.3g} m"
    limit = tip_limit(surface)
    if limit == 0.0:
        return Note(
            Assumption.RESOLUTION, Standing.ASYMPTOTIC, f"No part of the map is half as sharp as {radius}.", SANNER
        )
    share = share_below(surface, limit)
    whole = limit >= 0.5 * float(np.min(surface.lengths))
    return Note(
        Assumption.RESOLUTION,
        Standing.OUTSIDE if whole else standing_of(share, SMALL_SHARE, LARGE_SHARE),
        f"Below {limit:.3g} m, {limit / max(surface.pixel):.2g} pixels, {radius} has rounded the map. Waves of "
        f"this length have {max(share, 0.0):.0%} of the mean square slope. Contacts, pressures and adhesion of "
        "such small spots are not those of the surface.",
        SANNER,
    )
