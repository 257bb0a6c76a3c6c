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
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.marching import IntegratedStates, StopCondition
from winkler.numerics.types import Array
from winkler.problems.impact.memory import NO_HISTORY, EnteredSprings, RecalledPoint, SlidSprings, Stuck, ring
from winkler.problems.impact.motion import ImpactMoment, ImpactProblem, Stage, integrate, integrate_stuck, stuck_stage
from winkler.values.errors import NotConverged

__all__ = ["stages"]

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
    raise NotConverged(f"Impact: sticking and sliding have taken turns {MOST_STAGES} times; give fewer waves.")


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
