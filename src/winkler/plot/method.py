"""The single pictures of the method: body, springs, line load, pressure, stress, force.

`winkler.plot.draw` combines them on one sheet, a report shows each with a caption, the browser animates them.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np

from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.plot.extent import around
from winkler.plot.medium import MEASURED_BED, makeup_panel, spring_stiffness_panel, stiffness_panel
from winkler.plot.normal.body import contact_panel
from winkler.plot.normal.curves import (
    force_depth,
    line_load_panel,
    loaded_so_far,
    pressure_panel,
    surface,
    surface_panel,
)
from winkler.plot.normal.depths import disc_sheet
from winkler.plot.normal.springs import springs_panel
from winkler.plot.normal.stresses import stress_panel
from winkler.plot.panel import Panel, Sheet, note
from winkler.plot.series import with_unit
from winkler.problems.answer import is_dragged
from winkler.problems.normal.indentation import IndentationSolution
from winkler.values.checks.contract import is_a
from winkler.values.errors import InvalidInput, OutsideValidity

if TYPE_CHECKING:
    from winkler.problems.adhesion.indentation import AdhesiveSolution

    Contact = IndentationSolution | AdhesiveSolution  # the drawn object: a solution for one load


def adheres(solution: Any) -> TypeGuard[AdhesiveSolution]:
    """Return whether a contact adheres; the modules of adhesion are loaded for such contacts alone."""
    return is_a(solution, "winkler.problems.adhesion.indentation:AdhesiveSolution")


def bed_panels(bed: Any, to: float, radius: float = 0.0) -> tuple[Panel, Panel]:
    """Return E(z), or the measured k(a), and the stiffness of the springs.

    Parameters
    ----------
    bed : Bed
        Its springs.
    to : float
        Greatest x and, where the medium has no length of its own, depth [m].
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    if is_a(bed, MEASURED_BED):
        return stiffness_panel(bed, to, radius), spring_stiffness_panel(bed.medium, min(to, bed.reach), radius)
    return makeup_panel(bed.medium, to, radius), spring_stiffness_panel(bed.medium, to, radius)


def line_load(solution: Contact, to: float) -> Panel:
    """Return the line load q(x) of a contact, with its integral."""
    pull = 0.0
    if adheres(solution):
        from winkler.plot.adhesion.equilibria import pull_of

        pull = pull_of(solution)
    return line_load_panel(solution, to, float(solution.force), pull)


def pressure(solution: Contact, to: float) -> Panel:
    """Return p(r) of a contact, with its mean, or with the stress intensity at its edge."""
    if adheres(solution):
        return pressure_panel(solution, to, remark=_intensity(solution))
    radius = float(solution.pressed.radius)
    return pressure_panel(solution, to, float(solution.force) / (np.pi * radius**2) if radius > 0.0 else None)


def _intensity(solution: AdhesiveSolution) -> str:
    """Return the stress intensity factor at the edge as text; empty if the law has none."""
    try:
        return f"\n$K_I$ = {with_unit(float(solution.stress_intensity), 'Pa', 3)} m$^{{1/2}}$"
    except OutsideValidity:
        return ""


def stress(solution: Contact, to: float, *, scale: float | None = None) -> Panel:
    """Return the map of the stress below the surface; with a `scale` [m] at fewer points, without its maximum."""
    if solution.radius == 0.0:
        raise InvalidInput(
            "draw: the bodies do not touch under this load, so there is no stress to show; give more load."
        )
    if is_dragged(solution):
        from winkler.plot.friction.curves import RestorableSprings
        from winkler.plot.friction.stress import dragged_stress_panel, in_first

        sheared = solution.sheared
        first, radius = in_first(sheared.pressed.bed), sheared.pressed.radius
        return dragged_stress_panel(RestorableSprings(sheared), radius, to, first=first, scale=scale)
    return stress_panel(solution, to, float(solution.radius), scale=scale)


def force(solution: Contact, _: float = 0.0) -> Panel:
    """Return F(d) up to this load, or around it with adhesion, and the load itself as a point."""
    if adheres(solution):
        from winkler.plot.adhesion.equilibria import around_panel

        return around_panel(solution)
    depth = float(solution.depth)
    if depth <= 0.0:
        raise InvalidInput(
            "draw: the bodies do not touch under this load, so there is no F(d) up to it; give more load."
        )
    panel = loaded_so_far(solution.pressed, float(solution.force))
    gaps = np.isnan(force_depth(solution.pressed).of.content).any()
    notes = (note("gaps: there the contact is no single disc", "upper left"),) if gaps else ()
    return panel.plus(*notes, across=dataclasses.replace(panel.across, low=0.0, high=1.04 * depth))


def depths(solution: Contact, _: float = 0.0) -> Sheet:
    """Return the greatest stresses over the depth, of the contact pressed without friction."""
    return disc_sheet(solution.problem.bed, float(solution.depth))


PICTURES: dict[str, Callable[[Any, float], Panel | tuple[Panel, ...] | Sheet]] = {
    "shape": contact_panel,
    "medium": lambda solution, to: bed_panels(solution.pressed.bed, to, float(solution.radius)),
    "springs": lambda solution, to: springs_panel(solution.pressed, to),
    "line_load": line_load,
    "pressure": pressure,
    "displacement": lambda solution, to: surface_panel(surface(solution, 1.5 * to)),
    "stress": stress,
    "depths": depths,
    "force": force,
}
"""Name -> function of a solution for one load and of the extent [m]; in the order of the method."""


def pictures_of(solution: Contact) -> tuple[str, ...]:
    """Return the names of the pictures of a solution.

    A homogeneous medium has no picture of its own; stresses over the depth are drawn in isotropic half-spaces, where
    they take no time, and of bodies that do not adhere.
    """
    medium = solution.pressed.bed.medium
    left_out = {"medium"} if isinstance(medium, HomogeneousMedium) else set()
    if not isinstance(medium, HalfSpace) or adheres(solution):
        left_out |= {"depths"}
    return tuple(name for name in PICTURES if name not in left_out)


def method_sheet(name: str, solution: Contact, extent: float | None = None) -> Sheet:
    """Return one picture of the method.

    Parameters
    ----------
    name
        One of `PICTURES`.
    solution
        For one load.
    extent : float, optional
        Drawn up to this distance from the axis [m].

    Raises
    ------
    OutsideValidity
        If the drawn field cannot be computed for this contact.
    """
    panels = PICTURES[name](solution, around(solution.pressed, extent))
    if isinstance(panels, Sheet):
        return panels
    if isinstance(panels, Panel):
        return Sheet((panels,), width=5.0 if name == "stress" else 4.6, height=3.3)
    return Sheet(panels, height=3.3)
