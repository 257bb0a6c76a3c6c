"""Height maps on layers: contacts of 512 x 512 pixels, stacks that have not been met before.

Run it:  pytest benchmarks/bench_layered_map.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.surfaces import surface_grid

pytestmark = pytest.mark.bench

BASE = wk.Elastic(1.0, 0.3)
SIDE, COUNT = 0.8, 512
PLACES = (np.arange(COUNT) - 0.5 * (COUNT - 1)) * SIDE / COUNT
BALL = wk.Topography(-0.5 * (PLACES[:, None] ** 2 + PLACES**2), [SIDE, SIDE])
ROUGH = wk.random_topography(
    wk.SelfAffine(hurst=0.8, rms_height=1e-3, longest=0.8, shortest=0.02), (COUNT, COUNT), lengths=(SIDE, SIDE), seed=1
)


def coated(young, number):
    """A coating whose kernel has not been tabulated."""
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young * (1.0 + 1e-6 * number), 0.3), 0.1)], on=BASE)


@pytest.mark.parametrize("young", [0.2, 5.0, 100.0])
def bench_a_ball_on_a_coating(benchmark, below, young):
    numbers = iter(range(100))

    def contact():
        surface_grid._cached_grid.cache_clear()
        return wk.SurfaceContact(BALL, coated(young, next(numbers)), wk.Depth(0.05)).solve()

    found = benchmark.pedantic(contact, rounds=3, warmup_rounds=1)
    assert found.penetration <= 1e-6
    below(3.0, f"a ball on a coating of {young:g} times the modulus, 512 x 512 pixels")


def bench_a_rough_periodic_map_on_a_coating(benchmark, below):
    numbers = iter(range(100))

    def contact():
        surface_grid._cached_grid.cache_clear()
        return wk.SurfaceContact(ROUGH, coated(5.0, next(numbers)), wk.Force(1e-3)).solve()

    found = benchmark.pedantic(contact, rounds=3, warmup_rounds=1)
    assert found.penetration <= 1e-6
    below(3.0, "a rough periodic map on a coating, 512 x 512 pixels")
