"""The stress where a contact begins to yield that slides, or lies on layers: a map of the plane of sliding."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.materials.elastic import TransverselyIsotropic
from winkler.media.medium import Medium
from winkler.media.offers import LayerStack, offers
from winkler.plot import style
from winkler.plot.normal.stresses import depths_through, faces_above, stress_map
from winkler.plot.panel import Line, Panel, Rule
from winkler.plot.series import series
from winkler.problems.normal.greatest_stress import stress_in_plane
from winkler.problems.normal.yielding import YieldOnsetSolution, part_that_yields

POINTS_ACROSS, POINTS_DOWN = 113, 49
DEPTH_IN_RADII = 1.6
"""Depth of the map in contact radii."""
BEYOND = 1.25
"""Depth and half of the width of the map, at least, over how far the place lies where yielding begins."""


def sliding_stress_panel(item: YieldOnsetSolution, pressed: PressedSprings, extent: float) -> Panel:
    """Return the von Mises stress in the plane of sliding of the body that yields, with a mark where it begins.

    Parameters
    ----------
    item : YieldOnsetSolution
        With friction, or on layers.
    pressed : PressedSprings
        Its springs.
    extent : float
        Drawn up to this distance from the axis [m], or farther if it yields farther away.
    """
    medium, friction = pressed.bed.medium, item.problem.friction.coefficient
    part, radius = part_that_yields(item), item.radius
    sign = 1.0 if part.first else -1.0
    x = max(extent, BEYOND * math.hypot(item.x, item.z)) * np.linspace(-1.0, 1.0, POINTS_ACROSS)
    z = max(DEPTH_IN_RADII * radius, BEYOND * abs(item.z)) * (np.linspace(0.0, 1.0, POINTS_DOWN) ** 1.6 + 1e-3)
    faces = faces_above(medium, z[-1]) if part.first else ()
    z = depths_through(z, faces)
    if part.first:
        z = z[z > _unknown_above(medium)]
    across, down = np.broadcast_arrays(x[:, None], z)
    stress = stress_in_plane(pressed, part, friction, across.ravel(), down.ravel())
    shown = series("von_mises", stress.reshape(across.shape))
    label = "along the sliding $x$" if friction > 0.0 else ""
    panel = stress_map(series("x", across), series("z", sign * down), shown, label, faces)
    look = {"dash": (4.0, 2.0), "order": 7.0}
    rules = [Rule(depth, colour=style.INK, width=0.9, **look) for depth in faces]  # type: ignore[arg-type]
    place = Line(np.array([item.x]), np.array([item.z]), "white", width=0.0, marker="+", size=9.0, clipped=False)
    edge = Line(np.array([-radius, radius]), np.zeros(2), style.RED, width=3.0, clipped=False, blunt=True, order=8.0)
    return panel.plus(*rules, place, edge)


def _unknown_above(medium: Medium) -> float:
    """Return the depth down to which stresses are not known [m]: in a transversely isotropic uppermost layer."""
    if offers(medium, LayerStack) and isinstance(medium.layers[0].solid, TransverselyIsotropic):
        return float(medium.layers[0].thickness)
    return 0.0
