"""Transforms on rings: exact for paraboloids, second order for others, and nothing lost."""

import math

import mpmath
import numpy as np
import pytest

from winkler.numerics.transforms.graded_abel import gap as graded_gap
from winkler.numerics.transforms.graded_abel import surface as graded_surface
from winkler.numerics.transforms.grid_transforms import SurfaceTransform, cuts_of
from winkler.numerics.transforms.ring_transforms import RingTransforms

NODES = np.concatenate([np.linspace(0.0, 0.5, 31)[:-1], 0.5 + np.linspace(0.0, 1.0, 41) ** 2])


@pytest.mark.parametrize("k", [0.0, 0.4, -0.4])
def test_a_paraboloid_is_exact(k):
    rings = RingTransforms(NODES, k)
    height = 0.5 * NODES**2
    gap = rings.gap @ height
    np.testing.assert_allclose(gap, NODES**2 / (1.0 + k), rtol=1e-12, atol=1e-15)
    # theory, section 8.1, in units of E* / c_0^k
    stretch = 0.4 - gap
    cut = cuts_of(rings.squares, stretch)
    a = math.sqrt(0.4 * (1.0 + k))
    assert math.sqrt(cut[-1].place) == pytest.approx(a, rel=1e-14)
    assert 2.0 * rings.integral(stretch, cut) == pytest.approx(
        4.0 * a ** (k + 3.0) / ((1.0 + k) ** 2 * (k + 3.0)), rel=1e-12
    )
    # means over rings: the exact load beyond a radius is that of the power (3 + k)/2
    beyond = 4.0 / ((1.0 + k) ** 2 * (k + 3.0)) * np.maximum(a * a - rings.borders, 0.0) ** (0.5 * (3.0 + k))
    loads = -np.diff(np.append(beyond, 0.0))
    np.testing.assert_allclose(rings.borne(stretch, cut) * rings.areas, loads, atol=1e-13)
    shown = SurfaceTransform(rings)(gap, cuts_of(rings.squares, gap))
    np.testing.assert_allclose(shown, height, rtol=1e-11, atol=1e-15)


@pytest.mark.parametrize("k", [0.0, 0.3])
def test_other_shapes_converge(k):
    # under the root at the end of the last cell the slope of f counts, known to first order: (3 + k) / 2 in g

    x = np.array([0.3, 0.7, 1.1])
    expected = graded_gap(lambda r: 4.0 * r**3 - 3.0 * r**5, (), k, x)
    back = graded_surface(lambda y: np.cos(y), (), k, x)
    misses = []
    for count in (110, 220, 440):
        nodes = np.linspace(0.0, 1.1, count + 1)
        rings = RingTransforms(nodes, k)
        here = np.rint(x / nodes[1]).astype(int)
        gap = rings.gap @ (nodes**4 - 0.5 * nodes**6)
        values = np.cos(nodes)
        shown = SurfaceTransform(rings)(values, cuts_of(rings.squares, values))
        misses.append([np.max(np.abs(gap[here] - expected)), np.max(np.abs(shown[here] - back))])
    orders = np.log2(np.array(misses[:-1]) / np.array(misses[1:]))
    assert np.all(orders > [0.95 * 0.5 * (3.0 + k), 1.8])
    assert np.max(misses[-1]) < 5e-4


def test_what_is_cut_off_within_a_cell_is_cut_off_there():
    # one value at each node, the same function on twice as many: kinks at zero lie within cells
    coarse, fine = np.array([0.0, 1.0, 2.0]), np.sqrt(np.array([0.0, 0.25, 1.0, 1.75, 3.25, 4.0]))
    values, more = (np.interp(nodes**2, [0.0, 1.0, 4.0], [1.0, -2.0, 1.0]) for nodes in (coarse, fine))
    one, other = RingTransforms(coarse, 0.0), RingTransforms(fine, 0.0)
    first, second = cuts_of(one.squares, values), cuts_of(other.squares, more)
    assert one.integral(values, first) == pytest.approx(other.integral(more, second), rel=1e-13)
    # the same by numbers, and how much of the line is pressed: x^2 falls through zero at 1/3 and rises through it at 3
    assert one.pressed(values) == pytest.approx(other.pressed(more), rel=1e-13)
    assert one.pressed(values)[0] == pytest.approx(one.integral(values, first), rel=1e-13)
    assert one.pressed(values)[1] == pytest.approx(2.0 + np.sqrt(1.0 / 3.0) - np.sqrt(3.0), rel=1e-13)
    pairs = (one, values, first), (other, more, second)
    whole = (np.sum(rings.borne(v, cut) * rings.areas) for rings, v, cut in pairs)
    # all of the load, and twice the integral along the line
    assert list(whole) == pytest.approx([2.0 * one.integral(values, first)] * 2, rel=1e-12)
    np.testing.assert_allclose(
        SurfaceTransform(one)(values, first)[[1, 2]], SurfaceTransform(other)(more, second)[[2, 5]], rtol=1e-12
    )


def test_the_mean_pressure_of_a_ring_is_an_integral():
    nodes = np.array([0.0, 0.5, 1.0, 1.5])
    values = np.array([1.0, 0.8, 0.3, 0.0])
    rings = RingTransforms(nodes, 0.0)
    cut = cuts_of(rings.squares, values)
    y = rings.squares

    def pressure(r):
        total = mpmath.mpf(0)
        for i in range(3):
            slope = (values[i + 1] - values[i]) / (y[i + 1] - y[i])
            low, high = (mpmath.sqrt(max(y[j] - r * r, 0)) for j in (i, i + 1))
            total -= 2 * slope * (high - low) / mpmath.pi
        return total

    low, high = (math.sqrt(each) for each in rings.borders[1:3])
    mean = 2 * mpmath.pi * mpmath.quad(lambda r: r * pressure(r), [low, 0.5, high]) / rings.areas[1]
    assert rings.borne(values, cut)[1] == pytest.approx(float(mean), rel=1e-9)


def test_means_over_other_rings_lose_nothing():
    values = np.exp(-3.0 * NODES**2)
    values[-1] = 0.0
    wide = np.linspace(0.0, 2.0, 60)
    before, after = RingTransforms(NODES, 0.0), RingTransforms(wide, 0.0)
    means = after.means(before.squares, values)
    assert after.areas @ means == pytest.approx(before.areas @ values, rel=1e-13)
    assert np.max(np.abs(means - np.interp(wide**2, NODES**2, values, right=0.0))) < 0.01
