"""Transforms on strips: exact for parabolic cylinders, convergent for others, and nothing lost."""

import math

import mpmath
import numpy as np
import pytest

from winkler.numerics.transforms.grid_transforms import SurfaceTransform, cuts_of
from winkler.numerics.transforms.strips.strip_transforms import StripTransforms

NODES = np.concatenate([np.linspace(0.0, 0.5, 31)[:-1], 0.5 + np.linspace(0.0, 1.0, 41) ** 2])
STRIPS = StripTransforms(NODES)


def test_a_parabolic_cylinder_is_exact():
    # f = x^2/2, E* = 1: w = pi a^2/4, p = (a^2 - x^2)^(1/2)/2
    load = STRIPS.gap @ (0.5 * NODES**2)
    np.testing.assert_allclose(load, 0.25 * math.pi * NODES**2, rtol=1e-12, atol=1e-15)
    stretch = 0.4 - load
    cut = cuts_of(STRIPS.squares, stretch)
    a = math.sqrt(1.6 / math.pi)
    assert math.sqrt(cut[-1].place) == pytest.approx(a, rel=1e-14)
    inside = np.minimum(STRIPS.borders, a)
    beyond = 0.5 * (a * a * np.arccos(inside / a) - inside * np.sqrt(a * a - inside**2))
    borne = STRIPS.borne(stretch, cut) * STRIPS.areas
    np.testing.assert_allclose(borne, -np.diff(np.append(beyond, 0.0)), atol=1e-14)
    assert np.sum(borne) == pytest.approx(STRIPS.integral(stretch, cut), rel=1e-14)


def test_the_distance_beside_a_narrower_cylinder_is_exact():
    c = 0.3
    lacking = 0.25 * math.pi * (NODES**2 - c * c)
    found = SurfaceTransform(STRIPS)(lacking, cuts_of(STRIPS.squares, lacking))
    x = np.maximum(NODES, c)
    root = np.sqrt((x - c) * (x + c))
    np.testing.assert_allclose(found, 0.5 * (x * root - c * c * np.arcsinh(root / c)), atol=1e-14)


def test_a_flat_pad_bears_as_sadowsky_found():
    even = np.ones(NODES.size)
    borne = STRIPS.borne(even, cuts_of(STRIPS.squares, even)) * STRIPS.areas
    beyond = 2.0 / math.pi * np.arccos(np.append(STRIPS.borders, NODES[-1]) / NODES[-1])
    np.testing.assert_allclose(borne, -np.diff(beyond), atol=1e-14)


def test_other_shapes_converge():
    x = [0.3, 0.7, 1.1]
    with mpmath.workdps(20):
        expected = [
            float(mpmath.quad(lambda t, a=a: (s := a * mpmath.sin(t)) * (4 * s**3 - 3 * s**5), [0, mpmath.pi / 2]))
            for a in x
        ]
    misses = []
    for count in (110, 220, 440):
        nodes = np.linspace(0.0, 1.1, count + 1)
        load = StripTransforms(nodes).gap @ (nodes**4 - 0.5 * nodes**6)
        misses.append(np.max(np.abs(load[np.rint(np.array(x) / nodes[1]).astype(int)] - expected)))
    assert np.all(np.log2(np.array(misses[:-1]) / misses[1:]) > 1.4)
    assert misses[-1] < 5e-4


def test_what_is_cut_off_within_a_cell_is_cut_off_there():
    coarse, fine = np.array([0.0, 1.0, 2.0]), np.sqrt(np.array([0.0, 0.25, 1.0, 1.75, 3.25, 4.0]))
    values, more = (np.interp(nodes**2, [0.0, 1.0, 4.0], [1.0, -2.0, 1.0]) for nodes in (coarse, fine))
    one, other = StripTransforms(coarse), StripTransforms(fine)
    first, second = cuts_of(one.squares, values), cuts_of(other.squares, more)
    totals = [np.sum(s.borne(v, cut) * s.areas) for s, v, cut in ((one, values, first), (other, more, second))]
    assert totals == pytest.approx([1.0, 1.0], rel=1e-12)


def test_means_over_other_strips_lose_nothing():
    values = np.exp(-3.0 * NODES**2)
    values[-1] = 0.0
    wide = StripTransforms(np.linspace(0.0, 2.0, 60))
    means = wide.means(STRIPS.squares, values)
    assert wide.areas @ means == pytest.approx(STRIPS.areas @ values, rel=1e-13)
    assert np.max(np.abs(means - np.interp(wide.squares, STRIPS.squares, values, right=0.0))) < 0.01
