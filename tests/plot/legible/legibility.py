"""What a reader would find wrong in a figure: empty panels, axes without a name, cut curves, texts that meet."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg

SMALLEST = 7.0
"""Letters [pt]."""
MET = 1.5
"""Dots by which two texts may meet."""
EDGE = 2.0
"""Points by which a text may reach over the edge: a report lays out by the letters of SVG, which are narrower."""
CUT = 0.5
"""Part of the points of a solid curve that may lie outside of its panel."""
NUMBER = re.compile(r"[\s\d.,−+\-$\\{}^×·mathdeful]*")
"""Labels of ticks that are numbers, with powers of ten."""


def faults(figure: Any) -> list[str]:
    """Return what is wrong with a figure, a line for each fault."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    found = [*_texts(figure, renderer)]
    for axes in figure.axes:
        found += _panel(axes) if axes.axison else []
    return found


def _texts(figure: Any, renderer: Any) -> list[str]:
    hidden = {id(label) for axes in figure.axes for label in _unseen(axes)}
    texts = [
        text
        for text in figure.findobj(lambda one: type(one).__name__ in ("Text", "Annotation"))
        if text.get_visible() and text.get_text().strip() and id(text) not in hidden
    ]
    found = [f"small: {one.get_text()!r}, {one.get_fontsize():g} pt" for one in texts if one.get_fontsize() < SMALLEST]
    boxes = [(one.get_text(), one.get_window_extent(renderer)) for one in texts]
    edge = EDGE * figure.dpi / 72.0
    for place, (text, box) in enumerate(boxes):
        if min(box.x0, box.y0, figure.bbox.width - box.x1, figure.bbox.height - box.y1) < -edge:
            found.append(f"outside: {text!r}")
        for other, more in boxes[:place]:
            wide, high = min(box.x1, more.x1) - max(box.x0, more.x0), min(box.y1, more.y1) - max(box.y0, more.y0)
            if wide > MET and high > MET:
                found.append(f"overlap: {text!r} and {other!r}")
    return found


def _unseen(axes: Any) -> list[Any]:
    """Return labels of ticks outside of a panel, and all those of one without axes."""
    found = []
    for axis in (axes.xaxis, axes.yaxis):
        low, high = sorted(axis.get_view_interval())
        off = 1e-9 * (high - low)
        for tick in axis.get_major_ticks() + axis.get_minor_ticks():
            if not axes.axison or not low - off <= tick.get_loc() <= high + off:
                found += [tick.label1, tick.label2]
    return found


def _panel(axes: Any) -> list[str]:
    if not (axes.lines or axes.collections or axes.images or axes.patches):
        return [f"empty: {axes.get_title(loc='left') or axes.get_title()!r}"]
    found = []
    for axis, name in ((axes.xaxis, axes.get_xlabel()), (axes.yaxis, axes.get_ylabel())):
        labels = [tick.label1.get_text() for tick in axis.get_major_ticks() if tick.label1.get_visible()]
        if any(labels) and not name and all(NUMBER.fullmatch(label) for label in labels):
            found.append(f"no name: the {axis.axis_name} axis beside {axes.get_xlabel()!r} {axes.get_ylabel()!r}")
    (left, right), (low, high) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    for line in axes.lines:
        points = np.asarray(line.get_xydata(), dtype=float)
        points = points[np.isfinite(points).all(axis=1)]
        if len(points) < 8 or line.get_linestyle() != "-" or line.get_transform() != axes.transData:
            continue
        x, y = points.T
        inside = (x >= left) & (x <= right) & (y >= low) & (y <= high)
        if np.mean(inside) < CUT:
            found.append(f"cut: {np.sum(~inside)} of {len(points)} points of a curve over {axes.get_xlabel()!r}")
    return found
