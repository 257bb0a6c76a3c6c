"""Coatings and graded bodies: stiffness, force curves, pressure and stresses below, all from nothing.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest
from film_tables import forget

import winkler as wk
from winkler.materials.depth_grading import ExponentialGrading
from winkler.materials.layered import Layer
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace

pytestmark = pytest.mark.bench

STACK = CoatedHalfSpace(
    [
        Layer(wk.Elastic(400e9, 0.2), 1e-6),
        Layer(wk.Elastic(120e9, 0.32), 0.3e-6),
        Layer(wk.Elastic(250e9, 0.28), 2e-6),
    ],
    on=wk.Elastic(210e9, 0.3),
)
BED = wk.Foundation(wk.Paraboloid(100e-6), STACK)
DEPTHS = np.linspace(0.0, 1e-6, 201)[1:]
"""Up to a contact three times wider than the coating is thick."""
SKIN = DepthGradedHalfSpace(ExponentialGrading(70e9, 210e9, depth_scale=3e-6, poisson=0.3))
STEEP = DepthGradedHalfSpace(ExponentialGrading(2.1e9, 210e9, depth_scale=3e-6, poisson=0.3))
STEEPEST = DepthGradedHalfSpace(ExponentialGrading(0.21e9, 210e9, depth_scale=3e-6, poisson=0.3))


def bench_first_stiffness(benchmark, below):
    """k of one radius on a stack that is new."""
    k = benchmark.pedantic(STACK.punch_stiffness, args=(np.array(2e-6),), setup=forget, rounds=5)
    assert 2.0 * 210e9 / 0.91 * 2e-6 < float(k) < 2.0 * 400e9 / 0.96 * 2e-6
    below(0.5, "three-layer coating, k of one radius, from nothing")


def _curve(medium) -> wk.IndentationSolution:
    return wk.Indentation(wk.Foundation(wk.Paraboloid(100e-6), medium), wk.Depth(DEPTHS)).solve()


def _is_its_own_derivative(curve) -> None:
    assert np.all(np.diff(curve.force) > 0.0)
    middle = slice(100, 120)
    slope = np.gradient(curve.force, curve.depth, edge_order=2)[middle]
    np.testing.assert_allclose(slope, curve.stiffness[middle], rtol=1e-4)


def bench_force_curve_on_three_layers(benchmark, below):
    """200 depths."""
    _is_its_own_derivative(benchmark.pedantic(_curve, args=(STACK,), setup=forget, rounds=5))
    below(1.0, "three-layer coating, F at 200 depths, from nothing")


def bench_first_stiffness_of_a_grading(benchmark, below):
    """k of one radius on a body graded in depth, to a millionth; E rises a hundredfold."""
    k = benchmark.pedantic(STEEP.punch_stiffness, args=(np.array(2e-6),), setup=forget, rounds=5)
    assert 2.0 * 2.1e9 / 0.91 * 2e-6 < float(k) < 2.0 * 210e9 / 0.91 * 2e-6
    below(1.0, "graded in depth (E ratio 100, tolerance 1e-6), k of one radius, from nothing")


@pytest.mark.parametrize(
    ("medium", "ratio", "target"), [(SKIN, 3, 2.0), (STEEP, 100, 2.0), (STEEPEST, 1000, 3.0)], ids=["3", "100", "1000"]
)
def bench_force_curve_on_a_grading(benchmark, below, medium, ratio, target):
    """200 depths on a body graded in depth."""
    _is_its_own_derivative(benchmark.pedantic(_curve, args=(medium,), setup=forget, rounds=3))
    below(target, f"graded in depth (E ratio {ratio}, tolerance 1e-6), F at 200 depths, from nothing")


def bench_force_curve_of_the_same_ratio(benchmark, below):
    """200 depths on a body graded in depth that differs from one before by its moduli and its depth alone."""
    _curve(SKIN)
    numbers = iter(range(1, 100))

    def alike():
        by = 1.0 + 0.01 * next(numbers)
        return _curve(DepthGradedHalfSpace(ExponentialGrading(70e9 * by, 210e9 * by, 3e-6 * by, poisson=0.3)))

    _is_its_own_derivative(benchmark.pedantic(alike, rounds=5))
    below(0.1, "graded in depth, F at 200 depths, another modulus and depth of the same ratio")


@pytest.mark.parametrize("contrast", [1e6, 1e-6])
def bench_wide_punches_on_a_million(benchmark, below, contrast):
    """k a thousand times as wide as the layer is thick."""
    medium = CoatedHalfSpace([Layer(wk.Elastic(210e9 * contrast, 0.3), 1e-6)], on=wk.Elastic(210e9, 0.3))
    k = benchmark.pedantic(medium.punch_stiffness, args=(np.array(1e-3),), setup=forget, rounds=3)
    assert (float(k) > 2.0 * 210e9 / 0.91 * 1e-3) == (contrast > 1.0)
    below(1.0, f"coating of {contrast:g} times the modulus, k at a/h = 1000, from nothing")


@pytest.mark.parametrize(("medium", "what"), [(STACK, "three-layer coating"), (SKIN, "graded in depth")])
def bench_pressure(benchmark, below, medium, what):
    """Pressure at 200 radii, after the contact has been solved."""
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(100e-6), medium), wk.Depth(0.2e-6)).solve()
    r = np.linspace(0.0, 0.999, 200) * contact.radius
    pressure = benchmark.pedantic(medium.pressure, args=(contact.pressed, r), rounds=5, warmup_rounds=1)
    whole = np.sum(np.diff(r**2) * np.pi * 0.5 * (pressure[1:] + pressure[:-1]))
    assert abs(whole / contact.force - 1.0) < 1e-3
    below(0.5, f"{what}, pressure at 200 radii")


def bench_stresses_inside_a_grading(benchmark, below):
    """Stresses at 20 x 30 points of a body graded in depth."""
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(100e-6), SKIN), wk.Depth(0.2e-6)).solve()
    r, z = np.meshgrid(np.linspace(0.0, 2.0, 20) * contact.radius, np.linspace(0.0, 5e-6, 30))
    field = benchmark.pedantic(wk.restore, args=(contact, r, z), setup=forget, rounds=3)
    assert np.all(np.isfinite(field.von_mises))
    below(10.0, "graded in depth, stresses at 600 points, from nothing")


def bench_stresses_inside_a_coating(benchmark, below):
    """Stresses at 20 x 30 points in all layers and the substrate."""
    contact = wk.Indentation(BED, wk.Depth(0.2e-6)).solve()
    r, z = np.meshgrid(np.linspace(0.0, 2.0, 20) * contact.radius, np.linspace(0.0, 5e-6, 30))
    field = benchmark.pedantic(wk.restore, args=(contact, r, z), setup=forget, rounds=3)
    assert np.all(np.isfinite(field.von_mises))
    below(3.0, "three-layer coating, stresses at 600 points")


def bench_shear_stiffness(benchmark, below):
    """k_x of 50 radii over a decade on a stack that is new."""
    radii = np.geomspace(0.4e-6, 4e-6, 50)
    k = benchmark.pedantic(STACK.punch_shear_stiffness, args=(radii,), setup=forget, rounds=3)
    assert np.all(np.diff(k) > 0.0)
    below(0.5, "three-layer coating, k_x table of a decade of radii, from nothing")
