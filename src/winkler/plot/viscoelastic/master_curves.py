"""Sheets of master curves: shifted sweeps, shift factors with both laws, spectrum, and residuals."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Sheet, points, titled, zero
from winkler.plot.series import Series, middle_scale
from winkler.problems.master_curves.master_curve import MasterCurveSolution
from winkler.values.vocabulary import Word

POINTS = 241
ROOM = 4.0
"""Upper end of the moduli over the greatest one: there stands the legend."""
WIDEST = math.log(1e3)
"""Half-width of an interval, in logarithms, beyond which it is not drawn."""
NAMES = {Response.STORAGE: "storage $G'$", Response.LOSS: "loss $G''$", Response.RELAXATION: "relaxation $G(t)$"}


@without_extent(MasterCurveSolution)
def master_curve_sheet(item: MasterCurveSolution) -> Sheet:
    """Return the shifted sweeps with their fit, the shifts with both laws, the spectrum and the residuals."""
    panels = _curve(item), _shifts(item), _residuals(item), _spectrum(item)
    titles = ("master curve", "shift factors", "residuals", "relaxation spectrum")
    return Sheet(titled(panels, *titles), 2, width=4.6, height=3.3)


def _shifted(item: MasterCurveSolution, one: Measurements) -> tuple[Array, Array]:
    """Return abscissa and modulus at the reference temperature."""
    factor = item.shift_factor[one.group]
    at = one.abscissa / factor if one.response is Response.RELAXATION else one.abscissa * factor
    return at, one.modulus / item.vertical_factor[one.group]


def _along(item: MasterCurveSolution, at: Array) -> Series:
    if item.problem.measured[0].response is Response.RELAXATION:
        return Series("time", Word("t/a_T", "s", "shifted time"), at)
    return Series("angular_frequency", Word(r"\omega\,a_T", "rad/s", "shifted angular frequency"), at)


def _curve(item: MasterCurveSolution) -> Panel:
    measured = item.problem.measured
    rows = [_shifted(item, one) for one in measured]
    low, high = min(x.min() for x, _ in rows), max(x.max() for x, _ in rows)
    at = np.geomspace(low, high, POINTS)
    solid = item.solid
    model = {Response.STORAGE: solid.storage, Response.LOSS: solid.loss, Response.RELAXATION: solid.relaxation}
    marks: list[Line] = []
    for place, (one, (x, y)) in enumerate(zip(measured, rows, strict=True)):
        marks.append(points(x, y, style.CYCLE[place], size=2.5, name=NAMES[one.response]))
        marks.append(Line(at, model[one.response](at), style.INK, width=1.0, name="" if place else "fit"))
    modulus = Series("modulus", Word("G", "Pa", "modulus"), np.concatenate([y for _, y in rows]))
    scale = middle_scale("Pa", modulus.content)
    return Panel(
        tuple(marks),
        PanelAxis.of(_along(item, at), log=True, plain=True, parts=5, margin=0.03),
        PanelAxis.of(modulus, scale, log=True, plain=True, margin=0.05, high=ROOM * float(np.max(modulus.content))),
        legend="upper center",
        columns=3,
        spaced=True,
    )


def _shifts(item: MasterCurveSolution) -> Panel:
    """Return decadic logarithms of the shifts with 95 % intervals, and both laws."""
    warmth = item.temperature
    decades, errors = np.log10(item.shift_factor), 1.96 * item.shift_error / math.log(10.0)
    drawn = np.linspace(float(warmth.min()), float(warmth.max()), POINTS)
    laws = item.laws
    marks = (
        *(
            Line(drawn, np.log10([law.factor(t) for t in drawn.tolist()]), colour, width=1.2, dash=dash, name=name)
            for law, colour, dash, name in (
                (laws.ferry, style.BLUE, (), "Williams, Landel, Ferry"),
                (laws.arrhenius, style.ORANGE, (4.0, 2.0), "Arrhenius"),
            )
        ),
        points(warmth, decades, style.RED, size=4.0, error_y=np.vstack([errors, errors]), name="shifts, 95 %"),
    )
    across = PanelAxis.of(Series("temperature", Word("T", "K", "temperature"), warmth), margin=0.05)
    shift = Series("shift", Word(r"\log_{10}a_T", "", "decadic logarithm of the shift factor"), decades)
    return Panel(marks, across, PanelAxis.of(shift, margin=0.08), legend="best")


def _residuals(item: MasterCurveSolution) -> Panel:
    marks: list[Any] = [zero()]
    first = 0
    places = []
    for place, one in enumerate(item.problem.measured):
        row = item.residuals[first : first + one.modulus.size]
        first += one.modulus.size
        at, _ = _shifted(item, one)
        places.append(at)
        marks.append(points(at, row, style.CYCLE[place], size=2.5, name=NAMES[one.response]))
    misfit = Series("residuals", Word("", "", "relative residual"), item.residuals)
    return Panel(
        tuple(marks),
        PanelAxis.of(_along(item, np.concatenate(places)), log=True, plain=True, parts=5, margin=0.03),
        PanelAxis.of(misfit, margin=0.08),
    )


def _spectrum(item: MasterCurveSolution) -> Panel:
    """Return the moduli of the spectrum with their 95 % intervals, grey where they are not determined."""
    time = Series("relaxation_times", Word(r"\tau", "s", "relaxation time"), item.relaxation_times)
    width = 1.96 * item.shears_error
    known = width < WIDEST
    low, high = item.shears * np.exp(-width), item.shears * np.exp(width)
    shears = Series("shears", Word("G_i", "Pa", "shear modulus"), item.shears)
    marks = (
        Area(item.relaxation_times[known], low[known], high[known], alpha=0.25),
        Line(item.relaxation_times, item.shears, marker="o", size=3.0),
    )
    ends = {"low": 0.3 * float(low[known].min()), "high": 2.0 * float(high[known].max())}
    return Panel(
        marks,
        PanelAxis.of(time, log=True, plain=True, parts=5, margin=0.03),
        PanelAxis.of(shears, middle_scale("Pa", item.shears), log=True, plain=True, **ends),
    )
