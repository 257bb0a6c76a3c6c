"""Sheets of rolling: creep curves, where the contact sticks and slides, onset of rolling, and oscillating rolling."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.laws.varying_friction import greatest_coefficient
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import sheet_of
from winkler.plot.panel import Area, Line, Map, Panel, PanelAxis, Rule, Sheet, Text, Vectors, note, points, titled, zero
from winkler.plot.series import Series, middle_scale, row_of, series
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.oscillating import OscillatingRollingSolution
from winkler.problems.rolling.simplified_theory import SimplifiedRollingSolution
from winkler.problems.rolling.start import RollingStartSolution
from winkler.problems.rolling.steady import RollingSolution
from winkler.values.vocabulary import Word

POINTS = 121
CREEPAGE_BEYOND_SLIDING = 1.35
"""Range of a creep curve relative to the creepage at full sliding."""
STATES_DRAWN = 5
"""Number of drawn states of a history."""
STRIPS_DRAWN = 160
"""Strips of a map of tractions."""
ARROWS_ACROSS = 13
MOST_EXTENSIONS = 40
"""Most extensions, by 1.3 each, in the search for the end of a creep curve."""
LEAST_FORCE_SHARE = 1e-9
"""Force components below this part of the sliding force are not drawn."""
CREEPAGES = ("longitudinal", "lateral", "spin")


def _solved_at(item: Any, factor: Array) -> Any:
    """Return the solution for multiples of the creepage of `item`."""
    creepage = item.problem.creepage
    scaled = Creepage(*(factor * float(part) for part in (creepage.longitudinal, creepage.lateral, creepage.spin)))
    return dataclasses.replace(item.problem, creepage=scaled).solve()


def _friction_bound(problem: Any, force: float) -> float:
    return greatest_coefficient(problem.friction) * force


def _strongest(item: Any) -> Any:
    """Return the solution for the one creepage with the greatest shear force."""
    creepage = item.problem.creepage
    if creepage.shape == ():
        return item
    place = int(np.argmax(np.ravel(item.shear_force)))
    one = Creepage(*(float(part[place]) for part in creepage.broadcast()))
    return dataclasses.replace(item.problem, creepage=one).solve()


def _creep_panel(item: Any, force: float) -> Panel:
    """Return the force over the creepage: over the requested ones, or over multiples of a single one."""
    single = item.problem.creepage.shape == ()
    creepage = item.problem.creepage
    spread = {name: float(np.ptp(np.asarray(getattr(creepage, name), dtype=float))) for name in CREEPAGES}
    greatest = {name: float(np.max(np.abs(getattr(creepage, name)))) for name in CREEPAGES}
    varied = [name for name in CREEPAGES if (greatest[name] if single else spread[name]) > 0.0]
    if not varied:
        text = "no creepage, no force" if single else "one creepage, many times"
        return Panel((note(text, "upper centre"),), title="creep force")
    curve = _solved_at(item, np.linspace(0.0, _end_factor(item), POINTS)) if single else item
    along = _along(curve, varied[0])
    bound_force = _friction_bound(item.problem, force)
    rows, full = [], []
    for part in ("longitudinal_force", "lateral_force"):
        content = np.ravel(np.asarray(getattr(curve, part))) / bound_force
        asked = (getattr(creepage, varied[0]), getattr(item, part) / bound_force) if single else ((), ())
        rows.append(Quantity(Series(part, Word("", "", part), content), part.removesuffix("_force"), asked))
        if np.max(np.abs(content)) > 0.8:
            full.append(Rule(float(np.sign(content[np.argmax(np.abs(content))])), width=0.9, dash=style.DOTTED))
    drawn = [row for row in rows if np.max(np.abs(row.of.content)) >= LEAST_FORCE_SHARE] or rows[:1]
    panel = curves_panel(along, drawn, label=r"creep force $F/(\mu F_N)$").plus(*full, title="creep force")
    legend = panel.legend if len(drawn) > 1 else ""
    others = ", the others in proportion" if single and len(varied) > 1 else ""
    return panel.plus(legend=legend, across=dataclasses.replace(panel.across, label=f"{panel.across.label}{others}"))


def _along(curve: Any, name: str) -> Series:
    creepage = curve.problem.creepage
    content = np.broadcast_to(np.asarray(getattr(creepage, name), dtype=float), creepage.shape)
    of = series(name, np.ravel(content), Creepage)
    return of if name == "spin" else dataclasses.replace(of, name=f"{name} creepage")


def _end_factor(item: Any) -> float:
    """Return the greatest multiple of the creepage: at full sliding, or well beyond the greatest force."""
    limit, reached = 1.0, 0.0
    for _ in range(MOST_EXTENSIONS):
        saturation = float(_solved_at(item, np.array([limit])).saturation[0])
        if saturation > 0.995 or saturation < reached:
            break
        limit, reached = 1.3 * limit, saturation
    return (CREEPAGE_BEYOND_SLIDING if item.problem.creepage.spin == 0.0 else 2.0 * CREEPAGE_BEYOND_SLIDING) * limit


@sheet_of.register(RollingSolution)
def rolling_sheet(item: RollingSolution, *, extent: float | None = None) -> Sheet:
    """Return the creep curve, and the load of the springs at the creepage of the greatest force."""
    one = _strongest(item)
    a = float(item.contact.radius) if extent is None else extent
    x = a * np.linspace(-1.0, 1.0, 801)
    right = _line_panel(x, one.shear_load(x), one.problem.friction.coefficient * one.contact.line_load(x))
    return Sheet((_creep_panel(item, float(item.contact.force)), right), height=3.3)


BOUND = r"bound $\mu q_z$"
TO_THE_RIGHT = "load of the springs, rolling to the right"


def _line_panel(x: Array, load: Array, bound: Array) -> Panel:
    along, of = series("x", x), series("shear_load", load)
    sticks = load < bound * (1.0 - 1e-9)
    marks: list[Any] = [
        Line(x, bound, style.MUTED, dash=style.DASHES[1], name=BOUND),
        Line(x, load, name="$q_x$"),
        Area(x, np.where(sticks, load, np.nan), 0.0, alpha=0.15),
    ]
    marks += [note("shaded: sticks")] if np.any(sticks) else []
    upright = PanelAxis.of(of, middle_scale(of.word.unit, bound), low=0.0, high=1.15 * float(np.max(bound)))
    return Panel(tuple(marks), PanelAxis.of(along), upright, title=TO_THE_RIGHT, legend="upper left")


@sheet_of.register(SimplifiedRollingSolution)
def simplified_sheet(item: SimplifiedRollingSolution, *, extent: float | None = None) -> Sheet:
    """Return the creep curve, the tractions over the contact, and the zones of stick and slip."""
    one = _strongest(item)
    fine = dataclasses.replace(one.problem, count=max(STRIPS_DRAWN, one.problem.count)).solve()
    panels = _creep_panel(item, float(item.problem.load.force)), _traction_panel(fine), _zones_panel(fine)
    titles = ("creep force", "traction, rolling to the right", "where it sticks and slides")
    return Sheet(titled(panels, *titles), width=3.9, height=3.3)


def _ellipse_panel(item: SimplifiedRollingSolution, *marks: Any, margin_across: float = 0.05) -> Panel:
    """Return the contour ellipse with further marks, on equal axes."""
    a, b = item.longitudinal_semi_axis, item.lateral_semi_axis
    scale, turn = middle_scale("m", np.array([a, b])), np.linspace(0.0, 2.0 * np.pi, 181)
    outline = Line(a * np.cos(turn), b * np.sin(turn), style.INK, width=1.0)
    axes = PanelAxis("$x$", scale, margin=0.05), PanelAxis("$y$", scale, margin=margin_across)
    return Panel((outline, *marks), *axes, equal=True, grid="")


def _traction_panel(item: SimplifiedRollingSolution) -> Panel:
    field = item.traction
    across = field.y[:, :1] * np.ones_like(field.x)
    size = series("traction", field.traction)
    rows = np.unique(np.linspace(2, field.x.shape[0] - 3, ARROWS_ACROSS).round().astype(int))
    columns = np.unique(np.linspace(3, field.x.shape[1] - 4, ARROWS_ACROSS).round().astype(int))
    place = np.ix_(rows, columns)
    arrows = Vectors(field.x[place], across[place], field.longitudinal[place], field.lateral[place])
    return _ellipse_panel(
        item, Map(field.x, across, size.content, PanelAxis.of(size), kind="smooth", shrink=0.85), arrows
    )


def _zones_panel(item: SimplifiedRollingSolution) -> Panel:
    field, nothing = item.traction, np.empty(0)
    across = field.y[:, :1] * np.ones_like(field.x)
    colours = (style.BLUE, style.ORANGE)
    look: dict[str, Any] = {"colours": colours, "levels": np.array([-0.5, 0.5, 1.5]), "alpha": 0.55, "place": ""}
    zones = (
        Area(nothing, nothing, nothing, colour, 0.55, name)
        for colour, name in zip(colours, ("sticks", "slides"), strict=True)
    )
    panel = _ellipse_panel(item, Map(field.x, across, field.sliding.astype(float), **look), *zones, margin_across=0.28)
    return panel.plus(legend="upper right", columns=2)


@sheet_of.register(RollingStartSolution)
def start_sheet(item: RollingStartSolution, *, extent: float | None = None) -> Sheet:
    """Return the force over the distance rolled, and the springs at some distances."""
    along, force = series("distance", item.distance), r"shear force $F_x/(\mu F_N)$"
    steady = float(item.steady.saturation)
    marks: list[Any] = [
        Line(along.content, item.shear_force / _friction_bound(item.problem, float(item.contact.force)), name="$F_x$"),
        Rule(steady, width=1.1, dash=style.DASHES[1], name="steady"),
        zero(),
    ]
    width = 2.0 * float(item.contact.radius)
    if width < float(item.distance[-1]):
        look: dict[str, Any] = {"across": "left", "upright": "baseline", "colour": style.MUTED, "size": 9.0}
        marks.append(Rule(width, upright=True, width=0.9, dash=style.DOTTED))
        marks.append(Text(width, 0.5, " $2a$", framed=(False, True), **look))
    left = Panel(
        tuple(marks), PanelAxis.of(along), PanelAxis(force), legend="lower right", title="from rest to steady rolling"
    )
    places = np.unique(np.linspace(0, len(item.states) - 1, STATES_DRAWN).round().astype(int))
    right = _states_panel(item, [(int(k), _rolled_so_far(item, int(k))) for k in places])
    return Sheet((left, right.plus(title=TO_THE_RIGHT)), height=3.3)


def _rolled_so_far(item: RollingStartSolution, index: int) -> str:
    return f"{float(item.distance[index]) / float(item.contact.radius):.2g} $a$"


def _states_panel(item: RollingStartSolution | OscillatingRollingSolution, chosen: list[tuple[int, str]]) -> Panel:
    """Return the loads of the springs in some states, and their bounds."""
    states, x = item.states, item.states[0].x
    bound = item.problem.friction.coefficient * item.contact.line_load(x)
    signs = (1.0, -1.0) if min(float(np.min(state.shear_load)) for state in states) < 0.0 else (1.0,)
    dashed: dict[str, Any] = {"colour": style.MUTED, "width": 1.1, "dash": style.DASHES[1]}
    lines = [Line(x, sign * bound, name=BOUND if sign > 0.0 else "", **dashed) for sign in signs]
    for colour, (index, name) in zip(style.CYCLE, chosen, strict=False):
        lines.append(Line(x, states[index].shear_load, colour, width=1.4, name=name))
    upright = PanelAxis.of(series("shear_load", bound))
    return Panel(tuple(lines), PanelAxis.of(series("x", x)), upright, legend="upper left", outside=True)


@sheet_of.register(OscillatingRollingSolution)
def rocking_sheet(item: OscillatingRollingSolution, *, extent: float | None = None) -> Sheet:
    """Return the shift over the cycles, the springs after some of them, and the load in the shakedown diagram."""
    problem, radius = item.problem, float(item.contact.radius)
    bound_force = _friction_bound(problem, float(item.contact.force))
    last = len(item.states) - 1
    after = sorted({0, 1, min(4, last), last})
    labels = [(k, "at rest" if k == 0 else f"{k} cycles" if k > 1 else "1 cycle") for k in after]
    shares = np.linspace(0.0, 1.0, 61)[1:]
    limits = [dataclasses.replace(problem, amplitude=float(w) * radius).shakedown_force / bound_force for w in shares]
    shares, limit = np.concatenate([[0.0], shares]), np.concatenate([[1.0], limits])
    look: dict[str, Any] = {"across": "left", "upright": "baseline", "size": 9.0}
    colour = style.RED if item.ratchets else style.GREEN
    this_load = min(problem.amplitude / radius, 1.0), problem.shear_force / bound_force
    marks = (
        Area(shares, limit, 1.0, style.RED),
        Area(shares, 0.0, limit, style.GREEN),
        Line(shares, limit, style.INK),
        Text(0.1, 0.25, "comes to rest", **look),
        Text(0.55, 0.75, "creeps on", **look),
        points(*this_load, colour, clipped=False),
    )
    axes = PanelAxis("amplitude $W/a$", low=0.0, high=1.0), PanelAxis(r"shear force $F_x/(\mu F_N)$", low=0.0, high=1.0)
    panels = titled(
        (
            curves_panel(row_of(item, "cycle"), [(row_of(item, "shift"), "")]),
            _states_panel(item, labels),
            Panel(marks, *axes),
        ),
        "creeps on" if item.ratchets else "comes to rest",
        "load of the springs, in the middle",
        "limit of shakedown",
    )
    return Sheet(panels, width=4.0, height=3.3)
