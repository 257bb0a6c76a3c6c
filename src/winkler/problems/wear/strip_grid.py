r"""The line contact of a worn profile: pressure and slip, from what has been worn off at the nodes of a grid.

The load per length :math:`P = E^*\,w(a)` stands for the depth: with :math:`v = P/E^* - w` half-planes press with

.. math:: p(x) = -\frac{E^*}\pi\int_{|x|}^a\frac{v'(c)}{\sqrt{c^2-x^2}}\,\mathrm dc .

Under a shear force per length that swings by Q to each side, what sticks is the contact that the load
:math:`\gamma = P - Q/\mu` would have, and the surfaces slip by :math:`\mu` times the distance that this one leaves open
beside it (Ciavarella, Jaeger), for the worn profile too:

.. math:: s(x) = \frac{E^*}{m_L}\,\frac{2x}\pi\int_0^x\frac{(Q/E^* - \mu v(c))_+}{c\,\sqrt{x^2-c^2}}\,\mathrm dc .

On layers a growing contact adds their own flat punches to v, and a shear force those of their response to shear
(`winkler.numerics.transforms.strips.strip_punches`); bounds and slip are those of
`winkler.numerics.transforms.rubbed_rings`.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.loading.loads import LineForce
from winkler.numerics.types import Array
from winkler.problems.wear.sheared_grid import ShearedGrid, sheared_strips
from winkler.problems.wear.worn_grid import WornContact, WornGrid


class RubbedStrip(NamedTuple):
    """A pressed line contact that is sheared to and fro.

    Parameters
    ----------
    stick_half_width : float
        c [m].
    slip : ndarray, (n,)
        Amplitude of the slip [m] at the nodes, zero outside the contact.
    """

    stick_half_width: float
    slip: Array


class StripGrid(WornGrid):
    """A bed of a line contact on a grid of distances from its middle.

    Parameters
    ----------
    bed : LineBed
        Before wear.
    nodes : ndarray, (n,)
        Distances [m], rising from zero; the last is the rim where the profile has one.
    """

    bed: LineBed

    def __init__(self, bed: LineBed, nodes: Array) -> None:
        super().__init__(bed, bed.grid_transforms(nodes), bed.load_profile(nodes), float(bed.medium.modulus))

    def height(self, x: Array) -> Array:
        """Height of the profile before wear [m]."""
        return self.bed.profile.height(x)

    def holds_depth(self, load: LineForce) -> bool:
        """Return True: the force per length stands for the depth."""
        return True

    def depth_at(self, load: LineForce, gap: Array) -> float:
        """Return P/E* [m]."""
        return float(load.force_per_length) / self.modulus

    def sunk(self, contact: WornContact, worn: Array) -> float:
        """As `WornGrid.sunk`: what the load stands for, and what was worn off."""
        return contact.depth + float(np.max(worn.sum(axis=0)))

    @functools.cached_property
    def sheared(self) -> ShearedGrid:
        """What the springs do that are pushed along the surface."""
        return sheared_strips(self)

    def rub(self, contact: WornContact, coefficient: float, shear_force: float) -> RubbedStrip:
        """Return what a contact does that is sheared to and fro by a force per length [N/m], less than slides it."""
        short = shear_force / self.modulus - coefficient * np.maximum(self.sheared.bounds(contact.stretch), 0.0)
        cuts = self.cuts(short)
        slip = self.sheared.ratio * np.where(contact.pressure > 0.0, self.sheared.slip(short, cuts), 0.0)
        core_edge = 0.0 if short[0] > 0.0 else math.inf
        stick = min([contact.radius, core_edge, *(math.sqrt(cut.place) for cut in cuts if not cut.falls)])
        return RubbedStrip(stick, np.maximum(slip, 0.0))
