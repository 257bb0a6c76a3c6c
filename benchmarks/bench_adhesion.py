"""Adhesive contacts: whole curves, branches of wavy bodies, Maugis' rings.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.problems.adhesion import stability
from winkler.problems.adhesion.equilibrium import Equilibrium
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.maugis import _zone
from winkler.problems.line import cohesive
from winkler.profiles import line_transform

pytestmark = pytest.mark.bench

RUBBER = wk.HalfSpace.between(wk.Elastic(1.5e6, 0.5))
BALL = wk.Foundation(wk.Paraboloid(10e-3), RUBBER)
LAW = ShortRange(0.07)


def forget():
    """Empty the caches, so that every round starts from nothing."""
    stability._branches.cache_clear()
    stability._least_radius.cache_clear()
    stability._typical.cache_clear()
    _zone.cache_clear()


def bench_equilibrium_curve(benchmark, below):
    """The whole JKR curve: 1,000 points and its limits of stability."""
    problem = Equilibrium(BALL, LAW, reach=1e-3)
    curve = benchmark.pedantic(problem.solve, setup=forget, rounds=30, warmup_rounds=2)
    assert curve.radius.size >= 1000
    below(10e-3, "JKR equilibrium curve, 1,000 points")


def bench_force_curve(benchmark, below):
    """F at 2,000 depths of an adhesive ball, as a fit needs it."""
    problem = AdhesiveIndentation(BALL, LAW, wk.Depth(np.linspace(-1e-6, 5e-5, 2000)))
    contact = benchmark.pedantic(problem.solve, setup=forget, rounds=20, warmup_rounds=2)
    assert np.all(np.diff(contact.force) > 0.0)
    below(30e-3, "JKR, F at 2,000 depths")


def bench_maugis_force_curve(benchmark, below):
    """The same with a cohesive ring."""
    problem = AdhesiveIndentation(BALL, Dugdale(0.07, 2e4), wk.Depth(np.linspace(-1e-6, 5e-5, 2000)))
    contact = benchmark.pedantic(problem.solve, setup=forget, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(contact.radius) > 0.0)
    below(500e-3, "Maugis, F at 2,000 depths")


def bench_line_in_an_attraction_with_a_range(benchmark, below):
    """A cylinder whose load profile is an integral, 20 forces per length, nothing cached: 400 ms."""
    bed = wk.LineFoundation(wk.Sphere(10e-3), wk.HalfSpace(wk.Elastic(2e6, 0.5)))
    problem = wk.LineAdhesion(bed, Dugdale(0.05, 2e4), wk.LineForce(np.linspace(-0.1, 5.0, 20)))

    def forget_the_line():
        for cached in (line_transform._octaves, cohesive._zone, cohesive._end):
            cached.cache_clear()

    contact = benchmark.pedantic(problem.solve, setup=forget_the_line, rounds=5, warmup_rounds=1)
    assert np.all(np.diff(contact.half_width) > 0.0)
    below(400e-3, "Maugis' line of a circle, 20 forces")


def bench_surfaces_beside_a_line(benchmark, below):
    """The distance of the surfaces at 60 places beside the same cylinder: 200 ms."""
    bed = wk.LineFoundation(wk.Sphere(10e-3), wk.HalfSpace(wk.Elastic(2e6, 0.5)))
    contact = wk.LineIndentation(bed, wk.LineForce(50.0)).solve()
    x = float(contact.half_width) * np.linspace(1.0, 4.0, 60)
    apart = benchmark.pedantic(contact.separation, (x,), rounds=5, warmup_rounds=1)
    assert np.all(np.diff(apart) > 0.0)
    below(200e-3, "60 places beside a line")


def bench_hundred_waves(benchmark, below):
    """All branches of a wavy ball with a hundred waves in the contact."""
    wavy = wk.Sum((wk.Paraboloid(1.0), wk.Wavy(1e-4, 0.01)))
    bed = wk.Foundation(wavy, wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    problem = Equilibrium(bed, ShortRange(1e-7), reach=1.0)
    curve = benchmark.pedantic(problem.solve, setup=forget, rounds=10, warmup_rounds=1)
    assert len(curve.branches) == 98
    below(200e-3, "wavy ball, 98 stable branches")
