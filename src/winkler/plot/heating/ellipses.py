"""Sheets of the frictional heat of elliptic contacts: a map, both surfaces, and flash temperature over speed."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.heating.over_loads import curves_sheet, refuse_cold
from winkler.plot.panel import Arrow, Line, Map, Panel, PanelAxis, Rule, Sheet, plane, points, titled
from winkler.plot.series import common_scale, middle_scale, series, with_unit
from winkler.problems.heating.elliptic_heating import EllipticFrictionHeatingSolution
from winkler.problems.heating.heated_ellipse import HeatedEllipse

__all__ = ["elliptic_heating_sheet"]

EXTENT = 1.7
"""Of the map over the semi-axes."""
PLACES, REFINEMENT = 33, 4
LENGTHS = 3.0
PLACES_ALONG = 121
LEVELS = 12
SPEEDS, DECADES_BEYOND = 21, 1.5


@without_extent(EllipticFrictionHeatingSolution)
def elliptic_heating_sheet(item: EllipticFrictionHeatingSolution) -> Sheet:
    """Return the map of the body with the higher Peclet number, both surfaces along its motion, flash over speed.

    For many loads or speeds: flash temperature and heat partition over the varied quantity.
    """
    refuse_cold(item.flash_temperature)
    if np.ndim(item.heat_rate) != 0:
        return curves_sheet(item, item.stationary_temperature, "both at rest")
    faster = item.first if item.first_peclet >= item.second_peclet else item.second
    panels = titled(
        (_map_panel(faster), _along_panel(item, faster), _speeds_panel(item)),
        f"surface of the {'first' if item.first_peclet >= item.second_peclet else 'second'} body",
        "along its motion, through the middle",
        "flash temperature over the speed",
    )
    flash, heat = with_unit(float(item.flash_temperature), "K"), with_unit(float(item.heat_rate), "W")
    share = with_unit(float(item.first_share), "")
    title = f"$T_\\mathrm{{flash}}$ = {flash}   heat {heat}   first body takes {share}"
    return Sheet(panels, width=4.1, height=3.2, title=title)


def _forward(body: HeatedEllipse) -> float:
    return body.direction + (math.pi if body.speed < 0.0 else 0.0)


def _map_panel(body: HeatedEllipse) -> Panel:
    from scipy.interpolate import RectBivariateSpline

    a, b = body.longitudinal_semi_axis, body.lateral_semi_axis
    wide = EXTENT * max(a, b)
    x = np.linspace(-1.0, 1.0, PLACES) * max(EXTENT * a, 0.6 * wide)
    y = np.linspace(-1.0, 1.0, PLACES) * max(EXTENT * b, 0.6 * wide)
    rise = body.temperature(x[:, None], y[None, :])
    fine_x, fine_y = (np.linspace(line[0], line[-1], REFINEMENT * line.size) for line in (x, y))
    of = series("temperature", np.maximum(RectBivariateSpline(x, y, rise)(fine_x, fine_y), 0.0))
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    look: dict[str, Any] = {"levels": LEVELS, "colours": style.HEATS, "line_width": 0.4, "shrink": 0.78}
    warmest = body.warmest
    marks: list[Any] = [
        Map(fine_x, fine_y, of.content.T, PanelAxis("rise of temperature", of.scale), **look),
        Line(a * np.cos(turn), b * np.sin(turn), style.INK, width=1.1),
        Line(np.array([warmest.x]), np.array([warmest.y]), style.INK, width=0.0, marker="+"),
    ]
    if body.speed != 0.0:
        forth = np.array([math.cos(_forward(body)), math.sin(_forward(body))])
        start = np.array([0.85 * x[0], 0.85 * y[-1]]) - np.minimum(forth, 0.0) * 0.3 * np.array([1.0, 0.0]) * wide
        start -= np.maximum(forth, 0.0) * 0.3 * np.array([0.0, 1.0]) * wide
        end = start + 0.3 * wide * forth
        marks.append(Arrow((float(start[0]), float(start[1])), (float(end[0]), float(end[1])), style.INK))
    return Panel(tuple(marks), *plane(series("x", fine_x).scale), equal=True, grid="")


def _along_panel(item: EllipticFrictionHeatingSolution, faster: HeatedEllipse) -> Panel:
    """Return the temperature of both surfaces along the motion of the body with the higher Peclet number."""
    length, forward = faster.half_length, _forward(faster)
    s = np.linspace(-LENGTHS, LENGTHS, PLACES_ALONG) * length
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
    marks += [Rule(edge, upright=True, width=0.9, dash=style.DOTTED) for edge in (-length, length)]
    across = PanelAxis("place along the motion", series("x", s).scale)
    upright = PanelAxis("rise of temperature $T$", common_scale(*rises), low=0.0, high=high)
    return Panel(tuple(marks), across, upright, legend="upper left")


def _speeds_panel(item: EllipticFrictionHeatingSolution) -> Panel:
    """Return the flash temperature over the speed of sliding, relative to that of bodies at rest."""
    factors, problem = np.geomspace(10.0**-DECADES_BEYOND, 10.0**DECADES_BEYOND, SPEEDS), item.problem
    speeds = (np.asarray(problem.first_speed), np.asarray(problem.second_speed))
    curve = dataclasses.replace(problem, first_speed=factors * speeds[0], second_speed=factors * speeds[1]).solve()
    once = float(item.heat_rate) / (problem.law.coefficient * float(item.contact.force))
    rest, sliding = np.asarray(curve.stationary_temperature), factors * once
    requested = float(item.flash_temperature) / float(item.stationary_temperature)
    marks = (
        Line(sliding, curve.flash_temperature / rest, name="flash temperature"),
        Line(sliding, curve.fast_temperature / rest, style.ORANGE, width=1.2, dash=style.DASHES[3], name="fast"),
        points(once, requested, name="requested", order=5.0),
    )
    across = PanelAxis("speed of sliding $v$", middle_scale("m/s", sliding), log=True)
    high = 1.7 * max(float(np.max(curve.flash_temperature / rest)), requested)
    return Panel(marks, across, PanelAxis("over that of bodies at rest [-]", low=0.0, high=high), legend="upper right")
