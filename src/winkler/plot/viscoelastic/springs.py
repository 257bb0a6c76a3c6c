"""The picture of the method for viscoelastic contacts: springs that are pressed, and springs that recover."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.friction.springs import coil
from winkler.plot.normal.springs import draw_ground, plane_profile
from winkler.plot.series import places, scale_of, series
from winkler.problems.viscoelastic.states import ViscoelasticState
from winkler.problems.viscoelastic.tangential_states import ViscoelasticTangentialState

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_recovering", "draw_state_loads", "width_of"]

Springy = ViscoelasticState | ViscoelasticTangentialState

SPRINGS = 33
"""How many springs are drawn; the row itself has more."""
WIDER = 1.35
"""A picture goes to so many radii of what has been pressed."""
LITTLE = 1e-3
"""Springs that are nearer to their rest than this part of the deepest count as recovered."""


def width_of(state: Springy) -> float:
    """Return how far the picture of a state goes [m]: beyond the contact, and beyond what has not recovered."""
    deepest = float(np.max(state.recess))
    moved = state.position[state.recess > LITTLE * deepest] if deepest > 0.0 else state.position[:0]
    return WIDER * max(float(np.max(moved, initial=0.0)), state.radius, float(state.position[0]))


def draw_recovering(axes: Axes, state: Springy, bed: Bed | None = None) -> None:
    """Draw the springs at one moment: those that press, those that still recover, and those at rest.

    Parameters
    ----------
    axes : Axes
        Empty.
    state : ViscoelasticState or ViscoelasticTangentialState
    bed : Bed, optional
        Whose plane profile is drawn over the springs.
    """
    from matplotlib.collections import LineCollection
    from matplotlib.lines import Line2D

    extent = width_of(state)
    deepest = float(np.max(state.recess))
    unit = deepest if deepest > 0.0 else extent
    across, upright = scale_of("m", [extent]), scale_of("m", [unit])
    step = 2.0 * extent / SPRINGS
    place = (np.arange(SPRINGS) - 0.5 * (SPRINGS - 1)) * step
    sunk = np.interp(np.abs(place), state.position, state.recess, right=0.0)
    pressed = np.abs(place) <= state.radius if state.radius > 0.0 else np.zeros(place.shape, dtype=bool)
    bottom, top = -2.4 * unit, 1.1 * unit
    for one, down, hit in zip(place, sunk, pressed, strict=True):
        line = coil(one, 0.0, bottom, -down, 0.32 * step)
        colour = style.RED if hit else style.GREEN if down > LITTLE * unit else style.MUTED
        points = np.stack([line[0] / across.factor, line[1] / upright.factor], axis=-1)
        axes.add_collection(
            LineCollection([points], colors=colour, linewidths=1.1, alpha=0.55 if colour == style.MUTED else 0.95)
        )
    draw_ground(axes, extent / across.factor, bottom / upright.factor, 0.2 * unit / upright.factor)
    if bed is not None:
        x, g = plane_profile(bed, extent)
        both, lower = style.mirrored(x.content, g.content - state.depth)
        kept = lower <= top
        body = np.where(kept, lower, top) / upright.factor
        axes.fill_between(
            both / across.factor, body, np.full(body.shape, top / upright.factor), facecolor=style.BODY, alpha=0.6
        )
        axes.plot(both[kept] / across.factor, body[kept], color=style.BLUE, linewidth=2.0, zorder=5)
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
    axes.set_xlim(-extent / across.factor, extent / across.factor)
    axes.set_ylim((bottom - 0.2 * unit) / upright.factor, top / upright.factor)
    axes.set_xlabel(series("Foundation", "x", state.position).label(across))
    axes.set_ylabel(f"height [{upright.unit}]")
    axes.grid(visible=False)
    handles = [
        Line2D([], [], color=style.RED, label="pressed"),
        Line2D([], [], color=style.GREEN, label="recover freely"),
    ]
    style.framed_legend(axes, handles=handles, loc="lower center", ncols=2)


def draw_state_loads(axes: Axes, state: ViscoelasticState) -> None:
    """Draw the pressure over the contact, and how far the surface's springs stand below it.

    Parameters
    ----------
    axes : Axes
        Empty.
    state : ViscoelasticState
    """
    if state.radius == 0.0:
        axes.axis("off")
        style.note(axes, "no contact", where="upper centre")
        return
    extent = width_of(state)
    r = places(extent, (state.radius,), count=300)
    pressure: Array = state.pressure(r)
    known = np.isfinite(pressure)
    of, along = series("ViscoelasticState", "pressure", pressure[known]), series("SurfaceFields", "r", r[known])
    x, p = style.mirrored(along.shown(), of.shown())
    axes.plot(x, p, color=style.RED)
    axes.fill_between(x, p, color=style.RED, alpha=0.14, linewidth=0.0)
    axes.set_xlim(-extent / along.scale.factor, extent / along.scale.factor)
    axes.set_ylim(0.0, None)
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label())
