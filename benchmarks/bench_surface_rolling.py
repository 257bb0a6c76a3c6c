"""Steady rolling on 36 to 288 pixels along the contact, by boundary elements: creepages, forces, unlike bodies.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math
import time

import pytest

import winkler as wk

pytestmark = pytest.mark.bench

PAIR = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
LIMITS = {36: 0.2, 72: 0.6, 144: 2.0, 288: 8.0}
FORCE_LIMITS = {36: 0.3, 72: 0.9}
UNLIKE_LIMIT = 2.0


@pytest.mark.parametrize("count", LIMITS)
def bench_a_creepage(benchmark, below, count):
    """A locomotive wheel at a creepage under which half of the contact sticks."""
    problem = driven(count, wk.Creepage(longitudinal=1.2e-3))
    rolled = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert math.isclose(float(rolled.saturation), 0.643, abs_tol=0.01)
    below(LIMITS[count], f"steady rolling, {count} x {count} pixels in contact: press, stick, slip and forces")


@pytest.mark.parametrize("count", FORCE_LIMITS)
def bench_a_force(benchmark, below, count):
    """The creepages of the wheel under given forces."""
    problem = driven(count, wk.CreepForce(20e3, 5e3))
    rolled = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert math.isclose(float(rolled.longitudinal_force), 20e3, rel_tol=1e-6)
    below(FORCE_LIMITS[count], f"steady rolling under forces, {count} x {count} pixels in contact: creepages")


@pytest.mark.parametrize("creepages", [(1.2e-3, 0.0), (4e-4, 2e-4)])
def bench_forces_beside_the_creepages_they_need(benchmark, below, creepages):
    """At most four times what the wheel takes under given creepages, in one run."""
    given = driven(36, wk.Creepage(*creepages))
    rolled, alone = given.solve(), math.inf
    for _ in range(5):
        begun = time.process_time()
        given.solve()
        alone = min(alone, time.process_time() - begun)
    problem = driven(36, wk.CreepForce(float(rolled.longitudinal_force), float(rolled.lateral_force)))
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert math.isclose(float(found.longitudinal_creepage), creepages[0], rel_tol=1e-4)
    below(4.0 * alone, "steady rolling under forces, against the same under creepages")


def bench_dissimilar_bodies(benchmark, below):
    """A wheel on a softer rail, with pressures and tractions by turns."""
    problem = driven(72, wk.Creepage(longitudinal=1.2e-3), wk.HalfSpace.between(PAIR.first, wk.Elastic(180e9, 0.2)))
    rolled = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert rolled.misfit <= problem.tolerance
    below(UNLIKE_LIMIT, "steady rolling of dissimilar bodies, 72 x 72 pixels in contact")


def driven(count: int, drive, pair: wk.HalfSpace = PAIR) -> wk.SurfaceRolling:
    wide = count + 8
    sides = [2.0 * axis * wide / count for axis in (6.304e-3, 12.61e-3)]
    wheel = wk.SampledProfile(sides, wk.CurvedBodies(0.625, 1.777), (wide, wide))
    return wk.SurfaceRolling(wheel, pair, wk.Force(106.7e3), wk.Coulomb(0.33), drive)
