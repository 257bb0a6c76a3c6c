"""Sheets of frictional heating: a map of temperature, the wake, flash temperatures over speed or time; fretting."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np

from winkler.errors import OutsideValidity
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.series import common_scale, middle_scale, scale_of, series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.problems.heating.fretting import FrettingHeatSolution
from winkler.problems.heating.heated_body import HeatedBody
from winkler.problems.heating.steady import FrictionHeatingSolution
from winkler.problems.heating.transient import TransientHeatingSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap

    from winkler.plot.picture import Picture

__all__ = ["fretting_heat_sheet", "heating_sheet", "transient_heating_sheet"]

BEFORE, BEHIND, BESIDE = 1.8, 3.2, 1.7
"""How far the map reaches, in contact radii."""
COLUMNS, ROWS, FINE = 49, 15, 4
"""Places of the map where the temperature is computed, and how many times finer it is drawn."""
ALONG = 121
SPEEDS, DECADES = 25, 1.5
"""Speeds at which the flash temperature is drawn, and how far below and above the one that was asked."""
LEVELS = 12
ESTIMATES = (
    ("stationary_temperature", "at rest", style.GREEN, style.DASHES[1]),
    ("fast_temperature", "fast", style.ORANGE, style.DASHES[3]),
    ("tian_kennedy_temperature", "Tian, Kennedy", style.PURPLE, style.DASHES[2]),
)
MOMENTS = 6
FAR = 2.5


@draw.register(FrictionHeatingSolution)
def heating_sheet(item: FrictionHeatingSolution, *, extent: float | None = None) -> Picture:
    """Return the map of the warmer wake, both bodies along their middle line, and the flash temperature over speed.

    Of many loads or speeds at once: the flash temperature and the share, over what was varied.
    """
    refuse_extent(item, extent)
    if not np.any(np.asarray(item.flash_temperature) > 0.0):
        raise OutsideValidity("draw: nothing warms up, so there is nothing to show; press and slide.")
    if np.ndim(item.heat_rate) != 0:
        return _many(item)
    told_heat = f"   heat {told(float(item.heat_rate), 'W')}   first body takes {told(float(item.first_share), '')}"
    fastest = told(float(max(item.first_peclet, item.second_peclet)), "", 3)
    with style.styled():
        figure = style.figure(3, width=4.1, height=3.2)
        panels = figure.subplots(1, 3)
        faster = item.first if item.first_peclet >= item.second_peclet else item.second
        _draw_map(panels[0], faster, "first" if faster == item.first else "second")
        _draw_wake(panels[1], item)
        _draw_speeds(panels[2], item)
        flash = told(float(item.flash_temperature), "K")
        figure.suptitle(f"$T_\\mathrm{{flash}}$ = {flash}{told_heat}   Pe = {fastest}")
    return figure


def _draw_map(axes: Axes, body: HeatedBody, name: str) -> None:
    """Draw lines of equal temperature around the contact, the wake to the right of a body that moves forwards."""
    from scipy.interpolate import RectBivariateSpline

    a = body.pressed.radius
    forth = -1.0 if body.speed < 0.0 else 1.0
    x = np.sort(forth * np.linspace(-BEFORE, BEHIND, COLUMNS)) * a
    y = np.linspace(0.0, BESIDE, ROWS) * a
    rise = body.temperature(x[:, None], y[None, :])
    fine_x, fine_y = (np.linspace(line[0], line[-1], FINE * line.size) for line in (x, y))
    fine = np.maximum(RectBivariateSpline(x, np.concatenate([-y[:0:-1], y]), _mirror(rise))(fine_x, fine_y), 0.0)
    along, of = series("HeatedBody", "x", fine_x), series("FrictionHeatingSolution", "temperature", _mirror(fine))
    across = np.concatenate([-fine_y[:0:-1], fine_y]) / along.scale.factor
    filled = axes.contourf(along.shown(), across, of.shown().T, levels=LEVELS, cmap=_heats())
    axes.contour(
        along.shown(), across, of.shown().T, levels=np.asarray(filled.levels)[1:], colors="white", linewidths=0.4
    )
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    rim = a / along.scale.factor
    axes.plot(rim * np.cos(turn), rim * np.sin(turn), color=style.INK, linewidth=1.1)
    peak = body.warmest
    axes.plot([peak.x / along.scale.factor], [peak.y / along.scale.factor], "+", color=style.INK)
    if body.speed != 0.0:
        axes.annotate(
            "", xy=(forth * 2.9 * rim, 1.45 * rim), xytext=(forth * 1.7 * rim, 1.45 * rim),
            arrowprops={"arrowstyle": "-|>", "color": style.INK},
        )  # fmt: skip
    axes.set_aspect("equal")
    axes.grid(visible=False)
    axes.set_xlabel(f"$x$ [{along.scale.unit}]")
    axes.set_ylabel(f"$y$ [{along.scale.unit}]")
    axes.figure.colorbar(filled, ax=axes, shrink=0.78, label=f"rise of temperature [{of.scale.unit}]")
    axes.set_title(f"surface of the {name} body")


def _heats() -> Colormap:
    """Return the colour map of temperatures: the darker, the warmer."""
    from matplotlib import colormaps

    return colormaps["YlOrRd"]


def _mirror(half: Array) -> Array:
    return np.concatenate([half[:, :0:-1], half], axis=1)


def _draw_wake(axes: Axes, item: FrictionHeatingSolution) -> None:
    """Draw the temperature of both surfaces along the middle line."""
    a = float(item.contact.radius)
    x = np.linspace(-BEHIND, BEHIND, ALONG) * a
    along = series("HeatedBody", "x", x)
    rises = [
        series("FrictionHeatingSolution", "temperature", body.temperature(x)) for body in (item.first, item.second)
    ]
    scale = common_scale(*rises)
    for rise, body, name, color, dash in zip(
        rises, (item.first, item.second), ("first", "second"), (style.RED, style.BLUE), style.DASHES, strict=False
    ):
        moves = f"moves, Pe = {told(body.peclet, '', 3)}" if body.speed else "rests"
        axes.plot(along.shown(), rise.shown(scale), color=color, linestyle=dash, label=f"{name}: {moves}")
    axes.axvspan(-a / along.scale.factor, a / along.scale.factor, color=style.MUTED, alpha=0.12, linewidth=0.0)
    axes.set_ylim(0.0, 1.42 * max(float(np.max(rise.shown(scale))) for rise in rises))
    axes.set_xlabel(f"$x$ along the motion [{along.scale.unit}]")
    axes.set_ylabel(f"rise of temperature $T$ [{scale.unit}]")
    axes.set_title("along the middle, contact shaded")
    style.framed_legend(axes, loc="upper left")


def _draw_speeds(axes: Axes, item: FrictionHeatingSolution) -> None:
    """Draw the flash temperature over the speed of sliding, as a part of what the rule for bodies at rest gives."""
    factors = np.geomspace(10.0**-DECADES, 10.0**DECADES, SPEEDS)
    problem = item.problem
    curve = dataclasses.replace(
        problem, first_speed=factors * problem.first_speed, second_speed=factors * problem.second_speed
    ).solve()
    sliding = abs(float(problem.first_speed) - float(problem.second_speed))
    along = series("TransientHeating", "speed", factors * sliding)
    across = middle_scale("m/s", along.content)
    rest = np.asarray(curve.stationary_temperature)
    axes.plot(along.shown(across), curve.flash_temperature / rest, color=style.BLUE, label="flash temperature")
    for name, label, color, dash in ESTIMATES:
        guess = np.asarray(getattr(curve, name)) / rest
        if np.all(np.isfinite(guess)):
            axes.plot(along.shown(across), guess, color=color, linestyle=dash, linewidth=1.2, label=label)
    asked = float(item.flash_temperature) / float(item.stationary_temperature)
    axes.plot([sliding / across.factor], [asked], "o", color=style.RED, label="asked", zorder=5)
    axes.set_xscale("log")
    axes.set_ylim(0.0, 1.7)
    axes.set_xlabel(f"speed of sliding $v$ [{across.unit}]")
    axes.set_ylabel("over that of bodies at rest [-]")
    axes.set_title("flash temperature over the speed")
    style.framed_legend(axes, loc="upper right", ncols=2)


def _many(item: FrictionHeatingSolution) -> Picture:
    """Return flash temperature and share over what was varied: the Peclet number, or else the force."""
    pe = np.maximum(np.asarray(item.first_peclet), np.asarray(item.second_peclet))
    warm = np.ravel(np.asarray(item.heat_rate)) > 0.0
    along = series("FrictionHeatingSolution", "heat_rate", np.ravel(np.asarray(item.heat_rate)))
    if np.ptp(pe) > 0.0:
        along = series("HeatedBody", "peclet", np.ravel(pe))
    kept = dataclasses.replace(along, content=along.content[warm])
    with style.styled():
        figure = style.figure(2, width=4.6, height=3.3)
        left, right = figure.subplots(1, 2)
        order = np.argsort(kept.content, kind="stable")
        across = middle_scale(kept.word.unit, kept.content)
        for axes, names in (
            (left, ("first_max_temperature", "second_max_temperature", "stationary_temperature")),
            (right, ("first_share",)),
        ):
            many = [
                series("FrictionHeatingSolution", name, np.ravel(np.asarray(getattr(item, name)))[warm])
                for name in names
            ]
            upright = scale_of(many[0].word.unit, *(one.content for one in many))
            for one, color, dash, label in zip(
                many,
                (style.RED, style.BLUE, style.GREEN),
                style.DASHES,
                ("first", "second", "both at rest"),
                strict=False,
            ):
                marker = "o" if order.size <= 40 else ""
                shown = kept.shown(across)[order], one.shown(upright)[order]
                axes.plot(*shown, color=color, linestyle=dash, label=label, marker=marker, markersize=3.0)
            axes.set_xlabel(kept.label(across).replace("peclet", "Peclet number"))
            axes.set_ylabel(
                many[0].label(upright) if axes is right else f"greatest rise of temperature [{upright.unit}]"
            )
            if np.min(kept.content) > 0.0 and np.max(kept.content) > 20.0 * np.min(kept.content):
                axes.set_xscale("log")
            axes.margins(x=0.03)
        if left.get_xscale() == "log":
            left.set_yscale("log")
        else:
            left.set_ylim(0.0, None)
        right.set_ylim(0.0, 1.0)
        left.set_title("how warm the bodies get")
        right.set_title("part of the heat for the first body")
        style.framed_legend(left, loc="upper left")
    return figure


@draw.register(TransientHeatingSolution)
def transient_heating_sheet(item: TransientHeatingSolution, *, extent: float | None = None) -> Picture:
    """Return how the contact warms up over time, and the surface of the first body at some moments."""
    refuse_extent(item, extent)
    if item.stationary_temperature == 0.0:
        raise OutsideValidity("draw: nothing warms up, so there is nothing to show; press and slide.")
    low, high = float(np.min(item.time)), float(np.max(item.time))
    if high <= 10.0 * low:
        low, high = low / 30.0, high * 30.0
    curve = dataclasses.replace(item.problem, time=np.geomspace(low, high, 61)).solve()
    a = float(item.contact.radius)
    with style.styled():
        figure = style.figure(2, width=4.6, height=3.3)
        left, right = figure.subplots(1, 2)
        time = series("TransientHeatingSolution", "time", curve.time)
        across = middle_scale("s", time.content)
        of = series("TransientHeatingSolution", "flash_temperature", curve.flash_temperature)
        left.plot(time.shown(across), of.shown(), color=style.BLUE, label="flash temperature")
        mean = np.maximum(curve.first_mean_temperature, curve.second_mean_temperature)
        left.plot(
            time.shown(across), mean / of.scale.factor, color=style.ORANGE, linestyle=style.DASHES[1], label="mean"
        )
        left.axhline(
            item.stationary_temperature / of.scale.factor, color=style.GREEN, linewidth=1.2, linestyle=style.DASHES[2],
            label="in the end",
        )  # fmt: skip
        left.plot(
            item.time / across.factor, item.flash_temperature / of.scale.factor, "o", color=style.RED, markersize=3.5,
            label="asked",
        )  # fmt: skip
        left.set_xscale("log")
        left.set_ylim(0.0, 1.15 * item.stationary_temperature / of.scale.factor)
        left.set_xlabel(time.label(across))
        left.set_ylabel(of.label())
        left.set_title("how the contact warms up")
        style.framed_legend(left, loc="lower right")
        r = np.linspace(0.0, FAR, 61) * a
        moments = dataclasses.replace(item.problem, time=np.geomspace(low, high, MOMENTS)).solve()
        rows = moments.first_temperature(r)
        along, rise = series("HeatedBody", "r", r), series("FrictionHeatingSolution", "temperature", rows)
        for row, moment, share in zip(rise.shown(), moments.time, np.linspace(0.1, 0.9, MOMENTS), strict=True):
            right.plot(along.shown(), row, color=_heats()(share), label=told(float(moment), "s", 3))
        right.axvline(a / along.scale.factor, color=style.MUTED, linewidth=0.9, linestyle=":")
        right.set_ylim(0.0, None)
        right.set_xlabel(along.label())
        right.set_ylabel(f"rise of temperature $T$ [{rise.scale.unit}]")
        right.set_title("surface of the first body")
        style.framed_legend(right, loc="upper right")
    return figure


@draw.register(FrettingHeatSolution)
def fretting_heat_sheet(item: FrettingHeatSolution, *, extent: float | None = None) -> Picture:
    """Return where the heat of a cycle is released, and the mean temperature of the surface."""
    refuse_extent(item, extent)
    a = item.source.radius
    stick = a * float(item.source.joints[1])  # what does not slip ends there; at the rim if all slips
    places = np.linspace(0.0, 1.8, 3 * ALONG) * a
    with style.styled():
        figure = style.figure(2, width=4.6, height=3.3)
        left, right = figure.subplots(1, 2)
        along, of = series("HeatedBody", "r", places), series("RoundFlux", "flux", item.flux.at(places))
        left.fill_between(along.shown(), of.shown(), color=style.RED, alpha=0.14, linewidth=0.0)
        left.plot(along.shown(), of.shown(), color=style.RED)
        if 0.0 < stick < a:
            left.axvline(stick / along.scale.factor, color=style.MUTED, linewidth=0.9, linestyle=":")
            style.note(left, f"sticks within {told(stick, 'm', 3)}", where="upper left")
        left.set_ylim(0.0, None)
        left.set_xlabel(along.label())
        left.set_ylabel(f"mean heat flux $q$ [{of.scale.unit}]")
        left.set_title("where the heat is released")
        r = np.linspace(0.0, 1.8, ALONG) * a
        rise = series("FrettingHeatSolution", "temperature", item.temperature(r))
        right.plot(r / along.scale.factor, rise.shown(), color=style.BLUE)
        right.axvline(a / along.scale.factor, color=style.MUTED, linewidth=0.9, linestyle=":")
        right.set_ylim(0.0, None)
        right.set_xlabel(along.label())
        right.set_ylabel(f"mean rise of temperature [{rise.scale.unit}]")
        right.set_title("how warm the surfaces get")
        style.note(right, f"swings by about ±{told(item.swing, 'K', 2)}")
        figure.suptitle(f"{told(item.loss_per_cycle, 'J')} in every cycle, {told(item.heat_rate, 'W')}")
    return figure
