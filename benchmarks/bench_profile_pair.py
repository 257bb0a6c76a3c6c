"""A wheel on a rail by their profiles: placed, pressed, with creepages.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.Elastic(208e9, 0.28)
Y = np.linspace(-30e-3, 30e-3, 301)


def bench_a_wheel_on_a_rail(benchmark, below):
    rail = wk.CrossProfile(Y, np.sqrt(0.3**2 - Y**2) - 0.3)
    wheel = wk.CrossProfile(Y, np.sqrt(0.5**2 - Y**2) - 0.5 + Y / 40.0)
    track = wk.HalfSpace.between(STEEL, STEEL)
    pair = wk.ProfilePair(rail, wheel, track, wk.Force(80e3), yaw=2e-3, second_radius=0.46)
    found = benchmark.pedantic(pair.solve, rounds=5, warmup_rounds=1)
    assert math.isclose(found.force, 80e3, rel_tol=1e-6)
    below(1.5, "a wheel on a rail by profiles of 301 points: placing, pressures on 96 x 96 pixels, creepages")


def bench_a_wheel_that_rolls_with_friction(benchmark, below):
    rail = wk.CrossProfile(Y, np.sqrt(0.3**2 - Y**2) - 0.3)
    wheel = wk.CrossProfile(Y, np.sqrt(0.5**2 - Y**2) - 0.5 + Y / 40.0)
    track = wk.HalfSpace.between(STEEL, STEEL)
    pair = wk.ProfilePair(rail, wheel, track, wk.Force(80e3), yaw=2e-3, second_radius=0.46)
    found = benchmark.pedantic(wk.ProfilePairRolling(pair, wk.Coulomb(0.3)).solve, rounds=5, warmup_rounds=1)
    assert math.isclose(found.z_force, 80e3, rel_tol=1e-4)
    below(3.0, "the same with friction: stick, slip and creep forces, balanced with the load")
