r"""The round contact of a worn profile: depth, pressure and slip, from what has been worn off at the nodes of a grid.

Per cycle of fretting (theory after Dimaki and co-workers): the worn profile is transformed into springs, pressed and
pushed to and fro by U; of what they do the pressure p and the slip s are restored.  With :math:`v = d - g` the springs
bear

.. math:: q = c_N\,v_+ , \qquad u_t = \min(U, \mu\tfrac{E^*}{G^*}\,v_+) , \qquad
          s(r) = \frac2\pi\int_0^r \frac{U-u_t(x)}{\sqrt{r^2-x^2}}\,\mathrm dx ,

zero where everything inside sticks.  On layers, whose normal and shear kernels differ, bounds and slip are those of
`winkler.numerics.transforms.rubbed_rings`.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Normal
from winkler.media.body_of import exponent_of
from winkler.media.offers import PowerOfDepth, PressedWaves, offers
from winkler.numerics.transforms.grid_transforms import GridTransforms, inner_product
from winkler.numerics.transforms.ring_transforms import RingTransforms
from winkler.numerics.types import Array
from winkler.problems.wear.sheared_grid import ShearedGrid, sheared_grid
from winkler.problems.wear.worn_grid import WornContact, WornGrid
from winkler.values.errors import NotConverged

MOST_TRIALS = 100
FORCE_TOLERANCE = 1e-13
"""Part of a force to which it is met."""
LATE_TRIAL, LATE_TOLERANCE = 12, 1e-9
"""After so many trials a force may be met to that part, which rounding leaves."""
DEPTH_TOLERANCE = 8.0 * np.finfo(float).eps
"""Part of the greatest gap to which a depth is known."""


class RubbedContact(NamedTuple):
    """A pressed contact that is pushed to and fro.

    Parameters
    ----------
    shift : float
        Amplitude U [m].
    stick_radius : float
        c [m].
    slip : ndarray, (n,)
        Amplitude of the slip [m] at the nodes, zero outside the contact.
    """

    shift: float
    stick_radius: float
    slip: Array


def _rings(medium: object, nodes: Array, exponent: float) -> GridTransforms:
    if offers(medium, PressedWaves):
        # numerics of layers are loaded with layers
        from winkler.numerics.transforms.layered_rings import LayeredRings

        return LayeredRings(nodes, medium.response)
    return RingTransforms(nodes, exponent)


class RoundGrid(WornGrid):
    """A bed of a round contact on a grid of radii.

    Parameters
    ----------
    bed : Foundation
        Before wear, on a homogeneous, a power-law or a layered medium.
    nodes : ndarray, (n,)
        Radii [m], rising from zero; the last is the rim where the profile has one.
    """

    bed: Foundation

    def __init__(self, bed: Foundation, nodes: Array) -> None:
        medium = bed.medium
        self.k = exponent_of(medium)
        self.rings = _rings(medium, nodes, self.k)
        scale = float(medium.depth_scale**self.k) if offers(medium, PowerOfDepth) else 1.0
        super().__init__(bed, self.rings, bed.gap(nodes), float(bed.medium.modulus / scale))  # type: ignore[attr-defined]

    @functools.cached_property
    def lifted(self) -> Array:
        """As `WornGrid.lifted`: what is worn off the apex itself lowers every spring."""
        lifted = self.rings.gap.copy()
        lifted[:, 0] += 1.0
        return lifted

    def lift(self, worn: Array) -> Array:
        """As `WornGrid.lift`."""
        return np.asarray(inner_product(self.rings.gap, worn) + worn[0])

    def height(self, x: Array) -> Array:
        """Height of the profile before wear [m]."""
        return self.bed.height(x)

    def holds_depth(self, load: Normal) -> bool:
        """Return whether the depth is prescribed."""
        return isinstance(load, Depth)

    def depth_at(self, load: Normal, gap: Array) -> float:
        """Return the depth [m] under a load and a gap [m]."""
        match load:
            case Depth(number):
                return float(number)
            case _:
                return self.depth_under(float(load.force), gap)

    @functools.cached_property
    def sheared(self) -> ShearedGrid:
        """What the springs do that are pushed along the surface."""
        return sheared_grid(self)

    def sunk(self, contact: WornContact, worn: Array) -> float:
        """As `WornGrid.sunk`: the depth."""
        return contact.depth

    def depth_under(self, force: float, gap: Array) -> float:
        """Return the depth [m] at which springs under a gap [m] bear a force [N]."""
        return level_under(self.rings, self.modulus, force, gap)

    def rub(self, contact: WornContact, coefficient: float, shift: float) -> RubbedContact:
        """Return what a contact does that is pushed to and fro by a shift [m]."""
        ratio = self.sheared.ratio
        short = shift - coefficient * ratio * np.maximum(self.sheared.bounds(contact.stretch), 0.0)
        cuts = self.cuts(short)
        slip = np.where(contact.pressure > 0.0, self.sheared.slip(short, cuts), 0.0)
        core_edge = 0.0 if short[0] > 0.0 else math.inf
        stick = min([contact.radius, core_edge, *(math.sqrt(cut.place) for cut in cuts if not cut.falls)])
        return RubbedContact(shift, stick, np.maximum(slip, 0.0))

    def shear_force(self, contact: WornContact, coefficient: float, shift: float) -> float:
        """Return the amplitude F_x [N] of a shift [m]."""
        # what slides bears the whole friction, less what its core has in excess of the shift
        ratio = self.sheared.ratio
        excess = coefficient * ratio * np.maximum(self.sheared.bounds(contact.stretch), 0.0) - shift
        core = 2.0 * self.modulus / ratio * self.sheared.rings.integral(excess, self.cuts(excess))
        return coefficient * contact.force - core

    def shift_under(self, contact: WornContact, coefficient: float, shear_force: float) -> float:
        """Return the shift [m] of a shear force [N] (Ciavarella, Jaeger); at sliding the one from which all slides."""
        core, bounds = contact.force - shear_force / coefficient, self.sheared.bounds(contact.stretch)
        if core <= 0.0:
            moved = float(np.max(bounds, initial=0.0))
        else:
            moved = -level_under(self.sheared.rings, self.modulus, core, -bounds)
        return coefficient * self.sheared.ratio * moved


def level_under(rings: GridTransforms, modulus: float, force: float, gap: Array) -> float:
    """Return the depth [m] at which springs of these transforms under a gap [m] bear a force [N]."""
    # the force at the depths of the nodes, as if g never fell, gives the start
    climbing, loads, wanted = np.maximum.accumulate(gap), np.zeros(gap.size), force / (2.0 * modulus)
    (rings.springs_between * (climbing[1:] - climbing[:-1])).cumsum(out=loads[1:])
    cell = int(loads.searchsorted(wanted)) - 1
    depth, lacking, springs = float(climbing[cell]), wanted - float(loads[cell]), float(rings.springs_at_nodes[cell])
    if cell + 1 < gap.size:
        rise = float(climbing[cell + 1]) - depth
        bend = (float(rings.springs_between[cell]) - springs) * lacking * rise
        depth += 2.0 * lacking * rise / (springs * rise + math.sqrt((springs * rise) ** 2 + 4.0 * bend))
    else:
        depth += lacking / springs
    low, high, highest = float(gap.min()), math.inf, float(climbing[-1])
    reach = max(highest, -low)
    for trial in range(MOST_TRIALS):
        borne, wide = rings.pressed(depth - gap)
        error = borne - wanted
        # where much is worn off, depth and gap are great against the stretch: rounding leaves less of it
        if abs(error) <= FORCE_TOLERANCE * wanted or (trial > LATE_TRIAL and abs(error) <= LATE_TOLERANCE * wanted):
            return depth
        low, high = (max(low, depth), high) if error < 0.0 else (low, min(high, depth))
        following = depth - error / wide if wide > 0.0 else highest
        # stiff layers part and touch again from depth to depth: halving is slow, but settles
        if trial > LATE_TRIAL and high < math.inf:
            following = 0.5 * (low + high)
        if abs(following - depth) <= DEPTH_TOLERANCE * reach:
            return following
        depth = following
    raise NotConverged(f"The worn contact finds no depth at which it carries {force:.6g} N; give more cells (count).")
