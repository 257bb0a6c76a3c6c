"""Maps of pixels and arrows as traces of plotly.js."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot.marks import Map, Vectors

HEAD, OPENING = 0.35, 0.45
"""Length of the head of an arrow over its shaft, and half of its angle [rad]."""
SHAFT = 0.8
"""Length of the longest arrow over the distance between them."""
SCALES = {"viridis_r": "Viridis"}


def heat_map(mark: Map, across: float, upright: float, axis: str) -> dict[str, Any]:
    """Return a map of pixels between its ends; parameters as of the marks of `winkler.web.pictures.chart`."""
    factor, unit = mark.bar.scale.factor, mark.bar.scale.unit
    look: dict[str, Any] = {
        "type": "heatmap",
        "x": _middles(mark.x, mark.z.shape[0]) / across,
        "y": _middles(mark.y, mark.z.shape[1]) / upright,
        "z": mark.z.T / factor,
        "yaxis": axis,
        "opacity": mark.alpha,
        "hoverongaps": False,
    }
    if isinstance(mark.colours, str):
        look |= {"colorscale": SCALES.get(mark.colours, "Viridis"), "reversescale": mark.colours.endswith("_r")}
        look |= {"zmin": (mark.bar.low or 0.0) / factor}
        look |= {"zmax": mark.bar.high / factor} if mark.bar.high else {}
        look |= {"colorbar": {"title": {"text": f"[{unit}]", "side": "top"}, "thickness": 12, "outlinewidth": 0}}
        look |= {"hovertemplate": "%{z:.4g} " + unit + "<extra></extra>"}
    else:
        look |= {"colorscale": [[0.0, mark.colours[0]], [1.0, mark.colours[-1]]]}
        look |= {"showscale": False, "hoverinfo": "skip"}
    return look


def arrow_lines(mark: Vectors, across: float, upright: float, axis: str) -> dict[str, Any]:
    """Return arrows through their places, the longest as long as most of the distance between them."""
    places = np.stack([mark.x, mark.y])
    length = np.hypot(mark.u, mark.v)
    apart = min(_apart(mark.x), _apart(mark.y))
    shaft = SHAFT * apart * np.stack([mark.u, mark.v]) / (float(np.max(length)) or 1.0)
    tip = places + 0.5 * shaft
    sides = [tip - HEAD * _turned(shaft, turn) for turn in (OPENING, -OPENING)]
    gap = np.full(places.shape, np.nan)
    lines = np.stack([places - 0.5 * shaft, tip, sides[0], tip, sides[1], gap], axis=-1).reshape(2, -1)
    return {
        "type": "scatter", "mode": "lines", "x": lines[0] / across, "y": lines[1] / upright, "yaxis": axis,
        "hoverinfo": "skip", "showlegend": False, "line": {"color": mark.colour, "width": 1.2},
    }  # fmt: skip


def _middles(ends: Array, count: int) -> Array:
    edges = np.linspace(ends[0], ends[-1], count + 1)
    return np.asarray(0.5 * (edges[1:] + edges[:-1]))


def _apart(places: Array) -> float:
    steps = np.diff(np.unique(places))
    return float(np.min(steps)) if steps.size else np.inf


def _turned(shaft: Array, turn: float) -> Array:
    c, s = np.cos(turn), np.sin(turn)
    return np.stack([c * shaft[0] - s * shaft[1], s * shaft[0] + c * shaft[1]])
