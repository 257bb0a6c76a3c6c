"""Pictures of adhesive contacts in motion: cycles with their jumps and losses, and contacts that are sheared."""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.loading.loads import Depth, Force, ShearForce, Shift
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.panel import Arrow, Line, Panel, PanelAxis, Polygon, note, points, zero
from winkler.plot.series import row_of, series, with_unit
from winkler.problems.adhesion.cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesion.cycle_states import EdgeState
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShear, AdhesiveShearSolution

CYCLE_STATES, STATES_AT_JUMP = 300, 201
"""Number of states along a drawn cycle, and of additional states around each jump."""
SHEAR_STATES = 161
MARGIN = 0.05
SEPARATED_SHARE = 0.3
"""Part of the drawn range in which the bodies are separated, relative to the range in contact."""
MOST_MARKED_POINTS = 40
"""Points of a path are marked individually up to this number."""


def contact_of(solution: Any) -> AdhesiveSolution | None:
    """Return one state of an adhesive solution as a contact with fields; None if no state has a contact.

    Parameters
    ----------
    solution
        Solution of a problem of adhesion.  The widest contact of a cycle is taken, the widest stable one of a curve,
        and that of the last load of a sheared contact.
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
    """Return force and contact radius over the position of the machine, with jumps and the dissipated energy shaded.

    Parameters
    ----------
    solution : AdhesiveCycleSolution
    """
    by_depth = isinstance(solution.problem.path, Depth)
    name = "position" if by_depth else "depth"
    path = _detailed_path(solution)
    along = series(name, path.place, AdhesiveCycleSolution)
    interacting = path.place[(path.force != 0.0) | (path.radius > 0.0)]
    low, margin = float(np.min(path.place)), MARGIN * float(np.ptp(path.place))
    if interacting.size:  # leave out most of the path on which the bodies are separated
        low = max(
            low - margin, float(np.min(interacting)) - SEPARATED_SHARE * float(np.max(path.place) - np.min(interacting))
        )
    across = PanelAxis.of(along, margin=MARGIN, low=low if interacting.size else None)
    panels = []
    for what, content in (("force", path.force), ("radius", path.radius)):
        of = series(what, content, AdhesiveCycleSolution)
        marks: list[Any] = [Line(*_with_gaps(path.place, content, path.is_jump))]
        for index in np.flatnonzero(path.is_jump):
            start, stop = ((float(path.place[at]), float(content[at])) for at in (index, index + 1))
            marks.append(Arrow(start, stop, width=1.2))
        if solution.depth.size <= MOST_MARKED_POINTS:
            marks.append(points(getattr(solution, name), getattr(solution, what), style.BLUE, size=4.0))
        upright = PanelAxis.of(of, margin=0.08, low=0.0 if what == "radius" else None)
        panels.append(Panel(tuple(marks), across, upright))
    lost, closed = (
        with_unit(float(solution.dissipation[-1]), "J"),
        bool(solution.radius[-1] == solution.force[-1] == 0.0),
    )
    shaded = by_depth and closed
    area = (Polygon(path.place, path.force, style.RED, 0.14),) if shaded else ()
    text = note(f"{'shaded: lost,' if shaded else 'lost so far:'} {lost}", "upper left")
    return panels[0].plus(zero(), *area, text), panels[1]


class _CyclePath(NamedTuple):
    """States along a cycle, jumps included: between two neighbours there may be a jump."""

    place: Array
    force: Array
    radius: Array
    is_jump: Array


def _detailed_path(solution: AdhesiveCycleSolution) -> _CyclePath:
    """Return the cycle with intermediate states; the solution depends on the turning points alone."""
    places: list[EdgeState] = []
    is_jump: list[bool] = []
    for state in _refined(solution).steps():
        for jump in state.jumps:
            places += [jump.before, jump.after]
            is_jump += [True, False]
        places.append(state)
        is_jump.append(False)
        # is_jump[i] belongs to the step from state i to the next one
    numbers = np.array([(state.position, state.force, state.radius) for state in places])
    return _CyclePath(numbers[:, 0], numbers[:, 1], numbers[:, 2], np.array(is_jump))


def _refined(solution: AdhesiveCycleSolution) -> AdhesiveCycle:
    """Return the same cycle up to the last solved state in small steps, beginning with separated bodies."""
    problem, reached = solution.problem, solution.depth.size
    match problem.path:
        case Depth(levels):
            reached_levels = np.asarray(levels, dtype=float)[:reached]
            separated = min(float(reached_levels[0]), -0.1 * float(np.ptp(np.append(reached_levels, 0.0))))
            jumps = [jump.before.position for jump in solution.jumps]
            return dataclasses.replace(problem, path=Depth(_steps(np.append(separated, reached_levels), jumps)))
        case Force(levels):
            jumps = [jump.before.force for jump in solution.jumps]
            reached_levels = np.asarray(levels, dtype=float)[:reached]
            return dataclasses.replace(problem, path=Force(_steps(reached_levels, jumps)))


def _steps(levels: Array, jumps: list[float]) -> Array:
    """Return the levels with intermediate ones, dense at jumps, where curves begin like a square root."""
    share = max(1, math.ceil(CYCLE_STATES / levels.size))
    beside = (
        float(np.ptp(levels)) * np.linspace(-1.0, 1.0, STATES_AT_JUMP) * np.abs(np.linspace(-1.0, 1.0, STATES_AT_JUMP))
    )
    dense = (np.array(jumps)[:, None] + beside).ravel()
    parts = [levels[:1]]
    for start, stop in itertools.pairwise(levels):
        inside = dense[(dense > min(start, stop)) & (dense < max(start, stop))]
        leg = np.unique(np.concatenate([np.linspace(start, stop, share, endpoint=False)[1:], inside]))
        parts += [leg if start < stop else leg[::-1], np.array([stop])]
    return np.concatenate(parts)


def _with_gaps(x: Array, y: Array, is_jump: Array) -> tuple[Array, Array]:
    """Return a line interrupted at jumps."""
    after = np.flatnonzero(is_jump) + 1
    return np.insert(x, after, np.nan), np.insert(y, after, np.nan)


def sheared_panels(solution: AdhesiveShearSolution) -> tuple[Panel, Panel]:
    """Return shear force and contact radius over the shift, up to the loss of stability.

    Parameters
    ----------
    solution : AdhesiveShearSolution
    """
    problem, limit = solution.problem, solution.limit
    share = 1.0 - (1.0 - np.linspace(0.0, 1.0, SHEAR_STATES)) ** 2  # dense where the radius falls steeply
    most = Shift(limit.shift * share) if isinstance(problem.lateral, Shift) else ShearForce(limit.shear_force * share)
    whole = AdhesiveShear(problem.bed, problem.law, problem.normal, most).solve()
    panels = []
    for name in ("shear_force", "radius"):
        asked = np.abs(solution.shift), np.abs(getattr(solution, name))
        of = Quantity(row_of(whole, name), points=asked, marked="requested")
        end = points(limit.shift, getattr(limit, name), style.INK, name="instability")
        panels.append(curves_panel(row_of(whole, "shift"), [of]).plus(end))
    return panels[0].plus(note("approximate", "upper left")), panels[1]
