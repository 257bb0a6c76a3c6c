"""Sheets of restored fields: on the surface, and stresses below it."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.fields.restoration import SubsurfaceFields, SurfaceFields
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.normal.curves import surface_panel
from winkler.plot.normal.stresses import along_panel, field_panel
from winkler.plot.panel import Sheet, titled
from winkler.plot.series import row_of
from winkler.values.errors import InvalidInput


@sheet_of.register(SurfaceFields)
def surface_sheet(item: SurfaceFields, *, extent: float | None = None) -> Sheet:
    """Return pressure and displacement of a surface."""
    cropped = _cropped(item, extent)
    pressure = curves_panel(row_of(cropped, "r"), [(row_of(cropped, "pressure"), "")])
    return Sheet(titled((pressure, surface_panel(cropped)), "pressure", "surface"))


def _cropped(item: SurfaceFields, extent: float | None) -> SurfaceFields:
    r = np.ravel(item.r)
    within = r <= (np.inf if checked_extent(extent) is None else extent)
    if not within.any():
        raise InvalidInput(f"draw: there is nothing within the extent of {extent} m; give a greater one.")
    return SurfaceFields(*(np.ravel(part)[within] for part in (item.r, item.pressure, item.displacement, item.gap)))


@sheet_of.register(SubsurfaceFields)
def subsurface_sheet(item: SubsurfaceFields, *, extent: float | None = None) -> Sheet:
    """Return the stresses below a surface: a map of a grid, curves along a line."""
    end = checked_extent(extent)
    if not _is_grid(item):
        return Sheet((along_panel(item).plus(title="stresses along a line"),), width=5.2, height=3.2)
    panel = field_panel(item).plus(title="stress below the surface")
    if end is not None:
        panel = panel.plus(across=dataclasses.replace(panel.across, low=-end, high=end))
    return Sheet((panel,), width=5.2, height=3.2)


def _is_grid(item: SubsurfaceFields) -> bool:
    if item.r.ndim != 2 or min(item.r.shape) < 2:
        return False
    spread = [(float(np.ptp(part, axis=0).max()), float(np.ptp(part, axis=1).max())) for part in (item.r, item.z)]
    return spread[0].count(0.0) == 1 and spread[1].count(0.0) == 1 and spread[0][0] * spread[1][0] == 0.0
