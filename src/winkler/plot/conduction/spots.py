"""Sheets of rough contacts that conduct: clusters of spots, and bounds for any roughness."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.loading import Depth, Force
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.series import scale_of, series, told
from winkler.problems.conduction.bounds import ConductanceBoundsSolution
from winkler.problems.conduction.spots import SpotClusterSolution
from winkler.problems.normal.indentation import Indentation

if TYPE_CHECKING:
    from winkler.plot.picture import Picture

__all__ = ["bounds_sheet", "spots_sheet"]

POINTS = 161


def _refuse(item: Any, extent: float | None) -> None:
    if extent is not None:
        raise InvalidInput(f"draw: a {type(item).__name__} has no extent; leave it out.")


@draw.register(SpotClusterSolution)
def spots_sheet(item: SpotClusterSolution, *, extent: float | None = None) -> Picture:
    """Return the spots from above, shaded by their current density, and what every spot carries."""
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Circle

    _refuse(item, extent)
    problem = item.problem
    reach = np.hypot(problem.x - np.mean(problem.x), problem.y - np.mean(problem.y)) + problem.radii
    across = scale_of("m", reach)
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        # current over radius, against that of all spots together: how much the others take away from it
        load = item.shares / problem.radii * np.sum(problem.radii)
        circles = [
            Circle((x / across.factor, y / across.factor), a / across.factor)
            for x, y, a in zip(problem.x, problem.y, problem.radii, strict=True)
        ]
        spots = PatchCollection(circles, cmap=style.shades(), edgecolor=style.INK, linewidth=0.6)
        spots.set_array(load)
        left.add_collection(spots)
        if math.isfinite(item.holm_radius):
            weight = problem.radii / np.sum(problem.radii)
            middle = float(weight @ problem.x), float(weight @ problem.y)
            left.add_patch(
                Circle(
                    (middle[0] / across.factor, middle[1] / across.factor),
                    item.holm_radius / across.factor,
                    fill=False,
                    color=style.RED,
                    linestyle=style.DASHES[1],
                    linewidth=1.2,
                )
            )
        left.autoscale_view()
        left.margins(0.08)
        left.set_aspect("equal")
        left.set_xlabel(f"$x$ [{across.unit}]")
        left.set_ylabel(f"$y$ [{across.unit}]")
        figure.colorbar(spots, ax=left, shrink=0.8, label="current over that of its radius' part")
        left.set_title("the spots; red: Holm radius of their cluster")
        parts = {
            "spots on their own": item.alone,
            "their crowding": item.resistance - item.alone,
            "Greenwood's estimate": item.greenwood,
        }
        scale = scale_of("ohm", list(parts.values()))
        colours = (style.BLUE, style.ORANGE, style.MUTED)
        names = list(parts)
        starts = (0.0, item.alone, 0.0)
        for place, (name, colour, start) in enumerate(zip(names, colours, starts, strict=True)):
            row = 1 if place < 2 else 0
            right.barh(row, parts[name] / scale.factor, left=start / scale.factor, color=colour, height=0.5, label=name)
        right.set_yticks([0, 1], ["Greenwood", "one voltage"])
        right.set_ylim(-0.6, 2.3)
        right.set_xlim(0.0, 1.08 * max(item.greenwood, item.resistance) / scale.factor)
        right.set_xlabel(f"resistance $R$ [{scale.unit}]")
        right.grid(visible=False, axis="y")
        style.framed_legend(right, loc="upper left", ncols=1)
        right.set_title(f"$R$ = {told(item.resistance, 'ohm')}")
    return figure


@draw.register(ConductanceBoundsSolution)
def bounds_sheet(item: ConductanceBoundsSolution, *, extent: float | None = None) -> Picture:
    """Return the force curves between which a rough one must lie, and the steepest and flattest slopes there."""
    _refuse(item, extent)
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
    along, of = series("Indentation", "depth", depth + rough), series("Indentation", "force", np.asarray(smooth))
    with style.styled():
        figure = style.figure(width=5.2, height=3.4)
        axes: Any = figure.subplots()
        x, y = along.scale.factor, of.scale.factor
        axes.plot(depth / x, of.shown(), color=style.BLUE, label="smooth")
        axes.plot((depth + rough) / x, of.shown(), color=style.BLUE, linestyle=style.DASHES[1], label="smooth, offset")
        axes.fill_betweenx(of.shown(), depth / x, (depth + rough) / x, color=style.BLUE, alpha=0.12, linewidth=0.0)
        axes.axhline(problem.force / y, color=style.MUTED, linewidth=0.8)
        for start, slope, colour, name in (
            (depth0 + rough, item.least_stiffness, style.GREEN, "flattest"),
            (depth0 + rough, item.greatest_stiffness, style.RED, "steepest"),
        ):
            line = start + np.array([-0.6, 0.6]) * depth0
            force = problem.force + slope * (line - start)
            axes.plot(
                line / x, force / y, color=colour, linestyle=style.DASHES[3], label=f"{name}: {told(slope, 'N/m')}"
            )
        axes.set_ylim(0.0, float(np.max(of.shown())))
        axes.set_xlim(0.0, float(depth[-1] + rough) / x)
        axes.set_xlabel(along.label())
        axes.set_ylabel(of.label())
        style.framed_legend(axes, loc="upper left")
        least, most = told(item.least_conductance, "S"), told(item.greatest_conductance, "S")
        axes.set_title(f"conductance from {least} to {most}")
    return figure
