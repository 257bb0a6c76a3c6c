"""Sheets of bodies that strike metal: one blow with its dent, or restitution and dents over the velocity."""

from __future__ import annotations

import math

import numpy as np

from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Panel, Rule, Sheet, titled
from winkler.plot.particles.dent_film import blow_of
from winkler.plot.particles.yielding import plastic_sheet
from winkler.plot.series import positive, row_of, series, with_unit
from winkler.problems.plastic.impact import PlasticImpactSolution

TITLES = "restitution", "dent", "time of contact"


@without_extent(PlasticImpactSolution)
def plastic_impact_sheet(item: PlasticImpactSolution) -> Sheet:
    """Return force and radius over the depth, and the dent, of one velocity; of many what depends on it."""
    if np.size(item.velocity) == 1:
        blow = plastic_sheet(blow_of(item))
        left = f"the dent is {with_unit(float(np.max(item.residual_depth)), 'm')} deep"
        return Sheet(
            blow.panels, height=blow.height, title=f"restitution $e$ = {float(np.max(item.restitution)):.4g}; {left}"
        )
    velocity, first = row_of(item, "velocity"), item.yield_velocity
    depth = row_of(item, "residual_depth")
    radius = np.where(depth.content > 0.0, row_of(item, "largest_radius").content, np.nan)  # a dent where they yield
    dents = (positive(depth), "depth $d_0$"), (series("largest_radius", radius, type(item)), "radius $a_m$")
    panels: tuple[Panel, ...] = (
        curves_panel(velocity, [(row_of(item, "restitution"), "")]),
        curves_panel(velocity, dents, label="dent", log=bool(np.any(depth.content > 0.0))),
        curves_panel(velocity, [(row_of(item, "duration"), "")]),
    )
    if float(np.min(velocity.content)) < first < float(np.max(velocity.content)):
        begins = Rule(first, upright=True, colour=style.GREEN, dash=style.DASHES[2])
        panels = tuple(panel.plus(begins) for panel in panels)
    begun = f"yielding begins at {with_unit(first, 'm/s')}" if 0.0 < first < math.inf else ""
    return Sheet(titled(panels, *TITLES), title=begun)
