"""Springs that stick and slip: how many of them go through a step in a second, and what a whole problem takes.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
The fastest round counts: one core, arrays in the fastest memory, at whatever clock that core runs.
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.loading.path import Path
from winkler.numerics.springs.slip_kernels import march_line
from winkler.numerics.springs.slip_plane import march_plane

pytestmark = pytest.mark.bench

STEPS = 1000
TIME = np.arange(STEPS + 1.0)


def row(count: int) -> tuple[np.ndarray, ...]:
    """Return gaps, stiffnesses and bounds per depth of springs that are all in contact at unit depth."""
    x = np.linspace(0.0, 1.0, count, endpoint=False)
    return x * x, np.full(count, 1.0 / count), np.full(count, 0.4)


@pytest.mark.parametrize("count", [500, 4000])
@pytest.mark.parametrize("pressing", ["held", "pumped"])
def bench_springs_along_a_line(benchmark, below, count, pressing):
    """A fretting loop, at constant depth or with a depth that changes too: 2e9, or 1e9, springs and steps a second."""
    gap, stiffness, slope = row(count)
    depth = np.ones(STEPS + 1) if pressing == "held" else 1.0 + 0.1 * np.sin(0.07 * TIME)
    shift = 0.3 * np.sin(0.13 * TIME)
    u = np.zeros(count)
    force, stored, lost = np.zeros((3, STEPS))

    def run():
        march_line(u, gap, stiffness, slope, depth, shift, force, stored, lost)

    benchmark.pedantic(run, rounds=200, warmup_rounds=5)
    assert lost.min() >= 0.0
    rate = 2e9 if pressing == "held" else 1e9
    below(count * STEPS / rate, f"{count} springs, {STEPS} steps of a loop, depth {pressing}")


@pytest.mark.parametrize("amplitude", [0.1, 0.3])
def bench_springs_in_the_plane(benchmark, below, amplitude):
    """A circular path; the shift of sliding is 0.4: an eighth, or half, of the springs slip in every step."""
    count = 500
    gap, stiffness, slope = row(count)
    depth = np.ones(STEPS + 1)
    shift = amplitude * np.column_stack([np.cos(0.13 * TIME), np.sin(0.13 * TIME)])
    u, slips, bound = np.zeros((2, count)), np.zeros(count, dtype=bool), slope * (depth[:, np.newaxis] - gap)
    force, stored, lost = np.zeros((STEPS, 2)), np.zeros(STEPS), np.zeros(STEPS)

    def run():
        march_plane(u, slips, gap, stiffness, bound, 1.0, depth, shift, force, stored, lost)

    benchmark.pedantic(run, rounds=100, warmup_rounds=3)
    assert lost.min() >= 0.0
    rate = 1.8e8 if amplitude == 0.1 else 8e7
    below(count * STEPS / rate, f"{count} springs, {STEPS} steps of a circle, radius {amplitude / 0.4:.0%} of sliding")


LOOPS = {
    "shift": (lambda full: wk.Shift(0.5 * full * np.sin(0.1 * TIME)), 5e-3),
    "shear force": (lambda full: wk.ShearForce(60.0 * np.sin(0.1 * TIME)), 30e-3),
    "plane": (lambda full: wk.Shift(0.5 * full * np.column_stack([np.sin(0.1 * TIME), np.cos(0.07 * TIME)])), 25e-3),
}


@pytest.mark.parametrize("name", LOOPS)
def bench_a_loop_of_a_thousand_steps(benchmark, below, steel_on_steel, name):
    """From bed, law and path to forces and energies: 500 springs, 1,000 steps."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel)
    depth = wk.Indentation(bed, wk.Force(1000.0)).solve().depth
    lateral, most = LOOPS[name]
    full = 0.3 * depth * steel_on_steel.modulus / steel_on_steel.shear_modulus
    problem = wk.Tangential(bed, Coulomb(0.3), Path(TIME, wk.Depth(depth), lateral(full)), wk.Method.SPRINGS, 500)
    trace = benchmark.pedantic(problem.solve, rounds=20, warmup_rounds=2)
    assert np.all(np.diff(trace.dissipation) >= 0.0)
    below(most, f"500 springs, {STEPS} steps, {name}")


TURNS = 10_000
SWINGS = {
    "shrinking": (-1.0) ** np.arange(TURNS) * (1.0 - np.arange(TURNS) / TURNS),
    "growing": (-1.0) ** np.arange(TURNS) * (np.arange(TURNS) + 1.0) / TURNS,
    "random": np.random.default_rng(3).uniform(-1.0, 1.0, TURNS),
}


@pytest.mark.parametrize("load", [wk.Shift, wk.ShearForce])
@pytest.mark.parametrize("name", SWINGS)
def bench_ten_thousand_turning_points(benchmark, below, steel_on_steel, name, load):
    """Under a steady load, all that are not closed are remembered: less than a second, energies included."""
    bed, force = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel), 1000.0
    depth = wk.Indentation(bed, wk.Force(force)).solve().depth
    most = 0.25 * depth if load is wk.Shift else 0.27 * force
    problem = wk.Tangential(bed, Coulomb(0.3), Path(np.arange(TURNS) * 1.0, wk.Force(force), load(most * SWINGS[name])))
    solution = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert np.all(np.diff(solution.dissipation) >= 0.0)
    below(1.0, f"{TURNS} turning points, {name}, {load.__name__}")


def bench_ten_thousand_turning_points_on_a_coating(benchmark, below):
    """Where slip is followed by rings: a second, the tables of the layers computed before."""
    layer = wk.Layer(wk.Elastic(400e9, 0.3), thickness=2e-6)
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.CoatedHalfSpace([layer], on=wk.Elastic(40e9, 0.3)))
    path = Path(np.arange(TURNS) * 1.0, wk.Force(0.05), wk.Shift(4e-9 * SWINGS["shrinking"]))
    problem = wk.Tangential(bed, Coulomb(0.3), path)
    solution = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert np.all(np.diff(solution.dissipation) >= 0.0)
    below(1.0, f"{TURNS} turning points on a coating")


def bench_turning_points_at_depths_that_change(benchmark, below, steel_on_steel):
    """Straight steps of shift and depth, one by one: 0.2 ms each."""
    count = 1_000
    bed, turns = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel), np.arange(count)
    depth = wk.Indentation(bed, wk.Force(1000.0)).solve().depth * (1.0 + 0.2 * SWINGS["random"][turns])
    path = Path(turns * 1.0, wk.Depth(depth), wk.Shift(0.25 * depth * SWINGS["random"][-count:]))
    problem = wk.Tangential(bed, Coulomb(0.3), path)
    solution = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert np.all(np.diff(solution.dissipation) >= 0.0)
    below(0.2, f"{count} turning points of shift and depth")


@pytest.mark.parametrize("load", [wk.Shift, wk.ShearForce])
def bench_a_loop_of_a_thousand_points_on_a_coating(benchmark, below, load):
    """Under a steady load, by turning points: 1 s, the tables of the layers computed before."""
    layer = wk.Layer(wk.Elastic(400e9, 0.3), thickness=2e-6)
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.CoatedHalfSpace([layer], on=wk.Elastic(40e9, 0.3)))
    swing = np.sin(6.0 * np.pi * np.linspace(0.0, 1.0, 1000)) * (4e-9 if load is wk.Shift else 5e-3)
    problem = wk.Tangential(bed, wk.Coulomb(0.3), wk.Path(np.linspace(0.0, 1.0, 1000), wk.Force(0.05), load(swing)))
    problem.solve()
    assert benchmark(problem.solve).dissipation[-1] > 0.0
    below(1.0, f"loop of a thousand points on a coating, {load.__name__}")


@pytest.mark.parametrize("by", [wk.Torque, wk.Angle])
def bench_a_twist_under_a_force_that_changes(benchmark, below, steel_on_steel, by):
    """Nine turning points of both: half a second."""
    bed, turn = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel), np.arange(9.0)
    radius = float(wk.Indentation(bed, wk.Force(100.0)).solve().radius)
    most = 3.0 * np.pi / 16.0 * 0.3 * 100.0 * radius
    twist = (-1.0) ** turn * (0.4 * most if by is wk.Torque else 1e-4)
    path = wk.Path(turn, wk.Force(100.0 * (1.0 + 0.4 * np.sin(1.3 * turn))), by(twist))
    problem = wk.Torsion(bed, wk.Coulomb(0.3), path)
    solution = benchmark.pedantic(problem.solve, rounds=3, warmup_rounds=1)
    assert np.all(np.diff(solution.dissipation) >= 0.0)
    below(0.5, f"nine turning points of a force and {by.__name__}")
