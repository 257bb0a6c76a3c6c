"""Jaeger's picture drawn: the staircase of flat punches, and the pressures that add up."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.fields import restore
from winkler.plot import style
from winkler.plot.series import places, scale_of, series
from winkler.stairs import Staircase

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_pressures", "draw_steps"]


class _Contact:
    """What `restore` needs of a solution."""

    def __init__(self, stairs: Staircase) -> None:
        self.pressed = stairs.pressed


def draw_steps(axes: Axes, stairs: Staircase, extent: float) -> None:
    """Draw the punches as slabs under the plane profile that they approach.

    Parameters
    ----------
    axes : Axes
        Empty.
    stairs : Staircase
    extent : float
        Drawn up to this x on both sides [m].
    """
    from matplotlib.patches import Rectangle

    pressed = stairs.pressed
    across, upright = scale_of("m", [extent]), scale_of("m", [pressed.depth])
    colours = _colours(stairs)
    below = np.cumsum(stairs.increments[::-1])[::-1]
    for radius, thick, bottom, colour in zip(stairs.radii, stairs.increments, below, colours, strict=True):
        axes.add_patch(
            Rectangle(
                (-radius / across.factor, -bottom / upright.factor),
                2.0 * radius / across.factor,
                thick / upright.factor,
                facecolor=colour,
                edgecolor="white",
                linewidth=0.8,
                zorder=3,
            )
        )
    x = np.concatenate([[0.0], places(pressed.radius, tuple(b for b, _ in pressed.kinks)), [pressed.radius]])
    shape = np.asarray(pressed.bed.gap(x), dtype=float) - pressed.depth
    if pressed.edge > 0.0:
        x, shape = np.append(x, pressed.radius), np.append(shape, 0.0)
    both = style.mirrored(x / across.factor, shape / upright.factor)
    axes.plot(*both, color=style.INK, linewidth=1.6, zorder=5, label="$g(x) − d$")
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
    axes.set_xlim(-extent / across.factor, extent / across.factor)
    axes.set_ylim(-1.08 * pressed.depth / upright.factor, 0.32 * pressed.depth / upright.factor)
    axes.set_xlabel(series("Foundation", "x", x).label(across))
    axes.set_ylabel(f"height [{upright.unit}]")
    axes.legend(loc="upper right", ncols=2)
    axes.grid(visible=False)


def draw_pressures(axes: Axes, stairs: Staircase, extent: float) -> None:
    """Draw the pressure of every punch, their sum, and the pressure of the contact itself.

    Parameters
    ----------
    axes : Axes
        Empty.
    stairs : Staircase
    extent : float
        Drawn up to this distance from the axis [m].
    """
    r = places(extent, tuple(stairs.radii), count=600)
    exact = restore(_Contact(stairs), r).pressure
    across = scale_of("m", [extent])
    middle = exact[np.isfinite(exact) & (exact > 0.0)]
    top = 1.9 * float(np.percentile(middle, 90.0)) if middle.size else 1.0
    scale = scale_of("Pa", [top])
    for radius, increment, colour in zip(stairs.radii, stairs.increments, _colours(stairs), strict=True):
        inside = r[r < radius]
        own = stairs.modulus * increment / (np.pi * np.sqrt((radius - inside) * (radius + inside)))
        axes.plot(inside / across.factor, own / scale.factor, color=colour, linewidth=1.1, zorder=3)
    label = f"sum of {stairs.radii.size} punches" if stairs.radii.size > 1 else "one punch"
    together = stairs.pressure(r)
    axes.plot(r / across.factor, together / scale.factor, color=style.RED, linewidth=1.1, zorder=4, label=label)
    axes.plot(
        r / across.factor,
        exact / scale.factor,
        color=style.INK,
        linewidth=2.0,
        linestyle=style.DASHES[1],
        zorder=5,
        label="infinitely many",
    )
    axes.set_xlim(0.0, extent / across.factor)
    axes.set_ylim(0.0, top / scale.factor)
    axes.set_xlabel(series("SurfaceFields", "r", r).label(across))
    axes.set_ylabel(series("SurfaceFields", "pressure", exact).label(scale))
    style.framed_legend(axes, loc="upper right")


def _colours(stairs: Staircase) -> list[tuple[float, ...]]:
    """Return one colour for every punch, from the narrowest to the widest."""
    return [tuple(style.shades()(tone)) for tone in np.linspace(0.9, 0.25, stairs.radii.size)]
