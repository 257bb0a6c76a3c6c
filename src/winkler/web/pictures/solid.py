"""The body in three dimensions, cut open, in its dent: the curves that the browser revolves about the axis.

Both are bodies of revolution, so that two curves suffice; ``solid.js`` draws and rotates them.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.fields.restoration import restore
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import outline_end, sunk
from winkler.plot.series import with_unit
from winkler.web.pictures.chart import Chart
from winkler.web.pictures.view import View

RINGS, SECTORS = 18, 24
"""Radial steps, and angular steps of both the cut and the remaining sector."""
HALF_CUT_ANGLE = math.radians(80.0)
"""Half of the sector that is cut out of the body, towards the reader."""
HEIGHT_TO_WIDTH = 0.55
"""Height of the picture in its widths."""
SURFACE_COLOURS = ((0.0, "#a50f15"), (0.49, "#fcae91"), (0.495, style.SOLID), (0.505, style.SOLID), (0.51, "#e2e418"),
        (0.7, "#5ec962"), (0.85, "#21918c"), (1.0, "#3b528b"))  # fmt: skip
"""Colours from tension over zero to pressure."""
BODY_COLOURS = ("#66788c", "#cdd8e3")
"""Of the body: away from the light, and towards it."""


def draw_solid(contact: Any, view: View) -> Chart:
    """Return the body of a contact in the deformed surface; the pressure is painted on the surface.

    Lengths are in halves of the picture's width; heights are stretched so that it is `HEIGHT_TO_WIDTH` times as high.

    Parameters
    ----------
    contact
        For one load.
    view
        The frame.
    """
    pressed = contact.pressed
    a, half_width = float(pressed.radius), view.extent
    lid = max(1.7 * view.sunk, float(pressed.bed.height(np.zeros(1))[0]) - float(pressed.depth))
    ground = np.unique(np.append(np.linspace(0.0, half_width, RINGS + 1), [0.985 * a, a, min(1.02 * a, half_width)]))
    level = -sunk(pressed, ground)
    low = min(float(np.min(level)), -1.2 * view.sunk)
    stretch = 2.0 * HEIGHT_TO_WIDTH / (lid - low)
    r, f = _outline(pressed, view, lid)
    edge = stretch * (float(np.interp(a, ground, level)) - low)
    note = f"{with_unit(2.0 * half_width, 'm', 3)} across, heights × {float(f'{stretch * half_width:.2g}'):g}"
    data = {
        "ground": {
            "r": ground / half_width,
            "z": stretch * (level - low),
            "colours": _painted(contact, ground, half_width),
        },
        "body": {
            "r": r / half_width,
            "z": stretch * (f - low),
            "lid": 2.0 * HEIGHT_TO_WIDTH,
            "colours": list(BODY_COLOURS),
            "cut": HALF_CUT_ANGLE,
        },
        "edge": {"radius": a / half_width, "level": edge, "colour": style.RED},
        "sectors": SECTORS,
        "tall": 2.0 * HEIGHT_TO_WIDTH,
        "note": note,
    }
    return {"data": data}


def _outline(pressed: Any, view: View, lid: float) -> tuple[Array, Array]:
    """Return the outline of the body up to a lid."""
    end = min(view.extent, outline_end(pressed.bed))
    r = np.unique(np.append(np.linspace(0.0, end, RINGS + 1), [b for b, _ in pressed.bed.kinks if b < end]))
    f = np.asarray(pressed.bed.height(r), dtype=float) - float(pressed.depth)
    above = np.flatnonzero(f > lid)
    if above.size and above[0] > 0:  # it is cut at the upper end of the picture
        last = above[0]
        out = float(np.interp(lid, f[last - 1 : last + 1], r[last - 1 : last + 1]))
        return np.append(r[:last], out), np.append(f[:last], lid)
    return np.append(r, r[-1]), np.append(f, lid)


def _painted(contact: Any, ground: Array, half_width: float) -> list[str]:
    """Return the colour of every ring of the ground: the darker, the higher the pressure on it."""
    a, middle = float(contact.pressed.radius), 0.5 * (ground[1:] + ground[:-1])
    pressure = np.asarray(restore(contact, np.maximum(middle, 1e-6 * half_width)).pressure, dtype=float)
    inside = np.abs(pressure[(middle < a) & np.isfinite(pressure)])
    typical = 2.0 * float(np.median(inside)) if inside.size else 0.0
    if typical == 0.0:
        return [style.SOLID] * middle.size
    tint = np.where(middle < a, np.clip(np.nan_to_num(pressure / typical, posinf=1.0, neginf=-1.0), -1.0, 1.0), 0.0)
    places, stops = (
        np.array([place for place, _ in SURFACE_COLOURS]),
        np.array([_channels(colour) for _, colour in SURFACE_COLOURS]),
    )
    mixed = np.stack([np.interp(0.5 * (1.0 + tint), places, channel) for channel in stops.T], axis=-1)
    return [f"rgb({red:.0f},{green:.0f},{blue:.0f})" for red, green, blue in mixed]


def _channels(colour: str) -> list[int]:
    """Return red, green and blue of ``#rrggbb``."""
    return [int(colour[place : place + 2], 16) for place in (1, 3, 5)]
