"""Sheets of worn line contacts: profiles and pressures over the cycles or the distance, and the limiting profile."""

from __future__ import annotations

import numpy as np

from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Sheet
from winkler.plot.series import with_unit
from winkler.plot.wear.wear import (
    FLAT_SHARE,
    POINTS,
    RADII_DRAWN,
    cycles_sheet,
    distances_sheet,
    limit,
    one_state,
)
from winkler.problems.line.indentation import LineIndentation
from winkler.problems.wear.line_fretting import LineFrettingSolution
from winkler.problems.wear.line_limiting_profile import LineLimitingSolution
from winkler.problems.wear.line_sliding import LineSlidingSolution
from winkler.problems.wear.line_states import LineFrettingState, LineWearState

__all__ = ["line_fretting_sheet", "line_limiting_sheet", "line_sliding_sheet", "line_wear_state_sheet"]


@without_extent(LineFrettingSolution)
def line_fretting_sheet(item: LineFrettingSolution) -> Sheet:
    """Return worn profiles and pressures after growing numbers of cycles; contact, volume and loss over them."""
    return cycles_sheet(item, "half_width", "_per_length", "dissipation_per_length", "loss of one cycle")


@without_extent(LineSlidingSolution)
def line_sliding_sheet(item: LineSlidingSolution) -> Sheet:
    """Return worn profiles and pressures after growing distances, and contact, volume and pressure over them."""
    return distances_sheet(item, "half_width", "worn_volume_per_length")


@without_extent(LineWearState, LineFrettingState)
def line_wear_state_sheet(item: LineWearState) -> Sheet:
    """Return the worn profile and the pressure of one state."""
    return one_state(item, item.elapsed, isinstance(item, LineFrettingState))


@without_extent(LineLimitingSolution)
def line_limiting_sheet(item: LineLimitingSolution) -> Sheet:
    """Return the limiting profile, the worn depth, and the pressure in the limit and before wear."""
    bed, c, end = item.problem.bed, item.stick_half_width, item.half_width
    beside = c + (end - c) * np.linspace(0.0, 1.0, POINTS) ** 2
    x = np.unique(np.concatenate([np.linspace(0.0, min(RADII_DRAWN * end, bed.reach, bed.rim), POINTS), beside]))
    before, worn = bed.profile.height(x), item.worn(x)
    pressed = LineIndentation(bed, item.problem.normal).solve()
    inside = float(pressed.half_width) * FLAT_SHARE
    lost = with_unit(item.worn_volume_per_length, "m^2")
    title = f"$c$ = {with_unit(c, 'm')}   $a_\\infty$ = {with_unit(end, 'm')}   $V'$ = {lost}"
    first, last = Line(inside, pressed.pressure(inside)), Line(c * FLAT_SHARE, item.pressure(c * FLAT_SHARE))
    return limit(Line(x, before), worn, first, last, c, float(pressed.mean_pressure), title, LineWearState)
