"""Sheets of rolling line contacts: creep curve and tractions, the course from rest, resistance of relaxing solids."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.loading.loads import LineShearForce
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import checked_extent
from winkler.plot.line.contact import across, over
from winkler.plot.panel import Line, Panel, PanelAxis, Rule, Sheet, titled
from winkler.plot.series import Series, scale_of, series, series_of, with_unit
from winkler.problems.line_rolling.resistance import LineRollingResistanceSolution
from winkler.problems.line_rolling.rolled_strip import sliding_creepage
from winkler.problems.line_rolling.start import LineRollingStartSolution
from winkler.problems.line_rolling.start_states import DRAGGED
from winkler.problems.line_rolling.steady import LineRollingSolution
from winkler.problems.rolling.creepage import Creepage
from winkler.values.vocabulary import Word

POINTS, STRIP_POINTS, COUPLED_POINTS = 121, 41, 15
"""Of a creep curve in closed form, on elements, and on elements with coupling, which take longer."""
BEYOND_SLIDING = 1.35
"""Range of a creep curve relative to the creepage at full sliding."""
PLACES = 401
BESIDE = 1.15
"""Range of a picture over the half-width."""
CURVES_DRAWN = 4
STATES_DRAWN = 5


@sheet_of.register(LineRollingSolution)
def line_rolling_sheet(item: LineRollingSolution, *, extent: float | None = None) -> Sheet:
    """Return the force over the creepage, and tractions with zones of stick of several widths."""
    end = checked_extent(extent) or BESIDE * float(item.contact.half_width)
    panels = titled(
        (_creep_panel(item), _traction_panel(_some(item), end)), "creep force", "traction, rolling to the right"
    )
    return Sheet(panels, height=3.1)


def _some(item: LineRollingSolution) -> list[LineRollingSolution]:
    """Return solutions of single drives with zones of stick as different as there are, at most four."""
    if np.ndim(item.stick_share) == 0:
        return [item]
    shares = np.ravel(np.asarray(item.stick_share))
    wanted = np.linspace(np.max(shares), np.min(shares), CURVES_DRAWN)
    chosen = sorted({int(np.argmin(np.abs(shares - share))) for share in wanted})
    return [_alone(item, index) for index in chosen]


def _alone(item: LineRollingSolution, index: int) -> LineRollingSolution:
    creepage, force, share = (
        float(np.ravel(column)[index])
        for column in (item.longitudinal_creepage, item.shear_force_per_length, item.stick_share)
    )
    by_force = isinstance(item.problem.drive, LineShearForce)
    problem = dataclasses.replace(item.problem, drive=LineShearForce(force) if by_force else Creepage(creepage))
    return LineRollingSolution(problem, creepage, force, share, item.contact, item.strips[index : index + 1])


def _creep_panel(item: LineRollingSolution) -> Panel:
    """Return the curve, and the drives on it; of dissimilar bodies the force is zero beside no creepage."""
    creepage, ratio = np.ravel(np.asarray(item.longitudinal_creepage, dtype=float)), _used(item)
    limit = sliding_creepage(item.problem.bed, float(item.contact.half_width), item.problem.friction.coefficient)
    most = max(BEYOND_SLIDING * limit, float(np.max(np.abs(creepage))))
    coupled = bool(item.strips) and item.problem.coupled
    both = coupled or np.min(creepage) < 0.0
    count = COUPLED_POINTS if coupled else STRIP_POINTS if item.strips else POINTS
    along = np.linspace(-most if both else 0.0, most, count)
    forces = _used(dataclasses.replace(item.problem, drive=Creepage(longitudinal=along)).solve())
    if item.strips:
        along, places = np.unique(np.append(along, creepage), return_index=True)
        forces = np.append(forces, ratio)[places]
    of = series("longitudinal_creepage", along, LineRollingSolution)
    force = Quantity(Series("force", Word("", "", "force over that of sliding"), forces), points=(creepage, ratio))
    return curves_panel(of, [force], label=r"force $Q/(\mu P)$").plus(Rule(1.0, width=0.9, dash=style.DOTTED))


def _used(item: LineRollingSolution) -> Array:
    """Return Q over mu P, with the sign of Q."""
    force = np.ravel(np.asarray(item.shear_force_per_length, dtype=float))
    return force / (item.problem.friction.coefficient * float(item.contact.force_per_length))


def _traction_panel(drawn: list[LineRollingSolution], end: float) -> Panel:
    a, mu = float(drawn[0].contact.half_width), drawn[0].problem.friction.coefficient
    ends = [a - 2.0 * a * float(one.stick_share) for one in drawn]
    x = np.unique(np.concatenate([np.linspace(-end, end, PLACES), [-a, a], ends]))
    tractions = [one.traction(x) for one in drawn]
    bound = mu * drawn[0].contact.pressure(x)
    signs = sorted({float(np.sign(float(one.shear_force_per_length))) or 1.0 for one in drawn})
    dashed: dict[str, Any] = {"colour": style.MUTED, "dash": style.DASHES[1]}
    marks = [Line(x, sign * bound, name=r"$\mu p$" if sign == signs[0] else "", **dashed) for sign in signs]
    for colour, one, traction in zip(style.CYCLE, drawn, tractions, strict=False):
        marks.append(Line(x, traction, colour, name=f"$c/a = {float(one.stick_share):.2g}$"))
    upright = PanelAxis.of(series("traction", tractions[0]), scale_of("Pa", bound), margin=0.1)
    return Panel(tuple(marks), across(end), upright, legend="upper left", outside=True)


@sheet_of.register(LineRollingStartSolution)
def line_rolling_start_sheet(item: LineRollingStartSolution, *, extent: float | None = None) -> Sheet:
    """Return what follows over the distance rolled, the creepage or the force, and tractions at some places."""
    held = isinstance(item.problem.drive, LineShearForce)
    name = "longitudinal_creepage" if held else "shear_force_per_length"
    first = 1 if held and item.distance.size > 1 else 0  # at rest there is no creepage
    found, distance = series_of(item, name), series_of(item, "distance")
    distance, found = (dataclasses.replace(one, content=one.content[first:]) for one in (distance, found))
    courses = curves_panel(distance, [(found, "")])
    if DRAGGED not in item.validity:
        courses = courses.plus(Rule(float(getattr(item.steady, name)), width=0.9, dash=style.DOTTED))
    end = checked_extent(extent) or BESIDE * float(item.contact.half_width)
    panels = titled((courses, _states_panel(item, end)), "until it is steady", "traction, rolling to the right")
    return Sheet(panels, height=3.1)


def _states_panel(item: LineRollingStartSolution, end: float) -> Panel:
    states, a = item.states, float(item.contact.half_width)
    chosen = sorted({int(index) for index in np.linspace(0.0, 1.0, STATES_DRAWN) ** 2 * (len(states) - 1)})
    x = np.concatenate([[-a], states[0].x, [a]])
    bound = item.problem.friction.coefficient * item.contact.pressure(x)
    sign = float(np.sign(float(item.steady.shear_force_per_length))) or 1.0
    marks = [Line(x, sign * bound, style.MUTED, dash=style.DASHES[1], name=r"$\mu p$")]
    for colour, index in zip(style.CYCLE, chosen, strict=False):
        one = states[index]
        name = "at rest" if one.distance == 0.0 else f"after {one.distance / a:.2g} $a$"
        marks.append(Line(x, np.pad(one.traction, 1), colour, width=1.4, name=name))
    upright = PanelAxis.of(series("traction", bound), scale_of("Pa", bound), margin=0.1)
    return Panel(tuple(marks), across(end), upright, legend="upper left", outside=True)


@sheet_of.register(LineRollingResistanceSolution)
def line_resistance_sheet(item: LineRollingResistanceSolution, *, extent: float | None = None) -> Sheet:
    """Return the coefficient over the speed, and the pressure at the slowest, the fastest and the worst speed."""
    speed, coefficient = (np.ravel(np.asarray(part, dtype=float)) for part in (item.speed, item.coefficient))
    order = np.argsort(speed, kind="stable")
    many = speed.size > 1
    chosen = sorted({int(order[0]), int(np.argmax(coefficient)), int(order[-1])}, key=lambda index: speed[index])
    drawn = [dataclasses.replace(item.problem, speed=float(speed[index])).solve() for index in chosen]
    end = checked_extent(extent) or BESIDE * max(float(one.leading_edge) for one in drawn)
    x = np.linspace(-end, end, PLACES)
    pressures = [one.pressure(x) for one in drawn]
    marks = tuple(
        Line(x, pressure, colour, name=with_unit(float(one.speed), "m/s") if many else "")
        for colour, one, pressure in zip(style.CYCLE, drawn, pressures, strict=False)
    )
    most = max(float(np.max(pressure)) for pressure in pressures)
    upright = PanelAxis.of(series("pressure", pressures[0]), scale_of("Pa", [most]), low=0.0, high=1.1 * most)
    pressed = Panel(marks, across(end), upright, legend="upper left" if many else "")
    if not many:
        title = f"resistance {float(item.coefficient):.3g} of the force per length"
        return Sheet((pressed,), height=3.1, title=title)
    names = "resistance over force per length", "pressure, rolling to the right"
    panels = titled((over(item, "coefficient", "speed"), pressed), *names)
    return Sheet(panels, height=3.1)
