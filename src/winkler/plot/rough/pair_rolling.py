"""Sheets of two profiles that roll: the bodies, and stick and slip with the traction on their patches."""

from __future__ import annotations

import dataclasses
import math

from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Panel, Sheet
from winkler.plot.rough.profile_pair import bodies_panel
from winkler.plot.rough.shear import traction_maps
from winkler.plot.series import with_unit
from winkler.problems.profile_pair.pair_rolling import ProfilePairRollingSolution
from winkler.problems.profile_pair.rolled_patch import RolledPatch

MOST_PATCHES = 2
"""Patches whose tractions are drawn."""


@without_extent(ProfilePairRollingSolution)
def pair_rolling_sheet(item: ProfilePairRollingSolution) -> Sheet:
    """Return both profiles with their patches, and stick and slip with the traction where they bear most."""
    patches = tuple(each.patch for each in item.patches)
    panels = [bodies_panel(item.problem.pair, item.height, patches).plus(title="profiles and contact")]
    for each in item.patches[:MOST_PATCHES]:
        zones, traction = _maps(each)
        force = f"{with_unit(each.patch.force, 'N', 3)} at {math.degrees(each.patch.angle):.3g}°"
        panels += [zones.plus(title=f"stick (green) and slip; {force}"), traction.plus(title="traction")]
    lost = with_unit(item.loss_per_distance, "J/m")
    title = f"force along the track {with_unit(item.x_force, 'N')};  dissipated {lost}"
    return Sheet(tuple(panels), 3, width=4.4, height=3.2, title=title)


def _maps(each: RolledPatch) -> tuple[Panel, ...]:
    load = each.surface_load
    maps = traction_maps(load.pixel, each, (float(load.corner[0]), float(load.corner[1])))
    x, y = (("along $x$", "across"), ("along the arc $s$", "upright"))
    return tuple(
        dataclasses.replace(
            one, **{axis: dataclasses.replace(getattr(one, axis), label=label) for label, axis in (x, y)}
        )
        for one in maps
    )
