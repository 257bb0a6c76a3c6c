"""The picture of the method: a row of springs under the equivalent plane profile."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import outline_end
from winkler.plot.medium import OFFSET_FROM_AXIS, is_varied
from winkler.plot.panel import Area, Arrow, Line, Panel, PanelAxis, Rule, Strokes, Text, note
from winkler.plot.series import Series, places, round_numbers, scale_of, series

COILS = 9
SPRINGS_DRAWN = 33
"""Number of drawn springs; the method itself is continuous."""
STRETCH_TOLERANCE = 1e-6
"""Relative displacement below which a stretch is rounding error."""
BASE_THICKNESS = 0.16
"""Thickness of the base of the springs, in the unit of the frame."""


class SpringFrame(NamedTuple):
    """Frame of the picture of a row of springs.

    Parameters
    ----------
    extent
        x at the right end [m].
    unit
        Characteristic height [m].
    bottom, top
        Lower end of the springs and upper end of the picture, relative to the free surface [m].
    """

    extent: float
    unit: float
    bottom: float
    top: float


class DrawnSprings(NamedTuple):
    """Drawn springs.

    Parameters
    ----------
    place
        x [m].
    sunk
        Compression of each [m]; negative: stretched.
    aside
        Lateral displacement of the head of each [m], as drawn.
    colours
        Of each.
    width, strength
        Of the lines.
    """

    place: Array
    sunk: Array
    aside: Array
    colours: tuple[str, ...]
    width: Array
    strength: Array


@np.errstate(divide="ignore", invalid="ignore")  # g is infinite at the equator of a ball
def plane_profile(bed: Bed, end: float) -> tuple[Series, Series]:
    """Return x and g(x) from the axis to `end` [m], or to the end of the bed.

    Parameters
    ----------
    bed : Bed
    end : float
        [m].
    """
    medium = getattr(bed, "medium", None)
    if offers(medium, RelaxingMedium) and not medium.in_proportion:
        # g changes in time; what the springs follow is the profile on one solid
        bed = dataclasses.replace(bed, medium=HalfSpace(medium.elastic.layers[0].solid))  # type: ignore[attr-defined, type-var]
    end = min(end, outline_end(bed))
    inner = places(end, tuple(b for b, _ in bed.kinks))
    x = np.concatenate([[0.0], inner, [end]])
    g = np.asarray(bed.gap(x), dtype=float)
    finite = np.isfinite(g)
    return series("x", x[finite]), series("gap", g[finite])


def spring_places(extent: float) -> Array:
    """Return the positions of the drawn springs [m]."""
    return (np.arange(SPRINGS_DRAWN) - 0.5 * (SPRINGS_DRAWN - 1)) * 2.0 * extent / SPRINGS_DRAWN


def springs_panel(pressed: PressedSprings, extent: float, frame: SpringFrame | None = None) -> Panel:
    """Return the springs compressed by the plane profile.

    Parameters
    ----------
    pressed : PressedSprings
        Bed, depth and contact radius; depth zero shows the bed at first touch.
    extent : float
        Drawn up to this x on both sides [m].
    frame : Frame, optional
        Fixed frame, for animations.
    """
    _, g = plane_profile(pressed.bed, extent)
    drop, pull = max(pressed.depth, 0.0), _greatest_stretch(pressed)
    displaced = max(drop, pull)
    rise = float(np.max(g.content)) if g.content.size else 0.0
    if frame is None:
        unit = max(
            displaced,
            0.45 * min(rise, 4.0 * displaced) if displaced > 0.0 else rise,
            1e-3 * extent if rise == 0.0 else 0.0,
        )
        top = min(1.05 * max(rise - pressed.depth, 0.0), 2.2 * unit) + (0.55 * unit if rise <= drop else 0.0)
        frame = SpringFrame(extent, unit, (-2.3 if displaced > 0.0 else -1.2) * unit, top)
    marks: list[Any] = []
    if _has_varied_stiffness(pressed.bed, extent):
        marks.append(note("thicker springs are stiffer", "upper left"))
    if pull > 0.0:
        marks.append(note("blue springs pull", "lower left"))
    if pressed.radius > 0.0:
        marks += _dimensions(pressed, frame.bottom)
    panel = row_panel(_spring_row(pressed, extent), pressed.bed, pressed.depth, frame)
    factor = panel.upright.scale.factor
    ticks = factor * round_numbers(-drop / factor, frame.top / factor, 5)
    visible_ticks = ticks[(ticks >= -1.02 * drop) & (ticks <= frame.top)]
    return panel.plus(*marks, upright=dataclasses.replace(panel.upright, ticks=visible_ticks))


def row_panel(row: DrawnSprings, bed: Bed | None, depth: float, frame: SpringFrame, shift: float = 0.0) -> Panel:
    """Return springs on their base, and the plane profile above them.

    Parameters
    ----------
    row : Row
    bed : Bed, optional
        Its plane profile is drawn.
    depth : float
        d [m].
    frame : Frame
    shift : float, optional
        Lateral shift of the drawn body [m].
    """
    extent, unit, bottom, top = frame
    ends, thick = np.array([-extent, extent]), BASE_THICKNESS * unit
    marks: list[Any] = [
        Area(ends, bottom, bottom - thick, style.SOLID, 1.0, hatch="////"),
        Line(ends, np.full(2, bottom), style.INK, width=1.0),
        _spring_lines(row, bottom),
    ]
    if bed is not None:
        x, g = plane_profile(bed, extent)
        both, lower = style.mirrored(*_visible_part(x.content, g.content - depth, top, wall=bed.rim))
        marks.append(Area(both + shift, lower, top, style.BODY, 0.75, order=4.0))
        marks.append(Line(both + shift, lower, width=2.0, order=5.0))
    marks.append(Rule(0.0, dash=style.DASHED, order=1.0))
    across = PanelAxis.of(series("x", ends), low=-extent, high=extent)
    upright = PanelAxis("height", scale_of("m", [unit]), low=bottom - thick, high=top)
    return Panel(tuple(marks), across, upright, grid="")


def _visible_part(x: Array, lower: Array, top: float, wall: float) -> tuple[Array, Array]:
    """Return the part of a profile below the upper end of the picture."""
    visible = lower <= top
    if not visible.any():
        return x, np.full(x.shape, top)
    if not visible.all():
        last = int(np.argmin(visible))
        crossing = np.interp(top, lower[last - 1 : last + 1], x[last - 1 : last + 1])
        return np.append(x[:last], crossing), np.append(lower[:last], top)
    return (np.append(x, x[-1]), np.append(lower, top)) if wall <= x[-1] * (1.0 + 1e-12) else (x, lower)


def _spring_lines(row: DrawnSprings, bottom: float) -> Strokes:
    """Return zigzags from the ground to the heads of the springs, each of which stands `aside` of its foot."""
    heights = np.concatenate([[0.0, 0.1], 0.1 + 0.8 * (np.arange(2 * COILS) + 0.5) / (2 * COILS), [0.9, 1.0]])
    side = np.concatenate([[0.0, 0.0], np.where(np.arange(2 * COILS) % 2 == 0, 1.0, -1.0), [0.0, 0.0]])
    wide = 0.32 * (row.place[1] - row.place[0])
    x = row.place[:, None] + row.aside[:, None] * heights + wide * side
    return Strokes(x, bottom + heights * (-row.sunk - bottom)[:, None], row.colours, row.width, row.strength)


def _spring_row(pressed: PressedSprings, extent: float) -> DrawnSprings:
    x = spring_places(extent)
    place = np.abs(x)
    in_contact = (place <= pressed.radius) & (pressed.radius > 0.0)
    sunk = np.zeros(x.shape)
    sunk[in_contact] = pressed.value(place[in_contact])
    greatest = max(float(np.max(np.abs(sunk))), 1e-300)
    is_stretched = stretched(sunk)
    colours = [
        (style.BLUE if pull else style.RED) if pressed_down else style.MUTED
        for pull, pressed_down in zip(is_stretched, in_contact, strict=True)
    ]
    strength = 0.55 + 0.45 * np.abs(sunk) / greatest
    return DrawnSprings(x, sunk, np.zeros(x.shape), tuple(colours), _thickness(pressed.bed, place), strength)


def _greatest_stretch(pressed: PressedSprings) -> float:
    """Return the greatest stretch of the springs [m]; zero within rounding."""
    if pressed.radius == 0.0:
        return 0.0
    x = np.append(places(pressed.radius, (*(b for b, _ in pressed.kinks), pressed.touching)), pressed.radius)
    displaced = np.asarray(pressed.value(x))
    return -float(np.min(displaced)) if np.any(stretched(displaced)) else 0.0


def stretched(displaced: Array) -> Array:
    """Return which springs are stretched by more than rounding.

    Parameters
    ----------
    displaced : ndarray
        Compression of springs [m], negative where they are stretched.
    """
    return np.asarray(displaced < -STRETCH_TOLERANCE * float(np.max(np.abs(displaced))))


def _thickness(bed: Bed, place: Array) -> Array:
    """Return the line widths of springs: equal, or by their stiffness where it varies."""
    beside = np.clip(place, OFFSET_FROM_AXIS * np.max(place), bed.reach)
    stiffness = np.asarray(bed.normal_stiffness(beside), dtype=float)
    if not is_varied(stiffness):
        return np.ones(place.shape)
    greatest_elsewhere = np.max(np.delete(stiffness, np.argmin(place)))  # the stiffness in the middle may be infinite
    return np.asarray(0.45 + 1.35 * np.minimum(stiffness / greatest_elsewhere, 1.0))


def _has_varied_stiffness(bed: Bed, extent: float) -> bool:
    return is_varied(np.asarray(bed.normal_stiffness(min(extent, bed.reach) * np.linspace(0.1, 1.0, 9)), dtype=float))


def _dimensions(pressed: PressedSprings, bottom: float) -> list[Any]:
    """Return the dimension lines of contact radius, radius of attraction, and depth."""
    a, d, outer = pressed.touching, float(pressed.depth), pressed.radius
    level, edge = 0.86 * bottom, -float(pressed.edge)
    look: dict[str, Any] = {"colour": style.INK, "width": 0.9, "both": True, "order": 7.0}
    box: dict[str, Any] = {"size": 9.0, "boxed": 0.85, "pad": 1.2}
    marks: list[Any] = [
        Line(np.full(2, side), np.array([edge, bottom]), style.INK, width=0.8, dash=style.DOTTED, order=6.0)
        for side in (-outer, outer)
    ]
    marks += [Arrow((0.0, level), (a, level), **look), Text(0.5 * a, level, "$a$", **box)]
    if a < outer:  # ring of attraction
        marks += [Arrow((0.0, level), (-outer, level), **look), Text(-0.5 * outer, level, "$c$", **box)]
    marks += [Arrow((0.0, 0.0), (0.0, -d), **look), Text(0.05 * a, -0.45 * d, "$d$", across="left", size=9.0)]
    return marks


def at_first_touch(bed: Bed) -> PressedSprings:
    """Return a bed at first touch, without load."""
    return PressedSprings(bed, 0.0, 0.0)
