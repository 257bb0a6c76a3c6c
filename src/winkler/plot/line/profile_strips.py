"""Sheets of strips side by side: pressures, surfaces and forces of one load; contact length and pressures of many."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.line.contact import distance_panel, over, pressure_axis, pressures_over
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, points, titled
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.line_strips.profile_contact import LineProfileSolution

PLACES, INSIDE = 1201, 65
"""Places along the section and on each strip."""
BESIDE = 0.15
"""What is drawn beside the outermost strips, over their extent."""
CLIPPED = 95.0
"""Percentile of a pressure that is infinite somewhere, above which it is not drawn."""


@without_extent(LineProfileSolution)
def strips_sheet(item: LineProfileSolution) -> Sheet:
    """Return the strips of one load with their pressures and forces; of many loads contact length and pressures."""
    if np.ndim(item.force_per_length) == 0:
        edges, forces = item.edges, item.strip_forces
        if not edges.size:
            edges, forces = np.array([[-0.5, 0.5]]), np.zeros(1)
        panels = (_pressure_panel(item, edges), _surface_panel(item, edges), _force_panel(edges, forces))
        count = int(item.strip_count)
        strips = f"{count} strip{'s' if count != 1 else ''}"
        title = (
            f"{with_unit(float(item.force_per_length), 'N/m')} on {strips} of {with_unit(_length(item), 'm')} in all"
        )
        return Sheet(
            titled(panels, "pressure", "distance of the surfaces", "force per strip"), 3, height=3.1, title=title
        )
    pressures = pressures_over(item, name="mean of the strips")
    panels = (over(item, "contact_length"), pressures, over(item, "strip_count"))
    return Sheet(titled(panels, "contact length", "pressure", "strips"), 3, height=3.1)


def _length(item: LineProfileSolution) -> float:
    return float(np.asarray(item.contact_length))


def _axis(x: np.ndarray) -> PanelAxis:
    return PanelAxis("$x$", scale_of("m", [float(np.max(np.abs(x)))]), low=float(x[0]), high=float(x[-1]))


def _places(item: LineProfileSolution, edges: np.ndarray) -> np.ndarray:
    """Return places along the drawn part of the section, dense towards the edges of the strips."""
    beside = BESIDE * float(edges[-1, 1] - edges[0, 0])
    section = item.problem.section
    start, end = max(section.start, float(edges[0, 0]) - beside), min(section.end, float(edges[-1, 1]) + beside)
    inside = 0.5 - 0.5 * np.cos(np.pi * (np.arange(INSIDE) + 0.5) / INSIDE)
    on_strips = (edges[:, :1] + inside * np.diff(edges, axis=1)).ravel()
    return np.unique(np.concatenate([np.linspace(start, end, PLACES), on_strips, edges.ravel()]))


def _pressure_panel(item: LineProfileSolution, edges: np.ndarray) -> Panel:
    x = _places(item, edges)
    finite, upright = pressure_axis(item.pressure(x), CLIPPED if np.isinf(item.peak_pressure) else 100.0)
    return Panel((Line(x, finite, style.RED),), _axis(x), upright)


def _surface_panel(item: LineProfileSolution, edges: np.ndarray) -> Panel:
    x, section = _places(item, edges), item.problem.section
    known = np.ones(x.shape, dtype=bool)
    if section.pads:
        known = np.any([(x >= start) & (x <= end) for start, end in section.pads], axis=0)
    height = np.full(x.shape, np.nan)
    height[known] = section.height(x[known]) - np.asarray(item.tilt) * x[known]
    height -= np.nanmin(height)
    apart = None
    if item.strip_count:
        apart = np.full(x.shape, np.nan)
        apart[known] = item.separation(x[known])
    return distance_panel(x, height, apart, _axis(x), legend="upper center")


def _force_panel(edges: np.ndarray, forces: np.ndarray) -> Panel:
    middles = edges.mean(axis=1)
    load = series("force_per_length", forces)
    most = float(np.max(forces))
    upright = PanelAxis.of(load, scale_of("N/m", [most or 1.0]), low=0.0, high=1.1 * most if most > 0.0 else None)
    beside = 0.5 * (float(edges[-1, 1] - edges[0, 0]))
    across = np.array([middles[0] - beside, middles[-1] + beside])
    return Panel((points(middles, forces, style.RED),), _axis(across), upright)
