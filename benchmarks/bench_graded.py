"""Graded half-spaces, measured beds and bodies made to order.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.measured import MeasuredBed
from winkler.materials.graded import PowerLawGraded
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.problems.normal.design import design_profile

pytestmark = pytest.mark.bench

CERAMIC = GradedHalfSpace.between(PowerLawGraded(300e9, 1e-4, 0.2, 0.22))
DEPTH = np.linspace(0.0, 1e-6, 200)


def bench_force_curve(benchmark, below):
    """F at 200 depths: a closed form with an incomplete beta function per kink."""
    problem = wk.Indentation(wk.Foundation(wk.TruncatedCone(1.5, 1e-5), CERAMIC), wk.Depth(DEPTH))
    contact = benchmark(problem.solve)
    assert np.all(np.diff(contact.force) > 0.0)
    below(20e-3, "graded half-space, truncated cone, F at 200 depths")


def bench_fields(benchmark, below):
    """Pressure and surface at 200 radii."""
    contact = wk.Indentation(wk.Foundation(wk.Sphere(2e-3), CERAMIC), wk.Force(30.0)).solve()
    r = np.linspace(0.0, 2.0, 200) * contact.radius
    fields = benchmark(lambda: wk.restore(contact, r))
    assert fields.pressure[0] > 0.0
    below(200e-3, "graded half-space, sphere, pressure and displacement at 200 radii")


def bench_from_curve(benchmark, below, steel_on_steel):
    """The bed behind 200 noisy points: the choice of the convex curve."""
    force = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-3), steel_on_steel), wk.Depth(DEPTH)).solve().force
    noisy = force + 1e-3 * force[-1] * np.random.default_rng(2).standard_normal(force.size)
    bed = benchmark(lambda: MeasuredBed.from_curve(DEPTH, noisy, steel_on_steel.modulus))
    assert bed.scatter > 0.0
    below(1.0, "bed behind 200 noisy points of a force curve")


def bench_design(benchmark, below, steel_on_steel):
    """A body for a curve of 200 points: fit, inverse transform, panels."""
    t = DEPTH[1:] / DEPTH[-1]
    body = benchmark.pedantic(
        lambda: design_profile(DEPTH[1:], t**1.5 + t**2 + 0.3 * t**4, steel_on_steel), rounds=3, warmup_rounds=1
    )
    assert body.tolerance < 1e-5
    below(5.0, "body made to order for a force curve of 200 points")
