r"""Earlier contacts that add up to a sheared one, as a row: the loss of a step, and the shift that slip allows.

Without a bulk stress both are sums over the memory.  With one the normal force is steady, so that what slips in a step
bears its final traction all the time,

.. math:: D = \int_{-a}^a q\,\Delta s\,\mathrm dx , \qquad U_s = \int_{-a}^a\frac{s}{\pi\sqrt{a^2-x^2}}\,\mathrm dx ,

the second by reciprocity with a flat punch: it is the shift of the bodies beyond that of a strip that sticks.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.slip_sums import SlipSums
from winkler.problems.line_friction.bulk import lean_of
from winkler.problems.line_friction.element_row import refuse_sliding
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.slip_curve import slip_curve
from winkler.problems.line_friction.strips import EarlierStrip, slipped, strips_of, traction
from winkler.problems.row import Reached, Row

ANGLES, STEPS = np.polynomial.legendre.leggauss(20)
PLACES, WEIGHTS = np.sin(0.5 * np.pi * ANGLES), 0.5 * np.pi * STEPS * np.cos(0.5 * np.pi * ANGLES)
"""Between the edges of two strips, from -1 to 1: roots at both ends are mapped away."""
ROUNDING = 1e-14
"""By which the factor of a strip that stays may differ after a step."""


class SummedGoal(NamedTuple):
    """P and Q [N/m] at a point of the path."""

    force: float
    shear: float


class SummedCells(NamedTuple):
    """What is remembered, the strips of it beside a bulk stress, and the shift beyond what Q causes [m]."""

    memory: SlipMemory
    strips: tuple[EarlierStrip, ...]
    shift: float


class SummedRow(Row[SummedGoal, SummedCells]):
    """A line contact as a sum of earlier ones, where `winkler.problems.line_friction.bulk.has_closed_form` says so.

    Losses are per length [J/m]; half-planes move without end under a force per length, so that the work is no number.
    """

    owner = "LineTangential"

    def __init__(self, bed: LineBed, friction: float, path: LinePath) -> None:
        self.bed, self.friction, self.modulus = bed, friction, bed.medium.modulus
        self.goals = [SummedGoal(*row) for row in zip(path.across.tolist(), path.along.tolist(), strict=True)]
        most = max(goal.force for goal in self.goals) / self.modulus
        self.sums = SlipSums(slip_curve(bed, most)) if most > 0.0 else None
        self.lean = lean_of(bed, path)

    def begin(self, goal: SummedGoal) -> Reached[SummedCells]:
        """Return the contact pressed straight down, and sheared after."""
        memory = SlipMemory.fresh().moved(goal.force / self.modulus, 0.0, self.friction).memory
        return self.step(SummedCells(memory, (), 0.0), goal)

    def step(self, state: SummedCells, goal: SummedGoal) -> Reached[SummedCells]:
        """Return the contact after both forces have changed in proportion."""
        bed, modulus, sums = self.bed, self.modulus, self.sums
        refuse_sliding(self.friction, *goal, 1.0)
        change = goal.shear / modulus - state.memory.on_axis
        memory, lost, _ = state.memory.moved(goal.force / modulus, change, self.friction, sums)
        if self.lean != 0.0 and goal.force > 0.0:
            strips = strips_of(bed, memory, self.lean)
            lost, further = work_and_shift(bed, state.strips, strips)
            return Reached(SummedCells(memory, strips, state.shift + further), math.nan, lost)
        if sums is None:
            return Reached(SummedCells(memory, (), 0.0), math.nan, 0.0)
        # of the second body, beyond a strip that sticks under this force
        shift = -bed.along_share * sums.within(memory)[1] / modulus if goal.force > 0.0 else 0.0
        return Reached(SummedCells(memory, (), shift), math.nan, max(bed.along_share * lost, 0.0))


def work_and_shift(
    bed: LineBed, before: tuple[EarlierStrip, ...], after: tuple[EarlierStrip, ...]
) -> tuple[float, float]:
    """Return the loss per length of a step under a steady normal force [J/m], and by how much the shift changes [m].

    Strips that stay lie inside of those that change, beside which alone there is slip: only the latter are summed.

    Parameters
    ----------
    bed : LineBed
    before, after : tuple of EarlierStrip
        At both ends of the step, each within the next; none before the first.
    """
    staying = 0
    for one, other in zip(before, after, strict=False):
        if one[1:] != other[1:] or abs(one.factor - other.factor) > ROUNDING:
            break
        staying += 1
    a = after[-1].half_width
    before, after = before[staying:], after[staying:]
    x, share = _over_contact((*before, *after), a)
    slip = slipped(bed, after, x) - slipped(bed, before, x)
    work = share @ (traction(bed, after, x) * slip)
    shift = share @ (slip / (np.pi * np.sqrt((a - x) * (a + x))))
    return max(float(work), 0.0), float(shift)


def _over_contact(strips: tuple[EarlierStrip, ...], a: float) -> tuple[Array, Array]:
    """Return places and weights [m] for integrals over the contact, piece by piece between the edges of all strips."""
    ends = [strip.middle + side * strip.half_width for strip in strips for side in (-1.0, 1.0)]
    edges = np.unique(np.clip([-a, *ends, a], -a, a))
    half, middle = 0.5 * np.diff(edges)[:, None], 0.5 * (edges[1:] + edges[:-1])[:, None]
    x, share = (middle + half * PLACES).ravel(), (half * WEIGHTS).ravel()
    inside = np.abs(x) < a
    return x[inside], share[inside]
