"""Adhesive cycles: a touch of 2,000 points, and a wavy ball with a dozen jumps.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.cycle import AdhesiveCycle

pytestmark = pytest.mark.bench

MEDIUM = wk.HalfSpace(wk.Elastic(1.0, 0.0))
PATH = np.concatenate([np.linspace(-0.05, 0.1, 1000), np.linspace(0.1, -0.05, 1000)])


def bench_touch_of_2000_points(benchmark):
    problem = AdhesiveCycle(wk.Foundation(wk.Paraboloid(1.0), MEDIUM), ShortRange(1e-3), wk.Depth(PATH))
    assert len(benchmark(problem.solve).jumps) == 2


def bench_wavy_ball_of_2000_points(benchmark):
    bed = wk.Foundation(wk.Paraboloid(1.0) + wk.Wavy(1e-3, 0.05), MEDIUM)
    problem = AdhesiveCycle(bed, ShortRange(1e-4), wk.Depth(PATH))
    assert len(benchmark(problem.solve).jumps) > 12
