"""Height maps that attract each other: snap-in and pull-off of a ball with a Tabor number of 5, loop of a rough map.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))
WORK, TABOR = 1e-9, 5.0
LIMITS = {128: 5.0, 256: 10.0}


@pytest.mark.parametrize("count", LIMITS)
def bench_a_pull_off(benchmark, below, count):
    """A ball that snaps in and is drawn off beyond its pull-off force, in six displacements."""
    reach = np.sqrt(2.0 * WORK)  # the shortest on pixels of one metre
    tabor = TABOR * np.sqrt(count / 256.0)
    radius = tabor**3 * reach**3 / WORK**2
    x = np.arange(count) - 0.5 * (count - 1)
    surface = wk.Topography(-(x[:, None] ** 2 + x**2) / (2.0 * radius), [count, count])
    path = wk.Depth(reach * tabor**1.5 / 11.2 * np.linspace(-2.0, -7.0, 6))
    problem = wk.SurfaceAdhesion(surface, UNIT, wk.ShortRange(WORK), path)
    found = benchmark.pedantic(problem.solve, rounds=1)
    assert abs(found.pull_off_force / (-1.5 * np.pi * radius * WORK) - 1.0) < 0.02
    below(LIMITS[count], f"a ball of Tabor number {tabor:.2g} on {count} x {count} pixels: snap-in and pull-off")


def bench_a_pull_off_without_range(benchmark, below):
    """JKR's pull-off force of a ball from two short ranges, seven displacements each."""
    reach, count = np.sqrt(2.0 * WORK), 256
    radius = TABOR**3 * reach**3 / WORK**2
    x = np.arange(count) - 0.5 * (count - 1) + 0.3
    surface = wk.Topography(-(x[:, None] ** 2 + x**2) / (2.0 * radius), [count, count])
    problem = wk.SurfaceAdhesion(surface, UNIT, wk.ShortRange(WORK), wk.Depth(reach * np.linspace(-3.0, -4.8, 7)))
    found = benchmark.pedantic(problem.pull_off_without_range, rounds=1)
    assert abs(found.force / (-1.5 * np.pi * radius * WORK) - 1.0) < 0.005
    below(10.0, "a ball on 256 x 256 pixels: pull-off force without range, from two ranges")


def bench_a_rough_loop(benchmark, below):
    """A rough map of 128 pixels along a side, to contact and back, in nineteen displacements."""
    spectrum = wk.SelfAffine(0.8, rms_height=0.5e-6, longest=2e-4, shortest=25e-6)
    rough = wk.random_topography(spectrum, (128, 128), [4e-4, 4e-4], seed=4)
    path = wk.Depth(np.concatenate((np.linspace(-3e-6, 1e-6, 9), np.linspace(0.5e-6, -4e-6, 10))))
    soft = wk.HalfSpace(wk.Elastic(1e6, 0.5))
    problem = wk.SurfaceAdhesion(rough, soft, wk.ExponentialAttraction(0.05, 0.6e-6), path)
    found = benchmark.pedantic(problem.solve, rounds=1)
    assert found.dissipation[-1] > 0.0
    below(20.0, "a sticky rough map of 128 x 128 pixels: nineteen displacements")
