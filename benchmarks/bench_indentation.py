"""The solver: one Hertz contact, and a thousand loads in one call.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.reference.hertz import hertz_radius
from winkler.reference.sphere import sphere_force

pytestmark = pytest.mark.bench

RADIUS = 10e-3
LOADS = np.linspace(1.0, 1000.0, 1000)
SHAPES = {"paraboloid": wk.Paraboloid(RADIUS), "sphere": wk.Sphere(RADIUS)}


def force_of(shape: wk.Shape, radius: np.ndarray | float, modulus: float) -> np.ndarray:
    """The force at a contact radius, by the closed form."""
    if isinstance(shape, wk.Sphere):
        return sphere_force(radius, curvature_radius=RADIUS, modulus=modulus)
    return 4.0 * modulus / (3.0 * RADIUS) * np.asarray(radius) ** 3


@pytest.mark.parametrize("name", SHAPES)
def bench_one_load(benchmark, below, steel_on_steel, name):
    """From the bodies to depth, force and radius: everything is built anew in each round."""

    def solve():
        bed = wk.Foundation(type(SHAPES[name])(RADIUS), steel_on_steel)
        return wk.Indentation(bed, wk.Force(100.0)).solve()

    contact = benchmark.pedantic(solve, rounds=2000, warmup_rounds=50)
    assert force_of(SHAPES[name], contact.radius, steel_on_steel.modulus) == pytest.approx(100.0, rel=1e-12)
    below(200e-6, f"steel {name} on steel, one force")


@pytest.mark.parametrize("name", SHAPES)
def bench_a_thousand_loads(benchmark, below, steel_on_steel, name):
    """A thousand forces in one call."""
    problem = wk.Indentation(wk.Foundation(SHAPES[name], steel_on_steel), wk.Force(LOADS))
    curve = benchmark.pedantic(problem.solve, rounds=200, warmup_rounds=5)
    np.testing.assert_allclose(force_of(SHAPES[name], curve.radius, steel_on_steel.modulus), LOADS, rtol=1e-12)
    if name == "paraboloid":
        expected = hertz_radius(LOADS, curvature_radius=RADIUS, modulus=steel_on_steel.modulus)
        np.testing.assert_allclose(curve.radius, expected, rtol=1e-13)
    below(5e-3, f"steel {name} on steel, 1,000 forces in one call")
