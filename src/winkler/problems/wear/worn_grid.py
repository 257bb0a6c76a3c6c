"""A bed on a grid: the contact of a worn profile, from what has been worn off at the nodes.

Only what was worn off is held on the grid: the shape itself keeps its own transform.  Where the worn springs would be
pulled they are free; pressures are means about the nodes (`winkler.numerics.transforms.grid_transforms`).
"""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.transforms.grid_transforms import (
    CutCell,
    GridTransforms,
    SurfaceTransform,
    cuts_of,
    inner_product,
)
from winkler.numerics.types import Array


class WornContact(NamedTuple):
    """A pressed contact on the grid.

    Parameters
    ----------
    depth, force, radius : float
        d [m], F_N [N], a [m]; of a line contact P/E* [m], P [N/m], a [m].
    stretch : ndarray, (n,)
        d - g(x), or P/E* - w(x) [m] at the nodes, also where it is negative.
    pressure : ndarray, (n,)
        p [Pa] at the nodes.
    worn_depth : float
        Greatest worn depth, of both bodies together [m].
    """

    depth: float
    force: float
    radius: float
    stretch: Array
    pressure: Array
    worn_depth: float


class WornGrid:
    """A bed on a grid.

    Parameters
    ----------
    bed : Foundation or LineFoundation
        Before wear.
    transforms : RingTransforms or StripTransforms
        Between the nodes.
    gap : ndarray, (n,)
        g, or w, before wear [m].
    modulus : float
        What pressures over stretches are counted in.
    """

    def __init__(self, bed: Any, transforms: GridTransforms, gap: Array, modulus: float) -> None:
        self.bed, self.transforms, self.gap, self.modulus = bed, transforms, gap, modulus
        self.nodes = transforms.nodes

    @functools.cached_property
    def lifted(self) -> Array:
        """How much higher each spring begins for what is worn off at each node ``(n, n)``."""
        return self.transforms.gap

    @functools.cached_property
    def surface(self) -> SurfaceTransform:
        """What restores the displacement of the surface."""
        return SurfaceTransform(self.transforms)

    @functools.cached_property
    def response(self) -> Array:
        """Bound on the change of pressure at each node by worn depths of one metre, of any sign [Pa/m], ``(n,)``."""
        both = np.diff(self.transforms.outside @ self.transforms.gap, axis=0, append=0.0)
        return np.asarray(self.modulus * np.sum(np.abs(both / self.transforms.areas[:, None]), axis=1))

    def lift(self, worn: Array) -> Array:
        """Return how much higher the springs begin for what is worn off [m]."""
        return inner_product(self.transforms.gap, worn)

    def height(self, x: Array) -> Array:
        """Height of the profile before wear [m]."""
        raise NotImplementedError

    def holds_depth(self, load: Any) -> bool:
        """Return whether the depth, or what stands for it, stays while the contact wears."""
        raise NotImplementedError

    def depth_at(self, load: Any, gap: Array) -> float:
        """Return the depth [m], or what stands for it, under a load and a gap [m]."""
        raise NotImplementedError

    def sunk(self, contact: WornContact, worn: Array) -> float:
        """Return how far the bodies have come together [m], wear included.

        Parameters
        ----------
        worn : ndarray, (2, n)
            What both bodies have lost [m].
        """
        raise NotImplementedError

    def cuts(self, values: Array) -> list[CutCell]:
        """Return where values at the nodes pass zero."""
        return cuts_of(self.transforms.squares, values)

    def press(self, worn: Array, load: Any) -> WornContact:
        """Return the contact of the profile less what was worn off, under a load.

        Parameters
        ----------
        worn : ndarray, (n,)
            Worn depth [m] at the nodes, of both bodies together.
        load : Depth, Force or LineForce
            One number.
        """
        gap = self.gap + self.lift(worn)
        depth = self.depth_at(load, gap)
        stretch = depth - gap
        cuts = self.cuts(stretch)
        pressure = self.modulus * self.transforms.borne(stretch, cuts)
        force = float(self.transforms.areas @ pressure)
        edge = max((cut.place for cut in cuts if cut.falls), default=0.0)
        radius = float(self.nodes[-1]) if stretch[-1] > 0.0 else math.sqrt(edge)
        # nothing pulls: what is left of tension between two nodes that touch is no pressure
        return WornContact(depth, force, radius, stretch, np.maximum(pressure, 0.0), float(worn.max()))

    def touching(self, contact: WornContact, worn: Array, slack: float) -> float:
        """Return up to which distance from the middle the surfaces touch [m].

        Where wear has taken all pressure off a part of the contact they touch still: a jump that wears off too much
        there by less than a slack [m] does not part them.
        """
        (grazed,) = np.nonzero((worn > 0.0) & (contact.stretch > -slack))
        return max(contact.radius, float(self.nodes[grazed[-1]]) if grazed.size else 0.0)
