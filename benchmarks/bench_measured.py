"""F(d) of a measured profile of 10,000 noisy points: choice of the curve, transform and 200 depths, nothing cached.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.profiles import measured
from winkler.reference.rounded import sphero_conical_depth, sphero_conical_force

pytestmark = pytest.mark.bench

TIP = {"curvature_radius": 1e-6, "half_angle": np.radians(60.0)}
REACH, POINTS, SCATTER = 1.5e-6, 10_000, 1e-9


def noisy_points() -> tuple[np.ndarray, np.ndarray]:
    """A sphero-conical tip, measured at unevenly spaced places with a scatter of 1 nm."""
    random = np.random.default_rng(7)
    radii = REACH * np.sort(random.random(POINTS))
    return radii, wk.SpheroConical(**TIP).height(radii) + SCATTER * random.standard_normal(POINTS)


def forget():
    """Empty every cache that a measured profile fills."""
    for item in vars(measured).values():
        if hasattr(item, "cache_clear"):
            item.cache_clear()


def bench_ten_thousand_points(benchmark, below, steel_on_steel):
    radii, heights = noisy_points()
    depth = np.linspace(0.0, 0.5e-6, 200)

    def curve():
        bed = wk.Foundation(wk.Measured(radii, heights), steel_on_steel)
        return wk.Indentation(bed, wk.Depth(depth)).solve()

    contact = benchmark.pedantic(curve, setup=forget, rounds=40, warmup_rounds=3)
    exact = np.interp(
        contact.depth[50:],
        sphero_conical_depth(np.linspace(0.0, REACH, 4001), **TIP),
        sphero_conical_force(np.linspace(0.0, REACH, 4001), modulus=steel_on_steel.modulus, **TIP),
    )
    np.testing.assert_allclose(contact.force[50:], exact, rtol=5e-3)
    below(50e-3, "measured profile of 10,000 noisy points: curve, transform, F at 200 depths")


def bench_reading_again(benchmark, steel_on_steel):
    """The same profile at other depths: the transform is cached."""
    bed = wk.Foundation(wk.Measured(*noisy_points()), steel_on_steel)
    problem = wk.Indentation(bed, wk.Depth(np.linspace(0.0, 0.5e-6, 200)))
    contact = benchmark.pedantic(problem.solve, rounds=100, warmup_rounds=3)
    assert np.all(np.diff(contact.force) > 0.0)
    benchmark.extra_info.update(what="the same profile again, F at 200 depths")
