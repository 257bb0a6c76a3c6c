"""Sheets of strips of heat: both surfaces along the motion, and flash temperature over speed."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.heating.over_loads import both_panel, curves_sheet, refuse_cold
from winkler.plot.panel import Panel, Sheet, titled
from winkler.plot.series import Series, row_of, with_unit
from winkler.problems.heating.band_heating import BandHeatingSolution
from winkler.problems.heating.line_heating import LineFrictionHeatingSolution
from winkler.values.vocabulary import Word

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
    rows = [
        (body.temperature(x), f"{name}: Pe = {with_unit(body.peclet, '', 3)}")
        for body, name in ((item.first, "first"), (item.second, "second"))
        if body.heat_per_length > 0.0
    ]
    return both_panel(rows, Series("place along the motion", Word("x", "m", "place"), x), a)


def _speeds_panel(item: StripSolution) -> Panel:
    problem, rates = item.problem, [float(each) for each in (item.problem.first_speed, item.problem.second_speed)]
    rubs = isinstance(item, LineFrictionHeatingSolution)
    pace = abs(rates[0] - rates[1]) if rubs else max(map(abs, rates))
    factors = np.geomspace(10.0**-DECADES_BEYOND, 10.0**DECADES_BEYOND, SPEEDS)
    curve = dataclasses.replace(problem, first_speed=factors * rates[0], second_speed=factors * rates[1]).solve()
    name, symbol = ("speed of sliding", "v") if rubs else ("speed of the faster surface", "V")
    asked = (pace, item.flash_temperature)
    rows = [Quantity(row_of(curve, "flash_temperature"), "flash temperature", asked, "requested")]
    fast = row_of(curve, "fast_temperature")
    if np.all(np.isfinite(fast.content)):
        rows.append(Quantity(fast, "fast"))
    return curves_panel(Series(name, Word(symbol, "m/s", name), factors * pace), rows, log=True)
