"""The body in three dimensions, cut open, in the dent that it makes: a drawing in parallel projection.

Everything is a body of revolution, so the scene is built of rings cut into facets, turned towards the reader, painted
from back to front.  Heights are stretched, because dents are shallow; two bars tell both scales.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from winkler.fields import restore
from winkler.foundation.bed import Pressed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import Outline, solid_until, sunk
from winkler.plot.series import told
from winkler.problems.answer import Restorable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_body", "draw_contact"]

ELEVATION = math.radians(27.0)
CUT = math.radians(58.0)
"""Half of the sector that is cut out of the body, towards the reader."""
RINGS, SECTORS = 48, 120
TOWARDS = np.array([0.0, -math.cos(ELEVATION), math.sin(ELEVATION)])
"""Direction from the scene to the reader."""
LIGHT = np.array([-0.45, -0.45, 0.77])
FACE = "#8fa3b8"
TALL = 0.62
"""Height of the body in the picture, in units of its drawn radius."""


class Facets(NamedTuple):
    """Corners (n, 4, 3) of many facets in picture units, their normals (n, 3) and colours (n, 3)."""

    corners: Array
    normals: Array
    colours: Array


def draw_body(axes: Axes, shape: Outline, extent: float) -> None:
    """Draw a body of revolution alone.

    Parameters
    ----------
    axes : Axes
        Empty.
    shape
        A profile or a bed.
    extent : float
        Drawn radius [m].
    """
    end = min(extent, solid_until(shape))
    r = np.linspace(0.0, end, RINGS + 1)
    f = np.asarray(shape.height(r), dtype=float)
    lid = _lid(float(f[-1]), end, 0.0, wall=shape.rim <= end)
    stretch = TALL * end / lid
    _solid(axes, r / end, f * stretch / end, TALL)
    _finish(axes, end, stretch)


def draw_contact(axes: Axes, solution: Restorable, extent: float) -> None:
    """Draw the body of a contact, cut open, in the deformed surface; the pressure is painted on the surface.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution
        For one load.
    extent : float
        Drawn radius [m].
    """
    pressed = solution.pressed
    end = min(extent, solid_until(pressed.bed))
    r = _rings(end, pressed)
    f = np.asarray(pressed.bed.height(r), dtype=float) - pressed.depth
    lid = _lid(float(f[-1] - f[0]), end, abs(pressed.depth), wall=pressed.bed.rim <= end) + float(f[0])
    ground = np.unique(np.concatenate([_rings(extent, pressed), [pressed.radius]]))
    stretch = TALL * end / (lid - min(float(f[0]), 0.0))
    scaled = stretch / extent
    _paint(axes, _floor(ground / extent, -sunk(pressed, ground) * scaled, _tint(solution, ground)), zorder=2.0)
    levels = np.linspace(0.0, extent, 7)[1:]
    for radius, level in zip(levels, sunk(pressed, levels), strict=True):
        _ring(axes, radius / extent, -level * scaled, style.MUTED, 0.5)
    if pressed.radius > 0.0:
        edge = float(sunk(pressed, np.array([pressed.radius]))[0])
        _ring(axes, pressed.radius / extent, -edge * scaled, style.RED, 1.5)
    if 0.0 < pressed.touching < pressed.radius:  # beyond it the surfaces only attract each other
        edge = float(sunk(pressed, np.array([pressed.touching]))[0])
        _ring(axes, pressed.touching / extent, -edge * scaled, style.RED, 0.8)
    _solid(axes, r / extent, f * scaled, lid * scaled)
    _finish(axes, extent, stretch)


def _lid(rise: float, radius: float, depth: float, *, wall: bool) -> float:
    """Return where the body is cut off above its apex [m]."""
    if not wall and rise > 0.0:
        return max(1.12 * rise, 1.3 * depth)
    return max(1.6 * rise, rise + 4.0 * depth) or TALL * radius


def _rings(end: float, pressed: Pressed) -> Array:
    marks = [b for b in (*(b for b, _ in pressed.bed.kinks), pressed.radius) if 0.0 < b < end]
    return np.unique(np.concatenate([np.linspace(0.0, end, RINGS + 1), marks]))


def _tint(solution: Restorable, ground: Array) -> Array:
    """Return the colour of every ring of the surface: the pressure within the contact, else that of the solid."""
    from matplotlib.colors import to_rgb

    middle = 0.5 * (ground[1:] + ground[:-1])
    pressure = restore(solution, middle).pressure
    colours = np.tile(np.array(to_rgb(style.SOLID)), (middle.size, 1))
    touched = middle < solution.pressed.radius
    if touched.any():
        share = np.clip(pressure[touched] / (2.0 * float(np.median(np.abs(pressure[touched])))), -1.0, 1.0)
        pushed, pulled = style.shades()(np.maximum(share, 0.0)), style.tensions()(np.maximum(-share, 0.0))
        colours[touched] = np.where(share[:, None] >= 0.0, pushed, pulled)[:, :3]
    return colours


def _revolved(r: Array, z: Array, turns: Array, normal_sign: float, colour: Callable[[int], Array]) -> Facets:
    """Return the facets of a curve (r, z) turned about the axis through `turns`."""
    grid = np.meshgrid(np.arange(r.size - 1), np.arange(turns.size - 1), indexing="ij")
    ring, sector = (part.ravel() for part in grid)
    corners = np.empty((ring.size, 4, 3))
    for place, (i, j) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
        radius, turn = r[ring + i], turns[sector + j]
        corners[:, place] = np.stack([radius * np.cos(turn), radius * np.sin(turn), z[ring + i]], axis=-1)
    along = np.hypot(np.diff(r), np.diff(z))
    along = np.where(along > 0.0, along, 1.0)
    out, up = -np.diff(z) / along, np.diff(r) / along
    turn = 0.5 * (turns[sector] + turns[sector + 1])
    normals = np.stack([out[ring] * np.cos(turn), out[ring] * np.sin(turn), up[ring]], axis=-1) * normal_sign
    return Facets(corners, normals, np.stack([colour(int(i)) for i in range(r.size - 1)])[ring])


def _floor(r: Array, z: Array, tint: Array) -> Facets:
    turns = np.linspace(0.5 * np.pi, 2.5 * np.pi, SECTORS + 1)
    facets = _revolved(r, z, turns, 1.0, lambda ring: tint[ring])
    order = np.argsort(-np.mean(facets.corners[:, :, 1], axis=1))
    return Facets(facets.corners[order], facets.normals[order], facets.colours[order])


def _solid(axes: Axes, r: Array, z: Array, lid: float) -> None:
    """Draw a body with the outline z(r), closed at the height `lid`, with a sector cut out towards the reader."""
    from matplotlib.colors import to_rgb

    steel = np.array(to_rgb(style.BODY))
    turns = np.linspace(CUT, 2.0 * np.pi - CUT, SECTORS + 1) - 0.5 * np.pi
    shell = _revolved(r, z, turns, -1.0, lambda _: steel)
    wall = _revolved(np.full(9, r[-1]), np.linspace(z[-1], lid, 9), turns, -1.0, lambda _: steel)
    parts = Facets(*(np.concatenate(pair) for pair in zip(shell, wall, strict=True)))
    towards = parts.corners.mean(axis=1) @ TOWARDS
    order = np.argsort(towards)
    _paint(axes, Facets(*(part[order] for part in parts)), zorder=3.0)
    rim = np.concatenate([[0.0], np.full(turns.size, r[-1])])
    turned = np.concatenate([[0.0], turns])
    top = np.stack([rim * np.cos(turned), rim * np.sin(turned), np.full(rim.shape, lid)], axis=-1)
    _sheet(axes, top, np.array([0.0, 0.0, 1.0]), style.BODY)
    for turn, side in ((turns[0], 1.0), (turns[-1], -1.0)):
        across, up = np.concatenate([r, [r[-1], 0.0]]), np.concatenate([z, [lid, lid]])
        face = np.stack([across * np.cos(turn), across * np.sin(turn), up], axis=-1)
        _sheet(axes, face, side * np.array([math.sin(turn), -math.cos(turn), 0.0]), FACE)


def _sheet(axes: Axes, corners: Array, normal: Array, colour: str) -> None:
    """Paint one plane polygon."""
    from matplotlib.colors import to_rgb

    shaded = np.array(to_rgb(colour)) * _brightness(normal)
    axes.fill(*_seen(corners), facecolor=shaded, edgecolor=shaded * 0.8, linewidth=0.6, zorder=3.5)


def _ring(axes: Axes, radius: float, level: float, colour: str, width: float) -> None:
    """Draw a circle on the surface; the body hides what is behind it."""
    turn = np.linspace(0.0, 2.0 * np.pi, 241)
    circle = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full(turn.shape, level)], axis=-1)
    axes.plot(*_seen(circle), color=colour, linewidth=width, zorder=2.5)


def _brightness(normal: Array) -> Array:
    return np.asarray(0.62 + 0.38 * np.clip(normal @ (LIGHT / np.linalg.norm(LIGHT)), 0.0, 1.0))


def _seen(points: Array) -> tuple[Array, Array]:
    """Return where points (..., 3) appear in the plane of the picture."""
    return points[..., 0], points[..., 2] * math.cos(ELEVATION) + points[..., 1] * math.sin(ELEVATION)


def _paint(axes: Axes, facets: Facets, *, zorder: float) -> None:
    """Paint the facets that face the reader, in their order; as pixels, also in vector formats."""
    from matplotlib.collections import PolyCollection

    visible = facets.normals @ TOWARDS > 1e-9
    corners, normals, colours = (part[visible] for part in facets)
    shaded = np.clip(colours * _brightness(normals)[:, None], 0.0, 1.0)
    flat = np.stack(_seen(corners), axis=-1)
    axes.add_collection(
        PolyCollection(list(flat), facecolors=shaded, edgecolors=shaded, linewidths=0.4, rasterized=True, zorder=zorder)
    )


def _finish(axes: Axes, extent: float, stretch: float) -> None:
    """Set the frame, and add the bars that tell the scales."""
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.autoscale_view()
    bottom = float(axes.dataLim.y0)
    width, height = _round(0.5 * extent), _round(0.32 * extent / stretch)
    line: Any = {"color": style.INK, "linewidth": 1.1, "zorder": 6, "clip_on": False, "solid_capstyle": "butt"}
    tall = height * stretch / extent * math.cos(ELEVATION)
    top = bottom - 0.07
    level = top - 0.5 * tall
    axes.plot([-1.0, -1.0 + width / extent], [level, level], **line)
    axes.text(-1.0 + 0.5 * width / extent, level - 0.04, told(width, "m"), ha="center", va="top", fontsize=8.5)
    axes.plot([0.3, 0.3], [top - tall, top], **line)
    told_height = told(height, "m")
    if abs(stretch - 1.0) > 0.01:
        told_height += f"  (heights × {float(f'{stretch:.2g}'):g})"
    axes.text(0.34, level, told_height, ha="left", va="center", fontsize=8.5)
    axes.set_xlim(-1.08, 1.12)
    axes.set_ylim(min(top - tall, level - 0.2), None)


def _round(length: float) -> float:
    """Return the greatest 1, 2 or 5 times a power of ten that is not above `length`."""
    power = 10.0 ** math.floor(math.log10(length))
    return float(f"{max(step for step in (1.0, 2.0, 5.0) if step * power <= length * (1 + 1e-9)) * power:.6g}")
