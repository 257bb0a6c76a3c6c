r"""A straight step in depth and shift, and what it does to springs that are numbered by their gap.

A spring that sticks is displaced by the shift, one that slides stays on its bound :math:`\beta(d-\gamma)`, and one that
comes into contact begins within the step: all linear in the gap, piece by piece.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

__all__ = ["BOUND_TOLERANCE", "LEAST_DEPTH", "Moments", "RingSums", "SpringPiece", "StraightStep"]

LEAST_DEPTH = 1e-150
"""Depths below this [m] are none, and springs whose gaps differ by less lose alike: their squares are no numbers."""
BOUND_TOLERANCE = 1e-12
"""A spring that is displaced by all but this part of its bound slides."""
CUT_TOLERANCE = 1e-14
"""A cut this close to the end of a piece, in parts of the depth, is at the end."""


Ends = tuple[float, float]
"""What a straight line over the gap is at both ends of a piece."""
Moments = tuple[float, float, float]
"""Sums over springs of 1 [N/m], of a length [N] and of its square [J]."""
RingSums = Callable[[float, float], Moments]
"""The moments of the springs between two gaps, of their distance from the outer one."""
Springs = tuple[float, Moments]
"""How far the gaps of springs are from each other [m], and their moments."""


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
    """A straight step in depth and shift, and its effect on the springs.

    Parameters
    ----------
    before, after : float
        d at its beginning and its end [m].
    change : float
        By how much the bodies shift [m].
    bound : float
        beta [-].
    ring : RingSums or None
        With which energies are summed; without it they are left out.

    Attributes
    ----------
    pieces : list of SpringPiece
        The springs after the step.
    lost, work : float
        What sliding has cost, and what the bodies have spent on these springs [J], over the ratio of stiffnesses.
    """

    def __init__(self, before: float, after: float, change: float, bound: float, ring: RingSums | None) -> None:
        self.before, self.after, self.change, self.bound, self.ring = before, after, change, bound, ring
        self.rise = after - before
        self.pieces: list[SpringPiece] = []
        self.lost = self.work = 0.0

    def drag(self, start: float, stop: float, left: float, right: float, *, came: bool = False) -> None:
        """Move springs of which those that tried to be displaced by more than their bound slide."""
        if math.isinf(self.bound):
            self._stick(start, stop, (left, right), came)
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
        for (low, at_low), (high, at_high) in pairwise(cuts):
            if not high > low:
                continue
            trial, limit = 0.5 * (at_low + at_high), bound * (after - 0.5 * (low + high))
            if abs(trial) < limit * (1.0 - BOUND_TOLERANCE):
                self._stick(low, high, (at_low, at_high), came)
                continue
            side = 1 if trial > 0.0 else -1
            ends = bound * (after - low), bound * (after - high)
            borne = side * ends[0], side * ends[1]
            self.pieces.append(SpringPiece(low, high, *borne, side))
            if self.ring is not None:
                springs = high - low, self.ring(low, high)
                self._spend(springs, (at_low, at_high), borne if came else None)
                slid = max(side * at_low - ends[0], 0.0), max(side * at_high - ends[1], 0.0)
                self._slide(springs, side, slid, ends, came)

    def leave(self, start: float, stop: float, left: float, right: float) -> None:
        """Let springs go: they slide back until nothing presses them, or fall back at once if nothing slides."""
        if self.ring is None or not stop > start:
            return
        per = self.change / self.rise
        begin, end = (start - self.before) * per, (stop - self.before) * per
        # displaced by so much when they lose contact, had they stuck until then
        left, right = left + begin, right + end
        springs = stop - start, self.ring(start, stop)
        self.work += _product(springs, (begin, end), (left - 0.5 * begin, right - 0.5 * end))
        if math.isinf(self.bound):
            self.lost += _product(springs, (left, right), (0.5 * left, 0.5 * right))
            return
        cuts = [(start, left), (stop, right)]
        if left * right < 0.0:
            cuts.insert(1, (start + (stop - start) * (left / (left - right)), 0.0))
        for (low, at_low), (high, at_high) in pairwise(cuts):
            if high > low:
                side = 1 if at_low + at_high > 0.0 else -1
                slid = max(side * at_low, 0.0), max(side * at_high, 0.0)
                self._slide((high - low, self.ring(low, high)), side, slid, (0.0, 0.0), False)

    def _stick(self, start: float, stop: float, ends: Ends, came: bool) -> None:
        """Keep springs that stick."""
        self.pieces.append(SpringPiece(start, stop, *ends, 0))
        if self.ring is not None:
            self._spend((stop - start, self.ring(start, stop)), ends, ends if came else None)

    def _spend(self, springs: Springs, trial: Ends, came: Ends | None) -> None:
        """Add the work on springs that stick and end at `trial`; those that `came` to where they are began at rest."""
        if came is not None:
            self.work += _product(springs, trial, (0.5 * came[0], 0.5 * came[1]))
        elif self.change != 0.0:
            half = 0.5 * self.change
            self.work += _product(springs, (self.change, self.change), (trial[0] - half, trial[1] - half))

    def _slide(self, springs: Springs, side: int, slid: Ends, ends: Ends, came: bool) -> None:
        """Add the loss of springs that slide until they bear `ends`, and take from the work what they do not resist."""
        if slid[0] == 0.0 and slid[1] == 0.0:
            return
        if came:  # the bound of a coming spring grows from zero
            self.lost += _product(springs, slid, (0.5 * ends[0], 0.5 * ends[1]))
            return
        # the bound changes in proportion to the distance that is slid
        closing = side * self.change - self.bound * self.rise
        share = 0.5 * self.bound * self.rise / closing if closing > 0.0 else 0.0
        self.lost += _product(springs, slid, (ends[0] - share * slid[0], ends[1] - share * slid[1]))
        if closing > 0.0:
            self.work -= 0.5 * side * self.change / closing * _product(springs, slid, slid)


def _product(springs: Springs, first: Ends, second: Ends) -> float:
    """Return the sum over springs of the product of two straight lines over their gap."""
    width, (zeroth, linear, square) = springs
    if width < LEAST_DEPTH:  # a flat end may still be among them
        return first[0] * second[0] * zeroth
    one, two = (first[0] - first[1]) / width, (second[0] - second[1]) / width
    return first[1] * second[1] * zeroth + (one * second[1] + two * first[1]) * linear + one * two * square
