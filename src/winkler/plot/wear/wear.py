"""Sheets of wear: worn profiles and pressures over the cycles, what changes meanwhile, and where it ends."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.series import Series, series, told
from winkler.problems.wear.fretting import FrettingSolution
from winkler.problems.wear.limiting_profile import LimitingSolution
from winkler.problems.wear.sliding import SlidingSolution
from winkler.problems.wear.states import FrettingState, WearState

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["fretting_sheet", "limiting_sheet", "sliding_sheet", "wear_state_sheet"]

SHOWN = 6
"""So many states are shown side by side."""
AROUND = 1.35
"""Pictures go to so many contact radii."""
DENSE = 400
CEILING = 3.0
"""Pressures are shown up to so many times their mean: that at the edge of a core or a punch has no end."""


def _refuse(item: Any, extent: float | None) -> None:
    if extent is not None:
        raise InvalidInput(f"draw: the sheet of a {type(item).__name__} has no extent; leave it out.")


@draw.register(FrettingSolution)
def fretting_sheet(item: FrettingSolution, *, extent: float | None = None) -> Picture:
    """Return worn profiles and pressures after growing numbers of cycles, and radii, volume and loads over them."""
    _refuse(item, extent)
    cycles = series("FrettingSolution", "cycles", item.cycles)
    with style.styled():
        figure = style.figure(3, 2, width=3.9)
        panels = figure.subplots(2, 3).ravel()
        names = [f"{count:,.0f}" if count >= 10 or count == 0 else f"{count:.2g}" for count in item.cycles]
        _draw_states(panels[:3], item.states, names, "cycles")
        _draw_over(panels[3], cycles, [_told(item, "radius"), _told(item, "stick_radius")], "radius")
        _draw_volume(panels[4], cycles, item)
        _draw_over(panels[5], cycles, [_told(item, "force")], "")
        for axes, title in zip(panels[3:], ("contact and core", "worn volume", "normal force"), strict=True):
            axes.set_title(title)
        if np.ptp(item.force) <= 1e-6 * np.max(item.force):
            panels[5].clear()
            _draw_over(panels[5], cycles, [_told(item, "depth")], "")
            panels[5].set_title("depth")
    return figure


@draw.register(SlidingSolution)
def sliding_sheet(item: SlidingSolution, *, extent: float | None = None) -> Picture:
    """Return worn profiles and pressures after growing distances, and contact, volume and pressure over them."""
    _refuse(item, extent)
    distance = series("SlidingSolution", "distance", item.distance)
    with style.styled():
        figure = style.figure(3, 2, width=3.9)
        panels = figure.subplots(2, 3).ravel()
        _draw_states(panels[:3], item.states, [told(far, "m", 3) for far in item.distance.tolist()], "distance")
        _draw_over(panels[3], distance, [_told(item, "radius")], "")
        _draw_over(panels[4], distance, [_told(item, "worn_volume")], "")
        _draw_over(panels[5], distance, [_told(item, "mean_pressure")], "")
        for axes, title in zip(panels[3:], ("contact", "worn volume", "mean pressure"), strict=True):
            axes.set_title(title)
    return figure


@draw.register(WearState)
@draw.register(FrettingState)
def wear_state_sheet(item: WearState, *, extent: float | None = None) -> Picture:
    """Return the worn profile and the pressure of one state."""
    _refuse(item, extent)
    with style.styled():
        figure = style.figure(3, width=3.9)
        panels = figure.subplots(1, 3)
        _draw_states(panels, (item,), [f"{item.elapsed:.4g}"], "after")
    return figure


@draw.register(LimitingSolution)
def limiting_sheet(item: LimitingSolution, *, extent: float | None = None) -> Picture:
    """Return the limiting profile, what was worn off, and the pressure in the end and before wear."""
    _refuse(item, extent)
    bed, c, end = item.problem.bed, item.stick_radius, item.radius
    reach = min(AROUND * end, bed.reach)
    ring = c + (end - c) * np.linspace(0.0, 1.0, DENSE) ** 2
    r = np.unique(np.concatenate([np.linspace(0.0, reach, DENSE), ring]))
    before, worn = bed.height(r), item.worn(r)
    with style.styled():
        figure = style.figure(3, width=3.9)
        panels = figure.subplots(1, 3)
        lines = [("before wear", style.MUTED, style.DASHES[1]), ("in the end", style.BLUE, "-")]
        _draw_rows(panels[0], "WearState", "height", [(r, before), (r, before + worn)], lines)
        _draw_rows(panels[1], "WearState", "worn", [(r, worn)], [("worn off", style.RED, "-")])
        share = np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, DENSE))[:-1]
        pressed = item.problem.contact
        radius = float(pressed.radius)
        rows = [
            (radius * share, bed.medium.pressure(pressed.pressed, radius * share)),
            (c * share, item.pressure(c * share)),
        ]
        _draw_rows(panels[2], "WearState", "pressure", rows, lines, CEILING * float(pressed.mean_pressure))
        for axes, title in zip(panels, ("profile", "worn depth", "pressure"), strict=True):
            axes.set_title(title)
            _mark(axes, c, "core")
            style.framed_legend(axes, loc="best")
        figure.suptitle(
            f"$c$ = {told(c, 'm')}   $a_\\infty$ = {told(end, 'm')}   $V$ = {told(item.worn_volume, 'm^3')}"
        )
    return figure


def _told(item: Any, name: str) -> Series:
    return series(type(item), name, getattr(item, name))


def _chosen(states: tuple[WearState, ...]) -> list[int]:
    """Return a few states that differ in what was worn off by equal parts."""
    volumes = np.array([state.worn_volume for state in states])
    if len(states) <= SHOWN or volumes[-1] == volumes[0]:
        return list(range(min(len(states), SHOWN)))
    wanted = volumes[0] + (volumes[-1] - volumes[0]) * np.linspace(0.0, 1.0, SHOWN)
    return sorted({int(np.argmin(np.abs(volumes - each))) for each in wanted})


def _draw_states(panels: Any, states: tuple[WearState, ...], names: list[str], what: str) -> None:
    """Draw profiles, worn depths and pressures of a few states, from pale to dark."""
    chosen = _chosen(states)
    reach = AROUND * max(states[index].radius for index in chosen)
    colours = style.shades()(np.linspace(0.25, 1.0, len(chosen)))
    shown = [states[index] for index in chosen]
    kept = [state.radii <= reach for state in shown]
    mean = max(state.force / (np.pi * state.radius**2) for state in shown)
    for axes, name, most in zip(panels, ("height", "worn", "pressure"), (np.inf, np.inf, CEILING * mean), strict=True):
        rows = [
            (state.radii[inside], np.asarray(getattr(state, name))[inside])
            for state, inside in zip(shown, kept, strict=True)
        ]
        styles = [(names[index], colour, "-") for index, colour in zip(chosen, colours, strict=True)]
        _draw_rows(axes, "WearState", name, rows, styles, most)
    for axes, title in zip(panels, ("worn profiles", "worn depth", "pressure"), strict=True):
        axes.set_title(title)
    style.framed_legend(panels[0], loc="best", title=what, title_fontsize=8.5)


def _draw_rows(
    axes: Axes,
    owner: str,
    name: str,
    rows: list[tuple[Array, Array]],
    styles: list[tuple[str, Any, Any]],
    most: float = np.inf,
) -> None:
    """Draw curves over the distance from the axis, all in one unit, up to a greatest number that is shown."""
    along = series("WearState", "radii", np.concatenate([r for r, _ in rows]))
    every = np.minimum(np.concatenate([content for _, content in rows]), most)
    of = series(owner, name, every)
    for (r, content), (label, colour, line) in zip(rows, styles, strict=True):
        axes.plot(r / along.scale.factor, content / of.scale.factor, color=colour, linestyle=line, label=label)
    axes.set_xlabel(f"$r$ [{along.scale.unit}]")
    axes.set_ylabel(of.label())
    top = float(np.max(every)) / of.scale.factor
    axes.set_ylim(0.0, 1.08 * top if top > 0.0 else 1.0)


def _mark(axes: Axes, radius: float, label: str) -> None:
    along = series("WearState", "radii", np.array([radius]))
    axes.axvline(along.shown()[0], color=style.MUTED, linewidth=0.9, linestyle=":", label=label)


def _draw_over(axes: Axes, along: Series, rows: list[Series], label: str) -> None:
    """Draw quantities of one unit over cycles or distance."""
    scale = max((row.scale for row in rows), key=lambda one: one.factor)
    for row, colour, line in zip(rows, (style.BLUE, style.RED), ("-", style.DASHES[1]), strict=False):
        axes.plot(along.shown(), row.shown(scale), color=colour, linestyle=line, label=row.name.replace("_", " "))
    axes.set_xlabel(along.label())
    axes.set_ylabel(f"{label} [{scale.unit}]" if label else rows[0].label(scale))
    axes.set_ylim(0.0, 1.12 * max(float(np.max(row.shown(scale))) for row in rows) or 1.0)
    if len(rows) > 1:
        style.framed_legend(axes, loc="best")


def _draw_volume(axes: Axes, along: Series, item: FrettingSolution) -> None:
    """Draw what both bodies have lost; each by itself if both wear."""
    if not np.any(item.second_volume > 0.0):
        _draw_over(axes, along, [_told(item, "worn_volume")], "")
        return
    _draw_over(axes, along, [_told(item, "first_volume"), _told(item, "second_volume")], "worn volume")
