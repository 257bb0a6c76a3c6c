"""What a reader would find wrong in a figure: empty panels, axes without a name, cut curves, texts that meet.

The manual's build looks at each figure of the gallery, tests at those of reports. To look at more:
``python docs/figures/legibility.py examples/studies/*/*.toml examples/*/*.py`` prints a line for each fault.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import re
import runpy
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import pyplot
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

__all__ = ["faults", "figures_made"]

SMALLEST = 7.0
"""Letters [pt]."""
MET = 1.5
"""Dots by which two texts may meet."""
EDGE = 2.0
"""Points by which a text may reach over the edge: a report lays out by the letters of SVG, which are narrower."""
CUT = 0.5
"""Part of the points of a solid curve that may lie outside of its panel."""
HIDDEN = 0.03
"""Length of a curve below a legend, as a part of the panel's width."""
FLAT = 0.1
"""Least part of a panel's height that its curves take."""
DECADES = 13.0
"""Most of them on an upright axis whose curves are to be read; master curves go over more of time."""
DOTS = 2.5
"""Least height and width of an area that has a name or a colour of its own."""
CORNERS = 5
"""A curve without markers that has at most so many points, and turns at them, is a polygon."""
TURN = 0.12
"""Angle between two parts of a curve [rad]."""
NUMBER = re.compile(r"[\s\d.,−+\-$\\{}^×·mathdeful]*")
"""Labels of ticks that are numbers, with powers of ten."""
LETTERS = re.compile(r"(?<![A-Za-z\\_{])(?:um|uN|uJ|us|uohm|[mk]?ohm|deg|\[1\]|nan|inf)(?![A-Za-z])|\d\.?\d*e[+-]?\d\d")
"""Units without their letters, and numbers as programs print them."""


def faults(figure: Any) -> list[str]:
    """Return what is wrong with a figure, a line for each fault."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    found = [*_texts(figure, renderer)]
    for axes in figure.axes:
        found += [*_panel(axes), *_labels(axes)] if axes.axison else []
        found += [*_shapes(axes), *_hidden(axes, renderer)]
    return found


# ------------------------------------------------------------------------------------------------------------- texts


def _texts(figure: Any, renderer: Any) -> list[str]:
    unseen = {id(label) for axes in figure.axes for label in _unseen(axes)}
    texts = [
        text
        for text in figure.findobj(lambda one: type(one).__name__ in ("Text", "Annotation"))
        if text.get_visible() and text.get_text().strip() and id(text) not in unseen
    ]
    found = [f"small: {one.get_text()!r}, {one.get_fontsize():g} pt" for one in texts if one.get_fontsize() < SMALLEST]
    found += [f"letters: {one.get_text()!r}" for one in texts if LETTERS.search(one.get_text())]
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
        low, high = (low * (1.0 - 1e-9), high * (1.0 + 1e-9)) if axis.get_scale() == "log" else (low, high)
        off = 0.0 if axis.get_scale() == "log" else 1e-9 * (high - low)
        for tick in axis.get_major_ticks() + axis.get_minor_ticks():
            if not axes.axison or not low - off <= tick.get_loc() <= high + off:
                found += [tick.label1, tick.label2]
    return found


# -------------------------------------------------------------------------------------------------------------- axes


def _panel(axes: Any) -> list[str]:
    if not (axes.lines or axes.collections or axes.images or axes.patches or axes.texts):
        return [f"empty: {axes.get_title(loc='left') or axes.get_title()!r}"]
    found = []
    for axis, name in ((axes.xaxis, axes.get_xlabel()), (axes.yaxis, axes.get_ylabel())):
        labels = [tick.label1.get_text() for tick in axis.get_major_ticks() if tick.label1.get_visible()]
        if any(labels) and not name and all(NUMBER.fullmatch(label) for label in labels):
            found.append(f"no name: the {axis.axis_name} axis beside {_name(axes)}")
    return found


def _name(axes: Any) -> str:
    return f"{axes.get_xlabel()!r} {axes.get_ylabel()!r}"


def _labels(axes: Any) -> Iterator[str]:
    """Yield axes that nobody can read a number from: with fewer than two of them, or over too many decades."""
    unseen = {id(label) for label in _unseen(axes)}
    for axis in (axes.xaxis, axes.yaxis):
        labels = [
            label
            for tick in axis.get_major_ticks() + axis.get_minor_ticks()
            for label in (tick.label1, tick.label2)
            if label.get_visible() and label.get_text() and id(label) not in unseen
        ]
        if len(labels) == 1 and axis.get_label_text():
            yield f"one number: the {axis.axis_name} axis of {_name(axes)}"
        if "+" in axis.get_offset_text().get_text():
            yield f"offset: {axis.get_offset_text().get_text()} on the {axis.axis_name} axis of {_name(axes)}"
        low, high = sorted(axis.get_view_interval())
        if axis.axis_name == "y" and axis.get_scale() == "log" and np.log10(high / low) > DECADES:
            yield f"decades: {np.log10(high / low):.0f} on the {axis.axis_name} axis of {_name(axes)}"


# ------------------------------------------------------------------------------------------------------------ curves


def _curves(axes: Any) -> list[tuple[Any, np.ndarray]]:
    """Return each curve of a panel with its points in dots."""
    return [
        (line, axes.transData.transform(np.ma.filled(line.get_xydata(), np.nan).astype(float)))
        for line in axes.lines
        if line.get_visible() and line.get_transform() == axes.transData and len(line.get_xydata())
    ]


def _shapes(axes: Any) -> Iterator[str]:
    """Yield curves that are cut, polygons, or flat, and areas of a few dots."""
    box, over = axes.bbox, f"over {axes.get_xlabel()!r}"
    heights = []
    for line, dots in _curves(axes):
        joined = line.get_linestyle() not in ("None", "", " ")
        dots = dots[np.isfinite(dots).all(axis=1)]
        if not joined or len(dots) < 3:
            continue
        inside = (dots >= box.min - 0.5).all(axis=1) & (dots <= box.max + 0.5).all(axis=1)
        window = (dots[:, 0] >= box.x0 - 0.5) & (dots[:, 0] <= box.x1 + 0.5)
        shown = inside[window] if window.any() else inside
        if len(dots) >= 8 and line.get_linestyle() == "-" and np.mean(shown) < CUT:
            yield f"cut: {np.sum(~shown)} of {len(shown)} points of a curve {over}"
        if len(dots) <= CORNERS and line.get_marker() in ("None", "", " ") and _turns(dots):
            yield f"polygon: a curve of {len(dots)} points {over}"
        if len(dots) >= 8:
            heights.append(np.clip(dots[:, 1], box.y0, box.y1))
    if heights and not (axes.collections or axes.images or axes.patches):
        every = np.concatenate(heights)
        if 1e-6 < np.ptp(every) / box.height < FLAT:
            yield f"flat: curves {over} take {np.ptp(every) / box.height:.2f} of the height"
    for area in axes.collections:
        if type(area).__name__ in ("PolyCollection", "FillBetweenPolyCollection") and len(area.get_paths()) == 1:
            corners = area.get_transform().transform(area.get_paths()[0].vertices)
            wide, high = np.ptp(corners, axis=0)
            if 1e-6 < min(wide, high) < DOTS:
                yield f"thin: an area of {wide:.1f} by {high:.1f} dots {over}"


def _turns(dots: np.ndarray) -> bool:
    """Return whether a curve bends as a smooth one does: all turns are moderate and to one side, none is a corner."""
    steps = np.diff(dots, axis=0)
    steps = steps[np.hypot(*steps.T) > 1.0]
    angles = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
    return bool(angles.size) and bool(np.max(np.abs(angles)) > TURN and np.max(np.abs(angles)) < 1.2)


def _hidden(axes: Any, renderer: Any) -> Iterator[str]:
    """Yield curves and points below a legend, and texts with a curve through them."""
    beside = [one for one in axes.figure.axes if one.bbox.overlaps(axes.bbox)]
    curves = [(line, _between(dots, one.bbox)) for one in beside for line, dots in _curves(one)]
    rules = [
        (line, _between(line.get_transform().transform(line.get_xydata()), axes.bbox))
        for line in axes.lines
        if len(line.get_xydata()) == 2 and line.get_transform() != axes.transData
    ]
    for legend in [axes.get_legend()] if axes.get_legend() else []:
        box = legend.get_window_extent(renderer).padded(-2.0)
        inside = axes.bbox.x0 < 0.5 * (box.x0 + box.x1) < axes.bbox.x1
        if inside and (box.x0 < axes.bbox.x0 or box.x1 > axes.bbox.x1):
            yield f"wider than its panel: the legend over {axes.get_xlabel()!r}"
        for line, dots in curves:
            if line.get_linewidth() < 1.0 and line.get_marker() in ("None", "", " "):
                continue
            below = _within(dots, box)
            if np.sum(below) > HIDDEN * axes.bbox.width or (below.any() and line.get_linestyle() in ("None", "")):
                yield f"below the legend: {line.get_label()!r} over {axes.get_xlabel()!r}"
    for text in axes.texts:
        patch = text.get_bbox_patch()
        if not text.get_text().strip() or (patch is not None and (patch.get_alpha() or 1.0) > 0.5):
            continue
        box = text.get_window_extent(renderer)
        box = box.padded(-0.25 * min(box.height, box.width))
        for _, dots in curves + rules:
            if np.sum(_within(dots, box)) > 4:
                yield f"struck through: {text.get_text()!r}"
                break


def _between(dots: np.ndarray, box: Any) -> np.ndarray:
    """Return points on a curve a dot from each other, as far as its panel shows them."""
    parts = []
    for start, stop in itertools.pairwise(dots):
        if np.isfinite(start).all() and np.isfinite(stop).all():
            count = int(min(np.hypot(*(stop - start)), 5000.0)) + 1
            parts.append(start + np.linspace(0.0, 1.0, count + 1)[:-1, None] * (stop - start))
    every = np.concatenate([*parts, dots[-1:]])
    return every[_within(every, box)]


def _within(dots: np.ndarray, box: Any) -> np.ndarray:
    return np.asarray((dots >= box.min).all(axis=1) & (dots <= box.max).all(axis=1))


# ------------------------------------------------------------------------------------------------- figures of scripts


@contextlib.contextmanager
def figures_made() -> Iterator[list[Any]]:
    """Keep each figure that is made meanwhile."""
    made: list[Any] = []
    init = Figure.__init__

    def kept(self: Any, *given: Any, **named: Any) -> None:
        init(self, *given, **named)
        made.append(self)

    Figure.__init__ = kept  # type: ignore[method-assign]
    try:
        yield made
    finally:
        Figure.__init__ = init  # type: ignore[method-assign]


def _made_by(path: Path) -> list[Any]:
    """Return the figures of a script, or of the report of a study."""
    with figures_made() as made, tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(sys.stderr):
        if path.suffix == ".py":
            os.chdir(path.parent)
            sys.path.insert(0, str(path.parent))
            runpy.run_path(str(path), run_name="__main__")
        else:
            from winkler.cli import main

            main(["report", str(path), "--output", str(Path(folder, "report.html"))])
    return [one for one in made if one.axes]


def main() -> int:
    """Print the faults of figures of scripts and of reports."""
    count = 0
    for path in [Path(name).resolve() for name in sys.argv[1:]]:
        for place, figure in enumerate(_made_by(path)):
            for fault in faults(figure):
                count += 1
                sys.stdout.write(f"{path.stem} {place}: {fault}\n")
        pyplot.close("all")
    return int(count > 0)


if __name__ == "__main__":
    sys.exit(main())
