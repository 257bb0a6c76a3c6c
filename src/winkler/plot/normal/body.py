"""The body in three dimensions, cut open, in the dent that it makes: a drawing in parallel projection.

Everything is a body of revolution, so the scene is built of rings cut into facets, turned towards the reader, painted
from back to front.  Heights are stretched, because dents are shallow; two bars show both scales.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from winkler.fields.restoration import restore
from winkler.foundation.bed import PressedSprings
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import BodyOutline, outline_end, sunk
from winkler.plot.panel import Facets, Line, Panel, PanelAxis, Polygon, Text
from winkler.plot.series import with_unit
from winkler.problems.answer import Restorable

ELEVATION = math.radians(27.0)
HALF_CUT_ANGLE = math.radians(58.0)
"""Half of the sector that is cut out of the body, towards the reader."""
RINGS, SECTORS = 48, 120
VIEW_DIRECTION = np.array([0.0, -math.cos(ELEVATION), math.sin(ELEVATION)])
"""Direction from the scene to the reader."""
LIGHT = np.array([-0.45, -0.45, 0.77])
CUT_COLOUR = "#8fa3b8"
HEIGHT_TO_RADIUS = 0.62
"""Height of the body in the picture, in units of its drawn radius."""


class ShadedFacets(NamedTuple):
    """Corners (n, 4, 3) of many facets in picture units, their normals (n, 3) and colours (n, 3)."""

    corners: Array
    normals: Array
    colours: Array


def body_panel(shape: BodyOutline, extent: float) -> Panel:
    """Return a body of revolution alone.

    Parameters
    ----------
    shape
        A profile or a bed.
    extent : float
        Drawn radius [m].
    """
    end = min(extent, outline_end(shape))
    r = np.linspace(0.0, end, RINGS + 1)
    f = np.asarray(shape.height(r), dtype=float)
    top_height = _top_height(float(f[-1]), end, 0.0, wall=shape.rim <= end)
    stretch = HEIGHT_TO_RADIUS * end / top_height
    return _with_scale_bars(_body_marks(r / end, f * stretch / end, HEIGHT_TO_RADIUS), end, stretch)


def contact_panel(solution: Restorable, extent: float) -> Panel:
    """Return the body of a contact, cut open, in the deformed surface; the pressure is painted on the surface.

    Parameters
    ----------
    solution
        For one load.
    extent : float
        Drawn radius [m].
    """
    pressed = solution.pressed
    end = min(extent, outline_end(pressed.bed))
    r = _rings(end, pressed)
    f = np.asarray(pressed.bed.height(r), dtype=float) - pressed.depth
    top_height = _top_height(float(f[-1] - f[0]), end, abs(pressed.depth), wall=pressed.bed.rim <= end) + float(f[0])
    ground = np.unique(np.concatenate([_rings(extent, pressed), [pressed.radius]]))
    stretch = HEIGHT_TO_RADIUS * end / (top_height - min(float(f[0]), 0.0))
    scaled = stretch / extent
    marks: list[Any] = [
        _painted(_surface_facets(ground / extent, -sunk(pressed, ground) * scaled, _tint(solution, ground)), 2.0)
    ]
    circles = [(float(radius), style.MUTED, 0.5) for radius in np.linspace(0.0, extent, 7)[1:]]
    circles += [(pressed.radius, style.RED, 1.5)] if pressed.radius > 0.0 else []
    if 0.0 < pressed.touching < pressed.radius:  # ring of attraction
        circles.append((pressed.touching, style.RED, 0.8))
    for radius, colour, width in circles:
        level = -float(sunk(pressed, np.array([radius]))[0])
        marks.append(_ring(radius / extent, level * scaled, colour, width))
    return _with_scale_bars([*marks, *_body_marks(r / extent, f * scaled, top_height * scaled)], extent, stretch)


def _top_height(rise: float, radius: float, depth: float, *, wall: bool) -> float:
    """Return the height above the apex at which the body is cut off [m]."""
    if not wall and rise > 0.0:
        return max(1.12 * rise, 1.3 * depth)
    return max(1.6 * rise, rise + 4.0 * depth) or HEIGHT_TO_RADIUS * radius


def _rings(end: float, pressed: PressedSprings) -> Array:
    marks = [b for b in (*(b for b, _ in pressed.bed.kinks), pressed.radius) if 0.0 < b < end]
    return np.unique(np.concatenate([np.linspace(0.0, end, RINGS + 1), marks]))


def _tint(solution: Restorable, ground: Array) -> Array:
    """Return the colour of every ring of the surface: the pressure within the contact, else that of the solid."""
    middle = 0.5 * (ground[1:] + ground[:-1])
    pressure = restore(solution, middle).pressure
    colours = np.tile(style.channels(style.SOLID), (middle.size, 1))
    in_contact = middle < solution.pressed.radius
    if in_contact.any():
        share = np.clip(pressure[in_contact] / (2.0 * float(np.median(np.abs(pressure[in_contact])))), -1.0, 1.0)
        colours[in_contact] = np.stack([style.channels(style.pressure_colour(float(one))) for one in share])
    return colours


def _revolved(r: Array, z: Array, turns: Array, normal_sign: float, colour: Callable[[int], Array]) -> ShadedFacets:
    """Return the facets of a curve (r, z) revolved about the axis through the angles `turns`."""
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
    return ShadedFacets(corners, normals, np.stack([colour(int(i)) for i in range(r.size - 1)])[ring])


def _surface_facets(r: Array, z: Array, tint: Array) -> ShadedFacets:
    turns = np.linspace(0.5 * np.pi, 2.5 * np.pi, SECTORS + 1)
    facets = _revolved(r, z, turns, 1.0, lambda ring: tint[ring])
    order = np.argsort(-np.mean(facets.corners[:, :, 1], axis=1))
    return ShadedFacets(facets.corners[order], facets.normals[order], facets.colours[order])


def _body_marks(r: Array, z: Array, top_height: float) -> list[Any]:
    """Return a body with the outline z(r), closed at `top_height`, with a sector cut out towards the reader."""
    steel = style.channels(style.BODY)
    turns = np.linspace(HALF_CUT_ANGLE, 2.0 * np.pi - HALF_CUT_ANGLE, SECTORS + 1) - 0.5 * np.pi
    shell = _revolved(r, z, turns, -1.0, lambda _: steel)
    wall = _revolved(np.full(9, r[-1]), np.linspace(z[-1], top_height, 9), turns, -1.0, lambda _: steel)
    parts = ShadedFacets(*(np.concatenate(pair) for pair in zip(shell, wall, strict=True)))
    order = np.argsort(parts.corners.mean(axis=1) @ VIEW_DIRECTION)
    marks: list[Any] = [_painted(ShadedFacets(*(part[order] for part in parts)), 3.0)]
    rim = np.concatenate([[0.0], np.full(turns.size, r[-1])])
    turned = np.concatenate([[0.0], turns])
    top = np.stack([rim * np.cos(turned), rim * np.sin(turned), np.full(rim.shape, top_height)], axis=-1)
    marks.append(_plane(top, np.array([0.0, 0.0, 1.0]), style.BODY))
    for turn, side in ((turns[0], 1.0), (turns[-1], -1.0)):
        across, up = np.concatenate([r, [r[-1], 0.0]]), np.concatenate([z, [top_height, top_height]])
        face = np.stack([across * np.cos(turn), across * np.sin(turn), up], axis=-1)
        marks.append(_plane(face, side * np.array([math.sin(turn), -math.cos(turn), 0.0]), CUT_COLOUR))
    return marks


def _plane(corners: Array, normal: Array, colour: str) -> Polygon:
    """Return one plane polygon in its shade."""
    shaded = style.channels(colour) * _brightness(normal)
    return Polygon(
        *_projected(corners), tuple(shaded.tolist()), edge=tuple((0.8 * shaded).tolist()), width=0.6, order=3.5
    )


def _ring(radius: float, level: float, colour: str, width: float) -> Line:
    """Return a circle on the surface, partly hidden by the body."""
    turn = np.linspace(0.0, 2.0 * np.pi, 241)
    circle = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full(turn.shape, level)], axis=-1)
    return Line(*_projected(circle), colour, width=width, order=2.5)


def _brightness(normal: Array) -> Array:
    return np.asarray(0.62 + 0.38 * np.clip(normal @ (LIGHT / np.linalg.norm(LIGHT)), 0.0, 1.0))


def _projected(points: Array) -> tuple[Array, Array]:
    """Return the projection of points (..., 3) onto the plane of the picture."""
    return points[..., 0], points[..., 2] * math.cos(ELEVATION) + points[..., 1] * math.sin(ELEVATION)


def _painted(scene: ShadedFacets, order: float) -> Facets:
    """Return the facets that face the reader, in their order."""
    visible = scene.normals @ VIEW_DIRECTION > 1e-9
    corners, normals, colours = (part[visible] for part in scene)
    shaded = np.clip(colours * _brightness(normals)[:, None], 0.0, 1.0)
    return Facets(np.stack(_projected(corners), axis=-1), shaded, order)


def _with_scale_bars(marks: list[Any], extent: float, stretch: float) -> Panel:
    """Return a panel without a frame, with scale bars."""
    heights = [mark.corners[..., 1] if isinstance(mark, Facets) else mark.y for mark in marks]
    top = min(float(np.min(part)) for part in heights if part.size) - 0.07
    width, height = _round(0.5 * extent), _round(0.32 * extent / stretch)
    line: Any = {"colour": style.INK, "width": 1.1, "order": 6.0, "clipped": False, "blunt": True}
    bar_height = height * stretch / extent * math.cos(ELEVATION)
    level = top - 0.5 * bar_height
    text = with_unit(height, "m")
    if abs(stretch - 1.0) > 0.01:
        text += f"  (heights × {float(f'{stretch:.2g}'):g})"
    bars = (
        Line(np.array([-1.0, -1.0 + width / extent]), np.full(2, level), **line),
        Text(-1.0 + 0.5 * width / extent, level - 0.04, with_unit(width, "m"), upright="top"),
        Line(np.full(2, 0.3), np.array([top - bar_height, top]), **line),
        Text(0.34, level, text, across="left"),
    )
    upright = PanelAxis(low=min(top - bar_height, level - 0.2))
    return Panel((*marks, *bars), PanelAxis(low=-1.08, high=1.12), upright, equal=True, bare=True)


def _round(length: float) -> float:
    """Return the greatest 1, 2 or 5 times a power of ten that is not above `length`."""
    power = 10.0 ** math.floor(math.log10(length))
    return float(f"{max(step for step in (1.0, 2.0, 5.0) if step * power <= length * (1 + 1e-9)) * power:.6g}")
