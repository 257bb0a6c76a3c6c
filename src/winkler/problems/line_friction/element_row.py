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
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.surfaces.strip_grid import StuckStrip, strip_step
from winkler.numerics.types import Array
from winkler.problems.line.half_width import under_force
from winkler.problems.line_friction.elements import elements_for, pressed_elements
from winkler.problems.line_friction.first_slip import FirstSlip, first_slip
from winkler.problems.line_friction.path import LinePath
from winkler.problems.row import Reached, Row
from winkler.values.errors import OutsideValidity

STEPS, STEPS_BESIDE = 24, 72
"""Steps over a change of the shear force by what friction bears at most, and of the bulk stress in proportion; while
the normal force changes the pressure on what slips does so, too, and steps are shorter."""
MOST_STEPS = 1000.0
"""Between two points of the path, besides those at which the contact widens or narrows by an element."""
ROUNDING = 1e-12
SLIDING_TOLERANCE = 1e-12
"""A shear force beyond what friction bears by no more than this part of it is that of sliding."""
LEAST_STUCK, SLIDING_SHARE, LEAST_WIDTH = 0.01, 0.999, 0.2
"""A bulk stress is refused that leaves less of the contact sticking, below this part of the shear force of sliding,
while the contact is wider than this part of the widest."""


class TouchingElements(NamedTuple):
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
    slip_shift
        As in `LineTangentialSolution` [m].
    """

    x: Array
    widths: Array
    bound: Array
    traction: Array
    slips: Array
    ahead: Array
    rubbed: Array
    slip_shift: float


class LineGoal(NamedTuple):
    """What is prescribed at a point of the path: P and Q over E* A [-], and the strain of the bulk stress [-]."""

    force: float
    shear: float
    strain: float
    bulk: float
    """The bulk stress [Pa], for messages."""


class LineCells(NamedTuple):
    """What elements remember.

    Parameters
    ----------
    goal
        Where they are.
    traction, bound
        Over E* ``(n,)``.
    ahead, slips, rubbed
        As in `TouchingElements`, over A, and over E* A.
    last, half_width_before
        How far they came ahead in the last step, and the half-width over A at its beginning.
    half_width, shift
        Over A.
    crept, number
        Of bodies that relax what of the tractions has flowed ``(n,)`` and is delayed ``(k, n)``, and the step that
        they have reached.
    """

    goal: LineGoal
    traction: Array
    bound: Array
    ahead: Array
    slips: Array
    rubbed: Array
    last: Array
    half_width_before: float
    half_width: float
    shift: float
    crept: tuple[Array, Array]
    number: int = -1
    turned: LineCells | None = None
    """The turning point of the shear force from which they came, under a steady normal force."""


Response = tuple[StuckStrip, float, Array | float]
"""Of a step: the elements, a factor of their compliance, and how far they are moved without new tractions."""


class ElementRow(Row[LineGoal, LineCells]):
    """Elements on a line contact; lengths over the greatest half-width A, tractions over E*, forces over E* A.

    Between two points of the path steps are as long as the constants of this module have them: none is halved.  Losses
    are over E* A^2; half-planes move without end under a force per length, so that the work is no number.
    """

    owner = "LineTangential"

    def __init__(self, bed: LineBed, friction: float, path: LinePath) -> None:
        self.bed, self.friction = bed, friction
        modulus = bed.medium.modulus
        self.elements = elements_for(bed, under_force(bed, path.across / modulus))
        self.unit = modulus * self.elements.scale
        """E* A [N/m]."""
        strain = bed.strain_per_stress * path.bulk if path.bulk.any() else path.bulk
        rows = path.across / self.unit, path.along / self.unit, strain, path.bulk
        self.goals = [LineGoal(*row) for row in zip(*(each.tolist() for each in rows), strict=True)]
        self.most = friction * max(goal.force for goal in self.goals)
        self.strained = bool(path.bulk.any())
        self.grid = StuckStrip(self.elements.compliance, self.elements.widths)
        pieces = [self._piece(before, after) for before, after in pairwise(self.goals) if before.force != after.force]
        start = self.goals[0].force
        forces = np.unique(np.concatenate([[start, 0.5 * start], *(piece[:, 0] for piece in pieces)]))
        found = under_force(bed, forces * self.elements.scale) / self.elements.scale  # at once, not one by one
        self.half_widths = dict(zip(forces.tolist(), np.minimum(found, 1.0).tolist(), strict=True))

    def _rest(self, terms: int = 0) -> LineCells:
        """Return elements that nothing has touched, on bodies whose creep has so many terms."""
        none = np.zeros(self.elements.x.size)
        crept = none, np.zeros((terms, none.size))
        return LineCells(LineGoal(0.0, 0.0, 0.0, 0.0), none, none, none, none, none, none, 0.0, 0.0, 0.0, crept=crept)

    def begin(self, goal: LineGoal) -> Reached[LineCells]:
        """Return the elements pressed straight down, and sheared and strained after."""
        down = goal._replace(shear=0.0, strain=0.0, bulk=0.0)
        pressed = self._go(self._rest(), down, np.array(down[:3]), 0.5 * goal.force)
        return pressed.then(self.step(pressed.state, goal))

    def step(self, state: LineCells, goal: LineGoal) -> Reached[LineCells]:
        """Return the elements after forces and strain have changed in proportion."""
        refuse_sliding(self.friction, goal.force, goal.shear, self.unit)
        if self._first is not None:
            return self._turned(self._first, state, goal)
        piece = self._piece(state.goal, goal)
        reached = Reached(state._replace(last=np.zeros(self.elements.x.size)), 0.0, 0.0)
        for at, middle in zip(piece[1::2], piece[::2], strict=True):
            reached = reached.then(self._go(reached.state, goal, at, float(middle[0])))
        return reached

    @functools.cached_property
    def _first(self) -> FirstSlip | None:
        """How elements slip from nothing on; None where more than the shear force changes."""
        force = self.goals[0].force
        if self.strained or force == 0.0 or any(goal.force != force for goal in self.goals):
            return None
        return first_slip(self.elements, self._bound(force))

    def _turned(self, first: FirstSlip, cells: LineCells, goal: LineGoal) -> Reached[LineCells]:
        """Return the elements under another shear force, from the turning point to which that leads back."""
        if goal.shear == cells.goal.shear:
            return Reached(cells._replace(last=np.zeros(cells.last.size)), math.nan, 0.0)
        side, turned = math.copysign(1.0, goal.shear - cells.goal.shear), cells.turned
        if side * (cells.goal.shear - (turned.goal.shear if turned else 0.0)) < 0.0:
            turned = cells
        origin = turned
        while turned is not None:  # a loop is closed where the point is reached at which it began
            before = turned.turned
            end = before.goal.shear if before else -turned.goal.shear
            if side * (goal.shear - end) < 0.0:
                break
            turned = before.turned if before else None
            origin = turned if goal.shear != end else origin
        times, start = (2.0, origin.goal.shear) if origin else (1.0, 0.0)
        traction, ahead, slips, shift = first.at(abs(goal.shear - start) / times)
        traction, ahead, shift = side * times * traction, side * times * ahead, side * times * shift
        if origin:
            traction, ahead, shift = traction + origin.traction, ahead + origin.ahead, shift + origin.shift
        gone = ahead - cells.ahead
        rubbed = cells.bound * np.abs(gone)
        new = cells._replace(
            goal=goal, traction=traction, ahead=ahead, slips=side * slips, rubbed=cells.rubbed + rubbed, last=gone,
            half_width_before=cells.half_width, shift=shift, turned=turned,
        )  # fmt: skip
        return Reached(new, math.nan, float(rubbed @ self.elements.widths))

    def _piece(self, start: LineGoal, goal: LineGoal) -> Array:
        """Return middles and ends of the steps along a straight piece of the path, in turn."""
        before, after = np.array(start[:3]), np.array(goal[:3])
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

    def _go(self, cells: LineCells, goal: LineGoal, at: Array, between: float) -> Reached[LineCells]:
        """Return the elements under forces on the way; `between` is the normal force in the middle of the step."""
        force, shear, strain = at.tolist()
        bound, half_width = cells.bound, self.half_widths[force]
        middle = bound
        if force != cells.goal.force:
            bound, middle = self._bound(force), self._bound(between)
        at_goal = goal._replace(force=force, shear=shear, strain=strain)
        reached = self._moved(cells, at_goal, bound, middle, half_width, (self.grid, 1.0, 0.0))
        new = reached.state
        near = abs(shear) > SLIDING_SHARE * self.friction * force or half_width < LEAST_WIDTH
        stuck = float(self.elements.widths @ ((new.slips == 0.0) & (bound > 0.0)))
        if self.strained and force > 0.0 and not near and stuck < LEAST_STUCK * 2.0 * half_width:
            raise OutsideValidity(
                f"the bulk stress, of {goal.bulk:.6g} Pa there, makes all of the contact slip outwards or inwards "
                "during the step but for less than a hundredth of it; give a smaller one."
            )
        return reached

    def _moved(
        self, cells: LineCells, goal: LineGoal, bound: Array, middle: Array, half_width: float, response: Response
    ) -> Reached[LineCells]:
        """Return the elements at the end of one straight step.

        `bound` and `middle` are what friction bears there and in the middle of the step.
        """
        elements, (grid, compliance, carried) = self.elements, response
        free = -goal.strain * elements.x - carried
        if half_width == 0.0:
            none = np.zeros(elements.x.size)
            parted = cells._replace(
                goal=goal, traction=none, bound=none, slips=none, ahead=free, last=free - cells.ahead,
                half_width=0.0, half_width_before=0.0, shift=0.0,
            )  # fmt: skip
            return Reached(parted, math.nan, 0.0)
        touches = bound > 0.0
        met = self._met(cells, touches & (cells.bound == 0.0))
        before = free - met
        if abs(goal.shear) >= self.friction * goal.force * (1.0 - ROUNDING):
            side = math.copysign(1.0, goal.shear)
            traction, slips = side * bound, side * touches
            moved = grid.compliance @ (compliance * traction)
            shift = float(side * np.max(side * (moved - before), where=touches, initial=-math.inf))
        else:
            found, slips, shift, moved = strip_step(
                grid, before, compliance * bound, cells.slips, total=compliance * goal.shear, rounding=ROUNDING
            )
            traction = found / compliance
        ahead = shift + free - moved
        gone = ahead - met
        slipped = np.where(touches, np.maximum(slips * gone, 0.0), np.abs(gone))  # what parts slips before
        rubbed = (cells.bound + 4.0 * middle + bound) / 6.0 * slipped
        ahead = np.where(touches & (slips == 0.0), met, ahead)
        new = cells._replace(
            goal=goal, traction=traction, bound=bound, ahead=ahead, slips=slips, rubbed=cells.rubbed + rubbed,
            last=ahead - cells.ahead, half_width_before=cells.half_width, half_width=half_width, shift=shift,
        )  # fmt: skip
        return Reached(new, math.nan, float(rubbed @ elements.widths))

    def _met(self, cells: LineCells, came: Array) -> Array:
        """Return how far elements are ahead, those that come into contact as when the edge reaches their middle.

        Until then they move by the power 3/2 of their distance from the edge, which the step before determines.
        """
        if not came.any() or cells.half_width <= cells.half_width_before:
            return cells.ahead
        away, ahead = np.abs(self.elements.x[came]), cells.ahead.copy()
        left = np.maximum(away - cells.half_width, 0.0) ** 1.5
        gone = np.maximum(away - cells.half_width_before, 0.0) ** 1.5 - left
        # an element at the edge may have no distance left: the edge rose by rounding alone
        ahead[came] += cells.last[came] * np.divide(left, gone, out=np.zeros_like(left), where=gone > 0.0)
        return ahead

    def _if_stuck(self, cells: LineCells) -> float:
        """Return the shift over A of a strip as wide that sticks."""
        scale = self.elements.scale
        return cells.goal.shear * stuck_compliance(self.bed, scale * cells.half_width, scale)

    def lost_per_length(self, lost: float) -> float:
        """Return a loss [J/m]."""
        return self.unit * self.elements.scale * lost

    def touching(self, cells: LineCells) -> TouchingElements:
        """Return the elements that touch, in units of their own; none if the bodies are apart."""
        rows, scale, modulus = np.flatnonzero(cells.bound), self.elements.scale, self.bed.medium.modulus
        shift = cells.shift
        if rows.size:
            shift -= self._if_stuck(cells)
        return TouchingElements(
            scale * self.elements.x[rows],
            scale * self.elements.widths[rows],
            modulus * cells.bound[rows],
            modulus * cells.traction[rows],
            cells.slips[rows],
            scale * cells.ahead[rows],
            modulus * scale * cells.rubbed[rows],
            scale * shift,
        )


@functools.lru_cache(maxsize=64)
def stuck_compliance(bed: LineBed, half_width: float, unit: float) -> float:
    """Return the displacement of a strip that sticks, as of `LineBed.stuck_compliance`, kept."""
    return bed.stuck_compliance(half_width, unit)


def refuse_sliding(friction: float, force: float, shear: float, unit: float) -> None:
    """Refuse a shear force that friction does not bear; both over `unit` [N/m].

    Raises
    ------
    OutsideValidity
    """
    if abs(shear) > friction * force * (1.0 + SLIDING_TOLERANCE):
        raise OutsideValidity(
            f"a shear force of {shear * unit:.6g} N/m is prescribed, but the friction limit is "
            f"{friction * force * unit:.6g} N/m, and the bodies would slide away; give a smaller one."
        )
