r"""What springs of which only the gap is known add up to: shear force, stored energy, and what sliding has cost.

Sums over springs are integrals over the stiffness :math:`K(\gamma)` of the frictionless contact pressed to the depth
:math:`\gamma`.  With its force F and its work W (:math:`F'=K`, :math:`W'=F`) those between two gaps are

.. math:: \int_a^b\mathrm dK = K_b-K_a ,\quad \int_a^b(b-\gamma)\,\mathrm dK = F_b-F_a-(b-a)K_a ,\quad
          \int_a^b(b-\gamma)^2\,\mathrm dK = 2(W_b-W_a)-2(b-a)F_a-(b-a)^2K_a :

whatever the shape, the solution needs its normal curve only.  What was straight over the gap is then summed exactly.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from winkler.problems.friction.slip_memory import LossPiece, SlipMemory

__all__ = ["NormalStates", "SlipSums"]

FEWEST_GAPS, GAPS_PER_PIECE = 256, 8
"""Gaps that are remembered at most: so many, or so many for each piece of the longest memory."""
NARROW_RING = 2e-3
"""Part of its outer gap below which a ring of springs is summed by itself, lest nothing be left of it by rounding."""

Moments = tuple[float, float, float]


class NormalStates(Protocol):
    """The frictionless contact over its depth."""

    def at(self, depth: float) -> Moments:
        """Return K [N/m], F [N] and W [J] at a depth [m]."""
        ...

    def between(self, gap: float, stiffness: float, depth: float) -> tuple[float, float]:
        """Return the sums of d - gap [N] and of its square [J] over the springs from a gap to a depth."""
        ...


class SlipSums:
    """Sums over the springs of one bed, over the ratio of tangential to normal stiffness.

    Parameters
    ----------
    states : NormalStates
        The frictionless contact of that bed.
    """

    def __init__(self, states: NormalStates) -> None:
        self.states = states
        # the gaps at which pieces meet come back step after step
        self._points: dict[float, Moments] = {0.0: (0.0, 0.0, 0.0)}
        self._rings: dict[tuple[float, float], Moments] = {}
        self._most = FEWEST_GAPS

    def at(self, gap: float) -> Moments:
        """Return K, F and W at a gap [m]; nothing at zero, where a flat end comes into contact at once."""
        sums = self._points.get(gap)
        if sums is None:
            if len(self._points) > self._most:
                self._points = {0.0: self._points[0.0]}
            sums = self._points[gap] = self.states.at(gap)
        return sums

    def ring(self, start: float, stop: float) -> Moments:
        """Return the sums of 1 [N/m], of stop - gap [N] and of its square [J] over the springs between two gaps."""
        sums = self._rings.get((start, stop))
        if sums is None:
            inner, outer, width = self.at(start), self.at(stop), stop - start
            gain = outer[0] - inner[0]
            if width < NARROW_RING * stop and start > 0.0:
                sums = gain, *self.states.between(start, inner[0], stop)
            else:
                sums = (
                    gain,
                    outer[1] - inner[1] - width * inner[0],
                    2.0 * (outer[2] - inner[2]) - width * (2.0 * inner[1] + width * inner[0]),
                )
            if len(self._rings) > self._most:  # a long march must not remember every gap it has met
                self._rings.clear()
            self._rings[start, stop] = sums
        return sums

    def _expect(self, pieces: int) -> None:
        """Remember more gaps where many pieces come back step after step."""
        self._most = max(self._most, GAPS_PER_PIECE * pieces)

    def shear(self, memory: SlipMemory) -> float:
        """Return the integral of u_t dK [N]: the shear force over the ratio."""
        total = 0.0
        self._expect(memory.left.size)
        for start, stop, left, right in _rows(memory):
            zeroth, first, _ = self.ring(start, stop)
            total += right * zeroth + (left - right) / (stop - start) * first
        return total

    def stored(self, memory: SlipMemory) -> float:
        """Return half the integral of u_t^2 dK [J]: the stored energy over the ratio."""
        total = 0.0
        self._expect(memory.left.size)
        for start, stop, left, right in _rows(memory):
            zeroth, first, second = self.ring(start, stop)
            slope = (left - right) / (stop - start)
            total += right * right * zeroth + slope * (2.0 * right * first + slope * second)
        return 0.5 * total

    def lost(self, losses: Iterable[LossPiece]) -> float:
        """Return what sliding has cost, or what was spent [J], over the ratio."""
        total, pieces = 0.0, tuple(losses)
        self._expect(len(pieces))
        for start, stop, constant, linear, square in pieces:
            zeroth, first, second = self.ring(start, stop)
            total += constant * zeroth + linear * first + square * second
        return total

    def stiffness(self, memory: SlipMemory, before: float) -> float:
        """Return how the shear force after a step grows with the shift of that step, over the ratio [N/m].

        Parameters
        ----------
        memory : SlipMemory
            After the step.
        before : float
            Depth at its beginning [m].
        """
        common, total = max(min(before, memory.depth), 0.0), 0.0
        edges = memory.edges.tolist()
        for start, stop, side in zip(edges, edges[1:], memory.slides.tolist(), strict=False):
            if side != 0.0:
                continue
            if start < common:
                total += self.ring(start, min(stop, common))[0]
            if stop > common:
                # springs that came within the step take part in what was left of it
                zeroth, first, _ = self.ring(max(start, common), stop)
                total += (zeroth * (memory.depth - stop) + first) / (memory.depth - before)
        return total


def _rows(memory: SlipMemory) -> Iterable[tuple[float, float, float, float]]:
    edges = memory.edges.tolist()
    return zip(edges, edges[1:], memory.left.tolist(), memory.right.tolist(), strict=False)
