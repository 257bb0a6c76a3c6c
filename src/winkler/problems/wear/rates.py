r"""The rates of sliding wear as a stiff system: what wears, and how that changes with what has been worn off.

With the springs' displacement :math:`v = d - g_0 - Gf`, the mean pressures :math:`p = E^*Rv_+` of the rings and the
force :math:`F = 2E^*w\cdot v_+`, a small change of the worn depth f changes

.. math:: \mathrm dp = E^*R\,(\mathrm dd - G\,\mathrm df) , \qquad \mathrm dd = \frac{w\cdot G\,\mathrm df}{w\cdot1}

(under a force; at a depth :math:`\mathrm dd=0`), R and w counting where springs are pressed.  In cells where v passes
zero both are differences, everywhere else matrices that are known.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.laws.wear import WearLaw, worn_by
from winkler.numerics.transforms.grid_transforms import Cuts
from winkler.numerics.types import Array
from winkler.problems.wear.worn_grid import WornContact, WornGrid

__all__ = ["SlidingSystem", "law_slope"]

DIFFERENCE_STEP = 1e-6
"""Change over which differences are taken, relative to the greatest number around."""


def law_slope(law: WearLaw, pressure: Array) -> Array:
    """Return how the worn depth per slip of both bodies grows with the pressure [1/Pa]."""
    near = DIFFERENCE_STEP * float(np.max(pressure))
    if near == 0.0:
        return np.zeros(pressure.shape)
    here, there = (np.sum(worn_by(law, pressure + more), axis=0) for more in (0.0, near))
    return np.asarray((there - here) / near)


class SlidingSystem:
    """A worn contact that slides everywhere: depths worn off at the nodes [m], and their rates per distance [-].

    Parameters
    ----------
    grid : WornGrid
        The bed on a grid.
    load : Depth, Force or LineForce
    law : WearLaw
        Of the one body that wears.
    """

    def __init__(self, grid: WornGrid, load: Any, law: WearLaw) -> None:
        self.grid, self.load, self.law = grid, load, law
        transforms = grid.transforms
        self.weights: Array = transforms.areas
        self._lifted = grid.lifted
        count = grid.nodes.size
        outside = np.append(transforms.outside, np.zeros((1, count)), axis=0)
        self._pressed = -np.diff(outside, axis=0) / transforms.areas[:, None]
        # the product of both over all springs that are pressed, updated
        self._both = np.zeros((count, count))
        self._counted = np.zeros(count, dtype=bool)
        self._last: tuple[bytes, WornContact] | None = None

    def contact(self, worn: Array) -> WornContact:
        """Return the contact of a worn profile; the last one is cached."""
        key = worn.tobytes()
        if self._last is None or self._last[0] != key:
            self._last = key, self.grid.press(worn, self.load)
        return self._last[1]

    def rates(self, state: Array) -> Array:
        """Return how fast each node wears [-]."""
        return np.asarray(np.sum(worn_by(self.law, self.contact(state).pressure), axis=0))

    def slopes(self, state: Array) -> tuple[Array, Array]:
        """Return where something wears, and how those rates change with what has been worn off [1/m]."""
        contact, transforms = self.contact(state), self.grid.transforms
        stretch = contact.stretch
        cut = Cuts(transforms.squares, stretch)
        # a rim that is pressed counts by itself
        rim = [stretch.size - 1] if stretch[-1] > 0.0 else []
        beside = np.unique(np.concatenate([cut.cells, cut.cells + 1, rim])).astype(int)
        counted = stretch > 0.0
        counted[beside] = False
        for changed, sign in ((counted & ~self._counted, 1.0), (self._counted & ~counted, -1.0)):
            if changed.any():
                self._both += sign * (self._pressed[:, changed] @ self._lifted[changed])
        self._counted = counted
        pressed, borne = np.zeros((stretch.size, beside.size)), np.where(counted, transforms.force, 0.0)
        for column, node in enumerate(beside):
            pressed[:, column], borne[node] = self._difference(stretch, int(node))
        changing = contact.pressure > 0.0
        rows = -(self._both[changing] + pressed[changing] @ self._lifted[beside])
        if not self.grid.holds_depth(self.load):
            sunk = (borne @ self._lifted) / np.sum(borne)
            even = self._pressed[:, counted].sum(axis=1) + pressed.sum(axis=1)
            rows += np.outer(even[changing], sunk)
        steepness = self.grid.modulus * law_slope(self.law, contact.pressure)[changing]
        return changing, steepness[:, None] * rows

    def _difference(self, stretch: Array, node: int) -> tuple[Array, float]:
        """Return how pressures and force change with the stretch of one spring beside an edge."""
        step = DIFFERENCE_STEP * float(np.max(np.abs(stretch[max(node - 1, 0) : node + 2])))
        sides = []
        for sign in (1.0, -1.0):
            moved = stretch.copy()
            moved[node] += sign * step
            cut = Cuts(self.grid.transforms.squares, moved)
            sides.append((self.grid.transforms.borne(moved, cut), self.grid.transforms.integral(moved, cut)))
        (more, stronger), (less, weaker) = sides
        return (more - less) / (2.0 * step), (stronger - weaker) / (2.0 * step)

    def guess(self, state: Array, first: Array, length: float) -> Array:
        """Return mean rates if the bodies were rigid: a plane takes the highest parts off, as much as wears now."""
        height = self.grid.height(self.grid.nodes) + state
        order = np.argsort(height)
        order = order[np.isfinite(height[order])]
        areas, rising = self.weights[order], height[order]
        wide = np.cumsum(areas)
        taken = wide * rising - np.cumsum(areas * rising)
        amount = length * float(self.weights @ first)
        last = max(int(np.searchsorted(taken, amount)) - 1, 0)
        plane = rising[last] + (amount - taken[last]) / wide[last]
        return np.asarray(np.maximum(plane - height, 0.0) / length)
