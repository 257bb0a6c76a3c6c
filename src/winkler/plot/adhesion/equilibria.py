"""Curves of adhesive equilibria: force over depth with stable and unstable states, and the jumps between them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.laws.adhesion import ShortRange
from winkler.loading import Depth, Force
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Scale, series
from winkler.problems.adhesion.equilibrium import Equilibrium, EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.pull_off import PullOffSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["curve_around", "draw_around", "draw_equilibrium", "draw_last", "draw_radii"]

WIDER, WIDER_PULLED = 1.4, 2.2
"""The curve around a state goes to so many contact radii; around one under tension further, to where the force is zero
or not far from it."""
POINTS = 400


def draw_equilibrium(axes: Axes, curve: EquilibriumCurve, *, jumps: bool = True) -> tuple[Scale, Scale]:
    """Draw F(d) of all equilibria: stable ones solid, others dashed, jumps as arrows.

    Parameters
    ----------
    axes : Axes
        Empty.
    curve : EquilibriumCurve
    jumps : bool, optional
        Whether to draw where the edge runs to from the ends of branches.

    Returns
    -------
    tuple of Scale
        Of depth and force.
    """
    across, upright = _over(axes, curve, "depth", "force")
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    left = axes.get_xlim()[0]
    for jump in curve.jumps if jumps else ():
        start = jump.start_depth / across.factor, jump.start_force / upright.factor
        stop = max(jump.stop_depth / across.factor, left), jump.stop_force / upright.factor
        axes.annotate("", stop, start, arrowprops=_arrow(), zorder=6, annotation_clip=False)
    if jumps and curve.jumps:
        axes.plot([], [], color=style.RED, linewidth=1.0, label="jump")
    style.framed_legend(axes, loc="best")
    return across, upright


def _arrow() -> dict[str, Any]:
    return {"arrowstyle": "-|>", "color": style.RED, "linewidth": 1.0, "shrinkA": 0, "shrinkB": 0}


def draw_radii(axes: Axes, curve: EquilibriumCurve) -> None:
    """Draw the contact radius over the depth of all equilibria."""
    _over(axes, curve, "depth", "radius")
    axes.set_ylim(0.0, None)


def _over(axes: Axes, curve: EquilibriumCurve, along: str, of: str) -> tuple[Scale, Scale]:
    x, y = (series("EquilibriumCurve", name, getattr(curve, name)) for name in (along, of))
    label = None if curve.stable.all() else "unstable"
    axes.plot(x.shown(), y.shown(), color=style.MUTED, linewidth=1.2, linestyle=style.DASHES[1], label=label)
    for place, inside in enumerate(_stretches(curve)):
        label = "stable" if place == 0 else None
        axes.plot(x.shown()[inside], y.shown()[inside], color=style.BLUE, linewidth=2.0, label=label)
    axes.margins(x=0.05, y=0.08)
    axes.set_xlabel(x.label())
    axes.set_ylabel(y.label())
    return x.scale, y.scale


def _stretches(curve: EquilibriumCurve) -> list[Array]:
    pairs = zip(curve.starts, curve.stops, strict=True)
    return [np.flatnonzero((curve.radius >= start) & (curve.radius <= stop)) for start, stop in pairs]


def curve_around(solution: AdhesiveSolution) -> EquilibriumCurve:
    """Return all equilibria around a state.

    Parameters
    ----------
    solution : AdhesiveSolution
        For one load, with a contact; a force, or a radius, is a dead load, a depth fixed grips.

    Raises
    ------
    InvalidInput
        If there is no contact.
    """
    problem, radius = solution.problem, float(solution.radius)
    if radius == 0.0:
        raise InvalidInput("draw: the bodies do not touch under this load, so there is no F(d) around it.")
    machine = math.inf if isinstance(problem.load, Depth) else 0.0
    return _curve(problem.bed, problem.law, (WIDER if solution.force >= 0.0 else WIDER_PULLED) * radius, machine)


def draw_around(axes: Axes, solution: AdhesiveSolution) -> None:
    """Draw F(d) of all equilibria around a state, and the state itself as a point.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution : AdhesiveSolution
        As for `curve_around`.
    """
    problem, radius, curve = solution.problem, float(solution.radius), curve_around(solution)
    across, upright = draw_equilibrium(axes, curve, jumps=False)
    depth, force = float(solution.depth) / across.factor, float(solution.force) / upright.factor
    if radius >= problem.bed.rim:  # the edge is held there: the springs go on together
        end = curve.depth[-1] / across.factor, curve.force[-1] / upright.factor
        axes.plot([end[0], depth], [end[1], force], color=style.BLUE, linewidth=2.0)
    axes.plot([depth], [force], "o", color=style.RED, clip_on=False, zorder=7)
    law = problem.law
    receding = isinstance(law, ShortRange) and law.work_closing < law.work_opening
    told = f"judged under {'fixed grips' if isinstance(problem.load, Depth) else 'a dead load'}"
    style.note(axes, f"the edge about to recede,\n{told}" if receding else told, where="lower right")


def draw_last(axes: Axes, solution: PullOffSolution) -> None:
    """Draw F(d) around a pull-off, the state itself, and along which line the machine lets go.

    Parameters
    ----------
    axes : Axes
        Empty.
    solution : PullOffSolution
    """
    problem = solution.problem
    machine = float(problem.machine_stiffness)
    pressed_on = Force(max(abs(solution.force), 1e-300))
    wide = float(AdhesiveIndentation(problem.bed, problem.law, pressed_on).solve().radius)
    across, upright = draw_equilibrium(axes, _curve(problem.bed, problem.law, wide, machine), jumps=False)
    place = solution.depth / across.factor, solution.force / upright.factor
    line: dict[str, Any] = {"color": style.RED, "linewidth": 1.0, "linestyle": style.DASHES[2], "label": "the machine"}
    if math.isinf(machine):
        axes.axvline(place[0], **line)
    else:
        slope = -machine * across.factor / upright.factor
        limits = axes.get_xlim(), axes.get_ylim()
        axes.axline(place, slope=slope, **line)
        axes.set_xlim(limits[0])
        axes.set_ylim(limits[1])
    axes.plot([place[0]], [place[1]], "o", color=style.RED, label="pull-off", zorder=7)
    style.framed_legend(axes, loc="best")


def _curve(bed: Any, law: Any, reach: float, machine: float) -> EquilibriumCurve:
    end = states_of(bed, law).end()
    return Equilibrium(bed, law, min(reach, end), machine, POINTS).solve()
