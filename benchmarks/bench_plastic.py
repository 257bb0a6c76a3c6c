"""Speed of metals that yield: a loop of many points, a map of restitution, and a strength from a dent.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL, SOFT = wk.Elastic(210e9, 0.3, strength=1e9), wk.Elastic(210e9, 0.3, strength=0.5e9)


HARDENING = wk.PowerHardening(210e9, 0.3, strength=1e9, exponent=0.2)


@pytest.mark.parametrize(
    ("medium", "limit"),
    [(wk.HalfSpace(STEEL), 0.02), (wk.HalfSpace.between(STEEL, SOFT), 0.03), (wk.HalfSpace(HARDENING), 0.15)],
    ids=["one", "two", "hardening"],
)
def bench_a_loop_of_a_thousand_points(benchmark, below, medium, limit):
    """Up to 200 times the force of first yield, back, and up again."""
    ramp = 2000.0 * np.linspace(0.0, 1.0, 334)
    path = wk.Force(np.concatenate([ramp, ramp[-2::-1], ramp[1:]]))
    problem = wk.PlasticIndentation(wk.Foundation(wk.Paraboloid(5e-3), medium), path)
    solution = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert solution.residual_depth[-1] > 0.0
    below(limit, f"{path.force.size} points")


def bench_a_strength_from_a_dent(benchmark, below):
    bed = wk.Foundation(wk.Paraboloid(5e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
    problem = wk.StrengthFromDent(bed, wk.Force(1000.0), wk.Radius(0.36e-3), dent_error=5e-6)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert found.strength > 0.0
    below(0.5, "one dent")


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
