r"""The memory of the springs of a sheared contact, distinguished by their gap instead of their place.

The springs of a rising profile can be numbered by :math:`\gamma=g(x)`, from 0 on the axis to the depth d at the edge.
On a straight step in depth and shift a spring that sticks is displaced by the shift, one that slides stays on its bound
:math:`\beta(d-\gamma)`, and one that comes into contact begins within the step.  All of that is linear in
:math:`\gamma`, so the displacement of the springs stays a chain of straight pieces for ever, one for each turning point
that is not yet forgotten: no grid, and no error but rounding.  What the pieces add up to is computed by
`winkler.problems.friction.slip_sums`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["LossPiece", "SlipMemory"]

SLOPE_TOLERANCE = 1e-13
"""Pieces that meet, and whose slopes differ by less than this part of the slopes there are, become one."""
LEAST_DEPTH = 1e-150
"""Depths below this [m] are none, and springs whose gaps differ by less lose alike: their squares are no numbers."""
BOUND_TOLERANCE = 1e-12
"""A spring that is displaced by all but this part of its bound slides."""
CUT_TOLERANCE = 1e-14
"""A cut this close to the end of a piece, in parts of the depth, is at the end."""


class LossPiece(NamedTuple):
    """What each of some springs has lost or taken up, over its tangential stiffness: a polynomial of its gap.

    Parameters
    ----------
    start, stop : float
        Their gaps [m].
    constant, linear, square : float
        [m^2], [m] and [-], in powers of stop - gap.
    """

    start: float
    stop: float
    constant: float
    linear: float
    square: float


Ends = tuple[float, float]
"""What a straight line over the gap is at both ends of a piece."""


class _SpringPiece(NamedTuple):
    start: float
    stop: float
    left: float
    right: float
    slides: int


@value
class SlipMemory:
    """The sideways displacement of the springs over their gap, in straight pieces.

    Parameters
    ----------
    depth : float
        d [m]; below zero the bodies are apart.
    edges : ndarray, (m + 1,)
        Where the pieces meet: gaps from 0 to the depth [m].
    left, right : ndarray, (m,)
        u_t at both ends of every piece [m].
    slides : ndarray, (m,)
        Whether the springs of a piece are on their bound: on which side (+1, -1), else 0.
    """

    __words__ = words(
        stick_gap=(r"\gamma_c", "m", "gap of the outermost spring that sticks"),
        corners=("", None, "depths and factors of the contacts that add up to the displacement"),
        edges=(r"\gamma_j", "m", "gaps at which the straight pieces of the displacement meet"),
        left=("u_t", "m", "displacement of the springs where a piece begins"),
        right=("u_t", "m", "displacement of the springs where a piece ends"),
        slides=(r"\sigma", "", "side to which springs slide: 1, -1, or 0 if they stick"),
    )

    depth: float
    edges: Array
    left: Array
    right: Array
    slides: Array

    @classmethod
    def fresh(cls) -> SlipMemory:
        """Return what is remembered by bodies that have not met."""
        return _remembered(0.0, [])

    @property
    def stick_gap(self) -> float:
        """Gap of the outermost spring that is not on its bound [m]; zero if all are."""
        stuck = np.flatnonzero(self.slides == 0.0)
        return float(self.edges[stuck[-1] + 1]) if stuck.size else 0.0

    def value(self, gap: Array) -> Array:
        """u_t [m] of the springs of given gaps [m]; zero outside the contact."""
        gap = np.asarray(gap, dtype=float)
        if not self.left.size:
            return np.zeros(gap.shape)
        place = np.clip(np.searchsorted(self.edges, gap, side="right") - 1, 0, self.left.size - 1)
        start, stop = self.edges[place], self.edges[place + 1]
        share = (gap - start) / (stop - start)
        inside = self.left[place] * (1.0 - share) + self.right[place] * share
        return np.where((gap <= self.depth) & (gap >= 0.0), inside, 0.0)

    def moved(self, depth: float, change: float, bound: float) -> tuple[SlipMemory, tuple[LossPiece, ...]]:
        """Return the memory after a straight step, and the energy lost.

        Parameters
        ----------
        depth : float
            d at the end of the step [m].
        change : float
            By how much the bodies shift in the step [m].
        bound : float
            beta = mu E* / G* [-]: a spring of gap gamma slides at u_t = beta (d - gamma); infinite if none ever does.

        Returns
        -------
        SlipMemory
        tuple of LossPiece
        """
        step = self._step(depth, change, bound, account=False)
        return _remembered(step.after, step.pieces), tuple(step.losses)

    def worked(
        self, depth: float, change: float, bound: float
    ) -> tuple[SlipMemory, tuple[LossPiece, ...], tuple[LossPiece, ...]]:
        """Return as `moved`, and what the bodies have spent on the springs, which does not go by what these keep."""
        step = self._step(depth, change, bound, account=True)
        return _remembered(step.after, step.pieces), tuple(step.losses), tuple(step.works)

    def _step(self, depth: float, change: float, bound: float, *, account: bool) -> _StraightStep:
        if 0.0 < depth < LEAST_DEPTH:
            depth = 0.0
        step = _StraightStep(self.depth, depth, change, bound, account)
        common = max(min(self.depth, depth), 0.0)
        edges = self.edges.tolist()
        for start, stop, left, right in zip(edges, edges[1:], self.left.tolist(), self.right.tolist(), strict=False):
            if stop <= common:
                step.drag(start, stop, left + change, right + change)
            elif start >= common:
                step.leave(start, stop, left, right)
            else:
                at = left + (right - left) * ((common - start) / (stop - start))
                step.drag(start, common, left + change, at + change)
                step.leave(common, stop, at, right)
        if depth > common:
            # springs that come into contact within the step take part in what is left of it
            step.drag(common, depth, (depth - common) * change / step.rise, 0.0, came=True)
        return step

    @property
    def corners(self) -> tuple[Array, Array]:
        """Depths [m] and factors of the normal contacts whose springs add up to u_t: the sum of B (gamma_j - gamma)+.

        Jumps of u_t, which only springs that never slide can have, are not among them.
        """
        slope = (self.right - self.left) / np.diff(self.edges)
        return self.edges[1:], np.diff(np.append(slope, 0.0))


class _StraightStep:
    """A straight step in depth and shift, and its effect on the springs."""

    def __init__(self, before: float, after: float, change: float, bound: float, account: bool) -> None:
        self.before, self.after, self.change, self.bound, self.account = before, after, change, bound, account
        self.rise = after - before
        self.works: list[LossPiece] = []
        self.pieces: list[_SpringPiece] = []
        self.losses: list[LossPiece] = []

    def drag(self, start: float, stop: float, left: float, right: float, *, came: bool = False) -> None:
        """Move springs of which those that tried to be displaced by more than their bound slide."""
        if math.isinf(self.bound):
            self.pieces.append(_SpringPiece(start, stop, left, right, 0))
            self._spend(start, stop, (left, right), (left, right) if came else None)
            return
        width, after, bound = stop - start, self.after, self.bound
        first, last = bound * (after - start), bound * (after - stop)
        cuts = [(start, left), (stop, right)]
        for sign in (1.0, -1.0):
            one, two = sign * left - first, sign * right - last
            if one * two < 0.0:
                at = start + width * (one / (one - two))
                if min(at - start, stop - at) > CUT_TOLERANCE * after:
                    cuts.insert(1 if at < cuts[1][0] else 2, (at, sign * bound * (after - at)))
        for (low, at_low), (high, at_high) in zip(cuts, cuts[1:], strict=False):
            if not high > low:
                continue
            trial, limit = 0.5 * (at_low + at_high), bound * (after - 0.5 * (low + high))
            if abs(trial) < limit * (1.0 - BOUND_TOLERANCE):
                self.pieces.append(_SpringPiece(low, high, at_low, at_high, 0))
                self._spend(low, high, (at_low, at_high), (at_low, at_high) if came else None)
                continue
            side = 1 if trial > 0.0 else -1
            ends = bound * (after - low), bound * (after - high)
            self.pieces.append(_SpringPiece(low, high, side * ends[0], side * ends[1], side))
            slid = max(side * at_low - ends[0], 0.0), max(side * at_high - ends[1], 0.0)
            # the bound of a coming spring grows from zero
            self._lose(low, high, slid, (0.5 * ends[0], 0.5 * ends[1]) if came else self._mean(side, slid, ends))
            self._spend(low, high, (at_low, at_high), (side * ends[0], side * ends[1]) if came else None)
            if not came:
                self._yield(low, high, side, slid)

    def leave(self, start: float, stop: float, left: float, right: float) -> None:
        """Let springs go: they slide back until nothing presses them, or fall back at once if nothing slides."""
        per = self.change / self.rise
        # displaced by so much when they lose contact, had they stuck until then
        left, right = left + (start - self.before) * per, right + (stop - self.before) * per
        if math.isinf(self.bound):
            self._lose(start, stop, (left, right), (0.5 * left, 0.5 * right))
            self._part(start, stop, left, right)
            return
        cuts = [(start, left), (stop, right)]
        if left * right < 0.0:
            cuts.insert(1, (start + (stop - start) * (left / (left - right)), 0.0))
        for (low, at_low), (high, at_high) in zip(cuts, cuts[1:], strict=False):
            side = 1 if at_low + at_high > 0.0 else -1
            slid = max(side * at_low, 0.0), max(side * at_high, 0.0)
            self._lose(low, high, slid, self._mean(side, slid, (0.0, 0.0)))
            self._part(low, high, at_low, at_high)
            self._yield(low, high, side, slid)

    def _mean(self, side: int, slid: tuple[float, float], ends: tuple[float, float]) -> tuple[float, float]:
        """Return the mean bound of springs that start to slide in a step, from how far they slide and how they end."""
        # the bound changes in proportion to the distance that is slid
        closing = side * self.change - self.bound * self.rise
        share = 0.5 * self.bound * self.rise / closing if closing > 0.0 else 0.0
        return ends[0] - share * slid[0], ends[1] - share * slid[1]

    def _spend(self, start: float, stop: float, trial: Ends, came: Ends | None) -> None:
        """Note the work on springs that stick and end at `trial`; those that `came` to where they are began at rest."""
        if came is not None:
            self._work(start, stop, trial, (0.5 * came[0], 0.5 * came[1]))
        else:
            half = 0.5 * self.change
            self._work(start, stop, (self.change, self.change), (trial[0] - half, trial[1] - half))

    def _part(self, start: float, stop: float, left: float, right: float) -> None:
        """Note the work on springs that stick until they part, where they are displaced by `left` to `right`."""
        if self.account:
            per = self.change / self.rise
            step = (start - self.before) * per, (stop - self.before) * per
            self._work(start, stop, step, (left - 0.5 * step[0], right - 0.5 * step[1]))

    def _yield(self, start: float, stop: float, side: int, slid: Ends) -> None:
        """Take away from the work what springs that slide at last do not resist any more."""
        closing = side * self.change - self.bound * self.rise
        if closing > 0.0:
            share = -0.5 * side * self.change / closing
            self._work(start, stop, slid, (share * slid[0], share * slid[1]))

    def _work(self, start: float, stop: float, one: Ends, other: Ends) -> None:
        """Note a work that is a product of two straight lines over the gap."""
        if self.account and stop > start:
            self.works.append(_product(start, stop, one, other))

    def _lose(self, start: float, stop: float, slid: tuple[float, float], mean: tuple[float, float]) -> None:
        """Note the loss of springs: sliding length times mean bound, both straight over the gap."""
        if not stop > start or (slid[0] == 0.0 and slid[1] == 0.0):
            return
        self.losses.append(_product(start, stop, slid, mean))


def _product(start: float, stop: float, first: Ends, second: Ends) -> LossPiece:
    """Return the product of two straight lines between two gaps."""
    if stop - start < LEAST_DEPTH:  # a flat end may still be among them
        return LossPiece(start, stop, first[0] * second[0], 0.0, 0.0)
    one, two = (first[0] - first[1]) / (stop - start), (second[0] - second[1]) / (stop - start)
    return LossPiece(start, stop, first[1] * second[1], one * second[1] + two * first[1], one * two)


def _remembered(depth: float, pieces: list[_SpringPiece]) -> SlipMemory:
    """Return the memory of pieces in a row, those that go on in one straight line as one."""
    result: list[_SpringPiece] = []
    for piece in pieces:
        if result and result[-1].slides == piece.slides:
            last = result[-1]
            before = (last.right - last.left) / (last.stop - last.start)
            behind = (piece.right - piece.left) / (piece.stop - piece.start)
            high = max(abs(last.left), abs(last.right), abs(piece.left), abs(piece.right))
            straight = piece.slides != 0 or abs(behind - before) <= SLOPE_TOLERANCE * max(abs(before), abs(behind))
            if straight and abs(piece.left - last.right) <= SLOPE_TOLERANCE * high:
                result[-1] = last._replace(stop=piece.stop, right=piece.right)
                continue
        result.append(piece)
    edges = np.array([piece.start for piece in result[:1]] + [piece.stop for piece in result] or [0.0])
    left, right, slides = (np.array([piece[k] for piece in result], dtype=float) for k in (2, 3, 4))
    return SlipMemory(depth, edges, left, right, slides)
