"""Twenty curves with one shared modulus, after their single fits, and one of these for comparison.

Run it:  pytest benchmarks/bench_fit_together.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.several.together import joint_of

pytestmark = pytest.mark.bench

PATH = "bed.medium.first.young"
FREE = [PATH, "contact_point", "baseline"]
MODEL = wk.Indentation(wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(3e4, 0.5))), wk.Depth(0.0))


def measured(seed: int) -> wk.ForceCurve:
    depth = np.linspace(-1e-6, 1e-6, 500)
    force = 4.0 / 3.0 * 1e4 / 0.75 * np.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5
    return wk.ForceCurve(depth + 2e-6, force + 3e-11 * np.random.default_rng(seed).standard_normal(500))


def bench_one_of_them(benchmark):
    found = benchmark(lambda: wk.fit(measured(0), MODEL, free=FREE))
    assert abs(found.value(PATH) - 1e4) < 5.0 * found.error(PATH)


def bench_twenty_together(benchmark):
    fits = [wk.fit(measured(seed), MODEL, free=FREE) for seed in range(20)]
    found = benchmark.pedantic(lambda: joint_of(fits, [PATH]), rounds=2)
    assert abs(found.value(PATH) - 1e4) < 5.0 * found.error(PATH)
