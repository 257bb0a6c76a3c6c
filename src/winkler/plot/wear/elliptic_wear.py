"""Sheet of an elliptic contact that wears: a map of what the slider has lost, and the section of the track."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Arrow, Line, Map, Panel, PanelAxis, Sheet, plane, titled
from winkler.plot.series import series, with_unit
from winkler.problems.wear.elliptic import EllipticWearSolution

EXTENT = 1.35
"""Of the pictures over the semi-axes."""
NEEDLE = 10.0
"""Ratio of the semi-axes beyond which the map has a scale of its own for either axis."""
PLACES, PLACES_ACROSS = 161, 241
LEVELS = 10


@without_extent(EllipticWearSolution)
def elliptic_wear_sheet(item: EllipticWearSolution) -> Sheet:
    """Return a map of the worn depth of the slider, and the section of the track or, without one, of the slider."""
    tracked = item.track_depth > 0.0
    section = _track_panel(item) if tracked else _sections_panel(item)
    panels = titled((_map_panel(item), section), "worn off the slider", "track" if tracked else "through the middle")
    title = f"$h_\\mathrm{{max}}$ = {with_unit(item.worn_depth, 'm')}   $V$ = {with_unit(item.worn_volume, 'm^3')}"
    if tracked:
        title += f"   $h_\\mathrm{{track}}$ = {with_unit(item.track_depth, 'm')}"
    return Sheet(panels, width=4.6, height=3.4, title=title)


def _semi_axes(item: EllipticWearSolution) -> tuple[float, float]:
    return float(item.contact.longitudinal_semi_axis), float(item.contact.lateral_semi_axis)


def _map_panel(item: EllipticWearSolution) -> Panel:
    a, b = _semi_axes(item)
    larger, equal = max(a, b), max(a, b) <= NEEDLE * min(a, b)
    half = np.array([larger, larger]) if equal else np.array([a, b])
    x, y = (np.linspace(-EXTENT, EXTENT, PLACES) * each for each in half)
    of = series("worn", item.worn(x[:, None], y[None, :]))
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    look: dict[str, Any] = {"levels": LEVELS, "colours": style.HEATS, "line_width": 0.4, "shrink": 0.78}
    forth = 0.5 * half * np.array([math.cos(item.problem.angle), math.sin(item.problem.angle)])
    marks = (
        Map(x, y, of.content.T, PanelAxis("worn depth", of.scale), **look),
        Line(a * np.cos(turn), b * np.sin(turn), style.INK, width=1.1),
        Arrow((float(-forth[0]), float(-forth[1])), (float(forth[0]), float(forth[1])), style.INK),
    )
    if equal:
        return Panel(marks, *plane(series("x", x).scale), equal=True, grid="")
    across, upright = (PanelAxis(f"${name}$", series("x", place).scale) for name, place in (("x", x), ("y", y)))
    return Panel(marks, across, upright, grid="")


def _track_panel(item: EllipticWearSolution) -> Panel:
    """Return the depth of the track over the distance from its middle, downwards."""
    t = np.linspace(-EXTENT, EXTENT, PLACES_ACROSS) * item.track_half_width
    of = series("worn", item.track(t))
    across = PanelAxis("across the sliding $t$", series("x", t).scale)
    upright = PanelAxis("surface of the second body", of.scale, low=-1.12 * float(np.max(of.content)))
    return Panel((Line(t, -of.content, style.RED),), across, upright)


def _sections_panel(item: EllipticWearSolution) -> Panel:
    """Return the worn depth of the slider along both axes."""
    marks, share = [], np.linspace(-EXTENT, EXTENT, PLACES_ACROSS)
    looks = (("x", (1.0, 0.0), style.BLUE, style.DASHES[0]), ("y", (0.0, 1.0), style.RED, style.DASHES[1]))
    for (name, (along, across), colour, dash), half in zip(looks, _semi_axes(item), strict=True):
        place = share * half
        marks.append(Line(place, item.worn(along * place, across * place), colour, dash=dash, name=f"along {name}"))
    places = series("x", np.concatenate([line.x for line in marks]))
    worn = series("worn", np.concatenate([line.y for line in marks]))
    upright = PanelAxis("worn depth", worn.scale, low=0.0, high=1.12 * float(np.max(worn.content)) or worn.scale.factor)
    return Panel(tuple(marks), PanelAxis("place", places.scale), upright, legend="upper right")
