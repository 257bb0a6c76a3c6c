"""Sheets of adhesive solutions: one contact, its equilibria, a cycle, a pull-off, a sheared contact."""

from __future__ import annotations

import numpy as np

from winkler.foundation.measured import MeasuredBed
from winkler.loading.loads import Force
from winkler.plot.adhesion.cycles import cycle_panels, sheared_panels
from winkler.plot.adhesion.equilibria import equilibrium_panel, pull_off_panel, radii_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.extent import around
from winkler.plot.medium import body_is_defined, stiffness_panel
from winkler.plot.method import force, line_load, pressure
from winkler.plot.normal.body import contact_panel
from winkler.plot.normal.springs import springs_panel
from winkler.plot.panel import NO_CONTACT, Sheet, titled
from winkler.plot.series import headline, with_unit
from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShearSolution
from winkler.problems.normal.indentation import IndentationSolution


def contact_sheet(item: IndentationSolution | AdhesiveSolution, extent: float | None = None) -> Sheet:
    """Return body, springs, their load and pressure of one contact; with adhesion equilibria in place of the load.

    Parameters
    ----------
    item : IndentationSolution or AdhesiveSolution
        For one load; of a measured bed its stiffness and F(d) stand for body and pressure.
    extent : float, optional
        [m].
    """
    end, bed = around(item.pressed, extent), item.pressed.bed
    defined, sticks = body_is_defined(bed), isinstance(item, AdhesiveSolution)
    body = contact_panel(item, end) if defined else stiffness_panel(bed, end, float(item.radius))
    measured = "measured stiffness" if isinstance(bed, MeasuredBed) else "stiffness"
    springs = springs_panel(item.pressed, end)
    parts = [(body, "the contact" if defined else measured), (springs, "springs under $g(x) − d$")]
    if not (sticks and defined):
        parts.append((line_load(item, end), "load of the springs $q(x)$"))
    if defined:
        parts.append((pressure(item, end), "pressure $p(r)$"))
    if sticks or not defined:
        curve = force(item) if (item.radius if sticks else item.depth) > 0.0 else NO_CONTACT
        parts.append((curve, f"force over depth{': states of equilibrium' if sticks else ''}"))
    return Sheet(tuple(panel.plus(title=title) for panel, title in parts), 2, height=3.2, title=headline(item))


@without_extent(EquilibriumCurve)
def equilibrium_sheet(item: EquilibriumCurve) -> Sheet:
    """Return force and contact radius over the depth, with branches and jumps."""
    panels = titled((equilibrium_panel(item), radii_panel(item)), "force over depth", "contact radius over depth")
    return Sheet(panels, height=3.5, title=f"equilibria under {_machine_text(item.problem.machine_stiffness)}")


@without_extent(AdhesiveCycleSolution)
def cycle_sheet(item: AdhesiveCycleSolution) -> Sheet:
    """Return force and contact radius along a cycle, with its jumps and the dissipated energy."""
    dead = isinstance(item.problem.path, Force)
    over = f"force over {'depth' if dead else 'position of the machine'}"
    machine = "a dead load" if dead else _machine_text(item.problem.machine_stiffness)
    count = len(item.jumps)
    title = f"slow cycle under {machine}: {count} jump{'' if count == 1 else 's'}"
    return Sheet(titled(cycle_panels(item), over, "contact radius"), height=3.5, title=title)


@without_extent(AdhesiveShearSolution)
def shear_sheet(item: AdhesiveShearSolution) -> Sheet:
    """Return shear force and contact radius over the shift."""
    return Sheet(titled(sheared_panels(item), "shear force over shift", "contact radius over shift"), height=3.3)


@without_extent(PullOffSolution)
def pull_off_sheet(item: PullOffSolution) -> Sheet:
    """Return the pull-off on the curve of equilibria."""
    title = f"pull-off under {_machine_text(item.problem.machine_stiffness)}"
    return Sheet((pull_off_panel(item).plus(title=title),), width=5.2, height=3.5, title=headline(item))


def _machine_text(stiffness: float) -> str:
    if stiffness == 0.0:
        return "a dead load"
    return "fixed grips" if np.isinf(stiffness) else f"a machine of {with_unit(stiffness, 'N/m')}"
