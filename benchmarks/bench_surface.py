"""Height maps of 512 x 512 pixels by boundary elements, and what runs on the springs behind them.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.surfaces import surface_grid

pytestmark = pytest.mark.bench

COUNT, SIDE, BALL, CONTACT = 512, 0.25, 1.0, 0.1
UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))
FORCE = 4.0 / 3.0 * CONTACT**3 / BALL
STEPS = 1000


def ball(count: int = COUNT) -> wk.Topography:
    """A paraboloid, whose contact is 80 % as wide as the map."""
    x = (np.arange(count) + 0.5) * SIDE / count - 0.5 * SIDE
    return wk.Topography(-(x[:, None] ** 2 + x**2) / (2.0 * BALL), [SIDE, SIDE])


def forget() -> None:
    """Empty the cache of grids."""
    surface_grid._cached_grid.cache_clear()


def bench_hertz_from_cold(benchmark, below):
    problem = wk.SurfaceContact(ball(), UNIT, wk.Force(FORCE))
    contact = benchmark.pedantic(problem.solve, setup=forget, rounds=8, warmup_rounds=1)
    assert math.isclose(4.0 / 3.0 * contact.depth**1.5, FORCE, rel_tol=3e-5)
    below(1.0, "Hertz, 512 x 512 pixels from cold: depth, stiffness, pressures and gaps")


def bench_hertz_from_a_load_nearby(benchmark, below):
    """To the tolerance that Tamaas is given in peers.py; the error of the force is that of the pixels."""
    problem = wk.SurfaceContact(ball(), UNIT, wk.Force(FORCE * np.array([1.0, 1.05])), tolerance=1e-5)

    def begun():
        states = problem.steps()
        next(states)
        return (states,), {}

    state = benchmark.pedantic(next, setup=begun, rounds=8, warmup_rounds=1)
    assert math.isclose(4.0 / 3.0 * state.depth**1.5, 1.05 * FORCE, rel_tol=3e-5)
    below(0.3, "Hertz, 512 x 512 pixels from a load 5 % less: the same, to 1e-5")


def bench_a_rough_surface(benchmark, below):
    """A periodic self-affine surface, all of it."""
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-5)
    rough = wk.random_topography(spectrum, (COUNT, COUNT), [1e-3, 1e-3], seed=1)
    problem = wk.SurfaceContact(rough, UNIT, wk.Force(2e-11))
    contact = benchmark.pedantic(problem.solve, setup=forget, rounds=5, warmup_rounds=1)
    assert 0.0 < contact.area < rough.area
    below(2.0, "periodic self-affine surface, 512 x 512 pixels: depth, stiffness, pressures and gaps")


def bench_a_reduction(benchmark, below):
    """All the contacts behind the springs of a map of 128 x 128 pixels."""
    problem = wk.Reduction(ball(128), UNIT, 0.01)
    found = benchmark.pedantic(problem.solve, setup=forget, rounds=5, warmup_rounds=1)
    assert found.misfit < 1e-3
    below(2.0, "128 x 128 pixels reduced to springs that bear F(d) to 1e-3")


def bench_both_directions_on_reduced_springs(benchmark, below):
    """A loop along x and one along y, of 40 points each, on the springs of a rough height map."""
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=6e-5)
    rough = wk.RandomTopography([1e-3, 1e-3], spectrum, (128, 128), seed=1, periodic=False)
    bed = wk.reduce(rough, wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.0, 0.3)), 3e-6)
    path = wk.Path.through(wk.Depth(2.5e-6), wk.Shift(8e-7 * np.sin(np.linspace(0.0, 8.0, 40))))
    springs = bed, bed.turned

    def loops():
        return [wk.Tangential(each, wk.Coulomb(0.3), path).solve() for each in springs]

    both = benchmark.pedantic(loops, rounds=20, warmup_rounds=2)
    assert all(np.all(np.diff(loop.dissipation) >= 0.0) for loop in both)
    below(0.2, "loops of 40 points along x and along y on the springs of a rough height map")


def bench_a_history_on_reduced_springs(benchmark, below):
    """A thousand steps of friction, against one boundary-element solution for each of them: 500 springs."""
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=6e-5)
    rough = wk.RandomTopography([1e-3, 1e-3], spectrum, (128, 128), seed=1, periodic=False)
    bed = wk.reduce(rough, UNIT, 3e-6)
    turns = np.sin(np.linspace(0.0, 40.0, STEPS))
    path = wk.Path.through(wk.Depth(2.5e-6 + 0.3e-6 * turns), wk.Shift(3e-7 * np.roll(turns, 100)))
    problem = wk.Tangential(bed, wk.Coulomb(0.3), path, wk.Method.SPRINGS, 500)
    trace = benchmark.pedantic(problem.solve, rounds=40, warmup_rounds=3)
    assert np.all(np.diff(trace.dissipation) >= 0.0)
    below(10e-3, "1,000 steps of friction on the springs of a rough height map")
