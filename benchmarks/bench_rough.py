"""Rough lines: all loads of a million springs, an ensemble, a rough ball; Persson's gap; nearly round bodies.

Run it:  pytest benchmarks/bench_rough.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

ONE = wk.HalfSpace(wk.Elastic(1.0, 0.0))
BLASTED = wk.SelfAffine(hurst=0.8, rms_height=1e-3, longest=1.0, shortest=1e-3)
FORCES = np.geomspace(1e-7, 1e-3, 1000)


@pytest.mark.parametrize("exponent", [5, 6])
def bench_a_line(benchmark, below, exponent):
    """F(d) and k(d) at a thousand depths, from unsorted heights."""
    heights = np.random.default_rng(1).standard_normal(10**exponent)
    depths = np.linspace(0.01, 8.0, 1000)

    def curve():
        line = wk.RoughLine(heights, 1.0, 1.0)
        return line.force(depths), line.stiffness(depths)

    force, stiffness = benchmark.pedantic(curve, rounds=5, warmup_rounds=1)
    pressed = np.maximum(depths[500] - (heights.max() - heights), 0.0)
    assert force[500] == pytest.approx(np.mean(pressed), rel=1e-9)
    assert stiffness[500] == pytest.approx(np.mean(pressed > 0.0), rel=1e-12)
    below(0.5 if exponent == 6 else 0.05, f"one line of 1e{exponent} springs, force and stiffness at 1000 depths")


def bench_an_ensemble(benchmark, below):
    problem = wk.RoughContact(BLASTED, ONE, 1.0, wk.Force(FORCES), realisations=50, count=4096)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(found.stiffness) >= 0.0)
    below(0.5, "50 lines of 4096 springs, medians and bands of 1000 forces")


def bench_a_rough_ball(benchmark, below):
    ball = wk.Foundation(wk.Paraboloid(10.0), ONE)
    problem = wk.RoughIndentation(BLASTED, ball, 1.0, wk.Force(FORCES), realisations=50, count=4096)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert found.stiffness[-1] < 1.05 * found.smooth_stiffness[-1]
    below(0.5, "a rough ball, 50 lines of 4096 springs, 1000 forces")


def bench_a_mean_gap(benchmark, below):
    pressures = np.geomspace(1e-4, 0.1, 100)
    gaps = benchmark.pedantic(lambda: wk.mean_separation(pressures, 1.0, BLASTED), rounds=5, warmup_rounds=1)
    assert np.all(np.diff(gaps) < 0.0)
    below(0.5, "Persson's mean gap under 100 pressures")


def bench_an_oval(benchmark, below):
    """An elliptic paraboloid in 64 directions, 100 depths, against Hertz."""
    turns = np.arange(64) * 2.0 * np.pi / 64
    body = tuple(wk.Paraboloid(float(0.5 / (0.4 * np.cos(t) ** 2 + 0.6 * np.sin(t) ** 2))) for t in turns)
    problem = wk.NearlyRoundIndentation(body, ONE, wk.Depth(np.geomspace(1e-6, 1e-2, 100)))
    found = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    exact = wk.EllipticIndentation(wk.CurvedBodies(1.25, 0.5 / 0.6), ONE, problem.load).solve()
    assert found.force == pytest.approx(exact.force, rel=2e-5)
    below(1.0, "a nearly round body in 64 directions, 100 depths")
