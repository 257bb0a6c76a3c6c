"""Sheets of impacts: forces, velocities, energies and the contact over time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.plot import style
from winkler.plot.friction.curves import draw_energies, draw_lines, draw_loop
from winkler.plot.series import Series, series
from winkler.problems.impact.adhesive_impact import AdhesiveImpactSolution
from winkler.problems.impact.impact import ImpactSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["adhesive_impact_sheet", "impact_sheet"]


STOPPED = "stopped before the bodies part"


def impact_sheet(item: ImpactSolution) -> Picture:
    """Return forces, velocities, the contact and the energies over time; shaded while the edge slides."""
    time = _told(item, "time")
    mu = float(item.problem.law.coefficient)
    with style.styled():
        figure = style.figure(2, 2, height=3.1)
        panels = figure.subplots(2, 2, squeeze=False).ravel()
        forces = [(_told(item, "force"), "$F_N$"), (_told(item, "shear_force"), "$F_x$")]
        if math.isfinite(mu) and np.any(item.shear_force):
            forces += [
                (
                    series("ImpactSolution", "shear_force", sign * mu * item.force),
                    r"$\pm\mu F_N$" if sign > 0.0 else "_",
                )
                for sign in (1.0, -1.0)
            ]
        draw_lines(panels[0], time, forces, "force")
        if len(forces) > 2:
            for line in panels[0].lines[-2:]:
                line.set(color=style.MUTED, linestyle=style.DASHES[1], linewidth=1.1)
            style.framed_legend(panels[0], loc="upper center", ncols=3, columnspacing=1.2)
        speeds = [(_told(item, "velocity"), "approach $v$")]
        if item.problem.sliding_velocity != 0.0:
            speeds += [
                (_told(item, "sliding_velocity"), "sliding $w$"),
                (_told(item, "lateral_velocity"), "centre $v_x$"),
            ]
        draw_lines(panels[1], time, speeds, "velocity")
        radii = [(_told(item, "radius"), "contact $a$"), (_told(item, "stick_radius"), "stick $c$")]
        draw_lines(panels[2], time, radii, "radius")
        panels[2].set_ylim(0.0, None)
        names = {
            "dissipation": "lost",
            "stored_energy": "elastic, along the surface",
            "energy": "elastic, across",
            "kinetic_energy": "kinetic",
        }
        draw_energies(panels[3], item, names)
        panels[3].set_ylim(0.0, 1.55 * float(panels[3].get_ylim()[1]) / 1.15)
        _shade_slip(panels[2], item, time)
        for axes, title in zip(panels, ("forces", "velocities", "contact", "energy"), strict=True):
            axes.set_title(title)
        figure.suptitle(_told_restitution(item))
    return figure


def adhesive_impact_sheet(item: AdhesiveImpactSolution) -> Picture:
    """Return the force over the depth, velocity and energies over time, of an impact of a sticky body."""
    time = _told(item, "time")
    with style.styled():
        figure = style.figure(2, 2, height=3.1)
        panels = figure.subplots(2, 2, squeeze=False).ravel()
        draw_loop(panels[0], _told(item, "depth"), _told(item, "force"), float(item.dissipation[-1]))
        draw_lines(panels[1], time, [(_told(item, "velocity"), "approach")], "velocity of approach $v$")
        draw_lines(panels[2], time, [(_told(item, "radius"), "contact")], "contact radius $a$")
        panels[2].set_ylim(0.0, None)
        energies = [
            (_told(item, "kinetic_energy"), "kinetic"),
            (_told(item, "energy"), "bodies and surfaces"),
            (_told(item, "dissipation"), "lost"),
        ]
        draw_lines(panels[3], time, energies, "energy")
        for axes, title in zip(panels, ("force over depth", "velocity", "contact", "energy"), strict=True):
            axes.set_title(title)
        left = STOPPED if math.isnan(item.restitution) else f"restitution $e$ = {item.restitution:.4g}"
        figure.suptitle("the body stays" if item.captured else left)
    return figure


def _told(item: Any, name: str) -> Series:
    return series(type(item), name, getattr(item, name))


def _told_restitution(item: ImpactSolution) -> str:
    if math.isnan(item.restitution):
        return STOPPED
    text = f"restitution $e$ = {item.restitution:.4g}"
    if item.problem.sliding_velocity != 0.0:
        text += f"   of the touching points $e_x$ = {item.lateral_restitution:.4g}"
    return text


def _shade_slip(axes: Axes, item: ImpactSolution, time: Series) -> None:
    """Shade when the edge of the contact slides, forwards or backwards."""
    named: set[int] = set()
    for stage in item.stages:
        if stage.side == 0:
            continue
        label = {1: "edge slides forwards", -1: "edge slides backwards"}[stage.side]
        axes.axvspan(
            stage.start / time.scale.factor,
            stage.end / time.scale.factor,
            color=style.RED if stage.side > 0 else style.ORANGE,
            alpha=0.12,
            linewidth=0.0,
            label="_" if stage.side in named else label,
        )
        named.add(stage.side)
    style.framed_legend(axes, loc="upper right")
    axes.set_ylim(0.0, 1.5 * float(axes.get_ylim()[1]))
