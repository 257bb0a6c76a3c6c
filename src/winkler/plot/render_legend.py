"""The place of a legend in its panel: where it covers no curve, point or text; else the panel gets room above them."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.legend import Legend
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox

from winkler.numerics.types import Array

__all__ = ["clear_of_curves"]

PLACES = (
    "upper right",
    "upper left",
    "lower right",
    "lower left",
    "center right",
    "center left",
    "upper center",
    "lower center",
    "center",
)
ABOVE = ("upper right", "upper left", "upper center")
FREE = 3.0
"""Dots between a legend and a curve."""
MOST_ROOM = 0.45
"""Greatest part of a panel that is left free above its curves for the legend."""
THIN = 1.0
"""Narrower lines, such as those at zero, may run below a legend [pt]."""


def clear_of_curves(axes: Axes, legend: Legend, wanted: str) -> None:
    """Place a legend where it was wanted, or at the first place where it covers nothing, or above the curves."""
    drawn = np.concatenate([np.empty((0, 2)), *(_dots(one) for one in _panels_here(axes))])
    texts = [text.get_window_extent() for text in axes.texts if text.get_text()]
    covered: dict[Any, int] = {}
    for place in dict.fromkeys((wanted, *PLACES)):
        if place == "best" and wanted != "best":
            continue
        box = _box(legend, place)
        covered[place] = int(np.count_nonzero(_within(drawn, box))) + 1000 * sum(box.overlaps(text) for text in texts)
        if covered[place] == 0:
            return
    share = (legend.get_window_extent().height + 4.0 * FREE) / axes.bbox.height
    if share < MOST_ROOM and axes.get_aspect() == "auto":
        for one in _panels_here(axes):
            _leave_room(one, share)
        covered = {place: sum(_box(legend, place).overlaps(text) for text in texts) for place in ABOVE}
    legend.set_loc(min(covered, key=lambda place: covered[place]))


def _box(legend: Legend, place: Any) -> Bbox:
    """Return the frame of a legend [dots] with what is to stay free around it, after placing it."""
    legend.set_loc(place)
    return legend.get_window_extent().padded(FREE)


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
    steps = np.diff(corners, axis=0)
    with np.errstate(invalid="ignore"):
        counts = np.clip(np.nan_to_num(np.hypot(*steps.T) / 2.0), 1.0, 1000.0).astype(int)
    start = np.repeat(np.arange(len(steps)), counts)
    part = (np.arange(len(start)) - np.repeat(np.cumsum(counts) - counts, counts)) / np.repeat(counts, counts)
    return np.concatenate([corners[start] + part[:, None] * steps[start], corners[-1:]])


def _within(dots: Array, box: Bbox) -> Array:
    return np.asarray((dots >= box.min).all(axis=1) & (dots <= box.max).all(axis=1))
