"""Jaeger's picture drawn: the staircase of flat punches, and the pressures that add up."""

from __future__ import annotations

import numpy as np

from winkler.fields import restore
from winkler.plot import style
from winkler.plot.panel import Axis, Line, Panel, Polygon, Rule
from winkler.plot.series import places, scale_of, series
from winkler.stairs import Staircase

__all__ = ["pressures_panel", "steps_panel"]


class _Contact:
    """What `restore` needs of a solution."""

    def __init__(self, stairs: Staircase) -> None:
        self.pressed = stairs.pressed


def steps_panel(stairs: Staircase, extent: float) -> Panel:
    """Return the punches as slabs under the plane profile that they approach.

    Parameters
    ----------
    stairs : Staircase
    extent : float
        Drawn up to this x on both sides [m].
    """
    pressed = stairs.pressed
    below = np.cumsum(stairs.increments[::-1])[::-1]
    marks: list[Line | Polygon | Rule] = []
    for radius, thick, bottom, colour in zip(stairs.radii, stairs.increments, below, _colours(stairs), strict=True):
        x = radius * np.array([-1.0, 1.0, 1.0, -1.0])
        y = np.array([-bottom, -bottom, thick - bottom, thick - bottom])
        marks.append(Polygon(x, y, colour, edge="white", width=0.8, order=3.0))
    x = np.concatenate([[0.0], places(pressed.radius, tuple(b for b, _ in pressed.kinks)), [pressed.radius]])
    shape = np.asarray(pressed.bed.gap(x), dtype=float) - pressed.depth
    if pressed.edge > 0.0:
        x, shape = np.append(x, pressed.radius), np.append(shape, 0.0)
    marks.append(Line(*style.mirrored(x, shape), style.INK, width=1.6, order=5.0, name="$g(x) − d$"))
    marks.append(Rule(0.0, dash=style.DASHED, order=1.0))
    across = Axis.of(series("x", x), scale_of("m", [extent]), low=-extent, high=extent)
    upright = Axis("height", scale_of("m", [pressed.depth]), low=-1.08 * pressed.depth, high=0.32 * pressed.depth)
    return Panel(tuple(marks), across, upright, grid="", legend="upper right", columns=2, unframed=True)


def pressures_panel(stairs: Staircase, extent: float) -> Panel:
    """Return the pressure of every punch, their sum, and the pressure of the contact itself.

    Parameters
    ----------
    stairs : Staircase
    extent : float
        Drawn up to this distance from the axis [m].
    """
    r = places(extent, tuple(stairs.radii), count=600)
    exact = restore(_Contact(stairs), r).pressure
    middle = exact[np.isfinite(exact) & (exact > 0.0)]
    top = 1.9 * float(np.percentile(middle, 90.0)) if middle.size else 1.0
    marks = []
    for radius, increment, colour in zip(stairs.radii, stairs.increments, _colours(stairs), strict=True):
        inside = r[r < radius]
        own = stairs.modulus * increment / (np.pi * np.sqrt((radius - inside) * (radius + inside)))
        marks.append(Line(inside, own, colour, width=1.1, order=3.0))
    name = f"sum of {stairs.radii.size} punches" if stairs.radii.size > 1 else "one punch"
    marks.append(Line(r, stairs.pressure(r), style.RED, width=1.1, order=4.0, name=name))
    marks.append(Line(r, exact, style.INK, width=2.0, dash=style.DASHES[1], order=5.0, name="infinitely many"))
    across = Axis.of(series("r", r), scale_of("m", [extent]), low=0.0, high=extent)
    upright = Axis.of(series("pressure", exact), scale_of("Pa", [top]), low=0.0, high=top)
    return Panel(tuple(marks), across, upright, legend="upper right")


def _colours(stairs: Staircase) -> list[tuple[str, float]]:
    """Return one colour for every punch, from the narrowest to the widest."""
    return [style.shade(float(tone)) for tone in np.linspace(0.9, 0.25, stairs.radii.size)]
