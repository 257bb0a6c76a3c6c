"""The sheet of an attracted height map: pressure and tension, gap, and the loops of force, area and energy."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import loop_panel, path_ends
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled, zero
from winkler.plot.rough.roughness import map_panel
from winkler.plot.series import common_scale, row_of, series, with_unit
from winkler.problems.surface_adhesion.adhesion import SurfaceAdhesionSolution

FEWEST_POINTS = 2
FAINTEST = 0.01
"""Stress over the greatest one below which nothing is drawn."""


@without_extent(SurfaceAdhesionSolution)
def stuck_sheet(item: SurfaceAdhesionSolution) -> Sheet:
    """Return maps where the surfaces pull most, and force, areas and energies over the displacement."""
    rough, state = item.problem.topography, item.tightest
    p = state.pressure
    faint = FAINTEST * float(np.max(np.abs(p), initial=0.0))
    panels: list[Panel] = []
    names: list[str] = []
    for name, part, colours in (
        ("tension", np.where(p < -faint, -p, np.nan), style.TENSIONS),
        ("pressure", np.where(p > faint, p, np.nan), style.SHADES),
    ):
        if np.isfinite(part).any():
            panels.append(map_panel(rough, series("pressure", part), colours, label=name))
            names.append(name)
    panels.append(map_panel(rough, series("separation", state.separation), style.SHADES))
    names.append("distance of the surfaces")
    if item.depth.size >= FEWEST_POINTS:
        depth = row_of(item, "depth")
        panels.append(loop_panel(depth, row_of(item, "force"), float(item.dissipation[-1])))
        panels.append(_pair(item, ("area", "touching"), ("attracted_area", "attracted"), "area"))
        panels.append(_pair(item, ("path_work", "spent"), ("energy", "energy"), "work and energy"))
        names += ["force", "area", "work spent and energy"]
    title = (
        f"greatest pull: {with_unit(state.force, 'N')} at a displacement of {with_unit(state.depth, 'm')};  "
        f"{len(item.jumps)} jumps lose {with_unit(float(item.dissipation[-1]), 'J')}"
    )
    return Sheet(titled(panels, *names), 3, width=4.0, height=3.3, title=title)


def _pair(item: SurfaceAdhesionSolution, first: tuple[str, str], second: tuple[str, str], label: str) -> Panel:
    """Return two quantities of one unit along the path, in its order, each with its name."""
    along = row_of(item, "depth")
    rows = [row_of(item, name) for name, _ in (first, second)]
    marks: list[Any] = [zero()]
    for row, (_, name), colour, dashes in zip(
        rows, (first, second), (style.BLUE, style.RED), style.DASHES[:2], strict=True
    ):
        marks.append(Line(along.content, row.content, colour, dash=dashes, name=name))
    marks += path_ends(along.content, rows[0].content)
    upright = PanelAxis(label, common_scale(*rows), margin=0.12)
    return Panel(tuple(marks), PanelAxis.of(along, margin=0.06), upright, legend="best")
