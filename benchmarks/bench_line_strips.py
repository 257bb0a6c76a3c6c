"""Sections that touch in many strips: elements on measured points, and refined strips of a formula.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.line_strips.strip_search import find_strips

pytestmark = pytest.mark.bench

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)


def trace(count: int) -> wk.MeasuredSection:
    """A rough cylinder, known at so many points."""
    random = np.random.default_rng(1)
    x, waves = np.linspace(-1e-3, 1e-3, count), np.arange(4, 400)
    rough = (waves**-1.3) @ np.cos(np.pi * np.outer(waves, x) / 1e-3 + 2.0 * np.pi * random.random((waves.size, 1)))
    return wk.MeasuredSection(x, 0.2e-6 * rough / np.std(rough) + x**2 / (2.0 * 50e-3))


def bench_a_measured_trace(benchmark, below):
    problem = wk.LineProfileContact(trace(10_000), PAIR, wk.LineForce(100e3))
    found = benchmark.pedantic(problem.solve, setup=find_strips.cache_clear, rounds=5, warmup_rounds=1)
    assert found.strip_count > 10
    below(1.0, "a measured trace of 10,000 points in tens of strips, and half as many points to compare with")


def bench_refined_strips(benchmark, below):
    wavy = wk.FormulaSection("(x-m)**2/(2*R) + h*cos(2*pi*x/l)", 4e-3, m=1.9e-3, R=0.1, h=0.5e-6, l=0.1e-3)
    problem = wk.LineProfileContact(wavy, PAIR, wk.LineForce(60e3))
    found = benchmark.pedantic(problem.solve, setup=find_strips.cache_clear, rounds=5, warmup_rounds=1)
    assert found.refined
    assert math.isclose(found.at(()).strip_forces.sum(), 60e3, rel_tol=1e-12)
    below(1.0, "a wavy cylinder in many strips, refined to rounding")
