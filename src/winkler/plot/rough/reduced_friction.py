"""Sheets of springs under friction beside boundary elements: loops in two directions, and the stiffness of both."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.foundation.directional import DirectionalBed
from winkler.loading.loads import Depth, ShearForce
from winkler.loading.path import Path
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled, zero
from winkler.plot.series import Series, series, with_unit
from winkler.problems.friction.tangential import Tangential
from winkler.problems.surface_friction.reduced import ReducedFrictionSolution
from winkler.values.vocabulary import Word

POINTS_BETWEEN = 12
"""Points of a drawn loop for each compared one."""
ELEMENTS_LOOK: dict[str, Any] = {"width": 0.0, "marker": "o", "size": 4.0, "name": "boundary elements"}


@without_extent(ReducedFrictionSolution)
def reduced_friction_sheet(item: ReducedFrictionSolution) -> Sheet:
    """Return the loops along x and along y by springs and by elements, and both ratios of stiffness over the depth."""
    loops = (
        _loop(item, item.bed, item.shift[:, 0], ("shift_x", "shear_force_x")),
        _loop(item, item.bed.turned, item.shift[:, 1], ("shift_y", "shear_force_y")),
    )
    ratios = {"along $x$": item.bed.ratios_along, "along $y$": item.bed.ratios_across}
    rows = [(Series("ratio", Word("", "", "ratio of stiffness"), ratio), name) for name, ratio in ratios.items()]
    over = curves_panel(series("depth", item.bed.depths), rows, label="tangential over normal stiffness")
    panels = titled((*loops, over), "shear along $x$", "shear along $y$", "stiffness along the surface")
    shift, loss = (f"{100.0 * error:.2g} %" for error in (item.shift_error, item.loss_error))
    title = f"{with_unit(item.force, 'N')}: springs differ by up to {shift} in shifts and {loss} in losses"
    return Sheet(panels, 3, width=3.9, height=3.3, title=title)


def _loop(item: ReducedFrictionSolution, bed: DirectionalBed, shift: Array, names: tuple[str, str]) -> Panel:
    """Return the shear force over the shift."""
    problem, shear = item.problem, item.shear_force
    stops = np.arange(shear.size * POINTS_BETWEEN - POINTS_BETWEEN + 1) / POINTS_BETWEEN
    forces = np.interp(stops, np.arange(shear.size), shear)
    path = Path.through(Depth(problem.depth), ShearForce(forces))
    springs = Tangential(bed, problem.law, path).solve()
    along, of = series(names[0], shift), series(names[1], shear)
    marks = (
        zero(),
        Line(springs.shift, springs.shear_force, name="springs"),
        Line(shift, shear, style.RED, **ELEMENTS_LOOK),
    )
    return Panel(marks, PanelAxis.of(along, margin=0.06), PanelAxis.of(of, margin=0.12), legend="upper left")
