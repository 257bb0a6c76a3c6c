"""The picture of the method for sheared contacts: springs that are pressed down and dragged sideways."""

from __future__ import annotations

import numpy as np

from winkler.foundation.sheared import ShearedSprings
from winkler.plot import style
from winkler.plot.normal.springs import DrawnSprings, SpringFrame, row_panel, spring_places
from winkler.plot.panel import Line, Panel, note

NOTHING = np.empty(0)


def dragged_panel(sheared: ShearedSprings, stick: float, extent: float, frame: SpringFrame | None = None) -> Panel:
    """Return the springs under the plane profile, leaning as far as they are stretched; in the plane along x.

    Parameters
    ----------
    sheared : ShearedSprings
        Of a contact.
    stick : float
        Radius of the part that sticks [m].
    extent : float
        [m].
    frame : Frame, optional
        Fixed frame, for animations.
    """
    pressed = sheared.pressed
    place = spring_places(extent)
    touching = (np.abs(place) <= pressed.radius) & (pressed.radius > 0.0)
    aside, sunk = np.zeros(place.shape), np.zeros(place.shape)
    for part in sheared.components[0]:
        within = np.abs(place) < part.radius
        aside[within] += part.value(np.abs(place[within]))
    greatest = float(np.max(np.abs(aside)))
    lean = (place[1] - place[0]) / greatest if greatest > 0.0 else 0.0  # lean of the most stretched spring
    sunk[touching] = pressed.value(np.abs(place[touching]))
    sticks = touching & (stick > 0.0) & (np.abs(place) <= stick)
    colours = [
        style.MUTED if not touches else style.GREEN if sticking else style.RED
        for touches, sticking in zip(touching, sticks, strict=True)
    ]
    strength = np.where(touching, 0.9, 0.5)
    springs = DrawnSprings(place, sunk, lean * aside, tuple(colours), np.full(place.shape, 1.1), strength)
    depth = float(pressed.depth)
    shift = float(np.clip(np.ravel(sheared.shift)[0], -greatest, greatest)) * lean
    panel = row_panel(
        springs, pressed.bed, depth, frame or SpringFrame(extent, depth, -2.4 * depth, 1.3 * depth), shift
    )
    names = (Line(NOTHING, NOTHING, style.GREEN, name="sticks"), Line(NOTHING, NOTHING, style.RED, name="slides"))
    magnification = (note(f"sideways {_round(lean)} times", "upper centre"),) if greatest > 0.0 else ()
    return panel.plus(*names, *magnification, legend="upper left")


def _round(number: float) -> str:
    """Return a magnification in two digits."""
    return f"{float(f'{number:.1e}'):,.0f}".replace(",", " ") if number >= 10.0 else f"{number:.2g}"
