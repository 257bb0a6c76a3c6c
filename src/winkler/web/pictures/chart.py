"""Panels as figures of plotly.js: plain dictionaries of traces, axes and notes, in the look of the other pictures."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.panel import (
    Area,
    Arrow,
    Band,
    Dots,
    Line,
    Map,
    Panel,
    PanelAxis,
    Polygon,
    Rule,
    Strokes,
    Text,
    Vectors,
)
from winkler.web.pictures.pixels import arrow_lines, heat_map
from winkler.web.pictures.words import text_html

Chart = dict[str, Any]
"""``data`` and ``layout`` of a figure."""

FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif'
CONFIG = {"displaylogo": False, "responsive": False, "displayModeBar": False, "scrollZoom": False}
"""Options of plotly.js; no button sends data elsewhere."""

LEGENDED = {
    "showlegend": True,
    "legend": {
        "orientation": "h",
        "x": 0.0,
        "y": 1.02,
        "xanchor": "left",
        "yanchor": "bottom",
        "font": {"size": 11},
        "itemclick": False,
        "itemdoubleclick": False,
    },
    "margin": {"l": 66, "r": 14, "t": 40, "b": 46},
}
"""Additional layout of a figure with a legend."""
SYMBOLS = {"o": "circle", ".": "circle", "+": "cross-thin-open", "P": "cross"}
DOMAINS = ((0.34, 1.0), (0.0, 0.24))
"""Heights of two panels above each other."""


def chart(*panels: Panel) -> Chart:
    """Return the figure of one panel, or of two above each other that share the axis across."""
    data: list[dict[str, Any]] = []
    layout: dict[str, Any] = {
        "margin": {"l": 66, "r": 14, "t": 12, "b": 46},
        "font": {"family": FONT, "color": style.INK, "size": 12},
        "paper_bgcolor": "white",
        "plot_bgcolor": "white",
        "showlegend": False,
        "hovermode": "closest",
        "dragmode": False,
        "xaxis": _axis(panels[-1].across, panels[-1].grid != "", anchor="y2" if len(panels) > 1 else "y"),
        "shapes": [],
        "annotations": [],
        "meta": {"hover": {}},
    }
    for number, panel in enumerate(panels):
        name = f"y{number + 1}" if number else "y"
        place: dict[str, Any] = {"domain": list(DOMAINS[number])} if len(panels) > 1 else {}
        place |= {"scaleanchor": "x", "constrain": "domain", "constraintoward": "middle"} if panel.equal else {}
        layout[f"yaxis{number + 1 if number else ''}"] = _axis(panel.upright, panel.grid == "both", **place)
        across, upright = panel.across.scale.factor, panel.upright.scale.factor
        for mark in sorted(panel.marks, key=lambda one: getattr(one, "order", 2.0)):
            for kind, one in MARKS[type(mark)](mark, across, upright, name):
                (data if kind == "data" else layout[kind]).append(one)
        add_hover(data, layout, panel, name)
        layout |= LEGENDED if panel.legend and any(_is_named(mark) for mark in panel.marks) else {}
    return {"data": data, "layout": layout, "config": CONFIG}


def _is_named(mark: Any) -> bool:
    name = getattr(mark, "name", "")
    return bool(name) and not name.startswith("_")


def _axis(one: PanelAxis, gridded: bool, **more: Any) -> dict[str, Any]:
    """Return an axis with a title."""
    low, high = (None if end is None else end / one.scale.factor for end in (one.low, one.high))
    result: dict[str, Any] = {
        "title": {"text": text_html(one.title), "font": {"size": 12}, "standoff": 6},
        "gridcolor": style.PALE,
        "zeroline": False,
        "fixedrange": True,  # touch gestures scroll the page
        "linecolor": style.MUTED,
        "ticks": "outside",
        "ticklen": 4,
        "tickcolor": style.MUTED,
        "tickfont": {"size": 11},
        "exponentformat": "power",
        "showgrid": gridded,
    }
    if one.log:
        result["type"] = "log"
    if low is not None and high is not None:
        result["range"] = [float(np.log10(end)) if one.log else end for end in (low, high)]
    elif low == 0.0:
        result["rangemode"] = "tozero"
    if one.falling:
        result["autorange"] = "reversed"
    return result | more


Parts = list[tuple[str, dict[str, Any]]]


def _rgba(colour: str | tuple[str, float], alpha: float) -> str:
    red, green, blue = (round(255.0 * part) for part in style.channels(colour))
    return f"rgba({red},{green},{blue},{alpha:g})"


def _line(mark: Line, across: float, upright: float, axis: str) -> Parts:
    look: dict[str, Any] = {"type": "scatter", "yaxis": axis, "hoverinfo": "x+y", "cliponaxis": mark.clipped}
    is_empty = not (mark.x.size or mark.name)
    look |= {"name": text_html(mark.name), "showlegend": True} if _is_named(mark) else {"showlegend": False}
    x, y = (part if part.size else np.full(1, np.nan) for part in (mark.x / across, mark.y / upright))
    modes = [name for name, wanted in (("lines", mark.width > 0.0), ("markers", mark.marker)) if wanted]
    colour = "white" if mark.colour == "white" else _rgba(mark.colour, mark.alpha)
    look |= {"x": x, "y": y, "mode": "+".join(modes)}
    if mark.width:
        dash = ",".join(f"{mark.width * part:g}px" for part in mark.dash) or "solid"
        look["line"] = {"color": colour, "width": mark.width, "dash": dash}
    if mark.marker:
        fill = {"color": "white", "line": {"color": colour, "width": 1.5}} if mark.hollow else {"color": colour}
        look["marker"] = {"size": 1.6 * mark.size, "symbol": SYMBOLS.get(mark.marker, "circle"), **fill}
    return [] if is_empty else [("data", look)]


def _dots(mark: Dots, across: float, upright: float, axis: str) -> Parts:
    marker = {"color": _rgba(mark.colour, 0.5), "size": 4}
    look: dict[str, Any] = {"type": "scatter", "mode": "markers", "marker": marker, "yaxis": axis, "hoverinfo": "x+y"}
    look |= {"name": mark.name, "showlegend": bool(mark.name)}
    return [("data", {**look, "x": mark.x / across, "y": mark.y / upright})]


def _strokes(mark: Strokes, across: float, upright: float, axis: str) -> Parts:
    """Return all strokes of one colour as one line with gaps."""
    result: Parts = []
    for colour in dict.fromkeys(mark.colours):
        mine = np.array([one == colour for one in mark.colours])
        gap = np.full((int(mine.sum()), 1), np.nan)
        x, y = (np.append(part[mine], gap, axis=1).ravel() for part in (mark.x / across, mark.y / upright))
        look = {"color": colour, "width": 1.0 if colour == style.MUTED else 1.6}
        result.append(("data", _bare(x, y, axis, line=look)))
    return result


def _bare(x: Array, y: Array, axis: str, **look: Any) -> dict[str, Any]:
    """Return lines without hover text and legend."""
    return {
        "type": "scatter",
        "mode": "lines",
        "x": x,
        "y": y,
        "yaxis": axis,
        "hoverinfo": "skip",
        "showlegend": False,
        **look,
    }


def _area(mark: Area, across: float, upright: float, axis: str) -> Parts:
    colour = _rgba(mark.colour, mark.alpha)
    if not mark.across and np.ndim(mark.high) == 0 and mark.high == 0.0:
        look = {"fill": "tozeroy", "fillcolor": colour, "line": {"width": 0}}
        return [("data", _bare(mark.x / across, mark.low / upright, axis, **look))] if np.any(mark.low) else []
    finite = np.isfinite(mark.x) & np.isfinite(mark.low) & np.isfinite(mark.high)
    along = mark.x[finite]
    low, high = (np.broadcast_to(np.asarray(end, dtype=float), mark.x.shape)[finite] for end in (mark.low, mark.high))
    x, y = np.concatenate([along, along[::-1]]), np.concatenate([low, high[::-1]])
    x, y = (y, x) if mark.across else (x, y)
    return _filled(x / across, y / upright, colour, axis)


def _polygon(mark: Polygon, across: float, upright: float, axis: str) -> Parts:
    return _filled(mark.x / across, mark.y / upright, _rgba(mark.colour, mark.alpha), axis)


def _filled(x: Array, y: Array, colour: str, axis: str) -> Parts:
    return [("data", _bare(x, y, axis, fill="toself", fillcolor=colour, line={"width": 0}))] if x.size else []


def _rule(mark: Rule, across: float, upright: float, axis: str) -> Parts:
    dash = ",".join(f"{mark.width * part:g}px" for part in mark.dash) or "solid"
    line = {"color": mark.colour, "width": mark.width, "dash": dash}
    at = mark.at / (across if mark.upright else upright)
    along, through = ("x", "y") if mark.upright else ("y", "x")
    refs = {"x": "x", "y": axis}
    ends: dict[str, Any] = {f"{along}0": at, f"{along}1": at, f"{through}0": 0.0, f"{through}1": 1.0}
    ends |= {f"{along}ref": refs[along], f"{through}ref": f"{refs[through]} domain"}
    return [("shapes", {"type": "line", "line": line, "layer": "below" if mark.order < 2.0 else "above", **ends})]


def _band(mark: Band, across: float, _: float, axis: str) -> Parts:
    ends = {"x0": mark.low / across, "x1": mark.high / across, "y0": 0.0, "y1": 1.0, "yref": f"{axis} domain"}
    look = {"fillcolor": _rgba(mark.colour, mark.alpha), "line": {"width": 0}, "layer": "below"}
    return [("shapes", {"type": "rect", **ends, **look})]


def _text(mark: Text, across: float, upright: float, axis: str) -> Parts:
    look = {
        "text": text_html(mark.text),
        "x": mark.x if mark.framed[0] else mark.x / across,
        "y": mark.y if mark.framed[1] else mark.y / upright,
        "xref": "x domain" if mark.framed[0] else "x",
        "yref": f"{axis} domain" if mark.framed[1] else axis,
        "xanchor": mark.across,
        "yanchor": {"center": "middle", "baseline": "bottom"}.get(mark.upright, mark.upright),
        "align": mark.across,
        "showarrow": False,
        "font": {"size": 11.5, "color": mark.colour},
    }
    return [("annotations", look | ({"bgcolor": "rgba(255,255,255,0.8)"} if mark.boxed else {}))]


def _arrow(mark: Arrow, across: float, upright: float, axis: str) -> Parts:
    look = {
        "text": "",
        "x": mark.stop[0] / across,
        "y": mark.stop[1] / upright,
        "ax": mark.start[0] / across,
        "ay": mark.start[1] / upright,
        "xref": "x",
        "axref": "x",
        "yref": axis,
        "ayref": axis,
        "showarrow": True,
        "arrowside": "end+start" if mark.both else "end",
        "arrowhead": 2,
        "arrowwidth": mark.width,
        "arrowcolor": mark.colour,
    }
    return [("annotations", look)]


def _map(mark: Map, across: float, upright: float, axis: str) -> Parts:
    """Return pixels, or contours; values above the last level have its colour."""
    if mark.kind == "pixels":
        return [("data", heat_map(mark, across, upright, axis))]
    factor, levels = mark.bar.scale.factor, np.asarray(mark.levels, dtype=float)
    x, y = (part[:, 0] if part.ndim == 2 and turn else np.ravel(part[:1]) if part.ndim == 2 else part
            for part, turn in ((mark.x, True), (mark.y, False)))  # fmt: skip
    unit = mark.bar.scale.unit
    contours = {
        "start": 2.0 * levels[1] / factor,
        "end": levels[-1] / factor,
        "size": 2.0 * (levels[1] - levels[0]) / factor,
    }
    look = {
        "type": "contour",
        "x": x / across,
        "y": y / upright,
        "z": np.minimum(mark.z.T if mark.x.ndim == 2 else mark.z, levels[-1]) / factor,
        "zmin": levels[0] / factor,
        "zmax": levels[-1] / factor,
        "showscale": bool(mark.place),
        "yaxis": axis,
        "colorscale": "Viridis",
        "reversescale": True,
        "contours": contours,
        "autocontour": False,
        "line": {"width": 0.4, "color": "white"},
        "colorbar": {"title": {"text": f"[{unit}]", "side": "top"}, "thickness": 12, "outlinewidth": 0, "len": 1.0},
        "hovertemplate": "%{z:.4g} " + unit + "<extra></extra>",
    }
    return [("data", look)]


MARKS: dict[type, Callable[[Any, float, float, str], Parts]] = {
    Line: _line,
    Dots: _dots,
    Strokes: _strokes,
    Area: _area,
    Polygon: _polygon,
    Rule: _rule,
    Band: _band,
    Text: _text,
    Arrow: _arrow,
    Map: _map,
    Vectors: lambda mark, *scales: [("data", arrow_lines(mark, *scales))],
}
"""Traces of each mark; three-dimensional bodies are drawn by `winkler.web.pictures.solid`."""


def add_hover(data: list[dict[str, Any]], layout: dict[str, Any], panel: Panel, axis: str) -> None:
    """State units and factors of a panel in its figure.

    Parameters
    ----------
    data, layout
        The figure; ``layout["meta"]`` gets the SI value of one unit of each axis, and the text by vertical axis.
    panel
        The panel.
    axis
        Its vertical axis, as plotly.js names it.
    """
    pair = (("x", panel.across), ("y", panel.upright))
    x, y = (f"%{{{name}:.4~g}} {one.scale.unit}".rstrip() for name, one in pair)
    text = f"{x}<br>{y}<extra></extra>"
    layout["meta"] |= {"x": panel.across.scale.factor, axis: panel.upright.scale.factor}
    layout["meta"]["hover"][axis] = text
    for trace in data:
        if trace.get("yaxis") == axis and trace.get("hoverinfo") == "x+y":
            trace["hovertemplate"] = text
