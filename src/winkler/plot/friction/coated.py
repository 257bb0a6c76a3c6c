"""Sheets of a contact that is pushed on a coating: a path, and one state of it."""

from __future__ import annotations

import contextlib

import numpy as np

from winkler.errors import OutsideValidity
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import BOUNDS, bounds, energies_panel, lines_panel, loop_panel
from winkler.plot.friction.sheets import ENERGY_NAMES, RADII_DRAWN, ring_panel
from winkler.plot.friction.stress import dragged_stress_panel
from winkler.plot.panel import NO_CONTACT, Sheet, titled
from winkler.plot.series import headline, series, with_unit
from winkler.problems.coated_friction.state import CoatedTangentialState
from winkler.problems.coated_friction.tangential import CoatedTangentialSolution

__all__ = ["coated_sheet", "coated_state_sheet"]

SYMBOL = r"$\tau$"


@without_extent(CoatedTangentialSolution)
def coated_sheet(item: CoatedTangentialSolution) -> Sheet:
    """Return the loop, forces and energies along a path, and the traction at its last contact."""
    touching = np.flatnonzero(item.radius > 0.0)
    time, shift, force = (series(name, getattr(item, name)) for name in ("time", "shift", "shear_force"))
    limit = item.problem.law.coefficient * item.force
    lines = [(force, "shear force"), *bounds("shear_force", limit, BOUNDS[0])]
    panels = titled(
        (
            loop_panel(shift, force, float(item.dissipation[-1])),
            lines_panel(time, lines, "shear force"),
            energies_panel(item, ENERGY_NAMES),
            ring_panel(item.states[int(touching[-1])], SYMBOL) if touching.size else NO_CONTACT,
        ),
        "shear force over shift",
        "shear force over time",
        "energy of the tangential motion",
        "traction along the motion",
    )
    return Sheet(panels, 2, height=3.2)


@without_extent(CoatedTangentialState)
def coated_state_sheet(item: CoatedTangentialState) -> Sheet:
    """Return the traction of a pushed contact, and where it can be computed the stress below it."""
    panels = [(ring_panel(item, SYMBOL) if item.radius > 0.0 else NO_CONTACT).plus(title="traction along the motion")]
    with contextlib.suppress(OutsideValidity):
        if item.radius > 0.0:
            below = dragged_stress_panel(item, item.radius, RADII_DRAWN * item.radius)
            panels.append(below.plus(title="stress below the surface"))
    title = f"{headline(item)}   $F_x$ = {with_unit(item.shear_force, 'N')}"
    return Sheet(tuple(panels), len(panels), width=5.0, title=title)
