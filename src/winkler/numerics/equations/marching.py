"""Ordinary differential equations from event to event, with time counted in a unit of its own.

Events are searched for to the rounding of numbers of the order of one; what lasts a nanosecond must not be counted in
seconds.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_RATES = 200_000
ZERO_SUBSTITUTE = 1e-300
"""Given for zero: to start from a condition is not to pass it."""

Condition = Callable[[float, Array], float]
"""A function of time and state that is zero where something happens."""


class StopCondition(NamedTuple):
    """A condition that ends a march when it passes zero, rising (1) or falling (-1); touching is not passing."""

    condition: Condition
    direction: int


class IntegratedStates(NamedTuple):
    """A stretch of time that was marched through.

    Parameters
    ----------
    times : ndarray, (steps + 1,)
        Ends of the steps [s].
    last : ndarray, (n,)
        The state at the end.
    stopped : tuple of bool
        Which conditions ended it; none if it went through to the end.
    unit : float
        Of the time that `dense` takes [s].
    dense : Callable
        The state at any time within, in that unit; polynomials of degree 7 in every step.
    """

    times: Array
    last: Array
    stopped: tuple[bool, ...]
    unit: float
    dense: Any

    @property
    def end(self) -> float:
        """When it ended [s]."""
        return float(self.times[-1])

    def at(self, time: Array | float) -> Array:
        """Return the state at a time [s], or at times ``(m,)`` as ``(n, m)``."""
        return np.asarray(self.dense(np.asarray(time) / self.unit))


def integrate_to_stop(
    rates: Callable[[float, Array], Sequence[float]],
    span: tuple[float, float],
    start: Array,
    *,
    unit: float,
    precision: float,
    scales: Array,
    stops: Sequence[StopCondition] = (),
) -> IntegratedStates:
    """March from a state until the span is over, or the first condition passes zero.

    Parameters
    ----------
    rates
        Time [s] and state to the rates of the state [per s].
    span : tuple of float
        Start and end [s].
    start : ndarray, (n,)
    unit : float
        A time in which something happens [s].
    precision : float
        Relative error allowed per step; a hundredth of it, of `scales`, where a quantity is small.
    scales : ndarray, (n,)
        What is large for each quantity.
    stops : sequence of Stop

    Raises
    ------
    NotConverged
        If it hardly moves on.
    """
    from scipy.integrate import solve_ivp

    calls = itertools.count()

    def scaled(time: float, state: Array) -> list[float]:
        if next(calls) > MOST_RATES:
            raise NotConverged(
                f"The integration has reached {time * unit:.6g} s and hardly advances: stiffness, velocities or "
                "friction differ by too many orders of magnitude; leave out what hardly counts."
            )
        return [unit * rate for rate in rates(time * unit, state)]

    solution = solve_ivp(
        scaled,
        (span[0] / unit, span[1] / unit),
        start,
        method="DOP853",
        rtol=precision,
        atol=1e-2 * precision * scales,
        dense_output=True,
        events=[_event(stop, unit) for stop in stops],
    )
    if solution.status < 0:
        raise NotConverged(f"At {solution.t[-1] * unit:.6g} s the integration stopped: {solution.message}")
    stopped = tuple(bool(times.size) for times in solution.t_events) if stops else ()
    times = solution.t * unit
    times[0] = span[0]
    if solution.status == 0:
        times[-1] = span[1]
    return IntegratedStates(times, solution.y[:, -1], stopped, unit, solution.sol)


def _event(stop: StopCondition, unit: float) -> Condition:
    condition, direction = stop

    def passed(time: float, state: Array) -> float:
        return condition(time * unit, state) or -direction * ZERO_SUBSTITUTE

    passed.terminal = True  # type: ignore[attr-defined]
    passed.direction = direction  # type: ignore[attr-defined]
    return passed
