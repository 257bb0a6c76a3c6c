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

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.friction.straight_step import (
    BOUND_TOLERANCE,
    LEAST_DEPTH,
    LossPiece,
    SpringPiece,
    StraightStep,
)
from winkler.values import value, words

__all__ = ["LossPiece", "SlipMemory"]

SLOPE_TOLERANCE = 1e-13
"""Pieces that meet, and whose slopes differ by less than this part of the slopes there are, become one."""


FEW = 8
"""Pieces that are dragged one by one."""


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
        staying = self._staying(depth, change, bound)
        step = self._step(depth, change, bound, account=False, first=staying)
        rest = _remembered(step.after, step.pieces)
        if staying:
            rest = SlipMemory(
                rest.depth,
                np.concatenate([self.edges[:staying], rest.edges]),
                np.concatenate([self.left[:staying] + change, rest.left]),
                np.concatenate([self.right[:staying] + change, rest.right]),
                np.concatenate([self.slides[:staying], rest.slides]),
            )
        return rest, tuple(step.losses)

    def worked(
        self, depth: float, change: float, bound: float
    ) -> tuple[SlipMemory, tuple[LossPiece, ...], tuple[LossPiece, ...]]:
        """Return as `moved`, and what the bodies have spent on the springs, which does not go by what these keep."""
        step = self._step(depth, change, bound, account=True)
        return _remembered(step.after, step.pieces), tuple(step.losses), tuple(step.works)

    def _staying(self, depth: float, change: float, bound: float) -> int:
        """Return how many pieces next to the middle stuck before the step and are dragged as a whole, but for one."""
        if math.isinf(bound) or self.left.size < FEW:
            return 0
        free = self.edges[1:] <= min(self.depth, depth)
        for gap, ends in ((self.edges[:-1], self.left), (self.edges[1:], self.right)):
            free &= np.abs(ends + change) < bound * (depth - gap) * (1.0 - BOUND_TOLERANCE)
        free &= self.slides == 0.0
        return max((self.left.size if free.all() else int(np.argmin(free))) - 1, 0)

    def _step(self, depth: float, change: float, bound: float, *, account: bool, first: int = 0) -> StraightStep:
        if 0.0 < depth < LEAST_DEPTH:
            depth = 0.0
        step = StraightStep(self.depth, depth, change, bound, account)
        common = max(min(self.depth, depth), 0.0)
        edges, ends = self.edges[first:].tolist(), (self.left[first:].tolist(), self.right[first:].tolist())
        for start, stop, left, right in zip(edges, edges[1:], *ends, strict=False):
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


def _remembered(depth: float, pieces: list[SpringPiece]) -> SlipMemory:
    """Return the memory of pieces in a row, those that go on in one straight line as one."""
    result: list[SpringPiece] = []
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
