r"""The cells of a relaxing contact that are dragged along its surface or around its axis, and what each bears at most.

Springs of homogeneous bodies are dragged where they are pressed, and bear :math:`\mu q_z`.  Under a twist, and on
layers under a push, cells have other weights :math:`e^2`, and each bears what all rings farther out press: with the
elastic bound B(x; t) of a contact of radius t (`winkler.foundation.torsion_bound`), at any time

.. math:: b(x) = -\mu\int_x^a \frac{\mathrm dB}{\mathrm dg}(x;t)\,\frac{\partial q_z}{\partial t}\,\mathrm dt ,

since the pressure is a sum of those of flat punches whatever the history, and all parts relax alike.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.springs import Springs
from winkler.foundation.torsion_bound import TwistBound
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.panels.kink_panels import Indices
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import affordable
from winkler.values.limits import MOST_NUMBERS


class DragCells(NamedTuple):
    """Cells that are dragged.

    Parameters
    ----------
    owner, load, unit, motion
        Words of messages: kind of problem, what drags, its unit, and the load that prescribes the motion.
    place
        x [m] ``(m,)``.
    weights
        What the load of each counts in the whole ``(m,)``: [m], of a twist [m^3].
    under
        Number of the pressed spring with which each touches ``(m,)``.
    density, lever
        Line loads over loads, across the surface and along it ``(m,)``.
    shares
        What each bears over mu, by the loads of the springs ``(m, n)``; that of its own spring without it.
    """

    owner: str
    load: str
    unit: str
    motion: str
    place: Array
    weights: Array
    under: Indices
    density: Array
    lever: Array
    shares: Array | None = None

    def bounds(self, loads: Array) -> Array:
        """Return what each bears over mu, from the loads of the springs ``(n,)``."""
        return loads[self.under] if self.shares is None else self.shares @ loads


def spring_cells(bed: Bed, springs: Springs) -> DragCells:
    """Return springs that are dragged where they are pressed; their stiffnesses have one ratio."""
    every, density = np.arange(springs.gap.size), springs.density(bed)
    weights = np.array(springs.stiffness)
    return DragCells("Tangential", "shear force", "N", "Shift", springs.position, weights, every, density, density)


def ring_cells(bound: TwistBound, springs: Springs, count: int) -> DragCells:
    """Return cells whose bounds are those of rings, under a twist or on layers.

    Parameters
    ----------
    bound : TwistBound
        Of the elastic bed, by depth, with a coefficient of 1.
    springs : Springs
        Those that are pressed.
    count : int
        How many cells about.
    """
    bed, panels, places = bound.bed, bound.panels, springs.position
    affordable(bound.owner, "pairs of springs", count * places.size, MOST_NUMBERS)
    # one pressed spring stands for a flat end, below which cells do not slide all at once
    inside = np.linspace(0.0, places[0], int(np.ceil(count * places[0] / places[-1])), endpoint=False)
    place = np.concatenate([inside, places])
    under = np.maximum(np.arange(place.size) - inside.size, 0)
    moments = (bound.weight, bound.weight * panels.nodes)
    area, first = (2.0 * panels.integral(moment, place) for moment in moments)
    chords = np.diff(place * area - first) / np.diff(place)
    weights = np.diff(np.concatenate([[0.0], chords, area[-1:]]))
    off_axis = np.maximum(place, 0.25 * place[1])
    lever = off_axis if isinstance(bed.medium, HomogeneousMedium) else np.sqrt(panels.value(bound.weight, off_axis))

    def over(radii: Array, excess: float) -> Array:
        rows = bound.over(radii, np.full(radii.size, excess)).reshape(radii.size, *panels.nodes.shape)
        found = np.array([panels.value(row, off_axis) for row in rows])
        return np.where(off_axis < radii[:, None] * (1.0 + 1e-12), found, 0.0)

    elastic = over(places, 0.0)
    rising = np.diff(elastic, axis=0) / np.diff(springs.gap)[:, None]
    rings = np.concatenate([rising, over(places[-1:], 1.0) - elastic[-1:]])
    shares = np.diff(rings, axis=0, prepend=0.0).T
    words = bound.owner, bound.load, bound.unit, bound.motion.capitalize()
    return DragCells(*words, place, weights, under, bed.normal_stiffness(off_axis), lever, shares)
