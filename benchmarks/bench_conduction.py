"""Conduction: contact resistance over a thousand loads, hot contacts, plated ones, clusters of spots.

Run it:  pytest benchmarks/bench_conduction.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.reference.conduction import holm_resistance

pytestmark = pytest.mark.bench

FORCES = np.geomspace(0.01, 100.0, 1000)
SILVER = wk.ElectricalConductor(15.9e-9, temperature_coefficient=3.8e-3)
TIN = wk.ElectricalConductor(115e-9, temperature_coefficient=3.8e-3)
BODIES = {
    "clean": (SILVER, SILVER, wk.SurfaceFilm()),
    "film": (SILVER, SILVER, wk.SurfaceFilm(1e-12)),
    "rods": (wk.Rod(SILVER, 1e-3, 1e-2), wk.Rod(SILVER, 1e-3, 1e-2), wk.SurfaceFilm()),
    "plated": (wk.Plated(TIN, 2e-6, on=SILVER), SILVER, wk.SurfaceFilm()),
}


@pytest.fixture
def rivet() -> wk.Foundation:
    silver = wk.Elastic(83e9, 0.37)
    return wk.Foundation(wk.Paraboloid(2e-3), wk.HalfSpace.between(silver, silver))


@pytest.mark.parametrize("name", BODIES)
def bench_a_thousand_loads(benchmark, below, rivet, name):
    pair = wk.ElectricalConductors(*BODIES[name])
    problem = wk.Constriction(wk.Indentation(rivet, wk.Force(FORCES)), pair)
    curve = benchmark.pedantic(problem.solve, rounds=50, warmup_rounds=2)
    if name == "clean":
        expected = holm_resistance(float(curve.radius[500]), first=15.9e-9, second=15.9e-9)
        assert curve.resistance[500] == pytest.approx(expected, rel=1e-12)
    below(20e-3 if name == "plated" else 10e-3, f"contact resistance, {name}, 1000 forces")


def bench_hot_contacts(benchmark, below, rivet):
    """A current through contacts whose resistance grows with the temperature: 200 forces."""
    pair = wk.ElectricalConductors(SILVER, TIN)
    problem = wk.JouleHeating(wk.Indentation(rivet, wk.Force(FORCES[::5])), pair, wk.Current(5.0))
    hot = benchmark.pedantic(problem.solve, rounds=20, warmup_rounds=1)
    assert np.all(hot.resistance > hot.cold_resistance)
    below(200e-3, "Joule heat of a given current, 200 forces")


def bench_a_cluster(benchmark, below):
    """A hundred spots, each of one voltage with all others."""
    x, y = (part.ravel() for part in np.meshgrid(np.arange(10.0), np.arange(10.0)))
    problem = wk.SpotCluster(x, y, np.full(100, 0.3), SILVER, SILVER)
    cluster = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert cluster.resistance == pytest.approx(cluster.greenwood, rel=0.1)
    below(10.0, "a cluster of 100 spots")
