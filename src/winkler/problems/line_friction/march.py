r"""A sheared line contact step by step on boundary elements: histories of both forces and of a bulk stress.

The second body is ahead of the first by

.. math:: s(x) = \delta - \varepsilon x - u(x) , \qquad
          u(x) = -\frac2{\pi E^*}\int q(\xi)\,\ln|x-\xi|\,\mathrm d\xi , \qquad
          \varepsilon = \frac{1-\nu_1^2}{E_1}\sigma_B

(on layers with the kernel of their response to shear, `LineBed.shear_compliance`), which stays as it is where the
surfaces stick, and changes in the direction of q where they slip under :math:`|q|=\mu p`.  Each step finds the zones
in which that holds at its end, and the shift :math:`\delta` at which the tractions add up to Q.  On similar bodies the
pressure does not depend on the traction.  An element that comes into contact brings along how far it was ahead when
the edge of the contact reached its middle: while the normal force changes, a step ends where the edge of the contact
is that of an element.

Where stick meets slip, in the midst of an element, the traction departs from its bound by the root of the distance: the
error of the loss, about 1e-4, falls by the power 7/4 of the width of the elements only.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.line_bed import LineBed
from winkler.numerics.surfaces.strip_grid import StuckStrip, strip_step
from winkler.numerics.types import Array
from winkler.problems.line.half_width import under_force
from winkler.problems.line_friction.elements import elements_for, pressed_elements
from winkler.problems.line_friction.path import LinePath

__all__ = ["LineMarch", "MarchedRow"]

STEPS, STEPS_BESIDE = 24, 72
"""Steps over a change of the shear force by what friction bears at most, and of the bulk stress in proportion; while
the normal force changes the pressure on what slips does so, too, and steps are shorter."""
MOST_STEPS = 1000.0
"""Between two points of the path, besides those at which the contact widens or narrows by an element."""
ROUNDING = 1e-12
LEAST_STUCK, SLIDING_SHARE, LEAST_WIDTH = 0.01, 0.999, 0.2
"""A bulk stress is refused that leaves less of the contact sticking, below this part of the shear force of sliding,
while the contact is wider than this part of the widest."""


class MarchedRow(NamedTuple):
    """The elements that touch, at one point of the path.

    Parameters
    ----------
    x, widths
        Middles and widths of the elements ``(m,)`` [m].
    bound, traction
        Mu times the mean pressure, and q [Pa].
    slips
        To which side each element slips: 1, -1, or 0 if it sticks.
    ahead
        How far the second body is ahead [m].
    rubbed
        What friction has lost since the beginning, per area [J/m^2].
    slip_shift, lost
        As in `LineTangentialSolution` [m], [J/m].
    """

    x: Array
    widths: Array
    bound: Array
    traction: Array
    slips: Array
    ahead: Array
    rubbed: Array
    slip_shift: float
    lost: float


class LineMarch:
    """A march along a path; lengths over the greatest half-width A, tractions over E*, forces over E* A."""

    def __init__(self, bed: LineBed, friction: float, path: LinePath) -> None:
        self.bed, self.friction = bed, friction
        modulus = bed.medium.modulus
        self.widths = under_force(bed, path.across / modulus)
        self.elements = elements_for(bed, self.widths)
        per_force = 1.0 / (modulus * self.elements.scale)
        strains = bed.strain_per_stress * path.bulk
        self.points = np.stack([path.across * per_force, path.along * per_force, strains], axis=1)
        self.most = friction * float(np.max(self.points[:, 0]))
        self.bulk = path.bulk
        self.grid = StuckStrip(self.elements.compliance, self.elements.widths)
        self.traction, self.bound, self.ahead, self.slips, self.rubbed = np.zeros((5, self.elements.x.size))
        self.shift = self.lost = 0.0
        self.half_width = self.force = 0.0
        self.step, self.half_width_before = np.zeros(self.elements.x.size), 0.0

    def rows(self) -> Iterator[MarchedRow]:
        """Yield the elements that touch at every point of the path, none if the bodies are apart."""
        first = self.points[0] * np.array([1.0, 0.0, 0.0])
        pieces = [self._piece(before, after) for before, after in pairwise([first, *self.points])]
        forces = np.unique(np.concatenate([[first[0], 0.5 * first[0]], *(piece[:, 0] for piece in pieces)]))
        found = under_force(self.bed, forces * self.elements.scale) / self.elements.scale  # at once, not one by one
        self.half_widths = dict(zip(forces.tolist(), np.minimum(found, 1.0).tolist(), strict=True))
        self._go(first, 0, 0.5 * float(first[0]))
        for index, (piece, point) in enumerate(zip(pieces, self.points, strict=True)):
            self.step = np.zeros(self.elements.x.size)
            for at, middle in zip(piece[1::2], piece[::2], strict=True):
                ahead = self.ahead
                self._go(at, index, float(middle[0]))
                self.step = self.ahead - ahead
            yield self._row(point)

    def _piece(self, before: Array, after: Array) -> Array:
        """Return middles and ends of the steps along a straight piece of the path, in turn."""
        ends = self._shares(before, after)
        middles = 0.5 * (ends + np.append(0.0, ends[:-1]))
        shares = np.stack([middles, ends], axis=1).ravel()[:, None]
        return np.where(shares < 1.0, before + shares * (after - before), after)

    def _shares(self, before: Array, after: Array) -> Array:
        """Return at which parts of a straight piece of the path the steps end."""
        change = after - before
        if not change.any():
            return np.ones(1)
        # mu P over E* A: the strain that a whole contact opposes is of this order
        sizes = np.abs(change) * np.array([self.friction, 1.0, 1.0]) / self.most
        whole = STEPS if change[0] == 0.0 else STEPS_BESIDE
        steps = math.ceil(min(max(whole * float(np.max(sizes)), 1.0), MOST_STEPS))
        shares = np.linspace(0.0, 1.0, steps + 1)[1:]
        if change[0] != 0.0:
            crossed = (self._arrivals - before[0]) / change[0]
            shares = np.append(shares, crossed[(crossed > ROUNDING) & (crossed < 1.0 - ROUNDING)])
        return np.unique(shares)

    @functools.cached_property
    def _arrivals(self) -> Array:
        """Normal forces at which the edge of the contact is that of an element."""
        right, scale = self.elements.edges[self.elements.edges > 0.0], self.elements.scale
        return self.bed.load_profile(scale * right) / scale

    def _bound(self, force: float) -> Array:
        """Return what friction bears on every element over E*."""
        scale, modulus = self.elements.scale, self.bed.medium.modulus
        pressed = pressed_elements(self.bed, self.elements, force * modulus * scale, self.half_widths[force] * scale)
        return self.friction * pressed

    def _go(self, point: Array, index: int, between: float) -> None:
        """Take a step to these forces and this strain; `between` is the normal force in the middle of it."""
        force, shear, strain = point.tolist()
        elements = self.elements
        if force <= 0.0:
            self.traction, self.bound, self.slips = np.zeros((3, elements.x.size))
            self.ahead, self.shift, self.half_width, self.force = -strain * elements.x, 0.0, 0.0, 0.0
            return
        bound = self._bound(force) if force != self.force else self.bound
        middle = self._bound(between) if force != self.force else bound
        self._meet((bound > 0.0) & (self.bound == 0.0))
        self.half_width_before, self.half_width = self.half_width, self.half_widths[force]
        mean = (self.bound + 4.0 * middle + bound) / 6.0
        self.force = force
        before = -self.ahead - strain * elements.x
        if abs(shear) >= self.friction * force * (1.0 - ROUNDING):
            side, touches = math.copysign(1.0, shear), bound > 0.0
            traction, slips = side * bound, side * touches
            moved = elements.compliance @ traction
            shift = float(side * np.max(side * (moved - before), where=touches, initial=-math.inf))
        else:
            traction, slips, shift, moved = strip_step(
                self.grid, before, bound, self.slips, total=shear, rounding=ROUNDING
            )
            stuck = float(elements.widths @ ((slips == 0.0) & (bound > 0.0)))
            near = abs(shear) > SLIDING_SHARE * self.friction * force or self.half_width < LEAST_WIDTH
            if stuck < LEAST_STUCK * 2.0 * self.half_width and not near and self.bulk.any():
                raise OutsideValidity(
                    f"LineTangential: before index {index} of the path the bulk stress, of {self.bulk[index]:.6g} Pa "
                    "there, makes all of the contact slip outwards or inwards but for less than a hundredth of it; "
                    "give a smaller one."
                )
        ahead = shift - strain * elements.x - moved
        self._keep(bound, mean, traction, slips, ahead)
        self.shift = shift

    def _meet(self, came: Array) -> None:
        """Let elements that come into contact be ahead as they are when the edge reaches their middle.

        Until then they move by the power 3/2 of their distance from the edge, which the step before determines.
        """
        if not came.any() or self.half_width <= self.half_width_before:
            return
        away = np.abs(self.elements.x[came])
        left = np.maximum(away - self.half_width, 0.0) ** 1.5
        gone = np.maximum(away - self.half_width_before, 0.0) ** 1.5 - left
        self.ahead[came] += self.step[came] * left / gone

    def _keep(self, bound: Array, mean: Array, traction: Array, slips: Array, ahead: Array) -> None:
        """Take over what a step has found."""
        touches = bound > 0.0
        moved = ahead - self.ahead
        slipped = np.where(touches, np.maximum(slips * moved, 0.0), np.abs(moved))  # what parts slips before
        rubbed = mean * slipped
        self.rubbed += rubbed
        self.lost += float(rubbed @ self.elements.widths)
        self.ahead = np.where(touches & (slips == 0.0), self.ahead, ahead)
        self.bound, self.traction, self.slips = bound, traction, slips

    def _row(self, point: Array) -> MarchedRow:
        rows, scale, modulus = np.flatnonzero(self.bound), self.elements.scale, self.bed.medium.modulus
        shift = self.shift
        if rows.size:
            shift -= float(point[1]) * self.bed.stuck_compliance(scale * self.half_width, scale)
        return MarchedRow(
            scale * self.elements.x[rows],
            scale * self.elements.widths[rows],
            modulus * self.bound[rows],
            modulus * self.traction[rows],
            self.slips[rows],
            scale * self.ahead[rows],
            modulus * scale * self.rubbed[rows],
            scale * shift,
            modulus * scale * scale * self.lost,
        )
