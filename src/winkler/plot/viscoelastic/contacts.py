"""Sheets of viscoelastic contacts: along a path, at one moment of it, and in an impact."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.friction.curves import draw_energies, draw_lines, draw_loop
from winkler.plot.series import Series, series, told
from winkler.plot.viscoelastic.springs import draw_recovering, draw_state_loads
from winkler.problems.viscoelastic.impact import ViscoelasticImpactSolution
from winkler.problems.viscoelastic.indentation import ViscoelasticSolution
from winkler.problems.viscoelastic.states import ViscoelasticState

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["TELLING", "depth_and_radius", "impact_sheet", "path_sheet", "refuse_extent", "state_sheet"]

TELLING = 0.1
"""Shown is the last contact under this part of the greatest force."""


def refuse_extent(item: Any, extent: float | None) -> None:
    """Refuse an extent for pictures that have none."""
    if extent is not None:
        raise InvalidInput(f"draw: the curves of a {type(item).__name__} have no extent; leave it out.")


@draw.register(ViscoelasticSolution)
def path_sheet(item: ViscoelasticSolution, *, extent: float | None = None) -> Picture:
    """Return the loop, force, depth and contact over time, energies; below springs and pressure of a late contact."""
    refuse_extent(item, extent)
    state = _late(item)
    time = _told(item, "time")
    with style.styled():
        figure = style.figure(3, 2, width=3.9)
        panels = figure.subplots(2, 3).ravel()
        draw_loop(panels[0], _told(item, "depth"), _told(item, "force"), float(item.dissipation[-1]))
        draw_lines(panels[1], time, [(_told(item, "force"), "force")], "force $F_N$")
        depth_and_radius(panels[2], item)
        draw_energies(panels[3], item, {"dissipation": "lost", "stored_energy": "stored"})
        panels[3].set_ylim(0.0, 1.2 * float(panels[3].get_ylim()[1]))
        draw_recovering(panels[4], state, item.problem.bed)
        draw_state_loads(panels[5], state)
        when = f" at {told(state.time, 's', 3)}"
        titles = ("force over depth", "force", "depth and contact", "energy", f"springs{when}", f"pressure{when}")
        for axes, title in zip(panels, titles, strict=True):
            axes.set_title(title)
    return figure


def _late(item: ViscoelasticSolution) -> ViscoelasticState:
    """Return the last state under a force that matters; the springs are marched there once more."""
    bearing = np.flatnonzero(item.force >= TELLING * np.max(item.force))
    last = int(bearing[-1]) if bearing.size else 0
    return next(itertools.islice(item.problem.steps(), last, None))


def depth_and_radius(axes: Axes, item: Any) -> None:
    """Draw the depth, and on a second axis the contact radius, over time."""
    time, depth, radius = (_told(item, name) for name in ("time", "depth", "radius"))
    axes.plot(time.shown(), depth.shown(), color=style.BLUE)
    axes.set_xlabel(time.label())
    axes.set_ylabel(depth.label(), color=style.BLUE)
    beside = axes.twinx()
    beside.plot(time.shown(), radius.shown(), color=style.RED, linestyle=style.DASHES[1])
    beside.set_ylabel(radius.label(), color=style.RED)
    beside.spines["right"].set_visible(True)
    beside.grid(visible=False)
    beside.set_ylim(0.0, None)
    axes.margins(x=0.0, y=0.08)
    if np.min(depth.content) >= 0.0:
        axes.set_ylim(0.0, 1.08 * float(np.max(depth.shown())))


@draw.register(ViscoelasticState)
def state_sheet(item: ViscoelasticState, *, extent: float | None = None) -> Picture:
    """Return the springs at one moment, those that recover as well, and the pressure."""
    refuse_extent(item, extent)
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        draw_recovering(left, item)
        draw_state_loads(right, item)
        left.set_title("springs")
        right.set_title("pressure $p(r)$")
        parts = (("t", item.time, "s"), ("F_N", item.force, "N"), ("d", item.depth, "m"), ("a", item.radius, "m"))
        figure.suptitle("   ".join(f"${symbol}$ = {told(number, unit)}" for symbol, number, unit in parts))
    return figure


@draw.register(ViscoelasticImpactSolution)
def impact_sheet(item: ViscoelasticImpactSolution, *, extent: float | None = None) -> Picture:
    """Return force over depth and over time, velocity, depth and contact of an impact."""
    refuse_extent(item, extent)
    time = _told(item, "time")
    with style.styled():
        figure = style.figure(2, 2, height=3.1)
        panels = figure.subplots(2, 2).ravel()
        draw_loop(panels[0], _told(item, "depth"), _told(item, "force"), float(item.dissipation))
        draw_lines(panels[1], time, [(_told(item, "force"), "force")], "force $F_N$")
        draw_lines(panels[2], time, [(_told(item, "velocity"), "velocity")], "velocity of approach $v$")
        depth_and_radius(panels[3], item)
        for axes, title in zip(panels, ("force over depth", "force", "velocity", "depth and contact"), strict=True):
            axes.set_title(title)
        figure.suptitle(f"restitution $e$ = {item.restitution:.4g}   contact for {told(item.duration, 's')}")
    return figure


def _told(item: Any, name: str) -> Series:
    return series(type(item), name, getattr(item, name))
