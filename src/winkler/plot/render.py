"""Panels and sheets drawn by matplotlib."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import FigureBase
from matplotlib.legend import Legend
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox

from winkler.numerics.types import Array
from winkler.plot.panel import Line, Panel, Rule, Sheet
from winkler.plot.picture import Picture, empty_figure, styled
from winkler.plot.render_axis import set_axis, thin_ticks
from winkler.plot.render_marks import draw_mark
from winkler.plot.svg.legend import ABOVE, free_place, room_above
from winkler.plot.svg.letters import Rectangle
from winkler.plot.svg.scales import points_along
from winkler.values.checks.physical_size import as_text
from winkler.values.errors import InvalidInput

Place = Axes | FigureBase | Sequence[Axes]
"""Where a picture is drawn that is a part of another one."""


def render(sheet: Sheet) -> Picture:
    """Return the figure of a sheet."""
    columns, rows = _grid_size(sheet)
    with styled():
        figure = empty_figure(sheet.width * columns, sheet.height * rows)
        for axes, panel in _axes_of_panels(figure, figure.add_gridspec, sheet):
            fill_axes(axes, panel)
        if sheet.title:
            figure.suptitle(sheet.title)
        if sheet.below:
            handles, names = figure.axes[0].get_legend_handles_labels()
            figure.legend(handles, names, loc="outside lower center", ncols=sheet.below)
    return figure


def render_into(sheet: Sheet, place: Place) -> FigureBase:
    """Draw a sheet into a figure, a sub-figure or axes of somebody else, in their style; return the figure drawn into.

    Raises
    ------
    InvalidInput
        If it is none of these, or has not as many axes as the sheet has panels.
    """
    if isinstance(place, FigureBase):
        for axes, panel in _axes_of_panels(place, place.add_gridspec, sheet):
            fill_axes(axes, panel)
        if sheet.title:
            place.suptitle(sheet.title)
        return place
    given = [place] if isinstance(place, Axes) else list(np.ravel(np.asarray(place, dtype=object)))
    if not given or not all(isinstance(axes, Axes) for axes in given):
        raise InvalidInput(
            f"draw: ax is {as_text(place)}; give axes of matplotlib, a list of them, a figure or a sub-figure."
        )
    panels = _panels(sheet)
    if len(given) != len(panels):
        raise InvalidInput(
            f"draw: the picture has {len(panels)} panels, and ax {len(given)} axes; give as many, or a sub-figure."
        )
    for axes, panel in zip(given, panels, strict=True):
        fill_axes(axes, panel)
    return given[0].figure


def _panels(sheet: Sheet) -> list[Panel]:
    """Return the panels of a sheet, and of the sheets inside it, in the order in which they are drawn."""
    found: list[Panel] = []
    for panel in sheet.panels:
        found += _panels(panel) if isinstance(panel, Sheet) else [] if panel is None else [panel]
    return found


def _grid_size(sheet: Sheet) -> tuple[int, int]:
    columns = sheet.columns or len(sheet.panels)
    return columns, -(-len(sheet.panels) // columns)


def _axes_of_panels(figure: FigureBase, make_grid: Callable[..., Any], sheet: Sheet) -> list[tuple[Axes, Panel]]:
    """Return empty axes on a grid for the panels of a sheet, and of the sheets inside it."""
    columns, rows = _grid_size(sheet)
    grid = make_grid(rows, columns, width_ratios=sheet.widths or None, height_ratios=sheet.heights or None)
    placed: list[tuple[Axes, Panel]] = []
    for number, panel in enumerate(sheet.panels):
        cell = grid[number // columns, number % columns]
        if isinstance(panel, Sheet):
            placed += _axes_of_panels(figure, cell.subgridspec, panel)
        elif panel is not None:
            share = {f"share{sheet.shared}": placed[0][0]} if sheet.shared and placed else {}
            placed.append((figure.add_subplot(cell, **share), panel))
            if sheet.shared == "y" and number % columns:
                placed[-1][0].tick_params(labelleft=False)
    if sheet.shared == "x":
        for axes, _ in placed[:-1]:
            axes.tick_params(labelbottom=False)
        figure.align_ylabels([axes for axes, _ in placed])
    return placed


def fill_axes(axes: Axes, panel: Panel) -> None:
    """Draw a panel into empty axes."""
    beside = axes.twinx() if panel.beside else axes
    sloped = [mark for mark in panel.marks if isinstance(mark, Rule) and mark.point is not None]
    for mark in panel.marks:
        if isinstance(mark, Line) and mark.beside:
            draw_mark(beside, mark, panel.across.scale.factor, panel.beside[0].scale.factor)
        elif mark not in sloped:
            draw_mark(axes, mark, panel.across.scale.factor, panel.upright.scale.factor)
    margins: Any = {"x": panel.across.margin, "y": panel.upright.margin}
    axes.margins(**{direction: margin for direction, margin in margins.items() if margin is not None})
    for mark in sloped:  # crosses the whole panel and keeps its limits
        draw_mark(axes, mark, panel.across.scale.factor, panel.upright.scale.factor)
    if panel.equal:
        axes.set_aspect("equal")
    set_axis(axes, "x", panel.across)
    set_axis(axes, "y", panel.upright)
    if panel.equal:
        thin_ticks(axes, panel.across)
    if panel.beside:
        set_axis(beside, "y", panel.beside[0])
        beside.spines["right"].set_visible(True)
        beside.grid(visible=False)
    if panel.grid != "both":
        axes.grid(visible=False, axis="y" if panel.grid == "x" else "both")
    if panel.boxed:
        for side in ("top", "right"):
            axes.spines[side].set_visible(True)
    if panel.bare:
        axes.set_axis_off()
    if panel.title:
        axes.set_title(panel.title)
    if panel.legend and axes.get_legend_handles_labels()[1]:
        _legend(axes, panel)


def _legend(axes: Axes, panel: Panel) -> None:
    options: dict[str, Any] = {"loc": panel.legend, "ncols": panel.columns, "markerscale": panel.marker_scale}
    options |= {"title": panel.legend_title, "title_fontsize": 8.5} if panel.legend_title else {}
    options |= {"columnspacing": 1.2} if panel.spaced else {}
    options |= {"bbox_to_anchor": (1.0, 1.0)} if panel.outside else {}
    legend = axes.legend(**options)
    if not panel.unframed:
        legend.set_frame_on(True)
        legend.get_frame().set(facecolor="white", edgecolor="none", alpha=0.85)
    if not panel.outside:
        clear_of_curves(axes, legend, panel.legend)


THIN = 1.0
"""Narrower lines, such as those at zero, may run below a legend [pt]."""


def clear_of_curves(axes: Axes, legend: Legend, wanted: str) -> None:
    """Place a legend where it was wanted, or at the first place where it covers nothing, or above the curves."""
    drawn = np.concatenate([np.empty((0, 2)), *(_dots(one) for one in _panels_here(axes))])
    texts = [Rectangle(*text.get_window_extent().extents) for text in axes.texts if text.get_text()]

    def box_at(place: str) -> Rectangle:
        legend.set_loc(place)  # type: ignore[arg-type]
        return Rectangle(*legend.get_window_extent().extents)

    place, free = free_place(wanted, box_at, drawn, texts)
    share = room_above(legend.get_window_extent().height, axes.bbox.height)
    if not free and share and axes.get_aspect() == "auto":
        for one in _panels_here(axes):
            _leave_room(one, share)
        place = min(ABOVE, key=lambda one: sum(map(box_at(one).meets, texts)))
    legend.set_loc(place)  # type: ignore[arg-type]


def _panels_here(axes: Axes) -> list[Any]:
    """Return the axes and those that are drawn over them, with another scale at the right."""
    beside: Any = axes.get_shared_x_axes().get_siblings(axes)
    return [one for one in beside if np.allclose(one.bbox.extents, axes.bbox.extents)]


def _leave_room(axes: Any, share: float) -> None:
    """Raise the upper end of an axis until what is drawn leaves a part of its height free."""
    scale = axes.yaxis.get_transform()
    low, high = scale.transform(np.array(axes.get_ylim()))
    axes.set_ylim(top=float(scale.inverted().transform(np.array([low + (high - low) / (1.0 - share)]))[0]))


def _dots(axes: Any) -> Array:
    """Return places [dots] that the curves and points of a panel cover, two dots from each other."""
    found = [np.empty((0, 2))]
    axes.get_xlim(), axes.get_ylim()  # limits that follow the curves are found when they are asked for
    for line in axes.lines:
        if line.get_transform() == axes.transData and line.get_visible():
            found.append(_along(axes.transData.transform(line.get_xydata()), line))
    for cloud in axes.collections:
        if np.size(cloud.get_offsets()) > 2 or type(cloud).__name__ == "PathCollection":
            found.append(axes.transData.transform(np.ma.filled(cloud.get_offsets(), np.nan)))
    every = np.concatenate(found)
    return np.asarray(every[_within(every, axes.bbox)])


def _along(corners: Array, line: Line2D) -> Array:
    """Return the points of a curve, and those between them where it is drawn through."""
    marked = line.get_marker() not in ("None", "", " ", None)
    if line.get_linestyle() in ("None", "", " ") or len(corners) < 2:
        return corners
    if line.get_linewidth() < THIN and not marked:
        return corners[:0]
    return points_along(corners)


def _within(dots: Array, box: Bbox) -> Array:
    return np.asarray((dots >= box.min).all(axis=1) & (dots <= box.max).all(axis=1))
