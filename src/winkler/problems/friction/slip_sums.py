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

from winkler.problems.friction.slip_memory import LossPiece, SlipMemory, SlipRing, WorkedStep

__all__ = ["NormalStates", "SlipSums"]

MOST_GAPS = 256
"""Gaps and rings that are remembered at most."""
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
        self._points: dict[float, Moments] = {0.0: (0.0, 0.0, 0.0)}
        self._rings: dict[tuple[float, float], Moments] = {}

    def at(self, gap: float) -> Moments:
        """Return K, F and W at a gap [m]; nothing at zero, where a flat end comes into contact at once."""
        sums = self._points.get(gap)
        if sums is None:
            if len(self._points) > MOST_GAPS:
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
            if len(self._rings) > MOST_GAPS:  # a long march must not remember every gap it has met
                self._rings.clear()
            self._rings[start, stop] = sums
        return sums

    def within(self, outermost: SlipRing | None) -> Moments:
        """Return the sums of 1 [N/m], of u_t [N] and of u_t^2 [J] over a stack, u_t counted from that on the axis."""
        missing = []
        while outermost is not None and (outermost.sums is None or outermost.sums[0] is not self):
            missing.append(outermost)
            outermost = outermost.inner
        sums = outermost.sums[1] if outermost is not None and outermost.sums is not None else (0.0, 0.0, 0.0)
        for ring in reversed(missing):
            start, stop, left, right, _ = ring.piece
            zeroth, first, second = self.ring(start, stop)
            slope, last = (left - right) / (stop - start), right - ring.axis
            sums = (
                sums[0] + zeroth,
                sums[1] + last * zeroth + slope * first,
                sums[2] + last * last * zeroth + slope * (2.0 * last * first + slope * second),
            )
            ring.sums = self, sums
        return sums

    def shear(self, memory: SlipMemory) -> float:
        """Return the integral of u_t dK [N]: the shear force over the ratio."""
        zeroth, first, _ = self.within(memory.outermost)
        return first + memory.on_axis * zeroth

    def stored(self, memory: SlipMemory) -> float:
        """Return half the integral of u_t^2 dK [J]: the stored energy over the ratio."""
        zeroth, first, second = self.within(memory.outermost)
        middle = memory.on_axis
        return 0.5 * (second + middle * (2.0 * first + middle * zeroth))

    def spent(self, step: WorkedStep, change: float) -> float:
        """Return the work of the bodies in a step [J], over the ratio: springs that stick as a whole resist evenly."""
        zeroth, first, _ = self.within(step.staying.outermost)
        return self.lost(step.works) + change * (first + (step.staying.on_axis + 0.5 * change) * zeroth)

    def lost(self, losses: Iterable[LossPiece]) -> float:
        """Return what sliding has cost [J], over the ratio."""
        total = 0.0
        for start, stop, constant, linear, square in losses:
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
        ring = memory.outermost
        while ring is not None and not (ring.stuck and ring.piece.stop <= common):
            start, stop = ring.piece.start, ring.piece.stop
            if ring.piece.slides == 0:
                if start < common:
                    total += self.ring(start, min(stop, common))[0]
                if stop > common:
                    # springs that came within the step take part in what was left of it
                    zeroth, first, _ = self.ring(max(start, common), stop)
                    total += (zeroth * (memory.depth - stop) + first) / (memory.depth - before)
            ring = ring.inner
        return total + self.within(ring)[0]
