"""The marks of a panel as elements of SVG, each in the units of its axes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import marks, style
from winkler.plot.svg.letters import Rectangle, text_box, text_element
from winkler.plot.svg.pixels import (
    colours_of,
    contour_bands,
    contour_lines,
    corners_of,
    image_data,
    map_pixels,
)
from winkler.plot.svg.scales import Side, points_along

HATCH = (
    '<pattern id="hatch" width="4" height="4" patternUnits="userSpaceOnUse">'
    f'<path d="M0 4L4 0" stroke="{style.MUTED}" stroke-width=".6"/></pattern>'
)
FAR = 1e4
"""Greatest coordinate that is written [pt]; what lies beyond is cut there."""
CLOSE = 0.4
"""Distance of two points that are drawn as one [pt]."""
MANY = 1500
"""Points of a curve from which on those are left out that lie between others of the same column."""
HEAD_LENGTH, HEAD_WIDTH = 5.0, 2.0
"""Length and half of the width of the head of an arrow [pt]."""
QUIVER = 1.8
"""Length of a mean arrow of a field: the width of the panel over this and over the root of their number."""
LEAST_ARROWS = 10.0


class Plane(NamedTuple):
    """The axes of a panel in their places, and the SI values of one shown unit of each."""

    across: Side
    upright: Side
    factors: tuple[float, float]

    def x(self, numbers: Any) -> Array:
        """Return where abscissae lie [pt]."""
        return self.across.place(np.asarray(numbers, dtype=float) / self.factors[0])

    def y(self, numbers: Any) -> Array:
        """Return where ordinates lie [pt], downwards."""
        return self.upright.place(np.asarray(numbers, dtype=float) / self.factors[1])

    @property
    def box(self) -> Rectangle:
        """The frame."""
        return Rectangle(self.across.start, self.upright.stop, self.across.stop, self.upright.start)


class Reach(NamedTuple):
    """What a mark asks of the ends of the axes [SI]: numbers that are shown, ends without a margin, or no margins."""

    x: Array = np.empty(0)
    y: Array = np.empty(0)
    fixed_x: tuple[float, ...] = ()
    fixed_y: tuple[float, ...] = ()
    tight: bool = False


class DrawnShape(NamedTuple):
    """One drawn mark.

    Parameters
    ----------
    order
        Greater ones are drawn later.
    text
        Elements of SVG.
    clipped
        Whether the frame cuts it.
    covers
        Places ``(n, 2)`` [pt] that a legend must not hide.
    letters
        The rectangle of a text, and whether it has a ground of its own.
    """

    order: float
    text: str
    clipped: bool = True
    covers: Array = np.empty((0, 2))
    letters: Rectangle | None = None


def colour_text(colour: Any) -> str:
    """Return a colour as text: ``#rrggbb``, a name, or a position on a colour map."""
    if isinstance(colour, str):
        return colour
    channels = style.channels(colour) if isinstance(colour[0], str) else np.asarray(colour, dtype=float)[:3]
    return "#" + "".join(f"{round(255.0 * float(part)):02x}" for part in channels)


def outline(x: Array, y: Array, *, closed: bool = False) -> str:
    """Return the path through places [pt], interrupted where one is not finite."""
    known = np.isfinite(x) & np.isfinite(y)
    x, y = (np.clip(np.where(known, part, 0.0), -FAR, FAR) for part in (x, y))
    parts, pen = [], "M"
    for here, a, b in zip(known.tolist(), np.round(x, 2).tolist(), np.round(y, 2).tolist(), strict=True):
        if here:
            parts.append(f"{pen}{a:g} {b:g}")
            pen = "L"
        else:
            pen = "M"
    return "".join(parts) + ("Z" if closed and parts else "")


def _thinned(x: Array, y: Array) -> tuple[Array, Array]:
    """Return a curve without the points that nobody can tell from others."""
    if x.size <= MANY:
        return x, y
    if np.isfinite(x).all() and (np.diff(x) >= 0.0).all() and np.isfinite(y).all():
        column = np.floor(x / CLOSE).astype(int)
        first = np.flatnonzero(np.diff(column, prepend=column[0] - 1))
        last = np.append(first[1:], x.size) - 1
        by_height = np.lexsort((y, column))
        kept = np.unique(np.concatenate([first, last, by_height[first], by_height[last]]))
    else:
        with np.errstate(invalid="ignore"):
            steps = np.hypot(np.diff(x, prepend=x[0]), np.diff(y, prepend=y[0]))
        along = np.floor(np.cumsum(np.nan_to_num(steps)) / CLOSE)
        kept = np.flatnonzero((np.diff(along, prepend=-1.0) > 0.0) | ~np.isfinite(steps))
        kept = np.unique(np.append(kept, x.size - 1))
    return x[kept], y[kept]


def stroke(colour: Any, width: float, dash: tuple[float, ...] = (), alpha: float = 1.0, *, blunt: bool = False) -> str:
    """Return how a line is drawn, as attributes; `blunt`: without round ends."""
    look = f'fill="none" stroke="{colour_text(colour)}" stroke-width="{width:g}"'
    if dash:
        look += f' stroke-dasharray="{" ".join(f"{part * width:.3g}" for part in dash)}"'
    elif not blunt:
        look += ' stroke-linecap="round"'
    return look + (f' stroke-opacity="{alpha:g}"' if alpha < 1.0 else "")


def tint(colour: Any, alpha: float) -> str:
    """Return how an area is filled, as attributes."""
    return f'fill="{colour_text(colour)}"' + (f' fill-opacity="{alpha:g}"' if alpha < 1.0 else "")


def _dots_path(x: Array, y: Array, width: float, colour: Any, alpha: float = 1.0) -> str:
    """Return discs of one size as one path of points with round ends."""
    known = np.isfinite(x) & np.isfinite(y) & (np.abs(x) < FAR) & (np.abs(y) < FAR)
    places = np.stack([x[known], y[known]], axis=1)
    if len(places) > MANY:
        places = np.unique(np.round(places / CLOSE), axis=0) * CLOSE
    path = "".join(f"M{a:.1f} {b:.1f}h0" for a, b in places.tolist())
    return f'<path class="points" d="{path}" {stroke(colour, width, alpha=alpha)}/>' if path else ""


def _crosses(x: Array, y: Array, size: float, colour: Any, width: float) -> str:
    half = 0.5 * size
    path = "".join(
        f"M{a - half:.1f} {b:.1f}h{size:g}M{a:.1f} {b - half:.1f}v{size:g}"
        for a, b in zip(x.tolist(), y.tolist(), strict=True)
        if math.isfinite(a + b)
    )
    return f'<path class="points" d="{path}" {stroke(colour, width, blunt=True)}/>' if path else ""


def markers(mark: marks.Line, x: Array, y: Array, scale: float = 1.0) -> str:
    """Return the points of a curve [pt], in a scale of their size."""
    size = scale * mark.size
    if mark.marker in ("+", "P"):
        thick = 1.8 if mark.colour == "white" else 1.0
        return _crosses(x, y, size, mark.colour, thick if mark.marker == "+" else 0.36 * size)
    size *= 0.5 if mark.marker == "." else 1.0
    edge = 0.0 if mark.alpha < 1.0 else 1.0
    outer = _dots_path(x, y, size + edge, mark.edge or mark.colour, mark.alpha)
    if mark.hollow or mark.edge:
        return outer + _dots_path(x, y, size - edge, "white" if mark.hollow else mark.colour, mark.alpha)
    return outer


def _line(mark: marks.Line, plane: Plane) -> Iterable[DrawnShape]:
    x, y = plane.x(mark.x).ravel(), plane.y(mark.y).ravel()
    text, covers = "", np.empty((0, 2))
    if mark.width and mark.error_x is None and mark.error_y is None:
        path = outline(*_thinned(x, y))
        look = stroke(mark.colour, mark.width, mark.dash, mark.alpha, blunt=mark.blunt)
        kind = "curve marked" if mark.marker else "curve"
        text = f'<path class="{kind}" d="{path}" {look} stroke-linejoin="round"/>' if path else ""
        covers = points_along(np.stack([x, y], axis=1)) if mark.width >= 1.0 or mark.marker else covers
    for errors, side in ((mark.error_x, 0), (mark.error_y, 1)):
        if errors is not None:
            text += _error_bars(mark, plane, errors, side)
    if mark.marker:
        text += markers(mark, x, y)
        covers = np.concatenate([covers, np.stack([x, y], axis=1)])
    yield DrawnShape(mark.order, text, mark.clipped, covers)


def _error_bars(mark: marks.Line, plane: Plane, errors: Array, side: int) -> str:
    low, high = np.broadcast_to(errors, (2, mark.x.size))
    ends = (
        [(mark.x - low, mark.x + high), (mark.y, mark.y)]
        if side == 0
        else [(mark.x, mark.x), (mark.y - low, mark.y + high)]
    )
    (x0, x1), (y0, y1) = [plane.x(end) for end in ends[0]], [plane.y(end) for end in ends[1]]
    path = "".join(
        f"M{a:.1f} {b:.1f}L{c:.1f} {d:.1f}"
        for a, b, c, d in zip(*(part.tolist() for part in (x0, y0, x1, y1)), strict=True)
        if math.isfinite(a + b + c + d)
    )
    if mark.cap:
        cap = f"v{2.0 * mark.cap:g}" if side == 0 else f"h{2.0 * mark.cap:g}"
        back = (0.0, mark.cap) if side == 0 else (mark.cap, 0.0)
        for a, b in zip([*x0.tolist(), *x1.tolist()], [*y0.tolist(), *y1.tolist()], strict=True):
            path += f"M{a - back[0]:.1f} {b - back[1]:.1f}{cap}" if math.isfinite(a + b) else ""
    return f'<path d="{path}" {stroke(mark.error_colour or mark.colour, mark.width, blunt=True)}/>'


def _dots(mark: marks.Dots, plane: Plane) -> Iterable[DrawnShape]:
    x, y = plane.x(mark.x), plane.y(mark.y)
    yield DrawnShape(
        1.0, _dots_path(x, y, math.sqrt(mark.size), mark.colour, mark.alpha), True, np.stack([x, y], axis=1)
    )


def _strokes(mark: marks.Strokes, plane: Plane) -> Iterable[DrawnShape]:
    x, y = plane.x(mark.x), plane.y(mark.y)
    widths, alphas = (np.broadcast_to(part, (len(x),)).tolist() for part in (mark.widths, mark.alphas))
    looks: dict[str, list[str]] = {}
    for a, b, colour, width, alpha in zip(x, y, mark.colours, widths, alphas, strict=True):
        looks.setdefault(stroke(colour, width, alpha=alpha), []).append(outline(a, b))
    text = "".join(f'<path d="{"".join(paths)}" {look}/>' for look, paths in looks.items())
    yield DrawnShape(mark.order, text)


def _area(mark: marks.Area, plane: Plane) -> Iterable[DrawnShape]:
    along = np.asarray(mark.x, dtype=float)
    low, high = (np.broadcast_to(np.asarray(end, dtype=float), along.shape) for end in (mark.low, mark.high))
    sides = (plane.y, plane.x) if mark.across else (plane.x, plane.y)
    places, below, above = sides[0](along), *(_bounded(sides[1](end), plane, mark.across) for end in (low, high))
    known = np.isfinite(places) & np.isfinite(low) & np.isfinite(high)
    path = ""
    for part in np.split(np.arange(along.size), np.flatnonzero(np.diff(known.astype(int))) + 1):
        if part.size > 1 and known[part[0]]:
            ends = np.concatenate([places[part], places[part][::-1]]), np.concatenate([below[part], above[part][::-1]])
            path += outline(*(ends[::-1] if mark.across else ends), closed=True)
    look = tint(mark.colour, mark.alpha)
    text = f'<path class="area" d="{path}" {look}/>' if path else ""
    text += f'<path d="{path}" fill="url(#hatch)"/>' if path and mark.hatch else ""
    yield DrawnShape(mark.order, text)


def _bounded(places: Array, plane: Plane, across: bool) -> Array:
    """Return places in which those that a logarithmic axis has not lie beyond its lower end."""
    side = plane.across if across else plane.upright
    beyond = side.start - math.copysign(FAR, side.stop - side.start)
    return np.where(np.isfinite(places), places, beyond) if side.log else places


def _polygon(mark: marks.Polygon, plane: Plane) -> Iterable[DrawnShape]:
    path = outline(plane.x(mark.x), plane.y(mark.y), closed=True)
    look = tint(mark.colour, mark.alpha)
    look += f' stroke="{colour_text(mark.edge)}" stroke-width="{mark.width:g}"' if mark.edge and mark.width else ""
    yield DrawnShape(mark.order, f'<path d="{path}" {look}/>' if path else "")


def _rule(mark: marks.Rule, plane: Plane) -> Iterable[DrawnShape]:
    box = plane.box
    if mark.point is not None:
        x = np.array([plane.across.low, plane.across.high]) * plane.factors[0]
        y = mark.point[1] + mark.slope * (x - mark.point[0])
        path = outline(plane.x(x), plane.y(y))
    elif mark.upright:
        path = f"M{float(plane.x(mark.at)):.1f} {box.top:.1f}V{box.bottom:.1f}"
    else:
        path = f"M{box.left:.1f} {float(plane.y(mark.at)):.1f}H{box.right:.1f}"
    shown = "nan" not in path
    yield DrawnShape(
        mark.order,
        f'<path class="rule" d="{path}" {stroke(mark.colour, mark.width, mark.dash, blunt=True)}/>' if shown else "",
    )


def _band(mark: marks.Band, plane: Plane) -> Iterable[DrawnShape]:
    left, right = sorted(np.clip([float(plane.x(mark.low)), float(plane.x(mark.high))], -FAR, FAR).tolist())
    box = plane.box
    yield DrawnShape(1.0, box._replace(left=left, right=right).drawn(tint(mark.colour, mark.alpha)))


def _text(mark: marks.Text, plane: Plane) -> Iterable[DrawnShape]:
    if not mark.text:
        return
    box = plane.box
    x = box.left + mark.x * (box.right - box.left) if mark.framed[0] else float(plane.x(mark.x))
    y = box.bottom - mark.y * (box.bottom - box.top) if mark.framed[1] else float(plane.y(mark.y))
    if not math.isfinite(x + y):
        return
    where: dict[str, Any] = {
        "across": mark.across, "upright": mark.upright, "turned": mark.turned, "spacing": mark.spacing,
    }  # fmt: skip
    around = text_box(mark.text, x + mark.right, y, mark.size, **where)
    text = around.grown(mark.pad).drawn(tint("white", mark.boxed)) if mark.boxed else ""
    kind = "note ground" if mark.boxed > 0.5 else "note"
    text += text_element(mark.text, x + mark.right, y, mark.size, colour=mark.colour, kind=kind, **where)
    yield DrawnShape(mark.order, text, False, letters=around)


def _arrow(mark: marks.Arrow, plane: Plane) -> Iterable[DrawnShape]:
    start, stop = (np.array([float(plane.x(x)), float(plane.y(y))]) for x, y in (mark.start, mark.stop))
    away = float(np.hypot(*(stop - start)))
    if not math.isfinite(away) or away == 0.0:
        return
    along = (stop - start) / away
    side = np.array([-along[1], along[0]])
    heads = [(stop, along), (start, -along)] if mark.both else [(stop, along)]
    shaft = np.stack([start, stop - (0.0 if mark.both else HEAD_LENGTH) * along], axis=1)
    text = f'<path d="{outline(*shaft)}" {stroke(mark.colour, mark.width, blunt=True)}/>'
    for tip, forth in heads:
        back = tip - HEAD_LENGTH * forth
        corners = np.stack([back + HEAD_WIDTH * side, tip, back - HEAD_WIDTH * side], axis=1)
        look = stroke(mark.colour, mark.width) if mark.both else tint(mark.colour, 1.0)
        text += f'<path d="{outline(*corners, closed=not mark.both)}" {look}/>'
    yield DrawnShape(mark.order, text, False)


def _bars(mark: marks.Bars, plane: Plane) -> Iterable[DrawnShape]:
    text = ""
    colours = [mark.colour] * mark.places.size if isinstance(mark.colour, str) else mark.colour
    half = 0.5 * mark.thick
    for at, length, colour in zip(mark.places.tolist(), mark.lengths.tolist(), colours, strict=True):
        left, right = sorted(float(plane.x(end)) for end in (mark.start, mark.start + length))
        top, bottom = sorted(float(plane.y(end)) for end in (at - half, at + half))
        text += Rectangle(left, top, right, bottom).drawn(tint(colour, 1.0))
    if mark.ends is not None:
        line = marks.Line(mark.start + mark.lengths, mark.places, "black", width=0.8, cap=2.0)
        text += _error_bars(line, plane, mark.ends, 0)
    yield DrawnShape(1.0, text)


def _map(mark: marks.Map, plane: Plane) -> Iterable[DrawnShape]:
    ground = plane.box.drawn(f'fill="{mark.ground}"') if mark.ground else ""
    if mark.kind == "contours":
        text = ""
        for colour, outlines in contour_bands(mark):
            path = "".join(outline(plane.x(part[:, 0]), plane.y(part[:, 1]), closed=True) for part in outlines)
            edge = "" if mark.alpha < 1.0 else f' stroke="{colour}" stroke-width=".3"'  # no light between two bands
            text += f'<path d="{path}" {tint(colour, mark.alpha)}{edge} fill-rule="evenodd"/>' if path else ""
    elif mark.kind == "discs":
        colours, wide = colours_of(mark), np.abs(plane.x(mark.x + mark.z) - plane.x(mark.x))
        discs = "".join(
            f'<circle cx="{a:.1f}" cy="{b:.1f}" r="{r:.2f}" fill="{colours.text(load)}"/>'
            for a, b, r, load in zip(plane.x(mark.x), plane.y(mark.y), wide, mark.levels, strict=True)
        )
        text = f'<g stroke="{style.INK}" stroke-width=".6">{discs}</g>'
    else:
        pixels, (left, top, right, bottom) = map_pixels(mark, plane.across, plane.upright, plane.factors)
        where = f'x="{left:.2f}" y="{top:.2f}" width="{right - left:.2f}" height="{bottom - top:.2f}"'
        look = 'preserveAspectRatio="none" image-rendering="pixelated"'
        text = f'<image {where} {look} href="{image_data(pixels)}"/>'
    yield DrawnShape(0.0 if mark.kind == "pixels" else 1.0, ground + text)
    if mark.line_width:
        path = "".join(outline(plane.x(line[:, 0]), plane.y(line[:, 1])) for line in contour_lines(mark))
        yield DrawnShape(
            2.0,
            f'<path d="{path}" {stroke(mark.line_colour, mark.line_width, alpha=mark.line_alpha)}/>' if path else "",
        )


def bars_of(found: Iterable[marks.Mark]) -> list[marks.Map]:
    """Return the maps of a panel that have a colour bar."""
    return [mark for mark in found if isinstance(mark, marks.Map) and mark.place]


def _vectors(mark: marks.Vectors, plane: Plane) -> Iterable[DrawnShape]:
    x, y = plane.x(mark.x).ravel(), plane.y(mark.y).ravel()
    u, v, box = np.ravel(mark.u), np.ravel(mark.v), plane.box
    size = np.hypot(u, v)
    mean = float(np.mean(size)) if size.size else 0.0
    if mean == 0.0:
        return
    unit = (box.right - box.left) / (QUIVER * mean * max(LEAST_ARROWS, math.sqrt(size.size)))
    step = 1e-3 * abs(plane.across.high - plane.across.low) * plane.factors[0]
    there = plane.x(mark.x + step / mean * mark.u).ravel(), plane.y(mark.y + step / mean * mark.v).ravel()
    ahead = np.stack([there[0] - x, there[1] - y])
    long = np.hypot(*ahead)
    known = (long > 0.0) & np.isfinite(long)
    along = ahead[:, known] / long[known] * size[known] * unit
    tips = np.stack([x[known], y[known]]) + 0.5 * along
    back = along * np.minimum(1.0, HEAD_LENGTH / np.hypot(*along))
    sides = [tips - back + sign * np.stack([-back[1], back[0]]) for sign in (0.4, -0.4)]
    gap = np.full_like(tips, np.nan)
    lines = np.stack([tips - along, tips, gap, sides[0], tips, sides[1], gap], axis=-1).reshape(2, -1)
    yield DrawnShape(1.0, f'<path d="{outline(*lines)}" {stroke(mark.colour, 0.8)}/>')


def _facets(mark: marks.Facets, plane: Plane) -> Iterable[DrawnShape]:
    tenths = np.round(10.0 * np.stack([plane.x(mark.corners[..., 0]), plane.y(mark.corners[..., 1])], axis=-1)).astype(
        int
    )
    steps = np.diff(tenths, axis=1)
    kept = np.flatnonzero(np.abs(steps).max(axis=(1, 2)) > 0)
    shades = np.clip(np.round(255.0 * mark.colours), 0, 255).astype(int)
    hues = (shades[:, 0] << 16) + (shades[:, 1] << 8) + shades[:, 2]
    between = "l" + " ".join(["%d %d"] * steps.shape[1]) + "z"
    row = "M%d %d" + between
    texts, last = [], -1
    rows = np.concatenate([tenths[:, 0], steps.reshape(len(steps), -1)], axis=1)[kept].tolist()
    for hue, numbers in zip(hues[kept].tolist(), rows, strict=True):
        texts.append((f'{chr(34)}/><path color="#{hue:06x}" d="' if hue != last else "") + row % tuple(numbers))
        last = hue
    look = 'fill="currentColor" stroke="currentColor" stroke-width="4" stroke-linejoin="round" transform="scale(.1)"'
    yield DrawnShape(mark.order, f'<g {look}>{"".join(texts)[3:]}"/></g>' if texts else "")


DRAWN: dict[type, Callable[[Any, Plane], Iterable[DrawnShape]]] = {
    marks.Line: _line,
    marks.Dots: _dots,
    marks.Strokes: _strokes,
    marks.Area: _area,
    marks.Polygon: _polygon,
    marks.Rule: _rule,
    marks.Band: _band,
    marks.Text: _text,
    marks.Arrow: _arrow,
    marks.Bars: _bars,
    marks.Map: _map,
    marks.Vectors: _vectors,
    marks.Facets: _facets,
}


def shapes_of(mark: marks.Mark, plane: Plane) -> list[DrawnShape]:
    """Return what is drawn of a mark."""
    return [shape for shape in DRAWN[type(mark)](mark, plane) if shape.text]


def reach_of(mark: marks.Mark) -> Reach:
    """Return what a mark asks of the ends of the axes."""
    match mark:
        case marks.Line(x=x, y=y):
            known = np.isfinite(x) & np.isfinite(y)
            xs, ys = [x[known]], [y[known]]
            if mark.error_x is not None:
                xs += [x - mark.error_x[0], x + mark.error_x[1]]
            if mark.error_y is not None:
                ys += [y - mark.error_y[0], y + mark.error_y[1]]
            return Reach(np.concatenate(xs), np.concatenate(ys))
        case marks.Dots(x=x, y=y) | marks.Strokes(x=x, y=y) | marks.Polygon(x=x, y=y) | marks.Vectors(x=x, y=y):
            return Reach(np.ravel(x), np.ravel(y))
        case marks.Area(x=x, low=low, high=high):
            known = (
                np.isfinite(x)
                & np.isfinite(np.broadcast_to(low, x.shape))
                & np.isfinite(np.broadcast_to(high, x.shape))
            )
            ends = np.concatenate([np.broadcast_to(end, x.shape)[known] for end in (low, high)])
            return Reach(ends, x[known]) if mark.across else Reach(x[known], ends)
        case marks.Rule(point=None):
            at = np.array([mark.at])
            return Reach(x=at) if mark.upright else Reach(y=at)
        case marks.Band(low=low, high=high):
            return Reach(np.array([low, high]))
        case marks.Bars(places=places, lengths=lengths, start=start):
            ends = np.concatenate([[start], start + lengths])
            if mark.ends is not None:
                ends = np.concatenate([ends, start + lengths - mark.ends[0], start + lengths + mark.ends[1]])
            return Reach(ends, np.concatenate([places - 0.5 * mark.thick, places + 0.5 * mark.thick]), (start,))
        case marks.Map():
            x, y = (np.ravel(part) for part in corners_of(mark))
            if mark.kind in ("contours", "discs"):
                return Reach(x, y, tight=mark.kind == "contours")
            return Reach(x, y, (float(np.nanmin(x)), float(np.nanmax(x))), (float(np.nanmin(y)), float(np.nanmax(y))))
        case marks.Facets(corners=corners):
            return Reach(np.ravel(corners[..., 0]), np.ravel(corners[..., 1]))
    return Reach()
