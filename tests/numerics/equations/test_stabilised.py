"""Steps for systems that damp: second order, stable as far as stated, and with the right estimate of their error."""

import math

import numpy as np
import pytest

from winkler.numerics.equations.stabilised import longest, stages_for, step, step_error


@pytest.mark.parametrize("stages", [2, 5, 20])
def test_the_order_is_two(stages):
    # y' = -y^2, y = 1 / (1 + t)
    misses = []
    for count in (4, 8, 16):
        y = np.ones(1)
        for _ in range(count):
            y = step(lambda z: -z * z, y, -y * y, 1.0 / count, stages)
        misses.append(abs(float(y[0]) - 0.5))
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.8)


@pytest.mark.parametrize("stages", [2, 7, 40, 100])
def test_a_step_is_stable_as_far_as_it_says(stages):
    length = longest(stages, 1.0)
    assert stages_for(length, 1.0) in (stages, stages + 1)
    decays = -np.linspace(0.0, 1.0, 2001)
    once = step(lambda z: decays * z, np.ones(decays.size), decays, length, stages)
    assert np.max(np.abs(once)) <= 1.0 + 1e-12
    assert longest(stages, 0.0) == math.inf


def test_the_error_is_estimated():
    y, length = np.ones(1), 0.2
    end = step(lambda z: -z, y, -y, length, 3)
    stated = abs(float(step_error(y, end, -y, -end, length)[0]))
    true = abs(float(end[0]) - math.exp(-length))
    assert 0.2 * true < stated < 20.0 * true
