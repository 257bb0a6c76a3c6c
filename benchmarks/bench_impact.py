"""Impacts: straight, oblique, without slip and sticky, each followed to rounding.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import pytest

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.problems.impact.adhesive_impact import AdhesiveImpact
from winkler.problems.impact.impact import Impact

pytestmark = pytest.mark.bench

BED = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
BALL = {"mass": 1.0, "velocity": 0.01, "inertia": 0.4, "lever": 1.0}


@pytest.mark.parametrize(("coefficient", "sliding"), [(0.0, 0.0), (0.4, 0.009), (math.inf, 0.009)])
def bench_impact_of_200_moments(benchmark, coefficient, sliding):
    problem = Impact(BED, Coulomb(coefficient), lateral_velocity=sliding, **BALL)
    assert abs(benchmark(problem.solve).balance[-1] - 1.0) < 1e-10


def bench_sticky_impact_of_200_moments(benchmark):
    problem = AdhesiveImpact(BED, wk.ShortRange(1e-5), 1.0, 0.01)
    assert not benchmark(problem.solve).captured


@pytest.mark.parametrize("thickness", [1e-3, 0.1])
def bench_oblique_impact_on_a_coating(benchmark, thickness):
    layers = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(3.0, 0.3), thickness)], on=wk.Elastic(1.0, 0.3))
    problem = Impact(wk.Foundation(wk.Paraboloid(1.0), layers), Coulomb(0.4), lateral_velocity=0.004, **BALL)
    assert abs(benchmark.pedantic(problem.solve, rounds=3).balance[-1] - 1.0) < 1e-10
