"""Sheets of restored fields: what happens on the surface, and the stresses below it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.errors import InvalidInput
from winkler.fields import SubsurfaceFields, SurfaceFields
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.extent import checked_extent
from winkler.plot.normal.curves import draw_surface, draw_surface_pressure
from winkler.plot.normal.stresses import draw_along, draw_field

if TYPE_CHECKING:
    from winkler.plot.picture import Picture

__all__ = ["subsurface_sheet", "surface_sheet"]


@draw.register(SurfaceFields)
def surface_sheet(item: SurfaceFields, *, extent: float | None = None) -> Picture:
    """Return pressure and displacement of a surface."""
    shown = _cropped(item, extent)
    with style.styled():
        figure = style.figure(2)
        left, right = figure.subplots(1, 2)
        draw_surface_pressure(left, shown)
        draw_surface(right, shown)
        left.set_title("pressure")
        right.set_title("surface")
    return figure


def _cropped(item: SurfaceFields, extent: float | None) -> SurfaceFields:
    r = np.ravel(item.r)
    kept = r <= (np.inf if checked_extent(extent) is None else extent)
    if not kept.any():
        raise InvalidInput(f"draw: there is nothing within the extent of {extent} m; give a greater one.")
    return SurfaceFields(*(np.ravel(part)[kept] for part in (item.r, item.pressure, item.displacement, item.gap)))


@draw.register(SubsurfaceFields)
def subsurface_sheet(item: SubsurfaceFields, *, extent: float | None = None) -> Picture:
    """Return the stresses below a surface: a map of a grid, curves along a line."""
    end = checked_extent(extent)
    with style.styled():
        figure = style.figure(1, width=5.2, height=3.2)
        axes = figure.subplots()
        if _is_grid(item):
            draw_field(axes, item)
            if end is not None:
                across = float(np.max(axes.get_xlim())) / float(np.max(item.r))
                axes.set_xlim(-end * across, end * across)
            axes.set_title("stress below the surface")
        else:
            draw_along(axes, item)
            axes.set_title("stresses along a line")
    return figure


def _is_grid(item: SubsurfaceFields) -> bool:
    if item.r.ndim != 2 or min(item.r.shape) < 2:
        return False
    spread = [(float(np.ptp(part, axis=0).max()), float(np.ptp(part, axis=1).max())) for part in (item.r, item.z)]
    return spread[0].count(0.0) == 1 and spread[1].count(0.0) == 1 and spread[0][0] * spread[1][0] == 0.0
