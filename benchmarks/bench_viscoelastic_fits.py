"""Fits of bodies that relax: a loop of 2,000 points as a power law, the same with two relaxation times, creep.

Run it:  pytest benchmarks/bench_viscoelastic_fits.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit

pytestmark = pytest.mark.bench

RADIUS, SPRING = 5e-6, 0.05
SOLID = "bed.medium.first."
IN = ("contact_point", "baseline")


def model(solid, path=None) -> wk.ViscoelasticIndentation:
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.ViscoelasticHalfSpace(solid))
    return wk.ViscoelasticIndentation(bed, path or wk.Path([0.0], wk.Depth(0.0)))


def loop(solid, hold: float = 0.0, count: int = 2000) -> ForceCurve:
    """In, held, and out on a cantilever, by springs, with noise."""
    time = np.linspace(-0.5, 2.5 + hold, count)
    depth = 1e-6 * np.where(time < 1.0, time, np.where(time < 1.0 + hold, 1.0, 2.0 + hold - time))
    direction = np.where(time < 1.0, 1.0, np.where(time < 1.0 + hold, 0.0, -1.0))
    force = model(solid, wk.Path(time, wk.Depth(depth))).solve().force
    noise = 1e-11 * np.random.default_rng(0).standard_normal(count)
    return ForceCurve(depth + force / SPRING + 2e-6, force + 1e-10 + noise, SPRING, time, direction)


def bench_power_law(benchmark, below):
    """Four free numbers, from four times the modulus and twice the exponent."""
    curve = loop(wk.PowerLawSolid(500.0, 1.0, 0.2, shortest=1e-3, longest=20.0))
    far = model(wk.PowerLawSolid(2e3, 1.0, 0.45, shortest=1e-3, longest=20.0))
    free = [f"{SOLID}shear", f"{SOLID}exponent", *IN]
    found = benchmark.pedantic(lambda: fit(curve, far, free=free), rounds=5, warmup_rounds=1)
    assert abs(found.value(f"{SOLID}exponent") - 0.2) < 5.0 * found.error(f"{SOLID}exponent")
    below(2.0, "fit of a loop of 2,000 points as a power law, four free numbers")


def bench_two_times(benchmark, below):
    """Seven free numbers, in, held for four seconds, and out."""
    curve = loop(wk.Prony(100.0, [300.0, 200.0], [0.05, 0.8]), hold=4.0)
    far = model(wk.Prony(1e3, [1e3, 1e3], [1.0, 10.0]))
    free = [f"{SOLID}relaxed_shear", f"{SOLID}shears", f"{SOLID}relaxation_times", *IN]
    found = benchmark.pedantic(lambda: fit(curve, far, free=free), rounds=5, warmup_rounds=1)
    assert abs(found.value(f"{SOLID}relaxation_times[1]") - 0.8) < 5.0 * found.error(f"{SOLID}relaxation_times[1]")
    below(2.0, "fit of a loop of 2,000 points with two relaxation times, seven free numbers")


def bench_creep(benchmark, below):
    """Three free numbers under a force that is held."""
    solid = wk.StandardSolid(300.0, 700.0, 0.8)
    time = np.linspace(0.0, 8.0, 2001)
    depth = wk.CreepTest(model(solid).bed, 1e-9, time[1:]).solve().depth
    noise = 2e-9 * np.random.default_rng(0).standard_normal(2000)
    curve = ForceCurve(depth + noise, np.full(2000, 1e-9), time=time[1:], direction=np.zeros(2000))
    far = model(wk.StandardSolid(1e3, 1e3, 5.0), wk.Path([0.0], wk.Force(0.0)))
    free = [f"{SOLID}{field}" for field in ("relaxed_shear", "shear", "relaxation_time")]
    found = benchmark.pedantic(lambda: fit(curve, far, free=free), rounds=5, warmup_rounds=1)
    assert abs(found.value(f"{SOLID}relaxed_shear") - 300.0) < 0.02 * 300.0
    below(1.0, "fit of creep, 2,000 points, three free numbers")
