"""Sheets of adhesive answers: a contact that sticks, its equilibria, a cycle, a pull-off, a contact that is sheared."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.loading import Force
from winkler.plot import style
from winkler.plot.adhesion.cycles import draw_cycle, draw_sheared
from winkler.plot.adhesion.equilibria import draw_around, draw_equilibrium, draw_last, draw_radii
from winkler.plot.extent import around
from winkler.plot.medium import body_is_known, draw_stiffness
from winkler.plot.method import headline, line_load_of, pressure_of
from winkler.plot.normal.body import draw_contact
from winkler.plot.normal.springs import draw_springs
from winkler.plot.series import told
from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShearSolution

if TYPE_CHECKING:
    from collections.abc import Callable

    from winkler.plot.picture import Picture

__all__ = ["SHEETS", "contact_sheet", "cycle_sheet", "equilibrium_sheet", "pull_off_sheet", "shear_sheet"]


def contact_sheet(item: AdhesiveSolution, extent: float | None = None) -> Picture:
    """Return body, springs, pressure and equilibria of one contact; of a measured bed what is known of it.

    Parameters
    ----------
    item : AdhesiveSolution
        For one load.
    extent : float, optional
        [m].
    """
    end, bed = around(item.pressed, extent), item.pressed.bed
    known = body_is_known(bed)
    with style.styled():
        figure = style.figure(2, 2, height=3.2)
        panels = figure.subplots(2, 2, squeeze=False).ravel()
        draw_springs(panels[1], item.pressed, end)
        if known:
            draw_contact(panels[0], item, end)
            pressure_of(panels[2], item, end)
        else:
            draw_stiffness(panels[0], bed, end, float(item.radius))
            line_load_of(panels[2], item, end)
        if item.radius > 0.0:
            draw_around(panels[3], item)
        else:
            style.note(panels[3], "no contact", where="upper centre")
        titles = (
            "the contact" if known else "measured stiffness",
            "springs under $g(x) − d$",
            "pressure $p(r)$" if known else "load of the springs $q(x)$",
            "force over depth: states of equilibrium",
        )
        for axes, title in zip(panels, titles, strict=True):
            axes.set_title(title)
        figure.suptitle(headline(item))
    return figure


def equilibrium_sheet(item: EquilibriumCurve) -> Picture:
    """Return force and contact radius over the depth, with branches and jumps."""
    with style.styled():
        figure = style.figure(2, height=3.5)
        left, right = figure.subplots(1, 2)
        draw_equilibrium(left, item)
        draw_radii(right, item)
        left.set_title("force over depth")
        right.set_title("contact radius over depth")
        figure.suptitle(f"equilibria under {_machine_told(item.problem.machine_stiffness)}")
    return figure


def cycle_sheet(item: AdhesiveCycleSolution) -> Picture:
    """Return force and contact radius along a cycle, with its jumps and what is lost."""
    dead = isinstance(item.problem.path, Force)
    with style.styled():
        figure = style.figure(2, height=3.5)
        left, right = figure.subplots(1, 2)
        draw_cycle(left, right, item)
        left.set_title(f"force over {'depth' if dead else 'position of the machine'}")
        right.set_title("contact radius")
        machine = "a dead load" if dead else _machine_told(item.problem.machine_stiffness)
        count = len(item.jumps)
        figure.suptitle(f"slow cycle under {machine}: {count} jump{'' if count == 1 else 's'}")
    return figure


def shear_sheet(item: AdhesiveShearSolution) -> Picture:
    """Return shear force and contact radius over the shift."""
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        draw_sheared(left, right, item)
        left.set_title("shear force over shift")
        right.set_title("contact radius over shift")
    return figure


def pull_off_sheet(item: PullOffSolution) -> Picture:
    """Return where on the curve of equilibria the machine lets go."""
    with style.styled():
        figure = style.figure(width=5.2, height=3.5)
        axes = figure.add_subplot()
        draw_last(axes, item)
        axes.set_title(f"pull-off under {_machine_told(item.problem.machine_stiffness)}")
        figure.suptitle(headline(item))
    return figure


def _machine_told(stiffness: float) -> str:
    if stiffness == 0.0:
        return "a dead load"
    return "fixed grips" if np.isinf(stiffness) else f"a machine of {told(stiffness, 'N/m')}"


SHEETS: dict[type, Callable[[Any], Picture]] = {
    EquilibriumCurve: equilibrium_sheet,
    AdhesiveCycleSolution: cycle_sheet,
    AdhesiveShearSolution: shear_sheet,
    PullOffSolution: pull_off_sheet,
}
"""What draws an answer that is a curve."""
