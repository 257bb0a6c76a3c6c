"""Sheets of line contacts: pressure and surfaces of one load, half-width and pressures of many, onset of yield."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.loading.loads import HalfWidth
from winkler.materials.elastic import Elastic
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.normal.stresses import stress_map
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.series import places, row_of, scale_of, series, with_unit
from winkler.problems.line.adhesion import LineAdhesionSolution
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.problems.line.layered_approach import has_depth
from winkler.problems.line.shakedown import LineShakedownSolution
from winkler.problems.line.yielding import LineYieldOnsetSolution

ACROSS, DOWN = 81, 49
"""Places of a map of stresses."""

Strip = LineSolution | LineAdhesionSolution
HALF_WIDTHS_DRAWN = 2.0
CLIPPED = 99.0
"""Percentile of a pressure that is infinite somewhere, above which it is not drawn."""


@sheet_of.register(LineSolution)
def line_sheet(item: LineSolution, *, extent: float | None = None) -> Sheet:
    """Return pressure and surfaces of one load; of many loads half-width and pressures over the force per length."""
    if np.ndim(item.half_width) == 0:
        return one_strip(item, _pressure_panel, extent)
    panels, titles = [over(item, "half_width"), pressures_over(item)], ["half-width", "pressure"]
    if has_depth(item.problem.bed.medium):
        panels.append(over(item, "depth"))
        titles.append("depth")
    return Sheet(titled(panels, *titles))


def one_strip(item: Strip, pressure_panel: Callable[[Any, float], Panel], extent: float | None) -> Sheet:
    """Return pressure and surfaces of one load."""
    a = float(item.half_width)
    end = checked_extent(extent) or HALF_WIDTHS_DRAWN * a or 1.0
    title = f"{with_unit(float(item.force_per_length), 'N/m')} on a half-width of {with_unit(a, 'm')}"
    panels = titled((pressure_panel(item, end), surface_panel(item, end)), "pressure", "distance of the surfaces")
    return Sheet(panels, height=3.1, title=title)


@sheet_of.register(LineYieldOnsetSolution)
@sheet_of.register(LineShakedownSolution)
def line_yield_sheet(item: LineYieldOnsetSolution | LineShakedownSolution, *, extent: float | None = None) -> Sheet:
    """Return what is limited below the contact: the von Mises stress at the onset of yield, the shear at shakedown."""
    a = item.half_width
    end = checked_extent(extent) or HALF_WIDTHS_DRAWN * a
    sign = float(np.copysign(1.0, item.z))  # -0.0 is the surface of the second body
    x = np.linspace(-end, end, ACROSS)
    z = sign * min(end, _deepest(item) if sign > 0.0 else end) * np.linspace(0.0, 1.0, DOWN) ** 1.6
    contact = LineIndentation(item.problem.bed, HalfWidth(a)).solve()
    found = contact.stresses(x[:, None], z[None, :] + sign * 1e-6 * a, item.problem.friction.coefficient)
    beside, down = np.broadcast_arrays(x[:, None], z[None, :])
    place = Line(np.array([item.x]), np.array([item.z]), "white", width=0.0, marker="+", size=9.0)
    onset = isinstance(item, LineYieldOnsetSolution)
    limited = series("von_mises", found.von_mises) if onset else series("xz_stress", np.abs(found.xz_stress))
    panel = stress_map(series("x", beside), series("z", down), limited, "$x$")
    limit = "onset of yield" if onset else "shakedown limit"
    title = f"{limit}: {with_unit(item.force_per_length, 'N/m')} on a half-width of {with_unit(a, 'm')}"
    return Sheet((panel.plus(place),), width=5.4, height=3.3, title=title)


def _deepest(item: LineYieldOnsetSolution | LineShakedownSolution) -> float:
    """Return how deep stresses are known [m]: not in a rigid base."""
    medium = item.problem.bed.medium
    if not isinstance(medium, CoatedHalfSpace) or isinstance(medium.on, Elastic):
        return np.inf
    return (1.0 - 1e-5) * medium.thickness


def over(item: Any, name: str, along: str = "force_per_length") -> Panel:
    """Return a result of all loads over the load."""
    return curves_panel(row_of(item, along), [(row_of(item, name), "")])


def pressures_over(item: Any, along: str = "force_per_length", name: str = "mean", of: str = "mean_pressure") -> Panel:
    """Return the greatest pressure, where it is finite, and another one of all loads over the load."""
    pressures = [(row_of(item, of), name)]
    if np.isfinite(item.peak_pressure).all():
        pressures.insert(0, (row_of(item, "peak_pressure"), "greatest"))
    return curves_panel(row_of(item, along), pressures, label="pressure")


def across(end: float) -> PanelAxis:
    """Return the axis across the strip."""
    return PanelAxis("$x$", scale_of("m", [end]), low=-end, high=end)


def _pressure_panel(item: LineSolution, end: float) -> Panel:
    a = float(item.half_width)
    marks = (a, *(b for b, _ in item.problem.bed.kinks if b < end)) if a > 0.0 else ()
    x = places(end, marks, count=241)
    finite, upright = pressure_axis(item.pressure(x), CLIPPED if np.isinf(item.peak_pressure) else 100.0)
    return Panel((Line(*style.mirrored(x, finite), style.RED),), across(end), upright)


def pressure_axis(pressure: Array, share: float = 100.0) -> tuple[Array, PanelAxis]:
    """Return a pressure without infinite values, and its axis up to the percentile `share`."""
    finite = np.where(np.isfinite(pressure), pressure, np.nan)
    most = float(np.nanpercentile(finite, share) if share < 100.0 else np.nanmax(finite))
    of, high = series("pressure", finite), 1.1 * most if most > 0.0 else None
    return finite, PanelAxis.of(of, scale_of("Pa", [most]), low=0.0, high=high)


def surface_panel(item: Strip, end: float) -> Panel:
    """Return the surfaces before and after they are pressed, as the distance between them."""
    bed, a = item.problem.bed, float(item.half_width)
    end = min(end, bed.reach, bed.rim)
    x = places(end, (a,) if 0.0 < a < end else (), count=121)
    before = np.asarray(bed.profile.height(x), dtype=float)
    both, height = style.mirrored(x, before)
    pressed = style.mirrored(x, item.separation(x))[1] if a < bed.rim else None
    return distance_panel(both, height, pressed, across(end), legend="upper center")


def distance_panel(x: Array, before: Array, pressed: Array | None, along: PanelAxis, legend: str) -> Panel:
    """Return the distance of the surfaces before and after they are pressed."""
    most = float(np.nanmax(before))
    marks = [Line(x, before, style.MUTED, dash=style.DASHES[1], name="before")]
    marks += [] if pressed is None else [Line(x, pressed, style.BLUE, name="pressed")]
    of, high = series("separation", before), 1.05 * most if most > 0.0 else None
    return Panel(tuple(marks), along, PanelAxis.of(of, scale_of("m", [most or 1.0]), low=0.0, high=high), legend=legend)
