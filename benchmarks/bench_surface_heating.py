"""Temperatures of two bodies that rub on a map of pixels.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEELS = wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(45.0, 12e-6))


def bench_a_body_at_rest_on_one_that_moves(benchmark, below):
    """The heat must be shared point by point: one body is fast, the other at rest."""
    x = 1.1 * ((np.arange(128) + 0.5) * 2.0 / 128 - 1.0)
    pressure = 300e6 * np.sqrt(np.maximum(1.0 - x[:, None] ** 2 - x**2, 0.0))
    load = wk.SurfaceLoad(pressure, [2.2e-3, 2.2e-3], x_traction=-0.1 * pressure)
    problem = wk.SurfaceFrictionHeating(load, STEELS, first_speed=5.0)
    warm = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert math.isclose(warm.heat_rate, 0.1 * 5.0 * load.force, rel_tol=1e-9)
    below(0.5, "128 x 128 pixels that rub: temperatures of both surfaces, the heat shared point by point")
