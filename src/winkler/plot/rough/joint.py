"""Sheets of joints: stiffness per area over the pressure, its ratio, loops of friction and what they lose."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Panel, PanelAxis, Sheet, titled, zero
from winkler.plot.rough.roughness import map_panel, models_panel
from winkler.plot.series import row_of, scale_of, series, series_of, with_unit
from winkler.problems.surface_friction.joint import JointStiffnessSolution

FEWEST_LOADS = 2
RATIO_MARGIN = 0.05
"""Of the axis of the ratios, above and below."""
POINTS: dict[str, Any] = {"width": 0.0, "marker": "o", "size": 4.5}
MOST_LOOPS = 5


@without_extent(JointStiffnessSolution)
def joint_sheet(item: JointStiffnessSolution) -> Sheet:
    """Return stiffnesses and their ratio of many loads, or the pressures of one; loops and losses of the last load."""
    many = np.size(item.force) >= FEWEST_LOADS
    if many:
        panels, names = [_stiffness(item), _ratios(item)], ["stiffness per area", "along over across"]
    else:
        pressure = series("pressure", item.contact.last.pressure)
        panels, names = [map_panel(item.problem.topography, pressure, style.SHADES)], ["pressure"]
    panels += [_loops(item), _losses(item)]
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
    return models_panel(row_of(item, "nominal_pressure"), finite, label="stiffness per area")


def _ratios(item: JointStiffnessSolution) -> Panel:
    """Return tangential over normal stiffness, beside that of a disc."""
    pressure = row_of(item, "nominal_pressure")
    order = np.argsort(pressure.content, kind="stable")
    rows = {"along $x$": "ratio_x", "along $y$": "ratio_y", "disc as stiff across": "disc_ratio"}
    looks: tuple[dict[str, Any], ...] = (
        {"marker": "o", "size": 4.0},
        {"colour": style.RED, "marker": "o", "size": 4.0},
        {"colour": style.INK, "width": 1.0},
    )
    contents = [row_of(item, name).content[order] for name in rows.values()]
    marks = tuple(
        Line(pressure.content[order], content, name=name, **look)
        for content, name, look in zip(contents, rows, looks, strict=True)
    )
    both = np.concatenate(contents)
    ends: dict[str, Any] = {"low": float(np.nanmin(both)) - RATIO_MARGIN, "high": float(np.nanmax(both)) + RATIO_MARGIN}
    spread = bool(np.max(pressure.content) > 10.0 * np.min(pressure.content))
    across = PanelAxis.of(pressure, margin=0.04, log=spread, plain=spread)
    return Panel(marks, across, PanelAxis("tangential over normal stiffness", **ends), legend="best")


def _loops(item: JointStiffnessSolution) -> Panel:
    """Return some loops by springs, and where boundary elements turn."""
    chosen = np.unique(np.linspace(0, item.share.size - 1, min(MOST_LOOPS, item.share.size)).round().astype(int))
    shift, force = series("shift_x", item.loop.shift_x), series("shear_force_x", item.loop.shear_force_x)
    marks: list[Any] = [zero()]
    for place, amplitude in enumerate(chosen.tolist()):
        marks.append(Line(*item.slip_loop(amplitude), style.BLUE, name="" if place else "springs"))
    marks.append(Line(shift.content, force.content, style.RED, name="boundary elements", **POINTS))
    return Panel(tuple(marks), PanelAxis.of(shift, margin=0.08), PanelAxis.of(force, margin=0.2), legend="upper left")


def _losses(item: JointStiffnessSolution) -> Panel:
    """Return the losses over the amplitude of the shift."""
    shift, loss = series_of(item, "shift_amplitude"), series_of(item, "loss_per_cycle")
    marks = (
        Line(item.spring_shift, item.spring_loss, style.BLUE, name="springs"),
        Line(shift.content, loss.content, style.RED, name="boundary elements", **POINTS),
    )
    several = shift.content.size > 1
    x, y = (scale_of(one.word.unit, one.content) for one in (shift, loss))
    across = PanelAxis.of(shift, x, margin=0.08, log=several, plain=several)
    return Panel(marks, across, PanelAxis.of(loss, y, margin=0.1, log=several), legend="upper left")
