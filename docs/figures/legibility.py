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
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

import numpy as np
from matplotlib import pyplot
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath
from matplotlib.transforms import Bbox

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


SVG = "{http://www.w3.org/2000/svg}"
DOTS_A_POINT = 2.0
ASCENT, DESCENT = 0.73, 0.22
"""Of letters, over their size."""


class Written(NamedTuple):
    """A text: its rectangle [dots], size of its letters [pt], whether its ground covers what is below, or hides it."""

    text: str
    box: Bbox
    size: float
    grounded: bool = True
    opaque: bool = False


class Curve(NamedTuple):
    """A curve: points [dots], whether they are joined, and by a solid line, whether they are marked, and its width."""

    dots: np.ndarray
    joined: bool
    solid: bool
    marked: bool
    width: float
    name: str


class Axis(NamedTuple):
    """An axis: its name and label, the labels of ticks that are seen, decades (zero if linear), and an offset."""

    name: str
    label: str
    numbers: list[str]
    decades: float
    offset: str = ""


class Seen(NamedTuple):
    """A panel as it is seen: frame, axes, curves, rules through it, areas, legends, notes, and whether it has more."""

    box: Bbox
    title: str
    empty: bool
    axes: list[Axis]
    curves: list[Curve]
    rules: list[np.ndarray]
    areas: list[np.ndarray]
    filled: bool
    legends: list[Bbox]
    notes: list[Written]


def faults(item: Any) -> list[str]:
    """Return what is wrong with a figure of matplotlib, or with a drawing in SVG, a line for each fault."""
    whole, texts, panels = _of_figure(item) if isinstance(item, Figure) else _of_drawing(item)
    found = [*_texts(whole, texts)]
    for one in panels:
        found += [*_axes(one), *_shapes(one), *_hidden(one, panels)]
    return found


# ----------------------------------------------------------------------------------------------------- what is wrong


def _texts(whole: Bbox, texts: list[Written]) -> Iterator[str]:
    yield from (f"small: {one.text!r}, {one.size:g} pt" for one in texts if one.size < SMALLEST)
    yield from (f"letters: {one.text!r}" for one in texts if LETTERS.search(one.text))
    for place, one in enumerate(texts):
        away = min(*(one.box.min - whole.min), *(whole.max - one.box.max))
        if away < -EDGE * DOTS_A_POINT:
            yield f"outside: {one.text!r}"
        for other in texts[:place]:
            wide, high = np.minimum(one.box.max, other.box.max) - np.maximum(one.box.min, other.box.min)
            if wide > MET and high > MET:
                yield f"overlap: {one.text!r} and {other.text!r}"


def _axes(one: Seen) -> Iterator[str]:
    """Yield panels without content, and axes from which nobody can read a number."""
    if one.empty:
        yield f"empty: {one.title!r}"
    name = " ".join(repr(axis.label) for axis in one.axes)
    for axis in one.axes:
        if axis.numbers and not axis.label and all(NUMBER.fullmatch(label) for label in axis.numbers):
            yield f"no name: the {axis.name} axis beside {name}"
        if len(axis.numbers) == 1 and axis.label:
            yield f"one number: the {axis.name} axis of {name}"
        if "+" in axis.offset:
            yield f"offset: {axis.offset} on the {axis.name} axis of {name}"
        if axis.name == "y" and axis.decades > DECADES:
            yield f"decades: {axis.decades:.0f} on the {axis.name} axis of {name}"


def _over(one: Seen) -> str:
    return f"over {next((axis.label for axis in one.axes if axis.name == 'x'), '')!r}"


def _shapes(one: Seen) -> Iterator[str]:
    """Yield curves that are cut, polygons, or flat, and areas of a few dots."""
    box, over, heights = one.box, _over(one), []
    for curve in one.curves:
        dots = curve.dots[np.isfinite(curve.dots).all(axis=1)]
        if not curve.joined or len(dots) < 3:
            continue
        inside = (dots >= box.min - 0.5).all(axis=1) & (dots <= box.max + 0.5).all(axis=1)
        window = (dots[:, 0] >= box.x0 - 0.5) & (dots[:, 0] <= box.x1 + 0.5)
        shown = inside[window] if window.any() else inside
        if len(dots) >= 8 and curve.solid and np.mean(shown) < CUT:
            yield f"cut: {np.sum(~shown)} of {len(shown)} points of a curve {over}"
        if len(dots) <= CORNERS and not curve.marked and _turns(dots):
            yield f"polygon: a curve of {len(dots)} points {over}"
        if len(dots) >= 8:
            heights.append(np.clip(dots[:, 1], box.y0, box.y1))
    if heights and not one.filled:
        every = np.concatenate(heights)
        if 1e-6 < np.ptp(every) / box.height < FLAT:
            yield f"flat: curves {over} take {np.ptp(every) / box.height:.2f} of the height"
    for corners in one.areas:
        wide, high = np.ptp(corners, axis=0)
        if 1e-6 < min(wide, high) < DOTS:
            yield f"thin: an area of {wide:.1f} by {high:.1f} dots {over}"


def _turns(dots: np.ndarray) -> bool:
    """Return whether a curve bends as a smooth one does: all turns are moderate and to one side, none is a corner."""
    steps = np.diff(dots, axis=0)
    steps = steps[np.hypot(*steps.T) > 1.0]
    angles = np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0])))
    return bool(angles.size) and bool(np.max(np.abs(angles)) > TURN and np.max(np.abs(angles)) < 1.2)


def _hidden(one: Seen, panels: list[Seen]) -> Iterator[str]:
    """Yield curves and points below a legend, and texts with a curve through them."""
    beside = [other for other in panels if other.box.overlaps(one.box)]
    curves = [(curve, _between(curve.dots, other.box)) for other in beside for curve in other.curves]
    for legend in one.legends:
        box = legend.padded(-2.0)
        inside = one.box.x0 < 0.5 * (box.x0 + box.x1) < one.box.x1
        if inside and (box.x0 < one.box.x0 or box.x1 > one.box.x1):
            yield f"wider than its panel: the legend {_over(one)}"
        for curve, dots in curves:
            if curve.width < 1.0 and not curve.marked:
                continue
            below = _within(dots, box)
            if np.sum(below) > HIDDEN * one.box.width or (below.any() and not curve.joined):
                yield f"below the legend: {curve.name!r} {_over(one)}"
    for text in one.notes:
        if text.grounded:
            for curve, dots in curves if text.opaque else ():
                if curve.solid and np.sum(_within(dots, text.box)) > HIDDEN * one.box.width:
                    yield f"below the text {text.text!r}: {curve.name!r} {_over(one)}"
            continue
        box = text.box.padded(-0.25 * min(text.box.height, text.box.width))
        if any(np.sum(_within(dots, box)) > 4 for dots in [*(dots for _, dots in curves), *one.rules]):
            yield f"struck through: {text.text!r}"


def _between(dots: np.ndarray, box: Bbox) -> np.ndarray:
    """Return points on a curve a dot from each other, as far as its panel shows them."""
    parts = []
    for start, stop in itertools.pairwise(dots):
        if np.isfinite(start).all() and np.isfinite(stop).all():
            count = int(min(np.hypot(*(stop - start)), 5000.0)) + 1
            parts.append(start + np.linspace(0.0, 1.0, count + 1)[:-1, None] * (stop - start))
    every = np.concatenate([*parts, dots[-1:]])
    return every[_within(every, box)]


def _within(dots: np.ndarray, box: Bbox) -> np.ndarray:
    return np.asarray((dots >= box.min).all(axis=1) & (dots <= box.max).all(axis=1))


# ---------------------------------------------------------------------------------------------- figures of matplotlib


def _of_figure(figure: Any) -> tuple[Bbox, list[Written], list[Seen]]:
    """Return the rectangle of a figure, its texts, and its panels."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    unseen = {id(label) for axes in figure.axes for label in _unseen(axes)}
    texts = [
        Written(text.get_text(), text.get_window_extent(renderer), text.get_fontsize())
        for text in figure.findobj(lambda one: type(one).__name__ in ("Text", "Annotation"))
        if text.get_visible() and text.get_text().strip() and id(text) not in unseen
    ]
    return figure.bbox, texts, [_of_axes(axes, renderer) for axes in figure.axes]


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


def _of_axes(axes: Any, renderer: Any) -> Seen:
    unseen = {id(label) for label in _unseen(axes)}
    named = []
    for axis in (axes.xaxis, axes.yaxis) if axes.axison else ():
        labels = [
            label.get_text()
            for tick in axis.get_major_ticks() + axis.get_minor_ticks()
            for label in (tick.label1, tick.label2)
            if label.get_visible() and label.get_text() and id(label) not in unseen
        ]
        low, high = sorted(axis.get_view_interval())
        decades = np.log10(high / low) if axis.get_scale() == "log" else 0.0
        named.append(Axis(axis.axis_name, axis.get_label_text(), labels, decades, axis.get_offset_text().get_text()))
    through = [line for line in axes.lines if line.get_transform() != axes.transData]
    areas = [
        one.get_transform().transform(one.get_paths()[0].vertices)
        for one in axes.collections
        if type(one).__name__ in ("PolyCollection", "FillBetweenPolyCollection") and len(one.get_paths()) == 1
    ]
    legend = axes.get_legend()
    drawn = axes.lines or axes.collections or axes.images or axes.patches or axes.texts
    return Seen(
        axes.bbox,
        axes.get_title(loc="left") or axes.get_title(),
        bool(axes.axison and not drawn),
        named,
        [_curve(axes, one) for one in axes.lines if one not in through and one.get_visible() and len(one.get_xydata())],
        [
            _between(one.get_transform().transform(one.get_xydata()), axes.bbox)
            for one in through
            if len(one.get_xydata()) == 2
        ],
        areas,
        bool(axes.collections or axes.images or axes.patches),
        [legend.get_window_extent(renderer)] if legend else [],
        [
            Written(text.get_text(), text.get_window_extent(renderer), text.get_fontsize(), *_ground(text))
            for text in axes.texts
            if text.get_text().strip()
        ],
    )


def _ground(text: Any) -> tuple[bool, bool]:
    """Return whether the ground of a text covers what is below, and whether it hides it."""
    patch = text.get_bbox_patch()
    alpha = 0.0 if patch is None else patch.get_alpha() or 1.0
    return alpha > 0.5, alpha == 1.0


def _curve(axes: Any, line: Any) -> Curve:
    dots = axes.transData.transform(np.ma.filled(line.get_xydata(), np.nan).astype(float))
    joined, marked = line.get_linestyle() not in ("None", "", " "), line.get_marker() not in ("None", "", " ")
    return Curve(dots, joined, line.get_linestyle() == "-", marked, line.get_linewidth(), line.get_label())


# ------------------------------------------------------------------------------------------------------------ drawings


def _of_drawing(drawing: Any) -> tuple[Bbox, list[Written], list[Seen]]:
    """Return the rectangle of a drawing, its texts, and its panels, as the SVG says; y is upwards."""
    root = ElementTree.fromstring(drawing.text)
    wide, high = (float(part) for part in root.attrib["viewBox"].split()[2:])
    whole = Bbox(DOTS_A_POINT * np.array([[0.0, -high], [wide, 0.0]]))
    places = zip(_with_class(root, "panel"), drawing.panels, strict=True)
    panels = [_of_panel(one, panel, plane) for one, (panel, plane) in places]
    return whole, [_written(text) for text in root.iter(f"{SVG}text")], panels


def _with_class(root: Any, name: str) -> list[Any]:
    return [one for one in root.iter() if name in one.get("class", "").split()]


def _written(text: Any) -> Written:
    """Return a text with the rectangle of its letters in DejaVu Sans."""
    size, font = float(text.attrib["font-size"]), {"family": "DejaVu Sans", "weight": text.get("font-weight", "normal")}
    parts = [(text.text or "", size)]
    for span in text:
        parts += [(span.text or "", float(span.get("font-size", size))), (span.tail or "", size)]
    wide = sum(_advance(part, of_size, FontProperties(**font)) for part, of_size in parts)
    start = {"start": 0.0, "middle": -0.5 * wide, "end": -wide}[text.attrib["text-anchor"]]
    turned = [float(number) for number in re.findall(r"-?[\d.]+", text.get("transform", ""))]
    if turned:
        x, y = turned[:2]
        box = [[x - ASCENT * size, start - y], [x + DESCENT * size, start + wide - y]]
    else:
        x, y = float(text.attrib["x"]), float(text.attrib["y"])
        box = [[x + start, -y - DESCENT * size], [x + start + wide, -y + ASCENT * size]]
    return Written(_letters(text), Bbox(DOTS_A_POINT * np.array(box)), size, "ground" in text.get("class", "").split())


def _letters(text: Any) -> str:
    return "".join(text.itertext())


def _advance(text: str, size: float, font: FontProperties) -> float:
    """Return the width of letters [pt]; spaces at the ends count a third of their size."""
    inner = text.strip()
    spaces = 0.32 * size * (len(text) - len(inner))
    return spaces + (float(TextPath((0, 0), inner, size, prop=font).get_extents().width) if inner else 0.0)


def _dots(path: Any) -> np.ndarray:
    """Return the corners of a path of straight parts [dots], with a gap before each of its further pieces."""
    found: list[list[float]] = []
    for letter, numbers in re.findall(r"([MLHV])([^A-Za-z]*)", path.attrib["d"]):
        if letter in "ML":
            found += [[np.nan, np.nan]] if letter == "M" and found else []
            found.append([float(part) for part in numbers.split()])
        else:
            found.append([float(numbers), found[-1][1]] if letter == "H" else [found[-1][0], float(numbers)])
    return DOTS_A_POINT * np.array(found).reshape(-1, 2) * [1.0, -1.0]


def _of_path(path: Any) -> Curve:
    kinds = path.attrib["class"].split()
    width, marked = float(path.attrib["stroke-width"]), "marked" in kinds or "points" in kinds
    return Curve(_dots(path), "curve" in kinds, not path.get("stroke-dasharray"), marked, width, kinds[0])


def _of_panel(one: Any, panel: Any, plane: Any) -> Seen:
    frame = next(one.iter(f"{SVG}clipPath"))[0].attrib
    left, top, wide, high = (float(frame[name]) for name in ("x", "y", "width", "height"))
    box = Bbox(DOTS_A_POINT * np.array([[left, -top - high], [left + wide, -top]]))
    axes = []
    for name, side in (("x", plane.across), ("y", plane.upright)):
        ticks, title = (
            [_letters(text) for text in _with_class(one, kind) if name in text.attrib["class"].split()]
            for kind in ("tick", "label")
        )
        axes.append(Axis(name, " ".join(title), ticks, abs(np.log10(side.high / side.low)) if side.log else 0.0))
    legends = _with_class(one, "legend")
    samples = {part for legend in legends for part in legend.iter()}
    curves = [_of_path(part) for kind in ("curve", "points") for part in _with_class(one, kind) if part not in samples]
    notes = [_written(text) for text in _with_class(one, "note")]
    content = [part for group in one.iter() if group.get("clip-path") for part in group]
    areas = [_dots(part) for part in _with_class(one, "area") if part.attrib["d"].count("M") == 1]
    return Seen(
        box,
        panel.title,
        not (panel.bare or content or notes),
        [] if panel.bare else axes,
        curves,
        [_between(_dots(part), box) for part in _with_class(one, "rule")],
        areas,
        any(part.get("class", "").split()[:1] not in (["curve"], ["rule"]) for part in content),
        [Bbox.union([_written(text).box for text in legend.iter(f"{SVG}text")]) for legend in legends],
        notes,
    )


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
    """Return the figures of a script, or the drawings of the report of a study."""
    if path.suffix == ".py":
        with figures_made() as made, contextlib.redirect_stdout(sys.stderr):
            os.chdir(path.parent)
            sys.path.insert(0, str(path.parent))
            runpy.run_path(str(path), run_name="__main__")
        return [one for one in made if one.axes]
    from winkler.study.batch.run import run
    from winkler.study.language.reading import read_study
    from winkler.study.report.figures import figures_of

    return [one.drawing for one in figures_of(run(read_study(path))) if one.drawing is not None]


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
