"""Maps on layers thin and thick, hard and soft to a factor of a million, against round contacts."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import winkler as wk

CORNERS = list(itertools.product([1e-6, 1e-3, 1e3, 1e6], [1e-3, 0.1, 1.0, 10.0, 1e3], [0.3, 0.5]))
DEPTH = 1e-4
"""Of a body of 1 m radius: a = 1 cm on a half-space."""
PIXELS = 64


def layers(contrast, ratio, poisson, on=None):
    """A layer so many times as stiff as its base, under half-spaces' contacts of so many thicknesses."""
    return wk.CoatedHalfSpace(
        [wk.Layer(wk.Elastic(1e9 * contrast, poisson), 1e-2 / ratio)], on=on or wk.Elastic(1e9, 0.3)
    )


def some(corners, every):
    return [
        corner if i % every == 0 else pytest.param(*corner, marks=pytest.mark.slow) for i, corner in enumerate(corners)
    ]


def round_map(side):
    x = ((np.arange(PIXELS) + 0.5) / PIXELS - 0.5) * side
    return wk.Topography(-0.5 * (x[:, None] ** 2 + x**2), (side, side))


@pytest.mark.parametrize(("contrast", "ratio", "poisson"), some(CORNERS, 7))
def test_a_map_of_a_ball_is_the_ball(contrast, ratio, poisson):
    """By depth and by force: the equation of round contacts knows k and g, the map knows pixels and waves."""
    medium = layers(contrast, ratio, poisson)
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(1.0), medium), wk.Depth(DEPTH)).solve()
    heights = round_map(3.2 * ball.radius)  # a contact 40 pixels across
    by_depth = wk.SurfaceContact(heights, medium, wk.Depth(DEPTH)).solve()
    by_force = wk.SurfaceContact(heights, medium, wk.Force(ball.force)).solve()
    # a soft film that keeps its volume bears by the sixth power of the radius, which pixels know to .3 %
    error = 0.02 if (contrast, poisson) == (1e-6, 0.5) else 4e-3
    assert by_depth.force == pytest.approx(ball.force, rel=error)
    assert by_force.depth == pytest.approx(DEPTH, rel=error)
    for found in (by_depth, by_force):
        assert found.area == pytest.approx(np.pi * ball.radius**2, rel=0.03)
