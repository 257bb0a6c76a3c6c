"""Sheets of rough contacts that conduct: clusters of spots, and bounds for any roughness."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Area, Bars, Line, Map, Panel, PanelAxis, Rule, Sheet, plane
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.conduction.bounds import ConductanceBoundsSolution
from winkler.problems.conduction.spots import SpotClusterSolution
from winkler.problems.normal.indentation import Indentation

POINTS = 161


@without_extent(SpotClusterSolution)
def spots_sheet(item: SpotClusterSolution) -> Sheet:
    """Return the spots from above, shaded by their current density, and the current of each spot."""
    problem = item.problem
    reach = np.hypot(problem.x - np.mean(problem.x), problem.y - np.mean(problem.y)) + problem.radii
    scale = scale_of("m", reach)
    # current over radius, against that of all spots together: the reduction by the other spots
    load = item.shares / problem.radii * np.sum(problem.radii)
    bar = PanelAxis("current over that of its radius' part")
    marks: list[Any] = [Map(problem.x, problem.y, problem.radii, bar, kind="discs", levels=load, shrink=0.8)]
    if math.isfinite(item.holm_radius):
        weight, turn = problem.radii / np.sum(problem.radii), np.linspace(0.0, 2.0 * np.pi, 181)
        x = float(weight @ problem.x) + item.holm_radius * np.cos(turn)
        y = float(weight @ problem.y) + item.holm_radius * np.sin(turn)
        marks.append(Line(x, y, style.RED, width=1.2, dash=style.DASHES[1]))
    axes = plane(scale, margin=0.08)
    left = Panel(tuple(marks), *axes, equal=True, title="the spots; red: Holm radius of their cluster")
    parts = (
        ("spots on their own", item.alone, 1.0, style.BLUE, 0.0),
        ("their interaction", item.resistance - item.alone, 1.0, style.ORANGE, item.alone),
        ("Greenwood's estimate", item.greenwood, 0.0, style.MUTED, 0.0),
    )
    bars = [
        Bars(np.array([row]), np.array([length]), colour, 0.5, start, name)
        for name, length, row, colour, start in parts
    ]
    greatest = max(item.greenwood, item.resistance)
    across = PanelAxis("resistance $R$", scale_of("ohm", [one[1] for one in parts]), low=0.0, high=1.08 * greatest)
    upright = PanelAxis(low=-0.6, high=2.3, ticks=np.array([0.0, 1.0]), names=("Greenwood", "one voltage"))
    title = f"$R$ = {with_unit(item.resistance, 'ohm')}"
    return Sheet((left, Panel(tuple(bars), across, upright, title, grid="x", legend="upper left")), height=3.3)


@without_extent(ConductanceBoundsSolution)
def bounds_sheet(item: ConductanceBoundsSolution) -> Sheet:
    """Return the force curves that bound a rough contact, and the bounds of its incremental stiffness."""
    problem = item.problem
    bed, rough = problem.bed, problem.roughness
    depth0 = float(Indentation(bed, Force(problem.force)).solve().depth)
    span = 2.2 * depth0 + rough
    depth = np.linspace(0.0, span, POINTS)
    ends = [d for d in (span, 1.6 * depth0, depth0) if d <= span]
    for end in ends:
        try:
            depth = np.linspace(0.0, end, POINTS)
            smooth = Indentation(bed, Depth(depth)).solve().force
            break
        except ValueError:
            continue
    along, of = series("depth", depth + rough), series("force", np.asarray(smooth))
    force, shifted = of.content, depth + rough
    marks: list[Any] = [
        Line(depth, force, name="smooth"),
        Line(shifted, force, dash=style.DASHES[1], name="smooth, offset"),
        Area(force, depth, shifted, alpha=0.12, across=True),
        Rule(problem.force),
    ]
    slopes = ((item.least_stiffness, style.GREEN, "flattest"), (item.greatest_stiffness, style.RED, "steepest"))
    for slope, colour, name in slopes:
        line = np.array([-0.6, 0.6]) * depth0
        text = f"{name}: {with_unit(slope, 'N/m')}"
        marks.append(Line(depth0 + rough + line, problem.force + slope * line, colour, dash=style.DASHES[3], name=text))
    across, upright = (
        PanelAxis.of(along, low=0.0, high=float(shifted[-1])),
        PanelAxis.of(of, low=0.0, high=float(np.max(force))),
    )
    title = f"conductance from {with_unit(item.least_conductance, 'S')} to {with_unit(item.greatest_conductance, 'S')}"
    return Sheet((Panel(tuple(marks), across, upright, title, legend="upper left"),), width=5.2, height=3.4)
