"""Sheets of worn line contacts: profiles and pressures over the cycles or the distance, and the limiting profile."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Rule, Sheet, titled
from winkler.plot.series import series_of, with_unit
from winkler.plot.wear.wear import (
    POINTS,
    PRESSURE_CEILING,
    RADII_DRAWN,
    one_state,
    over_elapsed,
    rows_panel,
    state_panels,
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
    cycles = series_of(item, "cycles")
    names = [f"{count:,.0f}" if count >= 10 or count == 0 else f"{count:.2g}" for count in item.cycles]
    both = bool(np.any(item.second_volume_per_length > 0.0))
    volumes = ("first_volume_per_length", "second_volume_per_length") if both else ("worn_volume_per_length",)
    below = titled(
        (
            over_elapsed(cycles, [series_of(item, "half_width"), series_of(item, "stick_half_width")], "half-width"),
            over_elapsed(cycles, [series_of(item, name) for name in volumes], "worn volume" if both else ""),
            over_elapsed(cycles, [series_of(item, "dissipation_per_length")]),
        ),
        "contact and core",
        "worn volume",
        "loss of one cycle",
    )
    return Sheet((*state_panels(item.states, names, "cycles"), *below), 3, width=3.9)


@without_extent(LineSlidingSolution)
def line_sliding_sheet(item: LineSlidingSolution) -> Sheet:
    """Return worn profiles and pressures after growing distances, and contact, volume and pressure over them."""
    distance = series_of(item, "distance")
    above = state_panels(item.states, [with_unit(far, "m", 3) for far in item.distance.tolist()], "distance")
    names = ("half_width", "worn_volume_per_length", "mean_pressure")
    below = (over_elapsed(distance, [series_of(item, name)]) for name in names)
    return Sheet((*above, *titled(below, "contact", "worn volume", "mean pressure")), 3, width=3.9)


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
    a, share = float(pressed.half_width), np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, POINTS))[:-1]
    first: dict[str, Any] = {"name": "before wear", "colour": style.MUTED, "dash": style.DASHES[1]}
    last: dict[str, Any] = {"name": "in the end"}
    start, stop = pressed.pressure(a * share), item.pressure(c * share)
    panels = (
        rows_panel("height", [Line(x, before, **first), Line(x, before + worn, **last)], LineWearState),
        rows_panel("worn", [Line(x, worn, style.RED, name="worn off")], LineWearState),
        rows_panel(
            "pressure",
            [Line(a * share, start, **first), Line(c * share, stop, **last)],
            LineWearState,
            most=PRESSURE_CEILING * float(pressed.mean_pressure),
        ),
    )
    core = Rule(c, upright=True, width=0.9, dash=style.DOTTED, name="core")
    lost = with_unit(item.worn_volume_per_length, "m^2")
    title = f"$c$ = {with_unit(c, 'm')}   $a_\\infty$ = {with_unit(end, 'm')}   $V'$ = {lost}"
    shown = titled((panel.plus(core, legend="best") for panel in panels), "profile", "worn depth", "pressure")
    return Sheet(shown, width=3.9, title=title)
