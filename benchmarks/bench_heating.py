"""Frictional heating: one contact, curves over speed and load, a map, and a contact that begins to rub.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.ThermalConductor(conductivity=45.0, diffusivity=12e-6)
PAIR = wk.HeatConductors(STEEL, STEEL)
SPEEDS = np.geomspace(0.01, 10.0, 200)


def rubbing(medium: wk.HalfSpace, load: wk.Force, speed: float | np.ndarray) -> wk.FrictionHeating:
    bed = wk.Foundation(wk.Paraboloid(10e-3), medium)
    return wk.FrictionHeating(wk.Indentation(bed, load), wk.Coulomb(0.3), PAIR, first_speed=speed)


def bench_one_speed(benchmark, below, steel_on_steel):
    """Flash and mean temperatures of both bodies, and how they share the heat, at one speed."""
    problem = rubbing(steel_on_steel, wk.Force(20.0), 1.0)
    found = benchmark.pedantic(problem.solve, rounds=50, warmup_rounds=2)
    assert found.flash_temperature < found.stationary_temperature
    below(20e-3, "flash temperature of a ball at one speed")


def bench_two_hundred_speeds(benchmark, below, steel_on_steel):
    """The same over three decades of the speed."""
    problem = rubbing(steel_on_steel, wk.Force(20.0), SPEEDS)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(found.flash_temperature) > 0.0)
    below(4.0, "flash temperatures of a ball at 200 speeds")


def bench_a_hundred_loads(benchmark, below, steel_on_steel):
    """A hundred loads at one speed: every load has a source of its own."""
    problem = rubbing(steel_on_steel, wk.Force(np.linspace(1.0, 100.0, 100)), 1.0)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(found.flash_temperature) > 0.0)
    below(3.0, "flash temperatures of a ball under 100 loads")


def bench_map(benchmark, below, steel_on_steel):
    """The surface of the moving body at 2,000 places."""
    body = rubbing(steel_on_steel, wk.Force(20.0), 1.0).solve().first
    a = body.half_length
    x, y = np.meshgrid(np.linspace(-2.0, 4.0, 80) * a, np.linspace(0.0, 2.0, 25) * a)
    found = benchmark.pedantic(lambda: body.temperature(x, y), rounds=5, warmup_rounds=1)
    assert np.all(found >= 0.0)
    below(3.0, "temperature of a moving surface at 2,000 places")


def bench_beginning(benchmark, below, steel_on_steel):
    """A contact that warms up, at a hundred times."""
    bed = wk.Foundation(wk.Paraboloid(10e-3), steel_on_steel)
    time = np.geomspace(1e-5, 1.0, 100)
    problem = wk.TransientHeating(wk.Indentation(bed, wk.Force(20.0)), wk.Coulomb(0.3), PAIR, speed=0.01, time=time)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(found.flash_temperature) > 0.0)
    below(0.3, "a ball that warms up, at 100 times")


def bench_line_speeds(benchmark, below, steel_on_steel):
    """Flash and mean temperatures of two discs in line contact, at fifty speeds."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), steel_on_steel)
    speeds = np.geomspace(0.1, 10.0, 50)
    problem = wk.LineFrictionHeating(
        wk.LineIndentation(bed, wk.LineForce(100e3)), wk.Coulomb(0.1), PAIR, 2.0 * speeds, speeds
    )
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(found.flash_temperature) > 0.0)
    below(3.0, "flash temperatures of two discs at 50 speeds")


def bench_ellipse_speeds(benchmark, below, steel_on_steel):
    """The same of an ellipse that slides askew."""
    speeds = np.geomspace(0.1, 10.0, 50)
    contact = wk.EllipticIndentation(wk.CurvedBodies(40e-3, 5e-3), steel_on_steel, wk.Force(20.0))
    problem = wk.FrictionHeating(contact, wk.Coulomb(0.1), PAIR, first_speed=speeds, first_direction=0.5)
    found = benchmark.pedantic(problem.solve, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(found.flash_temperature) > 0.0)
    below(3.0, "flash temperatures of an ellipse at 50 speeds")
