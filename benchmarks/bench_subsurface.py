"""Stresses below maps of pressure, by closed forms of pixels, summed or convolved.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest

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


def bench_the_greatest_stress(benchmark, below):
    found = benchmark.pedantic(wk.MapStress(hill(128), STEEL).solve, rounds=3, warmup_rounds=1)
    assert 0.62 < found.von_mises < 0.64
    below(
        3.0,
        "128 x 128 pixels under pressure and friction: the greatest von Mises stress and its place",
    )
