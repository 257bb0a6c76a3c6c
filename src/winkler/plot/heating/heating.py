"""Sheets of frictional heating: a map of temperature, the wake, flash temperatures over speed or time; fretting."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.heating.over_loads import curves_sheet, refuse_cold
from winkler.plot.panel import (
    Area,
    Arrow,
    Band,
    Line,
    Map,
    Panel,
    PanelAxis,
    Rule,
    Sheet,
    note,
    plane,
    points,
    titled,
)
from winkler.plot.series import common_scale, middle_scale, series, with_unit
from winkler.problems.heating.fretting import FrettingHeatSolution
from winkler.problems.heating.heat_source import half_lengths
from winkler.problems.heating.heated_body import HeatedBody
from winkler.problems.heating.steady import FrictionHeatingSolution
from winkler.problems.heating.transient import TransientHeatingSolution
from winkler.problems.normal.indentation import IndentationSolution

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
    ("stationary_temperature", "at rest", style.GREEN, style.DASHES[1]),
    ("fast_temperature", "fast", style.ORANGE, style.DASHES[3]),
    ("tian_kennedy_temperature", "Tian, Kennedy", style.PURPLE, style.DASHES[2]),
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
    marks: list[Any] = []
    for body, name, colour, dash in (
        (item.first, "first", style.RED, style.DASHES[0]),
        (item.second, "second", style.BLUE, style.DASHES[1]),
    ):
        moves = f"moves, Pe = {with_unit(body.peclet, '', 3)}" if body.speed else "rests"
        rise = body.temperature(s * math.cos(forward), s * math.sin(forward))
        marks.append(Line(s, rise, colour, dash=dash, name=f"{name}: {moves}"))
    rises = [series("temperature", line.y) for line in marks]
    high = 1.42 * max(float(np.max(rise.content)) for rise in rises)
    marks.append(Band(-length, length, style.MUTED, 0.12))
    across = PanelAxis("place along the motion", series("x", s).scale)
    upright = PanelAxis("rise of temperature $T$", common_scale(*rises), low=0.0, high=high)
    return Panel(tuple(marks), across, upright, legend="upper left")


def _speeds_panel(item: FrictionHeatingSolution) -> Panel:
    """Return the flash temperature over the speed of sliding, relative to that of bodies at rest."""
    factors, problem = np.geomspace(10.0**-DECADES_BEYOND, 10.0**DECADES_BEYOND, SPEEDS), item.problem
    speeds = (np.asarray(problem.first_speed), np.asarray(problem.second_speed))
    curve = dataclasses.replace(problem, first_speed=factors * speeds[0], second_speed=factors * speeds[1]).solve()
    sliding = float(item.heat_rate) / (problem.law.coefficient * float(item.contact.force))
    speed, rest = factors * sliding, np.asarray(curve.stationary_temperature)
    marks = [Line(speed, curve.flash_temperature / rest, name="flash temperature")]
    for name, label, colour, dash in ESTIMATES[: None if isinstance(item.contact, IndentationSolution) else -1]:
        estimate = np.asarray(getattr(curve, name)) / rest
        if np.all(np.isfinite(estimate)):
            marks.append(Line(speed, estimate, colour, width=1.2, dash=dash, name=label))
    requested = float(item.flash_temperature) / float(item.stationary_temperature)
    marks.append(points(sliding, requested, name="requested", order=5.0))
    across = PanelAxis("speed of sliding $v$", middle_scale("m/s", speed), log=True)
    least = float(np.min(curve.flash_temperature / rest))
    ends: dict[str, Any] = (
        {"low": 0.0, "high": 1.7} if least > SMALL else {"low": 0.5 * least, "high": 20.0, "log": True}
    )
    upright = PanelAxis("over that of bodies at rest [-]", **ends)
    return Panel(tuple(marks), across, upright, legend="upper right", columns=2)


@without_extent(TransientHeatingSolution)
def transient_heating_sheet(item: TransientHeatingSolution) -> Sheet:
    """Return the temperature of the contact over time, and along the surface of the first body at some times."""
    refuse_cold(item.stationary_temperature)
    low, high = float(np.min(item.time)), float(np.max(item.time))
    if high <= 10.0 * low:
        low, high = low / 30.0, high * 30.0
    curve = dataclasses.replace(item.problem, time=np.geomspace(low, high, 61)).solve()
    time = series("time", curve.time)
    of = series("flash_temperature", curve.flash_temperature)
    mean = np.maximum(curve.first_mean_temperature, curve.second_mean_temperature)
    final = item.stationary_temperature
    marks = (
        Line(time.content, of.content, name="flash temperature"),
        Line(time.content, mean, style.ORANGE, dash=style.DASHES[1], name="mean"),
        Rule(final, colour=style.GREEN, width=1.2, dash=style.DASHES[2], name="in the end"),
        points(item.time, item.flash_temperature, size=3.5, name="requested"),
    )
    across = PanelAxis.of(time, middle_scale("s", time.content), log=True)
    left = Panel(marks, across, PanelAxis.of(of, low=0.0, high=1.15 * final), legend="lower right")
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
