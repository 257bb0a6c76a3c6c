"""The picture of the method: a row of springs under the equivalent plane profile."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, Pressed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import solid_until
from winkler.plot.medium import OFF_AXIS, is_varied
from winkler.plot.panel import Area, Arrow, Axis, Line, Panel, Rule, Strokes, Text, note
from winkler.plot.series import Series, places, round_numbers, scale_of, series

__all__ = [
    "Frame",
    "Row",
    "at_first_touch",
    "plane_profile",
    "row_panel",
    "spring_places",
    "springs_panel",
    "stretched",
]

COILS = 9
SPRINGS = 33
"""How many springs are drawn; the method itself has no such number."""
SEEN = 1e-6
"""Part of the greatest displacement below which a spring is neither pressed nor stretched, but rounded."""
GROUND = 0.16
"""Thickness of what the springs stand on, in the unit of the frame."""


class Frame(NamedTuple):
    """What the picture of a row of springs shows.

    Parameters
    ----------
    extent
        x at the right end [m].
    unit
        A height that is typical of what happens [m].
    bottom, top
        Where the springs stand, and where the picture ends above, relative to the free surface [m].
    """

    extent: float
    unit: float
    bottom: float
    top: float


class Row(NamedTuple):
    """Springs as they are seen.

    Parameters
    ----------
    place
        x [m].
    sunk
        How far each is pressed [m]; negative: stretched.
    aside
        How far the head of each stands beside its foot [m], as drawn.
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


def plane_profile(bed: Bed, end: float) -> tuple[Series, Series]:
    """Return x and g(x) from the axis to `end` [m], or to where the bed is known.

    Parameters
    ----------
    bed : Bed
    end : float
        [m].
    """
    end = min(end, solid_until(bed))
    inner = places(end, tuple(b for b, _ in bed.kinks))
    x = np.concatenate([[0.0], inner, [end]])
    g = np.asarray(bed.gap(x), dtype=float)
    known = np.isfinite(g)
    return series("x", x[known]), series("gap", g[known])


def spring_places(extent: float) -> Array:
    """Return where springs are drawn [m]."""
    return (np.arange(SPRINGS) - 0.5 * (SPRINGS - 1)) * 2.0 * extent / SPRINGS


def springs_panel(pressed: Pressed, extent: float, frame: Frame | None = None) -> Panel:
    """Return the springs, compressed where the plane profile has come down on them.

    Parameters
    ----------
    pressed : Pressed
        Bed, depth and contact radius; depth zero shows the bed at first touch.
    extent : float
        Drawn up to this x on both sides [m].
    frame : Frame, optional
        What is shown, where it must not depend on this contact alone.
    """
    _, g = plane_profile(pressed.bed, extent)
    drop, pull = max(pressed.depth, 0.0), _pull(pressed)
    moved = max(drop, pull)
    rise = float(np.max(g.content)) if g.content.size else 0.0
    if frame is None:
        unit = max(moved, 0.45 * min(rise, 4.0 * moved) if moved > 0.0 else rise, 1e-3 * extent if rise == 0.0 else 0.0)
        top = min(1.05 * max(rise - pressed.depth, 0.0), 2.2 * unit) + (0.55 * unit if rise <= drop else 0.0)
        frame = Frame(extent, unit, (-2.3 if moved > 0.0 else -1.2) * unit, top)
    marks: list[Any] = []
    if _uneven(pressed.bed, extent):
        marks.append(note("thicker springs are stiffer", "upper left"))
    if pull > 0.0:
        marks.append(note("blue springs pull", "lower left"))
    if pressed.radius > 0.0:
        marks += _dimensions(pressed, frame.bottom)
    panel = row_panel(_pressed_row(pressed, extent), pressed.bed, pressed.depth, frame)
    factor = panel.upright.scale.factor
    ticks = factor * round_numbers(-drop / factor, frame.top / factor, 5)
    kept = ticks[(ticks >= -1.02 * drop) & (ticks <= frame.top)]
    return panel.plus(*marks, upright=dataclasses.replace(panel.upright, ticks=kept))


def row_panel(row: Row, bed: Bed | None, depth: float, frame: Frame, shift: float = 0.0) -> Panel:
    """Return springs on their ground, and the plane profile that came down on them.

    Parameters
    ----------
    row : Row
    bed : Bed, optional
        Whose plane profile is drawn.
    depth : float
        d [m].
    frame : Frame
    shift : float, optional
        How far the body is drawn beside its place [m].
    """
    extent, unit, bottom, top = frame
    ends, thick = np.array([-extent, extent]), GROUND * unit
    marks: list[Any] = [
        Area(ends, bottom, bottom - thick, style.SOLID, 1.0, hatch="////"),
        Line(ends, np.full(2, bottom), style.INK, width=1.0),
        _coils(row, bottom),
    ]
    if bed is not None:
        x, g = plane_profile(bed, extent)
        both, lower = style.mirrored(*_below(x.content, g.content - depth, top, wall=bed.rim))
        marks.append(Area(both + shift, lower, top, style.BODY, 0.75, order=4.0))
        marks.append(Line(both + shift, lower, width=2.0, order=5.0))
    marks.append(Rule(0.0, dash=style.DASHED, order=1.0))
    across = Axis.of(series("x", ends), low=-extent, high=extent)
    upright = Axis("height", scale_of("m", [unit]), low=bottom - thick, high=top)
    return Panel(tuple(marks), across, upright, grid="")


def _below(x: Array, lower: Array, top: float, wall: float) -> tuple[Array, Array]:
    """Return the part of a profile that is seen below the upper end of the picture."""
    keep = lower <= top
    if not keep.any():
        return x, np.full(x.shape, top)
    if not keep.all():
        last = int(np.argmin(keep))
        crossing = np.interp(top, lower[last - 1 : last + 1], x[last - 1 : last + 1])
        return np.append(x[:last], crossing), np.append(lower[:last], top)
    return (np.append(x, x[-1]), np.append(lower, top)) if wall <= x[-1] * (1.0 + 1e-12) else (x, lower)


def _coils(row: Row, bottom: float) -> Strokes:
    """Return zigzags from the ground to the heads of the springs, each of which stands `aside` of its foot."""
    rungs = np.concatenate([[0.0, 0.1], 0.1 + 0.8 * (np.arange(2 * COILS) + 0.5) / (2 * COILS), [0.9, 1.0]])
    side = np.concatenate([[0.0, 0.0], np.where(np.arange(2 * COILS) % 2 == 0, 1.0, -1.0), [0.0, 0.0]])
    wide = 0.32 * (row.place[1] - row.place[0])
    x = row.place[:, None] + row.aside[:, None] * rungs + wide * side
    return Strokes(x, bottom + rungs * (-row.sunk - bottom)[:, None], row.colours, row.width, row.strength)


def _pressed_row(pressed: Pressed, extent: float) -> Row:
    x = spring_places(extent)
    place = np.abs(x)
    touched = (place <= pressed.radius) & (pressed.radius > 0.0)
    sunk = np.zeros(x.shape)
    sunk[touched] = pressed.value(place[touched])
    most = max(float(np.max(np.abs(sunk))), 1e-300)
    pulls = stretched(sunk)
    colours = [
        (style.BLUE if pull else style.RED) if hit else style.MUTED for pull, hit in zip(pulls, touched, strict=True)
    ]
    strength = 0.55 + 0.45 * np.abs(sunk) / most
    return Row(x, sunk, np.zeros(x.shape), tuple(colours), _thickness(pressed.bed, place), strength)


def _pull(pressed: Pressed) -> float:
    """Return how far springs are stretched at most [m]; zero where none is by more than rounding."""
    if pressed.radius == 0.0:
        return 0.0
    x = np.append(places(pressed.radius, (*(b for b, _ in pressed.kinks), pressed.touching)), pressed.radius)
    moved = np.asarray(pressed.value(x))
    return -float(np.min(moved)) if np.any(stretched(moved)) else 0.0


def stretched(moved: Array) -> Array:
    """Return which springs pull: those that are stretched by more than rounding beside the one that moves most.

    Parameters
    ----------
    moved : ndarray
        How far springs are pressed [m], negative where they are stretched.
    """
    return np.asarray(moved < -SEEN * float(np.max(np.abs(moved))))


def _thickness(bed: Bed, place: Array) -> Array:
    """Return how thick springs are drawn: all alike, or by their stiffness where it varies."""
    beside = np.clip(place, OFF_AXIS * np.max(place), bed.reach)
    stiffness = np.asarray(bed.normal_stiffness(beside), dtype=float)
    if not is_varied(stiffness):
        return np.ones(place.shape)
    rest = np.max(np.delete(stiffness, np.argmin(place)))  # that in the middle may be without bounds
    return np.asarray(0.45 + 1.35 * np.minimum(stiffness / rest, 1.0))


def _uneven(bed: Bed, extent: float) -> bool:
    return is_varied(np.asarray(bed.normal_stiffness(min(extent, bed.reach) * np.linspace(0.1, 1.0, 9)), dtype=float))


def _dimensions(pressed: Pressed, bottom: float) -> list[Any]:
    """Return the contact radius, that of a ring which is pulled, and the depth, as they are marked."""
    a, d, outer = pressed.touching, float(pressed.depth), pressed.radius
    level, edge = 0.86 * bottom, -float(pressed.edge)
    look: dict[str, Any] = {"colour": style.INK, "width": 0.9, "both": True, "order": 7.0}
    box: dict[str, Any] = {"size": 9.0, "boxed": 0.85, "pad": 1.2}
    marks: list[Any] = [
        Line(np.full(2, side), np.array([edge, bottom]), style.INK, width=0.8, dash=style.DOTTED, order=6.0)
        for side in (-outer, outer)
    ]
    marks += [Arrow((0.0, level), (a, level), **look), Text(0.5 * a, level, "$a$", **box)]
    if a < outer:  # a ring around the contact is pulled
        marks += [Arrow((0.0, level), (-outer, level), **look), Text(-0.5 * outer, level, "$c$", **box)]
    marks += [Arrow((0.0, 0.0), (0.0, -d), **look), Text(0.05 * a, -0.45 * d, "$d$", across="left", size=9.0)]
    return marks


def at_first_touch(bed: Bed) -> Pressed:
    """Return a bed on which nothing is pressed yet."""
    return Pressed(bed, 0.0, 0.0)
