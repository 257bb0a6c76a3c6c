r"""What springs of which only the gap is known add up to: shear force, stored energy, and what sliding has cost.

Sums over springs are integrals over the stiffness :math:`K(\gamma)` of the frictionless contact pressed to the depth
:math:`\gamma`.  With its force F and its work W (:math:`F'=K`, :math:`W'=F`) those between two gaps are

.. math:: \int_a^b\mathrm dK = K_b-K_a ,\quad \int_a^b(b-\gamma)\,\mathrm dK = F_b-F_a-(b-a)K_a ,\quad
          \int_a^b(b-\gamma)^2\,\mathrm dK = 2(W_b-W_a)-2(b-a)F_a-(b-a)^2K_a :

whatever the shape, the solution needs its normal curve only.  What was straight over the gap is then summed exactly.
"""

from __future__ import annotations

from typing import Protocol

from winkler.problems.friction.slip_memory import SlipMemory, SlipRing
from winkler.problems.friction.straight_step import Moments

__all__ = ["NormalStates", "SlipSums"]

MOST_GAPS = 256
"""Gaps that are remembered at most."""
NARROW_RING = 2e-3
"""Part of its outer gap below which a ring of springs is summed by itself, lest nothing be left of it by rounding."""


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
    known : dict, optional
        What `states` has at depths that a path is known to go through.
    """

    def __init__(self, states: NormalStates, known: dict[float, Moments] | None = None) -> None:
        self.states, self._known = states, known or {}
        self._points: dict[float, Moments] = {0.0: (0.0, 0.0, 0.0)}

    def at(self, gap: float) -> Moments:
        """Return K, F and W at a gap [m]; nothing at zero, where a flat end comes into contact at once."""
        sums = self._points.get(gap)
        if sums is None:
            if len(self._points) > MOST_GAPS:
                self._points = {0.0: self._points[0.0]}
            sums = self._points[gap] = self._known.get(gap) or self.states.at(gap)
        return sums

    def ring(self, start: float, stop: float) -> Moments:
        """Return the sums of 1 [N/m], of stop - gap [N] and of its square [J] over the springs between two gaps."""
        zeroth, first, second = self.at(start)
        outer, width = self.at(stop), stop - start
        if width < NARROW_RING * stop and start > 0.0:
            return outer[0] - zeroth, *self.states.between(start, zeroth, stop)
        return (
            outer[0] - zeroth,
            outer[1] - first - width * zeroth,
            2.0 * (outer[2] - second) - width * (2.0 * first + width * zeroth),
        )

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
