"""Sheets of pressed height maps: patches of contact, distributions of gap and pressure, and the leak of seals."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.films.joined import islands
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Bounds, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Sheet, Vectors, note, titled
from winkler.plot.rough.roughness import map_panel
from winkler.plot.series import positive, row_of, scale_of, series, with_unit
from winkler.problems.pressed_maps.seal import SealSolution
from winkler.problems.pressed_maps.seal_states import FilmPassage, gap_of
from winkler.problems.pressed_maps.true_area import TrueAreaSolution, patch_areas
from winkler.problems.rough.surface_states import SurfaceState

FEWEST_LOADS = 2
ARROWS_ACROSS = 17
BINS = 60
MOST_POINTS = 400


def _density_panel(content: Array, name: str, unit: str, what: str) -> Panel:
    """Return how much of the map has which gap or pressure, as a density whose integral is one."""
    scale = scale_of(unit, content)
    heights, edges = np.histogram(content, BINS, density=True)
    x = np.repeat(edges, 2)[1:-1]
    shown = np.repeat(heights, 2) * scale.factor
    marks = (Area(x, 0.0 * shown, shown, style.BLUE, 0.3), Line(x, shown, style.BLUE, width=1.2))
    upright = PanelAxis(f"{what} [1/{scale.unit}]", low=0.0, margin=0.08)
    return Panel(marks, PanelAxis(name, scale, low=0.0, margin=0.02), upright)


def _gap_panel(state: SurfaceState) -> Panel:
    """Return the distribution of the gap outside of the contact."""
    gap = gap_of(state.pressure, state.separation)
    if not np.any(gap > 0.0):
        return Panel((note("touches everywhere"),))
    touching = 100.0 * float(np.mean(gap == 0.0))
    panel = _density_panel(gap[gap > 0.0], "gap $h$", "m", "part of the open map")
    return panel.plus(note(f"{touching:.3g} % of the pixels touch"))


def _sizes_panel(areas: Array) -> Panel:
    """Return how many patches are larger than an area."""
    counts = np.arange(1.0, areas.size + 1.0)
    keep = np.unique(np.geomspace(1, areas.size, MOST_POINTS).astype(int)) - 1
    look: dict[str, Any] = {"width": 0.0, "marker": "o", "size": 3.5}
    across = PanelAxis("area of a patch", scale_of("m^2", areas), log=True, margin=0.08)
    upright = PanelAxis("patches as large or larger", log=True, margin=0.08)
    return Panel((Line(areas[keep], counts[keep], style.BLUE, **look),), across, upright)


@without_extent(TrueAreaSolution)
def true_area_sheet(item: TrueAreaSolution) -> Sheet:
    """Return the patches of the last load, its distributions, and area and peak pressure of many loads."""
    contact, state = item.problem.contact, item.contact.last
    rough = contact.topography
    touching = state.pressure > 0.0
    labels, _ = islands(touching, (rough.periodic, rough.periodic), corners=True)
    counts = np.bincount(labels.ravel())
    counts[0] = 0
    size = np.where(touching, counts[labels] * (float(state.area) / float(np.sum(counts))), np.nan)
    areas = patch_areas(state, contact)
    panels = [
        map_panel(rough, series("area", size), style.SHADES, label="area of the patch"),
        _density_panel(state.pressure[touching], "pressure $p$", "Pa", "part of the contact"),
        _gap_panel(state),
        _sizes_panel(areas),
    ]
    names = ["patches of contact", "pressures", "gaps", "sizes of the patches"]
    if np.size(item.force) >= FEWEST_LOADS:
        for name in ("area", "peak_pressure"):
            of, error = row_of(item, name), row_of(item, f"{name}_error").content
            band = Bounds(np.maximum(of.content - error, 0.0), of.content + error, "change of the grid", style.BLUE)
            panels.append(curves_panel(row_of(item, "force"), [(of, "")], [band]))
            names.append(f"{name.replace('_', ' ')} over force")
    share = 100.0 * float(state.area) / rough.area
    title = f"{with_unit(state.force, 'N')}: {areas.size} patches, {share:.3g} % of the map touches"
    return Sheet(titled(tuple(panels), *names), 2 if len(panels) == 4 else 3, width=4.0, height=3.3, title=title)


def _arrows(along: Array, across: Array, pixel: tuple[float, float]) -> tuple[Vectors, ...]:
    """Return arrows of the flow, means over blocks; none where nothing flows."""
    step = max(1, max(along.shape) // ARROWS_ACROSS)
    nx, ny = (n // step for n in along.shape)
    if min(nx, ny) < 1:
        return ()
    u, v = (
        part[: nx * step, : ny * step].reshape(nx, step, ny, step).mean(axis=(1, 3)) / width
        for part, width in ((along, pixel[1]), (across, pixel[0]))
    )
    size = np.hypot(u, v)
    if not np.any(size > 0.0):
        return ()
    # the root shows weak flows, too
    short = np.sqrt(size / float(np.max(size))) / np.where(size > 0.0, size, 1.0)
    x, y = ((np.arange(n) + 0.5) * step * one for n, one in zip((nx, ny), pixel, strict=True))
    places = np.broadcast_arrays(x[:, None], y[None, :])
    flows = size > 1e-4 * float(np.max(size))
    return (Vectors(places[0][flows], places[1][flows], (u * short)[flows], (v * short)[flows], style.INK),)


def _film_panels(item: SealSolution, film: FilmPassage) -> tuple[Panel, Panel]:
    """Return the gap with the flow and its narrowest place, and the pressure of the fluid."""
    rough, state = item.problem.contact.topography, item.contact.last
    gap = gap_of(state.pressure, state.separation)
    relief = map_panel(rough, series("separation", np.where(gap > 0.0, gap, np.nan)), style.SHADES, label="gap $h$")
    relief = relief.plus(*_arrows(film.flow.along, film.flow.across, rough.pixel))
    if film.path.gap > 0.0:
        x, y = ((np.array([place + 0.5])) * one for place, one in zip(film.path.place, rough.pixel, strict=True))
        relief = relief.plus(Line(x, y, style.RED, width=0.0, marker="o", size=9.0, hollow=True, order=9.0))
    fluid = series("pressure", item.problem.pressure_drop * film.flow.pressure)
    return relief, map_panel(rough, fluid, style.SHADES, label="pressure of the fluid")


@without_extent(SealSolution)
def seal_sheet(item: SealSolution) -> Sheet:
    """Return the gap with the flow, the fluid's pressure and the gaps of the last load; leak and factors of many."""
    film, state = item.last_passage(), item.contact.last
    panels = [*_film_panels(item, film), _gap_panel(state)]
    names = ["gap and flow; white: contact, ring: narrowest", "pressure of the fluid", "gaps"]
    if np.size(item.force) >= FEWEST_LOADS:
        force = row_of(item, "force")
        columns = {
            "leak rate": (
                ("leak_rate", "along $x$"),
                ("lateral_leak_rate", "along $y$"),
                ("medium_leak_rate", "effective medium"),
            ),
            "flow factor": (("flow_factor", "along $x$"), ("lateral_flow_factor", "along $y$")),
            "critical gap": (("critical_gap", "along $x$"), ("lateral_critical_gap", "along $y$")),
        }  # fmt: skip
        for label, rows in columns.items():
            drawn = [(positive(row_of(item, name)), legend) for name, legend in rows]
            lines = [(one, legend) for one, legend in drawn if np.isfinite(one.content).any()]
            if lines:
                panels.append(curves_panel(force, lines, label=label))
                names.append(f"{label} over force")
    leak = float(np.ravel(np.asarray(item.leak_rate))[-1])
    flows = f"{with_unit(leak, 'm^3/s')} along $x$" if leak > 0.0 else "nothing leaks along $x$"
    return Sheet(
        titled(tuple(panels), *names), 3, width=4.0, height=3.3, title=f"{with_unit(state.force, 'N')}: {flows}"
    )
