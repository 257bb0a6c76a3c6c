r"""One spring under a contact that is pressed and pushed in harmonic motion: what it loses in a closed cycle.

.. math:: d = d_0 + A_z\cos n\theta,\qquad U = A_x\cos(m\theta+\varphi),\qquad 0\le\theta<2\pi .

A spring with the gap :math:`\gamma` is in contact while :math:`d>\gamma`; its displacement u follows U within the bound
:math:`|u|\le\beta(d-\gamma)` and slides along it.  Whether it *can* slide forward or back, at any moment, does not
depend on the spring: it needs :math:`\dot P>0` or :math:`\dot Q<0`, with

.. math:: P = U-\beta d,\qquad Q = U+\beta d .

Between the zeros of :math:`\dot P,\dot Q,\dot d` a step is therefore exact however curved the motion is: the spring
ends at its trial value or at the bound that this exceeds, and it began to slide where P (or Q) passed a known value.
Its loss per stiffness, :math:`\int\beta(d-\gamma)\,\mathrm dP` from there on, has a closed antiderivative.
"""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.values.value import value, words

UNIT_CIRCLE_TOLERANCE = 1e-3
"""How far from the unit circle a root still counts as a moment: one too many only splits a step in two."""

DISPLACEMENT_ROUNDING = 16.0 * np.finfo(float).eps
"""Part of the displacements that rounding may add to them."""


class _Slide(NamedTuple):
    """Springs that have slid in a step, forward (1) or back (-1): which, U less what they hold, from when to when."""

    direction: float
    which: Array
    base: Array
    begin: Array
    end: Array


@value
class SpringCycle:
    """Harmonic pressing and pushing of single springs.

    Parameters
    ----------
    depth_amplitude, shift_amplitude : float
        A_z and A_x [m].
    phase : float
        By which the push is ahead, in its own cycle [rad].
    normal_cycles, lateral_cycles : int
        n and m, without a common divisor.
    bound : float
        beta [-]: how far a spring is displaced when it begins to slide, over how far it is pressed.
    """

    __words__ = words(bound=(r"\beta", "", "displacement at which a spring slides, over how far it is pressed"))

    depth_amplitude: float
    shift_amplitude: float
    phase: float
    normal_cycles: int
    lateral_cycles: int
    bound: float

    def sunk(self, moment: Array) -> Array:
        """d - d_0 [m] at moments theta [rad]."""
        return np.asarray(self.depth_amplitude * np.cos(self.normal_cycles * moment))

    def moved(self, moment: Array) -> Array:
        """U [m]."""
        return np.asarray(self.shift_amplitude * np.cos(self.lateral_cycles * moment + self.phase))

    def forward(self, moment: Array) -> Array:
        """P but for a constant [m]."""
        return self.moved(moment) - self.bound * self.sunk(moment)

    def backward(self, moment: Array) -> Array:
        """Q but for a constant [m]."""
        return self.moved(moment) + self.bound * self.sunk(moment)

    def swept(self, moment: Array) -> Array:
        """Return the antiderivative of d - d_0 over U [m^2]."""
        n, m = self.normal_cycles, self.lateral_cycles
        apart = -moment * np.sin(self.phase) if n == m else np.cos((m - n) * moment + self.phase) / (m - n)
        both = np.cos((m + n) * moment + self.phase) / (m + n)
        return np.asarray(0.5 * m * self.shift_amplitude * self.depth_amplitude * (both + apart))

    @property
    def moments(self) -> Array:
        """When a spring may begin or cease to slide, and when the depth turns: from 0 to 2 pi [rad]."""
        n = self.normal_cycles
        turning = np.arange(2 * n + 1) * np.pi / n
        turning_points = [self._turning(sign) for sign in (-1.0, 1.0)]
        return np.unique(np.concatenate([turning, *turning_points]))

    def _turning(self, sign: float) -> Array:
        """Return the zeros of U' + sign beta d' as the roots, on the unit circle, of a polynomial in exp(i theta)."""
        n, m = self.normal_cycles, self.lateral_cycles
        middle = max(n, m)
        terms = np.zeros(2 * middle + 1, dtype=complex)
        for order, strength, phase in (
            (m, m * self.shift_amplitude, self.phase),
            (n, sign * self.bound * n * self.depth_amplitude, 0.0),
        ):
            terms[middle + order] += strength * np.exp(1j * phase)
            terms[middle - order] -= strength * np.exp(-1j * phase)
        if not np.any(terms):
            return np.zeros(0)
        roots = np.roots(terms[::-1])
        angles = np.angle(roots[np.abs(np.abs(roots) - 1.0) < UNIT_CIRCLE_TOLERANCE])
        return np.asarray(np.mod(angles, 2.0 * np.pi))

    def loss(self, gap: Array) -> Array:
        """Return what springs lose in a closed cycle, from the second on.

        Parameters
        ----------
        gap : ndarray, (k,)
            gamma - d_0 [m].

        Returns
        -------
        ndarray, (k,)
            Loss over tangential stiffness [m^2].
        """
        moments = self.moments
        # pressed straight down to the greatest depth at first; a first cycle forgets that
        displaced = np.zeros(gap.shape)
        for start, stop in itertools.pairwise(moments):
            displaced, _ = self._step(gap, displaced, start, stop)
        lost = np.zeros(gap.shape)
        for start, stop in itertools.pairwise(moments):
            displaced, slides = self._step(gap, displaced, start, stop)
            for slide in slides:
                lost[slide.which] += self._spent(slide, gap[slide.which])
        return lost

    def released(self, gap: Array) -> Array:
        """Return what springs that never slide lose when they lose contact, over tangential stiffness [m^2].

        Parameters
        ----------
        gap : ndarray, (k,)
            gamma - d_0 [m].
        """
        n, m = self.normal_cycles, self.lateral_cycles
        share = math.sin(self.phase) ** 2 * n if n <= 2 else 0.5 * n
        span = self.depth_amplitude
        if span == 0.0:
            return np.zeros(gap.shape)
        touching = np.arccos(np.clip(gap / span, -1.0, 1.0))
        never = (gap <= -span) | (gap >= span)
        lost = 2.0 * share * self.shift_amplitude**2 * np.sin(m * touching / n) ** 2
        return np.where(never, 0.0, lost)

    def _step(self, gap: Array, displaced: Array, start: float, stop: float) -> tuple[Array, list[_Slide]]:
        """Return the springs' displacements after a step, and which of them have slid."""
        ends = self.sunk(np.array([start, stop]))
        before, after = gap < ends[0], gap < ends[1]
        result = np.zeros(gap.shape)
        touching = np.flatnonzero(before | after)
        if not touching.size:
            return result, []
        g, before, after = gap[touching], before[touching], after[touching]
        passing = self._crossing(g, start, stop)
        begin, end = np.where(before, start, passing), np.where(after, stop, passing)
        base = self.moved(begin) - np.where(before, displaced[touching], 0.0)
        trial = self.moved(end) - base
        limit = np.where(after, self.bound * (ends[1] - g), 0.0)
        result[touching] = np.clip(trial, -limit, limit)
        # a spring that returns to its place has not slid, apart from rounding
        threshold = limit + DISPLACEMENT_ROUNDING * (self.shift_amplitude + self.bound * self.depth_amplitude)
        ahead, behind = np.flatnonzero(trial > threshold), np.flatnonzero(trial < -threshold)
        return result, [
            _Slide(direction, touching[index], base[index], begin[index], end[index])
            for direction, index in ((1.0, ahead), (-1.0, behind))
            if index.size
        ]

    def _crossing(self, gap: Array, start: float, stop: float) -> Array:
        """Return when d passes gamma within a step in which d only rises or only falls."""
        n = self.normal_cycles
        half = np.floor(0.5 * (start + stop) * n / np.pi)
        angle = (
            np.arccos(np.clip(gap / self.depth_amplitude, -1.0, 1.0)) if self.depth_amplitude else np.zeros(gap.shape)
        )
        place = half * np.pi + angle if half % 2 == 0 else (half + 1.0) * np.pi - angle
        return np.asarray(np.clip(place / n, start, stop))

    def _spent(self, slide: _Slide, gap: Array) -> Array:
        """Return the losses of springs that slide from some moment of their step on."""
        direction = slide.direction
        driver = self.forward if direction > 0.0 else self.backward
        target = slide.base - direction * self.bound * gap

        def ahead(moment: Array, index: Array) -> Array:
            return np.asarray(direction * (driver(moment) - target[index]))

        every = np.arange(gap.size)
        hit = np.where(ahead(slide.end, every) > 0.0, slide.begin, slide.end)
        inner = np.flatnonzero((ahead(slide.begin, every) < 0.0) & (hit < slide.end))
        if inner.size:
            hit[inner] = between(lambda moment, index: ahead(moment, inner[index]), hit[inner], slide.end[inner])
        over = self.swept(slide.end) - self.swept(hit) - gap * (self.moved(slide.end) - self.moved(hit))
        along = 0.5 * self.bound * ((self.sunk(slide.end) - gap) ** 2 - (self.sunk(hit) - gap) ** 2)
        lost: Array = self.bound * (direction * over - along)
        return np.maximum(lost, 0.0)
