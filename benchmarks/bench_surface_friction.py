"""One step of stick and slip on 64 to 512 pixels along a side, by boundary elements.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import pytest

import winkler as wk

pytestmark = pytest.mark.bench

SIDE, PUSH = 0.25, 0.875
PAIR = wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.0, 0.3))
FORCE = 4.0 / 3.0 * PAIR.modulus * 0.1**3
LIMITS = {64: 0.3, 128: 1.0, 256: 5.0}


@pytest.mark.parametrize("count", LIMITS)
def bench_a_push(benchmark, below, count):
    """A ball pushed to 7/8 of the friction at once, pressed before."""
    ball = wk.SampledProfile([SIDE, SIDE], wk.Paraboloid(1.0), (count, count))
    path = wk.Path.through(wk.Force(FORCE), wk.ShearForce([0.0, PUSH * 0.3 * FORCE]))
    problem = wk.SurfaceTangential(ball, PAIR, wk.Coulomb(0.3), path)

    def begun():
        states = problem.steps()
        next(states)
        return (states,), {}

    state = benchmark.pedantic(next, setup=begun, rounds=3, warmup_rounds=1)
    assert state.misfit <= 1e-8
    below(LIMITS[count], f"a ball pushed to 7/8 of its friction, {count} x {count} pixels: stick, slip and shift")
