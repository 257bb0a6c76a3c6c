"""Sheets of strips of heat: both surfaces along the motion, and flash temperature over speed."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.heating.over_loads import curves_sheet, refuse_cold
from winkler.plot.panel import Band, Line, Panel, PanelAxis, Sheet, points, titled
from winkler.plot.series import common_scale, middle_scale, series, with_unit
from winkler.problems.heating.band_heating import BandHeatingSolution
from winkler.problems.heating.line_heating import LineFrictionHeatingSolution

HALF_WIDTHS = 4.0
PLACES = 161
SPEEDS, DECADES_BEYOND = 21, 1.5
StripSolution = LineFrictionHeatingSolution | BandHeatingSolution


@without_extent(LineFrictionHeatingSolution, BandHeatingSolution)
def strip_heating_sheet(item: StripSolution) -> Sheet:
    """Return the temperature of both surfaces across the strip, and the flash temperature over the speed.

    For many loads or speeds: flash temperature and heat partition over the varied quantity.
    """
    refuse_cold(item.flash_temperature)
    if np.ndim(item.heat_per_length) != 0:
        return curves_sheet(item, item.fast_temperature, "both fast")
    panels = titled(
        (_across_panel(item), _speeds_panel(item)), "across the strip, shaded", "flash temperature over speed"
    )
    flash, heat = with_unit(float(item.flash_temperature), "K"), with_unit(float(item.heat_per_length), "W/m")
    share = with_unit(float(item.first_share), "")
    title = f"$T_\\mathrm{{flash}}$ = {flash}   heat {heat}   first body conducts {share}"
    return Sheet(panels, width=4.6, height=3.2, title=title)


def _across_panel(item: StripSolution) -> Panel:
    a = float(item.half_width)
    x = np.linspace(-HALF_WIDTHS, HALF_WIDTHS, PLACES) * a
    marks: list[Any] = []
    for body, name, colour, dash in (
        (item.first, "first", style.RED, style.DASHES[0]),
        (item.second, "second", style.BLUE, style.DASHES[1]),
    ):
        if body.heat_per_length > 0.0:
            label = f"{name}: Pe = {with_unit(body.peclet, '', 3)}"
            marks.append(Line(x, body.temperature(x), colour, dash=dash, name=label))
    rises = [series("temperature", line.y) for line in marks]
    marks.append(Band(-a, a, style.MUTED, 0.12))
    high = 1.42 * max(float(np.max(rise.content)) for rise in rises)
    across = PanelAxis("$x$ along the motion", series("x", x).scale)
    upright = PanelAxis("rise of temperature $T$", common_scale(*rises), low=0.0, high=high)
    return Panel(tuple(marks), across, upright, legend="upper left")


def _speeds_panel(item: StripSolution) -> Panel:
    problem, rates = item.problem, [float(each) for each in (item.problem.first_speed, item.problem.second_speed)]
    rubs = isinstance(item, LineFrictionHeatingSolution)
    pace = abs(rates[0] - rates[1]) if rubs else max(map(abs, rates))
    factors = np.geomspace(10.0**-DECADES_BEYOND, 10.0**DECADES_BEYOND, SPEEDS)
    curve = dataclasses.replace(problem, first_speed=factors * rates[0], second_speed=factors * rates[1]).solve()
    speed, flash = factors * pace, series("flash_temperature", curve.flash_temperature)
    marks: list[Any] = [Line(speed, flash.content, name="flash temperature")]
    fast = np.asarray(curve.fast_temperature)
    if np.all(np.isfinite(fast)):
        marks.append(Line(speed, fast, style.ORANGE, width=1.2, dash=style.DASHES[3], name="fast"))
    marks.append(points(pace, float(item.flash_temperature), name="requested", order=5.0))
    label = "speed of sliding $v$" if rubs else "speed of the faster surface $V$"
    across = PanelAxis(label, middle_scale("m/s", speed), log=True)
    scale = middle_scale("K", flash.content)
    legend = "upper left" if rubs else "upper right"  # friction makes more heat at speed, and the curve rises
    return Panel(tuple(marks), across, PanelAxis("flash temperature", scale, log=True), legend=legend)
