"""Lines of springs under heights: against sums over their springs, power laws that are known exactly, and the clock."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.loading.loads import Depth, Force
from winkler.problems.rough.spring_line import RoughLine, ensemble
from winkler.values.errors import InvalidInput


def test_a_line_is_the_sum_over_its_springs():
    heights = np.random.default_rng(1).standard_normal(500)
    line = RoughLine(heights, 2.0, 3.0)
    depths = np.array([0.0, 0.3, 1.1, 4.0, 9.0])
    pressed = np.maximum(depths[:, None] - (heights.max() - heights), 0.0)
    assert line.force(depths) == pytest.approx(3.0 * 2.0 / 500 * pressed.sum(axis=1), rel=1e-12, abs=1e-15)
    assert line.stiffness(depths[1:]) == pytest.approx(3.0 * 2.0 / 500 * (pressed[1:] > 0.0).sum(axis=1), rel=1e-12)
    forces = np.geomspace(1e-4, 10.0, 30)
    assert line.force(line.depth(forces)) == pytest.approx(forces, rel=1e-12)


def test_the_stiffness_is_the_slope_of_the_force():
    line = RoughLine(np.random.default_rng(1).standard_normal(500), 2.0, 3.0)
    step = 1e-7
    slope = (line.force(np.array(2.0 + step)) - line.force(np.array(2.0))) / step
    assert line.stiffness(np.array(2.0)) == pytest.approx(slope, rel=1e-6)


@pytest.mark.parametrize("hurst", [0.3, 0.5, 0.8])
def test_a_single_peak_of_a_power_law(hurst):
    """z = -c |x|^H: F = 2 E* H/(H+1) c^(-1/H) d^(1+1/H), hence k ~ F^(1/(1+H)) (theory 10)."""
    n, c = 200_000, 0.7
    x = (np.arange(n) + 0.5) / n * 2.0 - 1.0
    line = RoughLine(-c * np.abs(x) ** hurst, 2.0, 3.0)
    depth = np.array([0.2, 0.4])
    expected = 2.0 * 3.0 * hurst / (hurst + 1.0) * c ** (-1.0 / hurst) * depth ** (1.0 + 1.0 / hurst)
    # the highest of the springs stands half a spring beside the peak
    assert line.force(depth - c * (1.0 / n) ** hurst) == pytest.approx(expected, rel=1e-3)
    forces = np.array([0.01, 0.1])
    stiffness = line.stiffness(line.depth(forces))
    assert np.log(stiffness[1] / stiffness[0]) / np.log(10.0) == pytest.approx(1.0 / (1.0 + hurst), abs=2e-4)


def test_pressed_all_over_it_is_a_flat():
    line = RoughLine(np.random.default_rng(2).standard_normal(100), 2.0, 3.0)
    assert line.stiffness(np.array([100.0])) == pytest.approx(6.0, rel=1e-14)
    assert line.depth(line.force(np.array([100.0]))) == pytest.approx(100.0, rel=1e-14)


def test_a_million_springs_keep_their_digits():
    """Sorted sums of a million gaps lose nothing that matters: against the sum in extended precision."""
    import math

    heights = np.random.default_rng(3).standard_normal(10**6)
    line = RoughLine(heights, 1.0, 1.0)
    depth = 1.5
    exact = math.fsum(np.maximum(depth - (heights.max() - heights), 0.0).tolist()) / 1e6
    assert float(line.force(np.array(depth))) == pytest.approx(exact, rel=1e-13)


def test_many_lines_give_median_and_band():
    lines = [RoughLine(np.array([0.0, -1.0 - 0.1 * i]), 1.0, 1.0) for i in range(11)]
    statements = ensemble(lines, Depth([[1.5, 3.0]]))
    # F = d/2 + (d - 1 - i/10)+ / 2
    expected = np.sort([0.75 + 0.5 * max(0.5 - 0.1 * i, 0.0) for i in range(11)])
    assert statements.force.shape == (1, 2)
    assert statements.force_band.shape == (2, 1, 2)
    assert statements.force[0, 0] == pytest.approx(np.median(expected), rel=1e-14)
    assert statements.force_band[:, 0, 0] == pytest.approx([expected[1], expected[9]], rel=1e-14)
    assert np.all(statements.depth_band == statements.depth)
    assert ensemble(lines, Force(1.0)).force_band.tolist() == [1.0, 1.0]


@pytest.mark.parametrize(
    ("numbers", "sentence"),
    [
        ({"heights": [1.0]}, "row of at least 2"),
        ({"heights": [[1.0, 2.0]]}, "row of at least 2"),
        ({"heights": [1.0, np.nan]}, "finite"),
        ({"length": -1.0}, "length is -1.0"),
        ({"modulus": True}, "modulus is True"),
    ],
)
def test_wrong_lines_are_refused(numbers, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        RoughLine(**({"heights": np.array([0.0, 1.0]), "length": 1.0, "modulus": 1.0} | numbers))
