"""Rollers of finite length by boundary elements.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.Elastic(208e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
EVEN = 4e3 / 9.6e-3


def roller(alignment: wk.Tilt | wk.Moment) -> wk.RollerContact:
    """A bearing roller with a logarithmic crown."""
    return wk.RollerContact(4.2e-3, 9.6e-3, wk.LogarithmicEnds(EVEN), PAIR, wk.Force(4e3), alignment)


def bench_a_straight_roller(benchmark, below):
    found = benchmark.pedantic(roller(wk.Tilt(0.0)).solve, rounds=5, warmup_rounds=1)
    assert math.isclose(found.middle_pressure, math.sqrt(EVEN * PAIR.modulus / (math.pi * 4.2e-3)), rel_tol=0.01)
    below(1.0, "a roller with a logarithmic crown, 160 elements along it: pressures, approach, error of the grid")


def bench_a_roller_that_finds_its_tilt(benchmark, below):
    found = benchmark.pedantic(roller(wk.Moment(2.0)).solve, rounds=5, warmup_rounds=1)
    assert math.isclose(found.moment, 2.0, rel_tol=1e-6)
    below(1.5, "the same under a moment, with the tilt that it takes")
