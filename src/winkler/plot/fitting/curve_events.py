"""Picture of a measured curve: force over time and over position, with what was done and what happened."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.kinds import CurveEvent, CurveEvents, EventKind, with_error
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Band, Line, Panel, PanelAxis, Rule, Sheet, Text, titled
from winkler.plot.series import Series
from winkler.values.vocabulary import Word

COLOURS = {
    EventKind.LOADING: style.BLUE,
    EventKind.HOLD: style.ORANGE,
    EventKind.PARTIAL_UNLOADING: style.SKY,
    EventKind.LAST_UNLOADING: style.GREEN,
    EventKind.BASELINE_BEFORE: style.MUTED,
    EventKind.BASELINE_AFTER: style.MUTED,
}
"""Phases, drawn as bands; baselines cover the segments that they belong to."""
MARKERS = {
    EventKind.SNAP_IN: ("v", style.PURPLE),
    EventKind.POP_IN: ("o", style.RED),
    EventKind.PULL_OFF: ("^", style.PURPLE),
    EventKind.SATURATION: ("s", style.INK),
}
NOTED = (EventKind.INTERFERENCE, EventKind.CLOCK_OFFSET, EventKind.DRAG)
LEAST_LABELLED_SHARE = 0.03
"""Least part of the axis over which a phase is labelled."""
HEADROOM = 0.45
"""Part of the range of forces left free above for the labels."""
MOST_DOTS = 4000


class _Phase(NamedTuple):
    kind: EventKind
    first: int
    last: int


@without_extent(ForceCurve)
def curve_sheet(curve: ForceCurve) -> Sheet:
    """Return a curve: force over time and over position, with its phases as bands, and with its events.

    Parameters
    ----------
    curve : ForceCurve
    """
    events = curve.events
    phases = _phases(events, curve.count)
    panels = phases_over_time(curve, phases, COLOURS, events), _over_position(curve, phases, events)
    return Sheet(titled(panels, "what was done", "force over position"), width=5.0, height=3.7)


def _phases(events: CurveEvents, count: int) -> list[_Phase]:
    """Return the segments without their baselines, and the baselines, in their order."""
    place = {kind: number for number, kind in enumerate(COLOURS)}
    owner = np.full(count, -1)
    for event in sorted(events, key=lambda event: "baseline" in event.kind.value):
        if event.kind in place:
            owner[event.first : event.last + 1] = place[event.kind]
    starts = {event.first for event in events if event.kind in place}  # neighbours of one kind stay apart
    edges = sorted({0, *starts, *(np.flatnonzero(np.diff(owner)) + 1).tolist()})
    kinds = list(COLOURS)
    return [
        _Phase(kinds[owner[first]], first, end - 1)
        for first, end in zip(edges, [*edges[1:], count], strict=True)
        if owner[first] >= 0
    ]


def phases_over_time(
    curve: ForceCurve, phases: Iterable[Any], colours: Mapping[Any, str], events: CurveEvents | None = None
) -> Panel:
    """Return the force over time, or over the number of the point, with its phases shaded and named.

    Parameters
    ----------
    curve : ForceCurve
    phases : iterable
        With a kind, and indices of the first and last point.
    colours : mapping
        Of kinds.
    events : CurveEvents, optional
        Marked on the curve.
    """
    order = (
        Series("time", Word("t", "s", "time"), curve.time - curve.time[0])
        if curve.timed
        else Series("point", Word("", "", "point"), np.arange(float(curve.count)))
    )
    force = Series("force", Word("F", "N", "force"), curve.force)
    along = order.content
    span = float(np.ptp(along)) or 1.0
    marks: list[Any] = []
    look: dict[str, Any] = {"upright": "top", "size": 8.0, "turned": True, "framed": (False, True)}
    for phase in phases:
        start, end = along[phase.first], along[min(phase.last + 1, curve.count - 1)]
        marks.append(Band(start, end, colours[phase.kind], 0.16))
        if end - start > LEAST_LABELLED_SHARE * span:
            name = "baseline" if "baseline" in phase.kind.value else phase.kind.value
            marks.append(Text(0.5 * (start + end), 0.98, name, **look))
    marks.append(Line(along, force.content, style.INK, width=1.0, coarse=curve.count > MOST_DOTS))
    marks += _event_marks(events, along, force.content, named=False) if events else ()
    return Panel(tuple(marks), PanelAxis.of(order), PanelAxis.of(force, headroom=HEADROOM))


def _over_position(curve: ForceCurve, phases: list[_Phase], events: CurveEvents) -> Panel:
    """Return force over position, one colour for each kind of phase."""
    position = Series("position", Word("D", "m", "position"), curve.position)
    force = Series("force", Word("F", "N", "force"), curve.force)
    marks: list[Any] = phase_lines(position.content, force.content, phases, COLOURS)
    marks += _event_marks(events, position.content, force.content, named=True)
    nowhere = np.full(1, np.nan)
    for event in (event for kind in NOTED for event in events.of(kind)):
        marks.append(Line(nowhere, nowhere, style.INK, width=0.0, name=_noted(event)))
    upright = PanelAxis.of(force, margin=0.06, headroom=0.0)
    return Panel(tuple(marks), PanelAxis.of(position, margin=0.02), upright, legend="upper left", marker_scale=2.0)


def phase_lines(x: Array, force: Array, phases: Sequence[Any], colours: Mapping[Any, str]) -> list[Any]:
    """Return a force in phases, one colour for each kind, each joined to the last point of the one before."""
    look: dict[str, Any] = {"width": 0.8, "marker": ".", "size": 2.5, "coarse": force.size > MOST_DOTS}
    lines, named = [], set[str]()
    for phase in sorted(phases, key=lambda phase: list(colours).index(phase.kind)):
        own = slice(max(phase.first - 1, 0), phase.last + 1)
        name = "baseline" if "baseline" in phase.kind.value else phase.kind.value
        lines.append(Line(x[own], force[own], colours[phase.kind], name="" if name in named else name, **look))
        named.add(name)
    return lines


def _event_marks(events: CurveEvents, x: Array, force: Array, *, named: bool) -> list[Any]:
    """Return a mark for each sudden event; in the legend with their sizes, or their number."""
    marks: list[Any] = []
    for kind, (marker, colour) in MARKERS.items():
        own = events.of(kind)
        if not own:
            continue
        places = np.array([_place(event, force) for event in own])
        shown = own[0]
        size = with_error(shown.size, shown.error, shown.unit)
        name = f"{kind.value}, {size}" if len(own) == 1 else f"{len(own)} {kind.value}s"
        look: dict[str, Any] = {"width": 0.0, "marker": marker, "size": 6.0, "hollow": True, "order": 5.0}
        marks.append(Line(x[places], force[places], colour, name=name if named else "", **look))
        if not named and kind is EventKind.POP_IN:
            marks += [Rule(float(x[place]), upright=True, colour=colour, width=0.6, order=1.5) for place in places]
    return marks


def _place(event: CurveEvent, force: Array) -> int:
    """Return the point at which an event is marked: the greatest tension, or where it begins."""
    if event.kind in (EventKind.SNAP_IN, EventKind.PULL_OFF):
        return event.first + int(np.argmin(force[event.first : event.last + 1]))
    return event.first


def _noted(event: CurveEvent) -> str:
    """Return an event of the whole curve in one line."""
    remark = f",\n{event.remark}" if event.kind is EventKind.INTERFERENCE else ""
    return f"{event.kind.value}, {with_error(event.size, event.error, event.unit)}{remark}"
