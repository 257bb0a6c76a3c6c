"""Sheets of viscoelastic contacts under tangential motion, in sliding, and with adhesion."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.plot import style
from winkler.plot.curves import Quantity, answered, curves_panel, decades_around
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import (
    bounds,
    energies_panel,
    loop_panel,
    mirrored_bounds,
    stick_band,
)
from winkler.plot.friction.sheets import tangential_sheet, torsion_sheet
from winkler.plot.panel import NO_CONTACT, Area, Line, Panel, PanelAxis, Rule, Sheet, note, titled
from winkler.plot.series import common_scale, headline, row_of, series, series_of, with_unit
from winkler.plot.viscoelastic.contacts import LEAST_FORCE_SHARE, depth_and_radius
from winkler.plot.viscoelastic.springs import recovering_panel, width_of
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic.sliding import SlidingResistanceSolution
from winkler.problems.viscoelastic.tangential import DraggedState
from winkler.problems.viscoelastic.torsion import DraggedTwist

POINTS = 61
FACTOR_AROUND = 300.0
"""Range drawn around a single speed, as a factor."""


@without_extent(TangentialSolution)
@without_extent(TorsionSolution)
def dragged_sheet(item: TangentialSolution | TorsionSolution) -> Sheet:
    """Return the loop, forces and energies along a path; of bodies that relax springs and loads of a late contact."""
    bearing = np.flatnonzero(item.force >= LEAST_FORCE_SHARE * np.max(item.force))
    state, time = item.states[int(bearing[-1]) if bearing.size else 0], series_of(item, "time")
    twisted = isinstance(item, TorsionSolution)
    if not isinstance(state, DraggedState | DraggedTwist):
        return torsion_sheet(item) if isinstance(item, TorsionSolution) else tangential_sheet(item)
    assert isinstance(item.problem.law, Coulomb)
    mu = item.problem.law.coefficient
    motion, load, symbol = ("angle", "torque", "$M_z$") if twisted else ("shift", "shear_force", "$F_x$")
    limit = item.torque_limit if isinstance(item, TorsionSolution) else mu * item.force
    lines = [Quantity(series_of(item, load), symbol)]
    lines += bounds(load, limit, *(["bound of friction"] if twisted else [])) if math.isfinite(mu) else []
    names = {"friction_loss": "lost to friction", "bulk_loss": "lost in the bodies", "stored_energy": "stored"}
    radii = [(series_of(item, "radius"), "contact"), (series_of(item, "stick_radius"), "stick")]
    force = load.replace("_", " ")
    panels = (
        loop_panel(series_of(item, motion), series_of(item, load)),
        curves_panel(time, lines, label=force),
        energies_panel(item, names, height_factor=1.35),
        curves_panel(time, radii, label="radius"),
        recovering_panel(state, item.problem.bed),
        _loads_panel(state, mu),
    )
    when = f" at {with_unit(state.time, 's', 3)}"
    titles = (f"{force} over {motion}", force, "energy", "contact", f"springs{when}", f"their loads{when}")
    return Sheet(titled(panels, *titles), 3, width=3.9)


@without_extent(DraggedState)
@without_extent(DraggedTwist)
def dragged_state_sheet(item: DraggedState | DraggedTwist) -> Sheet:
    """Return the springs at one time, and their loads in both directions."""
    words = ("torque", "depth", "angle") if isinstance(item, DraggedTwist) else ("shear_force", "depth", "shift")
    panels = titled((recovering_panel(item), _loads_panel(item, math.inf)), "springs", "their loads")
    return Sheet(panels, height=3.3, title=headline(item, "force", *words))


def _loads_panel(state: DraggedState | DraggedTwist, coefficient: float) -> Panel:
    """Return the load of the springs along the surface, and the bound of friction; of a twist the load alone."""
    if state.radius == 0.0:
        return NO_CONTACT.plus(bare=True)
    along = series("x", state.position)
    known, twisted = math.isfinite(coefficient), isinstance(state, DraggedTwist)
    bound = coefficient * state.line_load if known and not twisted else np.zeros(state.line_load.shape)
    of, limit = (series("shear_load", loads) for loads in (state.shear_load, bound))
    x, y = style.mirrored(along.content, of.content)
    if twisted:  # to one side of the axis forwards, to the other back
        y = np.where(x < 0.0, -y, y)
    marks = (
        *stick_band(state.stick_radius),
        *mirrored_bounds(along.content, bound, r"$\pm\mu q_z$"),
        Line(x, y, style.RED, name="$q_x$"),
        Area(x, y, 0.0, style.RED, 0.12),
    )
    end = width_of(state)
    upright = PanelAxis.of(of, common_scale(of, limit), margin=0.2)
    return Panel(marks, PanelAxis.of(along, low=-end, high=end), upright, legend="upper right")


@without_extent(SlidingResistanceSolution)
def sliding_sheet(item: SlidingResistanceSolution) -> Sheet:
    """Return the resistance and the coefficient of friction over the speed, and the springs where it is greatest."""
    requested = np.ravel(np.asarray(item.speed, dtype=float))
    speeds = decades_around(requested, FACTOR_AROUND, POINTS)
    curve = item if requested.size >= POINTS else dataclasses.replace(item.problem, speed=speeds).solve()
    names = {"shear_force": "of the body", "line_shear_force": "of the line of springs"}
    pair = [answered(curve, item, "speed", name, label) for name, label in names.items()]
    place = int(np.argmax(np.ravel(np.asarray(curve.coefficient))))
    speed = with_unit(float(np.ravel(np.asarray(curve.speed))[place]), "m/s", 3)
    panels = (
        curves_panel(row_of(curve, "speed"), pair, label="resistance $F_x$"),
        curves_panel(row_of(curve, "speed"), [answered(curve, item, "speed", "coefficient")]),
        _trace_panel(curve, place),
    )
    titles = ("resistance", "coefficient", f"load of the springs at {speed}")
    return Sheet(titled(panels, *titles), width=3.9, height=3.3)


def _trace_panel(curve: SlidingResistanceSolution, place: int) -> Panel:
    """Return q(x) under the body, which moves to the right."""
    trace = curve.line(tuple(int(part) for part in np.unravel_index(place, np.shape(curve.speed))))
    along, of = series("x", trace.position), series("line_load", trace.line_load)
    marks = (
        Line(along.content, of.content),
        Area(along.content, of.content, 0.0),
        Rule(0.0, upright=True, dash=style.DASHED),
        note("moves to the right →", "upper left"),
    )
    upright = PanelAxis.of(of, low=0.0, high=1.25 * float(np.max(of.content)))
    return Panel(marks, PanelAxis.of(along, margin=0.04), upright)


@without_extent(ViscoelasticAdhesionSolution)
def adhesion_sheet(item: ViscoelasticAdhesionSolution) -> Sheet:
    """Return force over the position of the machine, depth and contact radius over time, and the speed of the edge."""
    time = series_of(item, "time")
    opening = np.where(item.crack_speed > 0.0, item.crack_speed, np.nan)
    edge, opens = series("crack_speed", opening, type(item)), bool(np.any(item.crack_speed > 0.0))
    speed = curves_panel(time, [(edge, "")], label="speed of the edge", log=opens)
    panels = (
        loop_panel(series_of(item, "position"), series_of(item, "force"), float(item.dissipation[-1])),
        depth_and_radius(item),
        speed,
    )
    titles = ("force over the position of the machine", "depth and contact", "opening speed of the edge")
    title = f"lowest force {with_unit(float(item.lowest_force[-1]), 'N')}"
    return Sheet(titled(panels, *titles), width=3.9, height=3.3, title=title)
