r"""Springs distinguished by their gap under a steady depth: a whole history at once, by its turning points.

Their bound falls with the gap, :math:`b=\beta(d-\gamma)`, so that those which slide are an outer ring, and histories
are those of `winkler.problems.ring_slip.steady_path`, with the gap in the place of the radius.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import SlipMemory, SlipPieces
from winkler.problems.friction.slip_stack import new_piece
from winkler.problems.normal.force_curve import GAUSS_POINTS, GAUSS_WEIGHTS, NormalCurve
from winkler.problems.ring_slip.steady_path import Moved, Plays, chunks
from winkler.problems.ring_slip.torsion_pieces import TurnHistory

__all__ = ["GapPlays", "turned_memories"]

NARROW = 1.0 / 16.0
"""Part of the depth within which the rings beside the edge are summed by K alone, lest nothing be left by rounding."""
SEARCHED = 0.5 * (1.0 - np.cos(np.linspace(0.0, np.pi, 34)[1:]))
"""Amplitudes over the greatest, between which that of a force is sought."""


class GapPlays(Plays):
    """The springs of one depth; amplitudes in m, and loads twice the shear force [N].

    Parameters
    ----------
    curve : NormalCurve
        The frictionless contact, to that depth at least.
    depth : float
        d [m], positive.
    beta, ratio : float
        Bound over d - gap [-], positive and finite; c_T/c_N [-].
    """

    def __init__(self, curve: NormalCurve, depth: float, beta: float, ratio: float) -> None:
        self._curve, self._beta, self._ratio = curve, beta, ratio
        self._edge = curve.at(depth)
        stiffness, force, work = self._edge
        whole = ratio * np.array([stiffness, beta * force, 2.0 * beta**2 * work])
        super().__init__(depth, whole, beta * depth * SEARCHED)

    def tails(self, front: Array) -> Array:
        """Return as `Plays.tails`."""
        parts = [self._tails(part) for part in chunks(front)]
        return np.concatenate(parts, axis=1) if parts else np.zeros((3, 0))

    def curve(self, amplitude: Array) -> Moved:
        """Return as `Plays.curve`."""
        front = np.where(amplitude < self._nodes[-1], np.maximum(self.rim - amplitude / self._beta, 0.0), 0.0)
        zeroth, first, second = self.tails(front)
        lost = np.maximum(amplitude * first - second, 0.0)
        stuck = self.whole[0] - zeroth
        return Moved(front, 2.0 * (amplitude * stuck + first), amplitude**2 * stuck + second + 2.0 * lost, lost)

    def _tails(self, front: Array) -> Array:
        read, width = self._curve.read, self.rim - front
        stiffness, force, work = self._edge
        inner = [read(front, which) for which in range(3)]
        first = force - inner[1] - width * inner[0]
        second = 2.0 * (work - inner[2]) - width * (2.0 * inner[1] + width * inner[0])
        panels = np.searchsorted(np.array(self._curve.edges), [front, np.full(front.shape, self.rim)], side="left")
        narrow = width < NARROW * self.rim
        some = np.flatnonzero(narrow & (panels[0] == panels[1]))
        half = 0.5 * width[some, None]
        rest = half * (1.0 - GAUSS_POINTS)
        excess = half * GAUSS_WEIGHTS * (read((self.rim - rest).ravel(), 0).reshape(rest.shape) - inner[0][some, None])
        first[some], second[some] = excess.sum(axis=1), 2.0 * (excess * rest).sum(axis=1)
        for each in np.flatnonzero(narrow & (panels[0] != panels[1])):
            first[each], second[each] = self._curve.between(float(front[each]), float(inner[0][each]), self.rim)
        tails = self._ratio * np.array([stiffness - inner[0], self._beta * first, self._beta**2 * second])
        # a flat end stands at no gap: where all slides it does, too
        return np.asarray(np.where(front > 0.0, np.maximum(tails, 0.0), self.whole[:, None]))


def turned_memories(depth: float, beta: float, history: TurnHistory) -> Iterator[SlipMemory]:
    """Yield what the springs remember at each point of a history; pieces within the last turn are shared.

    Parameters
    ----------
    depth, beta : float
        d [m], and bound over d - gap [-].
    history : TurnHistory
    """
    motions, fronts, branches = history.motion.tolist(), history.front.tolist(), history.branches
    pieces = SlipPieces()
    stack = pieces.columns
    kept: dict[int, int] = {}  # of the turns that are remembered, and of the point before

    def until(turn: int, front: float) -> int:
        """Return the pieces from the axis to a front within which nothing has slid after a turn; -1 is none."""
        if turn < 0:
            return new_piece(stack, -1, 0.0, front, 0.0, 0.0, 0) if front > 0.0 else -1
        return beyond(kept[turn], turn, front, 0)

    def beyond(within: int, turn: int, stop: float, slides: int) -> int:
        """Return pieces with another one, from the front of a turn on, which slid then."""
        start = fronts[turn]
        if not stop > start:
            return within
        bound, motion = branches.directions[turn] * beta, motions[turn]
        ends = bound * (depth - start) - motion, bound * (depth - stop) - motion
        return new_piece(stack, within, start, stop, *ends, slides)

    for point, (motion, head) in enumerate(zip(motions, branches.heads, strict=True)):
        while kept and next(reversed(kept)) > head:
            kept.popitem()
        last = kept[next(reversed(kept))] if kept else -1
        if pieces.crowded(last):  # of what is remembered the pieces of each turn are within those of the next
            pieces, number = pieces.alone(last)
            stack, kept = pieces.columns, {turn: number.get(piece, -1) for turn, piece in kept.items()}
        kept[point] = until(head, fronts[point])
        outermost = beyond(kept[point], point, depth, int(branches.directions[point]))
        yield SlipMemory(depth, motion, pieces, outermost)
