"""Line contacts without friction: many loads at once, stresses, onset of yield, and the pull-off of one that sticks.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, 1e9), wk.Elastic(210e9, 0.3))
SHAPES = {
    "cylinder": wk.Paraboloid(10e-3),
    "blunt wedge": wk.RoundedCone(10e-3, math.radians(89.5)),
    "formula": wk.Formula("r**2/(2*R) + A*r**4", R=10e-3, A=1e3),
}
LOADS = wk.LineForce(np.geomspace(1e3, 1e6, 1000))


@pytest.mark.parametrize("name", SHAPES)
def bench_a_thousand_loads(benchmark, below, name):
    """The bed is built anew in each round."""

    def solve():
        return wk.LineIndentation(wk.LineFoundation(SHAPES[name], STEEL), LOADS).solve()

    found = benchmark.pedantic(solve, rounds=10, warmup_rounds=1)
    if name == "cylinder":
        hertz = np.sqrt(4.0 * LOADS.force_per_length * 10e-3 / (math.pi * STEEL.modulus))
        np.testing.assert_allclose(found.half_width, hertz, rtol=1e-12)
    most = 30e-3 if name == "formula" else 5e-3
    below(most, f"half-widths under 1,000 loads per length, {name}")


@pytest.mark.parametrize("name", SHAPES)
def bench_a_thousand_half_widths(benchmark, below, name):
    """The other direction needs no search."""
    half_widths = wk.HalfWidth(np.geomspace(1e-6, 1e-4, 1000))

    def solve():
        return wk.LineIndentation(wk.LineFoundation(SHAPES[name], STEEL), half_widths).solve()

    found = benchmark.pedantic(solve, rounds=10, warmup_rounds=1)
    assert np.all(np.diff(found.force_per_length) > 0.0)
    below(5e-3, f"loads per length at 1,000 half-widths, {name}")


def bench_a_map(benchmark, below):
    contact = wk.LineIndentation(wk.LineFoundation(SHAPES["cylinder"], STEEL), wk.LineForce(1e5)).solve()
    x, z = np.linspace(-2e-4, 2e-4, 100)[:, None], np.linspace(0.0, 3e-4, 100)
    fields = benchmark(contact.stresses, x, z)
    assert fields.von_mises.shape == (100, 100)
    below(50e-3, "stresses below a cylinder at 100 x 100 places")


def bench_an_onset(benchmark, below):
    """The friction changes from round to round, so that nothing is remembered."""
    frictions = iter(np.linspace(0.01, 0.2, 1000))

    def onset():
        bed = wk.LineFoundation(SHAPES["cylinder"], STEEL)
        return wk.LineYieldOnset(bed, wk.Coulomb(float(next(frictions)))).solve()

    found = benchmark.pedantic(onset, rounds=5, warmup_rounds=1)
    assert found.force_per_length > 0.0
    below(0.2, "onset of yield below a cylinder that slides")
