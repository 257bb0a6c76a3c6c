"""Sheets of contacts of height maps: contact area, pressure, separation, force, stiffness and resistance."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Bounds, Quantity, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.normal.springs import at_first_touch, springs_panel
from winkler.plot.panel import Bars, Panel, PanelAxis, Sheet, titled
from winkler.plot.rough.roughness import heights_of, image_of, map_panel, share_of_map, sides_of
from winkler.plot.series import Series, row_of, series, with_unit
from winkler.problems.rough.reduce import ReductionSolution
from winkler.problems.rough.surface_conduction import SurfaceConductionSolution
from winkler.problems.rough.surface_contact import SurfaceContactSolution
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.topography import Topography

FEWEST_LOADS = 2
ELEMENTS_NAME, LINES_NAME = "boundary elements", "lines of springs"
"""Loads from which there are curves."""


def _map_panels(item: Topography, state: SurfaceState) -> tuple[Panel, ...]:
    """Return contact area, pressure and separation."""
    touching = series("pressure", np.where(state.pressure > 0.0, 1.0, np.nan))
    contact = dataclasses.replace(image_of(touching, (style.RED,), sides_of(item)), place="")
    relief = map_panel(item, heights_of(item), style.RELIEFS, label="height $z$", lowest=np.inf)
    pressed = series("pressure", np.where(state.pressure > 0.0, state.pressure, np.nan))
    panels = (
        relief.plus(contact),
        map_panel(item, pressed, style.SHADES),
        map_panel(item, series("separation", state.separation), style.SHADES),
    )
    share = 100.0 * float(state.area) / item.area
    return titled(panels, f"contact (red): {share:.3g} % of the map", "pressure", "distance of the surfaces")


def contact_maps(item: SurfaceContactSolution) -> Sheet:
    """Return contact area, pressure and separation under the last load."""
    panels = _map_panels(item.problem.topography, item.last)
    return Sheet(panels, width=4.0, height=3.3, title=_headline(item.last))


def _headline(state: SurfaceState) -> str:
    parts = [f"{with_unit(state.force, 'N')} at a depth of {with_unit(state.depth, 'm')}"]
    if math.isfinite(state.stiffness):
        parts.append(f"stiffness {with_unit(state.stiffness, 'N/m')}")
    parts.append(f"mean distance {with_unit(state.mean_gap, 'm', 3)}")
    return ";  ".join(parts)


@without_extent(SurfaceContactSolution)
def surface_sheet(item: SurfaceContactSolution) -> Sheet:
    """Return the maps of the last load; for many loads also force, stiffness and area."""
    if np.size(item.force) < FEWEST_LOADS:
        return contact_maps(item)
    panels = list(_map_panels(item.problem.topography, item.last))
    for over, what in (("depth", "force"), ("force", "stiffness"), ("force", "area")):
        share = share_of_map(item.area, item.problem.topography)
        along, of = row_of(item, over), share if what == "area" else row_of(item, what)
        finite, panel = np.isfinite(of.content), Panel()
        if finite.any():
            along, of = (dataclasses.replace(one, content=one.content[finite]) for one in (along, of))
            panel = curves_panel(along, [(of, "")])
        panels.append(panel.plus(title=f"{'contact area' if what == 'area' else what} over {over}"))
    title = f"{'greatest' if _rises(item) else 'last'} load: {_headline(item.last)}"
    return Sheet(tuple(panels), 3, width=4.0, height=3.2, title=title)


def _rises(item: SurfaceContactSolution) -> bool:
    return bool(item.last.force >= np.max(item.force))


@without_extent(SurfaceConductionSolution)
def conduction_sheet(item: SurfaceConductionSolution) -> Sheet:
    """Return stiffness, conductance and area over the force, by boundary elements and springs, with bounds."""
    if np.size(item.force) < FEWEST_LOADS:
        return Sheet((_single_panel(item),), width=5.4, height=3.0)
    force, conductance = row_of(item, "force"), row_of(item, "conductance")
    band = item.line.stiffness_band.reshape(2, -1)
    least, most = (np.ravel(np.asarray(part)) for part in (item.least_stiffness, item.greatest_stiffness))
    top = np.where(np.isfinite(most), most, 1e3 * np.max(np.asarray(item.stiffness)[np.isfinite(item.stiffness)]))

    def between(shown: Callable[[Array], Array]) -> list[Bounds]:
        bounds = [Bounds(shown(least), shown(top), "bounds", style.MUTED)] if np.all(least > 0.0) else []
        return [*bounds, Bounds(shown(band[0]), shown(band[1]), "eight lines of ten", style.RED)]

    def conducting(stiffness: Array) -> Array:
        return 1.0 / item.problem.of_stiffness(stiffness, np.ravel(np.asarray(item.film_excess)))

    flowing: list[tuple[Series, str]] = [(conductance, ELEMENTS_NAME)]
    if item.problem.in_proportion:
        by_lines = 1.0 / np.ravel(np.asarray(item.line_resistance, dtype=float))
        flowing.append((series("conductance", by_lines, type(item)), LINES_NAME))
    elif np.all(full := np.ravel(np.asarray(item.least_resistance, dtype=float))):
        flowing.append((series("conductance", 1.0 / full, type(item)), "full contact"))
    stiffness = [(row_of(item, "stiffness"), ELEMENTS_NAME), (row_of(item, "line_stiffness"), LINES_NAME)]
    rough = item.contact.problem.topography
    touched, persson = (share_of_map(part, rough) for part in (item.contact.area, item.line.area))
    panels = (
        curves_panel(force, stiffness, between(lambda stiffness: stiffness)),
        curves_panel(force, flowing, between(conducting) if item.problem.in_proportion else []),
        curves_panel(force, [(touched, ELEMENTS_NAME), (persson, "Persson, same spectrum")]),
    )
    titles = ("stiffness over force", "conductance over force", "contact area over force")
    return Sheet(titled(panels, *titles), width=4.0, height=3.3)


def _single_panel(item: SurfaceConductionSolution) -> Panel:
    """Return the resistance of one load between its bounds."""
    rows = (
        ("least_resistance", "lower bound", style.MUTED),
        ("resistance", ELEMENTS_NAME, style.BLUE),
        ("line_resistance", LINES_NAME, style.RED),
        ("greatest_resistance", "upper bound", style.MUTED),
    )
    numbers = {name: float(np.ravel(getattr(item, name))[0]) for name, _, _ in rows}
    known = [row for row in rows if math.isfinite(numbers[row[0]])]
    labels, colours = tuple(label for _, label, _ in known), tuple(colour for _, _, colour in known)
    of = series("resistance", np.array([numbers[name] for name, _, _ in known]), type(item))
    places = np.arange(float(of.content.size))
    bars = Bars(places, of.content, colours)
    upright = PanelAxis(ticks=places, names=labels, falling=True)
    title = f"resistance under {with_unit(float(np.ravel(np.asarray(item.force))[0]), 'N')}"
    return Panel((bars,), PanelAxis.of(of), upright, title, grid="x")


@without_extent(ReductionSolution)
def reduction_sheet(item: ReductionSolution) -> Sheet:
    """Return the computed contacts on the curve of the springs, their stiffness, and g(x) over the springs."""
    bed = item.bed
    radius = bed.radii[bed.depths >= 0.5 * float(np.min(item.depth))]
    d, k = bed.gap(radius), bed.stiffness(radius)
    curves = {"force": k * d - bed.gap_load(radius), "stiffness": k}
    panels = []
    for name, content in curves.items():
        springs = Quantity(series(name, content), "springs", (item.depth, getattr(item, name)), ELEMENTS_NAME)
        panels.append(curves_panel(series("depth", d), [springs]).plus(title=f"{name} over depth"))
    panels.append(springs_panel(at_first_touch(bed), bed.reach).plus(title="springs under $g(x)$"))
    return Sheet(tuple(panels), width=3.9, height=3.3)
