"""Climbing along a curve against a search over a fine grid."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from winkler.numerics.equations.turning import Slopes
from winkler.numerics.panels.chebyshev import fit_panels, stationary

END = 7.0


def wave(x):
    return 0.3 * x + np.sin(3.0 * x) + 0.4 * np.cos(7.3 * x) - 0.4


def slopes():
    panels = fit_panels(wave, np.linspace(0.0, END, 8), 1e-13)
    places = np.unique(np.concatenate([[0.0, END], stationary(panels)]))
    return Slopes(wave, places, wave(places))


def test_stationary_finds_every_turn():
    places = stationary(fit_panels(wave, np.linspace(0.0, END, 8), 1e-13))
    slope = 0.3 + 3.0 * np.cos(3.0 * places) - 2.92 * np.sin(7.3 * places)
    np.testing.assert_allclose(slope, 0.0, atol=1e-9)
    fine = np.linspace(0.0, END, 200_001)
    turns = np.count_nonzero(np.diff(np.sign(np.diff(wave(fine)))))
    assert places.size == turns
    assert stationary(fit_panels(lambda x: 2.0 * x, np.array([0.0, 1.0]), 1e-12)).size == 0


GRID = np.linspace(0.0, END, 70_001)
HEIGHTS = wave(GRID)


def searched(levels):
    """Go from cell to cell while the level exceeds the next one; each level begins where the last one ended."""
    index, path, before = 0, [], -np.inf
    for level in levels:
        if level >= before:
            higher = np.flatnonzero(HEIGHTS[index:] > level)
            index = index + (int(higher[0]) if higher.size else HEIGHTS.size - 1 - index)
        else:
            lower = np.flatnonzero(HEIGHTS[: index + 1][::-1] < level)
            index = index - (int(lower[0]) if lower.size else index)
        path.append(GRID[index])
        before = level
    return np.array(path)


@pytest.mark.slow
@settings(max_examples=50, deadline=None, derandomize=True)
@given(levels=st.lists(st.floats(-1.5, 2.5).map(lambda y: round(y, 3) + 3e-4), min_size=2, max_size=8))
def test_against_a_search_cell_by_cell(levels):
    curve, place, found = slopes(), 0.0, []
    before = -np.inf
    for level in levels:
        step = curve.rise if level >= before else curve.fall
        places, leaps = step(place, np.array([level]))
        place = float(places[0])
        found.append(place)
        for leap in leaps:
            assert wave(leap.start) == pytest.approx(leap.level, abs=1e-12)
            assert leap.end in (0.0, END) or wave(leap.end) == pytest.approx(leap.level, abs=1e-12)
            assert leap.aim == 0
        before = level
    np.testing.assert_allclose(found, searched(levels), atol=2.0 * END / 70_000 + 1e-4)


def test_many_levels_at_once_are_the_same_as_one_by_one():
    curve = slopes()
    up = np.linspace(-1.0, 2.4, 41)
    together, leaps = curve.rise(0.0, up)
    place, single, count = 0.0, [], 0
    for index, level in enumerate(up):
        places, own = curve.rise(place, np.array([level]))
        place = float(places[0])
        single.append(place)
        for leap in own:
            assert leap.start == pytest.approx(leaps[count].start, rel=1e-13)
            assert leaps[count].aim == index
            count += 1
    assert count == len(leaps) >= 3
    np.testing.assert_allclose(together, single, rtol=1e-13, atol=1e-300)
    down, back = curve.fall(float(together[-1]), up[::-1])
    assert np.all(np.diff(down) <= 0.0)
    assert len(back) >= 2


def test_walls():
    curve = Slopes(lambda x: -x, np.array([0.0, 1.0]), np.array([0.0, -1.0]))
    places, leaps = curve.rise(0.0, np.array([-0.5, 0.0, 3.0]))
    assert places.tolist() == [0.0, 1.0, 1.0]
    assert [tuple(leap) for leap in leaps] == [(0.0, 0.0, 1.0, 1)]
    places, leaps = curve.fall(1.0, np.array([-0.5, -1.5]))
    assert places.tolist() == [1.0, 0.0]
    assert [tuple(leap) for leap in leaps] == [(-1.0, 1.0, 0.0, 1)]
