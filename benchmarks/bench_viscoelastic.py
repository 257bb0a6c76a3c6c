"""Viscoelastic marches: a hundred thousand steps, half as many springs, terms or steps, forces, and an impact.

Run it:  pytest benchmarks/bench_viscoelastic.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import Maxwell
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.impact import ViscoelasticImpact
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation

pytestmark = pytest.mark.bench

STEPS, SPRINGS, TERMS = 100_000, 500, 5


def oscillating(steps: int, springs: int, terms: int) -> ViscoelasticIndentation:
    """Five cycles of pressing in and coming back to the surface, with touch lost in each of them."""
    solid = Prony(0.05, [0.2 / terms] * terms, np.geomspace(1e-3, 10.0, terms))
    bed = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))
    t = np.linspace(0.0, 10.0, steps)
    return ViscoelasticIndentation(bed, Path(t, wk.Depth(0.5 * (1.0 - np.cos(np.pi * t)))), count=springs)


def marched(benchmark, problem: ViscoelasticIndentation) -> None:
    problem_of_few = oscillating(10, 10, TERMS)
    problem_of_few.solve()  # compiled before it is timed
    found = benchmark.pedantic(problem.solve, rounds=3, iterations=1)
    assert found.force.size == problem.path.time.size
    assert found.dissipation[-1] > 0.0


def bench_hundred_thousand_steps(benchmark, below):
    marched(benchmark, oscillating(STEPS, SPRINGS, TERMS))
    below(5.0, "1e5 steps of 500 springs with 5 terms")


@pytest.mark.parametrize(
    "size",
    [(STEPS // 2, SPRINGS, TERMS), (STEPS, SPRINGS // 2, TERMS), (STEPS, 2 * SPRINGS, TERMS), (STEPS, SPRINGS, 10)],
    ids=["half the steps", "half the springs", "twice the springs", "twice the terms"],
)
def bench_what_it_grows_with(benchmark, below, size):
    marched(benchmark, oscillating(*size))
    below(5.0 * np.prod(size) / (STEPS * SPRINGS * TERMS), "in proportion to steps, springs and terms")


@pytest.mark.parametrize("solid", [Maxwell(0.25, 0.3), Prony(0.05, [0.04] * TERMS, np.geomspace(1e-3, 10.0, TERMS))])
def bench_forces(benchmark, below, solid):
    """Two cycles of 500 points under forces, each step chosen by its error: three times the march by depths."""
    bed = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(solid))
    t = np.linspace(0.0, 2.0, 1000)
    problem = ViscoelasticIndentation(bed, Path(t, wk.Force(0.01 * np.sin(np.pi * t) ** 2)))
    problem.solve()
    assert benchmark(problem.solve).depth.max() > 0.0
    below(30e-3, "1000 points under forces")


def bench_film(benchmark, below):
    """A film that relaxes on a body that does not, in, held and back: 1,000 points, 500 cells."""
    solid = Prony(1e3, [2e3, 2e3], [0.1, 2.0], poisson=0.48)
    film = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid, 20e-6)], on=wk.Elastic(1e4, 0.3))
    bed = wk.Foundation(wk.Paraboloid(1e-3), film)
    t = np.linspace(0.0, 4.0, 1000)
    path = Path(t, wk.Depth(2e-6 * np.interp(t, [0.0, 1.0, 3.0, 4.0], [0.0, 1.0, 1.0, 0.2])))
    problem = ViscoelasticIndentation(bed, path, count=500)
    problem.solve()
    assert benchmark.pedantic(problem.solve, rounds=3, iterations=1).dissipation[-1] > 0.0
    below(2.0, "1000 points on a film that relaxes")


def bench_line(benchmark, below):
    """Ten cycles of a line contact, 20 points and 33 relaxation times each, 500 springs: 2 s."""
    solid = wk.PowerLawSolid(shear=1e6, time_scale=1.0, exponent=0.3, shortest=1e-4, longest=1e3)
    bed = wk.LineFoundation(wk.Paraboloid(0.01), ViscoelasticHalfSpace(solid))
    path = wk.LineForcePath([0.0, 1.0, 2.0], [0.0, 1e3, 0.0], cycles=10, count=10)
    problem = wk.LineViscoelasticIndentation(bed, path)
    problem.solve()
    assert benchmark(problem.solve).half_width.max() > 0.0
    below(2.0, "ten cycles of a line contact")


def bench_impact(benchmark, below):
    bed = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(Maxwell(0.25, 1.0)))
    problem = ViscoelasticImpact(bed, mass=1.0, velocity=1.0)
    problem.solve()
    assert benchmark(problem.solve).restitution > 0.28
    below(0.5, "an impact to five digits")
