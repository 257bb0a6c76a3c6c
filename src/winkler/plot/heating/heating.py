"""Sheets of frictional heating: a map of temperature, the wake, flash temperatures over speed or time; fretting."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.curves import Quantity, answered, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.heating.over_loads import both_panel, curves_sheet, refuse_cold
from winkler.plot.panel import (
    Area,
    Arrow,
    Line,
    Map,
    Panel,
    PanelAxis,
    Rule,
    Sheet,
    note,
    plane,
    titled,
)
from winkler.plot.series import Series, row_of, series, with_unit
from winkler.problems.heating.fretting import FrettingHeatSolution
from winkler.problems.heating.heat_source import half_lengths
from winkler.problems.heating.heated_body import HeatedBody
from winkler.problems.heating.steady import FrictionHeatingSolution
from winkler.problems.heating.transient import TransientHeatingSolution
from winkler.problems.normal.indentation import IndentationSolution
from winkler.values.vocabulary import Word

EXTENT, WAKE = 1.7, 1.5
"""Half the side of the map over the semi-axes, and how much longer it is where the surface leaves the contact."""
POINTS, REFINEMENT = 33, 4
"""Points of the map across the contact at which the temperature is computed, and refinement of the drawing."""
LENGTHS, POINTS_ALONG = 3.0, 121
"""Places along the motion: how far they reach over half the contact, and their number."""
SPEEDS, DECADES_BEYOND = 25, 1.5
"""Number of speeds of the flash temperature curve, and decades below and above the requested one."""
SMALL = 0.1
"""Share of the temperature of bodies at rest below which the curve has a logarithmic axis."""
LEVELS = 12
ESTIMATES = (
    ("stationary_temperature", "at rest"),
    ("fast_temperature", "fast"),
    ("tian_kennedy_temperature", "Tian, Kennedy"),
)
MOMENTS_DRAWN = 6
RADII_DRAWN = 2.5


@without_extent(FrictionHeatingSolution)
def heating_sheet(item: FrictionHeatingSolution) -> Sheet:
    """Return the map of the body with the higher Peclet number, both surfaces along its motion, flash over speed.

    For many loads or speeds: flash temperature and heat partition over the varied quantity.
    """
    refuse_cold(item.flash_temperature)
    if np.ndim(item.heat_rate) != 0:
        return curves_sheet(item, item.stationary_temperature, "both at rest")
    heat_text = (
        f"   heat {with_unit(float(item.heat_rate), 'W')}   first body conducts "
        f"{with_unit(float(item.first_share), '')}"
    )
    fastest = with_unit(float(max(item.first_peclet, item.second_peclet)), "", 3)
    flash = with_unit(float(item.flash_temperature), "K")
    faster = item.first if item.first_peclet >= item.second_peclet else item.second
    panels = titled(
        (_map_panel(faster), _along_panel(item, faster), _speeds_panel(item)),
        f"surface of the {'first' if item.first_peclet >= item.second_peclet else 'second'} body",
        "along its motion, contact shaded",
        "flash temperature over the speed",
    )
    return Sheet(panels, width=4.1, height=3.2, title=f"$T_\\mathrm{{flash}}$ = {flash}{heat_text}   Pe = {fastest}")


def _forward(body: HeatedBody) -> float:
    """Return the angle of the motion to x [rad]."""
    return body.direction + (math.pi if body.speed < 0.0 else 0.0)


def _map_panel(body: HeatedBody) -> Panel:
    """Return isotherms around the contact and in the wake, which lies where the arrow points."""
    from scipy.interpolate import RectBivariateSpline

    assert body.source is not None  # of a contact that is heated
    forth = np.array([math.cos(_forward(body)), math.sin(_forward(body))])
    axes = [body.source.half_length(angle) for angle in (0.0, 0.5 * math.pi)]
    wide, wake = EXTENT * max(axes), (WAKE if body.speed else 0.0) * body.half_length * forth
    places = []
    for axis, drawn_out in zip(axes, wake, strict=True):
        half = max(EXTENT * axis, 0.6 * wide)
        ends = min(drawn_out, 0.0) - half, max(drawn_out, 0.0) + half
        places.append(np.linspace(*ends, round(POINTS * (ends[1] - ends[0]) / (2.0 * wide))))
    x, y = places
    rise = body.temperature(x[:, None], y[None, :])
    fine_x, fine_y = (np.linspace(line[0], line[-1], REFINEMENT * line.size) for line in (x, y))
    of = series("temperature", np.maximum(RectBivariateSpline(x, y, rise)(fine_x, fine_y), 0.0))
    bar = PanelAxis("rise of temperature", of.scale)
    look: dict[str, Any] = {"levels": LEVELS, "colours": style.HEATS, "line_width": 0.4, "shrink": 0.78}
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    marks: list[Any] = [
        Map(fine_x, fine_y, of.content.T, bar, **look),
        Line(axes[0] * np.cos(turn), axes[1] * np.sin(turn), style.INK, width=1.1),
        Line(np.array([body.warmest.x]), np.array([body.warmest.y]), style.INK, width=0.0, marker="+"),
    ]
    if body.speed != 0.0:
        long = 0.3 * wide
        corner = np.array([0.92 * x[0] + 0.08 * x[-1], 0.1 * y[0] + 0.9 * y[-1]])
        start = corner - np.array([min(forth[0], 0.0), max(forth[1], 0.0)]) * long
        end = start + long * forth
        marks.append(Arrow((float(start[0]), float(start[1])), (float(end[0]), float(end[1])), style.INK))
    return Panel(tuple(marks), *plane(series("x", fine_x).scale), equal=True, grid="")


def _along_panel(item: FrictionHeatingSolution, faster: HeatedBody) -> Panel:
    """Return the temperature of both surfaces along the motion of the body with the higher Peclet number."""
    length, forward = faster.half_length, _forward(faster)
    s = np.linspace(-LENGTHS, LENGTHS, POINTS_ALONG) * length
    rows = []
    for body, name in ((item.first, "first"), (item.second, "second")):
        moves = f"moves, Pe = {with_unit(body.peclet, '', 3)}" if body.speed else "rests"
        rows.append((body.temperature(s * math.cos(forward), s * math.sin(forward)), f"{name}: {moves}"))
    along = Series("place along the motion", Word("", "m", "place along the motion"), s)
    return both_panel(rows, along, length)


def _speeds_panel(item: FrictionHeatingSolution) -> Panel:
    """Return the flash temperature over the speed of sliding, relative to that of bodies at rest."""
    factors, problem = np.geomspace(10.0**-DECADES_BEYOND, 10.0**DECADES_BEYOND, SPEEDS), item.problem
    speeds = (np.asarray(problem.first_speed), np.asarray(problem.second_speed))
    curve = dataclasses.replace(problem, first_speed=factors * speeds[0], second_speed=factors * speeds[1]).solve()
    sliding = float(item.heat_rate) / (problem.law.coefficient * float(item.contact.force))
    speed, rest = factors * sliding, np.asarray(curve.stationary_temperature)
    ratio = Series("ratio", Word("", "", "over that of bodies at rest"), curve.flash_temperature / rest)
    asked = (sliding, float(item.flash_temperature) / float(item.stationary_temperature))
    rows = [Quantity(ratio, "flash temperature", asked, "requested")]
    for name, label in ESTIMATES[: None if isinstance(item.contact, IndentationSolution) else -1]:
        if np.all(np.isfinite(estimate := getattr(curve, name) / rest)):
            rows.append(Quantity(dataclasses.replace(ratio, content=estimate), label))
    least = float(np.min(ratio.content))
    along = Series("speed of sliding", Word("v", "m/s", "speed of sliding"), speed)
    panel = curves_panel(along, rows, label="over that of bodies at rest [-]", log=least <= SMALL)
    low, high = (0.0, 1.7) if least > SMALL else (0.5 * least, 20.0)
    upright = dataclasses.replace(panel.upright, low=low, high=high)
    return panel.plus(upright=upright, legend="upper right", columns=2)


@without_extent(TransientHeatingSolution)
def transient_heating_sheet(item: TransientHeatingSolution) -> Sheet:
    """Return the temperature of the contact over time, and along the surface of the first body at some times."""
    refuse_cold(item.stationary_temperature)
    low, high = float(np.min(item.time)), float(np.max(item.time))
    if high <= 10.0 * low:
        low, high = low / 30.0, high * 30.0
    curve = dataclasses.replace(item.problem, time=np.geomspace(low, high, 61)).solve()
    mean = np.maximum(curve.first_mean_temperature, curve.second_mean_temperature)
    final = item.stationary_temperature
    flash = answered(curve, item, "time", "flash_temperature", "flash temperature")
    left = curves_panel(row_of(curve, "time"), [flash, (series("temperature", mean), "mean")], log=False)
    end = Rule(final, colour=style.GREEN, width=1.2, dash=style.DASHES[2], name="in the end")
    left = left.plus(end, upright=dataclasses.replace(left.upright, low=0.0, high=1.15 * final))
    a = float(half_lengths(item.contact, 0.0))
    r = np.linspace(0.0, RADII_DRAWN, 61) * a
    moments = dataclasses.replace(item.problem, time=np.geomspace(low, high, MOMENTS_DRAWN)).solve()
    rows = moments.first_temperature(r)
    lines = [
        Line(r, row, (style.HEATS, float(share)), name=with_unit(float(moment), "s", 3))
        for row, moment, share in zip(rows, moments.time, np.linspace(0.1, 0.9, MOMENTS_DRAWN), strict=True)
    ]
    rise = series("temperature", rows)
    away = "r" if isinstance(item.contact, IndentationSolution) else "x"
    edge = Rule(a, upright=True, width=0.9, dash=style.DOTTED)
    upright = PanelAxis("rise of temperature $T$", rise.scale, low=0.0)
    right = Panel((*lines, edge), PanelAxis.of(series(away, r)), upright, legend="upper right")
    titles = ("temperature of the contact", "surface of the first body")
    return Sheet(titled((left, right), *titles), width=4.6, height=3.3)


@without_extent(FrettingHeatSolution)
def fretting_heat_sheet(item: FrettingHeatSolution) -> Sheet:
    """Return the heat flux of a cycle over the radius, and the mean temperature of the surface."""
    a = item.source.radius
    stick = a * float(item.source.joints[1])  # radius of the stick zone
    places = np.linspace(0.0, 1.8, 3 * POINTS_ALONG) * a
    along, of = series("r", places), series("flux", item.flux.at(places))
    marks: list[Any] = [Area(places, of.content, 0.0, style.RED), Line(places, of.content, style.RED)]
    if 0.0 < stick < a:
        marks.append(Rule(stick, upright=True, width=0.9, dash=style.DOTTED))
        marks.append(note(f"sticks within {with_unit(stick, 'm', 3)}", "upper left"))
    left = Panel(tuple(marks), PanelAxis.of(along), PanelAxis("mean heat flux $q$", of.scale, low=0.0))
    r = np.linspace(0.0, 1.8, POINTS_ALONG) * a
    rise = series("temperature", item.temperature(r))
    is_heated = (
        Line(r, rise.content),
        Rule(a, upright=True, width=0.9, dash=style.DOTTED),
        note(f"oscillates by about ±{with_unit(item.swing, 'K', 2)}"),
    )
    right = Panel(is_heated, PanelAxis.of(along), PanelAxis("mean rise of temperature", rise.scale, low=0.0))
    title = f"{with_unit(item.loss_per_cycle, 'J')} in every cycle, {with_unit(item.heat_rate, 'W')}"
    titles = ("heat flux over the radius", "temperature of the surfaces")
    return Sheet(titled((left, right), *titles), width=4.6, height=3.3, title=title)
