"""Sheets of worn height maps: heights and pressures before and after, and what changes over the distance slid."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.rough.roughness import map_panel
from winkler.plot.series import Series, scale_of, series, series_of, with_unit
from winkler.problems.surface_wear.states import SurfaceWearState
from winkler.problems.surface_wear.wear import SurfaceWearSolution
from winkler.profiles.rough.topography import Topography

FEWEST_STATES = 2
DECADES = 100.0
"""Greatest over smallest distance from which their axis is logarithmic."""
MOST_MARKED = 40


def _cut_panel(item: SurfaceWearSolution) -> Panel:
    """Return the heights along a line through the most worn pixel, before and after."""
    rough = item.problem.contact.topography
    deepest = np.unravel_index(int(np.argmax(item.last.worn)), item.last.worn.shape)
    before = rough.heights[:, deepest[1]] - np.mean(rough.heights)
    after = before - item.last.worn[:, deepest[1]]
    place = (np.arange(before.size) + 0.5) * rough.pixel[0]
    scale = scale_of("m", before)
    marks = (
        Line(place, before, style.MUTED, width=1.0, name="before wear", dash=style.DASHES[1]),
        Line(place, after, style.BLUE, width=1.3, name="worn"),
    )
    across = PanelAxis("place $x$", scale_of("m", rough.lengths), margin=0.0)
    return Panel(marks, across, PanelAxis("height $z$", scale, margin=0.25), legend="best")


def _pressure_panel(rough: Topography, state: SurfaceWearState) -> Panel:
    pressed = series("pressure", np.where(state.pressure > 0.0, state.pressure, np.nan))
    return map_panel(rough, pressed, style.SHADES)


def _over_distance(item: SurfaceWearSolution, rows: list[tuple[Series, str]], label: str, *, log: bool) -> Panel:
    """Return some quantities over the distance slid."""
    along = series_of(item, "distance")
    wide = _spread(along.content) > DECADES
    contents = np.concatenate([of.content for of, _ in rows])
    finite = contents[np.isfinite(contents)]
    steep = log and _spread(finite) > DECADES
    marks = []
    for (of, name), colour in zip(rows, (style.BLUE, style.RED), strict=False):
        shown = np.isfinite(of.content) & ((along.content > 0.0) | (not wide)) & ((of.content > 0.0) | (not steep))
        look: dict[str, Any] = {"marker": "o", "size": 3.5} if along.content.size <= MOST_MARKED else {}
        marks.append(Line(along.content[shown], of.content[shown], colour, width=1.3, name=name, **look))
    upright = PanelAxis(label, scale_of(rows[0][0].word.unit, finite), log=steep, margin=0.1)
    across = PanelAxis("distance $s$", along.scale, log=wide, margin=0.04)
    return Panel(tuple(marks), across, upright, legend="best" if len(rows) > 1 else "")


def _spread(content: Array) -> float:
    """Return the greatest over the smallest positive number."""
    positive = content[content > 0.0]
    return float(np.max(positive) / np.min(positive)) if positive.size else 1.0


@without_extent(SurfaceWearSolution)
def surface_wear_sheet(item: SurfaceWearSolution) -> Sheet:
    """Return heights, worn depth and pressures; of several distances also area, pressures, heights and volume."""
    rough = item.problem.contact.topography
    far = [with_unit(state.distance, "m", 3) for state in (item.first, item.last)]
    lost = series("worn", np.where(item.last.worn > 0.0, item.last.worn, np.nan), type(item.last))
    panels = [
        _cut_panel(item),
        map_panel(rough, lost, style.SHADES, label="worn off"),
        _pressure_panel(rough, item.first),
    ]
    names = ["cut through the most worn pixel", f"worn off after {far[1]}", f"pressure after {far[0]}"]
    if item.distance.size >= FEWEST_STATES:
        share = Series("area", series_of(item, "area").word, 100.0 * item.area / rough.area)
        panels += [
            _pressure_panel(rough, item.last),
            _over_distance(
                item,
                [(series_of(item, "peak_pressure"), "greatest"), (series_of(item, "mean_pressure"), "mean")],
                "pressure",
                log=True,
            ),
            _over_distance(item, [(series_of(item, "rms_height"), "")], "rms height $Sq$", log=False),
            _over_distance(item, [(series_of(item, "skewness"), "")], "skewness $Ssk$", log=False),
            _area_panel(item, share),
            _over_distance(item, [(series_of(item, "worn_volume"), "")], "worn volume $V$", log=True),
        ]
        names += [
            f"pressure after {far[1]}",
            "pressures",
            "root mean square height",
            "skewness",
            "contact",
            "worn volume",
        ]
    title = f"{with_unit(item.last.worn_volume, 'm^3')} worn off after {far[1]} under {with_unit(item.last.force, 'N')}"
    return Sheet(titled(tuple(panels), *names), 3, width=4.0, height=3.2, title=title)


def _area_panel(item: SurfaceWearSolution, share: Series) -> Panel:
    """Return which part of the map touches, over the distance slid."""
    along = series_of(item, "distance")
    wide = _spread(along.content) > DECADES
    shown = (along.content > 0.0) | (not wide)
    mark = Line(along.content[shown], share.content[shown], style.BLUE, width=1.3, marker="o", size=3.5)
    across = PanelAxis("distance $s$", along.scale, log=wide, margin=0.04)
    return Panel((mark,), across, PanelAxis("part of the map in contact [%]", low=0.0, margin=0.1))
