r"""The state of equilibrium of attracted surfaces next to a given one: a minimum of the energy on a grid.

.. math:: E(u) = \tfrac12\sum u\,Ku + \beta\sum\varphi(g), \qquad g = h - d + u \ge g_0 ,

with K of `ElasticSurface`; lengths across are in ranges of the law, and :math:`\beta = w\,\Delta x/(E^*r^2)`.  The
minimum is found by Newton's method in a trust region: pixels on the wall that press stay there, all others move.
No step is taken that raises the energy, so that a surface which has lost its hold runs down to the next minimum.

One step of Newton's method on a surface, inside a trust region (Steihaug).

:math:`(K + D)s = -r` on the pixels that are free, with the stiffness K of the surface and D of the law, by conjugate
gradients in single digits.  The preconditioner is the compliance of the surface; where the law is stiff that of the
surface on springs.  Lengths are those of the elastic energy, :math:`s K s`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.attracted.attraction import Attraction
from winkler.numerics.attracted.elastic_surface import ElasticSurface
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

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


MOST_ITERATIONS = 120
"""Conjugate gradients in one step; ten are usual."""
STIFF = 4.0
"""Pixels whose law is stiffer than the longest wave of the map by this factor are preconditioned as on springs."""
FLATTEST = 1e-6
"""Curvature of the energy over the elastic one below which a direction counts as one of negative curvature."""


class RegionStep(NamedTuple):
    """A step.

    Parameters
    ----------
    change
        Of the displacements on the torus.
    gain
        By how much the energy of second order falls.
    at_edge
        Whether the step ends at the edge of the region.
    """

    change: Array
    gain: float
    at_edge: bool


class FreeMoves:
    """The surface as conjugate gradients see it: moves of the free pixels, without a mean if it is periodic."""

    def __init__(self, surface: ElasticSurface, free: Array, stiffness: Array):
        self.surface, self.kept = surface, free.astype(np.float32)
        self.count = float(np.count_nonzero(free))
        self.bend = stiffness.astype(np.float32)
        stiff = self.bend > np.float32(STIFF * 2.0 * math.pi / max(surface.shape))
        self.pressed = np.zeros_like(self.kept)
        self.pressed[surface.area] = stiff & free[surface.area]
        self.some = bool(np.any(self.pressed))
        self.bedded = surface.bedded(float(np.median(self.bend[stiff]))) if self.some else surface.single_compliance

    def projected(self, numbers: Array) -> Array:
        """Return what free pixels may do of it."""
        numbers *= self.kept
        if self.surface.periodic:
            numbers -= self.kept * np.float32(float(np.sum(numbers, dtype=np.float64)) / self.count)
        return numbers

    def softened(self, force: Array) -> Array:
        """Return roughly the displacements under tractions."""
        if not self.some:
            return self.projected(self.surface.displaced(force))
        rest = np.float32(1.0) - self.pressed
        apart = self.surface.displaced(force * rest) * rest
        return self.projected(apart + self.surface.applied(self.bedded, force * self.pressed) * self.pressed)

    def bent(self, held: Array, along: Array) -> Array:
        """Return (K + D) d, from K d."""
        both = held.copy()
        both[self.surface.area] += self.bend * along[self.surface.area]
        return both


def region_step(
    surface: ElasticSurface, wrong: Array, free: Array, stiffness: Array, radius: float, aim: float
) -> RegionStep:
    """Return a step.

    Parameters
    ----------
    surface
        The surface.
    wrong
        r, tractions out of balance on the torus; zero where pixels are held.
    free
        Which pixels of the torus may move.
    stiffness
        D on the map.
    radius
        Of the region.
    aim
        To what part of the residual the equations are solved.
    """
    reduced = FreeMoves(surface, free, stiffness)
    size = float(np.max(np.abs(wrong)))  # in single digits squares of small numbers would vanish
    r = reduced.projected((-wrong / size).astype(np.float32))
    s, ks = np.zeros_like(r), np.zeros_like(r)
    along = reduced.softened(r)
    product = first = _dot(r, along)
    reach, gain, at_edge = radius / size, 0.0, False
    for _ in range(MOST_ITERATIONS):
        held = surface.tractions(along)
        curved = reduced.bent(held, along)
        curvature, length, across = _dot(along, curved), _dot(along, held), _dot(s, held)
        inner = _dot(s, ks)
        negative = curvature <= FLATTEST * length
        far = 0.0 if negative else product / curvature
        if negative or inner + 2.0 * far * across + far * far * length >= reach * reach:
            far = _to_edge(inner, across, length, reach)
            s += np.float32(far) * along
            gain += far * _dot(r, along) - 0.5 * far * far * curvature
            at_edge = True
            break
        s += np.float32(far) * along
        ks += np.float32(far) * held
        gain += 0.5 * far * product
        r -= np.float32(far) * reduced.projected(curved)
        softened = reduced.softened(r)
        new = _dot(r, softened)
        if new <= aim * aim * first:
            break
        along = softened + np.float32(new / product) * along
        product = new
    return RegionStep(size * s.astype(np.float64), size * size * gain, at_edge)


def _dot(one: Array, other: Array) -> float:
    return float(np.vdot(one, other))


def _to_edge(inner: float, across: float, length: float, reach: float) -> float:
    """Return t with |s + t d| = reach; one where nothing bounds it."""
    if not math.isfinite(reach):
        return 1.0
    return (math.sqrt(max(across * across + length * (reach * reach - inner), 0.0)) - across) / length
