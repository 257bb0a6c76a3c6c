"""The motion of a body that strikes: its moments, its stages, and how it goes on while all springs stick."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.marching import IntegratedStates, StopCondition, integrate_to_stop
from winkler.numerics.types import Array
from winkler.problems.normal.force_curve import NormalCurve

PRECISION = 3e-14
"""Relative error allowed per step."""


class ImpactProblem(NamedTuple):
    """What moves, and on which springs.

    Parameters
    ----------
    curve : NormalCurve
    depth : float
        The greatest depth [m].
    mass : float
        [kg].
    mobility : float
        kappa [1/kg].
    velocity, sliding : float
        v and w at first touch [m/s].
    ratio : float
        rho, tangential over normal stiffness of the springs.
    coefficient : float
        mu; infinite where nothing slides.
    """

    curve: NormalCurve
    depth: float
    mass: float
    mobility: float
    velocity: float
    sliding: float
    ratio: float
    coefficient: float

    def beta(self) -> float:
        """mu / rho, by which the bound of the displacement rises with the depth."""
        return self.coefficient / self.ratio

    def scales(self) -> Array:
        """What is large for d, v, U, w, the loss, the shear force and the stored energy."""
        time = self.depth / self.velocity
        climb = self.beta() if math.isfinite(self.coefficient) else 0.0
        # where springs slide by little, it is the difference of two large lengths and known to their rounding
        sliding = max(abs(self.sliding), 1e-3 * self.velocity * max(1.0, climb))
        energy = 0.5 * sliding**2 / self.mobility
        return np.array(
            [self.depth, self.velocity, sliding * time, sliding, energy, sliding / (self.mobility * time), energy]
        )


class ImpactMoment(NamedTuple):
    """One moment of the contact.

    Parameters
    ----------
    depth, velocity, shift, sliding_velocity, dissipation, force, shear_force, energy, stored_energy : float
        As in `winkler.problems.impact.states.ImpactState`.
    stuck : float
        The gap up to which springs stick [m].
    """

    depth: float
    velocity: float
    shift: float
    sliding_velocity: float
    dissipation: float
    force: float
    shear_force: float
    energy: float
    stored_energy: float
    stuck: float


class Stage(NamedTuple):
    """A stretch of time over which the same springs slide towards the same side, or none.

    Parameters
    ----------
    start, end : float
        [s].
    sign : int
        The side to which the edge slides; zero where all stick.
    moment : Callable
        Time -> ImpactMoment.
    """

    start: float
    end: float
    sign: int
    moment: Callable[[float], ImpactMoment]


def integrate(
    motion: ImpactProblem,
    rates: Callable[[float, Array], list[float]],
    span: tuple[float, float],
    start: Array,
    stops: list[StopCondition],
) -> IntegratedStates:
    """Integrate the motion from a state at the beginning of a span of time [s], to its end or to one of the stops."""
    unit, scales = motion.depth / motion.velocity, motion.scales()[: start.size]
    return integrate_to_stop(rates, span, start, unit=unit, precision=PRECISION, scales=scales, stops=stops)


def turning(motion: ImpactProblem) -> float:
    """Return when the depth is greatest [s]."""

    def rates(time: float, state: Array) -> list[float]:
        return [state[1], -motion.curve.at(state[0])[1] / motion.mass]

    longest = 2.0 * motion.depth / motion.velocity  # the force never falls with the depth
    stopped = StopCondition(lambda time, state: state[1], -1)
    integrated = integrate(motion, rates, (0.0, longest), np.array([0.0, motion.velocity]), [stopped])
    return integrated.end


def integrate_stuck(
    motion: ImpactProblem, span: tuple[float, float], start: Array, stops: list[StopCondition]
) -> IntegratedStates:
    """Integrate while all springs stick: d, v, U, w, loss, shear force and stored energy."""
    mass, ratio, mobility = motion.mass, motion.ratio, motion.mobility

    def rates(time: float, state: Array) -> list[float]:
        depth, velocity, _, sliding, _, shear, _ = state.tolist()
        stiffness, force, _ = motion.curve.at(depth)
        return [velocity, -force / mass, sliding, -mobility * shear, 0.0, ratio * stiffness * sliding, shear * sliding]

    return integrate(motion, rates, span, start, stops)


def stuck_stage(motion: ImpactProblem, integrated: IntegratedStates) -> Stage:
    """Return the stage in which all springs stick."""

    def moment(time: float) -> ImpactMoment:
        depth, velocity, shift, sliding, loss, shear, stored = integrated.at(time).tolist()
        _, force, pressed = motion.curve.at(depth)
        return ImpactMoment(depth, velocity, shift, sliding, loss, force, shear, pressed, stored, depth)

    return Stage(float(integrated.times[0]), integrated.end, 0, moment)
