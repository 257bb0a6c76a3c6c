"""Hertz's ellipse: maps of stresses with and without friction, the greatest stress, the onset of yield.

Run it:  pytest benchmarks/bench_ellipse.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, 1e9), wk.Elastic(210e9, 0.3))


@pytest.mark.parametrize("ratio", [3.0, 1e4])
@pytest.mark.parametrize("friction", [0.0, 0.2])
def bench_a_map(benchmark, below, ratio, friction):
    contact = wk.EllipticIndentation(wk.CurvedBodies(ratio * 1e-2, 1e-2), STEEL, wk.Force(100.0)).solve()
    a, b = contact.longitudinal_semi_axis, contact.lateral_semi_axis
    x, z = np.linspace(-2.0 * a, 2.0 * a, 100)[:, None], np.linspace(0.0, 3.0 * b, 100)
    fields = benchmark(contact.stresses, x, 0.1 * b, z, friction, 0.5)
    assert fields.zz_stress.shape == (100, 100)
    below(0.2, f"ellipse of R 1:{ratio:g}, stresses at 100 x 100 places, mu = {friction:g}")


def bench_an_onset(benchmark, below):
    angles = iter(np.linspace(0.1, 1.5, 1000))

    def onset():
        return wk.EllipticYieldOnset(wk.CurvedBodies(3e-2, 1e-2), STEEL, wk.Coulomb(0.2), float(next(angles))).solve()

    found = benchmark.pedantic(onset, rounds=5, warmup_rounds=1)
    assert found.force > 0.0
    below(0.5, "onset of yield of an ellipse that slides obliquely")
