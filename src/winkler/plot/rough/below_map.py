"""Sheets of stresses below a map of loads: the loads, and the von Mises stress at a depth and on a plane."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.normal.stresses import stress_map
from winkler.plot.panel import Panel, Sheet, points
from winkler.plot.rough.roughness import framed, image_of
from winkler.plot.series import Series, series, with_unit
from winkler.problems.subsurface.below_surface import fields_at_depth, fields_on_plane
from winkler.problems.subsurface.map_stress import MapStressSolution

DEPTHS_DRAWN = 41
LEAST_DEPTH_DRAWN = 0.35
"""Depth of the picture over the length of the map, unless the greatest stress lies deeper."""
FIRST_DEPTH = 0.5
"""Depth of the first row of the picture, in pixels."""


@without_extent(MapStressSolution)
def map_stress_sheet(item: MapStressSolution) -> Sheet:
    """Return pressure, and the von Mises stress in the depth of the greatest one and on the plane through it."""
    load, solid = item.problem.load, item.problem.solid
    depth = max(item.z, FIRST_DEPTH * load.pixel[1])
    flat = fields_at_depth(load, solid, depth)
    pressure = series("pressure", np.where(load.pressure != 0.0, load.pressure, np.nan))
    place = points([item.x], [item.y], "white", marker="+", size=9.0)
    panels = (
        _map(item, pressure).plus(title="pressure"),
        _map(item, series("von_mises", flat.von_mises)).plus(
            place, title=f"von Mises stress at a depth of {with_unit(depth, 'm', 3)}"
        ),
        _plane(item).plus(points([item.x], [item.z], "white", marker="+", size=9.0)),
    )
    title = f"{with_unit(item.force, 'N')};  greatest von Mises stress {with_unit(item.von_mises, 'Pa')}"
    return Sheet(panels, width=4.4, height=3.3, title=title)


def _map(item: MapStressSolution, of: Series) -> Panel:
    """Return one quantity over the pixels."""
    load = item.problem.load
    sides = [start + np.array([0.0, length]) for start, length in zip(load.corner, load.lengths, strict=True)]
    return framed(image_of(of, style.SHADES, sides))


def _plane(item: MapStressSolution) -> Panel:
    """Return the von Mises stress on the plane along x through its greatest."""
    load = item.problem.load
    deepest = max(LEAST_DEPTH_DRAWN * float(load.lengths[0]), 2.0 * item.z)
    depths = np.linspace(FIRST_DEPTH * load.pixel[0], deepest, DEPTHS_DRAWN)
    below = fields_on_plane(load, item.problem.solid, depths, x=np.nan, y=item.y)
    panel = stress_map(
        series("x", below.x, type(item)), series("z", below.z), series("von_mises", below.von_mises), "$x$"
    )
    return panel.plus(title=f"von Mises stress at y = {with_unit(item.y, 'm', 3)}")
