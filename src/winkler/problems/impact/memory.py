r"""What the stuck springs of a contact remember, when depth and shift follow any smooth curve.

A stuck spring moves with the bodies, :math:`u = U + h(\gamma)`, and begins to slide towards the side :math:`\sigma`
when :math:`\sigma u` reaches :math:`\beta(d-\gamma)`, that is when the level

.. math:: A_\sigma = \sigma U - \beta d \quad\text{reaches}\quad \alpha_\sigma(\gamma) = -\sigma h(\gamma)-\beta\gamma .

:math:`\alpha_\sigma` never rises with :math:`\gamma`: sliding sets in at the edge and advances inwards.  Springs
that have slid and stick again remember a straight line; springs that came into contact while all others stuck remember
the shift at that moment, :math:`h(\gamma)=-U(t_\gamma)`, and then :math:`\alpha_\sigma(\gamma)=A_\sigma(t_\gamma)`:
the level itself at that moment.
"""

from __future__ import annotations

from bisect import bisect_left
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.normal.force_curve import NormalCurve

__all__ = ["NO_HISTORY", "EnteredSprings", "RecalledPoint", "SlidSprings", "Stuck", "ring"]

NEWTON_STEPS = 60
NARROW_RING = 0.1
"""Part of the depth below which a ring of springs is summed by itself, lest nothing be left of it by rounding."""


class RecalledPoint(NamedTuple):
    """How far the springs stick, and sums over those that do.

    Parameters
    ----------
    gap : float
        The gap c of the last stuck spring [m].
    first, second : float
        The integrals of h dK [N] and h^2 dK [J] over the stuck springs.
    stiffness, force, work : float
        K [N/m], F [N] and W [J] at the depth c.
    """

    gap: float
    first: float
    second: float
    stiffness: float
    force: float
    work: float


NO_HISTORY = RecalledPoint(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class SpringRing(NamedTuple):
    """Sums over the springs from a gap to a depth: of d - gap [N], and of its square [J]."""

    linear: float
    square: float


def ring(curve: NormalCurve, inner: RecalledPoint, depth: float) -> SpringRing:
    """Return the sums over the springs beyond those that stick."""
    wide = depth - inner.gap
    if wide < NARROW_RING * depth:
        return SpringRing(*curve.between(inner.gap, inner.stiffness, depth))
    _, force, work = curve.at(depth)
    linear = force - inner.force - wide * inner.stiffness
    square = 2.0 * (work - inner.work) - wide * (2.0 * inner.force + wide * inner.stiffness)
    return SpringRing(linear, square)


class SlidSprings(NamedTuple):
    """Springs that have slid and stick again since a depth d1 and a shift U1: h = sign beta (d1 - gap) - U1.

    Parameters
    ----------
    sign : int
        The side to which they slid.
    depth, shift : float
        d1 and U1 [m].
    beta : float
        Slope of the bound of their displacement over the depth.
    start : Recalled
        What the springs within remember, up to the first of these.
    """

    sign: int
    depth: float
    shift: float
    beta: float
    start: RecalledPoint

    def highest(self, sign: int) -> float:
        """Return the level at which all of them slide to a side."""
        gap = self.start.gap
        if sign == self.sign:
            return sign * self.shift - self.beta * self.depth
        return sign * self.shift + self.beta * (self.depth - 2.0 * gap)

    def excess(self, sign: int, shift: float, depth: float, time: float) -> float:
        """Return how far the edge is displaced towards a side, if these springs stuck up to there [m]."""
        return sign * (shift - self.shift + self.sign * self.beta * (self.depth - depth))

    def front(self, sign: int, level: float, depth: float, curve: NormalCurve) -> RecalledPoint:
        """Return what sticks when the level towards a side is reached."""
        start = self.start
        gap = depth
        if sign != self.sign:
            low = 0.5 * ((sign * self.shift - level) / self.beta + self.depth)
            gap = min(max(low, start.gap), depth)
        stiffness, force, work = curve.at(gap)
        end = RecalledPoint(gap, 0.0, 0.0, stiffness, force, work)
        whole, rest = ring(curve, start, self.depth), ring(curve, end, self.depth)
        slope, gain = self.sign * self.beta, stiffness - start.stiffness
        linear, square = slope * (whole.linear - rest.linear), slope * slope * (whole.square - rest.square)
        first = start.first + linear - self.shift * gain
        second = start.second + square - 2.0 * self.shift * linear + self.shift * self.shift * gain
        return RecalledPoint(gap, first, second, stiffness, force, work)


class EnteredSprings(NamedTuple):
    """Springs that came into contact while all others stuck.

    Parameters
    ----------
    times : list of float
        Ends of the steps of the march [s].
    steps : ndarray, (steps, 4, degree + 1)
        Depth [m], shift [m], shear force [N] and stored energy [J] in powers of
        the place within each step, from -1 to 1.
    ratio, beta : float
        Tangential over normal stiffness; slope of the bound of the displacement over the depth.
    turn : float
        When the depth is greatest [s]: it is the same as long before as after.
    """

    times: list[float]
    steps: Array
    ratio: float
    beta: float
    turn: float

    def read(self, time: float) -> tuple[float, float, float, float]:
        """Return depth, shift, shear force and stored energy at a time within."""
        step = min(max(bisect_left(self.times, time), 1), len(self.times) - 1) - 1
        start, end = self.times[step], self.times[step + 1]
        place = (2.0 * time - start - end) / (end - start)
        depth, shift, shear, stored = (self.steps[step] @ place ** np.arange(self.steps.shape[2])).tolist()
        return depth, shift, shear, stored

    def highest(self, sign: int) -> float:
        """Return the level at which all of them slide to a side."""
        depth, shift, _, _ = self.read(self.times[0])
        return sign * shift - self.beta * depth

    def excess(self, sign: int, shift: float, depth: float, time: float) -> float:
        """Return how far the edge is displaced towards a side, if these springs stuck up to there [m]."""
        earlier = 2.0 * self.turn - time
        if earlier >= self.times[-1]:
            # further out springs have slid: there the displacement is on its bound
            end, start, _, _ = self.read(self.times[-1])
            return sign * (shift - start) + self.beta * max(depth - end, 0.0)
        return sign * (shift - self.read(max(earlier, self.times[0]))[1])

    def front(self, sign: int, level: float, depth: float, curve: NormalCurve) -> RecalledPoint:
        """Return what sticks when the level towards a side is reached."""
        time = self._when(sign, level)
        gap, shift, shear, stored = self.read(time)
        gap = max(gap, 0.0)  # less than nothing, by rounding at first touch, would let go of a flat end at once
        stiffness, force, work = curve.at(gap)
        first = shear / self.ratio - shift * stiffness
        second = 2.0 * stored / self.ratio - shift * shift * stiffness - 2.0 * shift * first
        return RecalledPoint(gap, first, second, stiffness, force, work)

    def _when(self, sign: int, level: float) -> float:
        """Return when the level, which fell all the time, was as low as now."""
        powers = sign * self.steps[:, 1] - self.beta * self.steps[:, 0]
        signs = np.where(np.arange(powers.shape[1]) % 2 == 0, 1.0, -1.0)
        ends = np.append(powers @ signs, np.sum(powers[-1]))
        if level >= ends[0]:
            return self.times[0]
        if level <= ends[-1]:
            return self.times[-1]
        step = min(int(np.searchsorted(-ends, -level)), len(powers)) - 1
        part = 0.5 + 0.5 * _root(powers[step].tolist(), level)
        return self.times[step] + part * (self.times[step + 1] - self.times[step])


Stuck = SlidSprings | EnteredSprings
"""What springs may remember."""


def _root(powers: list[float], level: float) -> float:
    """Return where a falling polynomial on (-1, 1) meets a level: Newton's steps, halving where they lead astray."""
    low, high, x = -1.0, 1.0, 0.0
    for _ in range(NEWTON_STEPS):
        height, slope = powers[-1], 0.0
        for power in powers[-2::-1]:
            slope = slope * x + height
            height = height * x + power
        low, high = (x, high) if height > level else (low, x)
        new = x - (height - level) / slope if slope else low - 1.0
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - x) <= 4e-16:
            return new
        x = new
    return x
