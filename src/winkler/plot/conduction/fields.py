"""Maps and cuts of the fields of current and heat through a contact."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from winkler.errors import InvalidInput
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.extent import checked_extent
from winkler.plot.series import Series, middle_scale, places, scale_of, series
from winkler.problems.conduction.fields import CurrentFields, HeatFields, restore_conduction
from winkler.problems.conduction.joule_heating import JouleHeatingSolution
from winkler.problems.conduction.thermal_constriction import ThermalConstrictionSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap

    from winkler.plot.picture import Picture

__all__ = ["draw_conduction_map", "draw_crossing", "fields_sheet"]

FAR = 3.0
"""How far from the contact is drawn, in contact radii."""
GRID = 121
LEVELS = 14
HIGHEST = 6.0
"""Densities end at so many times that in the middle: at the edge they are infinite."""


class _Names(NamedTuple):
    warm: str
    density: str


NAMES = {
    CurrentFields: _Names("temperature", "axial_current_density"),
    HeatFields: _Names("excess_temperature", "axial_heat_flux"),
}


def _heats() -> Colormap:
    from matplotlib import colormaps

    return colormaps["YlOrRd"]


def draw_conduction_map(axes: Axes, item: JouleHeatingSolution | ThermalConstrictionSolution) -> None:
    """Draw the temperature around the contact, the second body above.

    Parameters
    ----------
    axes : Axes
        Empty.
    item : JouleHeatingSolution or ThermalConstrictionSolution
        Of one load.
    """
    a = float(item.radius)
    r = np.linspace(0.0, FAR * a, GRID)
    z = np.concatenate([-np.linspace(FAR * a, 1e-9 * a, GRID), np.linspace(0.0, FAR * a, GRID)])
    fields: Any = restore_conduction(item, r[:, None], z[None, :])
    _draw_map(axes, fields, a)
    axes.set_title("temperature around the contact")


def _draw_map(axes: Axes, fields: CurrentFields | HeatFields, radius: float | None = None) -> None:
    warm = series(type(fields), NAMES[type(fields)].warm, getattr(fields, NAMES[type(fields)].warm))
    across = scale_of("m", fields.r, fields.z)
    scale = warm.scale
    x = np.concatenate([-fields.r[:0:-1], fields.r]) / across.factor
    y = np.concatenate([fields.z[:0:-1], fields.z]) / across.factor
    c = np.concatenate([warm.content[:0:-1], warm.content]) / scale.factor
    if np.ptp(c) <= 1e-12 * max(1.0, float(np.max(np.abs(c)))):
        style.note(axes, "the same everywhere", where="upper centre")
        return
    shown = axes.contourf(x, y, c, levels=LEVELS, cmap=_heats())
    axes.contour(x, y, c, levels=shown.levels, colors="white", linewidths=0.5, alpha=0.8)
    axes.axhline(0.0, color=style.INK, linewidth=0.8)
    if radius is not None:
        axes.plot([-radius / across.factor, radius / across.factor], [0.0, 0.0], color=style.BLUE, linewidth=3.0)
    axes.invert_yaxis()
    axes.set_aspect("equal")
    axes.grid(visible=False)
    axes.set_xlabel(series(type(fields), "r", fields.r).label(across))
    axes.set_ylabel(series(type(fields), "z", fields.z).label(across).replace("depth below the surface", "depth"))
    assert axes.figure is not None
    axes.figure.colorbar(shown, ax=axes, shrink=0.8, label=warm.label(scale))


def draw_crossing(axes: Axes, item: JouleHeatingSolution | ThermalConstrictionSolution) -> None:
    """Draw how fast current or heat crosses the contact, and the temperature of the surface, over the radius.

    Parameters
    ----------
    axes : Axes
        Empty.
    item : JouleHeatingSolution or ThermalConstrictionSolution
        Of one load.
    """
    a = float(item.radius)
    r = places(FAR * a, (a,))
    fields: Any = restore_conduction(item, r, 0.0)
    _draw_line(axes, fields, series(type(fields), "r", r))
    axes.set_title("over the surface of the first body")


def _draw_line(axes: Axes, fields: CurrentFields | HeatFields, along: Series) -> None:
    names = NAMES[type(fields)]
    density = series(type(fields), names.density, np.abs(getattr(fields, names.density)))
    warm = series(type(fields), names.warm, getattr(fields, names.warm))
    finite = density.content[np.isfinite(density.content)]
    positive = finite[finite > 0.0]
    top = 1.05 * float(np.max(positive)) if positive.size else 1.0
    if along.name == "r" and np.ptp(fields.z) == 0.0 and fields.z.flat[0] == 0.0 and positive.size:
        top = HIGHEST * float(np.min(positive))
    shown = np.minimum(np.where(np.isfinite(density.content), density.content, np.inf), 2.0 * top)
    scale = scale_of(density.word.unit, top)
    axes.plot(along.shown(), shown / scale.factor, color=style.BLUE)
    axes.set_ylim(0.0, top / scale.factor)
    axes.set_xlabel(along.label())
    symbol = density.word.symbol
    kind = "current density" if isinstance(fields, CurrentFields) else "heat flux"
    axes.set_ylabel(f"{kind} $|{symbol}|$ [{scale.unit}]", color=style.BLUE)
    other = axes.twinx()
    heat = warm.scale
    other.plot(along.shown(), warm.shown(heat), color=style.RED, linestyle=style.DASHES[1])
    other.set_ylabel(f"temperature ${warm.word.symbol}$ [{heat.unit}]", color=style.RED)
    other.grid(visible=False)
    other.spines["right"].set_visible(True)


@draw.register(CurrentFields)
@draw.register(HeatFields)
def fields_sheet(item: CurrentFields | HeatFields, *, extent: float | None = None) -> Picture:
    """Return a map of fields on a grid, or curves of fields along a line."""
    checked_extent(extent)
    with style.styled():
        figure = style.figure(width=5.0, height=3.4)
        axes: Any = figure.subplots()
        if np.ndim(item.r) == 2:
            if np.ptp(item.r, axis=0).max() > 0.0 and np.ptp(item.r, axis=1).max() == 0.0:
                _draw_map(axes, item)
            elif np.ptp(item.z, axis=0).max() > 0.0 and np.ptp(item.z, axis=1).max() == 0.0:
                turned = type(item)(*(np.asarray(getattr(item, name)).T for name in item.__dataclass_fields__))
                _draw_map(axes, turned)
            else:
                raise InvalidInput("draw: these places are no grid; restore on r[:, None] and z[None, :].")
            axes.set_title("temperature around the contact")
        else:
            if np.size(item.r) < 2:
                raise InvalidInput("draw: one place is no curve; restore along a line or on a grid.")
            name = "r" if np.ptp(item.r) >= np.ptp(item.z) else "z"
            _draw_line(axes, item, series(type(item), name, getattr(item, name)))
            axes.set_title("along a line")
        if extent is not None:
            across = middle_scale("m", item.r).factor
            axes.set_xlim(0.0 if np.ndim(item.r) == 1 else -extent / across, extent / across)
    return figure
