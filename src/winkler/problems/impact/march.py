r"""The march of an oblique impact: stages of sticking and sliding, each as exact as its integrator.

With the approach :math:`v=\dot d`, the velocity of the touching points :math:`w=\dot U` and their mobility
:math:`\kappa = 1/m+\ell^2/I`

.. math:: m\dot v = -F(d), \qquad \dot w = -\kappa F_x, \qquad
          F_x = \varrho\Bigl[U K(c) + \int_0^c h\,\mathrm dK\Bigr]
                + \sigma\mu\int_c^d (d-\gamma)\,\mathrm dK .

Springs up to the gap c stick, those beyond slide towards the side :math:`\sigma`; their bound moves with
:math:`\beta v`, so all slide at :math:`\sigma w-\beta v>0`.  When that vanishes, they stick: all of them while the
bodies still approach, otherwise sliding towards the other side begins at the edge at once.  Because the normal motion
is its own mirror image, the end of contact is known beforehand.

What the stuck springs of a contact remember, when depth and shift follow any smooth curve.

A stuck spring moves with the bodies, :math:`u = U + h(\gamma)`, and begins to slide towards the side :math:`\sigma`
when :math:`\sigma u` reaches :math:`\beta(d-\gamma)`, that is when the level

.. math:: A_\sigma = \sigma U - \beta d \quad\text{reaches}\quad \alpha_\sigma(\gamma) = -\sigma h(\gamma)-\beta\gamma .

:math:`\alpha_\sigma` never rises with :math:`\gamma`: sliding sets in at the edge and advances inwards.  Springs
that have slid and stick again remember a straight line; springs that came into contact while all others stuck remember
the shift at that moment, :math:`h(\gamma)=-U(t_\gamma)`, and then :math:`\alpha_\sigma(\gamma)=A_\sigma(t_\gamma)`:
the level itself at that moment.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.marching import IntegratedStates, StopCondition
from winkler.numerics.types import Array
from winkler.problems.impact.motion import ImpactMoment, ImpactProblem, Stage, integrate, integrate_stuck, stuck_stage
from winkler.problems.normal.force_curve import NormalCurve
from winkler.values.errors import NotConverged

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


DEGREE = 7
"""Of the integrator's own interpolation within a step."""
MOST_STAGES = 1000
NODES = np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
POWERS = np.linalg.inv(np.vander(NODES, increasing=True))


def stages(motion: ImpactProblem, turn: float) -> Iterator[Stage]:
    """Yield the stages of an impact, from first touch to the end of contact.

    Parameters
    ----------
    motion : ImpactProblem
    turn : float
        When the depth is greatest [s].

    Raises
    ------
    NotConverged
        If the integrator gives up.
    """
    if math.isinf(motion.coefficient) or motion.sliding == 0.0:
        return _without_slip(motion, turn)
    return _with_slip(motion, turn)


def _entered(motion: ImpactProblem, integrated: IntegratedStates, turn: float) -> EnteredSprings:
    """Return what springs remember that came into contact while all stuck."""
    times = integrated.times
    places = 0.5 * (times[:-1] + times[1:])[:, None] + 0.5 * np.diff(times)[:, None] * NODES
    values = integrated.at(places.ravel())[[0, 2, 5, 6]].reshape(4, *places.shape)
    return EnteredSprings(times.tolist(), np.moveaxis(values @ POWERS.T, 0, 1), motion.ratio, motion.beta(), turn)


def _with_slip(motion: ImpactProblem, turn: float) -> Iterator[Stage]:
    beta, end = motion.beta(), 2.0 * turn
    time, state = 0.0, np.array([0.0, motion.velocity, 0.0, motion.sliding, 0.0])
    memory: list[Stuck] = []
    excess = abs(motion.sliding) - beta * motion.velocity
    # at the limit the force decides: it slows the sliding by kappa mu F, and the growth of the bound by beta F / m
    slides = excess > 0.0 or (excess == 0.0 and motion.mobility * motion.ratio < 1.0 / motion.mass)
    sign = int(np.sign(motion.sliding)) if slides else 0
    shear = stored = 0.0
    for _ in range(MOST_STAGES):
        if sign == 0:
            forward = StopCondition(lambda time, y: y[3] - beta * y[1], 1)
            backward = StopCondition(lambda time, y: y[3] + beta * y[1], -1)
            integrated = integrate_stuck(motion, (time, turn), np.array([*state, shear, stored]), [forward, backward])
            if integrated.end > time:
                yield stuck_stage(motion, integrated)
                memory.append(_entered(motion, integrated, turn))
            time, state = integrated.end, integrated.last[:5]
            ahead, back = integrated.stopped
            # where the bodies turn back before anything slides, those that part next slide as the points move
            sign = int(ahead) - int(back) or int(np.sign(state[3])) or -int(np.sign(integrated.last[5])) or 1
            continue
        while memory and sign * state[2] - beta * state[0] >= memory[-1].highest(sign):
            memory.pop()
        slip = _Slip(motion, sign, memory[-1] if memory else None, turn)
        integrated = slip.march(time, turn if time < turn else end, state)
        if integrated.end > time:
            yield Stage(time, integrated.end, sign, slip.reader(integrated))
        time, state = integrated.end, integrated.last
        stopped, eaten, passed = integrated.stopped
        if not any(integrated.stopped) and time == end:
            return
        last = slip.recall(state)
        if eaten:
            memory.pop()
            while memory and isinstance(memory[-1], SlidSprings) and memory[-1].sign == sign:
                memory.pop()
        elif passed:
            sign = -sign
        elif stopped:
            shear, stored = slip.shear(state, last)
            if last.gap < state[0]:
                memory.append(SlidSprings(sign, float(state[0]), float(state[2]), beta, last))
            sign = 0 if time < turn else -sign
    raise NotConverged(f"Impact: stick and slip have alternated {MOST_STAGES} times; give fewer waves.")


class _Slip(NamedTuple):
    """The edge slides towards a side, over springs of which the last ones remember `stuck`."""

    motion: ImpactProblem
    sign: int
    stuck: Stuck | None
    turn: float

    def level(self, state: Array) -> float:
        return float(self.sign * state[2] - self.motion.beta() * state[0])

    def recall(self, state: Array) -> RecalledPoint:
        if self.stuck is None:
            return NO_HISTORY
        return self.stuck.front(self.sign, self.level(state), float(state[0]), self.motion.curve)

    def shear(self, state: Array, inner: RecalledPoint) -> tuple[float, float]:
        """Return shear force and stored energy."""
        motion, shift = self.motion, float(state[2])
        linear, square = ring(motion.curve, inner, float(state[0]))
        force = motion.ratio * (shift * inner.stiffness + inner.first) + self.sign * motion.coefficient * linear
        inside = shift * shift * inner.stiffness + 2.0 * shift * inner.first + inner.second
        return force, 0.5 * motion.ratio * (inside + motion.beta() ** 2 * square)

    def march(self, time: float, end: float, start: Array) -> IntegratedStates:
        motion, sign, stuck = self.motion, self.sign, self.stuck
        beta, mass, mobility = motion.beta(), motion.mass, motion.mobility

        def rates(time: float, state: Array) -> list[float]:
            depth, velocity, shift, sliding, _ = state.tolist()
            inner = self.recall(state)
            slid = sign * motion.coefficient * ring(motion.curve, inner, depth).linear
            shear = motion.ratio * (shift * inner.stiffness + inner.first) + slid
            force = motion.curve.at(depth)[1]
            return [velocity, -force / mass, sliding, -mobility * shear, slid * (sliding - sign * beta * velocity)]

        def eaten(time: float, state: Array) -> float:
            return -1.0 if stuck is None else self.level(state) - stuck.highest(sign)

        def passed(time: float, state: Array) -> float:
            if stuck is None or time <= self.turn:
                return 1.0
            return stuck.excess(sign, float(state[2]), float(state[0]), time)

        stops = [
            StopCondition(lambda time, state: sign * state[3] - beta * state[1], -1),
            StopCondition(eaten, 1),
            StopCondition(passed, -1),
        ]
        return integrate(motion, rates, (time, end), start, stops)

    def reader(self, integrated: IntegratedStates) -> Callable[[float], ImpactMoment]:
        def moment(time: float) -> ImpactMoment:
            state = integrated.at(time)
            depth, velocity, shift, sliding, loss = state.tolist()
            inner = self.recall(state)
            shear, stored = self.shear(state, inner)
            _, force, pressed = self.motion.curve.at(depth)
            return ImpactMoment(depth, velocity, shift, sliding, loss, force, shear, pressed, stored, inner.gap)

        return moment


def _without_slip(motion: ImpactProblem, turn: float) -> Iterator[Stage]:
    r"""All springs stick until they part; those of the gap d then lose what they have stored.

    With the displacement :math:`\delta` of the springs at the edge the loss is
    :math:`\tfrac12\varrho\int\delta^2\mathrm dK`, integrated by parts because K may jump.
    """
    loaded = integrate_stuck(
        motion, (0.0, turn), np.array([0.0, motion.velocity, 0.0, motion.sliding, 0.0, 0.0, 0.0]), []
    )
    yield stuck_stage(motion, loaded)
    mass, ratio, mobility, curve = motion.mass, motion.ratio, motion.mobility, motion.curve
    sign = 0

    def edge(time: float, shift: float) -> tuple[float, Array]:
        earlier = loaded.at(max(2.0 * turn - time, 0.0))
        return shift - float(earlier[2]), earlier

    def rates(time: float, state: Array) -> list[float]:
        depth, velocity, shift, sliding, _ = state.tolist()
        displaced, earlier = edge(time, shift)
        stiffness, force, _ = curve.at(depth)
        shear = ratio * stiffness * displaced + float(earlier[5])
        lost = ratio * stiffness * displaced * (sliding + float(earlier[3]))
        return [velocity, -force / mass, sliding, -mobility * shear, lost]

    parted = integrate(motion, rates, (turn, 2.0 * turn), loaded.last[:5], [])

    def moment(time: float) -> ImpactMoment:
        depth, velocity, shift, sliding, loss = parted.at(time).tolist()
        displaced, earlier = edge(time, shift)
        stiffness, force, pressed = curve.at(depth)
        stretch = 0.5 * ratio * stiffness * displaced**2
        before = float(earlier[6]) + float(earlier[5]) * displaced
        shear = ratio * stiffness * displaced + float(earlier[5])
        return ImpactMoment(
            depth, velocity, shift, sliding, loss - stretch, force, shear, pressed, before + stretch, depth
        )

    yield Stage(turn, 2.0 * turn, sign, moment)
