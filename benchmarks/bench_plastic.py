"""Speed of metals that yield: a loop of many points and a map of restitution, with one body that yields and with two.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL, SOFT = wk.Elastic(210e9, 0.3, strength=1e9), wk.Elastic(210e9, 0.3, strength=0.5e9)


@pytest.mark.parametrize(("second", "limit"), [(None, 0.02), (SOFT, 0.03)], ids=["one", "two"])
def bench_a_loop_of_a_thousand_points(benchmark, below, second, limit):
    """Up to 200 times the force of first yield, back, and up again."""
    medium = wk.HalfSpace(STEEL) if second is None else wk.HalfSpace.between(STEEL, second)
    ramp = 2000.0 * np.linspace(0.0, 1.0, 334)
    path = wk.Force(np.concatenate([ramp, ramp[-2::-1], ramp[1:]]))
    problem = wk.PlasticIndentation(wk.Foundation(wk.Paraboloid(5e-3), medium), path)
    solution = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert solution.residual_depth[-1] > 0.0
    below(limit, f"{path.force.size} points")


@pytest.mark.parametrize("second", [None, SOFT], ids=["one", "two"])
def bench_a_map_of_restitution(benchmark, below, second):
    """A hundred velocities from a tenth to a thousand times that of first yield."""
    medium = wk.HalfSpace(STEEL) if second is None else wk.HalfSpace.between(STEEL, second)
    bed = wk.Foundation(wk.Paraboloid(5e-3), medium)
    first = wk.PlasticImpact(bed, 4.1e-3, 1.0).yield_velocity
    problem = wk.PlasticImpact(bed, 4.1e-3, first * np.geomspace(0.1, 1000.0, 100))
    solution = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert solution.restitution[-1] < 0.5
    below(0.5, "100 velocities")
