"""Sheets of contacts that conduct: resistance over force, temperature around the contact, heating by a voltage."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.laws.current import Voltage
from winkler.loading.loads import Force
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.conduction.fields import conduction_map, crossing_panel
from winkler.plot.curves import Quantity, answered, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Area, Panel, PanelAxis, Sheet, titled
from winkler.plot.series import Series, middle_scale, row_of, series, with_unit
from winkler.problems.conduction.constriction import ConstrictionSolution
from winkler.problems.conduction.joule_heating import JouleHeatingSolution
from winkler.problems.conduction.thermal_constriction import ThermalConstrictionSolution
from winkler.values.errors import OutsideValidity, WinklerError

POINTS = 49
DECADES_BEYOND = 1.5
"""Decades drawn below and above a single requested force."""
GREATEST_TEMPERATURE_RATIO = 4.0
"""Greatest drawn temperature of the contact over that of the bodies."""
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


def _refuse_nothing_to_show(item: Any) -> None:
    if isinstance(item, JouleHeatingSolution) and not np.any(np.asarray(item.current) > 0.0):
        raise OutsideValidity("draw: no current flows, so there is nothing to show; give a voltage and a contact.")
    if not np.any(np.asarray(item.radius) > 0.0):
        raise OutsideValidity("draw: the bodies do not touch, so there is nothing to show; press harder.")


def _curve_over_force(item: Any) -> Any:
    """Return the solution over a range of forces around the requested ones, within the reach of the bed."""
    force = np.ravel(np.asarray(item.force, dtype=float))
    force = force[force > 0.0]
    low, high = np.log10(np.min(force)), np.log10(np.max(force))
    wide = DECADES_BEYOND if high == low else 0.0
    for less in (1.0, 0.3, 0.0):
        many = np.logspace(low - wide, high + less * wide, POINTS)
        try:
            contact = dataclasses.replace(item.problem.contact, load=Force(many))
            return dataclasses.replace(item.problem, contact=contact).solve()
        except WinklerError:
            continue
    raise OutsideValidity(
        "draw: no curve of forces can be solved around this contact; solve for one load and use its results."
    )


@without_extent(ConstrictionSolution)
def constriction_sheet(item: ConstrictionSolution) -> Sheet:
    """Return the resistance over the force, and its parts."""
    _refuse_nothing_to_show(item)
    curve = _curve_over_force(item)
    return Sheet((_resistance_panel(curve, item), _parts_panel(curve)), height=3.2)


def _resistance_parts(curve: Steady) -> list[tuple[str, Array]]:
    """Return names and values of the nonzero parts of the resistance."""
    shape = np.shape(curve.force)
    parts = [(label, np.broadcast_to(np.asarray(getattr(curve, name)), shape)) for name, label in PARTS[type(curve)]]
    return [(label, part) for label, part in parts if np.max(part) > 0.0]


def _resistance_panel(curve: Steady, item: Steady) -> Panel:
    """Return the resistance over the force, its parts, and the requested points."""
    whole, parts = answered(curve, item, "force", "resistance", "resistance"), _resistance_parts(curve)
    rows = [(series("resistance", part, type(curve)), label) for label, part in (parts if len(parts) > 1 else [])]
    return curves_panel(row_of(curve, "force"), [whole, *rows], log=True).plus(title="resistance over force")


def _parts_panel(curve: Steady) -> Panel:
    """Return the parts of the resistance in per cent."""
    along, parts = row_of(curve, "force"), _resistance_parts(curve)
    if len(parts) == 1:
        title = "springs in contact conduct: $R\\propto1/a$"
        return curves_panel(along, [(row_of(curve, "radius"), "")], log=True).plus(title=title)
    across = PanelAxis.of(along, middle_scale("N", along.content), log=True)
    rows = np.cumsum([np.zeros(along.content.shape), *(100.0 * part / curve.resistance for _, part in parts)], axis=0)
    areas = [
        Area(along.content, low, high, colour, 0.6, label)
        for low, high, colour, (label, _) in zip(rows, rows[1:], style.CYCLE, parts, strict=False)
    ]
    upright = PanelAxis("part of the resistance [%]", low=0.0, high=100.0)
    return Panel(tuple(areas), across, upright, legend="lower left", title="parts of the resistance")


@without_extent(ThermalConstrictionSolution)
def thermal_sheet(item: ThermalConstrictionSolution) -> Sheet:
    """Return the temperature around the contact and over its surface, and the resistance over the force."""
    _refuse_nothing_to_show(item)
    curve = _curve_over_force(item)
    return _with_fields(item, _resistance_panel(curve, item), lambda: _parts_panel(curve))


@without_extent(JouleHeatingSolution)
def joule_sheet(item: JouleHeatingSolution) -> Sheet:
    """Return the temperature around the contact, current density, and the temperature over the voltage."""
    _refuse_nothing_to_show(item)
    if np.ndim(item.radius) != 0:
        return _heated_over_force(item)
    return _with_fields(item, _voltages_panel(item), lambda: _current_panel(item))


def _with_fields(item: Any, curve: Panel, instead: Callable[[], Panel]) -> Sheet:
    """Return a map, a section and a curve; without a field solution the curve and a replacement."""
    try:
        if np.ndim(item.radius) != 0:
            raise OutsideValidity("of one load")
        return Sheet((conduction_map(item), crossing_panel(item), curve), width=4.0, height=3.3)
    except OutsideValidity:
        return Sheet((curve, instead()), height=3.2)


def _voltages(item: JouleHeatingSolution) -> Array:
    """Return voltages from zero to beyond the requested one, or to `GREATEST_TEMPERATURE_RATIO`."""
    ambient = item.problem.temperature
    hottest = max(
        float(item.problem.law.voltage_at(GREATEST_TEMPERATURE_RATIO * ambient, ambient)), 1.2 * float(item.voltage)
    )
    return np.linspace(0.0, hottest, POINTS)


def _solved_at_voltages(item: JouleHeatingSolution) -> tuple[JouleHeatingSolution, ...]:
    return tuple(dataclasses.replace(item.problem, drive=Voltage(float(one))).solve() for one in _voltages(item))


def _collected(solutions: tuple[JouleHeatingSolution, ...], name: str) -> Series:
    return series(name, np.array([getattr(one, name) for one in solutions]), JouleHeatingSolution)


def _voltages_panel(item: JouleHeatingSolution) -> Panel:
    """Return the temperature of the contact over the voltage, and of its hottest place."""
    solutions = _solved_at_voltages(item)
    along, hottest, contact = (
        _collected(solutions, name) for name in ("voltage", "max_temperature", "contact_temperature")
    )
    name = with_unit(float(item.current), "A")
    rows = [Quantity(hottest, "hottest place", (item.voltage, item.max_temperature), name)]
    if np.max(hottest.content - contact.content) > 1e-9 * np.max(hottest.content):
        rows.append(Quantity(contact, "contact"))
    return curves_panel(along, rows, label="temperature $T$").plus(title="temperature over voltage")


def _current_panel(item: JouleHeatingSolution) -> Panel:
    """Return the current over the voltage."""
    solutions = _solved_at_voltages(item)
    current = Quantity(_collected(solutions, "current"), points=(item.voltage, item.current))
    return curves_panel(_collected(solutions, "voltage"), [current]).plus(title="current over voltage")


def _heated_over_force(item: JouleHeatingSolution) -> Sheet:
    """Return temperature and resistance over the force, for many loads."""
    curve = _curve_over_force(item)
    along, cold = row_of(curve, "force"), series("resistance", curve.cold_resistance, type(item))
    panels = (
        curves_panel(along, [answered(curve, item, "force", "max_temperature")]),
        curves_panel(along, [answered(curve, item, "force", "resistance", "hot"), (cold, "cold")], log=True),
    )
    return Sheet(titled(panels, "temperature over force", "resistance over force"), height=3.2)
