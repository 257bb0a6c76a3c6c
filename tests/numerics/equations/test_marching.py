"""Marching from event to event: exact roots in any unit of time, refusals, and starts that touch a condition."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.numerics.equations.marching import StopCondition, integrate_to_stop
from winkler.values.errors import NotConverged


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e9])
def test_an_oscillator_stops_where_it_turns(unit):
    """x'' = -x in any unit: it comes to rest after pi/2, and is back after pi."""
    rate = 1.0 / unit

    def rates(time, state):
        return [rate * state[1], -rate * state[0]]

    common = {"unit": unit, "precision": 1e-13, "scales": np.ones(2)}
    rest = StopCondition(lambda time, state: state[1], -1)
    back = StopCondition(lambda time, state: state[0], -1)
    quarter = integrate_to_stop(rates, (0.0, 100.0 * unit), np.array([0.0, 1.0]), stops=(rest, back), **common)
    assert quarter.stopped == (True, False)
    assert quarter.end / unit == pytest.approx(math.pi / 2, rel=1e-12)
    np.testing.assert_allclose(quarter.at(quarter.end), [1.0, 0.0], atol=1e-12)
    half = integrate_to_stop(rates, (quarter.end, 100.0 * unit), quarter.last, stops=(back,), **common)
    assert half.stopped == (True,)
    assert half.times[0] == quarter.end
    assert half.end / unit == pytest.approx(math.pi, rel=1e-12)


def test_a_span_is_gone_through_exactly():
    gone = integrate_to_stop(
        lambda time, state: [1.0], (0.1, 0.7), np.zeros(1), unit=1.0 / 3.0, precision=1e-10, scales=np.ones(1)
    )
    assert (gone.times[0], gone.end, gone.stopped) == (0.1, 0.7, ())
    np.testing.assert_allclose(gone.at(np.array([0.1, 0.4])), [[0.0, 0.3]], atol=1e-14)


def test_to_start_from_a_condition_is_not_to_pass_it():
    """The speed is zero at first: that does not end a fall."""
    ground = StopCondition(lambda time, state: state[0] + 1.0, -1)
    stands = StopCondition(lambda time, state: state[1], 1)
    fell = integrate_to_stop(
        lambda time, state: [state[1], -2.0],
        (0.0, 10.0),
        np.zeros(2),
        unit=1.0,
        precision=1e-12,
        scales=np.ones(2),
        stops=(ground, stands),
    )
    assert fell.stopped == (True, False)
    assert fell.end == pytest.approx(1.0, rel=1e-12)


@pytest.mark.slow
def test_what_never_ends_is_given_up():
    with pytest.raises(NotConverged, match="hardly advances"):
        integrate_to_stop(
            lambda time, state: [math.sin(1e12 * time)],
            (0.0, 1.0),
            np.zeros(1),
            unit=1.0,
            precision=1e-13,
            scales=np.full(1, 1e-20),
        )
