"""Pictures of adhesive contacts in motion: cycles with their jumps and losses, and contacts that are sheared."""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.loading import Depth, Force, ShearForce, Shift
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.panel import Arrow, Axis, Line, Panel, Polygon, note, zero
from winkler.plot.series import series, told
from winkler.problems.adhesion.cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesion.cycle_states import AdhesiveState, EdgeState
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShear, AdhesiveShearSolution

__all__ = ["contact_of", "cycle_panels", "intensity_words", "sheared_panels"]

FINE, NEAR = 300, 201
"""A cycle is drawn through about so many states, however few the path has, and so many on both sides of each jump."""
SHEARED = 161
MARGIN = 0.05
BESIDE = 0.3
"""Of the way on which the bodies are apart so much is shown, in terms of the rest."""
MARKED = 40
"""Paths of at most so many points show each of them."""


def intensity_words(solution: AdhesiveSolution) -> str:
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


def cycle_panels(solution: AdhesiveCycleSolution) -> tuple[Panel, Panel]:
    """Return force and contact radius over the position of the machine, with every jump; what is lost is shaded.

    Parameters
    ----------
    solution : AdhesiveCycleSolution
    """
    by_depth = isinstance(solution.problem.path, Depth)
    name = "position" if by_depth else "depth"
    path = _followed(solution)
    along = series(name, path.place, AdhesiveCycleSolution)
    felt = path.place[(path.force != 0.0) | (path.radius > 0.0)]
    low, margin = float(np.min(path.place)), MARGIN * float(np.ptp(path.place))
    if felt.size:  # not the whole path along which the bodies are apart
        low = max(low - margin, float(np.min(felt)) - BESIDE * float(np.max(path.place) - np.min(felt)))
    across = Axis.of(along, margin=MARGIN, low=low if felt.size else None)
    panels = []
    for what, content in (("force", path.force), ("radius", path.radius)):
        of = series(what, content, AdhesiveCycleSolution)
        marks: list[Any] = [Line(*_broken(path.place, content, path.leaps))]
        for leap in np.flatnonzero(path.leaps):
            start, stop = ((float(path.place[at]), float(content[at])) for at in (leap, leap + 1))
            marks.append(Arrow(start, stop, width=1.2))
        if solution.depth.size <= MARKED:
            points = getattr(solution, name), getattr(solution, what)
            marks.append(Line(*points, width=0.0, marker="o", size=4.0))
        upright = Axis.of(of, margin=0.08, low=0.0 if what == "radius" else None)
        panels.append(Panel(tuple(marks), across, upright))
    lost, closed = told(float(solution.dissipation[-1]), "J"), bool(solution.radius[-1] == solution.force[-1] == 0.0)
    shaded = by_depth and closed
    area = (Polygon(path.place, path.force, style.RED, 0.14),) if shaded else ()
    words = note(f"{'shaded: lost,' if shaded else 'lost so far:'} {lost}", "upper left")
    return panels[0].plus(zero(), *area, words), panels[1]


class _Path(NamedTuple):
    """States along a cycle, jumps included: between two neighbours there may be a jump."""

    place: Array
    force: Array
    radius: Array
    leaps: Array


def _followed(solution: AdhesiveCycleSolution) -> _Path:
    """Return a cycle through many states; the answer depends on the turning points alone."""
    places: list[EdgeState | AdhesiveState] = []
    leaps: list[bool] = []
    for state in _refined(solution).steps():
        for jump in state.jumps:
            places += [jump.before, jump.after]
            leaps += [True, False]
        places.append(state)
        leaps.append(False)
        # leaps[i] belongs to the step from state i to the next one
    numbers = np.array([(state.position, state.force, state.radius) for state in places])
    return _Path(numbers[:, 0], numbers[:, 1], numbers[:, 2], np.array(leaps))


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
    parts = [levels[:1]]
    for start, stop in itertools.pairwise(levels):
        inside = dense[(dense > min(start, stop)) & (dense < max(start, stop))]
        leg = np.unique(np.concatenate([np.linspace(start, stop, share, endpoint=False)[1:], inside]))
        parts += [leg if start < stop else leg[::-1], np.array([stop])]
    return np.concatenate(parts)


def _broken(x: Array, y: Array, leaps: Array) -> tuple[Array, Array]:
    """Return a line that is interrupted where there is a jump."""
    after = np.flatnonzero(leaps) + 1
    return np.insert(x, after, np.nan), np.insert(y, after, np.nan)


def sheared_panels(solution: AdhesiveShearSolution) -> tuple[Panel, Panel]:
    """Return shear force and contact radius over the shift, up to where the contact loses its hold.

    Parameters
    ----------
    solution : AdhesiveShearSolution
    """
    problem, limit = solution.problem, solution.limit
    share = 1.0 - (1.0 - np.linspace(0.0, 1.0, SHEARED)) ** 2  # dense where the radius falls steeply
    most = Shift(limit.shift * share) if isinstance(problem.lateral, Shift) else ShearForce(limit.shear_force * share)
    whole = AdhesiveShear(problem.bed, problem.law, problem.normal, most).solve()
    shift = series("shift", whole.shift)
    panels = []
    for name, last in (("shear_force", limit.shear_force), ("radius", limit.radius)):
        of = series(name, getattr(whole, name))
        given = np.abs(np.ravel(solution.shift)), np.abs(np.ravel(getattr(solution, name)))
        end = np.array([float(limit.shift)]), np.array([float(last)])
        marks = (
            Line(shift.content, of.content),
            Line(*given, width=0.0, marker="o", name="asked", clipped=False),
            Line(*end, style.RED, width=0.0, marker="o", name="loses its hold"),
        )
        panels.append(Panel(marks, Axis.of(shift, margin=MARGIN), Axis.of(of, low=0.0)))
    return panels[0].plus(note("approximate", "upper left")), panels[1].plus(legend="lower left")
