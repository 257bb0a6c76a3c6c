"""A shape sampled at n clean points: its plane profile and its force converge with at least the third power of 1/n."""

from __future__ import annotations

import math

import numpy as np
import pytest
from slopes import order

import winkler as wk

SHAPES = {
    "sphere": (wk.Sphere(1.0), 0.6),
    "hyperboloid": (wk.Hyperboloid(0.2, 0.9), 1.0),
    "ellipsoid": (wk.Ellipsoid(1.0, 0.4), 0.6),
    "waves on a ball": (wk.Paraboloid(1.0) + wk.Wavy(1e-3, 0.5), 0.6),
    "blunt": (wk.PowerLaw(1.0, 5.0), 0.8),
    "cosh": (wk.Formula("h*(cosh(r/l) - 1)", reach=1.0, h=0.05, l=0.2), 0.6),
    "cone with a bend": (wk.Formula("m*r + sin(r)**3", reach=1.0, m=0.3), 0.8),
}
COUNTS = np.array([24, 48, 96, 192, 256])


def samples(shape: wk.Shape, reach: float, count: int) -> wk.Measured:
    places = np.linspace(0.0, reach, count)
    return wk.Measured(places, shape.height(places))


def error(reached, exact) -> float:
    return float(np.max(np.abs(reached - exact)) / np.max(np.abs(exact)))


@pytest.mark.few(1)
@pytest.mark.parametrize("name", SHAPES)
def test_plane_profile_and_force_are_of_third_order_at_least(name):
    shape, reach = SHAPES[name]
    x = reach * np.linspace(0.05, 0.95, 181)
    radius = reach * np.linspace(0.1, 0.9, 17)
    exact_gap = shape.gap(x)

    def force(body: wk.Shape) -> np.ndarray:
        return 2.0 * (radius * body.gap(radius) - body.gap_integral(radius))

    gaps, forces = [], []
    for count in COUNTS:
        tip = samples(shape, reach, int(count))
        gaps.append(error(tip.gap(x), exact_gap))
        forces.append(error(force(tip), force(shape)))
    assert order(COUNTS, gaps) > 3.0
    assert order(COUNTS, forces) > 3.0
    assert gaps[-1] < 1e-6


@pytest.mark.parametrize("name", ["sphere", "hyperboloid", "cosh"])
def test_the_cubic_spline_is_of_fourth_order_in_the_force_at_a_depth(name):
    shape, reach = SHAPES[name]
    medium = wk.HalfSpace(wk.Elastic(1.0, 0.0))
    depth = float(shape.gap(np.array([0.7 * reach]))[0])
    exact = wk.Indentation(wk.Foundation(shape, medium), wk.Depth(depth)).solve().force
    counts, errors = np.array([16, 24, 32, 48, 64]), []
    for count in counts:
        bed = wk.Foundation(samples(shape, reach, int(count)), medium)
        errors.append(abs(wk.Indentation(bed, wk.Depth(depth)).solve().force / exact - 1.0))
    assert order(counts, errors) > 3.0
    assert errors[-1] < 1e-4


def test_a_corner_costs_orders():
    """A truncated cone sampled like a smooth body: the spline rounds its edge, and has no order."""
    shape, reach = wk.TruncatedCone(math.radians(70.0), 0.31), 1.0
    x = np.linspace(0.05, 0.95, 181)
    errors = [error(samples(shape, reach, int(count)).gap(x), shape.gap(x)) for count in (64, 128, 256)]
    assert 0.4 < order([64, 128, 256], errors) < 2.0
