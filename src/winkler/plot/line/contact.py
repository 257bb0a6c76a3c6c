"""Sheets of line contacts: pressure and surfaces of one load, half-width and pressures of many, onset of yield."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.loading.loads import HalfWidth
from winkler.materials.elastic import Elastic
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.normal.stresses import stress_map
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled
from winkler.plot.rough.roughness import models_panel
from winkler.plot.series import Series, places, scale_of, series, with_unit
from winkler.problems.line.adhesion import LineAdhesionSolution
from winkler.problems.line.indentation import LineIndentation, LineSolution
from winkler.problems.line.layered_approach import has_depth
from winkler.problems.line.shakedown import LineShakedownSolution
from winkler.problems.line.yielding import LineYieldOnsetSolution

__all__ = ["across", "flat", "line_sheet", "line_yield_sheet", "mirrored", "pressure_across", "surface_panel"]

ACROSS, DOWN = 81, 49
"""Places of a map of stresses."""

HALF_WIDTHS_DRAWN = 2.0
CLIPPED = 99.0
"""Percentile of a pressure that is infinite somewhere, above which it is not drawn."""


@sheet_of.register(LineSolution)
def line_sheet(item: LineSolution, *, extent: float | None = None) -> Sheet:
    """Return pressure and surfaces of one load; of many loads half-width and pressures over the force per length."""
    if np.ndim(item.half_width) == 0:
        a = float(item.half_width)
        end = checked_extent(extent) or HALF_WIDTHS_DRAWN * a or 1.0
        title = f"{with_unit(float(item.force_per_length), 'N/m')} on a half-width of {with_unit(a, 'm')}"
        panels = titled((_pressure_panel(item, end), surface_panel(item, end)), "pressure", "distance of the surfaces")
        return Sheet(panels, height=3.1, title=title)
    force = flat(item, "force_per_length")
    pressures = [(flat(item, "mean_pressure"), "mean")]
    if np.isfinite(item.peak_pressure).all():
        pressures.insert(0, (flat(item, "peak_pressure"), "greatest"))
    widths = models_panel(force, [(flat(item, "half_width"), "")])
    over_force, titles = [widths, models_panel(force, pressures, label="pressure")], ["half-width", "pressure"]
    if has_depth(item.problem.bed.medium):
        over_force.append(models_panel(force, [(flat(item, "depth"), "")]))
        titles.append("depth")
    return Sheet(titled(tuple(over_force), *titles))


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
    across, down = np.broadcast_arrays(x[:, None], z[None, :])
    place = Line(np.array([item.x]), np.array([item.z]), "white", width=0.0, marker="+", size=9.0)
    onset = isinstance(item, LineYieldOnsetSolution)
    limited = series("von_mises", found.von_mises) if onset else series("xz_stress", np.abs(found.xz_stress))
    panel = stress_map(series("x", across), series("z", down), limited, "$x$")
    limit = "onset of yield" if onset else "shakedown limit"
    title = f"{limit}: {with_unit(item.force_per_length, 'N/m')} on a half-width of {with_unit(a, 'm')}"
    return Sheet((panel.plus(place),), width=5.4, height=3.3, title=title)


def _deepest(item: LineYieldOnsetSolution | LineShakedownSolution) -> float:
    """Return how deep stresses are known [m]: not in a rigid base."""
    medium = item.problem.bed.medium
    if not isinstance(medium, CoatedHalfSpace) or isinstance(medium.on, Elastic):
        return np.inf
    return (1.0 - 1e-5) * medium.thickness


def flat(item: Any, name: str) -> Series:
    """Return a result of all loads in one row."""
    return series(name, np.ravel(np.asarray(getattr(item, name), dtype=float)), type(item))


def mirrored(x: np.ndarray, content: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return places and contents on both sides of the middle."""
    return np.concatenate([-x[::-1], x]), np.concatenate([content[::-1], content])


def across(end: float) -> PanelAxis:
    """Return the axis across the strip."""
    return PanelAxis("$x$", scale_of("m", [end]), low=-end, high=end)


def pressure_across(item: Any, end: float, count: int) -> tuple[Array, Array]:
    """Return places across a strip up to `end` [m], and the pressure there [Pa], not a number where it is infinite."""
    a = float(item.half_width)
    marks = (a, *(b for b, _ in item.problem.bed.kinks if b < end)) if a > 0.0 else ()
    x = places(end, marks, count=count)
    pressure = item.pressure(x)
    return x, np.where(np.isfinite(pressure), pressure, np.nan)


def _pressure_panel(item: LineSolution, end: float) -> Panel:
    x, finite = pressure_across(item, end, 241)
    drawn = series("pressure", finite)
    infinite = not np.isfinite(item.peak_pressure)
    most = float(np.nanpercentile(finite, CLIPPED) if infinite else np.nanmax(finite))
    upright = PanelAxis.of(drawn, scale_of("Pa", [most]), low=0.0, high=1.1 * most if most > 0.0 else None)
    return Panel((Line(*mirrored(x, finite), style.RED),), across(end), upright)


def surface_panel(item: LineSolution | LineAdhesionSolution, end: float) -> Panel:
    """Return the surfaces before and after they are pressed, as the distance between them."""
    bed, a = item.problem.bed, float(item.half_width)
    end = min(end, bed.reach, bed.rim)
    x = places(end, (a,) if 0.0 < a < end else (), count=121)
    before = series("separation", np.asarray(bed.profile.height(x), dtype=float))
    marks = [Line(*mirrored(x, before.content), style.MUTED, dash=style.DASHES[1], name="before")]
    if a < bed.rim:
        marks.append(Line(*mirrored(x, item.separation(x)), style.BLUE, name="pressed"))
    most = float(np.max(before.content))
    upright = PanelAxis.of(before, scale_of("m", [most or 1.0]), low=0.0, high=1.05 * most if most > 0.0 else None)
    return Panel(tuple(marks), across(end), upright, legend="upper center")
