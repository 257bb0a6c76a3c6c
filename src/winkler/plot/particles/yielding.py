"""What yields along its path: force and contact radius over the depth, loading and unloading, and the dent."""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force, LineForce
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import loss_text
from winkler.plot.panel import Line, Panel, PanelAxis, Rule, Sheet, note, titled, zero
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.particles.elastic_plastic import ParticleSolution
from winkler.problems.plastic.dent_limit import DentLimitSolution
from winkler.problems.plastic.indentation import PlasticSolution
from winkler.problems.plastic.line_indentation import LinePlasticIndentation, LinePlasticSolution
from winkler.problems.plastic.strength_from_dent import StrengthFromDentSolution

Yielding = ParticleSolution | PlasticSolution

STATES_PER_LEG = 120
"""Number of states on each leg of the path."""
JUMP_OFFSET = 1e-9
"""Relative distance in depth of the states before and after a jump."""
LOOP_TITLES = "force over depth", "contact radius over depth"
DENT_POINTS = 121
MOST_MARKED_POINTS = 40
"""Points of a path are marked individually up to this number."""


class _Leg(NamedTuple):
    """States from one point of the path to the next, and whether they go deeper."""

    deeper: bool
    depth: Array
    force: Array
    radius: Array


@without_extent(ParticleSolution)
def particle_sheet(item: ParticleSolution) -> Sheet:
    """Return force and contact radius over the depth: going in, coming out, and where yield begins."""
    panels = titled(loop_panels(item, "depth (overlap)"), *LOOP_TITLES)
    return Sheet(panels, height=3.5, title=_headline(item))


@without_extent(PlasticSolution)
def plastic_sheet(item: PlasticSolution) -> Sheet:
    """Return force and contact radius over the depth, and the dent under the greatest load and after it."""
    loop = loop_panels(item, "depth")
    if float(np.max(item.dissipation, initial=0.0)) == 0.0:
        return Sheet(titled(loop, *LOOP_TITLES), height=3.5, title="elastic: no body yields along this path")
    begun = (
        "under a sharp tip the bodies yield at once"
        if item.yield_depth == 0.0
        else (f"yielding begins at $F_Y$ = {with_unit(item.yield_force, 'N')}")
    )
    left = f"the dent is {with_unit(float(item.residual_depth[-1]), 'm')} deep"
    elliptic = bool(item.problem.bed.footprint.unlike_disc)  # of whose dent the depth alone is known
    panels = titled(loop if elliptic else (*loop, _dent_panel(item)), *LOOP_TITLES, *([] if elliptic else ["the dent"]))
    return Sheet(panels, height=3.5, title=f"{begun}; {left}")


@without_extent(DentLimitSolution)
def dent_limit_sheet(item: DentLimitSolution) -> Sheet:
    """Return the contact under the load that leaves the dent, and let go."""
    left = with_unit(item.problem.residual_depth, "m")
    title = f"{with_unit(item.force, 'N')} leave a dent {left} deep"
    return dataclasses.replace(plastic_sheet(item.released), title=title)


@without_extent(StrengthFromDentSolution)
def dent_strength_sheet(item: StrengthFromDentSolution) -> Sheet:
    """Return the contact of a body with the strength that was found, and its dent."""
    tells = "these loads give" if np.size(item.problem._sizes) > 1 else "this dent gives"
    title = f"{tells} a strength of {with_unit(item.strength, 'Pa')}"
    return dataclasses.replace(plastic_sheet(item.released), title=title)


@without_extent(LinePlasticSolution)
def line_dent_sheet(item: LinePlasticSolution) -> Sheet:
    """Return half-width and mean pressure of a strip over the force per length, and the dent after its path."""
    ends = np.append(0.0, item.force_per_length)
    legs = [(low, high) for low, high in itertools.pairwise(ends) if high != low]
    path = np.concatenate([np.linspace(low, high, STATES_PER_LEG) for low, high in legs] or [ends])
    along = LinePlasticIndentation(item.problem.bed, LineForce(path)).solve()
    across = series("force_per_length", path, LinePlasticSolution)
    begun = Rule(item.yield_force, upright=True, colour=style.GREEN, dash=style.DASHES[2], name="yield begins")
    panels = []
    for name in ("half_width", "mean_pressure"):
        row = series(name, getattr(along, name), LinePlasticSolution)
        marks: list[Line | Rule] = []
        named: set[bool] = set()
        for number, (low, high) in enumerate(legs):
            part, up = slice(number * STATES_PER_LEG, (number + 1) * STATES_PER_LEG), high > low
            colour, dash = (style.BLUE, style.DASHES[0]) if up else (style.RED, style.DASHES[1])
            text = "" if up in named else "loading" if up else "unloading"
            marks.append(Line(path[part], row.content[part], colour, dash=dash, name=text))
            named.add(up)
        if 0.0 < item.yield_force < float(np.max(path)):
            marks.append(begun)
        panels.append(
            Panel(tuple(marks), PanelAxis.of(across, margin=0.04), PanelAxis.of(row, margin=0.08), legend="lower right")
        )
    half = float(np.max(item.largest_half_width, initial=0.0))
    if float(np.max(item.residual_depth, initial=0.0)) > 0.0:
        x = np.linspace(-half, half, 2 * DENT_POINTS - 1)
        height = item.surface(x)
        low, high = float(np.min(height)), float(np.max(height))
        upright = PanelAxis("height", scale_of("m", [low]), low=1.1 * low, high=high - 0.2 * low)
        panels.append(Panel((Line(x, height, style.RED), zero()), PanelAxis("$x$", scale_of("m", [half])), upright))
        left = with_unit(float(item.residual_depth[-1]), "m")
        title = f"yielding begins at {with_unit(item.yield_force, 'N/m')}; the dent is {left} deep"
    else:
        title = "elastic: no body yields along this path"
    titles = ("half-width over force per length", "mean pressure over force per length", "the dent")[: len(panels)]
    return Sheet(titled(tuple(panels), *titles), height=3.5, title=title)


def _dent_panel(item: PlasticSolution) -> Panel:
    """Return the surface under the greatest load, and after it, as far as it is known: up to the edge."""
    bed, edge = item.problem.bed, float(item.largest_radius[-1])
    assert isinstance(bed, Foundation)
    greatest = dataclasses.replace(item.problem, path=Depth(np.array([np.max(item.depth)]))).solve()
    half = np.linspace(0.0, edge, DENT_POINTS)
    shape = bed.profile.height(half)
    pressed = shape - float(greatest.depth[0])
    left = shape - item.dented.profile.height(half) - float(item.residual_depth[-1])
    r = np.concatenate([-half[:0:-1], half])
    rows = [np.concatenate([row[:0:-1], row]) for row in (pressed, left)]
    marks = (
        Line(r, rows[0], style.INK, dash=style.DASHES[1], name="under the greatest load"),
        Line(r, rows[1], style.RED, name="after it"),
        zero(),
    )
    low, high = min(map(np.min, rows)), max(0.0, *(float(np.max(row)) for row in rows))
    upright = PanelAxis("height", scale_of("m", [low]), low=1.05 * low, high=high - 0.35 * low)
    return Panel(marks, PanelAxis("$r$", scale_of("m", [edge])), upright, legend="upper center")


def loop_panels(item: Yielding, across: str) -> tuple[Panel, Panel]:
    """Return force and contact radius over the depth, which is called so."""
    legs = _legs(item)
    force, radius = _panel(item, legs, "force", across), _panel(item, legs, "radius", across)
    lost = loss_text(float(item.dissipation[-1]), item.depth, item.force)
    return (
        force.plus(zero(), legend="upper left"),
        radius.plus(note(lost, "lower right"), upright=dataclasses.replace(radius.upright, low=0.0)),
    )


def _headline(item: ParticleSolution) -> str:
    deepest, onset = float(np.max(item.depth)), item.yield_depth
    if deepest <= onset:
        return "an elastic particle: it does not yield along this path"
    residual = float(item.residual_depth[-1])
    touching = f"after unloading it would just touch at $d_0$ = {with_unit(residual, 'm')}"
    return f"yields from $d_Y$ = {with_unit(onset, 'm')} on; {touching}"


def _panel(item: Yielding, legs: list[_Leg], name: str, across_name: str) -> Panel:
    """Return one quantity over the depth."""
    along = series("depth", np.concatenate([leg.depth for leg in legs]))
    of = series(name, np.concatenate([getattr(leg, name) for leg in legs]), type(item))
    labelled: set[bool] = set()
    marks: list[Line | Rule] = []
    for leg in legs:
        colour, dash = (style.BLUE, style.DASHES[0]) if leg.deeper else (style.RED, style.DASHES[1])
        text = "" if leg.deeper in labelled else "loading" if leg.deeper else "unloading"
        marks.append(Line(leg.depth, getattr(leg, name), colour, dash=dash, name=text))
        labelled.add(leg.deeper)
    if float(np.max(along.content)) > item.yield_depth:
        look: dict[str, Any] = {"colour": style.GREEN, "width": 1.8, "dash": style.DASHES[2]}
        marks.append(Rule(item.yield_depth, upright=True, name="yield begins", **look))
    if item.depth.size <= MOST_MARKED_POINTS:
        look = {"colour": style.INK, "width": 0.0, "marker": "o", "size": 4.0, "order": 5.0}
        marks.append(Line(item.depth, getattr(item, name), name="points of the path", **look))
    across = PanelAxis(along.label().partition(" [")[0].replace("depth", across_name, 1), along.scale, margin=0.04)
    return Panel(tuple(marks), across, PanelAxis.of(of, margin=0.08, headroom=0.0 if name == "radius" else 0.45))


def _legs(item: Yielding) -> list[_Leg]:
    """Return the whole path through many states, up to the last solved state."""
    problem, by_depth = item.problem, isinstance(item.problem.path, Depth)
    levels = item.depth if by_depth else item.force
    row = np.append(min(0.0, float(levels[0])), levels)
    jump = item.yield_depth if by_depth else math.inf
    parts = [_between(low, high, jump) for low, high in itertools.pairwise(row)]
    dense = np.concatenate([row[:1], *parts])
    states = dataclasses.replace(problem, path=Depth(dense) if by_depth else Force(dense)).solve()
    legs, start = [], 0
    for one, (low, high) in zip(parts, itertools.pairwise(row), strict=True):
        part = slice(start, start + one.size + 1)
        start += one.size
        if high != low:
            legs.append(_Leg(high > low, states.depth[part], states.force[part], states.radius[part]))
    return legs


def _between(low: float, high: float, jump: float) -> Array:
    """Return levels in (low, high], with both sides of a jump between them."""
    states = np.linspace(low, high, STATES_PER_LEG + 1)[1:]
    beside = np.array([jump * (1.0 - JUMP_OFFSET), jump * (1.0 + JUMP_OFFSET)])
    inside = beside[(beside > min(low, high)) & (beside < max(low, high))]
    states = np.unique(np.append(states, inside))
    return states if low < high else states[::-1]
