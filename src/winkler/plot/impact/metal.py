"""Sheets of bodies that strike metal: one blow with its dent, or restitution and dents over the velocity."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Panel, PanelAxis, Rule, Sheet, among, from_zero, titled
from winkler.plot.particles.dent_film import blow_of
from winkler.plot.particles.yielding import plastic_sheet
from winkler.plot.series import row_of, with_unit
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
    velocity = row_of(item, "velocity").content
    order = np.argsort(velocity, kind="stable")
    spread = float(np.max(velocity)) > 5.0 * float(np.min(velocity))
    across = PanelAxis.of(row_of(item, "velocity"), margin=0.03, log=spread)
    panels = (
        _over(item, order, across, "restitution"),
        _over(item, order, across, "residual_depth", "largest_radius"),
        _over(item, order, across, "duration"),
    )
    first = item.yield_velocity
    begun = f"yielding begins at {with_unit(first, 'm/s')}" if 0.0 < first < math.inf else ""
    return Sheet(titled(panels, *TITLES), title=begun)


def _over(item: PlasticImpactSolution, order: Any, across: PanelAxis, *names: str) -> Panel:
    """Return answers of one unit over the velocity; lengths in decades where the bodies yield."""
    velocity = row_of(item, "velocity").content[order]
    rows = [row_of(item, name) for name in names]
    together = np.concatenate([row.content for row in rows])
    log = len(names) > 1 and bool(np.max(rows[0].content) > 0.0)
    marks: list[Any] = []
    for place, row in enumerate(rows):
        shown = row.content[order]
        content = np.where(rows[0].content[order] > 0.0, shown, np.nan) if log else shown
        name = ("depth $d_0$", "radius $a_m$")[place] if len(rows) > 1 else ""
        marks.append(among(place, velocity, content, name))
    if float(velocity[0]) < item.yield_velocity < float(velocity[-1]):
        marks.append(Rule(item.yield_velocity, upright=True, colour=style.GREEN, dash=style.DASHES[2]))
    scale = type(rows[0])(rows[0].name, rows[0].word, together[together > 0.0] if log else together).scale
    label = "dent" if len(names) > 1 else ""
    high = 1.05 * float(np.max(rows[0].content))
    low = from_zero(rows[0].content)
    ends: dict[str, Any] = {"margin": 0.1} if low is None else {"low": low, "high": high}
    upright = PanelAxis(label, scale, log=log) if label else PanelAxis.of(rows[0], **ends)
    return Panel(tuple(marks), across, upright, legend="lower right" if len(names) > 1 else "")
