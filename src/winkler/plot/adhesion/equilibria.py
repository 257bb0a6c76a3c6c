"""Curves of adhesive equilibria: force over depth with stable and unstable states, and the jumps between them."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Depth, Force
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.panel import Arrow, Line, Panel, PanelAxis, Rule, note, points, zero
from winkler.plot.series import series
from winkler.problems.adhesion.edge_states import FarStates
from winkler.problems.adhesion.equilibrium import Equilibrium, EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.values.errors import InvalidInput

RADII_DRAWN, RADII_DRAWN_IN_TENSION = 1.4, 2.2
"""Largest contact radius of the drawn curve, relative to that of the state; larger under tension."""
POINTS = 400
MARGIN = 0.05


def equilibrium_panel(curve: EquilibriumCurve, *, jumps: bool = True) -> Panel:
    """Return F(d) of all equilibria: stable ones solid, others dashed, jumps as arrows.

    Parameters
    ----------
    curve : EquilibriumCurve
    jumps : bool, optional
        Whether to draw the jumps from the ends of branches.
    """
    panel = _over(curve, "force")
    left = float(np.min(curve.depth)) - MARGIN * float(np.ptp(curve.depth))
    arrows = [
        Arrow((jump.start_depth, jump.start_force), (max(jump.stop_depth, left), jump.stop_force), clipped=False)
        for jump in (curve.jumps if jumps else ())
    ]
    name = (Line(np.empty(0), np.empty(0), style.RED, width=1.0, name="jump"),) if arrows else ()
    return panel.plus(zero(), *arrows, *name, legend="best")


def radii_panel(curve: EquilibriumCurve) -> Panel:
    """Return the contact radius over the depth of all equilibria."""
    panel = _over(curve, "radius")
    return panel.plus(upright=dataclasses.replace(panel.upright, low=0.0))


def _over(curve: EquilibriumCurve, name: str) -> Panel:
    x, y = (series(one, getattr(curve, one)) for one in ("depth", name))
    unstable = "" if curve.stable.all() else "unstable"
    lines = [Line(x.content, y.content, style.MUTED, width=1.2, dash=style.DASHES[1], name=unstable)]
    for place, inside in enumerate(_stable_branches(curve)):
        lines.append(Line(x.content[inside], y.content[inside], width=2.0, name="" if place else "stable"))
    return Panel(tuple(lines), PanelAxis.of(x, margin=MARGIN), PanelAxis.of(y, margin=0.08))


def _stable_branches(curve: EquilibriumCurve) -> list[Array]:
    pairs = zip(curve.starts, curve.stops, strict=True)
    return [np.flatnonzero((curve.radius >= start) & (curve.radius <= stop)) for start, stop in pairs]


def curve_around(solution: AdhesiveSolution) -> EquilibriumCurve:
    """Return all equilibria around a state.

    Parameters
    ----------
    solution : AdhesiveSolution
        For one load, with a contact.  A prescribed force or radius counts as dead load, a depth as fixed grips.

    Raises
    ------
    InvalidInput
        If there is no contact.
    """
    problem, radius = solution.problem, float(solution.radius)
    if radius == 0.0:
        raise InvalidInput("draw: the bodies do not touch under this load, so there is no F(d) around it.")
    machine = math.inf if isinstance(problem.load, Depth) else 0.0
    return _curve(
        problem.bed, problem.law, (RADII_DRAWN if solution.force >= 0.0 else RADII_DRAWN_IN_TENSION) * radius, machine
    )


def around_panel(solution: AdhesiveSolution) -> Panel:
    """Return F(d) of all equilibria around a state, and the state itself as a point.

    Parameters
    ----------
    solution : AdhesiveSolution
        As for `curve_around`.
    """
    problem, radius, curve = solution.problem, float(solution.radius), curve_around(solution)
    depth, force = float(solution.depth), float(solution.force)
    marks: list[Any] = []
    if radius >= problem.bed.rim:  # the edge is pinned: constant stiffness
        ends = np.array([curve.depth[-1], depth]), np.array([curve.force[-1], force])
        marks.append(Line(*ends, width=2.0))
    law = problem.law
    receding = isinstance(law, ShortRange) and law.work_closing < law.work_opening
    text = f"stability under {'fixed grips' if isinstance(problem.load, Depth) else 'a dead load'}"
    marks.append(note(f"the edge about to recede,\n{text}" if receding else text, "lower right"))
    return equilibrium_panel(curve, jumps=False).plus(*marks, points(depth, force, order=7.0, clipped=False))


def pull_of(solution: AdhesiveSolution) -> float:
    """Return the attraction outside the contact [N], zero where its law has none there."""
    states = states_of(solution.problem.bed, solution.problem.law)
    return states.pull if isinstance(states, FarStates) else 0.0


def pull_off_panel(solution: PullOffSolution) -> Panel:
    """Return F(d) around a pull-off, the state itself, and the unloading line of the machine.

    Parameters
    ----------
    solution : PullOffSolution
    """
    problem = solution.problem
    machine = float(problem.machine_stiffness)
    compressive = Force(max(abs(solution.force), 1e-300))
    widest = float(AdhesiveIndentation(problem.bed, problem.law, compressive).solve().radius)
    curve = _curve(problem.bed, problem.law, widest, machine)
    place = float(solution.depth), float(solution.force)
    look: dict[str, Any] = {"colour": style.RED, "width": 1.0, "dash": style.DASHES[2], "name": "the machine"}
    line = Rule(place[0], upright=True, **look) if math.isinf(machine) else Rule(point=place, slope=-machine, **look)
    return equilibrium_panel(curve, jumps=False).plus(line, points(*place, order=7.0, name="pull-off"))


def _curve(bed: Any, law: Any, reach: float, machine: float) -> EquilibriumCurve:
    end = states_of(bed, law).end()
    return Equilibrium(bed, law, min(reach, end), machine, POINTS).solve()
