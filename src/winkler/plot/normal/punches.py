"""Jaeger's construction: the staircase of flat punches, and the superposition of their pressures."""

from __future__ import annotations

import numpy as np

from winkler.fields.punch_staircase import Staircase
from winkler.fields.restoration import restore
from winkler.plot import style
from winkler.plot.panel import Line, Panel, PanelAxis, Polygon, Rule
from winkler.plot.series import places, scale_of, series

WIDTH_WITH_NAMES = 1.7
"""Width of the panel of pressures over what is drawn in it."""


class _StaircaseContact:
    """A staircase as the argument of `restore`."""

    def __init__(self, staircase: Staircase) -> None:
        self.pressed = staircase.pressed


def steps_panel(staircase: Staircase, extent: float) -> Panel:
    """Return the punches as slabs under the plane profile that they approximate.

    Parameters
    ----------
    staircase : Staircase
    extent : float
        Drawn up to this x on both sides [m].
    """
    pressed = staircase.pressed
    below = np.cumsum(staircase.increments[::-1])[::-1]
    marks: list[Line | Polygon | Rule] = []
    for radius, thick, bottom, colour in zip(
        staircase.radii, staircase.increments, below, _colours(staircase), strict=True
    ):
        x = radius * np.array([-1.0, 1.0, 1.0, -1.0])
        y = np.array([-bottom, -bottom, thick - bottom, thick - bottom])
        marks.append(Polygon(x, y, colour, edge="white", width=0.8, order=3.0))
    x = np.concatenate([[0.0], places(pressed.radius, tuple(b for b, _ in pressed.kinks)), [pressed.radius]])
    shape = np.asarray(pressed.bed.gap(x), dtype=float) - pressed.depth
    if pressed.edge > 0.0:
        x, shape = np.append(x, pressed.radius), np.append(shape, 0.0)
    marks.append(Line(*style.mirrored(x, shape), style.INK, width=1.6, order=5.0, name="$g(x) − d$"))
    marks.append(Rule(0.0, dash=style.DASHED, order=1.0))
    across = PanelAxis.of(series("x", x), scale_of("m", [extent]), low=-extent, high=extent)
    upright = PanelAxis("height", scale_of("m", [pressed.depth]), low=-1.08 * pressed.depth, high=0.32 * pressed.depth)
    return Panel(tuple(marks), across, upright, grid="", legend="upper right", columns=2, unframed=True)


def pressures_panel(staircase: Staircase, extent: float) -> Panel:
    """Return the pressure of every punch, their sum, and the pressure of the contact itself.

    Parameters
    ----------
    staircase : Staircase
    extent : float
        Drawn up to this distance from the axis [m].
    """
    r = places(extent, tuple(staircase.radii), count=600)
    exact = restore(_StaircaseContact(staircase), r).pressure
    middle = exact[np.isfinite(exact) & (exact > 0.0)]
    top = 1.9 * float(np.percentile(middle, 90.0)) if middle.size else 1.0
    marks = []
    for radius, increment, colour in zip(staircase.radii, staircase.increments, _colours(staircase), strict=True):
        inside = r[r < radius]
        own = staircase.modulus * increment / (np.pi * np.sqrt((radius - inside) * (radius + inside)))
        marks.append(Line(inside, own, colour, width=1.1, order=3.0))
    name = f"sum of {staircase.radii.size} punches" if staircase.radii.size > 1 else "one punch"
    marks.append(Line(r, staircase.pressure(r), style.RED, width=1.1, order=4.0, name=name))
    marks.append(Line(r, exact, style.INK, width=2.0, dash=style.DASHES[1], order=5.0, name="infinitely many"))
    wide = WIDTH_WITH_NAMES * extent  # beside the rims, which reach to the upper end
    across = PanelAxis.of(series("r", r), scale_of("m", [extent]), low=0.0, high=wide)
    upright = PanelAxis.of(series("pressure", exact), scale_of("Pa", [top]), low=0.0, high=top)
    return Panel(tuple(marks), across, upright, legend="upper right")


def _colours(staircase: Staircase) -> list[tuple[str, float]]:
    """Return one colour for every punch, from the narrowest to the widest."""
    return [style.shade(float(tone)) for tone in np.linspace(0.9, 0.25, staircase.radii.size)]
