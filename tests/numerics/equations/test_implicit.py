"""Implicit steps: order, stiffness, and rates with a kink."""

import math

import numpy as np
import pytest

from winkler.numerics.equations.implicit import implicit_step
from winkler.values.errors import NotConverged


class Chased:
    """y' = fast (level(y0) - y)+ for all but the first, which grows by itself: y0' = y0."""

    weights = np.ones(2)

    def __init__(self, fast):
        self.fast = fast

    def rates(self, state):
        return np.array([state[0], self.fast * max(state[0] - state[1], 0.0)])

    def slopes(self, state):
        if state[0] > state[1]:
            return np.array([True, True]), np.array([[1.0, 0.0], [self.fast, -self.fast]])
        return np.array([True, False]), np.array([[1.0, 0.0]])

    def guess(self, state, first, length):
        return np.array([state[0], max(state[0] - state[1], 0.0) / length])


def chased(fast, steps, end=1.0):
    system, state = Chased(fast), np.array([1.0, 0.0])
    rates = system.rates(state)
    for _ in range(steps):
        state, rates, _ = implicit_step(system, state, rates, end / steps)
    return state


def test_it_is_of_second_order():
    # y1' = 2 (exp(s) - y1), y1(0) = 0
    exact = np.array([math.e, 2.0 / 3.0 * (math.e - math.exp(-2.0))])
    coarse, fine = (np.abs(chased(2.0, steps) - exact) for steps in (20, 40))
    np.testing.assert_allclose(np.log2(coarse / fine), 2.0, atol=0.15)


def test_what_is_fast_follows_however_long_the_step():
    fast = 1e9
    exact = fast / (fast + 1.0) * math.e
    assert chased(fast, 40)[1] == pytest.approx(exact, rel=1e-4)


def test_the_error_of_what_has_settled_is_filtered():
    system, state, length = Chased(1e6), np.array([1.0, 1.0 - 3e-6]), 1e-3
    first = system.rates(state)
    end, last, error = implicit_step(system, state, first, length)
    # a rate that falls from 3 to 1, at once: both ends alone suggest a hundred times the error that is left
    raw = 0.8 * (state - end) + 0.4 * length * (first + last)
    assert abs(raw[1]) > 5e-4
    assert np.max(np.abs(error)) < 5e-6
    assert end[1] == pytest.approx(end[0] - 1e-6, abs=5e-6)


def test_a_stage_that_is_not_met_is_refused():
    class Wild(Chased):
        def slopes(self, state):
            return np.array([True, True]), np.array([[1.0, 0.0], [0.0, 1e3]])

    with pytest.raises(NotConverged, match="use a shorter one"):
        implicit_step(Wild(1e3), np.array([1.0, 0.0]), np.array([1.0, 1e3]), 1.0)
