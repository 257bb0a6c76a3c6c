"""Sheets of rolling: creep curves, where the contact sticks and slides, how rolling begins, and rocking to and fro."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.series import Series, middle_scale, series
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.oscillating import OscillatingRollingSolution
from winkler.problems.rolling.simplified_theory import SimplifiedRollingSolution
from winkler.problems.rolling.start import RollingStartSolution
from winkler.problems.rolling.steady import RollingSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__: list[str] = []

POINTS = 121
BEYOND = 1.35
"""Creep curves go so far beyond the creepage from which all slides."""
SHOWN = 5
"""States of a march that are drawn."""
STRIPS = 160
"""Strips of a map of tractions."""
ARROWS = 13
GROWTHS = 40
"""How often a creep curve grows longer by a third in search of its end."""
UNSEEN = 1e-9
"""A smaller part of the sliding force is not drawn."""
WORDS = ("longitudinal", "lateral", "spin")


def _solved_at(item: Any, factor: Array) -> Any:
    """Return the answers to so many times the creepage of `item`, each one array."""
    given = item.problem.creepage
    creepage = Creepage(*(factor * float(part) for part in (given.longitudinal, given.lateral, given.spin)))
    return dataclasses.replace(item.problem, creepage=creepage).solve()


def _most(problem: Any, force: float) -> float:
    return float(problem.friction.coefficient) * force


def _strongest(item: Any) -> Any:
    """Return the answer with the greatest shear force, to one creepage."""
    creepage = item.problem.creepage
    if creepage.shape == ():
        return item
    place = int(np.argmax(np.ravel(item.shear_force)))
    one = Creepage(*(float(part[place]) for part in creepage.broadcast()))
    return dataclasses.replace(item.problem, creepage=one).solve()


def _draw_creep(axes: Axes, item: Any, force: float) -> None:
    """Draw the force over the creepage: of many what was asked, of one all creepages in its proportion."""
    single = item.problem.creepage.shape == ()
    given = item.problem.creepage
    spread = {name: float(np.ptp(np.asarray(getattr(given, name), dtype=float))) for name in WORDS}
    moved = {name: float(np.max(np.abs(getattr(given, name)))) for name in WORDS}
    names = [name for name in WORDS if (moved[name] if single else spread[name]) > 0.0]
    if not names:
        style.note(axes, "no creepage, no force" if single else "one creepage, many times", where="upper centre")
        return
    curve = _solved_at(item, np.linspace(0.0, _far(item), POINTS)) if single else item
    along = _along(curve, names[0])
    order = np.argsort(along.content, kind="stable")
    most, lines = _most(item.problem, force), 0
    for part, colour in (("longitudinal_force", style.BLUE), ("lateral_force", style.RED)):
        content = np.ravel(np.asarray(getattr(curve, part))) / most
        if np.max(np.abs(content)) < UNSEEN:
            continue
        lines += 1
        marker = "" if single or content.size > 40 else "o"
        axes.plot(along.shown()[order], content[order], color=colour, marker=marker, label=part.removesuffix("_force"))
        if single:
            place = float(getattr(given, names[0])) / along.scale.factor
            axes.plot([place], [float(getattr(item, part)) / most], "o", color=colour)
        if np.max(np.abs(content)) > 0.8:
            axes.axhline(np.sign(content[np.argmax(np.abs(content))]), color=style.MUTED, linewidth=0.9, linestyle=":")
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
    axes.margins(y=0.1)
    others = ", the others in proportion" if single and len(names) > 1 else ""
    symbol = along.word.symbol
    unit = f" [{along.scale.unit}]" if along.scale.unit else ""
    axes.set_xlabel(f"{names[0]}{' creepage' if names[0] != 'spin' else ''} ${symbol}${unit}{others}")
    axes.set_ylabel(r"creep force $F/(\mu F_N)$")
    if lines > 1:
        style.framed_legend(axes, loc="best")


def _along(curve: Any, name: str) -> Series:
    creepage = curve.problem.creepage
    content = np.broadcast_to(np.asarray(getattr(creepage, name), dtype=float), creepage.shape)
    return series(Creepage, name, np.ravel(content))


def _far(item: Any) -> float:
    """Return how many times its creepage a curve goes: until all slides, or well beyond the greatest force."""
    limit, reached = 1.0, 0.0
    for _ in range(GROWTHS):
        saturation = float(_solved_at(item, np.array([limit])).saturation[0])
        if saturation > 0.995 or saturation < reached:
            break
        limit, reached = 1.3 * limit, saturation
    return (BEYOND if item.problem.creepage.spin == 0.0 else 2.0 * BEYOND) * limit


@draw.register(RollingSolution)
def rolling_sheet(item: RollingSolution, *, extent: float | None = None) -> Picture:
    """Return the creep curve, and what the springs bear at the greatest creepage that was asked for."""
    one = _strongest(item)
    a = float(item.contact.radius) if extent is None else extent
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        _draw_creep(left, item, float(item.contact.force))
        x = a * np.linspace(-1.0, 1.0, 801)
        load = one.shear_load(x)
        bound = one.problem.friction.coefficient * one.contact.line_load(x)
        _draw_line(right, x, load, bound)
        left.set_title("creep force")
        right.set_title("load of the springs, rolling to the right")
    return figure


def _draw_line(axes: Axes, x: Array, load: Array, bound: Array) -> None:
    along, of = series("RollingState", "x", x), series("RollingState", "shear_load", load)
    limit = middle_scale(of.word.unit, bound)
    sticks = load < bound * (1.0 - 1e-9)
    upright = limit.factor
    axes.plot(along.shown(), bound / upright, color=style.MUTED, linestyle=style.DASHES[1], label=r"bound $\mu q_z$")
    axes.plot(along.shown(), load / upright, color=style.BLUE, label="$q_x$")
    axes.fill_between(along.shown(), load / upright, where=sticks, color=style.BLUE, alpha=0.15, linewidth=0.0)
    axes.set_ylim(0.0, 1.15 * float(np.max(bound)) / upright)
    axes.set_xlabel(along.label())
    axes.set_ylabel(of.label(limit))
    style.framed_legend(axes, loc="upper left")
    if np.any(sticks):
        style.note(axes, "shaded: sticks", where="upper right")


@draw.register(SimplifiedRollingSolution)
def simplified_sheet(item: SimplifiedRollingSolution, *, extent: float | None = None) -> Picture:
    """Return the creep curve, the tractions over the contact, and where it sticks and slides."""
    one = _strongest(item)
    fine = dataclasses.replace(one.problem, count=max(STRIPS, one.problem.count)).solve()
    with style.styled():
        figure = style.figure(3, width=3.9, height=3.3)
        left, middle, right = figure.subplots(1, 3)
        _draw_creep(left, item, float(item.problem.load.force))
        _draw_traction(middle, fine)
        _draw_zones(right, fine)
        for axes, title in zip(
            (left, middle, right),
            ("creep force", "traction, rolling to the right", "where it sticks and slides"),
            strict=True,
        ):
            axes.set_title(title)
    return figure


def _outlined(axes: Axes, item: SimplifiedRollingSolution) -> tuple[float, str]:
    """Draw the ellipse and label both axes alike; return the factor and unit of lengths."""
    a, b = item.longitudinal_semi_axis, item.lateral_semi_axis
    scale = middle_scale("m", np.array([a, b]))
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.plot(a * np.cos(turn) / scale.factor, b * np.sin(turn) / scale.factor, color=style.INK, linewidth=1.0)
    axes.set_aspect("equal")
    axes.set_xlabel(f"$x$ [{scale.unit}]")
    axes.set_ylabel(f"$y$ [{scale.unit}]")
    axes.grid(visible=False)
    axes.margins(0.05)
    return scale.factor, scale.unit


def _draw_traction(axes: Axes, item: SimplifiedRollingSolution) -> None:
    field = item.traction
    factor, _ = _outlined(axes, item)
    size = series("RollingTraction", "traction", field.traction)
    across = field.y[:, :1] * np.ones_like(field.x)
    drawn = axes.pcolormesh(
        field.x / factor, across / factor, size.shown(), cmap=style.shades(), shading="gouraud", rasterized=True
    )
    axes.figure.colorbar(drawn, ax=axes, label=size.label(), shrink=0.85)
    rows = np.unique(np.linspace(2, field.x.shape[0] - 3, ARROWS).round().astype(int))
    columns = np.unique(np.linspace(3, field.x.shape[1] - 4, ARROWS).round().astype(int))
    place = np.ix_(rows, columns)
    axes.quiver(
        field.x[place] / factor,
        across[place] / factor,
        field.longitudinal[place],
        field.lateral[place],
        color=style.INK,
        angles="xy",
        pivot="mid",
        width=0.005,
    )


def _draw_zones(axes: Axes, item: SimplifiedRollingSolution) -> None:
    field = item.traction
    factor, _ = _outlined(axes, item)
    across = field.y[:, :1] * np.ones_like(field.x)
    axes.contourf(
        field.x / factor,
        across / factor,
        field.sliding.astype(float),
        levels=[-0.5, 0.5, 1.5],
        colors=[style.BLUE, style.ORANGE],
        alpha=0.55,
    )
    from matplotlib.patches import Patch

    zones = [Patch(color=style.BLUE, alpha=0.55, label="sticks"), Patch(color=style.ORANGE, alpha=0.55, label="slides")]
    axes.margins(x=0.05, y=0.28)
    style.framed_legend(axes, handles=zones, loc="upper right", ncols=2)


@draw.register(RollingStartSolution)
def start_sheet(item: RollingStartSolution, *, extent: float | None = None) -> Picture:
    """Return the force over the distance rolled, and the springs at some places on the way."""
    most = _most(item.problem, float(item.contact.force))
    steady = item.steady
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        along = series("RollingStartSolution", "distance", item.distance)
        left.plot(along.shown(), item.shear_force / most, color=style.BLUE, label="$F_x$")
        left.axhline(
            float(steady.saturation), color=style.MUTED, linestyle=style.DASHES[1], linewidth=1.1, label="steady"
        )
        width = 2.0 * float(item.contact.radius)
        if width < float(item.distance[-1]):
            left.axvline(width / along.scale.factor, color=style.MUTED, linestyle=":", linewidth=0.9)
            left.text(width / along.scale.factor, 0.5, " $2a$", transform=left.get_xaxis_transform(), color=style.MUTED)
        left.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
        left.set_xlabel(along.label())
        left.set_ylabel(r"shear force $F_x/(\mu F_N)$")
        style.framed_legend(left, loc="lower right")
        places = np.unique(np.linspace(0, len(item.states) - 1, SHOWN).round().astype(int))
        _draw_states(right, item, [(int(k), _rolled_so_far(item, int(k))) for k in places])
        left.set_title("from rest to steady rolling")
        right.set_title("load of the springs, rolling to the right")
    return figure


def _rolled_so_far(item: RollingStartSolution, index: int) -> str:
    return f"{float(item.distance[index]) / float(item.contact.radius):.2g} $a$"


def _draw_states(
    axes: Axes, item: RollingStartSolution | OscillatingRollingSolution, chosen: list[tuple[int, str]]
) -> None:
    """Draw what springs bear in some states, and what they can bear."""
    states = item.states
    bound = item.problem.friction.coefficient * item.contact.line_load(states[0].x)
    signs = (1.0, -1.0) if min(float(np.min(state.shear_load)) for state in states) < 0.0 else (1.0,)
    along, limit = series("RollingState", "x", states[0].x), series("RollingState", "shear_load", bound)
    for sign in signs:
        axes.plot(
            along.shown(),
            sign * limit.shown(),
            color=style.MUTED,
            linestyle=style.DASHES[1],
            linewidth=1.1,
            label=r"bound $\mu q_z$" if sign > 0.0 else "_",
        )
    for colour, (index, told) in zip(style.CYCLE, chosen, strict=False):
        axes.plot(along.shown(), states[index].shear_load / limit.scale.factor, color=colour, linewidth=1.4, label=told)
    axes.set_xlabel(along.label())
    axes.set_ylabel(limit.label())
    style.framed_legend(axes, loc="upper left", bbox_to_anchor=(1.0, 1.0))


@draw.register(OscillatingRollingSolution)
def rocking_sheet(item: OscillatingRollingSolution, *, extent: float | None = None) -> Picture:
    """Return the shift over the cycles, the springs after some of them, and where the force lies to the limit."""
    problem, radius = item.problem, float(item.contact.radius)
    most = _most(problem, float(item.contact.force))
    with style.styled():
        figure = style.figure(3, width=4.0, height=3.3)
        left, middle, right = figure.subplots(1, 3)
        of = series("OscillatingRollingSolution", "shift", item.shift)
        left.plot(item.cycle, of.shown(), color=style.BLUE, marker="o" if item.cycle.size < 40 else "", markersize=3.5)
        left.set_ylim(0.0, None)
        left.margins(x=0.03)
        left.set_xlabel("cycles $n$")
        left.set_ylabel(of.label())
        last = len(item.states) - 1
        after = sorted({0, 1, min(4, last), last})
        _draw_states(middle, item, [(k, "at rest" if k == 0 else f"{k} cycles" if k > 1 else "1 cycle") for k in after])
        ways = np.linspace(0.0, 1.0, 61)[1:]
        limits = [dataclasses.replace(problem, amplitude=float(w) * radius).shakedown_force / most for w in ways]
        ways, limit = np.concatenate([[0.0], ways]), np.concatenate([[1.0], limits])
        right.fill_between(ways, limit, 1.0, color=style.RED, alpha=0.14, linewidth=0.0)
        right.fill_between(ways, 0.0, limit, color=style.GREEN, alpha=0.14, linewidth=0.0)
        right.plot(ways, limit, color=style.INK)
        right.text(0.1, 0.25, "comes to rest", color=style.INK)
        right.text(0.55, 0.75, "creeps on", color=style.INK)
        at = min(problem.amplitude / radius, 1.0)
        right.plot(
            [at], [problem.shear_force / most], "o", color=style.RED if item.ratchets else style.GREEN, clip_on=False
        )
        right.set_xlim(0.0, 1.0)
        right.set_ylim(0.0, 1.0)
        right.set_xlabel("amplitude $W/a$")
        right.set_ylabel(r"shear force $F_x/(\mu F_N)$")
        left.set_title("creeps on" if item.ratchets else "comes to rest")
        middle.set_title("load of the springs, in the middle")
        right.set_title("limit of shakedown")
    return figure
