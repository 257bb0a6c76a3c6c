"""Coatings: a force curve on three layers, from nothing, and the stresses below it.

Run it:  pytest benchmarks -m bench --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.materials.layered import Layer
from winkler.media import coated_load, flat_punch
from winkler.media.coated import CoatedHalfSpace
from winkler.numerics import cosine, fredholm

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


def forget() -> None:
    """Empty every table of flat punches, so that each round begins from nothing."""
    for page in (cosine, fredholm, flat_punch, coated_load):
        for thing in vars(page).values():
            if hasattr(thing, "cache_clear"):
                thing.cache_clear()


def bench_force_curve_on_three_layers(benchmark, below):
    """200 depths, up to a contact three times wider than the coating is thick."""
    depths = np.linspace(0.0, 1e-6, 201)[1:]
    curve = benchmark.pedantic(wk.Indentation(BED, wk.Depth(depths)).solve, setup=forget, rounds=5)
    # F = integral of k dd, by Simpson's rule on every second depth
    assert np.all(np.diff(curve.force) > 0.0)
    middle = slice(100, 120)
    slope = np.gradient(curve.force, curve.depth, edge_order=2)[middle]
    np.testing.assert_allclose(slope, curve.stiffness[middle], rtol=1e-4)
    below(1.0, "three-layer coating, 200 depths, from nothing")


def bench_stresses_inside_a_coating(benchmark, below):
    """Stresses at 20 x 30 points in all layers and the substrate."""
    contact = wk.Indentation(BED, wk.Depth(0.2e-6)).solve()
    r, z = np.meshgrid(np.linspace(0.0, 2.0, 20) * contact.radius, np.linspace(0.0, 5e-6, 30))
    field = benchmark.pedantic(wk.restore, args=(contact, r, z), setup=forget, rounds=3)
    assert np.all(np.isfinite(field.von_mises))
    below(3.0, "three-layer coating, stresses at 600 points")
