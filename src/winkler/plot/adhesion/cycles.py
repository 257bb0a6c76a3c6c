"""Pictures of adhesive contacts in motion: cycles with their jumps and losses, and contacts that are sheared."""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.loading import Depth, Force, ShearForce, Shift
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import scale_of, series, told
from winkler.problems.adhesion.cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesion.cycle_states import AdhesiveState, EdgeState
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShear, AdhesiveShearSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["contact_of", "draw_cycle", "draw_sheared", "intensity_told"]

FINE, NEAR = 300, 201
"""A cycle is drawn through about so many states, however few the path has, and so many on both sides of each jump."""
SHEARED = 161
BESIDE = 0.3
"""Of the way on which the bodies are apart so much is shown, in terms of the rest."""
MARKED = 40
"""Paths of at most so many points show each of them."""


def intensity_told(solution: AdhesiveSolution) -> str:
    """Return what a picture of the pressure says about the edge: the stress intensity, where it is known."""
    try:
        return f"\n$K_I$ = {told(float(solution.stress_intensity), 'Pa', 3)} m$^{{1/2}}$"
    except OutsideValidity:
        return ""


def contact_of(solution: Any) -> AdhesiveSolution | None:
    """Return one state of an adhesive answer as a contact with fields; None if none of its states has a contact.

    Parameters
    ----------
    solution
        An answer to a problem of adhesion; of a cycle its widest contact is taken, of a curve its widest stable one, of
        a sheared contact that of the last load.
    """
    problem = solution.problem
    if isinstance(solution, AdhesiveSolution):
        return solution if np.ndim(solution.depth) == 0 else solution.at(np.size(solution.depth) - 1)
    states = [np.ravel(getattr(solution, name)) for name in ("depth", "force", "radius")]
    match solution:
        case AdhesiveCycleSolution():
            place = int(np.argmax(solution.radius))
        case EquilibriumCurve():
            place = int(np.flatnonzero(solution.stable)[-1]) if solution.stable.any() else 0
        case PullOffSolution() | AdhesiveShearSolution():
            place = -1
        case _:
            return None
    depth, force, radius = (float(part[place]) for part in states)
    if radius == 0.0:
        return None
    return AdhesiveSolution(AdhesiveIndentation(problem.bed, problem.law, Depth(depth)), depth, force, radius, True)


def draw_cycle(left: Axes, right: Axes, solution: AdhesiveCycleSolution) -> None:
    """Draw force and contact radius over the position of the machine, with every jump; what is lost is shaded.

    Parameters
    ----------
    left, right : Axes
        Empty.
    solution : AdhesiveCycleSolution
    """
    by_depth = isinstance(solution.problem.path, Depth)
    name = "position" if by_depth else "depth"
    way = _followed(solution)
    across = scale_of("m", way.place)
    for axes, what, content in ((left, "force", way.force), (right, "radius", way.radius)):
        of = series("AdhesiveCycleSolution", what, content)
        x, y = way.place / across.factor, of.shown()
        axes.plot(*_broken(x, y, way.leaps), color=style.BLUE)
        for leap in np.flatnonzero(way.leaps):
            arrow = {"arrowstyle": "-|>", "color": style.RED, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
            axes.annotate("", (x[leap + 1], y[leap + 1]), (x[leap], y[leap]), arrowprops=arrow, zorder=6)
        if solution.depth.size <= MARKED:
            points = getattr(solution, name) / across.factor, getattr(solution, what) / of.scale.factor
            axes.plot(*points, "o", color=style.BLUE, markersize=4.0)
        axes.margins(x=0.05, y=0.08)
        axes.set_xlabel(series("AdhesiveCycleSolution", name, way.place).label(across))
        axes.set_ylabel(of.label())
    left.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    right.set_ylim(0.0, None)
    felt = way.place[(way.force != 0.0) | (way.radius > 0.0)]
    for axes in (left, right) if felt.size else ():  # not the whole way that the bodies are apart
        low, high = axes.get_xlim()
        near = (float(np.min(felt)) - BESIDE * float(np.max(way.place) - np.min(felt))) / across.factor
        axes.set_xlim(max(low, near), high)
    lost, closed = told(float(solution.dissipation[-1]), "J"), bool(solution.radius[-1] == solution.force[-1] == 0.0)
    if by_depth and closed:
        upright = scale_of("N", way.force).factor
        left.fill(way.place / across.factor, way.force / upright, color=style.RED, alpha=0.14, linewidth=0.0)
    style.note(left, f"{'shaded: lost,' if by_depth and closed else 'lost so far:'} {lost}", where="upper left")


class _Way(NamedTuple):
    """States along a cycle, jumps included: between two neighbours there may be a jump."""

    place: Array
    force: Array
    radius: Array
    leaps: Array


def _followed(solution: AdhesiveCycleSolution) -> _Way:
    """Return a cycle through many states; the answer depends on the turning points alone."""
    places: list[EdgeState | AdhesiveState] = []
    leaps: list[bool] = []
    for state in _refined(solution).steps():
        for jump in state.jumps:
            places += [jump.before, jump.after]
            leaps += [True, False]
        places.append(state)
        leaps.append(False)
        # leaps[i] tells about the way from state i to the next one
    numbers = np.array([(state.position, state.force, state.radius) for state in places])
    return _Way(numbers[:, 0], numbers[:, 1], numbers[:, 2], np.array(leaps))


def _refined(solution: AdhesiveCycleSolution) -> AdhesiveCycle:
    """Return the same cycle, as far as the answer goes, in small steps, from where the bodies are apart."""
    problem, reached = solution.problem, solution.depth.size
    match problem.path:
        case Depth(levels):
            row = np.asarray(levels, dtype=float)[:reached]
            apart = min(float(row[0]), -0.1 * float(np.ptp(np.append(row, 0.0))))
            jumps = [jump.before.position for jump in solution.jumps]
            return dataclasses.replace(problem, path=Depth(_steps(np.append(apart, row), jumps)))
        case Force(levels):
            jumps = [jump.before.force for jump in solution.jumps]
            row = np.asarray(levels, dtype=float)[:reached]
            return dataclasses.replace(problem, path=Force(_steps(row, jumps)))


def _steps(levels: Array, jumps: list[float]) -> Array:
    """Return the levels with others in between; at a jump curves leave with the root of the distance."""
    share = max(1, math.ceil(FINE / levels.size))
    beside = float(np.ptp(levels)) * np.linspace(-1.0, 1.0, NEAR) * np.abs(np.linspace(-1.0, 1.0, NEAR))
    dense = (np.array(jumps)[:, None] + beside).ravel()
    way = [levels[:1]]
    for start, stop in itertools.pairwise(levels):
        inside = dense[(dense > min(start, stop)) & (dense < max(start, stop))]
        leg = np.unique(np.concatenate([np.linspace(start, stop, share, endpoint=False)[1:], inside]))
        way += [leg if start < stop else leg[::-1], np.array([stop])]
    return np.concatenate(way)


def _broken(x: Array, y: Array, leaps: Array) -> tuple[Array, Array]:
    """Return a line that is interrupted where there is a jump."""
    after = np.flatnonzero(leaps) + 1
    return np.insert(x, after, np.nan), np.insert(y, after, np.nan)


def draw_sheared(left: Axes, right: Axes, solution: AdhesiveShearSolution) -> None:
    """Draw shear force and contact radius over the shift, up to where the contact loses its hold.

    Parameters
    ----------
    left, right : Axes
        Empty.
    solution : AdhesiveShearSolution
    """
    problem, limit = solution.problem, solution.limit
    share = 1.0 - (1.0 - np.linspace(0.0, 1.0, SHEARED)) ** 2  # dense where the radius falls steeply
    most = Shift(limit.shift * share) if isinstance(problem.lateral, Shift) else ShearForce(limit.shear_force * share)
    whole = AdhesiveShear(problem.bed, problem.law, problem.normal, most).solve()
    shift = series("AdhesiveShearSolution", "shift", whole.shift)
    for axes, name, last in ((left, "shear_force", limit.shear_force), (right, "radius", limit.radius)):
        of = series("AdhesiveShearSolution", name, getattr(whole, name))
        axes.plot(shift.shown(), of.shown(), color=style.BLUE)
        x, y = np.abs(np.ravel(solution.shift)), np.abs(np.ravel(getattr(solution, name)))
        axes.plot(x / shift.scale.factor, y / of.scale.factor, "o", color=style.BLUE, label="asked", clip_on=False)
        end = limit.shift / shift.scale.factor, last / of.scale.factor
        axes.plot(*([part] for part in end), "o", color=style.RED, label="loses its hold")
        axes.margins(x=0.05)
        axes.set_ylim(0.0, None)
        axes.set_xlabel(shift.label())
        axes.set_ylabel(of.label())
    style.framed_legend(right, loc="lower left")
    style.note(left, "approximate", where="upper left")
