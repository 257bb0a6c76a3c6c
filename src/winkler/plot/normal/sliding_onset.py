"""The stress where a contact that slides begins to yield: a map of the plane of sliding."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.plot import style
from winkler.plot.medium import interfaces
from winkler.plot.normal.stresses import stress_map
from winkler.plot.panel import Line, Panel, Rule
from winkler.plot.series import series
from winkler.problems.normal.greatest_stress import stress_in_plane
from winkler.problems.normal.yielding import YieldOnsetSolution, part_that_yields

__all__ = ["sliding_stress_panel"]

POINTS_ACROSS, POINTS_DOWN = 113, 49
DEPTH_IN_RADII = 1.6
"""Depth of the map in contact radii."""
INTERFACE_OFFSET = 1e-6
"""Distance of a row of points from an interface, of its depth."""


def sliding_stress_panel(item: YieldOnsetSolution, pressed: PressedSprings, extent: float) -> Panel:
    """Return the von Mises stress in the plane of sliding of the body that yields, with a mark where it begins.

    Parameters
    ----------
    item : YieldOnsetSolution
        With friction.
    pressed : PressedSprings
        Its springs.
    extent : float
        Drawn up to this distance from the axis [m].
    """
    part, radius = part_that_yields(item), item.radius
    sign = 1.0 if part.first else -1.0
    x = np.linspace(-extent, extent, POINTS_ACROSS)
    z = DEPTH_IN_RADII * radius * (np.linspace(0.0, 1.0, POINTS_DOWN) ** 1.6 + 1e-3)
    borders = np.array([h for h in interfaces(pressed.bed.medium) if part.first and h < z[-1]])
    if borders.size:  # stresses jump there: one row of points on either side
        z = np.unique(np.concatenate([z, borders * (1.0 - INTERFACE_OFFSET), borders * (1.0 + INTERFACE_OFFSET)]))
    across, down = np.broadcast_arrays(x[:, None], z)
    stress = stress_in_plane(pressed, part, item.problem.friction.coefficient, across.ravel(), down.ravel())
    shown = series("von_mises", stress.reshape(across.shape))
    panel = stress_map(series("x", across), series("z", sign * down), shown, label="along the sliding $x$")
    look = {"dash": (4.0, 2.0), "order": 7.0}
    rules = [Rule(float(depth), colour=style.INK, width=0.9, **look) for depth in borders]  # type: ignore[arg-type]
    place = Line(np.array([item.x]), np.array([item.z]), "white", width=0.0, marker="+", size=9.0, clipped=False)
    edge = Line(np.array([-radius, radius]), np.zeros(2), style.RED, width=3.0, clipped=False, blunt=True, order=8.0)
    return panel.plus(*rules, place, edge)
