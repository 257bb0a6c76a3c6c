"""Wear: ten thousand cycles on the finest grid of daily use, and what one look at the worn contact takes.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.problems.wear.grids import wear_grid

pytestmark = pytest.mark.bench

COUNT = 400
MU = 0.5


def fretting(medium: wk.HalfSpace, rate: float, count: int = COUNT) -> wk.FrettingWear:
    """Return ten thousand cycles of a steel ball that sticks within half of its contact."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), medium)
    swing = wk.Shift(MU * medium.modulus / medium.shear_modulus * 0.75e-6)
    cycles = np.array([0.0, 100.0, 1000.0, 10000.0])
    return wk.FrettingWear(bed, wk.Archard(rate), wk.Coulomb(MU), wk.Depth(1e-6), swing, cycles, count=count)


@pytest.mark.parametrize("rate", [1e-14, 1e-12, 1e-10], ids=["hardly worn", "half worn", "to the limit"])
def bench_ten_thousand_cycles(benchmark, below, steel_on_steel, rate):
    """From the first cycle until the ring bears nothing any more: under 20 s."""
    problem = fretting(steel_on_steel, rate)
    worn = benchmark.pedantic(problem.solve, rounds=1, warmup_rounds=0)
    assert worn.worn_volume[-1] > 0.0
    below(20.0, f"10,000 cycles of fretting on {COUNT} rings, rate {rate:g} 1/Pa")


def bench_ten_thousand_cycles_on_a_coating(benchmark, below, steel_on_steel):
    """The same with the normal and shear kernels of layers: under 20 s."""
    steel = steel_on_steel.first
    soft = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(21e9, 0.3), 30e-6)], on=steel, second=steel)
    bed = wk.Foundation(wk.Paraboloid(10e-3), soft)
    press, swing, cycles = wk.Depth(1e-6), wk.Shift(0.455e-6), np.array([0.0, 100.0, 1000.0, 10000.0])
    problem = wk.FrettingWear(bed, wk.Archard(1e-12), wk.Coulomb(MU), press, swing, cycles, count=COUNT)
    worn = benchmark.pedantic(problem.solve, rounds=1, warmup_rounds=0)
    assert worn.worn_volume[-1] > 0.0
    below(20.0, f"10,000 cycles of fretting on {COUNT} rings of a coating, to nine tenths of the limit")


def bench_one_look(benchmark, below, steel_on_steel):
    """Depth, pressure and slip of a worn profile: under 2 ms."""
    problem = fretting(steel_on_steel, 1e-14)
    state = next(problem.steps())
    grid = wear_grid(problem.bed, state.radii)
    worn = 1e-3 * state.height

    def look():
        contact = grid.press(worn, problem.normal)
        return grid.rub(contact, MU, float(problem.amplitude.shift))

    look()
    benchmark.pedantic(look, rounds=200, warmup_rounds=5)
    below(2e-3, f"pressure and slip on {COUNT} rings")


def bench_a_ball_slides_any_distance(benchmark, below, steel_on_steel):
    """A hundred kilometres of sliding: under 10 s."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel)
    problem = wk.SlidingWear(bed, wk.Archard(1e-14), wk.Force(10.0), np.array([0.0, 1.0, 1e3, 1e5]), count=COUNT)
    worn = benchmark.pedantic(problem.solve, rounds=1, warmup_rounds=0)
    np.testing.assert_allclose(worn.worn_volume[1:], 1e-13 * worn.distance[1:], rtol=1e-9)
    below(10.0, f"a ball slides 100 km, {COUNT} rings")


def bench_a_million_cycles_of_a_line(benchmark, below, steel_on_steel):
    """A cylinder frets until only what sticks bears: under 20 s."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel)
    press, swing, cycles = wk.LineForce(100e3), wk.LineShearForce(37.5e3), np.array([0.0, 1e4, 1e5, 1e6])
    problem = wk.LineFrettingWear(bed, wk.Archard(1e-14), wk.Coulomb(MU), press, swing, cycles, count=COUNT)
    worn = benchmark.pedantic(problem.solve, rounds=1, warmup_rounds=0)
    np.testing.assert_allclose(worn.stick_half_width, 0.5 * worn.half_width[0], rtol=1e-6)
    below(20.0, f"a million cycles of a fretting cylinder on {COUNT} strips")


def bench_a_roller_slides_a_kilometre(benchmark, below, steel_on_steel):
    """A roller is worn to a flat over a kilometre: under 20 s."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel)
    problem = wk.LineSlidingWear(bed, wk.Archard(1e-14), wk.LineForce(10e3), np.array([0.0, 1.0, 1e3]), count=COUNT)
    worn = benchmark.pedantic(problem.solve, rounds=1, warmup_rounds=0)
    np.testing.assert_allclose(worn.worn_volume_per_length[1:], 1e-10 * worn.distance[1:], rtol=1e-9)
    below(60.0, f"a roller slides a kilometre, {COUNT} strips")
