"""Line contacts that slip: marches of 1,000 steps, beside those of a round body, and the stress below one state.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEPS = 1000
TIME = np.arange(STEPS + 1.0)
SHEAR = 30e3 * np.sin(0.1 * TIME)
PATHS = {
    "steady": (wk.LinePath(1e5, SHEAR), 0.25),
    "pumped": (wk.LinePath(1e5 * (1.0 + 0.1 * np.sin(0.07 * TIME)), SHEAR), 0.3),
    "beside a bulk stress": (wk.LinePath(1e5, SHEAR, bulk_stress=100e6), 1.0),
}


@pytest.mark.parametrize("name", PATHS)
def bench_a_line_that_frets(benchmark, below, steel_on_steel, name):
    """From bed, law and path to stick, slip and loss: without a bulk stress 0.2 ms a step."""
    path, most = PATHS[name]
    problem = wk.LineTangential(wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel), wk.Coulomb(0.5), path)
    solution = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(solution.dissipation_per_length) >= 0.0)
    below(most, f"{STEPS} steps, {name}")


def bench_a_line_that_frets_out_of_phase(benchmark, below, steel_on_steel):
    """400 boundary elements: some ms a step, several steps for a point of the path."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel)
    path = wk.LinePath(1e5, SHEAR[:201], bulk_stress=1e8 * np.sin(0.1 * TIME[:201] + 1.0))
    problem = wk.LineTangential(bed, wk.Coulomb(0.5), path)
    solution = benchmark.pedantic(problem.solve, rounds=2)
    assert np.all(np.diff(solution.dissipation_per_length) >= 0.0)
    below(3.0, "200 points out of phase")


def bench_a_line_under_a_load_that_changes_beside_a_bulk_stress(benchmark, below, steel_on_steel):
    """Nine turning points, 600 elements, 650 steps: what sticks is solved with the factors of a step before."""
    bed, turn = wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel), np.arange(9.0)
    load, shear = 1e5 * (1.0 + 0.4 * np.sin(1.3 * turn)), 15e3 * (-1.0) ** turn
    path = wk.LinePath(load, shear, bulk_stress=3e7 * np.sin(2.1 * turn + 1.0))
    problem = wk.LineTangential(bed, wk.Coulomb(0.5), path)
    solution = benchmark.pedantic(problem.solve, rounds=2)
    assert np.all(np.diff(solution.dissipation_per_length) >= 0.0)
    below(2.0, "nine turning points of both forces and of a bulk stress")


def bench_a_round_body_that_frets(benchmark, below, steel_on_steel):
    """The same memory under a ball, at steady depth: as fast."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel)
    path = wk.Path(TIME, wk.Depth(10e-6), wk.Shift(1e-6 * np.sin(0.1 * TIME)))
    problem = wk.Tangential(bed, wk.Coulomb(0.3), path)
    solution = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(solution.dissipation) >= 0.0)
    below(0.25, f"{STEPS} steps of a round body")


def bench_the_stress_below_a_line_that_frets(benchmark, below, steel_on_steel):
    """10,000 places, two earlier contacts."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel)
    state = wk.LineTangential(bed, wk.Coulomb(0.5), wk.LinePath(1e5, [0.0, 3e4, -1e4], bulk_stress=5e7)).solve().at(-1)
    x, z = np.linspace(-2e-4, 2e-4, 100), np.linspace(0.0, 2e-4, 100)
    fields = benchmark.pedantic(lambda: state.stresses(x[:, None], z[None, :]), rounds=10, warmup_rounds=1)
    assert np.all(np.isfinite(fields.von_mises))
    below(50e-3, "100 x 100 places")
