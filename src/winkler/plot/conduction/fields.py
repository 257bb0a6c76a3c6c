"""Maps and sections of the fields of current and heat through a contact."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.panel import Line, Map, Panel, PanelAxis, Rule, Sheet, note
from winkler.plot.series import Series, places, scale_of, series
from winkler.problems.conduction.fields import CurrentFields, HeatFields, restore_conduction
from winkler.problems.conduction.joule_heating import JouleHeatingSolution
from winkler.problems.conduction.thermal_constriction import ThermalConstrictionSolution
from winkler.values.errors import InvalidInput

EXTENT_IN_RADII = 3.0
"""Extent of the map in contact radii."""
GRID = 121
LEVELS = 14
MAP_TITLE = "temperature around the contact"
DENSITY_CEILING = 6.0
"""Greatest drawn density over that in the middle; at the edge it is infinite."""


class _FieldNames(NamedTuple):
    temperature: str
    density: str


FIELD_NAMES = {
    CurrentFields: _FieldNames("temperature", "axial_current_density"),
    HeatFields: _FieldNames("excess_temperature", "axial_heat_flux"),
}


def conduction_map(item: JouleHeatingSolution | ThermalConstrictionSolution) -> Panel:
    """Return the temperature around the contact, the second body above.

    Parameters
    ----------
    item : JouleHeatingSolution or ThermalConstrictionSolution
        Of one load.
    """
    a = float(item.radius)
    r = np.linspace(0.0, EXTENT_IN_RADII * a, GRID)
    z = np.concatenate([-np.linspace(EXTENT_IN_RADII * a, 1e-9 * a, GRID), np.linspace(0.0, EXTENT_IN_RADII * a, GRID)])
    fields: Any = restore_conduction(item, r[:, None], z[None, :])
    return _map(fields, a)


def _map(fields: CurrentFields | HeatFields, radius: float | None = None) -> Panel:
    temperature = series(
        FIELD_NAMES[type(fields)].temperature, getattr(fields, FIELD_NAMES[type(fields)].temperature), type(fields)
    )
    x = np.concatenate([-fields.r[:0:-1], fields.r])
    y, c = (np.concatenate([part[:0:-1], part]) for part in (fields.z, temperature.content))
    if np.ptp(c) <= 1e-12 * max(1.0, float(np.max(np.abs(c)))):
        return Panel((note("the same everywhere", "upper centre"),), title=MAP_TITLE)
    look: dict[str, Any] = {"colours": style.HEATS, "levels": LEVELS, "shrink": 0.8}
    marks: list[Any] = [
        Map(x, y, c, PanelAxis.of(temperature), line_width=0.5, line_alpha=0.8, lines="all", **look),
        Rule(0.0, colour=style.INK),
    ]
    if radius is not None:
        marks.append(Line(np.array([-radius, radius]), np.zeros(2), width=3.0))
    scale = scale_of("m", fields.r, fields.z)
    across = PanelAxis.of(series("r", fields.r, type(fields)), scale)
    upright = PanelAxis.of(series("z", fields.z, type(fields)), scale, falling=True)
    upright = dataclasses.replace(upright, label=upright.label.replace("depth below the surface", "depth"))
    return Panel(tuple(marks), across, upright, equal=True, grid="", title=MAP_TITLE)


def crossing_panel(item: JouleHeatingSolution | ThermalConstrictionSolution) -> Panel:
    """Return the normal density of current or heat and the surface temperature over the radius.

    Parameters
    ----------
    item : JouleHeatingSolution or ThermalConstrictionSolution
        Of one load.
    """
    a = float(item.radius)
    r = places(EXTENT_IN_RADII * a, (a,))
    fields: Any = restore_conduction(item, r, 0.0)
    return _line_panel(fields, series("r", r, type(fields))).plus(title="over the surface of the first body")


def _line_panel(fields: CurrentFields | HeatFields, along: Series) -> Panel:
    names = FIELD_NAMES[type(fields)]
    density = series(names.density, np.abs(getattr(fields, names.density)), type(fields))
    temperature = series(names.temperature, getattr(fields, names.temperature), type(fields))
    finite = density.content[np.isfinite(density.content)]
    positive = finite[finite > 0.0]
    top = 1.05 * float(np.max(positive)) if positive.size else 1.0
    if along.name == "r" and np.ptp(fields.z) == 0.0 and fields.z.flat[0] == 0.0 and positive.size:
        top = DENSITY_CEILING * float(np.min(positive))
    drawn = np.minimum(np.where(np.isfinite(density.content), density.content, np.inf), 2.0 * top)
    kind = "current density" if isinstance(fields, CurrentFields) else "heat flux"
    label, scale = f"{kind} $|{density.word.symbol}|$", scale_of(density.word.unit, top)
    heat = Line(along.content, temperature.content, style.RED, dash=style.DASHES[1], beside=True)
    return Panel(
        (Line(along.content, drawn), heat),
        PanelAxis.of(along),
        PanelAxis(label, scale, low=0.0, high=top, colour=style.BLUE),
        beside=(PanelAxis(f"temperature ${temperature.word.symbol}$", temperature.scale, colour=style.RED),),
    )


@sheet_of.register(CurrentFields)
@sheet_of.register(HeatFields)
def fields_sheet(item: CurrentFields | HeatFields, *, extent: float | None = None) -> Sheet:
    """Return a map of fields on a grid, or curves of fields along a line."""
    checked_extent(extent)
    if np.ndim(item.r) == 2:
        if np.ptp(item.r, axis=0).max() > 0.0 and np.ptp(item.r, axis=1).max() == 0.0:
            panel = _map(item)
        elif np.ptp(item.z, axis=0).max() > 0.0 and np.ptp(item.z, axis=1).max() == 0.0:
            panel = _map(type(item)(*(np.asarray(getattr(item, name)).T for name in item.__dataclass_fields__)))
        else:
            raise InvalidInput("draw: these points do not form a grid; restore on r[:, None] and z[None, :].")
    else:
        if np.size(item.r) < 2:
            raise InvalidInput("draw: one point does not make a curve; restore along a line or on a grid.")
        name = "r" if np.ptp(item.r) >= np.ptp(item.z) else "z"
        panel = _line_panel(item, series(name, getattr(item, name), type(item))).plus(title="along a line")
    if extent is not None:
        low = 0.0 if np.ndim(item.r) == 1 else -extent
        panel = panel.plus(across=dataclasses.replace(panel.across, low=low, high=extent))
    return Sheet((panel,), width=5.0, height=3.4)
