"""The picture of the method for sheared contacts: springs that are pressed down and dragged sideways."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.foundation.sheared import ShearedSprings
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.normal.springs import draw_ground, plane_profile
from winkler.plot.series import scale_of, series

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["coil", "draw_dragged"]

COILS = 8
SPRINGS = 29
"""How many springs are drawn; the method itself has no such number."""
ASIDE = 1.0
"""The spring that is stretched most leans over by so many distances of springs."""


def draw_dragged(axes: Axes, sheared: ShearedSprings, stick: float, extent: float) -> None:
    """Draw the springs under the plane profile, leaning as far as they are stretched; in the plane along x.

    Parameters
    ----------
    axes : Axes
        Empty.
    sheared : ShearedSprings
        Of a contact.
    stick : float
        Radius of the part that sticks [m].
    extent : float
        [m].
    """
    from matplotlib.collections import LineCollection
    from matplotlib.lines import Line2D

    pressed = sheared.pressed
    x, g = plane_profile(pressed.bed, extent)
    across, depth = scale_of("m", [extent]), pressed.depth
    upright = scale_of("m", [depth])
    step = 2.0 * extent / SPRINGS
    place = (np.arange(SPRINGS) - 0.5 * (SPRINGS - 1)) * step
    touching = np.abs(place) <= pressed.radius
    stretched = np.zeros(place.shape)
    for part in sheared.components[0]:
        within = np.abs(place) < part.radius
        stretched[within] += part.value(np.abs(place[within]))
    most = float(np.max(np.abs(stretched)))
    lean = ASIDE * step / most if most > 0.0 else 0.0
    sunk = np.zeros(place.shape)
    sunk[touching] = pressed.value(np.abs(place[touching]))
    bottom = -2.4 * depth
    for one, down, aside, hit in zip(place, sunk, lean * stretched, touching, strict=True):
        sticks = hit and stick > 0.0 and abs(one) <= stick
        line = coil(one, aside, bottom, -down, 0.3 * step)
        colour = style.MUTED if not hit else style.GREEN if sticks else style.RED
        points = np.stack([line[0] / across.factor, line[1] / upright.factor], axis=-1)
        axes.add_collection(
            LineCollection([points], colors=colour, linewidths=1.1, alpha=0.9 if hit else 0.5, zorder=3)
        )
    draw_ground(axes, extent / across.factor, bottom / upright.factor, 0.2 * depth / upright.factor)
    top = 1.3 * depth
    shift = float(np.clip(np.ravel(sheared.shift)[0], -most, most)) * lean
    both, lower = style.mirrored(x.content, g.content - depth)
    both, lower = (both + shift) / across.factor, lower / upright.factor
    ceiling = np.full(lower.shape, max(top / upright.factor, float(np.max(lower))))
    axes.fill_between(both, lower, ceiling, facecolor=style.BODY, alpha=0.6, zorder=2)
    axes.plot(both, lower, color=style.BLUE, linewidth=2.0, zorder=5)
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
    axes.set_xlim(-extent / across.factor, extent / across.factor)
    axes.set_ylim((bottom - 0.2 * depth) / upright.factor, top / upright.factor)
    axes.set_xlabel(series("Foundation", "x", x.content).label(across))
    axes.set_ylabel(f"height [{upright.unit}]")
    axes.grid(visible=False)
    handles = [
        Line2D([], [], color=style.GREEN, label="sticks"),
        Line2D([], [], color=style.RED, label="slides"),
    ]
    style.framed_legend(axes, handles=handles, loc="upper left")
    if most > 0.0:
        style.note(axes, f"sideways {_round(lean)} times", where="upper right")


def coil(x: float, aside: float, bottom: float, top: float, wide: float) -> tuple[Array, Array]:
    """Return a zigzag from the ground to the top of a spring, which stands `aside` of its foot."""
    rungs = np.concatenate([[0.0, 0.1], 0.1 + 0.8 * (np.arange(2 * COILS) + 0.5) / (2 * COILS), [0.9, 1.0]])
    side = np.concatenate([[0.0, 0.0], np.where(np.arange(2 * COILS) % 2 == 0, 1.0, -1.0), [0.0, 0.0]])
    return x + aside * rungs + wide * side, bottom + rungs * (top - bottom)


def _round(number: float) -> str:
    """Return a magnification in two digits."""
    return f"{float(f'{number:.1e}'):,.0f}".replace(",", " ") if number >= 10.0 else f"{number:.2g}"
