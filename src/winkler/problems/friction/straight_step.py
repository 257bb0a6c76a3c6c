r"""A straight step in depth and shift, and what it does to springs that are numbered by their gap.

A spring that sticks is displaced by the shift, one that slides stays on its bound :math:`\beta(d-\gamma)`, and one that
comes into contact begins within the step: all linear in the gap, piece by piece.
"""

from __future__ import annotations

import math
from typing import NamedTuple

__all__ = ["BOUND_TOLERANCE", "LEAST_DEPTH", "LossPiece", "SpringPiece", "StraightStep"]

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


class SpringPiece(NamedTuple):
    """Springs in a row whose displacement is a straight line over the gap.

    Parameters
    ----------
    start, stop : float
        Their gaps [m].
    left, right : float
        u_t at both ends [m].
    slides : int
        Whether they are on their bound: on which side (+1, -1), else 0.
    """

    start: float
    stop: float
    left: float
    right: float
    slides: int


class StraightStep:
    """A straight step in depth and shift, and its effect on the springs."""

    def __init__(self, before: float, after: float, change: float, bound: float, account: bool) -> None:
        self.before, self.after, self.change, self.bound, self.account = before, after, change, bound, account
        self.rise = after - before
        self.works: list[LossPiece] = []
        self.pieces: list[SpringPiece] = []
        self.losses: list[LossPiece] = []

    def drag(self, start: float, stop: float, left: float, right: float, *, came: bool = False) -> None:
        """Move springs of which those that tried to be displaced by more than their bound slide."""
        if math.isinf(self.bound):
            self.pieces.append(SpringPiece(start, stop, left, right, 0))
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
                self.pieces.append(SpringPiece(low, high, at_low, at_high, 0))
                self._spend(low, high, (at_low, at_high), (at_low, at_high) if came else None)
                continue
            side = 1 if trial > 0.0 else -1
            ends = bound * (after - low), bound * (after - high)
            self.pieces.append(SpringPiece(low, high, side * ends[0], side * ends[1], side))
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
