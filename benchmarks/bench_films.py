"""Thin films on a rigid base: force curves and fits, every table forgotten before each round.

Run it:  pytest benchmarks/bench_films.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from film_tables import forget

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.materials.elastic import Solid
from winkler.profiles.profile import Profile

pytestmark = pytest.mark.bench

THICKNESS = 5e-6
SHAPES = {
    "cone": lambda a: wk.Cone(1.5),
    "paraboloid": lambda a: wk.Paraboloid(50.0 * a),
    "sphere": lambda a: wk.Sphere(50.0 * a),
    "rounded cone": lambda a: wk.RoundedCone(curvature_radius=0.5 * a, half_angle=1.5),
}
FREE = ["bed.medium.layers[0].solid.young", "bed.medium.layers[0].thickness", "contact_point"]


def film(young: float, thickness: float, poisson: float) -> wk.CoatedHalfSpace:
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, poisson), thickness)], on=wk.Rigid())


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("width", [0.001, 1.0, 30.0, 100.0])
def bench_force_curve(benchmark, below, name, width):
    """200 depths up to contacts so many times as wide as an incompressible film is thick."""
    a = width * THICKNESS
    bed = wk.Foundation(SHAPES[name](a), film(1e3, THICKNESS, 0.5))
    deepest = float(bed.gap(np.array([a]))[0])

    def curve() -> wk.IndentationSolution:
        return wk.Indentation(bed, wk.Depth(np.linspace(0.0, deepest, 201)[1:])).solve()

    found = benchmark.pedantic(curve, setup=forget, rounds=3)
    assert found.radius[-1] == pytest.approx(a, rel=1e-9)
    below(1.0, f"incompressible film, {name}, F at 200 depths up to a/h = {width:g}, from nothing")


TURNING = {
    "sharpened tip": lambda a: wk.CappedParaboloid(50.0 * a, 49.0 * a, 0.3 * a),
    "sharpened tip on a cylinder": lambda a: wk.CappedCylinder(2.0 * a, TURNING["sharpened tip"](a)),
    "weak waves": lambda a: wk.Paraboloid(50.0 * a) + wk.Wavy(5e-5 * a, 0.2 * a),
}


@pytest.mark.parametrize("name", TURNING)
@pytest.mark.parametrize("width", [0.001, 1.0, 10.0, 100.0])
def bench_force_curve_of_a_turning_profile(benchmark, below, name, width):
    """The same for shapes whose g is not known to rise: all contacts are checked for tension and overlap."""
    a = width * THICKNESS
    bed = wk.Foundation(TURNING[name](a), film(1e3, THICKNESS, 0.5))
    deepest = float(bed.gap(np.array([a]))[0])

    def curve() -> wk.IndentationSolution:
        return wk.Indentation(bed, wk.Depth(np.linspace(0.0, deepest, 201)[1:])).solve()

    found = benchmark.pedantic(curve, setup=forget, rounds=3)
    assert found.radius[-1] == pytest.approx(a, rel=1e-9)
    below(3.0, f"incompressible film, {name}, F at 200 depths up to a/h = {width:g}, from nothing")


def _fit(shape: Profile, base: Solid) -> wk.Fit:
    def model(young: float, thickness: float) -> wk.Indentation:
        layer = wk.Layer(wk.Elastic(young, 0.5), thickness)
        return wk.Indentation(wk.Foundation(shape, wk.CoatedHalfSpace([layer], on=base)), wk.Depth(0.0))

    position = np.linspace(-1e-6, 1e-6, 2000)
    force = dataclasses.replace(model(1.2e3, 2e-6), load=wk.Depth(position)).solve().force
    noise = 1e-3 * np.max(force) * np.random.default_rng(4).standard_normal(2000)
    curve = ForceCurve(position + 3e-6, force + noise)
    forget()
    return fit(curve, model(5e3, 4e-6), free=FREE)


@pytest.mark.parametrize("name", ["cone", "paraboloid", "sphere"])
def bench_fit_on_a_rigid_base(benchmark, below, name):
    """2,000 points; modulus, thickness and contact point free."""
    shape = {"cone": wk.Cone(1.2), "paraboloid": wk.Paraboloid(5e-6), "sphere": wk.Sphere(5e-6)}[name]
    found = benchmark.pedantic(_fit, args=(shape, wk.Rigid()), rounds=3)
    assert found.values == pytest.approx([1.2e3, 2e-6, 3e-6], rel=0.1)
    below(3.0, f"film on a rigid base, {name}, fit of 2,000 points, three free numbers")


def bench_fit_on_glass(benchmark, below):
    """The same on an elastic base: every modulus is another contrast, and needs tables of its own."""
    found = benchmark.pedantic(_fit, args=(wk.Paraboloid(5e-6), wk.Elastic(70e9, 0.2)), rounds=3)
    assert found.values == pytest.approx([1.2e3, 2e-6, 3e-6], rel=0.1)
    below(10.0, "film on glass, paraboloid, fit of 2,000 points, three free numbers")
