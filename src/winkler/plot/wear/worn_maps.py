"""Sheets of worn height maps: heights and pressures before and after, and what changes over the distance slid."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.families import in_equal_ratios
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.rough.roughness import map_panel, share_of_map
from winkler.plot.series import scale_of, series, series_of, with_unit
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
        slid = item.distance > 0.0  # decades of distances have no place for the start
        drawn = np.flatnonzero(slid) if in_equal_ratios(item.distance[slid]) else np.arange(slid.size)
        pressures = {"peak_pressure": "greatest", "mean_pressure": "mean"}
        panels.append(_pressure_panel(rough, item.last))
        for chosen in (pressures, {"rms_height": ""}, {"skewness": ""}, {"area": ""}, {"worn_volume": ""}):
            rows = [
                (share_of_map(item.area, rough) if name == "area" else series_of(item, name), label)
                for name, label in chosen.items()
            ]
            distance, *rows = [
                (dataclasses.replace(of, content=of.content[drawn]), label)
                for of, label in ((series_of(item, "distance"), ""), *rows)
            ]
            panels.append(curves_panel(distance[0], rows, label="pressure" if len(rows) > 1 else ""))
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
