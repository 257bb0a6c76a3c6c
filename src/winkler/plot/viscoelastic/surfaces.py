"""Sheets of viscoelastic bodies that are dragged along, slid over, or pulled off."""

from __future__ import annotations

import dataclasses
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.plot import style
from winkler.plot.decades import Line, draw_decades
from winkler.plot.draw import draw
from winkler.plot.friction.curves import draw_energies, draw_lines, draw_loop, shade_stick
from winkler.plot.series import Series, common_scale, series, told
from winkler.plot.viscoelastic.contacts import TELLING, depth_and_radius, refuse_extent
from winkler.plot.viscoelastic.springs import draw_recovering, width_of
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic.sliding import SlidingResistanceSolution
from winkler.problems.viscoelastic.tangential import ViscoelasticTangentialSolution
from winkler.problems.viscoelastic.tangential_states import ViscoelasticTangentialState

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["adhesion_sheet", "dragged_sheet", "dragged_state_sheet", "sliding_sheet"]

POINTS = 61
AROUND = 300.0
"""One speed is shown within so many times more and less."""


@draw.register(ViscoelasticTangentialSolution)
def dragged_sheet(item: ViscoelasticTangentialSolution, *, extent: float | None = None) -> Picture:
    """Return the loop, forces, energies and contact along a path; springs and their loads of a late contact."""
    refuse_extent(item, extent)
    bearing = np.flatnonzero(item.force >= TELLING * np.max(item.force))
    state, time = item.states[int(bearing[-1]) if bearing.size else 0], _told(item, "time")
    mu = item.problem.law.coefficient
    with style.styled():
        figure = style.figure(3, 2, width=3.9)
        panels = figure.subplots(2, 3).ravel()
        draw_loop(panels[0], _told(item, "shift"), _told(item, "shear_force"))
        lines = [(_told(item, "shear_force"), "$F_x$")]
        if math.isfinite(mu):
            lines += [
                (series(type(item), "shear_force", sign * mu * item.force), r"$\pm\mu F_N$" if sign > 0 else "_")
                for sign in (1.0, -1.0)
            ]
        draw_lines(panels[1], time, lines, "shear force")
        for line in panels[1].lines[-2:] if len(lines) > 1 else ():
            line.set(color=style.MUTED, linestyle=style.DASHES[1], linewidth=1.1)
        if len(lines) > 1:
            style.framed_legend(panels[1], loc="upper center", ncols=2)
        names = {"friction_loss": "lost to friction", "bulk_loss": "lost in the bodies", "stored_energy": "stored"}
        draw_energies(panels[2], item, names)
        panels[2].set_ylim(0.0, 1.35 * float(panels[2].get_ylim()[1]))
        draw_lines(
            panels[3], time, [(_told(item, "radius"), "contact"), (_told(item, "stick_radius"), "stick")], "radius"
        )
        panels[3].set_ylim(0.0, None)
        draw_recovering(panels[4], state, item.problem.bed)
        _draw_loads(panels[5], state, mu)
        when = f" at {told(state.time, 's', 3)}"
        titles = ("shear force over shift", "shear force", "energy", "contact", f"springs{when}", f"their loads{when}")
        for axes, title in zip(panels, titles, strict=True):
            axes.set_title(title)
    return figure


@draw.register(ViscoelasticTangentialState)
def dragged_state_sheet(item: ViscoelasticTangentialState, *, extent: float | None = None) -> Picture:
    """Return the springs at one moment, and their loads in both directions."""
    refuse_extent(item, extent)
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        draw_recovering(left, item)
        _draw_loads(right, item, math.inf)
        left.set_title("springs")
        right.set_title("their loads")
        parts = (
            ("F_N", item.force, "N"),
            ("F_x", item.shear_force, "N"),
            ("d", item.depth, "m"),
            ("u_x", item.shift, "m"),
        )
        figure.suptitle("   ".join(f"${symbol}$ = {told(number, unit)}" for symbol, number, unit in parts))
    return figure


def _draw_loads(axes: Axes, state: ViscoelasticTangentialState, coefficient: float) -> None:
    """Draw the load of the springs along the surface, and what friction lets them bear."""
    if state.radius == 0.0:
        axes.axis("off")
        style.note(axes, "no contact", where="upper centre")
        return
    along = series("Foundation", "x", state.position)
    bound = coefficient * state.line_load if math.isfinite(coefficient) else np.zeros(state.line_load.shape)
    of, limit = (series("ViscoelasticTangentialState", "shear_load", loads) for loads in (state.shear_load, bound))
    scale = common_scale(of, limit)
    shade_stick(axes, state.stick_radius / along.scale.factor)
    for sign in (1.0, -1.0) if np.any(bound) else ():
        x, y = style.mirrored(along.shown(), sign * limit.shown(scale))
        label = r"$\pm\mu q_z$" if sign > 0.0 else "_"
        axes.plot(x, y, color=style.MUTED, linewidth=1.1, linestyle=style.DASHES[1], label=label)
    x, y = style.mirrored(along.shown(), of.shown(scale))
    axes.plot(x, y, color=style.RED, label="$q_x$")
    axes.fill_between(x, y, color=style.RED, alpha=0.12, linewidth=0.0)
    end = width_of(state) / along.scale.factor
    axes.set_xlim(-end, end)
    axes.margins(y=0.2)
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label(scale))
    style.framed_legend(axes, loc="upper right")


@draw.register(SlidingResistanceSolution)
def sliding_sheet(item: SlidingResistanceSolution, *, extent: float | None = None) -> Picture:
    """Return the resistance and the coefficient of friction over the speed, and the springs where it is greatest."""
    refuse_extent(item, extent)
    asked = np.ravel(np.asarray(item.speed, dtype=float))
    low, high = (np.min(asked), np.max(asked)) if asked.size > 1 else (asked[0] / AROUND, asked[0] * AROUND)
    speeds = np.geomspace(low, high, POINTS)
    curve = item if asked.size >= POINTS else dataclasses.replace(item.problem, speed=speeds).solve()
    order = np.argsort(np.ravel(np.asarray(curve.speed)), kind="stable")
    along = series(type(item), "speed", np.ravel(np.asarray(curve.speed))[order])

    def line(name: str, label: str = "") -> Line:
        points = (asked, np.ravel(np.asarray(getattr(item, name), dtype=float)))
        return Line(series(type(item), name, np.ravel(np.asarray(getattr(curve, name)))[order]), label, points)

    with style.styled():
        figure = style.figure(3, width=3.9, height=3.3)
        panels = figure.subplots(1, 3)
        pair = [line("shear_force", "of the body"), line("line_shear_force", "of the line of springs")]
        draw_decades(panels[0], along, pair, "resistance $F_x$")
        draw_decades(panels[1], along, [line("coefficient")])
        place = int(np.argmax(np.ravel(np.asarray(curve.coefficient))))
        _draw_trace(panels[2], curve, place)
        speed = told(float(np.ravel(np.asarray(curve.speed))[place]), "m/s", 3)
        for axes, title in zip(panels, ("resistance", "coefficient", f"load of the springs at {speed}"), strict=True):
            axes.set_title(title)
    return figure


def _draw_trace(axes: Axes, curve: SlidingResistanceSolution, place: int) -> None:
    """Draw q(x) under the body, which moves to the right."""
    trace = curve.line(tuple(int(part) for part in np.unravel_index(place, np.shape(curve.speed))))
    along, of = series("Foundation", "x", trace.position), series("SlidingLine", "line_load", trace.line_load)
    axes.plot(along.shown(), of.shown(), color=style.BLUE)
    axes.fill_between(along.shown(), of.shown(), color=style.BLUE, alpha=0.14, linewidth=0.0)
    axes.axvline(0.0, color=style.MUTED, linewidth=0.8, linestyle=(0, (4, 3)))
    style.note(axes, "moves to the right →", where="upper left")
    axes.margins(x=0.04)
    axes.set_ylim(0.0, 1.25 * float(np.max(of.shown())))
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label())


@draw.register(ViscoelasticAdhesionSolution)
def adhesion_sheet(item: ViscoelasticAdhesionSolution, *, extent: float | None = None) -> Picture:
    """Return force over the machine's way, contact and depth over time, and how fast the edge opens."""
    refuse_extent(item, extent)
    time = _told(item, "time")
    with style.styled():
        figure = style.figure(3, width=3.9, height=3.3)
        panels = figure.subplots(1, 3)
        draw_loop(panels[0], _told(item, "position"), _told(item, "force"), float(item.dissipation[-1]))
        depth_and_radius(panels[1], item)
        opening = np.where(item.crack_speed > 0.0, item.crack_speed, np.nan)
        draw_lines(panels[2], time, [(series(type(item), "crack_speed", opening), "")], "speed of the edge")
        if np.any(item.crack_speed > 0.0):
            panels[2].set_yscale("log")
        titles = ("force over the way of the machine", "depth and contact", "how fast the edge opens")
        for axes, title in zip(panels, titles, strict=True):
            axes.set_title(title)
        figure.suptitle(f"lowest force {told(float(item.lowest_force[-1]), 'N')}")
    return figure


def _told(item: Any, name: str) -> Series:
    return series(type(item), name, getattr(item, name))
