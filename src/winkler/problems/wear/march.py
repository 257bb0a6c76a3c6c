r"""How a worn profile is followed: in jumps over many cycles, as long as the error and the shortest waves allow.

What is worn off spreads the pressure, the faster the shorter its waves; a jump that is too long for them would blow up.
The jumps are steps of a method that is stable for them (`winkler.numerics.equations.stabilised`); each gives its own
error, and one that is too inaccurate is taken again, shorter.  Where all slides, and the shortest waves have decayed
many times so far, jumps are implicit (`winkler.numerics.equations.implicit`): as long as the slow growth
of the contact allows, over many nodes that come into contact.  A long one leaves pressures beside the edge that are
wrong by far more than the worn depths; the last one before a goal is short, so that they settle.  The grid is fixed
while the contact stays on it, finest beside the core that sticks, and follows a contact that grows.

The rates of sliding wear as a stiff system: what wears, and how that changes with what has been worn off.

With the springs' displacement :math:`v = d - g_0 - Gf`, the mean pressures :math:`p = E^*Rv_+` of the rings and the
force :math:`F = 2E^*w\cdot v_+`, a small change of the worn depth f changes

.. math:: \mathrm dp = E^*R\,(\mathrm dd - G\,\mathrm df) , \qquad \mathrm dd = \frac{w\cdot G\,\mathrm df}{w\cdot1}

(under a force; at a depth :math:`\mathrm dd=0`), R and w counting where springs are pressed.  In cells where v passes
zero both are differences, everywhere else matrices that are known.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any, NamedTuple, Protocol

import numpy as np

from winkler.laws.wear import WearLaw, worn_by
from winkler.numerics.equations.implicit import implicit_step
from winkler.numerics.equations.stabilised import MOST_STAGES, longest, stages_for, step, step_error
from winkler.numerics.transforms.grid_transforms import cuts_of
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import end_of
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.nodes import GRID_GROWTH, graded_nodes
from winkler.problems.wear.worn_grid import WornContact, WornGrid
from winkler.values.errors import NotConverged, OutsideValidity

FIRST_JUMP = 2e-3
"""Part of the depth that the first jump wears off."""
RATE_MARGIN = 1.2
"""On the fastest rate, which is a bound for steady slip; slip grows where wear sets in."""
WIDENING_SHARE = 0.95
"""Part of the grid at which a growing contact gets a wider one."""
UNCHECKED_SHARE = 1e-2
"""Part of the error allowed in a jump that may be worn off at once, without looking."""
STIFF_DECAYS = 3000.0
"""How often the shortest waves must have decayed, by a factor e, before jumps are implicit."""
SETTLING_DECAYS = 20.0
"""How often waves as long as the contact decay in the last implicit jump before a goal: what a long one left goes."""
EXPLICIT_STAGES = 4
"""A jump of not more stages is cheaper than an implicit one."""
RETRY_FACTOR = 0.2
"""Least part of a jump that failed, to be tried next."""
CORE_GROWTH, SLIDING_GROWTH = (5.0, 3.0), (2.0, 2.0)
"""Greatest growth of jumps and order of their errors, with a core that sticks and where all slides: nodes come into
contact there all the time, rates bend, and errors grow with the square of a jump."""
SHORTEST_JUMP = 1e-13
"""Part of a stretch at which jumps are given up."""


class WearMoment(NamedTuple):
    """How far wear has come.

    Parameters
    ----------
    elapsed : float
        Cycles, or distance [m].
    jump : float
        How far the next jump would go.
    nodes : ndarray, (n,)
        r [m].
    worn : ndarray, (2, n)
        What the first and the second body have lost [m].
    """

    elapsed: float
    jump: float
    nodes: Array
    worn: Array


class WearProblem(Protocol):
    """What the march needs of a problem."""

    @property
    def bed(self) -> Any:
        """The springs before wear."""
        ...

    @property
    def laws(self) -> WearLaw:
        """How the bodies wear."""
        ...

    @property
    def normal(self) -> Any:
        """The steady normal load."""
        ...

    @property
    def tolerance(self) -> float:
        """Error of the worn depth in one jump, over the depth; in an implicit one, over the depth and what has worn."""
        ...

    @property
    def most_worn(self) -> float:
        """Greatest depth that can wear off at all [m]; infinite where wear has no end, or it is not known."""
        ...

    def reached(self, elapsed: float) -> str:
        """Return how far wear has come, in words and with its unit."""
        ...

    def slipped(self, grid: Any, contact: WornContact) -> Array:
        """Return how far the surfaces slip at the nodes, over one cycle [m] or one metre of sliding [-]."""
        ...

    def refuse(self, contact: WornContact, elapsed: float) -> None:
        """Refuse a contact that cannot go on."""
        ...


def march_wear(
    problem: WearProblem, goals: Array, moment: WearMoment, *, everywhere: bool = False
) -> Iterator[WearMoment]:
    """Yield how far wear has come, at every goal beyond where it begins.

    Parameters
    ----------
    problem : WearProblem
        Such as `winkler.problems.wear.fretting.FrettingWear`.
    goals : ndarray, (steps,)
        Cycles or distances [m], rising.
    moment : Moment
        Where it begins; with a jump of zero, for the first time.
    everywhere : bool, optional
        Whether all that touches slides, by one metre per metre, and one body alone wears.

    Raises
    ------
    OutsideValidity
        If the contact outgrows the profile, or the bodies slide away; what was reached before has been yielded.
    NotConverged
        If jumps become too short to go on.
    """
    for goal in goals[goals > moment.elapsed]:
        moment = _advance(problem, moment, float(goal), everywhere)
        yield moment


class _JumpTrial(NamedTuple):
    """What a jump came to: the worn depths and their rates ``(2, n)``, and its error over that allowed."""

    end: Array
    last: Array
    error: float


class _WearRates:
    """A problem on one grid."""

    def __init__(self, problem: WearProblem, nodes: Array) -> None:
        self.problem, self.nodes = problem, nodes
        self.grid: WornGrid = wear_grid(problem.bed, nodes)
        self._last: tuple[bytes, WornContact, Array] | None = None

    @functools.cached_property
    def system(self) -> SlidingSystem:
        return SlidingSystem(self.grid, self.problem.normal, self.problem.laws)

    def rubbed(self, worn: Array) -> tuple[WornContact, Array]:
        """Return the contact and how far it slips; the last ones are kept."""
        key = worn.tobytes()
        if self._last is None or self._last[0] != key:
            there = self.grid.press(worn.sum(axis=0), self.problem.normal)
            self._last = key, there, self.problem.slipped(self.grid, there)
        return self._last[1:]

    def damping(self, worn: Array) -> float:
        """Return a bound of how fast the shortest waves of the pressure decay."""
        there, slip = self.rubbed(worn)
        return float(np.max(law_slope(self.problem.laws, there.pressure) * slip * self.grid.response))

    def rates(self, worn: Array) -> Array:
        there, slip = self.rubbed(worn)
        return np.array(worn_by(self.problem.laws, there.pressure)) * slip

    def explicit(self, worn: Array, first: Array, length: float, stages: int, scale: float) -> _JumpTrial:
        end = step(self.rates, worn, first, length, stages)
        last = self.rates(end)
        error = np.max(np.abs(step_error(worn, end, first, last, length).sum(axis=0)))
        return _JumpTrial(end, last, float(error) / scale)

    def implicit(self, worn: Array, first: Array, length: float, scale: float) -> _JumpTrial:
        end, last, error = implicit_step(self.system, worn.sum(axis=0), first.sum(axis=0), length)
        # the other body has lost nothing, and goes on so
        wears = 1 if first[1].any() else 0
        parts = np.zeros(worn.shape), np.zeros(worn.shape)
        parts[0][wears], parts[1][wears] = end, last
        return _JumpTrial(*parts, float(np.max(np.abs(error))) / scale)


def _advance(problem: WearProblem, moment: WearMoment, goal: float, everywhere: bool) -> WearMoment:
    """Go on to a goal."""
    elapsed, jump, nodes, worn = moment
    here = _WearRates(problem, nodes)
    (contact, _), first = here.rubbed(worn), here.rates(worn)
    problem.refuse(contact, elapsed)
    begun, overrun, failed = elapsed, False, False
    growth, order = SLIDING_GROWTH if everywhere else CORE_GROWTH
    while elapsed < goal:
        if overrun or (here.nodes[-1] < end_of(problem.bed) and contact.radius > WIDENING_SHARE * here.nodes[-1]):
            nodes, worn = _wider(problem.bed, here.nodes, worn)
            here, overrun = _WearRates(problem, nodes), False
            (contact, _), first = here.rubbed(worn), here.rates(worn)
        fastest = float(np.max(first))
        scale = problem.tolerance * scale_of(problem, here.grid, contact)
        if fastest * (goal - elapsed) <= UNCHECKED_SHARE * scale:
            return WearMoment(goal, jump, here.nodes, worn + (goal - elapsed) * first)
        damping = RATE_MARGIN * here.damping(worn)
        wanted = jump if jump > 0.0 else FIRST_JUMP * contact.depth / fastest
        length = min(wanted, goal - elapsed)
        settled = everywhere and elapsed * damping > STIFF_DECAYS and stages_for(length, damping) > EXPLICIT_STAGES
        settling = SETTLING_DECAYS * here.nodes.size / damping
        if not settled:
            length = min(length, longest(MOST_STAGES, damping))
        elif goal - elapsed > 2.0 * settling:
            length = min(length, goal - elapsed - settling)
        if length < SHORTEST_JUMP * max(goal - begun, elapsed) and length < goal - elapsed:
            raise NotConverged(
                f"Wear: after {problem.reached(elapsed)} the jumps become too short to go on; give more cells (count) "
                "or a smaller tolerance."
            )
        try:
            with np.errstate(over="raise", invalid="raise"):
                if settled:
                    tried = here.implicit(worn, first, length, problem.tolerance * here.grid.sunk(contact, worn))
                else:
                    tried = here.explicit(worn, first, length, stages_for(length, damping), scale)
        except (FloatingPointError, NotConverged):
            jump, failed = RETRY_FACTOR * length, everywhere
            continue
        part = 0.8 * max(tried.error, 1e-9) ** (-1.0 / order)
        if not tried.error <= 1.0:
            jump, failed = length * max(RETRY_FACTOR, part), everywhere
            continue
        # what is worn off does not come back, whatever rounding gives
        back = bool(np.any(tried.end < worn))
        end = np.maximum(tried.end, worn) if back else tried.end
        there, _ = here.rubbed(end)
        overrun = there.stretch[-1] > 0.0 and here.nodes[-1] < end_of(problem.bed)
        if overrun:
            continue
        grown, failed = length * min(1.0 if failed else growth, part), False
        # a goal that was near does not limit the next jump
        jump = max(grown, wanted) if length == goal - elapsed else grown
        elapsed = goal if length == goal - elapsed else elapsed + length
        worn, contact = end, there
        problem.refuse(contact, elapsed)
        _refuse_outgrown(problem.bed, contact, here.nodes)
        first = here.rates(worn) if back else tried.last
    return WearMoment(elapsed, jump, here.nodes, worn)


def scale_of(problem: WearProblem, grid: WornGrid, contact: WornContact) -> float:
    """Return the displacement [m] in terms of which errors count."""
    pressed = contact.depth if grid.holds_depth(problem.normal) else float(np.max(contact.stretch))
    return min(pressed, problem.most_worn)


def _refuse_outgrown(bed: Any, contact: WornContact, nodes: Array) -> None:
    """Refuse a contact that grows beyond what is known of its profile."""
    if end_of(bed) <= nodes[-1] < bed.rim and contact.stretch[-1] > 0.0:
        raise OutsideValidity(
            f"Wear: the contact grows beyond {nodes[-1]:.6g} m, as far as the profile is known; give one that is known "
            "farther out, or wear less."
        )


def _wider(bed: Any, nodes: Array, worn: Array) -> tuple[Array, Array]:
    """Return a wider grid, and what was worn on it."""
    reach = min(GRID_GROWTH * float(nodes[-1]), bed.reach, bed.rim)
    # the core has moved by then: a grid of even steps serves as well
    wide = graded_nodes(0.0, reach, bed.rim, nodes.size - 1)
    transforms = wear_grid(bed, wide).transforms
    return wide, np.stack([transforms.means(nodes**2, row) for row in worn])


DIFFERENCE_STEP = 1e-6
"""Change over which differences are taken, relative to the greatest number around."""


def law_slope(law: WearLaw, pressure: Array) -> Array:
    """Return how the worn depth per slip of both bodies grows with the pressure [1/Pa]."""
    near = DIFFERENCE_STEP * float(np.max(pressure))
    if near == 0.0:
        return np.zeros(pressure.shape)
    here, there = (np.add(*worn_by(law, pressure + more)) for more in (0.0, near))
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
        self._pressed = -np.diff(transforms.outside, axis=0, append=0.0) / transforms.areas[:, None]
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
        return np.add(*worn_by(self.law, self.contact(state).pressure))

    def slopes(self, state: Array) -> tuple[Array, Array]:
        """Return where something wears, and how those rates change with what has been worn off [1/m]."""
        contact, transforms = self.contact(state), self.grid.transforms
        stretch = contact.stretch
        # a rim that is pressed counts by itself
        rim = {stretch.size - 1} if stretch[-1] > 0.0 else set()
        cells = [cut.cell for cut in cuts_of(transforms.squares, stretch)]
        beside = sorted({*cells, *(cell + 1 for cell in cells)} | rim)
        counted = stretch > 0.0
        counted[beside] = False
        for changed, sign in ((counted & ~self._counted, 1.0), (self._counted & ~counted, -1.0)):
            if changed.any():
                self._both += sign * (self._pressed[:, changed] @ self._lifted[changed])
        self._counted = counted
        pressed, borne = self._differences(stretch, beside)
        changing = contact.pressure > 0.0
        rows = -(self._both[changing] + pressed[changing] @ self._lifted[beside])
        if not self.grid.holds_depth(self.load):
            borne += np.where(counted, transforms.force, 0.0)
            sunk = (borne @ self._lifted) / np.sum(borne)
            rows += (self._pressed @ counted + pressed.sum(axis=1))[changing, None] * sunk
        rows *= (self.grid.modulus * law_slope(self.law, contact.pressure))[changing, None]
        return changing, rows

    def _differences(self, stretch: Array, nodes: list[int]) -> tuple[Array, Array]:
        """Return how pressures ``(n, nodes)`` and force ``(n,)`` change with the stretch of single springs at edges."""
        transforms = self.grid.transforms

        def at(values: Array) -> tuple[Array, float]:
            cuts = cuts_of(transforms.squares, values)
            return transforms.borne(values, cuts), transforms.integral(values, cuts)

        pressed, borne = np.zeros((stretch.size, len(nodes))), np.zeros(stretch.size)
        for column, node in enumerate(nodes):
            step = DIFFERENCE_STEP * float(np.abs(stretch[max(node - 1, 0) : node + 2]).max())
            more, less = stretch.copy(), stretch.copy()
            more[node], less[node] = stretch[node] + step, stretch[node] - step
            (there, stronger), (here, weaker) = at(more), at(less)
            pressed[:, column], borne[node] = (there - here) / (2.0 * step), (stronger - weaker) / (2.0 * step)
        return pressed, borne

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
