r"""The state of equilibrium of attracted surfaces next to a given one: a minimum of the energy on a grid.

.. math:: E(u) = \tfrac12\sum u\,Ku + \beta\sum\varphi(g), \qquad g = h - d + u \ge g_0 ,

with K of `ElasticSurface`; lengths across are in ranges of the law, and :math:`\beta = w\,\Delta x/(E^*r^2)`.  The
minimum is found by Newton's method in a trust region: pixels on the wall that press stay there, all others move
(`winkler.numerics.attracted.region_step`).  No step is taken that raises the energy, so that a surface which has lost
its hold runs down to the next minimum.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.attracted.attraction import Attraction
from winkler.numerics.attracted.elastic_surface import ElasticSurface
from winkler.numerics.attracted.region_step import region_step
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

__all__ = ["AttractedSurface", "Rest"]

MOST_STEPS = 1000
"""Newton steps; five are usual, a hundred in a jump."""
LARGEST_FORCING = 0.1
"""To what part of the residual a step is solved at first; later to the root of what is left."""
ACCEPTED, POOR, GOOD = 1e-4, 0.25, 0.7
"""Gain over the expected one above which a step is taken, below which the region shrinks, above which it grows."""
SNAP = 1e-9
"""Gap over the wall, in ranges, that counts as none: pixels beside the wall would block steps."""
ROUNDING = 1e-13
"""Part of the energies that are summed up to which a change of the energy is rounding."""
FRESH_STEPS = 20
"""After how many steps tractions are made anew, so that their rounding does not add up."""
MOST_LEVELLING = 60
"""Steps to find the mean of a periodic map; five are usual."""
PRESSED_GAP_RATIO = 0.8
"""Surfaces are not begun closer than this part of the gap at which they touch."""


class Rest(NamedTuple):
    """A surface at rest.

    Parameters
    ----------
    displacement
        u on the torus, in ranges.
    traction
        p on the map, in E* range / pixel; compression positive.
    gap
        g on the map, in ranges.
    energy
        E.
    residual
        Greatest traction out of balance over the greatest traction.
    steps
        Newton steps.
    """

    displacement: Array
    traction: Array
    gap: Array
    energy: float
    residual: float
    steps: int


class HeldPixels(NamedTuple):
    """Tractions out of balance on the torus, which pixels of the torus are free, and the mean traction."""

    wrong: Array
    free: Array
    mean: float


class AttractedSurface(NamedTuple):
    """Heights over a half-space that attract each other.

    Parameters
    ----------
    surface
        The half-space.
    heights
        h of the map, in ranges.
    law
        The attraction.
    share
        beta.
    """

    surface: ElasticSurface
    heights: Array
    law: Attraction
    share: float

    def apart(self, depth: float) -> Array:
        """Return displacements of bodies that have not been attracted yet."""
        return self._allowed(np.zeros(self.surface.torus), self._lowest(depth, PRESSED_GAP_RATIO * self.law.touch))

    def moved(self, rest: Rest, deeper: float, depth: float) -> Array:
        """Return displacements to begin with at another depth: what touched stays in touch."""
        u = rest.displacement.copy()
        u[self.surface.area] += np.where(rest.gap <= self.law.touch, deeper, 0.0)
        return self._allowed(u, self._lowest(depth, PRESSED_GAP_RATIO * self.law.touch))

    def _lowest(self, depth: float, gap: float = -math.inf) -> Array:
        return np.asarray(depth - self.heights + max(gap, self.law.least))

    def _allowed(self, u: Array, lowest: Array) -> Array:
        """Return displacements that leave gaps, with a mean of zero where the map is periodic."""
        here = u[self.surface.area]
        if self.surface.periodic:
            high, small = here - lowest, 1e-15 * (1.0 + float(np.max(np.abs(here))))
            shift = 0.0
            for _ in range(MOST_LEVELLING):  # the mean of max(u - shift, lowest) is piecewise straight in the shift
                free = high > shift
                mean, count = float(np.mean(np.where(free, here - shift, lowest))), int(np.count_nonzero(free))
                if abs(mean) <= small or not count:
                    break
                shift += mean * here.size / count
            here = here - shift
        walled = here - lowest < SNAP
        here = np.where(walled, lowest, here)
        if self.surface.periodic and not walled.all():  # what snapping has moved, the others bear
            here = np.where(walled, here, here - float(np.sum(here)) / np.count_nonzero(~walled))
        u[self.surface.area] = here
        return u

    def _hold(self, traction: Array, pull: Array, gap: Array) -> HeldPixels:
        """Return what is out of balance, and what the wall does not hold."""
        wrong, area = traction.copy(), self.surface.area
        wrong[area] += self.share * pull
        here, wall = wrong[area], gap <= self.law.least
        mean, held = 0.0, wall & (wrong[area] > 0.0)
        if self.surface.periodic:  # waves know nothing of the mean traction: free pixels tell it
            for _ in range(MOST_LEVELLING):
                mean = float(np.min(here)) if held.all() else float(np.mean(here, where=~held))
                again = wall & (here > mean)
                if np.array_equal(again, held):
                    break
                held = again
            here -= mean
        free = np.ones(wrong.shape, dtype=bool)
        free[area] = ~held
        wrong[~free] = 0.0
        return HeldPixels(wrong, free, -mean)

    def at_rest(self, depth: float, start: Array, tolerance: float) -> Rest:
        """Return the surface at rest, next to where it starts.

        Parameters
        ----------
        depth
            d, in ranges.
        start
            u on the torus, allowed at this depth.
        tolerance
            Bound on `Rest.residual`.

        Raises
        ------
        NotConverged
            If none is found.
        """
        area, law, share, lowest = self.surface.area, self.law, self.share, self._lowest(depth)
        u, traction = start, self.surface.tractions(start)
        gap = np.maximum(u[area] - lowest, 0.0) + law.least
        potential, pull, stiffness = law.terms(gap)
        radius, left, most = math.inf, math.inf, 0.0
        for count in range(MOST_STEPS):
            hold = self._hold(traction, pull, gap)
            most = max(share * law.peak, float(np.max(np.abs(traction[area] + hold.mean))))
            left = float(np.max(np.abs(hold.wrong))) / most
            if left <= tolerance or not hold.free.any():
                energy = 0.5 * float(np.sum(u * traction)) + share * float(np.sum(potential))
                return Rest(u, traction[area] + hold.mean, gap, energy, left, count)
            aim = min(LARGEST_FORCING, math.sqrt(left))
            while True:
                step = region_step(self.surface, hold.wrong, hold.free, share * stiffness, radius, aim)
                moved = self._allowed(u + step.change, lowest)
                change = moved - u
                more = self.surface.tractions(change)
                new_gap = np.maximum(moved[area] - lowest, 0.0) + law.least
                terms = law.terms(new_gap)
                slope, bent = traction * change, float(np.sum(change * more))
                slope[area] += share * (terms[0] - potential)
                gain, length = -float(np.sum(slope)) - 0.5 * bent, math.sqrt(max(bent, 0.0))
                noise = ROUNDING * float(np.sum(np.abs(slope)))
                if gain >= ACCEPTED * step.gain - noise:
                    break
                radius = 0.25 * min(length, radius)
                if radius <= 1e-15 * math.sqrt(float(np.sum(u * traction)) + share):
                    raise NotConverged(_sentence(left, count, tolerance))
            if gain > GOOD * step.gain and step.at_edge:
                radius *= 2.0
            elif gain < POOR * step.gain and step.gain > noise:
                radius = min(radius, length)
            u, traction, gap = moved, traction + more, new_gap
            potential, pull, stiffness = terms
            if count % FRESH_STEPS == FRESH_STEPS - 1:
                traction = self.surface.tractions(u)
        raise NotConverged(_sentence(left, MOST_STEPS, tolerance))


def _sentence(left: float, count: int, tolerance: float) -> str:
    return (
        f"tractions are out of balance by {left:.3g} of the greatest after {count} steps, allowed are {tolerance:.3g}; "
        "allow a larger tolerance, or give a law of longer range."
    )
