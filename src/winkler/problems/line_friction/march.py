r"""A sheared line contact step by step on boundary elements: histories of both forces and of a bulk stress.

The second body is ahead of the first by

.. math:: s(x) = \delta - \varepsilon x - u(x) , \qquad
          u(x) = -\frac2{\pi E^*}\int q(\xi)\,\ln|x-\xi|\,\mathrm d\xi , \qquad
          \varepsilon = \frac{1-\nu_1^2}{E_1}\sigma_B ,

which stays as it is where the surfaces stick, and changes in the direction of q where they slip under
:math:`|q|=\mu p`.  Each step finds the zones in which that holds at its end, and the shift :math:`\delta` at which the
tractions add up to Q.  On similar bodies the pressure does not depend on the traction.  An element that comes into
contact brings along how far it was ahead when the edge of the contact reached its middle: while the normal force
changes, a step ends where the edge of the contact is that of an element.

Where stick meets slip, in the midst of an element, the traction departs from its bound by the root of the distance: the
error of the loss, about 1e-4, falls by the power 7/4 of the width of the elements only.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.numerics.surfaces.strip_grid import strip_step
from winkler.numerics.types import Array
from winkler.problems.line_friction.bulk import strain_per_stress
from winkler.problems.line_friction.elements import elements_for, pressed_elements
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.strips import half_widths

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

    def __init__(self, bed: LineFoundation, friction: float, path: LinePath) -> None:
        self.bed, self.friction = bed, friction
        modulus = bed.medium.modulus
        self.widths = half_widths(bed, path.across / modulus)
        self.elements = elements_for(self.widths)
        per_force = 1.0 / (modulus * self.elements.scale)
        strains = strain_per_stress(bed) * path.bulk
        self.points = np.stack([path.across * per_force, path.along * per_force, strains], axis=1)
        self.most = friction * float(np.max(self.points[:, 0]))
        right = self.elements.edges[self.elements.edges > 0.0]
        self.arrivals = bed.load_profile(self.elements.scale * right) / self.elements.scale
        self.bulk = path.bulk
        self.traction, self.bound, self.ahead, self.slips, self.rubbed = np.zeros((5, self.elements.x.size))
        self.shift = self.lost = 0.0
        self.half_width = self.force = 0.0
        self.step, self.half_width_before = np.zeros(self.elements.x.size), 0.0

    def rows(self) -> Iterator[MarchedRow]:
        """Yield the elements that touch at every point of the path, none if the bodies are apart."""
        before = self.points[0] * np.array([1.0, 0.0, 0.0])
        self._go(before, 0)
        for index, point in enumerate(self.points):
            self.step = np.zeros(self.elements.x.size)
            for share in self._shares(before, point):
                ahead = self.ahead
                self._go(before + share * (point - before) if share < 1.0 else point, index)
                self.step = self.ahead - ahead
            before = point
            yield self._row(point)

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
            crossed = (self.arrivals - before[0]) / change[0]
            shares = np.append(shares, crossed[(crossed > ROUNDING) & (crossed < 1.0 - ROUNDING)])
        return np.unique(shares)

    def _bound(self, force: float) -> tuple[Array, float]:
        """Return what friction bears on every element over E*, and the half-width over A."""
        scale, modulus = self.elements.scale, self.bed.medium.modulus
        a = min(float(half_widths(self.bed, np.array([force * scale]))[0]) / scale, 1.0)
        return self.friction * pressed_elements(self.bed, self.elements, force * modulus * scale, a * scale), a

    def _go(self, point: Array, index: int) -> None:
        """Take a step to these forces and this strain."""
        force, shear, strain = point.tolist()
        elements = self.elements
        if force <= 0.0:
            self.traction, self.bound, self.slips = np.zeros((3, elements.x.size))
            self.ahead, self.shift, self.half_width, self.force = -strain * elements.x, 0.0, 0.0, 0.0
            return
        middle = self._bound(0.5 * (force + self.force))[0] if force != self.force else self.bound
        bound, half_width = self._bound(force)
        self._meet((bound > 0.0) & (self.bound == 0.0))
        self.half_width_before, self.half_width = self.half_width, half_width
        mean = (self.bound + 4.0 * middle + bound) / 6.0
        self.force = force
        rows = np.flatnonzero(bound)
        whole, widths = rows.size == bound.size, elements.widths[rows]
        compliance = elements.compliance if whole else elements.compliance[np.ix_(rows, rows)]
        before = -self.ahead[rows] - strain * elements.x[rows]
        if abs(shear) >= self.friction * force * (1.0 - ROUNDING):
            slips = np.full(rows.size, math.copysign(1.0, shear))
            traction = slips * bound[rows]
            shift = float(slips[0] * np.max(slips * (compliance @ traction - before)))
        else:
            found = strip_step(
                compliance,
                before,
                bound[rows],
                self.slips[rows],
                total=shear,
                weights=widths,
                rounding=ROUNDING,
            )
            traction, slips, shift = found
            share = float(np.sum(widths[slips == 0.0])) / (2.0 * self.half_width)
            near = abs(shear) > SLIDING_SHARE * self.friction * force or self.half_width < LEAST_WIDTH
            if share < LEAST_STUCK and not near and self.bulk.any():
                raise OutsideValidity(
                    f"LineTangential: before index {index} of the path the bulk stress, of {self.bulk[index]:.6g} Pa "
                    "there, makes all of the contact slip outwards or inwards but for less than a hundredth of it; "
                    "give a smaller one."
                )
        self._keep(rows, bound, mean, traction, slips, shift, strain)

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

    def _keep(
        self, rows: Array, bound: Array, mean: Array, traction: Array, slips: Array, shift: float, strain: float
    ) -> None:
        """Take over what a step has found for the elements that touch."""
        elements = self.elements
        borne = np.zeros(elements.x.size)
        borne[rows] = traction
        ahead = shift - strain * elements.x - elements.compliance @ borne
        slipped = np.where(bound == 0.0, np.abs(ahead - self.ahead), 0.0)  # what parts slips before
        slipped[rows] = np.where(slips == 0.0, 0.0, np.maximum(slips * (ahead[rows] - self.ahead[rows]), 0.0))
        rubbed = mean * slipped
        self.rubbed += rubbed
        self.lost += float(rubbed @ elements.widths)
        ahead[rows] = np.where(slips == 0.0, self.ahead[rows], ahead[rows])
        self.ahead, self.shift, self.bound = ahead, shift, bound
        self.traction, self.slips = borne, np.zeros(elements.x.size)
        self.slips[rows] = slips

    def _row(self, point: Array) -> MarchedRow:
        rows, scale, modulus = np.flatnonzero(self.bound), self.elements.scale, self.bed.medium.modulus
        shift = self.shift
        if rows.size:
            shift += 2.0 / np.pi * float(point[1]) * math.log(0.5 * self.half_width)
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
