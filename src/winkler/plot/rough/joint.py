"""Sheets of joints: stiffness per area over the pressure, its ratio, loops of friction and what they lose."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled, zero
from winkler.plot.rough.roughness import map_panel
from winkler.plot.series import row_of, series, with_unit
from winkler.problems.surface_friction.joint import JointStiffnessSolution

FEWEST_LOADS = 2
POINTS: dict[str, Any] = {"width": 0.0, "marker": "o", "size": 4.5}
MOST_LOOPS = 5


@without_extent(JointStiffnessSolution)
def joint_sheet(item: JointStiffnessSolution) -> Sheet:
    """Return stiffnesses and their ratio of many loads, or the pressures of one; loops and losses of the last load."""
    many = np.size(item.force) >= FEWEST_LOADS
    if many:
        ratios = {"along $x$": "ratio_x", "along $y$": "ratio_y", "disc as stiff across": "disc_ratio"}
        rows = [(row_of(item, of), name) for name, of in ratios.items()]
        over = curves_panel(row_of(item, "nominal_pressure"), rows, label="tangential over normal stiffness")
        panels, names = [_stiffness(item), over], ["stiffness per area", "along over across"]
    else:
        pressure = series("pressure", item.contact.last.pressure)
        panels, names = [map_panel(item.problem.topography, pressure, style.SHADES)], ["pressure"]
    turned = item.shift_amplitude, item.loss_per_cycle
    springs = Quantity(series("loss_per_cycle", item.spring_loss), "springs", turned, "boundary elements")
    several = np.size(item.shift_amplitude) > 1
    losses = curves_panel(series("shift_amplitude", item.spring_shift), [springs], log=several)
    across = dataclasses.replace(losses.across, log=several, plain=several)
    panels += [_loops(item), losses.plus(across=across)]
    names += ["loops of friction", "loss per cycle"]
    pressed = with_unit(float(np.ravel(np.asarray(item.nominal_pressure))[-1]), "Pa")
    shift, loss = (f"{100.0 * error:.2g} %" for error in (item.shift_error, item.loss_error))
    title = f"{pressed} on the whole map: springs differ by up to {shift} in shifts and {loss} in losses"
    return Sheet(titled(tuple(panels), *names), 2 if many else 3, width=4.2, height=3.3, title=title)


def _stiffness(item: JointStiffnessSolution) -> Panel:
    """Return the stiffnesses per area over the nominal pressure."""
    lines = [
        (row_of(item, "areal_stiffness"), "across"),
        (row_of(item, "areal_stiffness_x"), "along $x$"),
        (row_of(item, "areal_stiffness_y"), "along $y$"),
    ]
    finite = [(series_, name) for series_, name in lines if np.all(np.isfinite(series_.content))]
    return curves_panel(row_of(item, "nominal_pressure"), finite, label="stiffness per area")


def _loops(item: JointStiffnessSolution) -> Panel:
    """Return some loops by springs, and where boundary elements turn."""
    chosen = np.unique(np.linspace(0, item.share.size - 1, min(MOST_LOOPS, item.share.size)).round().astype(int))
    shift, force = series("shift_x", item.loop.shift_x), series("shear_force_x", item.loop.shear_force_x)
    marks: list[Any] = [zero()]
    for place, amplitude in enumerate(chosen.tolist()):
        marks.append(Line(*item.slip_loop(amplitude), style.BLUE, name="" if place else "springs"))
    marks.append(Line(shift.content, force.content, style.RED, name="boundary elements", **POINTS))
    return Panel(tuple(marks), PanelAxis.of(shift, margin=0.08), PanelAxis.of(force, margin=0.2), legend="upper left")
