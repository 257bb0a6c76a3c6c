"""A sheet of panels as one picture in SVG: the panels in their places, with axes, ticks, legends and colour bars."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.plot import marks, style
from winkler.plot.axis import PanelAxis
from winkler.plot.panel import Panel, Sheet
from winkler.plot.svg.legend import ABOVE, Legend, free_place, legend_of, named, room_above
from winkler.plot.svg.letters import FONT, LINE_HEIGHT, Rectangle, text_element, width_of
from winkler.plot.svg.pixels import band_colour, colours_of, levels_of
from winkler.plot.svg.scales import Side, Ticks, broken, narrow_parts, round_steps, side_of, ticks_of
from winkler.plot.svg.shapes import HATCH, DrawnShape, Plane, bars_of, reach_of, shapes_of, stroke

POINTS = 72.0
"""Points in an inch."""
TICK_SIZE, LABEL_SIZE, TITLE_SIZE, SHEET_TITLE_SIZE = 8.5, 9.0, 9.5, 10.5
TICK, BESIDE_TICK, BESIDE_NUMBERS, ABOVE_FRAME = 3.5, 3.0, 4.0, 6.0
"""Length of a tick, and distances: of its number, of a label from the numbers, of a title from the frame [pt]."""
EDGE, BETWEEN = 4.3, 6.0
"""Around all panels, and between two [pt]."""
BAR, BAR_AWAY = 9.0, 9.0
"""Width of a colour bar, and its distance from the frame [pt]."""
MOST_BAR_LABELS = 8
LEAST_SIZE = 20.0
"""Least width and height of a panel [pt]."""
STEPS_OF_A_BAR = 64
ROUNDS = 3
"""Of the layout: the ticks follow from the size of a panel, and its size from the numbers at the ticks."""


class Drawing(NamedTuple):
    """A drawn sheet: the picture as text, its size [pt], and its panels with their axes in their places."""

    text: str
    width: float
    height: float
    panels: tuple[tuple[Panel, Plane], ...]


class Margins(NamedTuple):
    """What numbers, labels, titles, legends and bars take around the frame of a panel [pt]."""

    left: float = 0.0
    top: float = 0.0
    right: float = 0.0
    bottom: float = 0.0


class _Axes:
    """A panel that gets its place: ends of the axes, what numbers are written at it, and its rectangle."""

    def __init__(self, panel: Panel) -> None:
        self.panel = panel
        self.numbered = [not panel.bare, not panel.bare]
        reaches = [(mark, reach_of(mark)) for mark in panel.marks]
        own = [reach for mark, reach in reaches if not getattr(mark, "beside", False)]
        tight = any(reach.tight for reach in own)
        fixed_x = [end for reach in own for end in reach.fixed_x]
        fixed_y = [end for reach in own for end in reach.fixed_y]
        self.across = side_of(panel.across, [one.x for _, one in reaches], fixed_x, tight=tight, across=True)
        self.upright = side_of(panel.upright, [one.y for one in own], fixed_y, tight=tight, across=False)
        others = [reach.y for mark, reach in reaches if getattr(mark, "beside", False)]
        self.beside = side_of(panel.beside[0], others, [], tight=False, across=False) if panel.beside else None
        self.frame = Rectangle(0.0, 0.0, 200.0, 150.0)
        self.legend = _legend(panel)
        self.bars = bars_of(panel.marks)

    def put(self, frame: Rectangle) -> None:
        """Give the panel a rectangle; equal scales make it smaller, about its middle."""
        if self.panel.equal:
            sides = zip((self.across, self.upright), self.plane.factors, strict=True)
            wide, high = (abs(side.high - side.low) * factor for side, factor in sides)
            scale = min((frame.right - frame.left) / wide, (frame.bottom - frame.top) / high)
            half = 0.5 * scale * wide, 0.5 * scale * high
            middle = 0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom)
            frame = Rectangle(middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1])
        self.frame = frame
        self.across = self.across._replace(start=frame.left, stop=frame.right)
        self.upright = self.upright._replace(start=frame.bottom, stop=frame.top)
        if self.beside is not None:
            self.beside = self.beside._replace(start=frame.bottom, stop=frame.top)

    @property
    def plane(self) -> Plane:
        """The axes in their places."""
        return Plane(self.across, self.upright, (self.panel.across.scale.factor, self.panel.upright.scale.factor))

    @property
    def other(self) -> Plane:
        """The same with the second upright axis."""
        assert self.beside is not None
        return Plane(self.across, self.beside, (self.panel.across.scale.factor, self.panel.beside[0].scale.factor))

    def ticks(self) -> tuple[Ticks, Ticks]:
        """Return the ticks across and upright that lie inside of the frame."""
        parts = narrow_parts(self.panel.across, self.across[:2], self.upright[:2]) if self.panel.equal else 0
        return (
            _inside(ticks_of(self.panel.across, self.across, TICK_SIZE, across=True, parts=parts), self.across),
            _inside(ticks_of(self.panel.upright, self.upright, TICK_SIZE, across=False), self.upright),
        )

    def shapes(self) -> list[DrawnShape]:
        """Return what is drawn of the marks."""
        return [
            shape
            for mark in self.panel.marks
            for shape in shapes_of(mark, self.other if getattr(mark, "beside", False) else self.plane)
        ]

    def make_room(self) -> tuple[list[DrawnShape], DrawnShape | None]:
        """Return the marks and the legend, above which the upright axis reaches where no place is free."""
        drawn = self.shapes()
        if self.legend is None:
            return drawn, None
        legend, panel = self.legend, self.panel
        place = "upper right" if panel.legend == "best" else panel.legend
        if not panel.outside:
            covers = np.concatenate([np.empty((0, 2)), *(shape.covers for shape in drawn)])
            covers = covers[((covers >= self.frame[:2]) & (covers <= self.frame[2:])).all(axis=1)]
            texts = [shape.letters for shape in drawn if shape.letters is not None]
            place, free = free_place(place, lambda one: legend.at(one, self.frame), covers, texts)
            share = room_above(legend.height, self.upright.length)
            if not free and share and not panel.equal:
                self.upright = self.upright.raised(share)
                self.beside = None if self.beside is None else self.beside.raised(share)
                drawn = self.shapes()
                texts = [shape.letters for shape in drawn if shape.letters is not None]
                place = min(ABOVE, key=lambda one: sum(map(legend.at(one, self.frame).meets, texts)))
        return drawn, DrawnShape(5.0, legend.drawn(legend.at(place, self.frame, outside=panel.outside)), False)

    def margins(self) -> Margins:
        """Return what is drawn around the frame at its present size."""
        panel = self.panel
        left = top = right = bottom = 0.0
        if not panel.bare:
            across, upright = self.ticks()
            beyond = TICK + BESIDE_TICK
            if self.numbered[0] and across.labels:
                bottom += beyond + max(_height(label) for label in across.labels)
                ends = self.across.place(across.places)
                halves = [0.5 * width_of(label, TICK_SIZE) for label in across.labels]
                left = max(left, *(half - (end - self.frame.left) for half, end in zip(halves, ends, strict=True)))
                right = max(right, *(half - (self.frame.right - end) for half, end in zip(halves, ends, strict=True)))
            if self.numbered[1] and upright.labels:
                left = max(left, beyond + max(width_of(label, TICK_SIZE) for label in upright.labels))
                top, bottom = max(top, 0.5 * TICK_SIZE), max(bottom, 0.5 * TICK_SIZE)
            if upright.power:
                top += TICK_SIZE * LINE_HEIGHT
            if panel.across.title:
                bottom += BESIDE_NUMBERS + LABEL_SIZE * LINE_HEIGHT * _lines(panel.across.title)
            elif across.power:
                bottom += TICK_SIZE * LINE_HEIGHT
            if panel.upright.title:
                left += BESIDE_NUMBERS + LABEL_SIZE * LINE_HEIGHT * _lines(broken(panel.upright.title))
            if self.beside is not None:
                right = max(right, _side_width(panel.beside[0], self.beside))
        if panel.title:
            top += ABOVE_FRAME + TITLE_SIZE * LINE_HEIGHT * _lines(panel.title)
        for mark in self.bars:
            right = max(right, BAR_AWAY + BAR + _bar_width(mark, self.frame))
        if self.legend is not None and panel.outside:
            right = max(right, 5.0 + self.legend.width)
        return Margins(left, top, right, bottom)

    def drawn(self, number: int) -> str:
        """Return the elements of the panel; `number` tells its clip path from those of others."""
        drawn, legend = self.make_room()
        panel, frame = self.panel, self.frame
        layers = [*drawn, *([legend] if legend else []), *([] if panel.bare else self._frame())]
        text, inside = "", False
        for shape in sorted(layers, key=lambda one: one.order):
            if shape.clipped != inside:
                text += f'<g clip-path="url(#frame{number})">' if shape.clipped else "</g>"
                inside = shape.clipped
            text += shape.text
        text += "</g>" if inside else ""
        clip = f'<clipPath id="frame{number}">{frame.drawn("")}</clipPath>'
        text += "" if panel.bare else self._labels()
        if panel.title:
            power = TICK_SIZE * LINE_HEIGHT if not panel.bare and self.ticks()[1].power else 0.0
            look: dict[str, Any] = {"across": "left", "upright": "bottom", "bold": True, "kind": "title"}
            text += text_element(panel.title, frame.left, frame.top - ABOVE_FRAME - power, TITLE_SIZE, **look)
        text += "".join(_bar(mark, frame) for mark in self.bars)
        return f'<g class="panel">{clip}{text}</g>'

    def _frame(self) -> Iterator[DrawnShape]:
        """Yield the grid, and the frame with its ticks."""
        frame = self.frame
        across, upright = self.ticks()
        at_x, at_y = self.across.place(across.places).tolist(), self.upright.place(upright.places).tolist()
        grid = "".join(f"M{x:.1f} {frame.top:.1f}V{frame.bottom:.1f}" for x in at_x) if self.panel.grid else ""
        grid += (
            "".join(f"M{frame.left:.1f} {y:.1f}H{frame.right:.1f}" for y in at_y) if self.panel.grid == "both" else ""
        )
        if grid:
            yield DrawnShape(0.5, f'<path class="grid" d="{grid}" {stroke(style.PALE, 0.6, blunt=True)}/>', False)
        box = f"M{frame.left:.1f} {frame.top:.1f}V{frame.bottom:.1f}H{frame.right:.1f}"
        box += f"V{frame.top:.1f}" if self.panel.boxed or self.beside is not None else ""
        box += f"H{frame.left:.1f}" if self.panel.boxed else ""
        box += "".join(f"M{x:.1f} {frame.bottom:.1f}v{TICK}" for x in at_x)
        box += "".join(f"M{frame.left:.1f} {y:.1f}h-{TICK}" for y in at_y)
        box += "".join(f"M{x:.1f} {frame.bottom:.1f}v2" for x in self.across.place(across.minor).tolist())
        box += "".join(f"M{frame.left:.1f} {y:.1f}h-2" for y in self.upright.place(upright.minor).tolist())
        if self.beside is not None:
            ticks = _inside(ticks_of(self.panel.beside[0], self.beside, TICK_SIZE, across=False), self.beside)
            box += "".join(f"M{frame.right:.1f} {y:.1f}h{TICK}" for y in self.beside.place(ticks.places).tolist())
        yield DrawnShape(2.5, f'<path class="frame" d="{box}" {stroke(style.MUTED, 0.8, blunt=True)}/>', False)

    def _labels(self) -> str:
        """Return the numbers at the ticks, and the labels of the axes."""
        frame, panel = self.frame, self.panel
        across, upright = self.ticks()
        text, beyond = "", TICK + BESIDE_TICK
        below, beside = frame.bottom + beyond, frame.left - beyond
        if self.numbered[0]:
            for at, label in zip(self.across.place(across.places).tolist(), across.labels, strict=True):
                text += text_element(label, at, below, TICK_SIZE, upright="top", kind="tick x")
            below += max((_height(label) for label in across.labels), default=0.0)
            text += _power(across.power, frame.right, below + BESIDE_NUMBERS, "right", "top")
        if self.numbered[1]:
            for at, label in zip(self.upright.place(upright.places).tolist(), upright.labels, strict=True):
                text += text_element(label, beside, at, TICK_SIZE, across="right", kind="tick y")
            beside -= max((width_of(label, TICK_SIZE) for label in upright.labels), default=0.0)
            text += _power(upright.power, frame.left, frame.top - 3.0, "left", "bottom")
        if panel.across.title:
            middle = 0.5 * (frame.left + frame.right)
            look: dict[str, Any] = {"upright": "top", "colour": _own(panel.across), "kind": "label x"}
            text += text_element(panel.across.title, middle, below + BESIDE_NUMBERS, LABEL_SIZE, **look)
        if panel.upright.title:
            middle = 0.5 * (frame.top + frame.bottom)
            look = {"across": "right", "turned": True, "colour": _own(panel.upright), "kind": "label y"}
            text += text_element(broken(panel.upright.title), beside - BESIDE_NUMBERS, middle, LABEL_SIZE, **look)
        if self.beside is not None:
            text += _numbers_right(panel.beside[0], self.beside, frame.right)
        return text


def _own(axis: PanelAxis) -> str:
    return "" if axis.colour == style.INK else axis.colour


def _lines(text: str) -> int:
    return text.count("\n") + 1


def _height(label: str) -> float:
    return TICK_SIZE * (1.0 + LINE_HEIGHT * (_lines(label) - 1))


def _power(power: int, x: float, y: float, across: str, upright: str) -> str:
    look: dict[str, Any] = {"across": across, "upright": upright, "kind": "power"}
    return text_element(f"·$10^{{{power}}}$", x, y, TICK_SIZE, **look) if power else ""


def _inside(ticks: Ticks, side: Side) -> Ticks:
    """Return the ticks that lie between the ends of an axis."""
    places = side.place(ticks.places)
    low, high = sorted((side.start, side.stop))
    known = (places >= low - 0.01) & (places <= high + 0.01)
    labels = tuple(label for label, here in zip(ticks.labels, known.tolist(), strict=True) if here)
    return ticks._replace(places=ticks.places[known], labels=labels)


def _legend(panel: Panel) -> Legend | None:
    entries = [mark for mark in named(panel.marks) if not getattr(mark, "beside", False)]
    if not (panel.legend and entries):
        return None
    look: dict[str, Any] = {"near": panel.spaced, "framed": not panel.unframed, "marker_scale": panel.marker_scale}
    return legend_of(entries, panel.columns, title=panel.legend_title, **look)


# -------------------------------------------------------------------------------------------------- at the right side


def _side_width(axis: PanelAxis, side: Side) -> float:
    """Return what an axis at the right takes beside the line on which its ticks stand [pt]."""
    ticks = _inside(ticks_of(axis, side, TICK_SIZE, across=False), side)
    wide = TICK + BESIDE_TICK + max((width_of(label, TICK_SIZE) for label in ticks.labels), default=0.0)
    return wide + (BESIDE_NUMBERS + LABEL_SIZE * LINE_HEIGHT * _lines(broken(axis.title)) if axis.title else 0.0)


def _numbers_right(axis: PanelAxis, side: Side, left: float) -> str:
    """Return the numbers and the label of an axis at the right."""
    ticks = _inside(ticks_of(axis, side, TICK_SIZE, across=False), side)
    text, beside = "", left + TICK + BESIDE_TICK
    for at, label in zip(side.place(ticks.places).tolist(), ticks.labels, strict=True):
        text += text_element(label, beside, at, TICK_SIZE, across="left", kind="tick side")
    beside += max((width_of(label, TICK_SIZE) for label in ticks.labels), default=0.0)
    text += _power(ticks.power, left, min(side.start, side.stop) - 3.0, "left", "bottom")
    if axis.title:
        title = broken(axis.title)
        look: dict[str, Any] = {"across": "left", "turned": True, "colour": _own(axis), "kind": "label side"}
        text += text_element(title, beside + BESIDE_NUMBERS, 0.5 * (side.start + side.stop), LABEL_SIZE, **look)
    return text


def _bar_axis(mark: marks.Map, frame: Rectangle) -> tuple[PanelAxis, Side]:
    """Return the axis of a colour bar, with the levels of contours as its ticks."""
    colours = colours_of(mark)
    shrink = 1.0 if mark.place == "inset" else mark.shrink
    half = 0.5 * shrink * (frame.bottom - frame.top)
    middle = 0.5 * (frame.top + frame.bottom)
    side = Side(colours.low, colours.high, colours.log, middle + half, middle - half)
    factor = mark.bar.scale.factor
    if side.low == side.high:
        side = side._replace(high=side.low + (abs(side.low) or 1.0))
    if mark.kind == "contours":
        levels = levels_of(mark)
        wanted = levels[:: max(1, -(-levels.size // MOST_BAR_LABELS))]
    elif colours.log:
        return PanelAxis(mark.bar.label, mark.bar.scale, log=True, plain=mark.bar.plain), side
    else:
        wanted = round_steps(min(side[:2]), max(side[:2]), MOST_BAR_LABELS)
    return PanelAxis(mark.bar.label, mark.bar.scale, ticks=wanted * factor), side


def _bar_width(mark: marks.Map, frame: Rectangle) -> float:
    return _side_width(*_bar_axis(mark, frame))


def _bar(mark: marks.Map, frame: Rectangle) -> str:
    """Return the colour bar of a map at the right of its frame."""
    axis, side = _bar_axis(mark, frame)
    colours = colours_of(mark)
    left = frame.right + BAR_AWAY
    bands = mark.kind == "contours"
    steps = levels_of(mark) if bands else np.linspace(0.0, 1.0, STEPS_OF_A_BAR + 1)
    span = side.stop - side.start
    places = (side.place(steps) if bands else side.start + span * steps).tolist()
    text = ""
    for number, (low, high) in enumerate(itertools.pairwise(places)):
        if bands:
            colour = band_colour(mark, number + (mark.extend in ("min", "both")), steps[number], steps[number + 1])
        else:
            colour = colours.text(float(side.at(0.5 * (low + high))))
        over = 0.3 if number + 2 < len(places) else 0.0  # no light between two steps
        text += Rectangle(left, high - over, left + BAR, low).drawn(f'fill="{colour}"')
    for end, sign, edge, beyond in (("max", -1.0, places[-1], side.high), ("min", 1.0, places[0], side.low)):
        if mark.extend in (end, "both"):
            tip = f"M{left:.1f} {edge:.2f}l{0.5 * BAR:g} {sign * BAR:g} {0.5 * BAR:g} {-sign * BAR:g}z"
            text += f'<path d="{tip}" fill="{colours.text(beyond)}"/>'
    ticks = _inside(ticks_of(axis, side, TICK_SIZE, across=False), side)
    marks_at = "".join(f"M{left + BAR:.1f} {y:.1f}h{TICK}" for y in side.place(ticks.places).tolist())
    text += f'<path class="frame" d="{marks_at}" {stroke(style.MUTED, 0.8, blunt=True)}/>'
    return f'<g class="bar">{text}{_numbers_right(axis, side, left + BAR)}</g>'


# ------------------------------------------------------------------------------------------------------------- sheets


class _Cell(NamedTuple):
    """One cell of a sheet: a panel, or a sheet of its own."""

    row: int
    column: int
    item: _Axes | _PanelGrid


class _PanelGrid:
    """The panels of a sheet in rows and columns."""

    def __init__(self, sheet: Sheet) -> None:
        self.sheet = sheet
        self.columns = sheet.columns or len(sheet.panels)
        self.rows = -(-len(sheet.panels) // self.columns)
        self.cells = [
            _Cell(*divmod(place, self.columns), _PanelGrid(panel) if isinstance(panel, Sheet) else _Axes(panel))
            for place, panel in enumerate(sheet.panels)
            if panel is not None
        ]
        self._share()

    def _share(self) -> None:
        """Give panels that share an axis common ends, and numbers at the outer ones alone."""
        own = [cell for cell in self.cells if isinstance(cell.item, _Axes)]
        if not (self.sheet.shared and own):
            return
        name = "across" if self.sheet.shared == "x" else "upright"
        sides = [getattr(cell.item, name) for cell in own]
        low, high = min(min(side[:2]) for side in sides), max(max(side[:2]) for side in sides)
        turned = sides[0].low > sides[0].high
        for cell in own:
            side = getattr(cell.item, name)
            setattr(cell.item, name, side._replace(low=high if turned else low, high=low if turned else high))
            assert isinstance(cell.item, _Axes)
            if self.sheet.shared == "y" and cell.column:
                cell.item.numbered[1] = False
            if self.sheet.shared == "x" and cell is not own[-1]:
                cell.item.numbered[0] = False

    def all(self) -> Iterator[_Axes]:
        """Yield the panels in the order in which they are drawn."""
        for cell in self.cells:
            if isinstance(cell.item, _PanelGrid):
                yield from cell.item.all()
            else:
                yield cell.item

    def put(self, room: Rectangle) -> None:
        """Give each panel its rectangle in a room."""
        around = [cell.item.margins() if isinstance(cell.item, _Axes) else Margins() for cell in self.cells]
        spans = []
        for count, place, sides, start, stop, ratios in (
            (self.columns, 1, (0, 2), room.left, room.right, self.sheet.widths),
            (self.rows, 0, (1, 3), room.top, room.bottom, self.sheet.heights),
        ):
            before, after = (
                [max((m[side] for cell, m in zip(self.cells, around, strict=True) if cell[place] == one), default=0.0)
                 for one in range(count)]
                for side in sides
            )  # fmt: skip
            free = stop - start - sum(before) - sum(after) - BETWEEN * (count - 1)
            parts = np.asarray(ratios or [1.0] * count)
            sizes = np.maximum(free * parts / np.sum(parts), LEAST_SIZE)
            spans.append(_along(start, before, sizes.tolist(), after))
        for cell in self.cells:
            (left, right), (top, bottom) = spans[0][cell.column], spans[1][cell.row]
            cell.item.put(Rectangle(left, top, right, bottom))


def _along(
    start: float, before: Sequence[float], sizes: Sequence[float], after: Sequence[float]
) -> list[tuple[float, float]]:
    """Return where frames begin and end that stand in a row with their margins."""
    found = []
    for one, size, other in zip(before, sizes, after, strict=True):
        found.append((start + one, start + one + size))
        start += one + size + other + BETWEEN
    return found


def drawing_of(sheet: Sheet) -> Drawing:
    """Return a sheet as a picture in SVG."""
    grid = _PanelGrid(sheet)
    wide = POINTS * sheet.width * grid.columns
    high = POINTS * sheet.height * grid.rows
    top, bottom, text = EDGE, high - EDGE, ""
    if sheet.title:
        text += text_element(sheet.title, 0.5 * wide, top, SHEET_TITLE_SIZE, upright="top", bold=True, kind="title")
        top += SHEET_TITLE_SIZE * LINE_HEIGHT * _lines(sheet.title) + 4.0
    entries = named(next(grid.all()).panel.marks) if sheet.below else []
    if entries:
        legend = legend_of(entries, sheet.below, framed=False)
        bottom -= legend.height
        left = 0.5 * (wide - legend.width)
        text += legend.drawn(Rectangle(left, bottom, left + legend.width, bottom + legend.height))
        bottom -= 2.0
    for _ in range(ROUNDS):
        grid.put(Rectangle(EDGE, top, wide - EDGE, bottom))
    panels = [axes.drawn(number) for number, axes in enumerate(grid.all())]
    hatch = f"<defs>{HATCH}</defs>" if any("url(#hatch)" in part for part in panels) else ""
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.2f}pt" height="{high:.2f}pt" '
        f'viewBox="0 0 {wide:.2f} {high:.2f}" font-family="{FONT}" fill="{style.INK}">'
    )
    ground = f'<rect width="{wide:.2f}" height="{high:.2f}" fill="white"/>'
    whole = f"{head}{hatch}{ground}{''.join(panels)}{text}</svg>"
    return Drawing(whole, wide, high, tuple((axes.panel, axes.plane) for axes in grid.all()))
