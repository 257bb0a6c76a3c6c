"""Many contacts at once: oblique impacts, and steps of a discrete element code.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

GLASS = wk.HalfSpace.between(wk.Elastic(70e9, 0.22), wk.Elastic(70e9, 0.22))
RADIUS = 1e-3
MASS = 2500.0 * 4.0 / 3.0 * np.pi * RADIUS**3
MANY = 100_000


def bench_impacts(benchmark, below):
    """100,000 oblique impacts of 200 steps, 32 springs each; a thread on every core."""
    sliding = np.random.default_rng(2).normal(size=(MANY, 2))
    problem = wk.BallImpacts(GLASS, RADIUS, 0.3, MASS, 3.5 / MASS, 1.0, sliding)
    parted = benchmark.pedantic(problem.solve, rounds=2, warmup_rounds=1)
    assert np.max(np.abs(parted.balance - 1.0)) < 1e-4
    below(20.0, "100,000 oblique impacts of 200 steps")


def bench_step(benchmark, below):
    """One step of 100,000 contacts with their memory: shear, twist and rolling."""
    apart = wk.Contacts.apart(GLASS, curvature_radius=np.full(MANY, RADIUS), coefficient=0.3, reach=1e-6)
    contacts = apart.moved(np.full(MANY, 5e-7), motion=np.full((MANY, 2), 1e-8))
    depth, motion, twist = np.full(MANY, 6e-7), np.full((MANY, 2), 1e-8), np.full(MANY, 1e-5)
    benchmark.pedantic(lambda: contacts.moved(depth, motion=motion, twist=twist), rounds=5, warmup_rounds=1)
    below(0.5, "a step of 100,000 contacts")
