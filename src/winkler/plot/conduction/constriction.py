"""Sheets of contacts that conduct: resistance over force, temperature around the contact, what a voltage heats."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity, WinklerError
from winkler.laws.current import Voltage
from winkler.loading import Force
from winkler.plot import style
from winkler.plot.conduction.fields import draw_conduction_map, draw_crossing
from winkler.plot.draw import draw
from winkler.plot.series import common_scale, middle_scale, series, told
from winkler.problems.conduction.constriction import ConstrictionSolution
from winkler.problems.conduction.joule_heating import JouleHeatingSolution
from winkler.problems.conduction.thermal_constriction import ThermalConstrictionSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.numerics.types import Array
    from winkler.plot.picture import Picture

__all__ = ["constriction_sheet", "joule_sheet", "thermal_sheet"]

POINTS = 49
DECADES = 1.5
"""Curves go so far below and beyond what was asked."""
HOTTEST = 4.0
"""Voltages are drawn up to where the contact has so many times the temperature of the bodies."""
Steady = ConstrictionSolution | ThermalConstrictionSolution
PARTS = {
    ConstrictionSolution: (
        ("constriction", "constriction"),
        ("film_resistance", "film"),
        ("bulk_resistance", "length of the rods"),
    ),
    ThermalConstrictionSolution: (
        ("constriction", "constriction"),
        ("interface_resistance", "interface"),
        ("bulk_resistance", "length of the rods"),
    ),
}


def _refuse(item: Any, extent: float | None) -> None:
    if extent is not None:
        raise InvalidInput(f"draw: the curves of a {type(item).__name__} have no extent; leave it out.")
    if isinstance(item, JouleHeatingSolution) and not np.any(np.asarray(item.current) > 0.0):
        raise OutsideValidity("draw: no current flows, so there is nothing to show; give a voltage and a contact.")
    if not np.any(np.asarray(item.radius) > 0.0):
        raise OutsideValidity("draw: the bodies do not touch, so there is nothing to show; press harder.")


def _pressed_around(item: Any) -> Any:
    """Return the answers around the forces that were asked, as far as the bed knows them."""
    force = np.ravel(np.asarray(item.force, dtype=float))
    force = force[force > 0.0]
    low, high = np.log10(np.min(force)), np.log10(np.max(force))
    wide = DECADES if high == low else 0.0
    for less in (1.0, 0.3, 0.0):
        many = np.logspace(low - wide, high + less * wide, POINTS)
        try:
            return dataclasses.replace(item.problem, load=Force(many)).solve()
        except WinklerError:
            continue
    raise OutsideValidity("draw: no curve through this contact is known; ask for one load and its numbers.")


@draw.register(ConstrictionSolution)
def constriction_sheet(item: ConstrictionSolution, *, extent: float | None = None) -> Picture:
    """Return the resistance over the force, and what makes it."""
    _refuse(item, extent)
    curve = _pressed_around(item)
    with style.styled():
        figure = style.figure(2, height=3.2)
        left, right = figure.subplots(1, 2)
        _draw_resistance(left, curve, item)
        _draw_parts(right, curve)
    return figure


def _draw_resistance(axes: Axes, curve: Steady, item: Steady) -> None:
    """Draw the resistance over the force, its parts, and what was asked."""
    owner = type(curve)
    along, whole = series(owner, "force", curve.force), series(owner, "resistance", curve.resistance)
    across, upright = middle_scale("N", along.content), middle_scale(whole.word.unit, whole.content)
    axes.plot(along.shown(across), whole.shown(upright), color=style.INK, label="resistance")
    shown = [(name, label) for name, label in PARTS[owner] if np.max(getattr(curve, name)) > 0.0]
    for place, (name, label) in enumerate(shown if len(shown) > 1 else []):
        part = np.broadcast_to(np.asarray(getattr(curve, name), dtype=float), along.content.shape)
        axes.plot(
            along.shown(across),
            part / upright.factor,
            color=style.CYCLE[place],
            linestyle=style.DASHES[1 + place],
            label=label,
        )
    force, asked = (np.ravel(np.asarray(part, dtype=float)) for part in (item.force, item.resistance))
    touching = np.isfinite(asked)
    if touching.sum() <= POINTS:
        axes.plot(
            force[touching] / across.factor, asked[touching] / upright.factor, "o", color=style.RED, label="asked"
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    least, most = float(np.min(whole.shown(upright))), float(np.max(whole.shown(upright)))
    axes.set_ylim(0.3 * least if len(shown) > 1 else 0.7 * least, 1.6 * most)
    axes.set_xlabel(along.label(across))
    axes.set_ylabel(whole.label(upright))
    if np.ptp(np.log10(whole.content)) > 0.8:
        axes.yaxis.set_minor_formatter("")
    style.framed_legend(axes, loc="upper right")
    axes.set_title("resistance over force")


def _draw_parts(axes: Axes, curve: Steady) -> None:
    """Draw which part of the resistance comes from what."""
    owner = type(curve)
    along = series(owner, "force", curve.force)
    across = middle_scale("N", along.content)
    names = [(name, label) for name, label in PARTS[owner] if np.max(getattr(curve, name)) > 0.0]
    if len(names) == 1:
        radius = series(owner, "radius", curve.radius)
        axes.plot(along.shown(across), radius.shown(), color=style.BLUE)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_ylabel(radius.label())
        axes.set_title("springs in contact conduct: $R\\propto1/a$")
    else:
        shares = [
            np.broadcast_to(np.asarray(getattr(curve, name), dtype=float), along.content.shape) / curve.resistance
            for name, _ in names
        ]
        axes.stackplot(
            along.shown(across),
            *(100.0 * share for share in shares),
            labels=[label for _, label in names],
            colors=style.CYCLE[: len(names)],
            alpha=0.6,
            linewidth=0.0,
        )
        axes.set_xscale("log")
        axes.set_ylim(0.0, 100.0)
        axes.set_ylabel("part of the resistance [%]")
        axes.set_title("what makes it")
        style.framed_legend(axes, loc="lower left")
    axes.set_xlabel(along.label(across))


@draw.register(ThermalConstrictionSolution)
def thermal_sheet(item: ThermalConstrictionSolution, *, extent: float | None = None) -> Picture:
    """Return the temperature around the contact and over its surface, and the resistance over the force."""
    _refuse(item, extent)
    curve = _pressed_around(item)
    return _with_fields(item, lambda axes: _draw_resistance(axes, curve, item), lambda axes: _draw_parts(axes, curve))


@draw.register(JouleHeatingSolution)
def joule_sheet(item: JouleHeatingSolution, *, extent: float | None = None) -> Picture:
    """Return the temperature around the contact, voltage and density of the current, and what other voltages heat."""
    _refuse(item, extent)
    if np.ndim(item.radius) != 0:
        return _heated_over_force(item)
    return _with_fields(item, lambda axes: _draw_voltages(axes, item), lambda axes: _draw_hot(axes, item))


def _with_fields(item: Any, curve: Any, instead: Any) -> Picture:
    """Return a map, a cut and a curve; where the field is not known, the curve and what stands instead."""
    with style.styled():
        try:
            if np.ndim(item.radius) != 0:
                raise OutsideValidity("of one load")
            figure = style.figure(3, width=4.0, height=3.3)
            panels = figure.subplots(1, 3)
            draw_conduction_map(panels[0], item)
            draw_crossing(panels[1], item)
            curve(panels[2])
        except OutsideValidity:
            figure = style.figure(2, height=3.2)
            panels = figure.subplots(1, 2)
            curve(panels[0])
            instead(panels[1])
    return figure


def _voltages(item: JouleHeatingSolution) -> Array:
    """Return voltages from nothing to far beyond the one that was asked, or to where the metal glows."""
    ambient = item.problem.temperature
    most = max(float(item.problem.law.voltage_at(HOTTEST * ambient, ambient)), 1.2 * float(item.voltage))
    return np.linspace(0.0, most, POINTS)


def _draw_voltages(axes: Axes, item: JouleHeatingSolution) -> None:
    """Draw the temperature of the contact over the voltage, and of its hottest place."""
    problem = item.problem
    asked = [dataclasses.replace(problem, drive=Voltage(float(one))).solve() for one in _voltages(item)]
    along = series(JouleHeatingSolution, "voltage", np.array([one.voltage for one in asked]))
    most = series(JouleHeatingSolution, "max_temperature", np.array([one.max_temperature for one in asked]))
    touch = series(JouleHeatingSolution, "contact_temperature", np.array([one.contact_temperature for one in asked]))
    scale = common_scale(most, touch)
    axes.plot(along.shown(), most.shown(scale), color=style.RED, label="hottest place")
    if np.max(most.content - touch.content) > 1e-9 * np.max(most.content):
        axes.plot(along.shown(), touch.shown(scale), color=style.BLUE, linestyle=style.DASHES[1], label="contact")
    axes.plot(
        [float(item.voltage) / along.scale.factor],
        [float(item.max_temperature) / scale.factor],
        "o",
        color=style.RED,
        clip_on=False,
        label=f"{told(float(item.current), 'A')}",
    )
    axes.set_xlabel(along.label())
    axes.set_ylabel(f"temperature $T$ [{scale.unit}]")
    axes.set_title("what other voltages heat")
    style.framed_legend(axes, loc="upper left")


def _draw_hot(axes: Axes, item: JouleHeatingSolution) -> None:
    """Draw the current over the voltage."""
    asked = [dataclasses.replace(item.problem, drive=Voltage(float(one))).solve() for one in _voltages(item)]
    along = series(JouleHeatingSolution, "voltage", np.array([one.voltage for one in asked]))
    of = series(JouleHeatingSolution, "current", np.array([one.current for one in asked]))
    axes.plot(along.shown(), of.shown(), color=style.BLUE)
    axes.plot([float(item.voltage) / along.scale.factor], [float(item.current) / of.scale.factor], "o", color=style.RED)
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label())
    axes.set_title("current over voltage")


def _heated_over_force(item: JouleHeatingSolution) -> Picture:
    """Return temperature and voltage over the force, of many loads at once."""
    curve = _pressed_around(item)
    along = series(JouleHeatingSolution, "force", curve.force)
    across = middle_scale("N", along.content)
    with style.styled():
        figure = style.figure(2, height=3.2)
        panels = figure.subplots(1, 2)
        for axes, name in zip(panels, ("max_temperature", "resistance"), strict=True):
            of = series(JouleHeatingSolution, name, getattr(curve, name))
            scale = middle_scale(of.word.unit, of.content)
            axes.plot(
                along.shown(across), of.shown(scale), color=style.BLUE, label="hot" if name == "resistance" else None
            )
            asked = np.ravel(np.asarray(getattr(item, name), dtype=float))
            force = np.ravel(np.asarray(item.force, dtype=float))
            if asked.size <= POINTS:
                axes.plot(force / across.factor, asked / scale.factor, "o", color=style.RED)
            axes.set_xscale("log")
            axes.set_xlabel(along.label(across))
            axes.set_ylabel(of.label(scale))
        cold = series(JouleHeatingSolution, "cold_resistance", curve.cold_resistance)
        panels[1].plot(
            along.shown(across), cold.shown(scale), color=style.MUTED, linestyle=style.DASHES[1], label="cold"
        )
        panels[1].set_yscale("log")
        style.framed_legend(panels[1], loc="upper right")
        panels[0].set_title("temperature over force")
        panels[1].set_title("resistance over force")
    return figure
