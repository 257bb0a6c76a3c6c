"""The body in three dimensions, cut open, in the dent that it makes; to be turned with the mouse.

Triangles, not surfaces: browsers without a graphics card draw them twenty times faster.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.fields import restore
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import solid_until, sunk
from winkler.plot.series import scale_of, told
from winkler.web.chart import CONFIG, FONT, Chart
from winkler.web.view import View

__all__ = ["draw_solid"]

RINGS, SECTORS = 18, 36
CUT = math.radians(80.0)
"""Half of the sector that is cut out of the body, towards the reader."""
TALL = 0.55
"""Height of the picture in its widths."""
SKIN = [[0.0, "#a50f15"], [0.49, "#fcae91"], [0.495, style.SOLID], [0.505, style.SOLID], [0.51, "#e2e418"],
        [0.7, "#5ec962"], [0.85, "#21918c"], [1.0, "#3b528b"]]  # fmt: skip
"""From tension over nothing to pressure."""
STEEL = [[0.0, "#66788c"], [1.0, "#cdd8e3"]]
LIGHT = np.array([-0.45, -0.55, 0.70])
"""Direction to the light, the same from wherever one looks."""


class Mesh(NamedTuple):
    """Corners (n, 3), and triangles (m, 3) of their places."""

    corners: Array
    triangles: Array


def draw_solid(contact: Any, view: View) -> Chart:
    """Return the body of a contact in the deformed surface; the pressure is painted on the surface.

    Parameters
    ----------
    contact
        For one load.
    view
        The frame.
    """
    pressed, units = contact.pressed, _Units(view)
    a = float(pressed.radius)
    ground = np.unique(np.append(np.linspace(0.0, view.extent, RINGS + 1), [0.985 * a, a, min(1.02 * a, view.extent)]))
    level = -sunk(pressed, ground)
    pressure = np.asarray(restore(contact, np.maximum(ground, 1e-6 * view.extent)).pressure, dtype=float)
    inside = np.abs(pressure[(ground < a) & np.isfinite(pressure)])
    usual = 2.0 * float(np.median(inside)) if inside.size else 0.0
    tint = np.clip(np.nan_to_num(pressure / usual, posinf=1.0, neginf=-1.0), -1.0, 1.0) if usual else 0.0 * ground
    floor = _turned(units.across(ground), units.up(level), np.linspace(0.0, 2.0 * np.pi, SECTORS + 1))
    painted = np.tile(np.where(ground <= a, tint, 0.0), SECTORS + 1)
    lid = max(1.7 * view.sunk, float(pressed.bed.height(np.zeros(1))[0]) - float(pressed.depth))
    look = {"colorscale": SKIN, "cmin": -1.0, "cmax": 1.0, "intensity": painted, "showscale": False}
    body = _body(pressed, view, units, lid)
    wide, tall = units.across(view.extent), units.up(lid)
    steel = {"colorscale": STEEL, "cmin": 0.0, "cmax": 1.0, "showscale": False, "intensitymode": "cell"}
    data = [_drawn(floor, **look), _drawn(body, intensity=_brightness(body, wide, tall), **steel)]
    if a > 0.0:
        data.append(_ring(units.across(a), units.up(float(np.interp(a, ground, level)))))
    low = min(float(np.min(level)), -1.2 * view.sunk)
    stretch = TALL * 2.0 * view.extent / (lid - low)
    note = f"{told(2.0 * view.extent, 'm', 3)} across, heights × {float(f'{stretch:.2g}'):g}"
    return {"data": data, "layout": _layout(view, units, (low, lid), note), "config": CONFIG}


class _Units:
    """What lengths are shown in, across and up."""

    def __init__(self, view: View) -> None:
        self.wide, self.tall = scale_of("m", [view.extent]), scale_of("m", [view.sunk])

    def across(self, length: Any) -> Any:
        return length / self.wide.factor

    def up(self, length: Any) -> Any:
        return length / self.tall.factor


def _body(pressed: Any, view: View, units: _Units, lid: float) -> Mesh:
    """Return the body up to a lid, with a sector cut out: its shell, both faces of the cut, and its top."""
    end = min(view.extent, solid_until(pressed.bed))
    r = np.unique(np.append(np.linspace(0.0, end, RINGS + 1), [b for b, _ in pressed.bed.kinks if b < end]))
    f = np.asarray(pressed.bed.height(r), dtype=float) - float(pressed.depth)
    above = np.flatnonzero(f > lid)
    if above.size and above[0] > 0:  # it leaves the picture through the lid
        last = above[0]
        out = float(np.interp(lid, f[last - 1 : last + 1], r[last - 1 : last + 1]))
        r, f = np.append(r[:last], out), np.append(f[:last], lid)
    else:
        r, f = np.append(r, r[-1]), np.append(f, lid)
    turns = np.linspace(CUT, 2.0 * np.pi - CUT, SECTORS + 1) - 0.5 * np.pi
    x, z, top = units.across(r), units.up(f), units.up(np.full(r.shape, lid))
    parts = [_turned(x, z, turns), _turned(x, top, turns)]
    for turn in (turns[0], turns[-1]):
        face = np.concatenate([np.stack([x * np.cos(turn), x * np.sin(turn), side], axis=-1) for side in (z, top)])
        parts.append(Mesh(face, _quads(2, x.size)))
    return _joined(parts)


def _turned(r: Array, z: Array, turns: Array) -> Mesh:
    """Return the surface of a curve (r, z) turned about the axis."""
    corners = [np.stack([r * np.cos(turn), r * np.sin(turn), z], axis=-1) for turn in turns]
    return Mesh(np.concatenate(corners), _quads(turns.size, r.size))


def _quads(rows: int, columns: int) -> Array:
    """Return two triangles for every field of a grid whose corners are counted row by row."""
    first = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    second = [first, first + 1, first + columns], [first + 1, first + columns + 1, first + columns]
    return np.concatenate([np.stack(corners, axis=-1) for corners in second])


def _joined(parts: list[Mesh]) -> Mesh:
    before = np.cumsum([0, *(len(part.corners) for part in parts[:-1])])
    triangles = [part.triangles + count for part, count in zip(parts, before, strict=True)]
    return Mesh(np.concatenate([part.corners for part in parts]), np.concatenate(triangles))


def _drawn(mesh: Mesh, **look: Any) -> dict[str, Any]:
    return {
        "type": "mesh3d",
        **dict(zip("xyz", mesh.corners.T, strict=True)),
        **dict(zip("ijk", mesh.triangles.T, strict=True)),
        "hoverinfo": "skip",
        "lighting": {"ambient": 1.0, "diffuse": 0.0, "specular": 0.0, "fresnel": 0.0},
        **look,
    }


def _brightness(mesh: Mesh, wide: float, tall: float) -> Array:
    """Return how bright the side of every triangle is that is turned to the light, from zero to one."""
    corners = (mesh.corners / np.array([wide, wide, tall]))[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    return np.asarray(np.abs(normals @ LIGHT) / np.where(lengths > 0.0, lengths, 1.0))


def _ring(radius: float, level: float) -> dict[str, Any]:
    """Return the edge of the contact."""
    turn = np.linspace(0.0, 2.0 * np.pi, 73)
    return {
        "type": "scatter3d",
        "mode": "lines",
        "x": radius * np.cos(turn),
        "y": radius * np.sin(turn),
        "z": np.full(turn.shape, level),
        "line": {"color": style.RED, "width": 5},
        "hoverinfo": "skip",
    }


def _layout(view: View, units: _Units, heights: tuple[float, float], note: str) -> dict[str, Any]:
    wide, unseen = units.across(view.extent), {"visible": False}  # letters in space cost more than the body
    low, high = (units.up(height) for height in heights)
    return {
        "scene": {
            "xaxis": {**unseen, "range": [-wide, wide]},
            "yaxis": {**unseen, "range": [-wide, wide]},
            "zaxis": {**unseen, "range": [low, high + 0.01 * (high - low)]},
            "aspectmode": "manual",
            "aspectratio": {"x": 1.75, "y": 1.75, "z": 1.75 * TALL},
            "camera": {
                "eye": {"x": 0.3, "y": -1.9, "z": 1.25},
                "center": {"x": 0.0, "y": 0.0, "z": -0.08},
                "projection": {"type": "orthographic"},
            },
        },
        "margin": {"l": 0, "r": 0, "t": 0, "b": 0},
        "font": {"family": FONT, "color": style.INK, "size": 11},
        "paper_bgcolor": "white",
        "uirevision": "kept",
        "showlegend": False,
        "annotations": [
            {
                "text": note,
                "xref": "paper",
                "yref": "paper",
                "x": 0.99,
                "y": 0.01,
                "xanchor": "right",
                "showarrow": False,
            }
        ],
    }
