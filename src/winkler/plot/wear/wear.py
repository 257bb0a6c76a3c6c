"""Sheets of wear: worn profiles and pressures over the cycles, evolution over the cycles, and the limiting profile."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Rule, Sheet, titled
from winkler.plot.series import series, series_of, with_unit
from winkler.problems.line.indentation import LineIndentation
from winkler.problems.wear.fretting import FrettingSolution
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.limiting_profile import LimitingSolution
from winkler.problems.wear.line_fretting import LineFrettingSolution
from winkler.problems.wear.line_limiting_profile import LineLimitingSolution
from winkler.problems.wear.line_sliding import LineSlidingSolution
from winkler.problems.wear.line_states import LineFrettingState, LineWearState
from winkler.problems.wear.sliding import SlidingSolution
from winkler.problems.wear.states import FrettingState, WearState, WornState

MOST_STATES = 6
"""Most states drawn together."""
MOST_IN_COLUMN = 4
"""Names in one column of a legend."""
RADII_DRAWN = 1.35
"""Extent of the pictures in contact radii."""
POINTS = 400
PRESSURE_CEILING, CORE_CEILING = 3.0, 2.0
"""Greatest drawn pressure over its mean, and over that below which half of the load is carried; it is infinite at the
edge of a core or a punch."""


@without_extent(FrettingSolution, LineFrettingSolution)
def fretting_sheet(item: FrettingSolution | LineFrettingSolution) -> Sheet:
    """Return worn profiles and pressures after growing numbers of cycles, and contact, volume and loads over them."""
    cycles = series_of(item, "cycles")
    names = [f"{count:,.0f}" if count >= 10 or count == 0 else f"{count:.2g}" for count in item.cycles]
    strip = isinstance(item, LineFrettingSolution)
    radius, end = ("half_width", "_per_length") if strip else ("radius", "")
    if isinstance(item, FrettingSolution):
        steady = np.ptp(item.force) <= 1e-6 * np.max(item.force)
        last, title = ("depth", "depth") if steady else ("force", "normal force")
    else:
        last, title = "dissipation_per_length", "loss of one cycle"
    both = bool(np.any(getattr(item, f"second_volume{end}") > 0.0))
    volumes = [("first_volume", "first volume"), ("second_volume", "second volume")] if both else [("worn_volume", "")]
    radii = [(series_of(item, name), name.replace("_", " ")) for name in (radius, f"stick_{radius}")]
    worn = [(series_of(item, f"{name}{end}"), of) for name, of in volumes]
    below = (
        curves_panel(cycles, radii, label="half-width" if strip else "radius"),
        curves_panel(cycles, worn, label="worn volume" if both else ""),
        curves_panel(cycles, [(series_of(item, last), "")]),
    )
    above = state_panels(item.states, names, "cycles")
    return Sheet((*above, *titled(below, "contact and stick zone", "worn volume", title)), 3, width=3.9)


@without_extent(SlidingSolution, LineSlidingSolution)
def sliding_sheet(item: SlidingSolution | LineSlidingSolution) -> Sheet:
    """Return worn profiles and pressures after growing distances, and contact, volume and pressure over them."""
    distance = series_of(item, "distance")
    above = state_panels(item.states, [with_unit(far, "m", 3) for far in item.distance.tolist()], "distance")
    strip = isinstance(item, LineSlidingSolution)
    names = ("half_width", "worn_volume_per_length") if strip else ("radius", "worn_volume")
    below = (curves_panel(distance, [(series_of(item, name), "")]) for name in (*names, "mean_pressure"))
    return Sheet((*above, *titled(below, "contact", "worn volume", "mean pressure")), 3, width=3.9)


@without_extent(WearState, FrettingState, LineWearState, LineFrettingState)
def wear_state_sheet(item: WearState | LineWearState) -> Sheet:
    """Return the worn profile and the pressure of one state."""
    return one_state(item, item.elapsed, isinstance(item, FrettingState | LineFrettingState))


@without_extent(LimitingSolution)
def limiting_sheet(item: LimitingSolution) -> Sheet:
    """Return the limiting profile, the worn depth, and the pressure in the limit and before wear."""
    bed, pressed = item.problem.bed, item.problem.contact
    end = min(RADII_DRAWN * item.radius, bed.reach)

    def pressure(r: Array) -> Array:
        return np.asarray(bed.medium.pressure(pressed.pressed, r))

    before = BeforeWear(bed.height, float(pressed.radius), pressure, float(pressed.mean_pressure))
    return limit_sheet(item, before, item.stick_radius, item.radius, end, f"$V$ = {with_unit(item.worn_volume, 'm^3')}")


@without_extent(LineLimitingSolution)
def line_limiting_sheet(item: LineLimitingSolution) -> Sheet:
    """Return the same of a strip."""
    bed = item.problem.bed
    pressed = LineIndentation(bed, item.problem.normal).solve()
    before = BeforeWear(bed.profile.height, float(pressed.half_width), pressed.pressure, float(pressed.mean_pressure))
    lost = f"$V'$ = {with_unit(item.worn_volume_per_length, 'm^2')}"
    end = min(RADII_DRAWN * item.half_width, bed.reach, bed.rim)
    return limit_sheet(item, before, item.stick_half_width, item.half_width, end, lost, LineWearState)


class BeforeWear(NamedTuple):
    """The contact before wear: its shape, radius or half-width [m], pressure, and mean pressure [Pa]."""

    height: Callable[[Array], Array]
    radius: float
    pressure: Callable[[Array], Array]
    mean_pressure: float


def limit_sheet(
    item: LimitingSolution | LineLimitingSolution,
    unworn: BeforeWear,
    core: float,
    radius: float,
    end: float,
    lost: str,
    kind: type = WearState,
) -> Sheet:
    """Return the limiting profile, the worn depth, and the pressure in the limit and before wear.

    Parameters
    ----------
    item
        The limit.
    unworn : BeforeWear
    core, radius, end : float
        What sticks, the contact, and how far is drawn [m].
    lost : str
        The worn volume in words.
    kind : type
        Of a state of wear, whose words name the axes.
    """
    ring = core + (radius - core) * np.linspace(0.0, 1.0, POINTS) ** 2
    r = np.unique(np.concatenate([np.linspace(0.0, end, POINTS), ring]))
    before, worn = np.asarray(unworn.height(r), dtype=float), item.worn(r)
    share = np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, POINTS))[:-1]
    first: dict[str, Any] = {"name": "before wear", "colour": style.MUTED, "dash": style.DASHES[1]}
    last: dict[str, Any] = {"name": "in the end"}
    pressures = (
        Line(unworn.radius * share, unworn.pressure(unworn.radius * share), **first),
        Line(core * share, item.pressure(core * share), **last),
    )
    panels = (
        rows_panel("height", [Line(r, before, **first), Line(r, before + worn, **last)], kind),
        rows_panel("worn", [Line(r, worn, style.RED, name="worn off")], kind),
        rows_panel("pressure", list(pressures), kind, most=PRESSURE_CEILING * unworn.mean_pressure),
    )
    rim = Rule(core, upright=True, width=0.9, dash=style.DOTTED, name="stick zone")
    title = f"$c$ = {with_unit(core, 'm')}   $a_\\infty$ = {with_unit(radius, 'm')}   {lost}"
    drawn = titled((panel.plus(rim, legend="best") for panel in panels), "profile", "worn depth", "pressure")
    return Sheet(drawn, width=3.9, title=title)


def one_state(item: WornState, elapsed: float, by_cycles: bool) -> Sheet:
    """Return the profile before and after wear, the worn depth and the pressure of one state.

    Parameters
    ----------
    item : WornState
    elapsed : float
        Cycles [-] or distance [m].
    by_cycles : bool
        Which of them.
    """
    after = (
        (f"{elapsed:,.0f}" if elapsed >= 10.0 else f"{elapsed:.3g}") + " cycles"
        if by_cycles
        else with_unit(elapsed, "m", 4)
    )
    height, *others = state_panels((item,), ["worn"], "")
    before = np.asarray(item.height) - np.asarray(item.worn)
    drawn = item.nodes <= RADII_DRAWN * item.edge
    unworn = Line(item.nodes[drawn], before[drawn], style.MUTED, name="before wear", dash=style.DASHES[1])
    return Sheet((height.plus(unworn), *others), width=3.9, title=f"after {after}")


def _chosen(states: tuple[WornState, ...]) -> list[int]:
    """Return the indices of a few states with about equal increments of worn volume."""
    volumes = np.array([state.removed for state in states])
    if len(states) <= MOST_STATES or volumes[-1] == volumes[0]:
        return list(range(min(len(states), MOST_STATES)))
    volumes_wanted = volumes[0] + (volumes[-1] - volumes[0]) * np.linspace(0.0, 1.0, MOST_STATES)
    return sorted({int(np.argmin(np.abs(volumes - each))) for each in volumes_wanted})


def _bearing(state: WornState) -> float:
    """Return the pressure below which half of the load is carried [Pa]."""
    pressure = np.where(np.isfinite(state.pressure), state.pressure, 0.0)
    wide = np.gradient(state.nodes) * (1.0 if isinstance(state, LineWearState) else state.nodes)
    rising = np.argsort(pressure)
    carried = np.cumsum((pressure * wide)[rising])
    return float(pressure[rising][np.searchsorted(carried, 0.5 * carried[-1])])


def state_panels(states: tuple[WornState, ...], names: list[str], what: str) -> tuple[Panel, ...]:
    """Return profiles, worn depths and pressures of a few states, from pale to dark.

    Parameters
    ----------
    states : tuple of WornState
    names : list of str
        One for each.
    what : str
        Title of the names.
    """
    chosen = _chosen(states)
    chosen_states = [states[index] for index in chosen]
    reach = RADII_DRAWN * max(state.edge for state in chosen_states)
    within = [state.nodes <= reach for state in chosen_states]
    usual = max(map(_bearing, chosen_states))
    shades = [style.shade(float(share)) for share in np.linspace(0.25, 1.0, len(chosen))]
    panels = []
    for name, most in (("height", np.inf), ("worn", np.inf), ("pressure", CORE_CEILING * usual)):
        lines = [
            Line(state.nodes[inside], np.asarray(getattr(state, name))[inside], colour, name=names[index])
            for state, inside, colour, index in zip(chosen_states, within, shades, chosen, strict=True)
        ]
        panels.append(rows_panel(name, lines, type(chosen_states[0]), most=most))
    panels[0] = panels[0].plus(legend="best", legend_title=what, columns=2 if len(chosen) > MOST_IN_COLUMN else 1)
    return titled(panels, "worn profiles", "worn depth", "pressure")


def rows_panel(name: str, lines: list[Line], kind: type = WearState, *, most: float = np.inf) -> Panel:
    """Return a quantity of wear over the distance from the middle, up to a greatest drawn value.

    Parameters
    ----------
    name : str
        A field of the state.
    lines : list of Line
    kind : type
        Of the states.
    most : float
        [SI].
    """
    along = series("nodes", np.concatenate([line.x for line in lines]), kind)
    of = series(name, np.minimum(np.concatenate([line.y for line in lines]), most), kind)
    top = float(np.max(of.content))
    high = 1.08 * top if top > 0.0 else of.scale.factor
    letter = "$x$" if issubclass(kind, LineWearState) else "$r$"
    return Panel(tuple(lines), PanelAxis(letter, along.scale), PanelAxis.of(of, low=0.0, high=high))


def moment_panels(states: Sequence[WornState], moment: int) -> tuple[Panel, Panel, Panel]:
    """Return worn profile, worn depth and pressure in one state, beside the first and the last one.

    Parameters
    ----------
    states : sequence of WornState
        All states of a history.
    moment : int
        Index of the drawn state.
    """
    first, now, last = states[0], states[moment], states[-1]
    reach = min(RADII_DRAWN * max(one.edge for one in states), first.bed.reach, float(last.nodes[-1]))
    r = np.unique(np.concatenate([[0.0, reach], *(one.nodes[one.nodes <= reach] for one in (first, last))]))
    before = wear_grid(first.bed, first.nodes).height(r)
    end, current = (before + np.interp(r, one.nodes, one.worn) for one in (last, now))
    thin: dict[str, Any] = {"colour": style.MUTED, "width": 1.0}
    start = "before wear" if first.elapsed == 0.0 else "at first"
    profile = [
        Line(r, end, name="in the end", **thin),
        Line(r, before, name="before wear", dash=style.DASHES[1], **thin),
        Line(r, current, name="now"),
    ]
    worn = [
        Line(last.nodes, last.worn, name="in the end", **thin),
        Line(now.nodes, now.worn, style.RED, name="now"),
    ]
    most = CORE_CEILING * max(map(_bearing, states))
    top = max(float(np.max(np.minimum(one.pressure, most))) for one in states)
    pressure = [
        Line(first.nodes, np.minimum(first.pressure, most), name=start, dash=style.DASHES[1], **thin),
        Line(last.nodes, np.minimum(last.pressure, most), name="in the end", **thin),
        Line(now.nodes, np.minimum(now.pressure, most), style.RED, name="now"),
    ]
    off = Area(r, before, current, alpha=0.15)
    panels = []
    for name, lines, marks, high in (
        ("height", profile, (off,), float(np.max(end))),
        ("worn", worn, (), float(np.max(last.worn))),
        ("pressure", pressure, (), top),
    ):
        panel = rows_panel(name, lines, type(first))
        scale = series(name, np.array([high]), type(first)).scale
        upright = dataclasses.replace(panel.upright, scale=scale, high=1.08 * high if high > 0.0 else scale.factor)
        across = dataclasses.replace(panel.across, scale=series("r", r).scale, low=0.0, high=reach)
        panels.append(panel.plus(*marks, across=across, upright=upright, legend="best"))
    return panels[0], panels[1], panels[2]
