"""Stresses below maps of pressure, by closed forms of pixels, summed or convolved.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from film_tables import forget

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.Elastic(208e9, 0.3)


def hill(count: int) -> wk.SurfaceLoad:
    """The pressure of a ball with friction, on a map 1.1 times as wide as the contact."""
    x = 1.1 * ((np.arange(count) + 0.5) * 2.0 / count - 1.0)
    pressure = np.sqrt(np.maximum(1.0 - x[:, None] ** 2 - x**2, 0.0))
    return wk.SurfaceLoad(pressure, [2.2, 2.2], 0.1 * pressure)


def bench_stresses_at_one_depth(benchmark, below):
    solution = wk.MapStress(hill(256), STEEL).solve()
    found = benchmark.pedantic(solution.stresses_at_depth, (0.5,), rounds=5, warmup_rounds=1)
    assert math.isclose(float(np.min(found.zz_stress)), -0.8, rel_tol=1e-2)  # Hertz, on the axis
    below(0.6, "256 x 256 pixels under pressure and friction: all stresses and displacements at one depth")


def coated_ball() -> wk.Foundation:
    """A ball on a hard coating, at the onset of yield five times as wide as the coating is thick."""
    hard, steel = wk.Elastic(420e9, 0.3, strength=1e9), wk.Elastic(210e9, 0.3, strength=1e9)
    return wk.Foundation(wk.Paraboloid(1e-2), wk.CoatedHalfSpace([wk.Layer(hard, 2e-5)], on=steel))


def bench_the_onset_of_yield_under_a_thin_coating(benchmark, below):
    found = benchmark.pedantic(wk.YieldOnset(coated_ball()).solve, setup=forget, rounds=2)
    assert math.isclose(found.force, 31.7939112437, rel_tol=1e-9)
    below(3.0, "onset of yield of a ball on a hard coating of a fifth of the contact radius, from nothing")


def bench_the_onset_of_yield_of_a_coating_that_is_slid_over(benchmark, below):
    sliding = wk.YieldOnset(coated_ball(), wk.Coulomb(0.3))
    found = benchmark.pedantic(sliding.solve, setup=forget, rounds=2)
    assert 0.0 < found.force < 31.7939112437
    below(8.0, "the same where the ball slides with a coefficient of friction of 0.3")


def bench_the_greatest_stress(benchmark, below):
    found = benchmark.pedantic(wk.MapStress(hill(128), STEEL).solve, rounds=3, warmup_rounds=1)
    assert 0.62 < found.von_mises < 0.64
    below(
        3.0,
        "128 x 128 pixels under pressure and friction: the greatest von Mises stress and its place",
    )
