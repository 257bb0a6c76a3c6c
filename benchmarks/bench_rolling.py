"""Rolling: creep curves on the line and on the surface, and marches over springs.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.Elastic(208e9, 0.25)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
WHEEL = wk.Foundation(wk.Paraboloid(0.4), PAIR)
MU, LOAD = wk.Coulomb(0.3), wk.Force(80e3)
CURVE = np.linspace(0.0, 8e-3, 200)


@pytest.mark.parametrize("profile", [wk.Paraboloid(0.4), wk.Sphere(0.4), wk.Cone(half_angle=1.56)])
def bench_creep_curve_of_200_points(benchmark, below, profile):
    """On the line, for any profile: 50 ms."""
    problem = wk.Rolling(wk.Foundation(profile, PAIR), MU, wk.Creepage(CURVE), LOAD)
    assert np.all(np.diff(benchmark(problem.solve).saturation) > -1e-12)
    below(0.05, f"creep curve of 200 points, {type(profile).__name__}")


@pytest.mark.parametrize("spin", [0.0, 0.4])
def bench_simplified_creep_curve_of_200_points(benchmark, below, spin):
    """On the surface, 32 strips of 32 steps each: 50 ms."""
    problem = wk.SimplifiedRolling(wk.ContactEllipse(6e-3, 5e-3), PAIR, MU, wk.Creepage(CURVE, 0.0, spin), LOAD)
    assert np.max(benchmark(problem.solve).saturation) < 1.0 + 1e-9
    below(0.05, f"simplified creep curve of 200 points, spin {spin:g} 1/m")


def bench_start_of_rolling(benchmark, below):
    """A hundred states over two widths of the contact, 800 springs: 30 ms."""
    problem = wk.RollingStart(WHEEL, MU, wk.Creepage(1e-3), LOAD, 24e-3)
    solution = benchmark(problem.solve)
    assert abs(solution.shear_force[-1] / solution.steady.longitudinal_force - 1.0) < 1e-5
    below(0.03, "start of rolling, 800 springs")


def bench_rocking(benchmark, below):
    """Thirty cycles of 400 springs under a prescribed force: 30 ms."""
    problem = wk.OscillatingRolling(WHEEL, MU, 1e-3, 20e3, LOAD)
    assert benchmark(problem.solve).ratchets
    below(0.03, "thirty cycles of rocking, 400 springs")


ROLLER = wk.LineFoundation(wk.Paraboloid(0.5), PAIR)
RUBBER = wk.Prony(1e6, np.full(7, 1e6), np.geomspace(1e-5, 10.0, 7))


def bench_start_of_a_rolling_line(benchmark, below):
    """A hundred states over two widths of the strip, 160 elements: 300 ms."""
    load, pull = wk.LineForce(180e3), wk.LineShearForce(35e3)
    problem = wk.LineRollingStart(ROLLER, MU, pull, load, distance=4e-3)
    solution = benchmark(problem.solve)
    assert abs(solution.longitudinal_creepage[-1] / solution.steady.longitudinal_creepage - 1.0) < 5e-3
    below(0.3, "start of rolling of a line, 160 elements")


def bench_resistance_of_a_relaxing_track(benchmark, below):
    """A roller under a force at 50 speeds over seven decades, seven relaxation times: 300 ms."""
    bed = wk.LineFoundation(wk.Paraboloid(50e-3), wk.ViscoelasticHalfSpace(RUBBER))
    problem = wk.LineRollingResistance(bed, wk.LineForce(300.0), np.geomspace(1e-4, 1e3, 50))
    assert np.all(benchmark(problem.solve).coefficient > 0.0)
    below(0.3, "rolling resistance at 50 speeds, 7 relaxation times")


def bench_resistance_of_a_measured_spectrum(benchmark, below):
    """The same over 26 relaxation times of nine decades: 400 ms."""
    rubber = wk.Prony(1e5, np.full(26, 3e5), np.geomspace(1e-6, 1e3, 26))
    bed = wk.LineFoundation(wk.Paraboloid(50e-3), wk.ViscoelasticHalfSpace(rubber))
    problem = wk.LineRollingResistance(bed, wk.LineForce(300.0), np.geomspace(1e-4, 1e3, 50))
    assert np.all(benchmark(problem.solve).coefficient > 0.0)
    below(0.4, "rolling resistance at 50 speeds, 26 relaxation times")
