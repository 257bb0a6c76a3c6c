"""Sheets of impacts: forces, velocities, energies and the contact over time."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.plot import style
from winkler.plot.curves import Quantity, curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.friction.curves import bounds, energies_panel, loop_panel
from winkler.plot.panel import Band, Panel, Sheet, titled
from winkler.plot.series import series_of
from winkler.problems.impact.adhesive_impact import AdhesiveImpactSolution
from winkler.problems.impact.impact import ImpactSolution

STOPPED_IN_CONTACT = "stopped before the bodies part"


@without_extent(ImpactSolution)
def impact_sheet(item: ImpactSolution) -> Sheet:
    """Return forces, velocities, the contact and the energies over time; phases of edge sliding are shaded."""
    time = series_of(item, "time")
    mu = float(item.problem.law.coefficient)
    forces = [Quantity(series_of(item, "force"), "$F_N$"), Quantity(series_of(item, "shear_force"), "$F_x$")]
    if math.isfinite(mu) and np.any(item.shear_force):
        forces += bounds("shear_force", mu * item.force)
    speeds = [(series_of(item, "velocity"), "approach $v$")]
    if item.problem.sliding_velocity != 0.0:
        speeds += [
            (series_of(item, "sliding_velocity"), "sliding $w$"),
            (series_of(item, "lateral_velocity"), "centre $v_x$"),
        ]
    radii = [(series_of(item, "radius"), "contact $a$"), (series_of(item, "stick_radius"), "stick $c$")]
    names = {
        "dissipation": "lost",
        "stored_energy": "elastic, along the surface",
        "energy": "elastic, across",
        "kinetic_energy": "kinetic",
    }
    panels = titled(
        (
            curves_panel(time, forces, label="force"),
            curves_panel(time, speeds, label="velocity"),
            _with_slip(curves_panel(time, radii, label="radius"), item),
            energies_panel(item, names, height_factor=1.55 / 1.15),
        ),
        "forces",
        "velocities",
        "contact",
        "energy",
    )
    return Sheet(panels, 2, height=3.1, title=_restitution(item))


@without_extent(AdhesiveImpactSolution)
def adhesive_impact_sheet(item: AdhesiveImpactSolution) -> Sheet:
    """Return the force over the depth, velocity and energies over time, of an adhesive impact."""
    time = series_of(item, "time")
    energies = [
        (series_of(item, "kinetic_energy"), "kinetic"),
        (series_of(item, "energy"), "bodies and surfaces"),
        (series_of(item, "dissipation"), "lost"),
    ]
    panels = titled(
        (
            loop_panel(series_of(item, "depth"), series_of(item, "force"), float(item.dissipation[-1])),
            curves_panel(time, [(series_of(item, "velocity"), "")], label="velocity of approach $v$"),
            curves_panel(time, [(series_of(item, "radius"), "")], label="contact radius $a$"),
            curves_panel(time, energies, label="energy"),
        ),
        "force over depth",
        "velocity",
        "contact",
        "energy",
    )
    left = STOPPED_IN_CONTACT if math.isnan(item.restitution) else f"restitution $e$ = {item.restitution:.4g}"
    return Sheet(panels, 2, height=3.1, title="the body stays" if item.captured else left)


def _restitution(item: ImpactSolution) -> str:
    if math.isnan(item.restitution):
        return STOPPED_IN_CONTACT
    text = f"restitution $e$ = {item.restitution:.4g}"
    if item.problem.sliding_velocity != 0.0:
        text += f"   of the touching points $e_x$ = {item.lateral_restitution:.4g}"
    return text


def _with_slip(panel: Panel, item: ImpactSolution) -> Panel:
    """Return a panel over time with shades while the edge of the contact slides, forwards or backwards."""
    labelled: set[int] = set()
    bands = []
    for stage in item.stages:
        if stage.side == 0:
            continue
        name = "" if stage.side in labelled else f"edge slides {'forwards' if stage.side > 0 else 'backwards'}"
        bands.append(Band(stage.start, stage.end, style.RED if stage.side > 0 else style.ORANGE, 0.12, name))
        labelled.add(stage.side)
    headroom = 1.5 * (1.0 + panel.upright.headroom) - 1.0
    upright = dataclasses.replace(panel.upright, headroom=headroom)
    return panel.plus(*bands, upright=upright, legend="upper right", columns=1, spaced=False)
