r"""The memory of the springs of a sheared contact, distinguished by their gap instead of their place.

The springs of a rising profile can be numbered by :math:`\gamma=g(x)`, from 0 on the axis to the depth d at the edge.
On a straight step in depth and shift a spring that sticks is displaced by the shift, one that slides stays on its bound
:math:`\beta(d-\gamma)`, and one that comes into contact begins within the step.  All of that is linear in
:math:`\gamma`, so the displacement of the springs stays a chain of straight pieces for ever, one for each turning point
that is not yet forgotten: no grid, and no error but rounding.  What the pieces add up to is computed by
`winkler.problems.friction.slip_sums`.

Slip begins at the edge: in a row of pieces the inner ones stick while the outer ones slide.  So pieces are stacked from
the axis outwards, and a step replaces those at the edge alone.  What sticks is dragged as a whole: it is the same stack
before and after, displaced by one number, and all states of a path share it.  A path costs what its steps replace.
"""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple, Protocol

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.friction.straight_step import (
    BOUND_TOLERANCE,
    LEAST_DEPTH,
    Moments,
    SpringPiece,
    StraightStep,
)
from winkler.values.value import words

__all__ = ["MovedMemory", "SlipMemory", "SlipRing", "StackSums"]

SLOPE_TOLERANCE = 1e-13
"""Pieces that meet, and whose slopes differ by less than this part of the slopes there are, become one."""
ROUNDING = 1e-15
"""Of a displacement, relative to how far the stack was dragged."""


class SlipRing:
    """A piece on top of those within it, displaced by so much beyond the stack as a whole; it never changes.

    Parameters
    ----------
    inner : SlipRing or None
        The pieces within it.
    piece : SpringPiece
        Springs in a row.
    """

    __slots__ = ("axis", "count", "inner", "piece", "stuck", "sums")

    def __init__(self, inner: SlipRing | None, piece: SpringPiece) -> None:
        self.inner, self.piece = inner, piece
        self.axis: float = piece.left if inner is None else inner.axis
        """The displacement of the innermost spring [m]."""
        self.count: int = 1 if inner is None else inner.count + 1
        """How many pieces there are from the axis to here."""
        self.stuck: bool = piece.slides == 0 and (inner is None or inner.stuck)
        """Whether all of them stick."""
        self.sums: tuple[object, Moments] | None = None
        """What they add up to, and who has added it up (`winkler.problems.friction.slip_sums`)."""

    def __reduce__(self) -> tuple[object, ...]:  # a long stack is deeper than Python's calls may be
        return _stacked, (tuple(outwards(self)),)

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return isinstance(other, SlipRing) and self.count == other.count and outwards(self) == outwards(other)

    def __hash__(self) -> int:
        return hash((self.count, self.piece))


def outwards(outermost: SlipRing | None, until: SlipRing | None = None) -> list[SpringPiece]:
    """Return the pieces beyond one of them, in the order of their gaps."""
    pieces = []
    while outermost is not None and outermost is not until:
        pieces.append(outermost.piece)
        outermost = outermost.inner
    return pieces[::-1]


def _stacked(pieces: tuple[SpringPiece, ...]) -> SlipRing | None:
    ring = None
    for piece in pieces:
        ring = SlipRing(ring, piece)
    return ring


class StackSums(Protocol):
    """What springs add up to, with which the energies of a step are summed."""

    def ring(self, start: float, stop: float) -> Moments:
        """Return the sums of 1 [N/m], of stop - gap [N] and of its square [J] over the springs between two gaps."""
        ...

    def within(self, outermost: SlipRing | None) -> Moments:
        """Return the sums of 1 [N/m], of u_t [N] and of u_t^2 [J] over a stack, u_t counted from that on the axis."""
        ...


class MovedMemory(NamedTuple):
    """What a straight step does.

    Parameters
    ----------
    memory : SlipMemory
        After it.
    lost, work : float
        What sliding has cost, and what the bodies have spent [J], over the ratio of stiffnesses; not a number unless
        they are summed.
    """

    memory: SlipMemory
    lost: float
    work: float


@dataclasses.dataclass(frozen=True)
class SlipMemory:
    """The sideways displacement of the springs over their gap, in straight pieces.

    Parameters
    ----------
    depth : float
        d [m]; below zero the bodies are apart.
    dragged : float
        How far the stack of pieces was dragged as a whole [m].
    outermost : SlipRing or None
        The stack: the piece at the edge, with those within it.
    """

    __words__ = words(
        stick_gap=(r"\gamma_c", "m", "gap of the outermost spring that sticks"),
        corners=("", None, "depths and factors of the contacts that add up to the displacement"),
        edges=(r"\gamma_j", "m", "gaps at which the straight pieces of the displacement meet"),
        left=("u_t", "m", "displacement of the springs where a piece begins"),
        right=("u_t", "m", "displacement of the springs where a piece ends"),
        on_axis=("u_t", "m", "displacement of the spring that touches first"),
        slides=(r"\sigma", "", "side to which springs slide: 1, -1, or 0 if they stick"),
        dragged=("", "m", "how far the pieces of the displacement were dragged together"),
        outermost=("", None, "the piece at the edge, with those within it"),
        size=("m", None, "how many straight pieces the displacement has"),
    )

    depth: float
    dragged: float = 0.0
    outermost: SlipRing | None = None

    @classmethod
    def fresh(cls) -> SlipMemory:
        """Return what is remembered by bodies that have not met."""
        return cls(0.0)

    @property
    def size(self) -> int:
        """How many pieces there are."""
        return self.outermost.count if self.outermost is not None else 0

    @property
    def edges(self) -> Array:
        """Where the pieces meet: gaps from 0 to the depth [m], (m + 1,)."""
        return np.array([0.0, *(piece.stop for piece in outwards(self.outermost))])

    @property
    def left(self) -> Array:
        """u_t where each piece begins [m], (m,)."""
        return np.array([piece.left for piece in outwards(self.outermost)]) + self.dragged

    @property
    def right(self) -> Array:
        """u_t where each piece ends [m], (m,)."""
        return np.array([piece.right for piece in outwards(self.outermost)]) + self.dragged

    @property
    def slides(self) -> Array:
        """Whether the springs of a piece are on their bound: on which side (+1, -1), else 0, (m,)."""
        return np.array([float(piece.slides) for piece in outwards(self.outermost)])

    @property
    def on_axis(self) -> float:
        """u_t of the spring that touches first [m]; zero without contact."""
        return self.outermost.axis + self.dragged if self.outermost is not None else 0.0

    @property
    def stick_gap(self) -> float:
        """Gap of the outermost spring that is not on its bound [m]; zero if all are."""
        ring = self.outermost
        while ring is not None and ring.piece.slides != 0:
            ring = ring.inner
        return ring.piece.stop if ring is not None else 0.0

    def value(self, gap: Array) -> Array:
        """u_t [m] of the springs of given gaps [m]; zero outside the contact."""
        gap = np.asarray(gap, dtype=float)
        inside = _along(outwards(self.outermost), gap) + (self.dragged if self.outermost is not None else 0.0)
        return np.where((gap <= self.depth) & (gap >= 0.0), inside, 0.0)

    def apart(self, other: SlipMemory) -> float:
        """Return by how much the displacement of a spring differs at most [m], but for those of a common stack."""
        one, two = self.outermost, other.outermost
        while one is not two:
            if two is None or (one is not None and one.count >= two.count):
                one = one.inner if one is not None else None
            else:
                two = two.inner
        rows = [outwards(memory.outermost, one) for memory in (self, other)]
        gaps = np.array(sorted({edge for row in rows for piece in row for edge in (piece.start, piece.stop)}))
        if not gaps.size:
            return 0.0
        ends = [
            np.where(gaps <= memory.depth, _along(row, gaps) + memory.dragged, 0.0) if row else np.zeros(gaps.size)
            for memory, row in zip((self, other), rows, strict=True)
        ]
        return float(np.max(np.abs(ends[0] - ends[1])))

    def moved(self, depth: float, change: float, bound: float, sums: StackSums | None = None) -> MovedMemory:
        """Return the memory after a straight step, and its energies.

        Parameters
        ----------
        depth : float
            d at the end of the step [m].
        change : float
            By how much the bodies shift in the step [m].
        bound : float
            beta = mu E* / G* [-]: a spring of gap gamma slides at u_t = beta (d - gamma); infinite if none ever does.
        sums : StackSums, optional
            With which energies are summed: the work does not go by what the springs keep.

        Returns
        -------
        MovedMemory
        """
        if 0.0 < depth < LEAST_DEPTH:
            depth = 0.0
        step = StraightStep(self.depth, depth, change, bound, sums.ring if sums is not None else None)
        common = max(min(self.depth, depth), 0.0)
        sticking = math.inf if math.isinf(bound) else bound * (1.0 - BOUND_TOLERANCE)
        ring, dragged = self.outermost, self.dragged + change
        outer: list[SpringPiece] = []
        while ring is not None:
            piece = ring.piece
            if (
                ring.stuck
                and piece.stop <= common
                and abs(piece.right + dragged) < sticking * (depth - piece.stop)
                and abs(piece.left + dragged) < sticking * (depth - piece.start)
            ):
                break
            outer.append(piece)
            ring = ring.inner
        for piece in reversed(outer):
            start, stop = piece.start, piece.stop
            left, right = piece.left + self.dragged, piece.right + self.dragged
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
        lost, work = (step.lost, step.work) if sums is not None else (math.nan, math.nan)
        if ring is None:
            dragged = 0.0
        elif sums is not None:  # springs that stick as a whole resist evenly
            zeroth, first, _ = sums.within(ring)
            work += change * (first + (ring.axis + self.dragged + 0.5 * change) * zeroth)
        return MovedMemory(SlipMemory(depth, dragged, _joined(ring, dragged, step.pieces)), lost, work)

    @property
    def corners(self) -> tuple[Array, Array]:
        """Depths [m] and factors of the normal contacts whose springs add up to u_t: the sum of B (gamma_j - gamma)+.

        Jumps of u_t, which only springs that never slide can have, are not among them.
        """
        edges = self.edges
        slope = (self.right - self.left) / np.diff(edges)
        return edges[1:], np.diff(np.append(slope, 0.0))


def _along(row: list[SpringPiece], gap: Array) -> Array:
    """Return what straight pieces are at gaps [m]."""
    if not row:
        return np.zeros(gap.shape)
    edges = np.array([row[0].start, *(piece.stop for piece in row)])
    left, right = (np.array([piece[k] for piece in row]) for k in (2, 3))
    place = np.clip(np.searchsorted(edges, gap, side="right") - 1, 0, left.size - 1)
    share = (gap - edges[place]) / (edges[place + 1] - edges[place])
    return np.asarray(left[place] * (1.0 - share) + right[place] * share)


def _joined(ring: SlipRing | None, dragged: float, pieces: list[SpringPiece]) -> SlipRing | None:
    """Return the stack with more pieces on it [m], those that go on in one straight line as one."""
    for piece in pieces:
        if ring is not None and ring.piece.slides == piece.slides:
            last = ring.piece
            before = (last.right - last.left) / (last.stop - last.start)
            behind = (piece.right - piece.left) / (piece.stop - piece.start)
            ends = last.left + dragged, last.right + dragged, piece.left, piece.right
            allowed = SLOPE_TOLERANCE * max(map(abs, ends)) + ROUNDING * abs(dragged)
            straight = piece.slides != 0 or abs(behind - before) <= SLOPE_TOLERANCE * max(abs(before), abs(behind))
            if straight and abs(piece.left - dragged - last.right) <= allowed:
                ring = SlipRing(
                    ring.inner, SpringPiece(last.start, piece.stop, last.left, piece.right - dragged, piece.slides)
                )
                continue
        left, right = piece.left - dragged, piece.right - dragged
        ring = SlipRing(ring, SpringPiece(piece.start, piece.stop, left, right, piece.slides))
    return ring
